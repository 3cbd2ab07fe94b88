#!/bin/sh
# Bodies of bonds that cannot be: what is found out when nodes are placed is said with the line that is to blame, by runs and by
# checks; what goes wrong in motion with the step and the node, and what was before is kept.
. "$(dirname "$0")/common.sh"

cat >body.cfg <<'END'
kind = "explicit"; title = "layers";
grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; };
materials = ( { name = "hard"; density = 2.0; youngs_modulus = 3.0; }, { name = "soft"; density = 1.0; youngs_modulus = 1.0; } );
bodies = ( { name = "layer"; from = [0, 0]; to = [12, 6]; },
           { name = "core"; inside = "layer"; from = [0, 2]; to = [12, 4]; material = "soft"; },
           { name = "lid"; from = [0.0, 6.1]; to = [12.0, 9.0]; } );
interfaces = ( { first_material = "hard"; second_material = "soft"; critical_stretch = 0.01; },
               { name = "glue"; between = "bodies"; first_body = "layer"; second_body = "lid"; fracture_energy = 1e-4; } );
cracks = ( { from = [4, 3]; to = [8, 3]; } );
time = { duration = 5; };
END

# It runs as it is, and its check says the same of it again.
expect 0 '"$pdmc" check -q -t 1 body.cfg'
cp out resolved.cfg
expect 0 '"$pdmc" check -q -t 1 resolved.cfg'
cmp out resolved.cfg
expect 0 '"$pdmc" -q -t 1 body.cfg'
expect 0 '"$pdmc" show body.h5'
grep -qE '^  interface1 +[0-9]+ +[0-9]+ +[0-9.]+$' out && grep -qE '^  glue +[0-9]+ +0 +0$' out || fail "interfaces: $(cat out)"
expect 0 '"$pdmc" export body.h5 csv'
grep -q '^core,' csv/nodes.csv || fail 'nodes of a part have its name'
grep -q ',interface1.broken,glue.broken$' csv/records.csv || fail "columns: $(head -n 1 csv/records.csv)"
rm -r csv body.h5

# refuses SED_SCRIPT LINE: the changed study is refused with this line, by a run and by a check, and nothing is written.
refuses() {
    sed "$1" body.cfg >bad.cfg
    expect 78 '"$pdmc" -q bad.cfg' "pdmc: bad.cfg:$2"
    expect 78 '"$pdmc" check -q bad.cfg' "pdmc: bad.cfg:$2"
    expect_files
}

refuses 's/6.1\]/5.0]/' '6: bodies[2]: overlaps bodies[0], both have the node at (0.5, 5.5, 0)'
refuses 's/from = \[0.0, 6.1\]; to = \[12.0/from = [20.1, 0.1]; to = [20.1/' '6: bodies[2]: holds no node'
refuses 's/from = \[0, 2\]; to = \[12, 4\]/from = [13, 0]; to = [20, 6]/' '5: bodies[1]: holds no node of bodies[0]'
refuses 's/6.1\]; to = \[12.0, 9.0/20.0]; to = [12.0, 24.0/' '8: interfaces[1]: no bond is between the two'
refuses 's/from = \[4, 3\]; to = \[8, 3\]/from = [4, 30]; to = [8, 30]/' \
    '9: cracks[0]: crosses no bond, or none that those before it have left'
refuses '9s/8, 3\]; }/&, { from = [-1.0, 2.2]; to = [2.2, -1.0]; }/' \
    '9: cracks[1]: cuts all bonds of the node at (0.5, 0.5, 0) that are left'
refuses '9s/$/ no_fail = ( { from = [0, 30]; to = [1, 40]; } );/' '9: no_fail[0]: holds no node'
refuses '9s/$/ conditions = ( { from = [0, 0]; to = [9, 9]; x = 0; }, { from = [0, 30]; to = [1, 40]; x = 1; } );/' \
    '9: conditions[1]: holds no node'
