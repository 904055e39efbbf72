# The shader that tampack(1) prints, compiled as it stands, draws the tones that it is asked for, from the files that the
# line of README.md and that of the manual make.
. "${TOP:-.}/tests/tap.sh"
[ -z "$SANITIZE" ] || { skip "the manual's shader" "only run without sanitizers"; finish; }

sed -n '/^\.Ss Metadata for shaders/,/^\.Sh/{/^\.Bd -literal/,/^\.Ed/p}' "$TOP/man/man1/tampack.1" | sed '/^\./d' >six.glsl
grep -q 'float hatch(float darkness, vec2 uv)' six.glsl
is "tampack(1) has the function" $? 0
# "A map of more tones has one texture and one line more for each three of them."
sed 's/tam0, tam1;/tam0, tam1, tam2, tam3;/; s/^\( *+ three(x, \)4.0, texture(tam1, uv).rgb);/\14.0, texture(tam1, uv).rgb)\
         + three(x, 7.0, texture(tam2, uv).rgb)\
         + three(x, 10.0, texture(tam3, uv).rgb);/' six.glsl >twelve.glsl
ok "the program compiles" ${CC:-cc} -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -I"$TOP/libhatch" -I"$TOP/cmd" \
    "$TOP/tests/cli/render-gl/manual_shader.c" -o draw -Wl,--start-group "$BUILD/lib/libhatch-render-gl.a" \
    "$BUILD/lib/libhatch-cmd.a" "$BUILD/lib/libhatch-texture.a" "$BUILD/lib/libhatch-core.a" -Wl,--end-group \
    -lepoxy -lzstd -lm -pthread

# draws NAME SHADER FILE ...: checks that the ink is the tone, within .03, at all tones
draws() {
    name=$1
    shift
    ./draw "$@" >drawn 2>.err
    is "$name: eleven tones are drawn" "$? $(wc -l <drawn) $(cat .err)" "0 11 "
    is "$name: the ink of each is the tone" "$(awk '($1 - $2) ^ 2 > .03 ^ 2' drawn)" ""
}
# The lines as they stand, with a smaller map.
PATH=$WORK/bin:$PATH
mkdir bin
printf '#!/bin/sh\nexec "%s/tamgen" "$@" --size 128\n' "$BIN" >bin/tamgen
chmod +x bin/tamgen
cp "$TOP/styles/ink.style" my.style
line=$(sed -n 's/^ \{4\}\(.*| tampack .*\)/\1/p' "$TOP/README.md")
sh -c "$line"
is "README.md has a line with tampack" "$? $(ls hatch.*.ktx2 | tr '\n' ' ')" "0 hatch.0.ktx2 hatch.1.ktx2 "
draws "README.md's line" six.glsl hatch.?.ktx2
line=$(sed -n 's/^\.Dl \(.*tampack --ink 1 .*\)/\1/p' "$TOP/man/man1/tampack.1")
sh -c "$line"
is "the manual's line makes its files" "$? $(ls tam.*.ktx2 | tr '\n' ' ')" "0 tam.0.ktx2 tam.1.ktx2 "
draws "the manual's line" six.glsl tam.?.ktx2
for ink in 0 1; do
    tamgen --tones 12 | tampack --ink $ink -o twelve$ink.ktx2
    draws "twelve tones, ink $ink" twelve.glsl twelve$ink.?.ktx2
done
if command -v glslangValidator >/dev/null; then
    { printf '#version 300 es\nprecision highp float;\nin vec2 uv;\nout vec4 color;\n' && cat six.glsl &&
        printf 'void main()\n{\n    color = vec4(vec3(1.0 - hatch(0.5, uv)), 1.0);\n}\n'; } >web.frag
    ok "WebGL compiles the shader" glslangValidator web.frag
else
    skip "WebGL compiles the shader" "no glslangValidator"
fi
finish
