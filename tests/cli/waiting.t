# Waiting in tests: it ends with the process that is waited for.
. "${TOP:-.}/tests/tap.sh"

# never: counts its calls
never() {
    echo >>calls
    return 1
}

sh -c 'exit 3' &
ended=$!
soon $ended never
is "a wait fails when the process has ended" $? 1
is "it has tried a few times" "$(($(wc -l <calls) <= 5))" 1

# A process that has ended and that its parent does not wait for is in the table still.
perl -e 'my $child = fork; exit 0 unless $child; open my $f, ">", "child"; print $f $child; close $f; sleep 1000' &
parent=$!
soon $parent [ -s child ]
rm calls
soon "$(cat child)" never
is "nor does it wait for a dead child" "$? $(($(wc -l <calls) <= 5))" "1 1"
kill $parent

sleep 1000 &
running=$!
later() {
    never
    [ "$(wc -l <calls)" -ge 10 ]
}
rm calls
soon $running later
is "it goes on while the process runs" "$? $(wc -l <calls)" "0 10"
kill $running

(echo >last) &
soon $! [ -s last ]
is "what came just before the end counts" $? 0
finish
