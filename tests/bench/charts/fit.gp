# Distances of fitted cubics from the pseudo-inverse in doubles, at the pixels of a stroke. Failures, and what is off by
# more than a picture, lie on the upper border.
set multiplot layout 2,2 margins 0.09,0.71,0.11,0.92 spacing 0.05,0.07 \
    title "cubics fitted to the pixels of 1,000 strokes: distance from the pseudo-inverse in doubles"
set logscale xy
set grid
set yrange [2e-5:4000]
set ytics 100
rows(sweep, method, iterations, x, y) = sprintf( \
    "< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\" && $3 == %d {print $%d, ($%d > 3000 ? 3000 : $%d)}' %s", \
    sweep, method, iterations, x, y, y, data)
drawn = "plot for [i in '1 2 3 5 6 7 8'] rows(sweep, 'cg', i + 0, across, up) with lines lw 1 lc rgb '#bbbbbb' \
             title i eq '1' ? 'CG, 1 to 8 iterations' : '', \
         rows(sweep, 'cg', 4, across, up) with linespoints pt 8 lw 1.5 lc rgb '#333333' title 'CG, 4 (the paper)', \
         rows(sweep, 'inversion', 0, across, up) with linespoints pt 6 lw 1.5 lc rgb '#b03030' title 'inversion', \
         rows(sweep, 'cholesky', 0, across, up) with linespoints pt 4 lw 1.5 lc rgb '#d08030' title 'Cholesky', \
         rows(sweep, 'libhatch', 0, across, up) with linespoints pt 7 ps 0.8 lw 2 lc rgb '#1f5fa8' title 'libhatch', \
         bar with lines dt 2 lc rgb '#333333' title 'the bar'"
by_parameters = "sweep = 'parameters'; across = 4; set xrange [0.9:140]; set xtics (1, 2, 4, 8, 16, 32, 64, 128)"
by_seen = "sweep = 'seen'; across = 5; set xrange [0.0135:1.15]; \
    set xtics ('1/64' 1.0/64, '1/32' 1.0/32, '1/16' 1.0/16, '1/8' 0.125, '1/4' 0.25, '1/2' 0.5, '1' 1)"
set key at screen 0.995,0.91 right top Left reverse samplen 2 spacing 1.2
up = 7
bar = 0.1
set format y "10^{%L}"
set ylabel "median, pixels"
eval by_parameters
eval drawn
unset key
set format y ""
unset ylabel
eval by_seen
eval drawn
up = 9
bar = 1
set format y "10^{%L}"
set ylabel "largest, pixels"
set xlabel "different parameters, whole strokes"
eval by_parameters
eval drawn
set format y ""
unset ylabel
set xlabel "share of the stroke in sight"
eval by_seen
eval drawn
unset multiplot
