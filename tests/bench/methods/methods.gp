# Time of a frame against three errors, by method: means over scenes.
set multiplot title "means over scenes: time of a frame, in multiples of gouraud's, against three errors; lower left is better" font ",11"
means = sprintf("awk -f tests/bench/methods/means.awk %s", data)
methods = system(means." | awk -F'\\t' '$1 != \"gouraud\" {print $1}'")
of(method, i) = sprintf("< %s | awk -F'\\t' '$1 == \"%s\" {print $2 \"\\t\" $%d}'", means, method, i)
# One colour for each kind of texture, and another shape for each technique of a kind.
color(method) = strstrt(method, "tam") == 1 ? "#4878a8" : strstrt(method, "volume") || strstrt(method, "threshold") ? "#e08830" : \
    strstrt(method, "rptam") ? "#50a050" : strstrt(method, "strokes") ? "#c04040" : strstrt(method, "solid") ? "#8858b0" : "#202020"
shape(i) = word("1 2 3 4 7 6 5 7 9 7 7 7 7 7 7", i) + 0
set datafile separator "\t"
set grid
set logscale x 2
set xrange [2:32]
set xlabel "time of a frame"
set key off
set tmargin at screen 0.85
set bmargin at screen 0.14
draw(i) = sprintf("plot for [m = 1:words(methods)] of(word(methods, m), %d) using 1:2 with points pt shape(m) ps 1.3 lw 1.8 lc rgb color(word(methods, m)) title word(methods, m)", i)
set title "tone error, rms" font ",10"
set yrange [0:*]
set lmargin at screen 0.06
set rmargin at screen 0.27
eval draw(5)
set title "widest / narrowest over 3 octaves" font ",10"
set logscale y 2
set yrange [0.9:10]
set lmargin at screen 0.33
set rmargin at screen 0.54
eval draw(7)
unset logscale y
set title "flicker in a turn by a degree" font ",10"
set yrange [0:*]
set lmargin at screen 0.615
set rmargin at screen 0.825
set key at screen 0.995, screen 0.85 right top Left reverse samplen 0.5 spacing 1.3
eval draw(8)
unset multiplot
