# render-gl draws what it drew: lines, shadows, lights, textures, cameras, drawings, films.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden pictures
