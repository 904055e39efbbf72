# Errors of the positions of strokes, relative to the reference in pairs of doubles, and of the tone, relative to octave
# 0. Below octave 0 texture coordinates are 2^40 times as dense, and the camera moves outwards.
set multiplot layout 2,1 title "render-gl rptam: 2^{-40} to 2^{40}, reference in pairs of doubles"
set grid
set xrange [-41:41]
set xtics 10
set key outside right center
rows(method, surface, column) = sprintf( \
    "< awk -F'\\t' '$1 == \"%s\" && $3 == \"%s\" && $6 < 0.5 {print $2, ($%d > 1e-5 ? $%d : 1e-5)}' %s | sort -n", \
    surface, method, column, column, data)
set logscale y
set format y "10^{%L}"
set ylabel "largest error, pixels"
plot rows("floats", "plane", 4) using 1:2 with linespoints pt 6 lc rgb "#b03030" title "floats alone, plane", \
     rows("floats", "torus", 4) using 1:2 with linespoints pt 4 lc rgb "#d08030" title "floats alone, torus", \
     rows("pieces", "plane", 4) using 1:2 with linespoints pt 7 ps 0.7 lc rgb "#1f5fa8" title "pieces, plane", \
     rows("pieces", "torus", 4) using 1:2 with linespoints pt 5 ps 0.7 lc rgb "#30a070" title "pieces, torus", \
     0.1 with lines dt 2 lc rgb "#333333" title "the bar"
unset logscale y
set format y "%g"
set yrange [0:0.03]
set xlabel "octaves of zoom, outwards and inwards"
set ylabel "drift of five tones, plane"
plot rows("floats", "plane", 7) using 1:2 with linespoints pt 6 lc rgb "#b03030" title "floats alone", \
     rows("pieces", "plane", 7) using 1:2 with linespoints pt 7 ps 0.7 lc rgb "#1f5fa8" title "pieces", \
     0.01 with lines dt 2 lc rgb "#333333" title "the bar"
unset multiplot
