#!/bin/sh
# Elastic studies, as their users meet them.
. "$(dirname "$0")/common.sh"

cat >block.cfg <<'END'
kind = "elastic"; title = "block";
solid = { nodes_x = 4; nodes_y = 8; nodes_z = 4; spacing = 1.0; horizon = 2.0; youngs_modulus = 100.0; };
strain = { yy = 1e-3; xx = -2.5e-4; zz = -2.5e-4; };
faces = ( { face = "y_low"; layers = 1; }, { face = "y_high"; layers = 1; } );
END

# The check prints a study that reads back to itself, and what it takes.
expect 0 '"$pdmc" check -q -t 1 block.cfg'
cp out resolved.cfg
grep -qE '^# 128 nodes with about [0-9]+ bonds each; about [0-9]+ MB and [0-9.]+ s on 1 thread$' resolved.cfg ||
    fail "cost: $(tail -n 1 resolved.cfg)"
expect 0 '"$pdmc" check -q -t 1 resolved.cfg'
cmp out resolved.cfg

# What does not fit is refused.
sed 's/horizon = 2.0/horizon = 0.5/' block.cfg >short.cfg
expect 78 '"$pdmc" short.cfg' 'pdmc: short.cfg:2: solid.horizon: 0.5 is too small, must be at least 1, the spacing'
sed 's/"y_high"; layers = 1/"y_low"; layers = 1/' block.cfg >twice.cfg
expect 78 '"$pdmc" twice.cfg' 'pdmc: twice.cfg:4: faces[1].face: the face has been given before, must be given once'
sed 's/"y_high"; layers = 1/"y_high"; layers = 1; traction_x = 1.0/' block.cfg >both.cfg
expect 78 '"$pdmc" both.cfg' \
    'pdmc: both.cfg:4: faces[1].layers: a face has layers with a prescribed displacement or a traction, not both'
sed '/^faces/d' block.cfg >loose.cfg
expect 78 '"$pdmc" loose.cfg' 'pdmc: loose.cfg: faces: nothing holds or pulls the body: a face needs layers or a traction'
sed 's/layers = 1; }, { face = "y_high"; layers = 1/traction_y = 1.0/' block.cfg >flies.cfg
run '"$pdmc" -q flies.cfg'
[ "$code" -eq 78 ] && [ ! -e flies.h5 ] || fail 'a body that flies away'
grep -q '^pdmc: nothing holds the body, and its loads are not in balance$' err || fail "flies: $(cat err)"

# A run and its views, by each way to rest.
expect 0 '"$pdmc" -q -t 1 block.cfg'
expect 0 '"$pdmc" show block.h5'
grep -q '^  y_high  *0 \|^  y_high ' out || fail "table: $(cat out)"
grep -q '^  at rest after [0-9]* iterations, residual [0-9.e-]*; elastic energy ' out || fail "table: $(cat out)"
expect 0 '"$pdmc" show --json block.h5'
grep -q '"kind":"elastic".*"status":"complete".*"nodes":128' out || fail 'JSON'
expect 0 '"$pdmc" export block.h5 csv'
[ "$(ls csv | tr '\n' ' ')" = "energies.csv faces.csv line.csv nodes.csv " ] || fail "files: $(ls csv)"
[ "$(wc -l <csv/nodes.csv)" -eq 129 ] || fail 'nodes'
expect 65 '"$pdmc" compare block.h5 block.h5' 'pdmc: block.h5 is of an elastic study, which is not compared yet'
for method in relaxation damped; do
    { cat block.cfg; echo "rest = { method = \"$method\"; };"; } >$method.cfg
    sed -i 's/"damped"/"damped"; density = 1.0; damping = 0.5; steps = 40/' $method.cfg
    expect 0 '"$pdmc" -q -t 1 $method.cfg'
done
expect 0 '"$pdmc" show damped.h5'
grep -q '^  40 steps of ' out || fail "damped: $(cat out)"
