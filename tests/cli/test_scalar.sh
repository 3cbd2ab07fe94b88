#!/bin/sh
# Scalar studies, as their users meet them.
. "$(dirname "$0")/common.sh"

cat >wave.cfg <<'END'
kind = "scalar"; title = "wave";
domain = { dimension = 1; width = 1.0; };
kernel = { horizon = 0.13; };
elements = { cells = 10; outer = "exact"; };
wave = { length = 1.25; };
convergence = { levels = 2; };
END

# The check prints a study that reads back to itself, and what it takes.
expect 0 '"$pdmc" check -q -t 1 wave.cfg'
cp out resolved.cfg
grep -qE '^# 2 levels, the last one of about [0-9.e+]+ elements and [0-9.e+]+ entries; about [0-9]+ MB and [0-9.]+ s on 1 thread$' \
    resolved.cfg || fail "cost: $(tail -n 1 resolved.cfg)"
expect 0 '"$pdmc" check -q -t 1 resolved.cfg'
cmp out resolved.cfg

# What does not fit is refused.
sed 's/horizon = 0.13/horison = 0.13/' wave.cfg >typo.cfg
expect 78 '"$pdmc" typo.cfg' 'pdmc: typo.cfg:3: kernel.horison: unknown setting, did you mean "horizon"?'
sed 's/cells = 10/space = "discontinuous"; cells = 10/; s/outer = "exact"/outer = "gauss"/; s/0\.13/0.001/' wave.cfg >loose.cfg
run '"$pdmc" -q loose.cfg'
[ "$code" -ne 0 ] || fail 'elements that nothing holds'
grep -q '^pdmc: the form is not positive definite: some elements are not held by others' err || fail "loose: $(cat err)"
[ ! -e loose.h5 ] || fail 'a file of nothing'

# A run and its views.
expect 0 '"$pdmc" -q -t 1 wave.cfg'
expect 0 '"$pdmc" show wave.h5'
grep -q '^        0.05       0.13        26        19 ' out || fail "table: $(cat out)"
expect 0 '"$pdmc" show --json wave.h5'
grep -q '"kind":"scalar".*"status":"complete".*"error_rate":\[null,1\.9' out || fail 'JSON'
expect 0 '"$pdmc" export wave.h5 csv'
[ "$(ls csv)" = "levels.csv
values.csv" ] || fail "files: $(ls csv)"
expect 65 '"$pdmc" compare wave.h5 wave.h5' 'pdmc: wave.h5 is of a scalar study, which is not compared yet'
run '"$pdmc" -f -s 3 wave.cfg'
expect_line err 'pdmc: warning: a scalar study draws no samples, their number and seed change nothing'

# A source and a flux of the study's own, on bonds with a law.
cat >own.cfg <<'END'
kind = "scalar"; title = "own";
domain = { dimension = 1; width = 1.0; };
kernel = { horizon = 0.13; law = "saturating"; stretch = 1.2; };
elements = { cells = 10; inner = "polynomial"; };
source = { kind = "table"; file = "source.txt"; };
open_sides = ( { side = "left"; flux = 0.1; } );
convergence = { levels = 2; };
END
printf '# x b\n-0.5 0\n0 1\n0.5 0\n' >source.txt
expect 0 '"$pdmc" -q -t 1 own.cfg'
expect 0 '"$pdmc" show own.h5'
grep -q '^  scalar field in one dimension, kernel r^-1, under the study.s own source$' out || fail "own: $(cat out)"
grep -q 'iterations  residual left' out || fail "Newton: $(cat out)"
expect 0 '"$pdmc" export own.h5 own'
[ "$(head -n 1 own/values.csv)" = 'value,x[m],y[m],field,wave,moved' ] || fail "values: $(head -n 1 own/values.csv)"
mv source.txt elsewhere.txt
expect 66 '"$pdmc" check -q own.cfg' 'pdmc: source.txt: No such file or directory'
# More than bonds can bear.
mv elsewhere.txt source.txt
sed 's/stretch = 1.2/stretch = 0.1/' own.cfg >much.cfg
run '"$pdmc" -q much.cfg'
[ "$code" -ne 0 ] || fail 'bonds that bear too much'
grep -q '^pdmc: .*iteration' err || fail "much: $(cat err)"
