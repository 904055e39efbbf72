# Prints the means of methods.tsv over scenes, a line per method, in the order of the file: geometric means of ratios and
# spreads, arithmetic means of all else; nan where no scene has the figure.
#   method ratio bytes setup_s tone_rms grey_strokes spread flicker continuity
BEGIN { FS = OFS = "\t" }
NR == 1 { next }
!($1 in scenes) { order[++count] = $1 }
{
    scenes[$1]++
    for (i = 4; i <= 11; i++) {
        if ($i == "nan")
            continue
        given[$1, i]++
        sum[$1, i] += is_factor(i) ? log($i) : $i
    }
}
function is_factor(i) { return i == 4 || i == 9 }
function mean(method, i) {
    if (!given[method, i])
        return "nan"
    value = sum[method, i] / given[method, i]
    return is_factor(i) ? exp(value) : value
}
END {
    for (k = 1; k <= count; k++) {
        line = order[k]
        for (i = 4; i <= 11; i++)
            line = line OFS sprintf("%.6g", mean(order[k], i))
        print line
    }
}
