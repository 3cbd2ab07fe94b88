# SPDX-License-Identifier: GPL-3.0-or-later
# Turns what `pdmc describe` prints into man page source: a line "group: meaning" begins a section, and an indented line
# "key  kind and range; unit; default; meaning" is an item of it.
function escaped(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text
}
/^[^ ]/ {
    colon = index($0, ":")
    print ".SS " escaped(substr($0, 1, colon - 1))
    meaning = escaped(substr($0, colon + 2))
    print toupper(substr(meaning, 1, 1)) substr(meaning, 2) "."
    next
}
{
    key = $1
    sub(/^ *[^ ]+ +/, "")
    print ".TP"
    print ".B " escaped(key)
    print escaped($0)
}
