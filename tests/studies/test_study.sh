#!/bin/sh
# test_study.sh PDMC CHECK_EXPECTED STUDY [OPTION ...]: runs STUDY.cfg as its users do, views it in every way, and compares
# it with its expected values: those of a folder's study.cfg are in expected.csv, others' in STUDY.expected.csv.
set -eu
pdmc=$1 check_expected=$2 study=$3
shift 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$pdmc" --quiet --output results.h5 "$@" "$study.cfg"
"$pdmc" show results.h5 >table
"$pdmc" show --json results.h5 >results.json
"$pdmc" export results.h5 csv
"$pdmc" plot results.h5 plots
for output in table csv/*.csv plots/*.png plots/*.svg; do
    [ -s "$output" ] || { echo "$output is empty or missing"; exit 1; }
done
case $study in
    */study) "$check_expected" results.json "${study%study}expected.csv" ;;
    *) "$check_expected" results.json "$study.expected.csv" ;;
esac
