#!/bin/sh
# Runs a test of `make check` by automake's driver and says less: in a log a line for
# each script as it ends, on a terminal one line with what runs and how many are
# done.  What fails is told in both.
#   driver.sh LOGS COMMAND...   LOGS: the log files of all tests, blanks between;
#                               COMMAND: the driver, its options, the test
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
logs=$1
shift
trs='' log='' name='' was=''
for word in "$@"; do
	case $was in
	--test-name) name=$word ;;
	--log-file) log=$word ;;
	--trs-file) trs=$word ;;
	--) break ;;
	esac
	was=$word
done
terminal=false
[ ! -t 1 ] || terminal=true

# A test that runs has a log, one that is done has results too.
progress() {
	ended=0 all=0 running=
	for l in $logs; do
		all=$((all + 1))
		if [ -f "${l%.log}.trs" ]; then
			ended=$((ended + 1))
		elif [ -f "$l" ]; then
			l=${l##*/}
			running="$running ${l%.log}"
		fi
	done
	[ $ended -lt $all ] || running=
	printf '\r\033[K'
	[ -z "$running" ] || printf '%.79s' "$ended of $all done;$running"
}

# results WORD...: how many ended in one of these ways.
results() {
	n=0
	for way in "$@"; do
		n=$((n + $(grep -c "^:test-result: $way" "$trs")))
	done
	echo $n
}

: >"$log"
! $terminal || progress
from=$(date +%s)
said=$("$@")
status=$?
took=$(($(date +%s) - from))
! $terminal || printf '\r\033[K'
printf '%s\n' "$said" | grep -vE '^[^A-Z]*(PASS|SKIP|XFAIL)[^ ]*: |^$'
if $terminal; then
	progress
else
	failed=$(results FAIL ERROR XPASS) skipped=$(results SKIP)
	[ "$failed" -eq 0 ] && failed= || failed=", $failed failed"
	[ "$skipped" -eq 0 ] && skipped= || skipped=", $skipped skipped"
	echo "$name: $(results PASS) passed$failed$skipped, $took s"
fi
exit $status
