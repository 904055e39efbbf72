# Error of tone against the number of fitted strokes.
set title "tone of fitted strokes in 960x720 pixels: error against their number"
set xlabel "strokes"
set ylabel "root mean square error of tone over windows of 32 pixels"
set logscale xy
set format "%g"
set xrange [150:15000]
set yrange [0.01:0.5]
set grid
set key bottom left Left reverse samplen 1
set datafile separator "\t"
rows(scene, method) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\"' %s | sort -n -k 4", method, scene, data)
scenes = system(sprintf("awk -F'\\t' 'NR > 1 {print $2}' %s | sort -u", data))
plot for [i = 1:words(scenes)] rows(word(scenes, i), "largest") using 4:5 with linespoints pt 6 lw 2 lc i \
         title word(scenes, i) . ", the largest strokes", \
     for [i = 1:words(scenes)] rows(word(scenes, i), "size") using 4:5 with linespoints pt 7 lw 2 dt 2 lc i \
         title word(scenes, i) . ", all strokes, of other sizes"
