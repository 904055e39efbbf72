# render-gl draws and reports what it did: volumes, thresholds, show and probe.
. "${TOP:-.}/tests/tap.sh"
. "$TOP/tests/golden/check.sh"
golden reports
