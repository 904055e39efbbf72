# Error against memory of the textures made from a map of 255 tones. Points with a ring are Pareto optimal: no other is
# both smaller and more accurate.
set title "textures made from a map of 255 tones, 256², four levels: error against memory"
set xlabel "bytes of texels"
set ylabel "mean error of a sample's darkness"
set logscale xy
set format x "%.0s%cB"
set grid
set key top right
paint(name) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"colour\" {print $10, $12, $3}' %s", name, data)
rows(name) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"ink\" {print $10, $12, $3}' %s", name, data)
front = sprintf("< awk -F'\\t' '$2 == \"ink\" {print $10, $12}' %s | sort -g | awk '!best || $2 < best {print; best = $2}'", data)
plot rows("bins") using 1:2 with linespoints lw 2 pt 5 lc rgb "#b8541a" title "thresholds: fitted bins", \
     rows("bins") using 1:2:3 with labels offset 1.2,0 tc rgb "#b8541a" notitle, \
     rows("volume") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "volume: tones", \
     rows("volume") using 1:2:3 with labels offset 0,0.8 tc rgb "#1f5fa8" notitle, \
     rows("array") using 1:2 with linespoints lw 2 pt 9 lc rgb "#2b8a3e" title "array", \
     rows("blocks") using 1:2 with linespoints lw 2 pt 11 lc rgb "#7b3fa0" title "array in blocks (BC4)", \
     rows("exact") using 1:2 with points pt 13 ps 1.5 lc rgb "#c92a2a" title "exact runs", \
     paint("volume") using 1:2 with linespoints lw 1 dt 2 pt 6 lc rgb "#1f5fa8" title "in colour: volume", \
     paint("bc7") using 1:2 with linespoints lw 1 dt 2 pt 8 lc rgb "#2b8a3e" title "volume in blocks (BC7)", \
     paint("bc1") using 1:2 with linespoints lw 1 dt 2 pt 10 lc rgb "#7b3fa0" title "array in blocks (BC1)", \
     front using 1:2 with points pt 6 ps 2.5 lw 2 lc rgb "#333333" title "useful front"
