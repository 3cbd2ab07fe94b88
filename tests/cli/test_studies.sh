#!/bin/sh
# Good studies and bad ones.
. "$(dirname "$0")/common.sh"

expect 66 '"$pdmc" missing.cfg' 'pdmc: missing.cfg: No such file or directory'
expect 66 '"$pdmc" check missing.cfg' 'pdmc: missing.cfg: No such file or directory'
expect 66 '"$pdmc" .' 'pdmc: .: Is a directory'
: >empty.cfg
expect 78 '"$pdmc" empty.cfg' 'pdmc: empty.cfg: plate.width: is missing, must be a real > 0'
sed 's/width/widht/' small.cfg >typo.cfg
for command in '' check; do
    expect 78 "\"\$pdmc\" $command typo.cfg" 'pdmc: typo.cfg:2: plate.widht: unknown setting, did you mean "width"?'
done
printf 'plate = {\nwidth = ;' >syntax.cfg
expect 78 '"$pdmc" syntax.cfg' 'pdmc: syntax.cfg:2: syntax error'
expect_files

# What is not a study, by mistake: a result file, a program.
expect 0 '"$pdmc" -q small.cfg'
expect 78 '"$pdmc" small.h5' 'pdmc: small.h5: an HDF5 file, not a study file; pdmc show prints the results in one'
expect 78 '"$pdmc" "$pdmc"' "pdmc: $pdmc: has a zero byte in it, not a study file"
expect_files small.h5

# Loads that nothing holds are found before anything is computed, by the check too.
sed 's/, { side = "bottom".*/ );/' small.cfg >unbalanced.cfg
for command in '' check; do
    run "\"\$pdmc\" $command -q unbalanced.cfg"
    [ "$code" -eq 78 ] || fail "out of equilibrium: exit $code"
    [ "$(wc -l <err)" -eq 1 ] || fail "out of equilibrium: $(cat err)"
done
expect_files small.h5

# The check prints a study that reads back to itself, the options in it, and what the run will cost.
expect 0 '"$pdmc" check -q -n 77 -s 5 -t 1 small.cfg'
cp out resolved.cfg
expect_line resolved.cfg 'samples = 77;'
expect_line resolved.cfg 'seed = 5L;'
grep -qE '^# 121 nodes, [0-9]+ unknowns, [0-9]+ rows; about [0-9]+ MB and [0-9.]+ s on 1 thread$' resolved.cfg ||
    fail "cost: $(tail -n 1 resolved.cfg)"
expect 0 '"$pdmc" check -q -t 1 resolved.cfg'
cmp out resolved.cfg
run '"$pdmc" check small.cfg'
expect_line err "$warning"
sed 's/angles = 8/angles = 3600/; s/samples = 100/samples = 100; keep = 100000000/' small.cfg >huge.cfg
run '"$pdmc" check -n 100000000 huge.cfg'
grep -qE '^pdmc: warning: the run needs about [0-9]{8} MB of memory, this machine has [0-9]+ MB$' err ||
    fail "12 TB are no warning: $(cat err)"

# A design has whole replicates, whatever the command line says.
sed 's/samples = 100/samples = 96; design = "sobol"/' small.cfg >design.cfg
expect 64 '"$pdmc" check -q -n 100 design.cfg' \
    'pdmc: 100 samples are not allowed, must be a multiple of the 16 replicates of the design, such as 112'
expect 0 '"$pdmc" check -q -n 112 design.cfg'
expect_line out 'samples = 112;'
