# Tone error against time per frame. Points with a ring are Pareto optimal: no other is both faster and more accurate.
set title "render-gl: teapot, 20,000 faces, 1280×720, three distances; time as a multiple of gouraud's"
set xlabel "time per frame over that of gouraud in the same run"
set ylabel "largest tone error over windows of 64 pixels"
set logscale x
set format x "%g"
set grid
set key top right
set offsets graph 0.1, graph 0.25, graph 0.1, graph 0.05
rows = sprintf("< awk -F'\\t' 'NR > 1 && $1 != \"gouraud\" {print $7, $9, \"\\\"\" $1 \"\\\"\"}' %s", data)
# Labels of neighbouring points are on opposite sides.
side(which) = sprintf("%s | awk '($3 ~ /^.tam.?$/) == %d'", rows, which)
front = sprintf("< awk -F'\\t' 'NR > 1 && $1 != \"gouraud\" {print $7, $9}' %s | sort -g | awk '!best || $2 < best {print; best = $2}'", data)
plot rows using 1:2 with points pt 7 ps 1.2 lc rgb "#1f5fa8" title "techniques", \
     side(0) using 1:2:3 with labels left offset 1,0.5 tc rgb "#1f5fa8" notitle, \
     side(1) using 1:2:3 with labels right offset -1.5,-0.5 tc rgb "#1f5fa8" notitle, \
     front using 1:2 with points pt 6 ps 2.5 lw 2 lc rgb "#333333" title "useful front", \
     0.03 with lines dt 2 lc rgb "#333333" title "target"