sed '7s/critical_stretch = 0.01/micromodulus = 1000.0/; s/duration = 5/&; step = 0.5/' body.cfg >bad.cfg
for command in '' check; do
    run "\"\$pdmc\" $command -q bad.cfg"
    [ "$code" -eq 78 ] || fail "a step that an interface makes unstable: exit $code"
    grep -qx 'pdmc: bad.cfg:10: time.step: 0.5 is too large, must be at most 0.0[0-9]*, the largest stable one' err ||
        fail "a step that an interface makes unstable: $(cat err)"
done

# What an included file says is placed there.
sed '9d' body.cfg >whole.cfg
sed -n '9s/3\]/30]/gp' body.cfg >cracks.cfg
echo '@include "cracks.cfg"' >>whole.cfg
expect 78 '"$pdmc" -q whole.cfg' \
    'pdmc: cracks.cfg:1: cracks[0]: crosses no bond, or none that those before it have left'

# Nodes of a file: a volume that is not positive, two in one place, one by itself.
nodes() {
    printf '%s\n' "$@" >own.cfg
    sed '4s/from = .*; }/shape = "nodes"; file = "own.cfg"; }/; 5d; 7d; 9d; s/first_body/first_body/' body.cfg >bad.cfg
    sed -i 's/^ *{ name = "glue"/interfaces = ( { name = "glue"/' bad.cfg
}
nodes '0.5 4.5 1' '0.5 5.5 0'
expect 65 '"$pdmc" -q bad.cfg' 'pdmc: own.cfg:2: the volume is 0, must be > 0'
nodes '0.5 4.5 1' '0.5 5.5 1' '0.5 5.5 1'
expect 65 '"$pdmc" -q bad.cfg' 'pdmc: own.cfg:3: the node is in the place of that of line 2'
nodes '0.5 4.5 1' '0.5 6.5 1'
expect 78 '"$pdmc" -q bad.cfg' \
    'pdmc: bad.cfg:4: bodies[0]: the node at (0.5, 6.5, 0) is in the same place as one of bodies[1]'
nodes '0.5 4.5 1' '0.5 5.5 1' '40 40 1'
expect 78 '"$pdmc" -q bad.cfg' 'pdmc: bad.cfg:4: bodies[0]: the node at (40, 40, 0) has no other to be bonded with within 3.5'
expect_files

# Forces that are no numbers: the step and the node are said. From the start there is nothing to keep, later what was before is.
force='conditions = ( { prescribed = "force"; from = [0, 0]; to = [2, 1]; x = 1e308; times = [2, 3]; factors = [0, 1]; } );'
sed "9s/\$/ $force/; 9s/x = 1e308/&; x_gradient = [1e308, 0.0]/" body.cfg >lost.cfg
expect 65 '"$pdmc" -q lost.cfg' \
    'pdmc: step 0, time 0: the node at (1.5, 0.5, 0) has a velocity that is not a number: forces are too large'
expect_files
sed "9s/\$/ $force/" body.cfg >lost.cfg
run '"$pdmc" -q lost.cfg'
[ "$code" -eq 65 ] || fail "forces without bound: exit $code, $(cat err)"
grep -q '^pdmc: step [0-9]*, time 2[.0-9]*: the node at (0.5, 0.5, 0) would move .*; the steps until then are saved in lost.h5$' err ||
    fail "forces without bound: $(cat err)"
expect 0 '"$pdmc" export lost.h5 csv'
if grep -qi 'nan\|inf' csv/records.csv csv/nodes.csv; then fail 'what is kept is not finite'; fi

# At rest they are not taken for nothing.
sed "s/\"explicit\"/\"quasi_static\"/; 9s/\$/ ${force%times*} } );/; 10s/.*/loading = { steps = 4; };/" body.cfg >rest.cfg
expect 65 '"$pdmc" -q rest.cfg' \
    'pdmc: load 0.25: the force on the node at (0.5, 0.5, 0) is too large or not a number; the loads until then are saved in rest.h5'
