# Left: drift of the tone over an octave. Right: pop of the frames and the pop allowed (bench_fade.sh).
set multiplot layout 1,2 title "render-gl -t rptam: a zoom of one octave in 120 frames, tone .3"
set grid
set key top left
set xlabel "--overlap"
set xrange [-0.05:1.05]
set yrange [0:*]
set offsets 0, 0, graph 0.25, 0
rows(law, by, column) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\" {print $3, $%d}' %s", law, by, column, data)
set ylabel "drift of the tone, from peak to peak"
plot rows("paper", "opacity", 12) with linespoints pt 7 lw 2 lc rgb "#b03a2e" title "--fade paper", \
     rows("even", "opacity", 12) with linespoints pt 7 lw 2 lc rgb "#1f5fa8" title "even", \
     rows("even", "size", 12) with linespoints pt 6 lw 1 lc rgb "#1f5fa8" title "even, by size", \
     rows("weighted", "opacity", 12) with linespoints pt 7 lw 2 lc rgb "#2e8b57" title "weighted"
set key bottom right
set ylabel "mean |I(t - 1) - 2 I(t) + I(t + 1)|"
stats sprintf("< awk -F'\\t' '$1 == \"texture\" {print $14}' %s", data) nooutput
texture = STATS_max
plot rows("paper", "opacity", 14) with linespoints pt 7 lw 2 lc rgb "#b03a2e" title "--fade paper", \
     rows("paper", "opacity", 17) with lines dt 3 lw 2 lc rgb "#b03a2e" notitle, \
     rows("even", "opacity", 14) with linespoints pt 7 lw 2 lc rgb "#1f5fa8" title "even", \
     rows("even", "opacity", 17) with lines dt 3 lw 2 lc rgb "#1f5fa8" notitle, \
     rows("even", "size", 14) with linespoints pt 6 lw 1 lc rgb "#1f5fa8" title "even, by size", \
     rows("even", "size", 17) with lines dt 3 lw 1 lc rgb "#1f5fa8" notitle, \
     rows("weighted", "opacity", 14) with linespoints pt 7 lw 2 lc rgb "#2e8b57" title "weighted", \
     rows("weighted", "opacity", 17) with lines dt 3 lw 2 lc rgb "#2e8b57" notitle, \
     texture with lines dt 2 lc rgb "#333333" title "a mip-mapped texture", \
     NaN with lines dt 3 lw 2 lc rgb "#333333" title "unavoidable"
unset multiplot
