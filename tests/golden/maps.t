# tamgen, tampack, tamvol, tamthresh, solidgen, seedgen and hatchstat write what they wrote.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden maps
