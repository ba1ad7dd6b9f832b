#!/bin/sh
# A tour of the program in which one thing fails: an allocation (faults/allocate.c,
# preloaded), or a call to the system (strace, because what stdio and SQLite call
# cannot be preloaded).  Then the status is not 0, or all is as without the fault;
# no signal ends it; files are old or new, never torn; and nothing is left over.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
shim=$PWD/tests/faults/allocate.so
skip_all() {
	echo "1..0 # SKIP $1"
	exit 0
}
! grep -q __asan_init "$TIPSPEED" ||
	skip_all 'a sanitizer has its own allocator and its own ways to end'
[ -f "$shim" ] || skip_all "there is no $shim"
scratch
cd "$dir" || exit 99
# Fontconfig keeps its cache there.
HOME=$dir/home
LC_ALL=C.UTF-8
export HOME LC_ALL
mkdir home before
unset XDG_CACHE_HOME XDG_STATE_HOME

known='params set f_mat=2.18 e0_min=16.74 alpha=0.96'
"$TIPSPEED" --store=before/store.db data/sites/tierp.csv -c "$known" \
	-c 'remember date=2026-11-20' -c 'export before/rows.csv' >log 2>&1 &&
cp data/sites/tierp.csv before/sheet.csv &&
for f in old.csv old.log old.svg old.png old.tip old.xlsx old.html; do
	echo 'as it was' >before/$f || exit
done &&
echo "$known; predict 74" >before/script.tip || exit 99

# tour PART: one part of the tour, in the present folder.
tour() {
	case $1 in
	json) $under "$TIPSPEED" --store=:memory: --format=json sheet.csv \
		-c check -c "$known" -c 'predict 74' -c validate -c why ;;
	tables) $under "$TIPSPEED" --store=:memory: sheet.csv -c check \
		-c 'source script.tip; validate; why; sweep; find p80=5.5' \
		-c 'show bounds; materials; guess; plot psd; help predict' ;;
	calibrate) $under "$TIPSPEED" --store=:memory: sheet.csv \
		-c 'calibrate population=64 generations=4 threads=2' \
		-c 'validate; predict 72' -c 'plot convergence > history.csv' ;;
	pictures) $under "$TIPSPEED" --store=:memory: sheet.csv -c "$known" \
		-c 'plot psd > old.svg' -c 'plot psd > old.png' ;;
	store) $under "$TIPSPEED" --store=store.db sheet.csv -c "$known" \
		-c 'params set alpha=1' \
		-c 'remember replace=on date=2026-11-21; materials' \
		-c 'recall tierp; export rows.csv replace=on' ;;
	save) $under "$TIPSPEED" --store=:memory: sheet.csv -c "$known" \
		-c 'predict 74 > old.csv; predict 72 >> old.log' \
		-c 'save old.tip replace=on; write sheets' ;;
	books) $under "$TIPSPEED" --store=:memory: sheet.csv -c "$known" \
		-c 'predict 74 > old.xlsx; predict 74 > old.html' ;;
	esac
}

# run PART PREFIX...: the part in a fresh folder `now`, its output in out.  The store
# is compared by its rows: where SQLite left them in its log, they are there.
run() {
	part=$1
	shift
	under=$*
	rm -rf now
	cp -r before now
	(cd now && tour "$part") >out 2>err
	status=$?
	[ "$part" != store ] ||
		"$TIPSPEED" --store=now/store.db -c 'export now/stored' \
			>log 2>&1 || echo 'cannot be read' >now/stored
	rm -f now/store.db*
}

# whole: each file is as before or as in the run without a fault, and no other there.
whole() {
	for f in $(cd now && find . -type f); do
		cmp -s "now/$f" "before/$f" || cmp -s "now/$f" "after/$f" ||
		{ [ "$f" = ./stored ] && cmp -s now/stored before/rows.csv; } ||
			{ echo "torn or left over: $f"; return 1; }
	done
	for f in $(cd before && find . -type f ! -name 'store.db*'); do
		[ -f "now/$f" ] || { echo "gone: $f"; return 1; }
	done
}

