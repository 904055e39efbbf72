# Left: processor time against texels, for both methods. Then both distances to the exemplar against processor time at 32
# texels along each axis: lines over 1 to 16 iterations, squares for neighbourhoods of 4, 6, 10 and 12 pixels.
set multiplot layout 1,3 title "solidgen --exemplar, exemplars of 128x128 pixels"
set grid
set logscale xy
set format "%g"
rows(test, values) = sprintf("< awk -F'\\t' '%s {print %s}' %s | sort -n", test, values, data)
sizes(method, exemplar) = rows(sprintf("$1 == \"%s\" && $2 == \"%s\" && $6 == 8 && ($5 == 8 || $5 == 0) && !seen[$3]++", \
    method, exemplar), "$3, $10")
set xlabel "texels along each axis"
set ylabel "processor seconds"
set xrange [6:170]
set xtics (8, 16, 32, 64, 128)
set yrange [0.001:3000]
set key top left samplen 1
plot sizes("kopf", "cells") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "kopf, colours", \
     sizes("kopf", "strokes") using 1:2 with linespoints lw 2 pt 6 lc rgb "#1f5fa8" title "kopf, grey", \
     sizes("pyramid", "cells") using 1:2 with linespoints lw 2 pt 5 lc rgb "#b8541a" title "pyramid, colours", \
     sizes("pyramid", "strokes") using 1:2 with linespoints lw 2 pt 4 lc rgb "#b8541a" title "pyramid, grey"
set xlabel "processor seconds, 32 texels"
set xtics auto
set xrange [0.02:8]
name(i) = word("cells bricks strokes", i)
color(i) = word("#1f5fa8 #b03030 #3a8f3a", i)
more(i, column) = rows(sprintf("$1 == \"kopf\" && $2 == \"%s\" && $3 == 32 && $5 == 8", name(i)), "$10, ".column)
sides(i, column) = rows(sprintf("$1 == \"kopf\" && $2 == \"%s\" && $3 == 32 && $6 == 8 && $5 != 8", name(i)), "$10, ".column)
bands(i, column) = rows(sprintf("$1 == \"pyramid\" && $2 == \"%s\" && $3 == 32", name(i)), "$10, ".column)
do for [column in "$14 $13"] {
    if (column eq "$14") {
        set ylabel "distance of neighbourhoods"
        set yrange [0.02:2]
        set key top right
    } else {
        set ylabel "distance of histograms"
        set yrange [1e-5:1]
        unset key
    }
    plot for [i = 1:3] more(i, column) using 1:2 with linespoints lw 2 pt 7 lc rgb color(i) title "kopf: ".name(i), \
         for [i = 1:3] sides(i, column) using 1:2 with points pt 4 lc rgb color(i) notitle, \
         for [i = 1:3] bands(i, column) using 1:2 with points pt 9 ps 1.5 lc rgb color(i) title "pyramid: ".name(i)
}
unset multiplot
