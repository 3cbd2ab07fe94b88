#!/bin/sh
# Result files: where they may be, and that a run which fails leaves none.
. "$(dirname "$0")/common.sh"

# Refused before the run: a million samples would not end within the time of the test.
long_run='"$pdmc" -q -n 1000000'
mkdir folder
expect 73 "$long_run small.cfg -o nowhere/x.h5" \
    'pdmc: nowhere/x.h5: cannot be created: there is no such folder, or it takes no files'
expect 73 "$long_run small.cfg -f -o folder" 'pdmc: folder: is a folder, not a file'
expect 73 "$long_run small.cfg -o new/" 'pdmc: new/: is the name of a folder, not of a file'
expect 73 "$long_run small.cfg -f -o /dev/null" 'pdmc: /dev/null: is a device or the like, not a file'
expect 73 "$long_run small.cfg -f -o small.cfg" 'pdmc: small.cfg: is the study itself; -o FILE writes elsewhere'
[ -s small.cfg ] || fail 'the study was overwritten'
long=$(printf '%0250d' 1)
expect 73 "$long_run small.cfg -o $long" "pdmc: $long: cannot be created: File name too long"
run "$long_run small.cfg -o /proc/x.h5" # takes no files, not even from root, who passes every test of permissions
[ "$code" -eq 73 ] || fail "/proc: exit $code"
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w folder
    expect 73 "$long_run small.cfg -o folder/x.h5" 'pdmc: folder/x.h5: cannot be created: Permission denied'
    chmod a+w folder
fi
expect_files folder

# An existing file is kept, unless --force says otherwise; the default is the study's name, in the working folder.
mkdir studies
cp small.cfg studies/named.v2.cfg
expect 0 '"$pdmc" -q studies/named.v2.cfg'
cp named.v2.h5 before
expect 73 "$long_run studies/named.v2.cfg" \
    'pdmc: named.v2.h5: exists already; --force overwrites it, -o FILE writes elsewhere'
cmp named.v2.h5 before
expect 0 '"$pdmc" -q -f -s 0 studies/named.v2.cfg'
! cmp -s named.v2.h5 before || fail 'not overwritten'
rm -r before
expect_files named.v2.h5 folder studies

# A full disk, as a limit on the size of files: nothing half-written is left, and what was there is kept.
cp named.v2.h5 before
full='larger than files may be here (ulimit -f); nothing was written'
expect 74 '(ulimit -f 8; "$pdmc" -q -o x.h5 small.cfg)' "pdmc: x.h5: $full"
expect 74 '(ulimit -f 8; "$pdmc" -q -f studies/named.v2.cfg)' "pdmc: named.v2.h5: $full"
cmp named.v2.h5 before
expect 74 '(ulimit -f 8; "$pdmc" export named.v2.h5 csv)' "pdmc: csv/pdf.csv: $full"
expect_files named.v2.h5 before csv folder studies
