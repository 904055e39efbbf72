# The dominant frequency of a solid texture over distances, beside that of a texture that is fixed to the surface; and
# how much the picture changes from frame to frame over two octaves.
set multiplot layout 2,1 title "render-gl -t solid: a plane that faces the camera, 64 pixels to a period"
set grid
set key outside right center
rows(figure, blend) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\" {print $3, $4}' %s", figure, blend, data)
set logscale y 2
set yrange [1:64]
set xrange [-20.5:20.5]
set xtics 5
set xlabel "distance, octaves"
set ylabel "periods per 128 pixels"
plot rows("frequency", "fixed") using 1:2 with linespoints pt 6 lc rgb "#b03030" title "fixed to the surface", \
     rows("frequency", "linear") using 1:2 with linespoints pt 7 ps 0.4 lc rgb "#d08030" title "linear", \
     rows("frequency", "histogram") using 1:2 with linespoints pt 5 ps 0.4 lc rgb "#1f5fa8" title "histogram"
unset logscale y
set yrange [0:0.1]
set xrange [0:2]
set xtics 0.5
set xlabel "distance, octaves, 64 frames each"
set ylabel "change per frame"
plot rows("change", "linear") using 1:2 with lines lw 2 lc rgb "#d08030" title "linear", \
     rows("change", "contrast") using 1:2 with lines lw 2 lc rgb "#30a070" title "contrast", \
     rows("change", "histogram") using 1:2 with lines lw 2 lc rgb "#1f5fa8" title "histogram"
unset multiplot
