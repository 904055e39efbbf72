# Angle to the nearer principal axis against time, clean and noisy, for 10,000 faces and, for dirfield's default, other
# sizes; below on the right, time against faces. Other methods, in the same run (tests/bench/programs/peers.c): quadric /
# rings; tensor / rings, mu; smoothest; "told" stands for constants chosen for the size and the noise.
set multiplot layout 2,2 title "angle to the nearer principal axis: one thread, twelve shapes, 10,000 faces unless stated otherwise"
set grid
set logscale xy
set format y "%g"
set format x "%g"
set xrange [1:5000]
set xlabel "milliseconds (median)"
set key top right Right samplen 0.5 spacing 0.85 font ",7"
rows(noise, test) = sprintf("< awk -F'\\t' '$2 == \"twelve\" && $4 == 10000 && $5 == %s && %s {gsub(/ rings|, told|mu |radius |degree /, \"\", $1); gsub(/, /, \"/\", $1); print $6 * 1000, $10, $1}' %s", noise, test, data)
sizes(noise) = sprintf("< awk -F'\\t' '$1 == \"dirfield\" && $2 == \"twelve\" && $5 == %s {print $6 * 1000, $10, $4 / 1000, $4, $6}' %s", noise, data)
fixed = "$1 ~ /^radius/"
smoothed = "$1 ~ /^dirfield, smooth/"
others = "$1 ~ /^(quadric|tensor|smoothest)/ && $1 !~ /told/"
told = "$1 ~ /told/"
do for [n = 1:3] {
    noise = word("0 0.05 0.2", n)
    set title n == 1 ? "clean" : sprintf("noise %s of the edge", noise)
    set yrange [n == 1 ? 0.001 : 0.1 : n == 1 ? 1000 : 100]
    if (n > 1) { unset key }
    set ylabel n == 1 ? "degrees: mean of medians" : ""
    plot rows(noise, others) using 1:2 with points pt 2 lc rgb "#777777" title "other methods", \
         rows(noise, told) using 1:2 with points pt 1 lc rgb "#000000" title "other methods, told size and noise", \
         rows(noise, others . " && !/^smoothest/") using 1:2:3 with labels right offset -0.6,0.4 font ",7" tc rgb "#777777" notitle, \
         rows(noise, others . " && /^smoothest/") using 1:2:3 with labels right offset -0.6,1.2 font ",7" tc rgb "#777777" notitle, \
         rows(noise, fixed) using 1:2 with points pt 7 lc rgb "#b8541a" title "dirfield, fixed: radius/degree", \
         rows(noise, fixed) using 1:2:3 with labels left offset 0.6,0.3 font ",7" tc rgb "#b8541a" notitle, \
         rows(noise, "$1 == \"simplified\"") using 1:2 with points pt 9 lc rgb "#7a4fa0" title "dirfield, simplified mesh", \
         rows(noise, smoothed) using 1:2 with points pt 5 ps 1.1 lc rgb "#3a8f3a" title "dirfield, smooth 0 and 0.3", \
         sizes(noise) using 1:2 with lines lw 1 dt 2 lc rgb "#1f5fa8" notitle, \
         sizes(noise) using 1:2:(sprintf("%gk", column(3))) with labels offset 0,-0.9 font ",8" tc rgb "#1f5fa8" notitle, \
         rows(noise, "$1 == \"dirfield\"") using 1:2 with points pt 13 ps 1.5 lc rgb "#1f5fa8" title "dirfield, default"
}
set title "frames, curvature and field against faces"
set xrange [1000:200000]
set autoscale y
set xlabel "faces"
set ylabel "seconds (median)"
set key top left Left reverse samplen 1
plot sizes("0") using 4:5 with linespoints pt 13 lc rgb "#1f5fa8" title "clean", \
     sizes("0.05") using 4:5 with linespoints pt 7 lc rgb "#b8541a" title "noise 0.05", \
     sizes("0.2") using 4:5 with linespoints pt 9 lc rgb "#7a4fa0" title "noise 0.2", \
     x * log(x) * 4e-7 with lines dt 3 lc rgb "#999999" title "n log n"
unset multiplot
