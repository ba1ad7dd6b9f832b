#!/bin/sh
# Every writer, killed in the midst (kill -9): a file is what it was or what it
# was to be, a left-over blocks nothing, and the next run removes it.  In a PID
# namespace, where there may be one, the program has the same number each time,
# as in a container.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
KILLS=$(often 10 300)
inside=
[ "$(unshare --pid --fork sh -c 'echo $$' 2>/dev/null)" != 1 ] ||
	inside="unshare --pid --fork --kill-child=KILL"

# turn N: the commands that write, the same files with one of two contents.
turn() {
	echo "reset; load data/sites/tierp.csv"
	echo "params set f_mat=$1 e0_min=16 alpha=1"
	echo 'predict 74 > out/table.txt'
	echo 'sweep 60..90:0.5 > out/sweep.csv'
	echo 'predict 74 > out/predict.json'
	echo 'plot psd speed=74 > out/plot.svg'
	echo 'plot psd speed=74 > out/plot.png'
	echo 'plot psd speed=74 > out/plot.pdf'
	echo "remember pit$1 date=2026-11-22 replace=on"
	echo 'export out/own.csv replace=on'
	echo 'write out/site.csv replace=on'
	echo 'save out/session.tip replace=on'
	echo "calibrate population=64 generations=$1 polish=off stall=0 \
tolerance=0 > out/fit.json"
	echo 'echo added >> out/added'
}
same='table.txt sweep.csv predict.json plot.svg plot.png site.csv session.tip'
without='^$'
if "$TIPSPEED" -c version | grep -q 'without cairo'; then
	same=$(echo "$same" | sed 's/plot.png//')
	without='png$|pdf$'
fi
turn 2 | grep -vE "$without" >two.tip
turn 3 | grep -vE "$without" >three.tip
run() { "$TIPSPEED" --store=own.db -f "$1" >>log 2>&1; }
mkdir out want
for i in two three; do
	rm -f own.db out/added
	run $i.tip || cat log
	cp -r out want/$i
done

# whole FILE: one that has a time in it, or what the store held at the moment.
whole() {
	case $1 in
	added) ! grep -qvx added out/$1 ;;
	plot.pdf) head -c 5 out/$1 | grep -q '%PDF-' &&
		tail -n 1 out/$1 | grep -q '%%EOF' ;;
	*) [ "$(tail -c 1 out/$1 | wc -l)" = 1 ] ;;
	esac
}

# A script that writes without end, one content after the other.
for i in 1 2 3 4 5 6 7 8 9 10; do cat two.tip three.tip; done >both.tip
awk -v n="$KILLS" 'BEGIN { srand(11)
	for (i = 0; i < n; i++) printf "%.3f\n", 0.02 + 0.5 * rand() }' >delays
torn=0 most=0 cut=0 blocked=0
while read -r delay; do
	rm -f out/added
	$inside "$TIPSPEED" --store=own.db -f both.tip >/dev/null 2>&1 &
	pid=$!
	sleep "$delay"
	kill -KILL $pid 2>/dev/null && cut=$((cut + 1))
	wait $pid 2>/dev/null
	for f in $same; do
		cmp -s out/$f want/two/$f || cmp -s out/$f want/three/$f || {
			torn=$((torn + 1))
			echo "# torn after $delay s: $f"
		}
	done
	for f in fit.json own.csv plot.pdf added; do
		[ ! -s out/$f ] || whole $f || {
			torn=$((torn + 1))
			echo "# torn after $delay s: $f"
		}
	done
	left=$(find out -name '.tipspeed-*' | wc -l)
	[ "$left" -le $most ] || most=$left
	run two.tip || blocked=$((blocked + 1))
	[ "$(find out -name '.tipspeed-*' | wc -l)" = 0 ] ||
		blocked=$((blocked + 1))
done <delays
echo "# $cut of $KILLS killed${inside:+, always as process 1}"
[ "$cut" -ge $((KILLS * 9 / 10)) ] && [ $torn -eq 0 ]
result $? "$KILLS kills over all writers: nothing is torn"
[ "$most" -le 1 ]
result $? "no more than one left-over, seen: $most"
[ $blocked -eq 0 ]
result $? "the next run is not blocked, and removes it"
finish
