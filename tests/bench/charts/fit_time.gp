# Distances of fitted cubics from the pseudo-inverse in doubles against iterations, and against the time to solve.
set multiplot layout 1,2 margins 0.09,0.655,0.12,0.9 spacing 0.03,0.05 \
    title "fit error against iterations and time: 1,000 whole strokes, distance from the pseudo-inverse in doubles"
set logscale y
set grid
set yrange [5e-5:2000]
set ytics 10
set format y "10^{%L}"
set key at screen 0.995,0.89 right top Left reverse samplen 1 spacing 1.2
rows(method, x, y) = sprintf("< awk -F'\\t' '$1 == \"%s\" {print $%d, $%d}' %s", method, x, y, data)
level(method, y) = real(system(sprintf("awk -F'\\t' '$1 == \"%s\" {print $%d}' %s", method, y, data)))
solved(method, y) = sprintf("< awk -F'\\t' '$1 == \"%s\" {print $7 * 1e6, $%d, $2}' %s", method, y, data)
set xlabel "iterations"
set ylabel "pixels: median (lines), largest (small points)"
set xrange [0.5:8.5]
plot rows("cg", 2, 8) with lines lw 2 lc rgb "#333333" title "CG in powers of t", \
     rows("cg", 2, 10) with points pt 8 ps 0.7 lc rgb "#333333" notitle, \
     rows("legendre", 2, 8) with lines lw 2 lc rgb "#30a070" title "CG in Legendre polynomials", \
     rows("legendre", 2, 10) with points pt 2 ps 0.7 lc rgb "#30a070" notitle, \
     level("inversion", 8) with lines lw 1.5 lc rgb "#b03030" title "inversion", \
     level("cholesky", 8) with lines lw 1.5 lc rgb "#d08030" title "Cholesky", \
     level("libhatch", 8) with lines lw 2 lc rgb "#1f5fa8" title "libhatch"
unset key
unset ylabel
set format y ""
set xlabel "microseconds for a stroke of 4 pixels"
set xrange [0:0.4]
set xtics 0.1
plot solved("cg", 8) with linespoints pt 8 ps 1.3 lc rgb "#333333", \
     solved("cg", 10) with points pt 8 ps 0.7 lc rgb "#333333", \
     solved("cg", 8) using 1:2:($3 < 7 ? sprintf("%d", $3) : "") with labels offset 1.2,0.4 tc rgb "#333333", \
     solved("legendre", 8) with linespoints pt 2 ps 1.3 lc rgb "#30a070", \
     solved("legendre", 8) using 1:2:($3 < 6 ? sprintf("%d", $3) : "") with labels offset -1.2,-0.3 tc rgb "#30a070", \
     solved("inversion", 8) with points pt 6 ps 1.3 lc rgb "#b03030", \
     solved("inversion", 10) with points pt 6 ps 0.7 lc rgb "#b03030", \
     solved("cholesky", 8) with points pt 4 ps 1.3 lc rgb "#d08030", \
     solved("cholesky", 10) with points pt 4 ps 0.7 lc rgb "#d08030", \
     solved("libhatch", 8) with points pt 7 ps 1.3 lc rgb "#1f5fa8", \
     solved("libhatch", 10) with points pt 7 ps 0.7 lc rgb "#1f5fa8"
unset multiplot
