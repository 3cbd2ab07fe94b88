#!/bin/sh
# make-study-page.sh PDMC SOURCE_DIR EXAMPLE: prints the man page of the study file, with the settings as the command
# itself describes them and an example that is tested.
set -eu
pdmc=$1 source=$2 example=$3
settings=$("$pdmc" describe)
while IFS= read -r line; do
    case $line in
    @SETTINGS@) printf '%s\n' "$settings" | awk -f "$source/settings.awk" ;;
    @EXAMPLE@) sed 's/\\/\\e/g; s/-/\\-/g; s/^\./\\\&./' "$example" ;;
    *) printf '%s\n' "$line" ;;
    esac
done <"$source/pdmc-study.5.in"
