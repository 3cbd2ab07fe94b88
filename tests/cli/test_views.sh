#!/bin/sh
# What becomes of a result file.
. "$(dirname "$0")/common.sh"

expect 0 '"$pdmc" -q small.cfg'
[ ! -s out ] || fail "quiet: $(cat out)"
expect 0 '"$pdmc" -t 3 -q -o three.h5 small.cfg'
run '"$pdmc" -f small.cfg'
[ "$code" -eq 0 ] || fail "exit $code"
expect_line err "$warning"
expect_line err '100 of 100 samples'
expect_line err 'written: small.h5'
expect_line out 'P(G > G_c)'

expect 0 '"$pdmc" show small.h5'
expect_line out 'c.from at (-0.5, 0)'
expect_line out 'c.to at (0.5, 0)'
expect 0 '"$pdmc" show --json small.h5'
expect_line out '"samples":100,"kept":100,"failed":0,'

# The numbers do not depend on the threads; the times and the date do.
for file in small three; do
    expect 0 "\"\$pdmc\" export $file.h5 $file"
    for name in pdf quantiles direction samples energy_samples faces; do
        [ -s "$file/$name.csv" ] || fail "$file/$name.csv is missing"
    done
done
diff -r small three

expect 0 '"$pdmc" plot small.h5 plots'
count=0
for picture in plots/*.png; do
    [ -s "$picture" ] && [ -s "${picture%.png}.svg" ] || fail "$picture or its SVG is empty"
    count=$((count + 1))
done
[ "$count" -ge 4 ] || fail "$count pictures"

expect 66 '"$pdmc" show missing.h5' 'pdmc: missing.h5: No such file or directory'
expect 65 '"$pdmc" show small.cfg' 'pdmc: small.cfg: not an HDF5 file'
head -c 20000 small.h5 >cut.h5
run '"$pdmc" show cut.h5'
[ "$code" -eq 65 ] || fail "half a file: exit $code"
run '"$pdmc" export small.h5 small.cfg'
[ "$code" -eq 73 ] || fail "a file as the folder: exit $code"
