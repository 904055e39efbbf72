# Widths of strokes on the screen relative to the requested width, from the 5th to the 95th percentile.
set title "width of strokes on the screen over the requested width: teapot, 20,000 faces, 5th to 95th percentile"
set xlabel "distance from the surface in radii"
set ylabel "width over requested width"
set logscale xy
set grid
set xrange [0.007:1500]
set format x "%g"
set format y "%g"
set key top right
rows(method) = sprintf("< awk -F'\\t' '$1 == \"%s\" {print $2, $5, $4, $6}' %s", method, data)
plot rows("tam") using ($1 * 0.93):2:3:4 with yerrorbars pt 6 lc rgb "#b03030" title "tam, four levels", \
     rows("rptam, as printed") using ($1 * 1.07):2:3:4 with yerrorbars pt 4 lc rgb "#999999" \
         title "rptam, across measured on the surface (Algorithm 2)", \
     rows("rptam") using 1:2:3:4 with yerrorbars pt 7 lc rgb "#1f5fa8" title "rptam", \
     1.25 with lines dt 2 lc rgb "#333333" title "within a quarter", 0.75 with lines dt 2 lc rgb "#333333" notitle
