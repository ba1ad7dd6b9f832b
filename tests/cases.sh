#!/bin/sh
# Each folder of tests/cases holds a run of the program:
#   cmd       shell commands, run in a folder of their own that has data/
#   expected  what they print, standard error included
#   status    their exit status, where it is not 0
# `make renew` writes expected and status anew: look at the difference.
#   SHARD=k SHARDS=n   the k-th, the k + n-th .. of them; all without
#   CASE=NAME          that one alone
# A search that takes long says its generations, which on a busy machine any may:
# these lines are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
mkdir "$dir/bin"
ln -s "$TIPSPEED" "$dir/bin/tipspeed"
PATH=$dir/bin:$PATH
cases=$(cd "$srcdir/tests/cases" && pwd)
at=0
for c in "$cases"/${CASE:-*}/; do
	at=$((at + 1))
	[ $((at % ${SHARDS:-1})) -eq $((${SHARD:-0} % ${SHARDS:-1})) ] || continue
	name=$(basename "$c")
	mkdir "$dir/$name"
	ln -s "$dir/data" "$dir/$name/data"
	(cd "$dir/$name" && LC_ALL=C.UTF-8 sh "$c/cmd") >"$dir/all" 2>&1 </dev/null
	status=$?
	sed '/^  generation  *[0-9]/d' "$dir/all" >"$dir/out"
	if [ "${RENEW:-}" = 1 ]; then
		cp "$dir/out" "$c/expected"
		rm -f "$c/status"
		[ $status -eq 0 ] || echo $status >"$c/status"
	fi
	want=$(cat "$c/status" 2>/dev/null || echo 0)
	diff "$c/expected" "$dir/out" >"$dir/diff" 2>&1
	same=$?
	[ $same -eq 0 ] && [ "$status" = "$want" ]
	result $? "case $name"
	[ $same -eq 0 ] || { remark "$dir/diff"; echo "# make renew"; }
	[ "$status" = "$want" ] || echo "# exit status $status, not $want"
done
finish
