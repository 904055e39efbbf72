# Follows strokes by their ids, from three lists of bench_stroke_ids: of the film, of the film without thresholds of tone
# and detail, and of that through all surfaces (bench_stroke_ids.sh). A sighting is a run of frames in which a stroke is
# in sight; it is short if it lasts for fewer than three frames, none of them the first or the last of the film. It begins
# and ends at a threshold if the frame before or after has the stroke without thresholds; else behind a surface if it has
# the stroke through surfaces; else the stroke turns away there, or falls between the middles of pixels. A stroke that is in
# sight on a patch, but belongs to another one, is not drawn either.
# Ways to draw: all strokes; as render-gl does; those with as much ink as SEEN pixels; those that had as much since they
# came into sight.
BEGIN {
    FS = "\t"
    SEEN = 4
    way_count = split("all drawn inked born", ways, " ")
    kind_count = split("two thresholds:a threshold:patch:hidden:away:left out", kinds, ":")
}
FNR == 1 { list++ }
$3 == "patch" {
    if (list == 1) patch[$2 " " $1]
    next
}
list == 1 {
    if ($1 > last) last = $1
    at = $2 " " $1
    ink[at] = $3
    total += $3
    strokes++
    shown["all", at] = 1
    shown["drawn", at] = $4
    shown["inked", at] = $3 >= SEEN
    if ($5 && $1 > 0) waited++
    if ($5) { waits[at] = 1 + waits[$2 " " ($1 - 1)]; if (waits[at] > longest) longest = waits[at] }
    next
}
{ other[list, $2 " " $1] }

# Returns why a stroke is not drawn in a frame.
function reason(id, frame) {
    if ((id " " frame) in ink) return "left out"
    if ((id " " frame) in patch) return "patch"
    if ((2, id " " frame) in other) return "threshold"
    return (3, id " " frame) in other ? "hidden" : "away"
}

# Counts the sighting that begins with a frame.
function follow(way, id, frame, frames, most, kind, from, to, at) {
    for (frames = 0; shown[way, at = id " " (frame + frames)]; frames++)
        if (ink[at] > most) most = ink[at]
    sightings[way]++
    if (frames > 2 || frame == 0 || frame + frames > last) return
    from = reason(id, frame - 1)
    to = reason(id, frame + frames)
    kind = from == "threshold" && to == from ? kinds[1] : from == "threshold" || to == "threshold" ? kinds[2] : \
        from == "left out" || to == "left out" ? kinds[6] : from == "patch" || to == "patch" ? kinds[3] : \
        from == "hidden" || to == "hidden" ? kinds[4] : kinds[5]
    short[way, kind, most >= SEEN]++
}
END {
    for (key in ink) {
        split(key, part, " ")
        born = part[2] == 0
        if (!((part[1] " " (part[2] - 1)) in ink))
            for (frame = part[2]; (at = part[1] " " frame) in ink; frame++)
                shown["born", at] = born = born || ink[at] >= SEEN
    }
    for (key in ink)
        for (i = 1; i <= way_count; i++) {
            split(key, part, " ")
            if (!shown[ways[i], key])
                left_out[ways[i]] += ink[key]
            else if (!shown[ways[i], part[1] " " (part[2] - 1)])
                follow(ways[i], part[1], part[2])
        }
    printf "%s\tstrokes\t%d\t%d\t%d\t%d\n", name, last + 1, strokes / (last + 1), waited, longest
    for (i = 1; i <= way_count; i++) {
        printf "%s\t%s\t%d\t%.5f", name, ways[i], sightings[ways[i]], left_out[ways[i]] / total
        for (k = 1; k <= kind_count; k++)
            printf "\t%d/%d", short[ways[i], kinds[k], 1], short[ways[i], kinds[k], 0]
        printf "\n"
    }
}
