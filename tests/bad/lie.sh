# A file that promises more than it holds is refused within 50 ms and 16 MiB.

# within KIB COMMAND ...
within() {
    (ulimit -v "$1" && shift && exec "$@")
}

# The address space that a command takes for itself, in KiB.
own_space() {
    kib=8192
    while ! within $kib "$1" --version >/dev/null 2>&1; do
        kib=$((kib + 1024))
    done
    echo $kib
}

# lie FILE COMMAND ...: FILE goes last
lie() {
    name="$2 ${3#--}: $(basename "$1")"
    lying=$1
    shift
    space=$(own_space "$1")
    "$@" "$lying" >plenty 2>&1
    status=$?
    within $((space + 16384)) "$@" "$lying" >little 2>&1
    is "$name: refused within 16 MiB" "$? $(cat little)" "$status $(cat plenty)"
    case $status in 3 | 5) ;; *) fail "$name: refused" "exit $status" ;; esac
    ms=$(milliseconds 50 "$@" "$lying")
    [ "$ms" -le 50 ]
    is "$name: refused within 50 ms ($ms)" $? 0
}
