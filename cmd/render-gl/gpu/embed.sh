#!/bin/sh
# embed.sh BINDINGS FOLDER FILE... writes a C source that defines the variables of shader_files.h. They hold the FILEs,
# with names relative to FOLDER, and the #define lines of BINDINGS. Texts are written as arrays of numbers, because C
# limits the length of string literals.
set -eu
bytes() {
    od -An -v -tu1 | sed 's/  */,/g; s/^,//; s/$/,/'
}
echo '#include "render-gl/gpu/shader_files.h"'
echo '#include <stddef.h>'
echo 'const char shader_bindings[] = {'
sed -n 's|^\(#define [A-Z_]* [0-9][0-9]*\).*|\1|p' "$1" | bytes
echo '0};'
folder=$2
shift 2
number=0
for file; do
    echo "static const char text_$number[] = {"
    bytes <"$file"
    echo '0};'
    number=$((number + 1))
done
echo 'const struct shader_file shader_files[] = {'
number=0
for file; do
    echo "    {\"${file#"$folder"/}\", text_$number},"
    number=$((number + 1))
done
echo '    {NULL, NULL}};'
