#!/bin/sh
# Runs one entry of the table of limits, METHOD/NAME.limit beside this file:
#     one.sh ENTRY texts         prints its texts, separated by tabs
#     one.sh ENTRY plain|ours    makes the picture plain.png or ours.png in the working folder, and prints its figure
# An entry is a script that sets
#     title    the failure, in a few words
#     why      a sentence or two: what fails, and what helps
#     source   the paper and section that name it, or "found here"
#     plainly, instead   captions of the two pictures
#     measure  the figure, in words, with its unit
#     limit    ">" or "<" and a number: the figure of ours must be on this side, that of plain must not
# and defines the functions plain PICTURE, ours PICTURE and figure PICTURE, where PICTURE is a name without ".png".
# Entries in the folder open have no plain picture; their figures are on the wrong side of the limit.
set -eu
TOP=${TOP:-$PWD}
entry=$1
what=$2
. "$TOP/tests/stability/limits/tools.sh"
plainly='' instead=''
. "$entry"
case $what in
texts) printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$title" "$why" "$source" "$plainly" "$instead" "$measure" "$limit" ;;
*)
    "$what" "$what"
    figure "$what"
    ;;
esac
