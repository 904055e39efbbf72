# Time, black and flicker of four techniques at equal tones.
set multiplot layout 1,3 title "strokes 2 pixels wide, tones 0 to 0.65, 960x720"
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.8 noborder
set boxwidth 0.9
set grid y
set xtics rotate by -35 nomirror scale 0
set xrange [-0.7:3.7]
set rmargin 2
set yrange [0:*]
set datafile separator "\t"
set key top left Left reverse samplen 1
of(scene) = sprintf("< awk -F'\\t' '$2 == \"%s\"' %s", scene, data)
scenes = system(sprintf("awk -F'\\t' 'NR > 1 && !seen[$2]++ {print $2}' %s", data))
set title "time of a frame over gouraud's" font ",10"
plot for [i = 1:words(scenes)] of(word(scenes, i)) using 6:xtic(1) lc i title word(scenes, i)
set title "black in the inked pixels" font ",10"
set key off
plot for [i = 1:words(scenes)] of(word(scenes, i)) using 8:xtic(1) lc i
set title "flicker in 1 degree; grey: in 0.05" font ",10"
plot for [i = 1:words(scenes)] of(word(scenes, i)) using 10:xtic(1) lc i, \
     for [i = 1:words(scenes)] of(word(scenes, i)) using (column(0) + (i - (words(scenes) + 1) / 2.0) / (words(scenes) + 1)):11:(0.9 / (words(scenes) + 1)) \
         with boxes lc rgb "#555555"
unset multiplot
