# Time per frame against the number of seed points in each of four layers.
set title "render-gl -t rptam: teapot, 20,000 faces, 640×360, default strokes and samples"
set xlabel "seeds in each of four layers, as many strokes in the picture"
set ylabel "time per frame over that of gouraud in the same run"
set logscale xy
set format x "%g"
set format y "%g"
set xrange [3:1400]
set grid
set key top left
loop(name) = sprintf("< awk -F'\\t' '$1 == \"%s\" {print $2, $9}' %s", name, data)
stats sprintf("< awk -F'\\t' '$1 == \"tam\" {print $9}' %s", data) nooutput
tam = STATS_max
plot loop("brute") using 1:2 with linespoints pt 7 lw 2 lc rgb "#b03a2e" title "brute: every seed everywhere", \
     loop("coverage") using 1:2 with linespoints pt 7 lw 2 lc rgb "#1f5fa8" title "coverage: lists of strokes", \
     tam with lines dt 2 lc rgb "#333333" title "tam, six columns"
