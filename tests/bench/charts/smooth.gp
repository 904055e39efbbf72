# Singularities against the angle to the nearer principal axis of a three-ring quadric, a point for each value of
# --smooth, and on the bunny for each strength of the method of Knöppel et al. (tests/bench/programs/peers.c).
set title "dirfield --smooth: singularities against alignment"
set grid
set logscale y
set xlabel "median angle to the axes of a 3-ring quadric at its 30 % most anisotropic points, degrees"
set ylabel "singularities"
set xrange [0:20]
set yrange [5:3000]
set key top right samplen 1
rows(model, method) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\" {print $8, $5, $3}' %s", model, method, data)
plot rows("stanford-bunny", "linear") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "bunny", \
     rows("stanford-bunny", "linear") using 1:2:($3 <= 0.5 ? sprintf("%g", $3) : "") with labels offset 2.2,0.4 tc rgb "#1f5fa8" notitle, \
     rows("stanford-bunny", "hz") using 1:2 with linespoints lw 1 dt 2 pt 9 lc rgb "#b8541a" title "bunny, hz", \
     rows("horse", "linear") using 1:2 with linespoints lw 1 pt 5 ps 0.7 lc rgb "#3a8f3a" title "horse", \
     rows("gargoyle", "linear") using 1:2 with linespoints lw 1 pt 5 ps 0.7 lc rgb "#8a6fb0" title "gargoyle", \
     rows("rocker-arm-80k", "linear") using 1:2 with linespoints lw 1 pt 5 ps 0.7 lc rgb "#999999" title "rocker arm", \
     rows("stanford-bunny", "smoothest") using 1:2 with linespoints dt 3 pt 2 lc rgb "#333333" title "bunny, smoothest"
