# What the tests of the command share; sourced with the command's path as the first argument. They work in a folder of
# their own, with a study that takes a tenth of a second.
set -eu
pdmc=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat >small.cfg <<'STUDY'
title = "small";
plate = { width = 5.0; height = 5.0; };
material = { youngs_modulus = 1.5; fracture_energy = 2.0; };
cracks = ( { name = "c"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );
loads = ( { side = "top"; traction = [0.0, 1.0]; }, { side = "bottom"; traction = [0.0, -1.0]; } );
solver = { spacing = 0.5; };
random = ( { quantity = "micromodulus"; variation = 0.2; }, { quantity = "load"; variation = 0.2; } );
sampling = { samples = 100; };
energy = { angles = 8; };
STUDY
warning='small.cfg:7: warning: random[0].variation: 0.2 in 100 bins makes c(r) negative somewhere with probability '

fail() {
    echo "$*" >&2
    exit 1
}

# run SHELL_COMMAND: leaves its exit code in $code, what it printed in the files out and err.
run() {
    code=0
    (eval "$1") >out 2>err || code=$?
}

# expect CODE SHELL_COMMAND [LINE ...]: the command exits with CODE and prints exactly these lines to standard error.
expect() {
    wanted=$1 shell=$2
    shift 2
    run "$shell"
    : >lines
    for line in "$@"; do printf '%s\n' "$line" >>lines; done
    [ "$code" -eq "$wanted" ] || fail "$shell: exit $code, not $wanted: $(cat err)"
    cmp -s lines err || fail "$shell: printed \"$(cat err)\", not \"$(cat lines)\""
}

# expect_files NAME ...: these are the folder's files, besides those of the tests; nothing half-written was left.
expect_files() {
    found=$(find . -mindepth 1 ! -name out ! -name err ! -name lines ! -name '*.cfg' | sort | tr '\n' ' ')
    wanted=$(for name in "$@"; do echo "./$name"; done | sort | tr '\n' ' ')
    [ "$found" = "$wanted" ] || fail "files: $found, not $wanted"
}

# expect_line FILE TEXT: a line of the file has this text in it.
expect_line() {
    grep -qF -- "$2" "$1" || fail "\"$2\" is not in: $(cat "$1")"
}
