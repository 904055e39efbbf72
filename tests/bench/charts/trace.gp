# Time against faces, and against the number of strokes.
set multiplot layout 1,2 title "strokegen, two threads, reading and writing included"
set grid
set logscale xy
set format x "10^{%L}"
set format y "%g"
set key top left Left reverse samplen 0.5 font ",9"
set datafile separator "\t"
rows(test) = sprintf("< awk -F'\\t' '%s' %s", test, data)
level(i) = rows(sprintf("$1 == \"torus\" && $3 == %d", i))
set xlabel "faces"
set ylabel "seconds"
plot [500:2e6][0.01:30] for [i = 4:6] level(i) using 2:4 with linespoints pt 7 lc i - 3 \
         title sprintf("torus, %d levels", i), \
     rows("NR > 1 && $1 != \"torus\"") using 2:4 with points pt 9 lc 4 title "scans, 6 levels"
set xlabel "strokes"
plot [100:1e6][0.01:30] rows("$1 == \"torus\" && $2 > 8000 && $2 < 12000") . " | sort -n -k 8" using 8:4 with linespoints pt 7 lc 1 \
         title "torus of 10^4 faces, 3 to 8 levels", \
     x > 1000 ? x * 1e-4 : NaN with lines dt 2 lc rgb "#999999" title "n"
unset multiplot
