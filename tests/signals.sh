#!/bin/sh
# Signals in a calibration: the best is kept, a checkpoint is written, and another
# run goes on from it to the result of an undisturbed one.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
run='calibrate population=400 generations=60000 tolerance=0 stall=0 polish=off'
for signal in INT TERM HUP; do
	case $signal in
	INT) want=130 ;;
	TERM) want=143 ;;
	HUP) want=129 ;;
	esac
	rm -f point
	# A shell starts background jobs with INT ignored; env puts it back.
	env --default-signal=INT "$TIPSPEED" data/sites/tierp.csv \
		-c "$run checkpoint=point" >out 2>log &
	pid=$!
	tries=0
	until grep -q 'generation  *10 ' log || [ $tries -ge 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	kill -s $signal $pid
	wait $pid
	status=$?
	[ $status -eq $want ]
	result $? "$signal ends with status $want"
	grep -q 'calibrated parameters' out
	result $? "$signal prints the best so far"
	[ "$(head -n 1 point)" = 'tipspeed checkpoint 3' ]
	result $? "$signal writes the checkpoint"
	[ "$(tail -n 1 point | cut -c1-4)" = 'end ' ]
	result $? "$signal writes all of it"
	"$TIPSPEED" data/sites/tierp.csv -c "$run resume=point pause=1" \
		-c quit >again 2>log &
	pid=$!
	tries=0
	until grep -q 'going on after generation' log || [ $tries -ge 100 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	grep -q 'going on after generation' log
	result $? "$signal: another run goes on from it"
	kill -s TERM $pid
	wait $pid
done
# Results that go to a file are written when ^C stops what gives them.
env --default-signal=INT "$TIPSPEED" data/sites/tierp.csv \
	-c "$run > fit.json" >out 2>log &
pid=$!
tries=0
until grep -q 'generation  *10 ' log || [ $tries -ge 300 ]; do
	sleep 0.1
	tries=$((tries + 1))
done
kill -s INT $pid
wait $pid
[ $? -eq 130 ] && [ ! -s out ] && grep -q '"stop":"stopped"' fit.json
result $? "INT: a redirected calibration writes the best so far"
finish
