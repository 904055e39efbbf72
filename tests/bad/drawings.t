# Drawings that are damaged or mean harm, made here: one clear line each, soon, and nothing left.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/bad/lie.sh"

# repeat COUNT TEXT
repeat() {
    awk -v count="$1" -v text="$2" 'BEGIN {for (i = 0; i < count; i++) printf "%s", text}'
}
svg='<svg viewBox="0 0 9 9">'

(echo "$svg" && repeat 100000 '<g>' && repeat 100000 '</g>' && echo '</svg>') >nested.svg
(echo "$svg" && repeat 100000 '<p>' && repeat 100000 '</p>' && echo '</svg>') >nested-unknown.svg
(echo '<!DOCTYPE svg [<!ENTITY a0 "ha">' && awk 'BEGIN {
    for (i = 1; i < 30; i++) printf "<!ENTITY a%d \"&a%d;&a%d;&a%d;&a%d;\">\n", i, i - 1, i - 1, i - 1, i - 1}' &&
    echo "]>$svg<text>&a29;</text></svg>") >laughs.svg
(echo '<!DOCTYPE svg [<!ENTITY a "' && repeat 50000 hahaha && echo '">' && echo "]>$svg<text>" &&
    repeat 100000 '&a;' && echo '</text></svg>') >quadratic.svg
echo "<!DOCTYPE svg [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>$svg<text>&a;</text></svg>" >entity-file.svg
echo "<!DOCTYPE svg [<!ENTITY % a SYSTEM \"http://example.org/a\"> %a;]>$svg</svg>" >entity-network.svg
echo "$svg<use href=\"http://example.org/a.svg#b\"/></svg>" >clone-network.svg
echo "$svg<use xlink:href=\"/etc/passwd#b\"/></svg>" >clone-file.svg
echo '<svg width="100000000" height="100000000"><path d="M0 0h9" stroke="red"/></svg>' >gigabytes.svg
echo '<svg viewBox="0 0 1e-300 1e-300"><path d="M0 0h9" stroke="red"/></svg>' >tiny-page.svg
echo "$svg<path d=\"M0 0H1e300\" stroke=\"red\"/></svg>" >far.svg
echo "$svg<path d=\"M0 0C0 0 1e9 1e9 9 9\" stroke=\"red\"/></svg>" >wide-curve.svg
echo "$svg<path d=\"M0 0h9\" stroke-width=\"1e8\" stroke=\"red\"/></svg>" >broad.svg
echo "$svg<g transform=\"scale(1e200)\"><g transform=\"scale(1e200)\"><path d=\"M1 1h9\" stroke=\"red\"/></g></g></svg>" \
    >overflow.svg
echo "$svg<path d=\"M0 0hNaN\" stroke=\"red\"/></svg>" >nan.svg
echo "$svg<path d=\"M0 0h9\" stroke=\"red\"/>" >cut.svg
printf '<svg viewBox="0 0 9 9">\0</svg>' >zero-byte.svg
head -c 20000 "$TOP/pipelines/hatching.svg" >half.svg
(echo "$svg<path id=\"a0\" stroke=\"red\" d=\"M0 0h9\"/>" && awk 'BEGIN {for (i = 1; i < 30; i++) {
    printf "<g id=\"a%d\">", i; for (k = 0; k < 10; k++) printf "<use href=\"#a%d\"/>", i - 1; print "</g>"}}' &&
    echo '</svg>') >clones.svg
echo "$svg<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g></svg>" >clone-cycle.svg
(echo "$svg" && awk 'BEGIN {for (i = 0; i < 100000; i++) printf "<g id=\"a%d\"><use href=\"#a%d\"/></g>\n", i, i + 1}' &&
    echo '</svg>') >clone-chain.svg
echo "$svg<path stroke-dasharray=\"1e-9\" d=\"M0 0h9\" stroke=\"red\"/></svg>" >dashes.svg
(echo "$svg<style>" && awk 'BEGIN {for (i = 0; i < 100000; i++) printf ".a%d{stroke:red}", i}' && echo '</style></svg>') \
    >rules.svg
echo "$svg<text>a</text></svg>" >no-strokes.svg
: >empty.svg
printf 'x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\tpath\n0\t0\t0\t0\t.1\t1\t0\t0\t0\t0,0 1e9,0\n' >far.tsv
printf 'x\ty\tlength\tangle\twidth\ttone\tr\tg\tb\tbend\n0\t0\t9\t0\t.1\t1\t0\t0\t0\t7\n' >coil.tsv

for file in *.svg *.tsv; do
    try tamgen --size 64 --replay "$file" -o map.exr
    refused "$file" "$(case $file in gigabytes.svg | clones.svg | dashes.svg | rules.svg) echo 5 ;; *) echo 3 ;; esac)" 1
    ok "$file is named" grep -q "$file: " .err
done
ok "nothing is left" test ! -e map.exr
if [ -z "$SANITIZE" ]; then
    for file in nested.svg nested-unknown.svg laughs.svg quadratic.svg gigabytes.svg far.svg wide-curve.svg \
        clones.svg clone-cycle.svg dashes.svg; do
        lie "$PWD/$file" tamgen -j1 -o map.exr --replay
    done
fi

echo "$svg<style>@import 'file:///etc/passwd';.a{stroke:url(http://example.org/a)}</style><image href=\"file:///etc/passwd\"/><image href=\"http://example.org/a.png\"/>
    <path d=\"M0 3h9\" stroke=\"red\"/></svg>" >references.svg
if command -v strace >/dev/null; then
    strace -f -o trace tamgen --size 64 --replay references.svg -o map.exr 2>/dev/null
    is "a picture of elsewhere is not opened" "$(grep -cE 'passwd|socket|connect' trace)" 0
else
    skip "a picture of elsewhere is not opened" "no strace"
fi
finish
