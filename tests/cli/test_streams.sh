#!/bin/sh
# Standard streams that are full, closed, or read by nobody: it is said once, and results are safe.
. "$(dirname "$0")/common.sh"
[ -c /dev/full ] || exit 77

expect 0 '"$pdmc" -q small.cfg'
for command in 'show small.h5' 'show --json small.h5' 'check -q small.cfg' describe --help --version; do
    expect 74 "\"\$pdmc\" $command >/dev/full" 'pdmc: standard output: No space left on device'
    expect 74 "\"\$pdmc\" $command >&-" 'pdmc: standard output: Bad file descriptor'
    expect 74 "(trap '' PIPE; \"\$pdmc\" $command; echo \$? >code) | true; exit \$(cat code)" \
        'pdmc: standard output: Broken pipe'
done

# A run that cannot print its table has written its results, and none of its messages into them.
for to in '>/dev/full' '>&-' '<&- >&-' '2>/dev/full' '>&- 2>&-'; do
    rm small.h5
    run "\"\$pdmc\" small.cfg $to"
    case $to in
    2*) [ "$code" -eq 0 ] || fail "run $to: exit $code" ;;
    *) [ "$code" -eq 74 ] || fail "run $to: exit $code" ;;
    esac
    expect 0 '"$pdmc" show small.h5'
done
rm small.h5
expect 0 '"$pdmc" -q small.cfg >&- 2>&-'
expect 0 '"$pdmc" show small.h5'

# Nor is it lost when nobody reads its progress any more.
rm small.h5
run '{ "$pdmc" small.cfg 2>&1 >table; echo $? >code; } | true'
[ "$(cat code)" -eq 0 ] || fail "progress into a closed pipe: exit $(cat code)"
expect 0 '"$pdmc" show small.h5'
rm code table
expect_files small.h5
