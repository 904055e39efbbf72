# Functions of the benches of traced strokes.

# make_fields FOLDER: makes the scenes with a direction field: three shapes, and scans if ../shared has them
make_fields() {
    fields_scans=$(dirname "$0")/../../../../shared/data/meshes
    for fields_shape in torus teapot superquadric; do
        meshgen $fields_shape --faces 20000 | dirfield -q --smooth 1 -o "$1/$fields_shape.glb"
    done
    for fields_scan in stanford-bunny.ply armadillo.obj rocker-arm.obj; do
        [ ! -e "$fields_scans/$fields_scan" ] || dirfield -q "$fields_scans/$fields_scan" -o "$1/${fields_scan%.*}.glb"
    done
}
