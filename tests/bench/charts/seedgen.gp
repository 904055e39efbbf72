# Left: time against the number of seed points. Right: distances between seed points against the time for choosing among
# candidates.
set multiplot layout 1,2 title "seedgen, one thread, start-up included"
set grid
set logscale x
set format x "10^{%T}"
rows(name) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $3 == 1 {print $2, $9, $5 * 100}' %s", name, data)
chosen = sprintf("< awk -F'\\t' '$3 == 4 {print $9, $11, $12, $13, $4}' %s", data)
set xlabel "seeds in a set"
set ylabel "processor seconds"
set logscale y
set format y "%g"
set xrange [2:4e6]
set yrange [0.00003:1]
set key bottom right samplen 1
plot rows("any") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "any number (default)", \
     rows("euler") using 1:2 with linespoints lw 2 pt 5 lc rgb "#3a8f3a" title "Eulerian circuit", \
     rows("backtrack") using 1:2 with linespoints lw 2 pt 9 lc rgb "#b8541a" title "Algorithm 1, stopped at 10^6 digits", \
     rows("backtrack") using 1:2:3 with labels offset 0,1 tc rgb "#b8541a" title "(% of tries that find a cycle)"
unset logscale y
set format y "%.1f"
set xlabel "processor seconds (numbers: candidates)"
set ylabel "smallest distance over the hexagonal bound"
set xrange [0.001:1]
set yrange [0:1]
set key center right
plot chosen using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "64 seeds, 4 layers", \
     chosen using 1:2:5 with labels offset 0,1 tc rgb "#1f5fa8" notitle, \
     chosen using 1:4 with lines lw 2 dt 2 lc rgb "#333333" title "recursive Bayer order (a grid)", \
     chosen using 1:3 with lines lw 2 dt 3 lc rgb "#333333" title "random points"
unset multiplot
