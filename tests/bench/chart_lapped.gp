# Time against faces, and stretch and overlap against the number of patches, for sizes of patch on a torus.
set multiplot layout 1,3 title "lapped-param on a torus, one thread, reading and writing included"
set grid
set logscale x
set format x "%g"
set key top left Left reverse samplen 0.5 font ",9"
sizes = "chosen 0.05 0.1 0.2 0.4"
rows(size) = sprintf("< awk -F'\\t' '$1 == \"size %s\"' %s", size, data)
set datafile separator "\t"
set logscale y
set format y "%g"
set xlabel "faces"
set ylabel "seconds"
plot for [i = 1:5] rows(word(sizes, i)) using 2:3 with linespoints pt 7 lc i title "size ".word(sizes, i), \
     x * log(x) * 8e-7 with lines dt 2 lc rgb "#999999" title "n log n"
unset key
unset logscale y
set xlabel "patches"
set ylabel "stretch: 99th percentile"
plot for [i = 1:5] rows(word(sizes, i)) using 7:9 with linespoints pt 7 lc i
set ylabel "overlap"
plot for [i = 1:5] rows(word(sizes, i)) using 7:8 with linespoints pt 7 lc i
unset multiplot
