# render-gl draws what it drew: every technique with every kind of scene and option.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden techniques
