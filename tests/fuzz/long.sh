#!/bin/sh
# long.sh BINARY ...: runs each fuzzer RUNS times (default: a million) from its corpus. Inputs that crash or take over two
# seconds of processor time are written to build/fuzz/found/. Prints the numbers of fuzzers that passed and failed.
set -u
found=build/fuzz/found
mkdir -p "$found"
passed=0
failed=0

# fuzz BINARY NAME: runs a fuzzer; inputs that were slow by the clock are measured again in processor time, since the
# machine may have been busy
fuzz() {
    "$1" -runs="${RUNS:-1000000}" -seed=1 -timeout=30 -report_slow_units=2 -rss_limit_mb=1024 -max_len=65536 \
        -print_final_stats=1 -artifact_prefix="$found/$2-" "build/fuzz/grown/$2" tests/fuzz/corpus/"$2" || return 1
    for slow in "$found/$2"-slow-unit-*; do
        [ ! -e "$slow" ] || (ulimit -t 2 && "$1" "$slow") || return 1
    done
}

for fuzzer in "$@"; do
    name=$(basename "$fuzzer")
    grown=build/fuzz/grown/$name
    mkdir -p "$grown"
    if fuzz "$fuzzer" "$name" >"$grown.log" 2>&1; then
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
