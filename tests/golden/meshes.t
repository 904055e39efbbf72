# meshgen, dirfield, lapped-param, meshfit, hatchplan and strokegen write what they wrote.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden meshes
