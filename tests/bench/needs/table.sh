#!/bin/sh
# table.sh FILE: prints the table of docs/notes/needs.md from FILE, build/bench/needs.tsv: per scene and technique the shares
# of bytes and seconds at the tolerance .01, and the difference; then geometric means.
set -eu
awk -F'\t' 'BEGIN {
    print "| scene | technique | bytes | of the default | s | of the default | difference |"
    print "| --- | --- | --- | --- | --- | --- | --- |"
}
$3 == ".01" && $2 != "needs" {
    printf "| %s | %s | %d | %.2f | %.2f | %.2f | %.4f |\n", $1, $2, $4, $4 / $5, $6, $6 / $7, $8
    for (i = 0; i < 2; i++) {
        key = i ? $2 : "all"
        n[key]++
        bytes[key] += log($4 / $5)
        seconds[key] += log($6 / $7)
        most[key] = $8 > most[key] ? $8 : most[key]
    }
}
END {
    count = split("tam volume threshold rptam traced all", keys, " ")
    for (i = 1; i <= count; i++)
        if (n[keys[i]])
            printf "| mean | %s | | %.2f | | %.2f | %.4f |\n", keys[i], exp(bytes[keys[i]] / n[keys[i]]),
                exp(seconds[keys[i]] / n[keys[i]]), most[keys[i]]
}' "$1"
