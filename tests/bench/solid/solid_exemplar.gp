# Left: processor time against texels, for both methods. Right: distance of neighbourhoods to the exemplar against time at 32 texels
# along each axis, over iterations and sides of neighbourhoods.
set multiplot layout 1,2 title "solidgen --exemplar, exemplars of 128x128 pixels"
set grid
set logscale xy
set format "%g"
rows(test, values) = sprintf("< awk -F'\\t' '%s {print %s}' %s", test, values, data)
sizes(method, exemplar) = rows(sprintf("$1 == \"%s\" && $2 == \"%s\" && $4 == \"xyz\" && $6 == 8 && ($5 == 8 || $5 == 0) && !seen[$3]++", \
    method, exemplar), "$3, $10")
set xlabel "texels along each axis"
set ylabel "processor seconds"
set xrange [6:170]
set xtics (8, 16, 32, 64, 128)
set key top left samplen 1
plot sizes("kopf", "cells") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "kopf, colours", \
     sizes("kopf", "strokes") using 1:2 with linespoints lw 2 pt 6 lc rgb "#1f5fa8" title "kopf, grey", \
     sizes("pyramid", "cells") using 1:2 with linespoints lw 2 pt 5 lc rgb "#b8541a" title "pyramid, colours", \
     sizes("pyramid", "strokes") using 1:2 with linespoints lw 2 pt 4 lc rgb "#b8541a" title "pyramid, grey"
set xlabel "processor seconds (numbers: iterations at 8x8, sides at 8 iterations)"
set ylabel "mean distance to the nearest neighbourhood of the exemplar"
set xtics auto
set xrange [0.03:60]
set yrange [0.02:1]
unset logscale y
set key top right
more(exemplar) = rows(sprintf("$1 == \"kopf\" && $2 == \"%s\" && $3 == 32 && $5 == 8", exemplar), "$10, $14, $6")." | sort -n"
sides(exemplar) = rows(sprintf("$1 == \"kopf\" && $2 == \"%s\" && $3 == 32 && $6 == 8 && $5 != 8", exemplar), "$10, $14, $5")." | sort -n"
bands(exemplar) = rows(sprintf("$1 == \"pyramid\" && $2 == \"%s\" && $3 == 32", exemplar), "$10, $14")
plot for [i = 1:3] more(word("cells bricks strokes", i)) using 1:2 with linespoints lw 2 pt 7 \
         lc rgb word("#1f5fa8 #b03030 #3a8f3a", i) title "kopf: ".word("cells bricks strokes", i), \
     for [i = 1:3] more(word("cells bricks strokes", i)) using 1:2:3 with labels offset 0,0.8 notitle, \
     for [i = 1:3] sides(word("cells bricks strokes", i)) using 1:2 with points pt 4 \
         lc rgb word("#1f5fa8 #b03030 #3a8f3a", i) notitle, \
     for [i = 1:3] sides(word("cells bricks strokes", i)) using 1:2:3 with labels offset 0,-0.8 tc rgb "#777777" notitle, \
     for [i = 1:3] bands(word("cells bricks strokes", i)) using 1:2 with points pt 9 ps 1.5 \
         lc rgb word("#1f5fa8 #b03030 #3a8f3a", i) title "pyramid: ".word("cells bricks strokes", i)
unset multiplot
