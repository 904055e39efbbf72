#!/bin/sh
# draw.sh FOLDER: draws FOLDER/SUBJECT.tsv as SUBJECT.svg and SUBJECT.png. SUBJECT.gp plots the file named by
# the variable `data`; terminal and output are set before it runs.
set -eu
for plot in "$(dirname "$0")"/../*/*.gp; do
    [ -e "$plot" ] || continue
    subject=$(basename "$plot" .gp)
    [ -e "$1/$subject.tsv" ] || { echo "$1/$subject.tsv: not measured yet (make bench)" >&2; continue; }
    for terminal in svg png; do
        kind=$terminal
        [ $terminal = svg ] || kind=pngcairo
        gnuplot -e "set terminal $kind size 900,560; set output '$1/$subject.$terminal'" \
            -e "data = '$1/$subject.tsv'" "$plot"
        echo "$1/$subject.$terminal"
    done
done
