# Angle to the truth against time, 10,000 faces, clean and noisy. Grey: other programs, as measured elsewhere (2-ring
# quadric; trimesh2; libigl, 5 rings; CGAL's jets; fieldgen; Instant Meshes with libigl's seeds).
set multiplot layout 1,3 title "direction of curvature: 10,000 faces, one thread, mean of five shapes"
set grid
set logscale xy
set format y "%g"
set format x "%g"
set xrange [1:2000]
set yrange [0.00003:100]
set xlabel "milliseconds"
set key bottom left Left reverse samplen 0.5 font ",9"
rows(noise, test) = sprintf("< awk -F'\\t' '$2 == 10000 && $3 == %s && %s {print $4 * 1000, $8, $9, $1}' %s", noise, test, data)
fixed = "$1 ~ /^radius/"
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
    if (n > 1) { unset key }
    set ylabel n == 1 ? "degrees: median" : ""
    plot $peers using 1:(column(n + 1)) with points pt 2 lc rgb "#999999" title "other programs", \
         rows(noise, fixed) using 1:2 with points pt 7 lc rgb "#b8541a" title "fixed: radius/degree", \
         rows(noise, fixed) using 1:2:(short(stringcolumn(4) . " " . stringcolumn(5) . " " . stringcolumn(6) . " " . stringcolumn(7))) with labels offset 0,0.8 font ",8" tc rgb "#b8541a" notitle, \
         rows(noise, coarse) using 1:2 with points pt 9 lc rgb "#7a4fa0" title "simplified mesh", \
         rows(noise, raw) using 1:2 with points pt 5 ps 1.3 lc rgb "#3a8f3a" title "adaptive", \
         rows(noise, ours) using 1:2 with points pt 13 ps 1.5 lc rgb "#1f5fa8" title "adaptive, smoothed"
}
unset multiplot
