# bootstrap runs make on all processors, unless its arguments say otherwise. The commands that it calls are replaced.
. "${TOP:-.}/tests/tap.sh"

mkdir bin
printf '#!/bin/sh\necho "ii "\n' >bin/dpkg-query
printf '#!/bin/sh\necho "$@"\n' >bin/make
printf '#!/bin/sh\necho 7\n' >bin/nproc
chmod +x bin/*
is "bootstrap builds on all processors" "$(PATH=$WORK/bin:$PATH "$TOP/bootstrap" demo)" "-j7 demo"
is "bootstrap passes a -j of the user on, which make obeys as the last one" \
    "$(PATH=$WORK/bin:$PATH "$TOP/bootstrap" -j2 check)" "-j7 -j2 check"
printf 'all:\n\t@echo $(MAKEFLAGS)\n' >Makefile
case $(make -s -j7 -j2) in *-j2*) pass "make obeys the last -j" ;; *) fail "make obeys the last -j" ;; esac
make -C "$TOP" -npj4 bench chart 2>/dev/null | grep -q '^chart: bench$'
is "make -j bench chart measures before it draws" $? 0
make -C "$TOP" -npj4 clean all 2>/dev/null | grep -q '^\.NOTPARALLEL:'
is "make -j clean all cleans before it builds" $? 0
finish
