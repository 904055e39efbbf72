# Evenness against time, one line for each method over its numbers of candidates. Points with a ring are Pareto optimal:
# no other is both faster and more even.
set title "tamgen: 256², 6 tones, 4 levels, one thread, mean of five seeds"
set xlabel "processor seconds (start-up and compression included)"
set ylabel "unevenness, box N/16 (strokes at random: 1)"
set logscale x
set format x "%g"
set yrange [0.38:0.63]
set xrange [0.02:8]
set grid
set key top right
rows(name) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == 256 {sub(/:.*/, \"\", $6); print $10, $13, $6}' %s", name, data)
front = sprintf("< awk -F'\\t' '$2 == 256 {print $10, $13}' %s | sort -g | awk '!best || $2 < best {print; best = $2}'", data)
plot rows("field") using 1:2 with linespoints lw 2 pt 7 lc rgb "#1f5fa8" title "potential field (default)", \
     rows("field") using 1:2:3 with labels offset -3,-0.4 tc rgb "#1f5fa8" notitle, \
     rows("exhaustive") using 1:2 with linespoints lw 2 pt 5 lc rgb "#b8541a" title "exhaustive: every footprint in every pyramid", \
     rows("exhaustive") using 1:2:3 with labels offset 0,1 tc rgb "#b8541a" notitle, \
     front using 1:2 with points pt 6 ps 2.5 lw 2 lc rgb "#333333" title "useful front (numbers: candidates in the lightest column)"
