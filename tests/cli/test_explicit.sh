#!/bin/sh
# Explicit studies, as their users meet them.
. "$(dirname "$0")/common.sh"

cat >impact.cfg <<'END'
kind = "explicit"; title = "impact";
grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; };
materials = ( { density = 2.0; youngs_modulus = 3.0; critical_stretch = 0.02; } );
bodies = ( { from = [0, 0]; to = [12, 6]; } );
cracks = ( { name = "c"; from = [4, 3]; to = [8, 3]; } );
spheres = ( { radius = 2; centre = [6.0, 8.2]; velocity = [0.0, -0.1]; mass = 9; stiffness = 5; } );
time = { duration = 30; };
record = { interval = 3; snapshots = 3; };
END

# The check prints a study that reads back to itself, and what is placed.
expect 0 '"$pdmc" check -q -t 1 impact.cfg'
cp out resolved.cfg
grep -qE '^# 72 nodes, [0-9]+ bonds, [0-9]+ steps of [0-9.e-]+, stable up to [0-9.e-]+; about [0-9]+ MB and [0-9.]+ s on 1 thread$' \
    resolved.cfg || fail "cost: $(tail -n 1 resolved.cfg)"
expect 0 '"$pdmc" check -q -t 1 resolved.cfg'
cmp out resolved.cfg

# What it is told, and what the engine finds out.
sed 's/radius = 2/raduis = 2/' impact.cfg >typo.cfg
expect 78 '"$pdmc" typo.cfg' 'pdmc: typo.cfg:6: spheres[0].raduis: unknown setting, did you mean "radius"?'
sed 's/to = \[12, 6\]/to = [12]/' impact.cfg >short.cfg
expect 78 '"$pdmc" check short.cfg' 'pdmc: short.cfg:4: bodies[0].to: an array of 1 is not allowed, must be as many reals as grid.dimension, [x, y] or [x, y, z], each finite'
sed 's/duration = 30/duration = 30; step = 9.0/' impact.cfg >large.cfg
for command in '' check; do
    run "\"\$pdmc\" $command -q large.cfg"
    [ "$code" -eq 78 ] || fail "a step that is not stable: exit $code"
    grep -q '^pdmc: large.cfg:7: time.step: 9 is too large, must be at most 0.9[0-9]*, the largest stable one$' err ||
        fail "a step that is not stable: $(cat err)"
done
expect_files

# A run and its views.
expect 0 '"$pdmc" -q -t 1 impact.cfg'
expect 0 '"$pdmc" show impact.h5'
grep -q '^  72 nodes and [0-9]* bonds in the plane, spacing 1, horizon 3 m$' out || fail "table: $(cat out)"
expect 0 '"$pdmc" show --json impact.h5'
grep -q '"kind":"explicit".*"status":"complete".*"name":"c.to".*"name":"sphere1"' out || fail 'JSON'
expect 0 '"$pdmc" export impact.h5 csv'
[ "$(ls csv)" = "fragments.csv
nodes.csv
records.csv" ] || fail "files: $(ls csv)"
[ "$(wc -l <csv/nodes.csv)" -eq 73 ] || fail 'nodes'
expect 65 '"$pdmc" compare impact.h5 impact.h5' 'pdmc: impact.h5 is of an explicit study, which is not compared yet'
run '"$pdmc" -f -s 3 impact.cfg'
expect_line err 'pdmc: warning: this explicit study draws no samples, their number and seed change nothing'

# A node that leaves its family in one step: what was before is kept, and the exit code tells.
sed '/^spheres/c conditions = ( { from = [0, 0]; to = [12, 1]; y = 1e9; times = [9, 12]; factors = [0, 1]; } );' \
    impact.cfg >lost.cfg
run '"$pdmc" -q lost.cfg'
[ "$code" -eq 65 ] || fail "a lost node: exit $code, $(cat err)"
grep -q '^pdmc: step .*; the steps until then are saved in lost.h5$' err || fail "a lost node: $(cat err)"
expect 0 '"$pdmc" show lost.h5'
grep -q '^  STOPPED, these are the steps until then: step ' out || fail "a lost node: $(cat out)"
