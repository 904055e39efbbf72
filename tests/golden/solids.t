# render-gl draws what it drew: solid textures in all looks, and pictures painted in watercolour.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden solids
