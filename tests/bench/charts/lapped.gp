# Time against faces; stretch and overlap against the number of patches, for the default patch size on a torus, on noise
# and on scans, and for other sizes on tori of a thousand to a hundred thousand faces.
set multiplot layout 1,3 title "lapped-param, one thread, reading and writing included"
set grid
set logscale x
set format x "10^{%L}"
set key top left Left reverse samplen 0.5 font ",9"
set datafile separator "\t"
rows(test) = sprintf("< awk -F'\\t' '%s' %s", test, data)
chosen(i) = rows(sprintf("$1 == \"%s\"", word("chosen noisy bunny armadillo", i)))
sized(i) = rows(sprintf("$1 ~ /size/ && $2 > %d && $2 < %d", 500 * 10**(i - 1), 5000 * 10**(i - 1)))
array titles[4] = ["torus", "noisy ellipsoid", "bunny", "armadillo"]
array sizes[3] = ["--size .05 to .4: 10^3", "10^4 faces", "10^5 faces"]
point(i) = i > 2 ? 9 : 7
set logscale y
set format y "%g"
set xlabel "faces"
set ylabel "seconds"
plot [500:2e6] for [i = 1:4] chosen(i) using 2:3 with linespoints pt point(i) lc i title titles[i], \
     for [i = 1:3] sized(i) using 2:3 with points pt 2 ps 0.7 lc i + 4 title sizes[i], \
     x > 1000 ? x * log(x) * 8e-7 : NaN with lines dt 2 lc rgb "#999999" title "n log n"
unset key
unset logscale y
set format y "%.2f"
set xlabel "patches"
set ylabel "stretch: 99th percentile"
plot for [i = 1:4] chosen(i) using 7:9 with linespoints pt point(i) lc i, \
     for [i = 1:3] sized(i) using 7:9 with linespoints pt 2 ps 0.7 lc i + 4
set ylabel "overlap"
plot [][1:4] for [i = 1:4] chosen(i) using 7:8 with linespoints pt point(i) lc i, \
     for [i = 1:3] sized(i) using 7:8 with linespoints pt 2 ps 0.7 lc i + 4
unset multiplot
