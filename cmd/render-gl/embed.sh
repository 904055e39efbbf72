#!/bin/sh
# Prints the C source of the table that shader_files.h declares, from the shader files given.
set -eu
echo '#include "render-gl/shader_files.h"'
number=0
for file in "$@"; do
    echo "static const char text_$number[] = {"
    od -An -v -td1 "$file" | sed 's/[-0-9][-0-9]*/&,/g'
    echo '0};'
    number=$((number + 1))
done
echo 'const struct shader_file shader_files[] = {'
number=0
for file in "$@"; do
    echo "    {\"${file##*/}\", text_$number},"
    number=$((number + 1))
done
echo '    {0, 0}};'
