#!/bin/sh
# A run that is told to stop finishes the samples under way, saves what it has, and says so.
. "$(dirname "$0")/common.sh"
[ -r /proc/self/status ] || exit 77

sed 's/samples = 100/samples = 640; inverse = "direct"/' small.cfg >long.cfg
sed 's/spacing = 0.5/spacing = 0.2/' long.cfg >slow.cfg

# start STUDY: runs it in the background as $job and waits until it catches SIGTERM.
start() {
    "$pdmc" -t 1 -o x.h5 "$1" >out 2>err &
    job=$!
    for _ in $(seq 500); do
        # SIGTERM is the 15th signal, the third bit of the fourth hexadecimal digit from the right
        ! grep -qE '^SigCgt:.*[4567c-f][0-9a-f]{3}$' /proc/$job/status || return 0
        sleep 0.02
    done
    fail 'the run never caught SIGTERM'
}

# wait_for TEXT: until standard error has it.
wait_for() {
    for _ in $(seq 3000); do
        ! grep -qF -- "$1" err || return 0
        sleep 0.02
    done
    fail "\"$1\" never came: $(cat err)"
}

finish() {
    code=0
    wait "$job" || code=$?
    [ "$code" -eq "$1" ] || fail "exit $code, not $1: $(cat err)"
}

stopping='pdmc: stopping: what is under way is finished, then everything is saved; two more interrupts leave at'
for signal in INT TERM HUP; do
    start long.cfg
    wait_for '64 of 640 samples'
    kill -s "$signal" "$job"
    finish 75
    expect_line err "$stopping once and save nothing"
    count=$(sed -n 's/^pdmc: interrupted: the first \([0-9]*\) samples are saved in x.h5$/\1/p' err)
    [ "$count" -ge 64 ] && [ "$count" -lt 640 ] && [ $((count % 64)) -eq 0 ] || fail "saved \"$count\" samples"
    expect_line out INTERRUPTED
    expect 0 '"$pdmc" show --json x.h5'
    expect_line out "\"status\":\"interrupted\",\"samples\":$count,"
    expect_files x.h5
    rm x.h5
done

# Rare growth comes after the samples, which are saved without it.
sed 's/samples = 100/samples = 64/' small.cfg >rare.cfg
echo 'reliability = { method = "subset"; variation = 1e-4; evaluations = 100000000; };' >>rare.cfg
start rare.cfg
wait_for '64 of 64 samples'
kill -s TERM "$job"
finish 75
expect_line err 'pdmc: interrupted: all 64 samples are saved in x.h5, rare growth is not complete'
expect_line out 'INTERRUPTED: all samples were done, rare growth was not'
expect_files x.h5
rm x.h5

# Before there are samples there is nothing to save.
start slow.cfg
kill -s TERM "$job"
finish 75
expect_line err "$stopping"
expect_line err 'pdmc: stopped before the first samples: there is nothing to save'
expect_files

# The third leaves at once.
start long.cfg
wait_for '64 of 640 samples'
kill -s TERM "$job"
wait_for "$stopping"
kill -s TERM "$job"
wait_for 'pdmc: still stopping; one more interrupt leaves at once and saves nothing'
kill -s TERM "$job"
finish 143
expect_files

# nohup: a hangup that is ignored stays so.
trap '' HUP
start long.cfg
kill -s HUP "$job"
wait_for '64 of 640 samples'
kill -s TERM "$job"
finish 75
