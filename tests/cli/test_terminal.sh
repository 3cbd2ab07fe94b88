#!/bin/sh
# Progress: one line that is redrawn on a terminal, a line for each tenth elsewhere.
. "$(dirname "$0")/common.sh"
# Skipped where there is no script(1), or no pseudo-terminal to be had, as in a chroot without /dev/pts.
script -qec true /dev/null >/dev/null 2>&1 </dev/null || exit 77

# on_terminal TERM: leaves what a run prints to a terminal of this kind in the file shown.
on_terminal() {
    TERM=$1 script -qec "'$pdmc' -f -n 700 small.cfg" /dev/null >shown </dev/null || fail "exit $?: $(cat shown)"
}
return=$(printf '\r')
on_terminal xterm
expect_line shown "${return}preparing the solver"
expect_line shown "${return}64 of 700 samples"
expect_line shown "${return}700 of 700 samples"
on_terminal dumb
! grep -qF 'preparing' shown || fail 'redrawn on a dumb terminal'

run '"$pdmc" -f -n 700 small.cfg'
! grep -qF "$return" err || fail 'redrawn in a file'
[ "$(grep -cE '^[0-9]+ of 700 samples' err)" -eq 10 ] || fail "not a line for each tenth: $(cat err)"
