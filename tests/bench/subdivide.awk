# Reads a triangle mesh as OBJ and writes it with every face divided into four.
function middle(a, b,    key) {
    key = a < b ? a " " b : b " " a
    if (!(key in found)) {
        found[key] = ++count
        printf "v %.17g %.17g %.17g\n", (x[a] + x[b]) / 2, (y[a] + y[b]) / 2, (z[a] + z[b]) / 2
    }
    return found[key]
}
$1 == "v" {
    count++
    x[count] = $2
    y[count] = $3
    z[count] = $4
    print
}
$1 == "f" {
    ab = middle($2 + 0, $3 + 0)
    bc = middle($3 + 0, $4 + 0)
    ca = middle($4 + 0, $2 + 0)
    printf "f %d %d %d\nf %d %d %d\nf %d %d %d\nf %d %d %d\n", $2, ab, ca, $3, bc, ab, $4, ca, bc, ab, bc, ca
}
