# The deviation of blended solid textures relative to that of the texture, at the finest mip level, and what each blend
# costs.
set title "The contrast of four blended octaves, relative to the texture's"
set style data histograms
set style fill solid 0.8 noborder
set grid ytics
set yrange [0:1.15]
set ylabel "standard deviation, mean over a zoom cycle"
set key outside top center horizontal
cost(blend) = system(sprintf("awk -F'\\t' '$2 == \"%s\" {printf \"%%.2f\", $9; exit}' %s", blend, data))
rows(blend) = sprintf("< awk -F'\\t' '$2 == \"%s\" && $3 == 0' %s", blend, data)
named(blend) = sprintf("%s, frame %s times gouraud's", blend, cost(blend))
plot rows("linear") using 5:xtic(1) lc rgb "#d08030" title named("linear"), \
     rows("contrast") using 5 lc rgb "#30a070" title named("contrast"), \
     rows("histogram") using 5 lc rgb "#1f5fa8" title named("histogram"), \
     1 with lines dt 2 lc rgb "#333333" title ""
