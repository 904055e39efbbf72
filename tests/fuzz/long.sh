#!/bin/sh
# long.sh BINARY ...: runs each fuzzer RUNS times (a million) from its corpus; what crashes or hangs
# over two seconds goes to build/fuzz/found/. Ends with the number of fuzzers that passed and failed.
set -u
found=build/fuzz/found
mkdir -p "$found"
passed=0
failed=0
for fuzzer in "$@"; do
    name=$(basename "$fuzzer")
    grown=build/fuzz/grown/$name
    mkdir -p "$grown"
    if "$fuzzer" -runs="${RUNS:-1000000}" -seed=1 -timeout=2 -rss_limit_mb=1024 -max_len=65536 \
        -print_final_stats=1 -artifact_prefix="$found/$name-" "$grown" tests/fuzz/corpus/"$name" \
        >"$grown.log" 2>&1; then
        passed=$((passed + 1))
        echo "$name: passed, $(sed -n 's/^stat::average_exec_per_sec: *//p' "$grown.log") runs a second"
    else
        failed=$((failed + 1))
        echo "$name: FAILED, see $grown.log"
        tail -n 20 "$grown.log"
    fi
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
