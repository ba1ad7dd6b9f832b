#!/bin/sh
# Signals in a calibration: the best is kept, and results that go to a file are
# written.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
# Waits until a search has made generations: it says so only every two seconds.
searching() {
	tries=0
	until grep -q '^[ck]alibr' log || [ $tries -ge 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	sleep 0.5
}
# stops SIGNAL STATUS: sends it to pid, which ends with the status; five seconds are
# for busy machines.
stops() {
	from=$(date +%s%N)
	kill -s "$1" $pid
	wait $pid
	status=$?
	took=$((($(date +%s%N) - from) / 1000000))
	echo "# $took ms"
	[ $status -eq "$2" ] && [ $took -lt 5000 ]
}
run='calibrate population=400 generations=60000 tolerance=0 stall=0 polish=off threads=1'
for signal in INT TERM HUP; do
	case $signal in
	INT) want=130 ;;
	TERM) want=143 ;;
	HUP) want=129 ;;
	esac
	: >log
	# A shell starts background jobs with INT ignored, nohup with HUP; env puts
	# them back.
	env --default-signal=INT,HUP "$TIPSPEED" data/sites/tierp.csv \
		-c "$run" >out 2>log &
	pid=$!
	searching
	kill -s $signal $pid
	wait $pid
	status=$?
	[ $status -eq $want ]
	result $? "$signal ends with status $want"
	grep -q 'calibrated on 69, 79 m/s' out
	result $? "$signal prints the best so far"
done
# nohup: who is to stay after its terminal stays.
: >log
(
	trap '' HUP
	exec "$TIPSPEED" --store=:memory: data/sites/tierp.csv -c "$run" \
		</dev/null >out 2>log
) &
pid=$!
searching
kill -s HUP $pid
sleep 0.5
stops TERM 143
result $? "HUP that is ignored does not end it"
# Results that go to a file are written when ^C stops what gives them.
: >log
env --default-signal=INT "$TIPSPEED" data/sites/tierp.csv \
	-c "$run > fit.json" >out 2>log &
pid=$!
searching
kill -s INT $pid
wait $pid
[ $? -eq 130 ] && [ ! -s out ] && grep -q '"stop":"stopped"' fit.json
result $? "INT: a redirected calibration writes the best so far"
# Half a league is nothing, which is said in the user's language.
env --default-signal=INT "$TIPSPEED" --lang=sv data/sites/*.csv \
	-c 'league all' >out 2>log &
pid=$!
searching
kill -s INT $pid
wait $pid
grep -q '^stoppad innan alla modeller var kalibrerade' out log
result $? "INT: a stopped league says so in Swedish"

# A sheet of 250 sieves, where a step takes long: it is told at once, in the search, in
# the polish and while low and high are looked for. 0.2 s; others use the machine, too.
awk 'BEGIN {
	print "site,Big"; print "provenance,made up"
	print "size_mm,feed,product@65,product@75,product@85"
	for (i = 0; i < 250; i++) {
		x = 22.4 * exp(-i * log(355) / 249)
		printf "%.5g,%.5g", x, 100 * (x / 22.4) ^ 0.8
		for (v = 65; v <= 85; v += 10)
			printf ",%.5g", 100 * (1 - exp(-2 * (x * v * v / 44100) ^ 1.1))
		print ""
	}
}' >big.csv
waits=0.8
[ "$(often 0 1)" -eq 0 ] || waits="0.4 0.8 1.5 2.5"
for seconds in $waits; do
	env --default-signal=INT "$TIPSPEED" --store=:memory: big.csv \
		-c 'calibrate train=65,75,85 stall=0 tolerance=0 generations=20 threads=1' \
		-c 'predict 70' -c 'calibrate seed=2 threads=1' >out 2>log &
	pid=$!
	sleep $seconds
	stops INT 130
	result $? "250 sieves, after $seconds s: INT is answered in time"
done

# Many speeds are stopped between two of them, and nothing is shown of them.
printf '%s\n' 'load data/sites/tierp.csv' 'calibrate > /dev/null' \
	'predict 72 > /dev/null' >draws.tip
for line in 'sweep 20..99:0.04' 'card 20..99:0.04'; do
	rm -f drawn
	env --default-signal=INT "$TIPSPEED" --store=:memory: -f draws.tip \
		-c 'echo 1 > drawn' -c "$line" >out 2>log &
	pid=$!
	while [ ! -s drawn ] && kill -0 $pid; do sleep 0.1; done
	stops INT 130 && [ ! -s out ]
	result $? "$line: INT is answered in time"
done

# Reading is stopped as soon: a sheet of 1,900 sieves and 200 runs, again and again.
wide_sheet >wide.csv
for signal in INT TERM; do
	want=130
	[ $signal = INT ] || want=143
	i=0
	while [ $i -lt 100 ]; do
		echo 'load wide.csv'
		i=$((i + 1))
	done >loads.tip
	env --default-signal=INT "$TIPSPEED" --store=:memory: loads.tip >out 2>log &
	pid=$!
	sleep 0.7
	stops $signal $want && grep -q 'loads.tip:[0-9]*: interrupted' log
	result $? "$signal is answered in time while a sheet is read"
done
finish
