# Angle to the true direction against time, clean and noisy, for 10,000 faces and, for the smoothed field, other sizes;
# below on the right, time against faces. Grey: other programs, measured elsewhere (2-ring quadric; trimesh2; libigl, 5
# rings; CGAL's jets; fieldgen; Instant Meshes with libigl's directions).
set multiplot layout 2,2 title "direction of curvature: one thread, mean of five shapes, 10,000 faces unless stated otherwise"
set grid
set logscale xy
set format y "%g"
set format x "%g"
set xrange [2:6000]
set xlabel "milliseconds"
set key top left Left reverse samplen 0.5 font ",8"
rows(noise, test) = sprintf("< awk -F'\\t' '$2 == 10000 && $3 == %s && %s {print $4 * 1000, $8, $9, $1}' %s", noise, test, data)
fixed = "$1 ~ /^radius/"
sizes(noise) = sprintf("< awk -F'\\t' '$1 == \"adaptive, linear\" && $3 == %s {print $4 * 1000, $8, $2 / 1000, $2, $4}' %s", noise, data)
ours = "$1 ~ /^adaptive/ && $1 != \"adaptive\""
raw = "$1 == \"adaptive\""
coarse = "$1 ~ /^simplified/"
$peers << END
4.6 .19 11 31
2.9 .58 17 35
41 .25 1.1 4.7
280 .0015 16 33
52 .13 .36 2.7
61 .23 .46 2.0
END
short(name) = strlen(name) > 7 && name[1:6] eq "radius" ? name[8:strstrt(name, ",") - 1] . "/" . name[strlen(name):] : ""
do for [n = 1:3] {
    noise = word("0 0.05 0.2", n)
    set title n == 1 ? "clean" : sprintf("noise %s of the edge", noise)
    if (n == 1) { set yrange [0.0002:500] }
    if (n > 1) { unset key; set yrange [0.02:500] }
    set ylabel n == 1 ? "degrees: median" : ""
    plot $peers using 1:(column(n + 1)) with points pt 2 lc rgb "#999999" title "other programs", \
         rows(noise, fixed) using 1:2 with points pt 7 lc rgb "#b8541a" title "fixed: radius/degree", \
         rows(noise, fixed) using 1:2:(short(stringcolumn(4) . " " . stringcolumn(5) . " " . stringcolumn(6) . " " . stringcolumn(7))) with labels left rotate by 60 offset 0,0.5 font ",8" tc rgb "#b8541a" notitle, \
         rows(noise, coarse) using 1:2 with points pt 9 lc rgb "#7a4fa0" title "simplified mesh", \
         rows(noise, raw) using 1:2 with points pt 5 ps 1.3 lc rgb "#3a8f3a" title "adaptive", \
         sizes(noise) using 1:2 with lines lw 1 dt 2 lc rgb "#1f5fa8" notitle, \
         sizes(noise) using 1:2:(sprintf("%gk", column(3))) with labels offset 0,-0.9 font ",8" tc rgb "#1f5fa8" notitle, \
         rows(noise, ours) using 1:2 with points pt 13 ps 1.5 lc rgb "#1f5fa8" title "adaptive, smoothed"
}
set title "frames, curvature and field against faces"
set xrange [500:2000000]
set autoscale y
set xlabel "faces"
set ylabel "seconds"
set key top left Left reverse samplen 1
plot sizes("0") using 4:5 with linespoints pt 13 lc rgb "#1f5fa8" title "clean", \
     sizes("0.05") using 4:5 with linespoints pt 7 lc rgb "#b8541a" title "noise 0.05", \
     sizes("0.2") using 4:5 with linespoints pt 9 lc rgb "#7a4fa0" title "noise 0.2", \
     x * log(x) * 4e-7 with lines dt 3 lc rgb "#999999" title "n log n"
unset multiplot
