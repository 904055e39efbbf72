# Time per frame against the number of strokes, a line per size of the picture. Dashed: the plane through all points.
set xlabel "strokes in the picture"
set ylabel "time per frame, milliseconds"
set format x "%.0f"
set grid
set key top left Left reverse
set fit quiet logfile "/dev/null"
set xrange [0:17500]
set yrange [0:*]
rows(size) = sprintf("< awk -F'\\t' '$16 == \"nan\" && $3 ~ /%s/ {print $4, $5, $12}' %s | sort -n -k2", size, data)
whole(p, s) = base + per_megapixel * p + per_thousand * s / 1000
base = 100
per_megapixel = 500
per_thousand = 10
fit whole(x, y) rows(".") using 1:2:3 via base, per_megapixel, per_thousand
sum = sprintf("%.0f ms + %.0f ms per megapixel + %.1f ms per 1,000 strokes", base, per_megapixel, per_thousand)
set title "render-gl -t strokes: teapot, 27,000 faces, four samples\ndashed: the sum that fits best, " . sum
array sizes[3] = ["1920x1200", "1360x850", "960x600"]
array megapixels[3] = [2.304, 1.156, 0.576]
array colors[3] = [0xb03a2e, 0x1f5fa8, 0x2e7d32]
plot for [i = 1:3] rows(sizes[i]) using 2:3 with linespoints pt 7 lw 2 lc rgb colors[i] \
         title sprintf("%s: %.1f megapixels", sizes[i], megapixels[i]), \
     for [i = 1:3] whole(megapixels[i], x) with lines dt 2 lc rgb colors[i] notitle
