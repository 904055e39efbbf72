# render-gl draws what it drew: rptam and strokes at all zooms, moving options.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden seeds
