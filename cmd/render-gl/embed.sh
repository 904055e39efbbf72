#!/bin/sh
# embed.sh FILE...: C on standard output that holds the files as shader_files.h declares them. Bytes are
# numbers, because C limits the length of a string.
set -eu
echo '#include "render-gl/shader_files.h"'
echo '#include <stddef.h>'
number=0
for file; do
    echo "static const char text_$number[] = {"
    od -An -v -tu1 "$file" | sed 's/  */,/g; s/^,//; s/$/,/'
    echo '0};'
    number=$((number + 1))
done
echo 'const struct shader_file shader_files[] = {'
number=0
for file; do
    echo "    {\"${file##*/}\", text_$number},"
    number=$((number + 1))
done
echo '    {NULL, NULL}};'
