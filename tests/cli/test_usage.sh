#!/bin/sh
# What the command says of itself, and to command lines that it does not understand.
. "$(dirname "$0")/common.sh"

help='see pdmc --help'
expect 64 '"$pdmc"' "pdmc: a run needs the name of a study; $help"
expect 64 '"$pdmc" -n 10' "pdmc: a run needs the name of a study; $help"
expect 64 '"$pdmc" check' "pdmc: check needs the name of a study; $help"
expect 64 '"$pdmc" show' "pdmc: show needs the name of a result file; $help"
expect 64 '"$pdmc" export a' "pdmc: export needs a result file and a folder; $help"
expect 64 '"$pdmc" plot a b extra' "pdmc: unexpected argument extra; $help"
expect 64 '"$pdmc" describe extra' "pdmc: unexpected argument extra; $help"
expect 64 '"$pdmc" small.cfg other.cfg' "pdmc: unexpected argument other.cfg; $help"
expect 64 '"$pdmc" chek small.cfg' "pdmc: chek: neither a command nor a file; $help"
expect 64 '"$pdmc" --samples 0 small.cfg' 'pdmc: --samples: "0" is not a whole number from 1 to 100000000'
expect 64 '"$pdmc" --seed -1 small.cfg' 'pdmc: --seed: "-1" is not a whole number from 0 to 9223372036854775807'
expect 64 '"$pdmc" --seed 99999999999999999999 small.cfg' \
    'pdmc: --seed: "99999999999999999999" is not a whole number from 0 to 9223372036854775807'
expect 64 '"$pdmc" --threads 2x small.cfg' 'pdmc: --threads: "2x" is not a whole number from 1 to 1024'
expect 64 '"$pdmc" --threads "" small.cfg' 'pdmc: --threads: "" is not a whole number from 1 to 1024'
expect 64 '"$pdmc" --output "" small.cfg' 'pdmc: --output: the name of the file is empty'
expect 64 '"$pdmc" --json small.cfg' "pdmc: a run does not take --json; $help"
expect 64 '"$pdmc" show -n 3 small.h5' "pdmc: show does not take --samples; $help"
expect 64 '"$pdmc" check --force small.cfg' "pdmc: check does not take --force; $help"
run '"$pdmc" --bogus small.cfg'
[ "$code" -eq 64 ] || fail "an unknown option: exit $code"
expect_line err "pdmc: unrecognized option '--bogus'"
expect_files

expect 0 '"$pdmc" --help'
expect_line out 'pdmc STUDY [options]'
for code in 3 64 65 66 70 73 74 75 78; do expect_line out "$code "; done
expect 0 '"$pdmc" --version'
grep -qE '^pdmc [0-9]+\.[0-9]+\.[0-9]+ [0-9a-f]*$' out || fail "version: $(cat out)"
expect 0 '"$pdmc" describe'
expect_line out '    youngs_modulus '

# All processors that OpenMP would use, whatever reading a study does with the linear algebra.
expect 0 'OMP_NUM_THREADS=3 "$pdmc" check -q small.cfg'
expect_line out ' on 3 threads'
expect 0 'OMP_NUM_THREADS=3 "$pdmc" check -q -t 2 small.cfg'
expect_line out ' on 2 threads'
