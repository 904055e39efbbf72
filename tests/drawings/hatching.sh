# Writes hatching.svg with features of drawings made in Inkscape: layers with transforms, relative and absolute commands,
# style attributes and presentation attributes, shapes other than paths.
#     sh tests/drawings/hatching.sh >pipelines/hatching.svg
# Strokes are spread evenly over the page in drawing order, from ochre to blue black, so that the whole page darkens
# evenly.
LC_ALL=C awk '
function random() { # the same everywhere, unlike awk'"'"'s
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
}
function spread(low, high) { return low + (high - low) * random() }
function place() { # the next point of an even sequence over the page
    number++
    px = (0.5 + number * 0.7548776662) % 1 * 256
    py = (0.5 + number * 0.5698402910) % 1 * 256
}
function mix(from, to, share) { return from + (to - from) * share }
function hex(share,  t) { # colour at a share of the drawing: ochre, red chalk, blue black
    if (share < 0.45) {
        t = share / 0.45
        return sprintf("#%02x%02x%02x", mix(214, 166, t), mix(150, 52, t), mix(48, 44, t))
    }
    t = (share - 0.45) / 0.55
    return sprintf("#%02x%02x%02x", mix(166, 22, t), mix(52, 30, t), mix(44, 70, t))
}
function look(share, width) { # in a style, or in attributes
    if (number % 3)
        return sprintf("style=\"stroke:%s;stroke-width:%.2f\"", hex(share), width)
    return sprintf("stroke=\"%s\" stroke-width=\"%.2f\"", hex(share), width)
}
function open_layer(name, matrix) {
    printf "  <g\n     inkscape:groupmode=\"layer\"\n     inkscape:label=\"%s\"\n", name
    printf "     style=\"fill:none;stroke-linecap:round\"\n     transform=\"%s\">\n", matrix
}
# A stroke like one drawn by hand, slightly bent and wavy.
function hatch(length_px, angle, share, width,  dx, dy, bow) {
    place()
    angle += spread(-0.06, 0.06)
    length_px *= spread(0.7, 1.15)
    dx = length_px * cos(angle); dy = length_px * sin(angle); bow = spread(-3, 3)
    px -= dx / 2; py -= dy / 2
    if (number % 4 == 0)
        shape = sprintf("M %.1f %.1f C %.1f %.1f %.1f %.1f %.1f %.1f", px, py, px + dx / 3 - bow / 4, py + dy / 3 + bow,
            px + 2 * dx / 3, py + 2 * dy / 3 + bow / 2, px + dx, py + dy)
    else if (number % 4 == 1)
        shape = sprintf("m %.1f,%.1f q %.1f,%.1f %.1f,%.1f", px, py, dx / 2, dy / 2 + bow, dx, dy)
    else if (number % 4 == 2)
        shape = sprintf("m%.1f %.1fc%.1f,%.1f,%.1f,%.1f,%.1f,%.1fs%.1f %.1f %.1f %.1f", px, py, dx / 6, bow, dx / 3, dy / 3,
            dx / 2, dy / 2, dx / 3, dy / 3 + bow / 2, dx / 2, dy / 2)
    else
        shape = sprintf("m %.1f,%.1f %.1f,%.1f %.1f,%.1f", px, py, dx / 2 + bow / 6, dy / 2 + bow / 3,
            dx / 2 - bow / 6, dy / 2 - bow / 3)
    printf "    <path %s\n       d=\"%s\" />\n", look(share, width), shape
}
function tick(share,  radius) {
    place()
    radius = spread(5, 11)
    if (number % 5 == 0)
        printf "    <circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s />\n", px, py, radius / 2, look(share, 1.6)
    else
        printf "    <path d=\"m %.1f,%.1f a %.1f %.1f %.0f 0 %d %.1f,%.1f\" %s />\n", px, py, 2 * radius, radius,
            spread(-90, 90), random() < 0.5, spread(8, 26), spread(-20, 20), look(share, 2)
}
BEGIN {
    seed = 20021101
    print "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>"
    print "<svg width=\"256mm\" height=\"256mm\" viewBox=\"0 0 256 256\" version=\"1.1\" id=\"svg1\""
    print "   xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
    print "   xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\""
    print "   xmlns=\"http://www.w3.org/2000/svg\">"
    print "  <sodipodi:namedview id=\"namedview1\" pagecolor=\"#ffffff\" inkscape:document-units=\"mm\" />"
    print "  <defs id=\"defs1\"><clipPath id=\"none\"><path d=\"M 0 0 H 9\" stroke=\"red\" /></clipPath></defs>"
    open_layer("lights", "translate(6,-9.5)")
    for (i = 0; i < 170; i++)
        hatch(80, -0.6, i / 540, 2)
    print "  </g>"
    open_layer("shades", "matrix(0.9848 0.1736 -0.1736 0.9848 4 -3)")
    for (i = 0; i < 190; i++)
        hatch(95, 0.35, (170 + i) / 540, 2.2)
    print "  </g>"
    open_layer("accents", "translate(128,128) rotate(-12) scale(1.1) translate(-128,-128)")
    print "   <g style=\"opacity:0.9\">"
    for (i = 0; i < 90; i++) {
        tick((360 + 2 * i) / 540)
        hatch(60, 1.1, (361 + 2 * i) / 540, 2.4)
    }
    print "   </g>\n  </g>\n</svg>"
}'
