# Error of tone against the number of strokes kept.
set title "tone of traced strokes in 960x720 pixels, engraving: error against the strokes that are kept"
set xlabel "strokes"
set ylabel "root mean square error of tone over windows of 32 pixels"
set logscale xy
set format x "10^{%L}"
set format y "%g"
set yrange [0.01:0.5]
set grid
set key bottom left Left reverse samplen 1
set datafile separator "\t"
rows(scene, method) = sprintf("< awk -F'\\t' '$1 == \"%s\" && $2 == \"%s\"' %s | sort -n -k 4", method, scene, data)
scenes = system(sprintf("awk -F'\\t' 'NR > 1 {print $2}' %s | sort -u", data))
plot for [i = 1:words(scenes)] rows(word(scenes, i), "share") using 4:6 with lines lw 2 lc i \
         title word(scenes, i) . ", strokes up to a threshold", \
     for [i = 1:words(scenes)] rows(word(scenes, i), "levels") using 4:6 with points pt 7 lc i \
         title word(scenes, i) . ", the first 3 to 7 levels"
