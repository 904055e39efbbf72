# Bytes and time of assets that are made for needs, as shares of the default ones, and the difference of the pictures,
# against the tolerance: means over scenes, by technique (geometric for shares; the largest for differences).
set grid
set key outside right center
set logscale x 10
set xrange [0.002:0.15]
set xtics ("0.003" 0.003, "0.01" 0.01, "0.03" 0.03, "0.1" 0.1)
set rmargin 24
set multiplot layout 3,1 title "tamgen, tamvol, tamthresh, dirfield, lapped-param, strokegen --needs: means over scenes"
mean(technique, a, b) = sprintf("< awk -F'\\t' '$2 == \"%s\" && $%d > 0 {n[$3]++; s[$3] += log($%d / $%d)} \
    END {for (t in n) print t, exp(s[t] / n[t])}' %s | sort -g", technique, b, a, b, data)
most(technique) = sprintf("< awk -F'\\t' '$2 == \"%s\" {m[$3] = $8 > m[$3] ? $8 : m[$3]} \
    END {for (t in m) print t, m[t]}' %s | sort -g", technique, data)
colors = "#1f5fa8 #b03030 #d08030 #30a070 #7a4fa0"
names = "tam volume threshold rptam traced"
set yrange [0:1]
set ylabel "bytes"
plot for [i = 1:5] mean(word(names, i), 4, 5) using 1:2 with linespoints pt 7 ps 0.6 lc rgb word(colors, i) title word(names, i)
unset key
set ylabel "seconds"
plot for [i = 1:5] mean(word(names, i), 6, 7) using 1:2 with linespoints pt 7 ps 0.6 lc rgb word(colors, i) title word(names, i)
set logscale y 10
set yrange [0.0005:0.5]
set xlabel "tolerance"
set ylabel "difference"
set label "1.5 tolerances" at 0.045, 0.17 textcolor rgb "#666666"
plot for [i = 1:5] most(word(names, i)) using 1:2 with linespoints pt 7 ps 0.6 lc rgb word(colors, i) title word(names, i), \
     1.5 * x with lines dt 2 lc rgb "#888888" title "1.5 tolerances"
unset multiplot
