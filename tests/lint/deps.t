# Includes between modules follow libhatch/DEPS, and only certain files include headers of packages.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1

includes() { # "file header" for every include of the files given; <header> keeps its brackets
    awk '/^#[ \t]*include/ {gsub(/"/, "", $2); print FILENAME, $2}' "$@"
}
ours() {
    find libhatch cmd tests -name '*.[ch]' -o -name '*.cc'
}

bad=$(awk '!/^#/ && NF {
        module = $1; sub(/:/, "", module)
        for (i = 2; i <= NF; i++) if (!($i in seen)) print module " includes " $i ", which is not above it"
        seen[module] = 1 }' libhatch/DEPS)
is "DEPS lists every module after those that it includes" "$bad" ""

bad=""
for folder in libhatch/*/; do
    module=$(basename "$folder")
    grep -q "^$module:" libhatch/DEPS || bad="$bad $module"
done
is "every module is listed in DEPS" "$bad" ""

bad=$(find libhatch -name '*.[ch]' -o -name '*.cc' | sort | while read -r file; do
    module=$(echo "$file" | cut -d/ -f2)
    allowed=" $module $(sed -n "s/^$module://p" libhatch/DEPS) "
    includes "$file" | while read -r _ header; do
        case $header in
        '<'*) ;;
        *)
            case $allowed in
            *" ${header%%/*} "*) ;;
            *) echo "$file: $header" ;;
            esac
            ;;
        esac
    done
done)
is "modules include only what DEPS allows" "$bad" ""

rooms=$(grep -v '^#' cmd/render-gl/DEPS)
is "DEPS of render-gl lists its rooms" "$(echo "$rooms" | sort)" \
    "$(find cmd/render-gl -mindepth 2 -name '*.c' | cut -d/ -f3 | sort -u)"
bad=""
below=" "
for room in $rooms; do
    below="$below$room "
    bad="$bad$(includes $(find "cmd/render-gl/$room" -name '*.[ch]') | while read -r file header; do
        case $header in
        render-gl/*/*)
            other=${header#render-gl/}
            case $below in *" ${other%%/*} "*) ;; *) echo "$file: $header" ;; esac
            ;;
        render-gl/*) echo "$file: $header stands in no room" ;;
        esac
    done)"
done
is "rooms of render-gl include only those above them in DEPS" "$bad" ""
is "no file leads back to itself by includes" "$(perl tests/lint/circles.pl $(ours | grep -E '^(libhatch|cmd)/'))" ""

# Beside its file, its shaders and the list, a technique is known by what it says of itself. Passes, messages, kinds of
# styles and mesh files may have the same words. hatchplan chooses among techniques.
names=$(sed -n 's/^ *X(\([a-z_]*\)).*/\1/p' cmd/render-gl/technique/list.h)
is "the list has techniques" "$(echo "$names" | grep -c .)" "$(grep -c '^const struct technique technique_' \
    cmd/render-gl/technique/*.c | awk -F: '{sum += $2} END {print sum - 1}')"
bad=""
for name in $names; do
    dashed=$(echo "$name" | tr _ -)
    bad="$bad$(grep -rnE "technique_$name\\b|\"$dashed\"" cmd/render-gl libhatch |
        grep -vE "^cmd/render-gl/technique/$name(_[a-z]*)?\.[ch]:|CMD_TEXT|\.name = |_end_pass\(|_check_memory\(|cmd_find_style\(|^libhatch/io/mesh/")"
    case $dashed in
    *-*) bad="$bad$(grep -rnE "(^|[^-a-z])$dashed([^-a-z]|\$)" cmd libhatch |
        grep -vE "^cmd/(hatchplan/candidates\.c|render-gl/(technique/$name\.c|shaders/))")" ;;
    esac
done
is "no technique is named outside of its file, its shaders and the list" "$bad" ""

bad=$(includes $(ours) | grep -E '<(epoxy|GL|GLES[23]?|EGL|GLFW|KHR)/' | grep -vE '^(cmd|tests/cli|tests/unit)/render-gl/')
is "only cmd/render-gl and its tests include OpenGL" "$bad" ""

# In .cc files, and in headers that only .cc files include.
bad=$(includes $(ours) | grep -E 'tiny_gltf|OpenMesh|OpenImageIO' | cut -d' ' -f1 | sort -u |
    grep -v '\.cc$' | while read -r header; do
    includes $(ours) | grep -F " ${header#libhatch/}" | grep -vE '^libhatch/[a-z/]*/[a-z_0-9]*\.cc ' ||
        case $header in libhatch/*.h) ;; *) echo "$header" ;; esac
done)
is "only adapters' .cc files and their headers include C++ packages" "$bad" ""

# Headers of packages in libhatch.
system='assert|complex|ctype|dlfcn|errno|fenv|float|inttypes|limits|math|pthread|stdalign|stdarg|stdatomic|stdbool|stddef|stdint|stdio|stdlib|string'
bad=$(includes $(find libhatch -name '*.[ch]') | grep '<' |
    grep -vE " <($system)\.h>|^libhatch/io/|^libhatch/sparse/cholmod.* <suitesparse/")
is "only io includes packages, and sparse CHOLMOD" "$bad" ""
bad=$(includes $(find cmd -name '*.[ch]') | grep -E '<(openexr|OpenEXR|png|zstd|zlib|ktx|jansson|libdeflate)')
is "commands include no package but OpenGL's" "$bad" ""
finish