# Nobody here can mend these: a path in the trace of the call, and the reason.
excepted() {
	grep -q INJECTED trace 2>/dev/null || return 1
	# fontconfig goes on with another font, or none, and says nothing.
	grep INJECTED trace | grep -q '[/.]font'
}

# judge WHAT: counts the run, tells what is wrong with it.
judge() {
	runs=$((runs + 1))
	fault=
	if [ $status -gt 127 ]; then
		fault="ended by a signal, status $status" kind=signals
	elif [ $status -eq 0 ]; then
		cmp -s out out.$part && diff -r now after >/dev/null ||
			fault='status 0, but other results' kind=wrong
	else
		fault=$(whole) || kind=torn
	fi
	[ -n "$fault" ] || return 0
	! { [ $kind = wrong ] && excepted; } || kind=spared
	eval "$kind=\$(($kind + 1))"
	[ $kind = spared ] || echo "# $1: $fault"
}

# sum_up KIND PART OF: the test point.
sum_up() {
	[ $signals -eq 0 ] && [ $wrong -eq 0 ] && [ $torn -eq 0 ] &&
		[ $runs -gt 0 ]
	result $? "$2: $runs of $3 $1 fail; $signals by signal, $wrong wrong \
with status 0, $torn torn, $spared excepted"
	runs=0 signals=0 wrong=0 torn=0 spared=0
}
runs=0 signals=0 wrong=0 torn=0 spared=0

# stride N: every how many of N faults of a kind and part there are to be.
stride() {
	most=$(often 4 "$1")
	echo $((($1 + most - 1) / most))
}

allocations() {
	export FAULT_COUNT="$dir/count"
	run "$1" env LD_PRELOAD="$shim"
	unset FAULT_COUNT
	all=$(cat count)
	step=$(stride "$all")
	i=1
	while [ $i -le "$all" ]; do
		run "$1" env LD_PRELOAD="$shim" FAULT=$i
		judge "$1, allocation $i"
		i=$((i + step))
	done
	sum_up allocations "$1" "$all"
}

# What the calls are called differs between machines; strace leaves out unknown ones.
calls='?open,?openat,?creat,?read,?pread64,?write,?pwrite64,?fsync,?fdatasync,?rename,?renameat,?renameat2,?close,?ftruncate'

# Each call after the libraries were loaded, three errors: "openat ENOSPC 37".
list_calls() {
	awk '{ sub(/^[0-9]+ +/, ""); sub(/\(.*/, ""); name = $0 }
		NR > last { for (i in error) print name, error[i], n[name] + 1 }
		{ n[name]++ }
		BEGIN { split("ENOSPC EIO EINTR", error); last = LAST }' \
		LAST="$(grep -n '\.so[.0-9]*[">]' trace | tail -n 1 | cut -d: -f1)" \
		trace
}

system_calls() {
	run "$1" strace -f -qq -y -o "$dir/trace" -e trace="$calls" -e signal=none
	list_calls >calls
	all=$(wc -l <calls)
	awk -v step="$(stride "$all")" 'NR % step == step - 1 || step == 1' \
		calls >some
	while read -r call error number; do
		run "$1" strace -f -qq -y -o "$dir/trace" -e signal=none \
			-e trace="$calls" \
			-e inject="$call:error=$error:when=$number"
		judge "$1, $call $number $error"
	done <some
	sum_up 'system calls' "$1" "$all"
}

strace -qq -o log true 2>/dev/null
traced=$?
for part in ${PARTS-json tables calibrate pictures store save books}; do
	run $part
	[ $status -eq 0 ]
	result $? "$part: without a fault"
	rm -rf after
	mv now after
	cp out out.$part
	allocations $part
	if [ $traced -eq 0 ]; then
		system_calls $part
	else
		n=$((n + 1))
		echo "ok $n - $part: system calls # SKIP strace cannot trace here"
	fi
done
finish
