#!/bin/sh
# Sampling until something is known, or until the cap.
. "$(dirname "$0")/common.sh"

sed 's/samples = 100;/samples = 100; target = "mean"; relative_error = 0.02;/' small.cfg >mean.cfg
run '"$pdmc" mean.cfg'
[ "$code" -eq 0 ] || fail "exit $code: $(cat err)"
expect_line out 'the precision that was asked for is reached'
grep -qE '^1024 samples: the mean at c\.(from|to) is known to [0-9.]+ %, 2 % wanted, about [0-9]+ more needed$' err ||
    fail "no prediction: $(cat err)"
count=$(sed -nE 's/^([0-9]+) samples: the mean at c\.(from|to) is known to [0-9.]+ %, 2 % wanted$/\1/p' err)
[ "$count" -gt 1024 ] || fail "met by \"$count\" samples: $(cat err)"
expect 0 '"$pdmc" show --json mean.h5'
expect_line out "\"status\":\"target_met\",\"samples\":$count,"

# A plain study of as many says the same.
expect 0 '"$pdmc" show --json mean.h5 | sed "s/.*\"tips\"/tips/; s/\"runtime\".*//" >met'
sed "s/samples = 100/samples = $count/" small.cfg >plain.cfg
expect 0 '"$pdmc" -q plain.cfg && "$pdmc" show --json plain.h5 | sed "s/.*\"tips\"/tips/; s/\"runtime\".*//" >plain'
cmp met plain || fail 'not the results of a plain study'

# Growth that never happens is never known.
sed 's/fracture_energy = 2.0/fracture_energy = 2000.0/' small.cfg >never.cfg
sed 's/samples = 100;/target = "probability"; samples = 100; most_samples = 300;/' never.cfg >cap.cfg
run '"$pdmc" cap.cfg'
[ "$code" -eq 3 ] || fail "exit $code, not 3: $(cat err)"
expect_line err '300 samples: P(G > G_c) at c.from is not known at all, 5 % wanted'
expect_line out 'STOPPED AT THE CAP'
expect 0 '"$pdmc" show --json cap.h5'
expect_line out '"status":"sample_cap","samples":300,'
expect 3 '"$pdmc" -q -f cap.cfg'
run '"$pdmc" -n 301 -f cap.cfg'
[ "$code" -eq 64 ] || fail "more than the cap: exit $code, not 64: $(cat err)"
