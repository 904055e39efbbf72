# The syntax of shell scripts is correct, and programs are executable.
. "${TOP:-.}/tests/tap.sh"
cd "$TOP" || exit 1
for script in bootstrap .ci/run $(find tests cmd $(ls -d pipelines 2>/dev/null) -name '*.sh' -o -name '*.t' -o -name '*.limit' | sort); do
    ok "$script" sh -n "$script"
done
ok "tests/run" perl -c tests/run
for script in bootstrap .ci/run; do
    ok "$script may be executed" test -x $script
done
finish
