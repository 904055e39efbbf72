# Time of a frame of each look and blend over that of gouraud in the same run.
set datafile separator "\t"
set title "render-gl -t solid at 1280x720, relative to gouraud in the same run"
set style data histograms
set style fill solid 0.8 noborder
set grid ytics
set logscale y 2
set ylabel "time of a frame"
set key outside top center horizontal
set xtics rotate by -20
rows(mesh) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $3 == \"frame\" && $2 != \"gouraud\"' %s", mesh, data)
plot rows("teapot") using 7:xtic(2) lc rgb "#d08030" title "teapot", \
     rows("teapot-100k") using 7 lc rgb "#30a070" title "100,000 triangles", \
     rows("teapot-538k") using 7 lc rgb "#1f5fa8" title "538,000 triangles"
