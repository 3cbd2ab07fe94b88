#!/bin/sh
# Two result files side by side.
. "$(dirname "$0")/common.sh"

expect 0 '"$pdmc" -q -o a.h5 small.cfg'
expect 0 '"$pdmc" -q -o same.h5 small.cfg'
expect 0 '"$pdmc" -q -s 5 -o b.h5 small.cfg'

# Without notes: the studies differ by their seeds alone.
expect 0 '"$pdmc" compare a.h5 b.h5'
expect_line out 'file                a.h5                                   b.h5'
expect_line out 'method              kansa'
expect_line out 'A and B are taken as independent samples'
expect_line out 'c.from, Griffith energy at 180 deg, N/m'
expect_line out 'Kolmogorov-Smirnov'
expect_line out 'peak memory, MB'
! grep -q 'c.to, Griffith' out || fail "more than the first tip"
expect 0 '"$pdmc" compare a.h5 same.h5'
expect_line out 'A and B are taken as pairs'
expect_line out 'Kolmogorov-Smirnov  0 [0, 0], p = 1'
expect 0 '"$pdmc" compare --tip c.to --tip c.from --angle 45,-90 --angle 0 --measure bond a.h5 b.h5'
for angle in 45 270 0; do expect_line out "c.to, bond energy at $angle deg"; done
expect_line out 'c.from, bond energy at 45 deg'

# The same numbers every time, whatever is resampled.
expect 0 '"$pdmc" compare --json a.h5 b.h5'
cp out first
expect 0 '"$pdmc" compare --json a.h5 b.h5'
cmp first out
expect_line out '"paired":false,'
expect_line out '"peak_memory":'
! grep -q '"peak_memory":0' out || fail "no memory"

expect 0 '"$pdmc" compare --plot plots --angle 180,135 a.h5 b.h5'
for ending in png svg; do
    [ -s "plots/compare_c.from_griffith_energy.$ending" ] || fail "no $ending"
done
expect 0 '"$pdmc" compare --plot plots a.h5 b.h5' # replaces them
[ "$(ls plots | wc -l)" -eq 2 ] || fail "plots: $(ls plots)"

# What is not alike is told, and what can be compared nevertheless is.
sed 's/angles = 8/angles = 12/; s/fracture_energy = 2.0/fracture_energy = 1.0/' small.cfg >twelve.cfg
expect 0 '"$pdmc" -q -n 50 -o twelve.h5 twelve.cfg'
expect 0 '"$pdmc" compare a.h5 twelve.h5' \
    'pdmc: note: 8 and 12 angles: energies are compared at the 4 that both have' \
    'pdmc: note: G_c is 2 and 1 N/m: P(G > G_c) differs with it' \
    'pdmc: note: the same seed, but different numbers of samples: taken as independent, so that p and intervals of differences are too large'
expect 0 '"$pdmc" compare -q a.h5 twelve.h5'

# What cannot be compared is refused.
sed 's/"c"/"d"/' small.cfg >other.cfg
sed 's/plate =/units = { length = "mm"; };\nplate =/' small.cfg >units.cfg
cat >moving.cfg <<'STUDY'
kind = "dynamic";
plate = { width = 5.0; height = 5.0; };
material = { youngs_modulus = 1.5; fracture_energy = 2.0; };
cracks = ( { name = "c"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );
loads = ( { side = "top"; traction = [0.0, 1.0]; }, { side = "bottom"; traction = [0.0, -1.0]; } );
solver = { spacing = 0.5; };
dynamics = { density = 1.0; step = 0.1; duration = 1.0; };
STUDY
for name in other units moving; do expect 0 "\"\$pdmc\" -q -o $name.h5 $name.cfg"; done
expect 65 '"$pdmc" compare a.h5 other.h5' \
    'pdmc: a.h5 and other.h5 have no tip in common: c.from, c.to; d.from, d.to'
[ ! -s out ] || fail "a refusal prints"
expect 65 '"$pdmc" compare a.h5 units.h5' 'pdmc: a.h5 and units.h5 have different units of length, m and mm'
expect 65 '"$pdmc" compare a.h5 moving.h5' 'pdmc: a.h5 is of a static study and moving.h5 of a dynamic one'
expect 0 '"$pdmc" compare moving.h5 moving.h5' \
    'pdmc: note: dynamic studies have no samples, and their motions are not compared'
expect_line out 'motion'
expect 65 '"$pdmc" compare a.h5 small.cfg' 'pdmc: small.cfg: not an HDF5 file'
expect 66 '"$pdmc" compare a.h5 missing.h5' 'pdmc: missing.h5: No such file or directory'
expect 73 '"$pdmc" compare --plot small.cfg a.h5 b.h5' 'pdmc: small.cfg: is a file, not a folder'
expect 64 '"$pdmc" compare --tip e.to a.h5 b.h5' 'pdmc: e.to is no tip of both files'
expect 64 '"$pdmc" compare --angle 100 a.h5 b.h5' 'pdmc: 100 deg is no angle of both files; the nearest is 90 deg'

help='see pdmc --help'
expect 64 '"$pdmc" compare a.h5' "pdmc: compare needs two result files; $help"
expect 64 '"$pdmc" compare a.h5 b.h5 c.h5' "pdmc: unexpected argument c.h5; $help"
expect 64 '"$pdmc" compare -n 3 a.h5 b.h5' "pdmc: compare does not take --samples; $help"
expect 64 '"$pdmc" show --tip c.to a.h5' "pdmc: show does not take --tip; $help"
for angle in '' left 1,,2 45, 400 nan; do
    expect 64 "\"\$pdmc\" compare --angle '$angle' a.h5 b.h5" \
        "pdmc: --angle: \"$angle\" is not an angle from -360 to 360 degrees, or several with commas"
done
expect 64 '"$pdmc" compare --angle 1,2,3,4,5,6,7,8,9,10,11,12,13 a.h5 b.h5' 'pdmc: --angle: more than 12 angles'
expect 64 '"$pdmc" compare --measure stress a.h5 b.h5' 'pdmc: --measure: "stress" is neither bond nor griffith'
expect 64 '"$pdmc" compare --plot "" a.h5 b.h5' 'pdmc: --plot: the name of the folder is empty'
