# For the tests of this folder, after tests/tap.sh.

# golden PART: checks that the runs of a part of tests/bytes/list.sh write what PART.tsv says
golden() {
    if [ ! -x "$BUILD/tests/golden/pixels" ]; then
        skip "golden figures of $1" "make check builds pixels"
        finish
    fi
    sh "$TOP/tests/golden/figures.sh" "$1" "$BUILD" >figures.tsv || { fail "figures of $1"; finish; }
    perl "$TOP/tests/golden/golden.pl" check "$TOP/tests/golden/$1.tsv" figures.tsv
}
