# Grey strokes against the time per frame, for all ways to draw one map of 255 tones. Points with a ring are Pareto
# optimal: no other is both faster and less grey.
set title "a sphere of 255 tones, 480², four samples a pixel: time against strokes that are grey"
set xlabel "time of a frame over that of the tone alone"
set ylabel "grey strokes, share of the inked pixels"
set grid
set key top right
set offsets graph 0.08, graph 0.12, graph 0.08, graph 0.05
rows(style) = sprintf("< awk -F'\\t' '$2 == \"%s\" && $3 == 4 {print $9, $13, $1}' %s", style, data)
front(style) = sprintf("< awk -F'\\t' '$2 == \"%s\" && $3 == 4 {print $9, $13}' %s | sort -g | awk '!best || $2 < best {print; best = $2}'", style, data)
plot rows("ink") using 1:2 with points pt 7 ps 1.4 lc rgb "#1f5fa8" title "ink, 1.8 pixels wide", \
     rows("ink") using 1:2:3 with labels left offset 1,0.4 tc rgb "#1f5fa8" notitle, \
     rows("bold") using 1:2 with points pt 5 ps 1.4 lc rgb "#b8541a" title "the same 4 pixels wide", \
     rows("bold") using 1:2:3 with labels left offset 1,0.4 tc rgb "#b8541a" notitle, \
     front("ink") using 1:2 with points pt 6 ps 2.5 lw 2 lc rgb "#333333" title "useful fronts", \
     front("bold") using 1:2 with points pt 6 ps 2.5 lw 2 lc rgb "#333333" notitle
