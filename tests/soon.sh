# Waiting for an event in shell tests; tests/tap.sh includes this file.

# alive PROCESS: whether a process runs. One that has ended may stay in the table until the shell waits for it.
alive() {
    state=$(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null) && [ -n "$state" ] && [ "${state%% *}" != Z ]
}

# soon PROCESS COMMAND ...: repeats a command until it succeeds, for a minute or more, since machines may be busy. Fails
# at once when the process that should bring it about has ended.
soon() {
    maker=$1
    tries=0
    shift
    until "$@"; do
        [ $tries -lt 600 ] || return 1
        if ! alive "$maker"; then
            "$@" # may have come just before the end
            return
        fi
        sleep 0.1
        tries=$((tries + 1))
    done
}
