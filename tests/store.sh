#!/bin/sh
# The store through the program: kills in the middle of writes, several programs
# at once, files and folders that cannot be written, a full disk, and no trace
# where none is wanted.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
KILLS=$(often 30 300)
params='params set f_mat=2 e0_min=17 alpha=0.95'

# remembers PREFIX N: a script that remembers PREFIX-1, PREFIX-2, ...
remembers() {
	printf 'load data/sites/tierp.csv\n%s\n' "$params"
	awk -v p="$1" -v n="$2" 'BEGIN {
		for (i = 1; i <= n; i++)
			print "remember " p "-" i " date=2026-11-21" }'
}

# names FILE: of all lines of JSON that are complete.
names() { sed -n 's/}$//; t found
	d
	: found
	s/"name":/\n/g; p' "$1" | sed -n 's/^"\([^"]*\)".*/\1/p' | sort; }

# own STORE: the names it holds; fails where the program does.
own() {
	"$TIPSPEED" --store="$1" --format=json -c 'materials origin=own' \
		>own.json 2>own.log || return
	names own.json
}

# Kills.  Every file is opened with PRAGMA integrity_check, so that a store that
# lists its materials is whole.  A new store every ten rounds, so that its making
# is hit too; each round's script is longer than it lives.  The delays are in
# units of the time that it takes to remember three here and now, a second at most.
remembers t 3 >three.tip
unit=1000000000
for try in 1 2 3; do
	from=$(date +%s%N)
	"$TIPSPEED" --store=t$try.db -f three.tip >/dev/null 2>&1
	took=$(($(date +%s%N) - from))
	[ $took -ge $unit ] || unit=$took
done
awk -v n=$KILLS -v unit=$unit 'BEGIN { srand(7)
	for (i = 0; i < n; i++)
		printf "%.3f\n", 1e-9 * unit * (0.1 + 2.5 * rand()) }' >delays
round=0 broken=0 lost=0 cut=0 said=0
while read -r delay; do
	round=$((round + 1))
	[ $((round % 10)) -ne 1 ] || { rm -f s.db*; : >acknowledged; }
	remembers r$round 400 >many.tip
	# Not what the last round said, if this one is killed before it starts.
	: >said
	"$TIPSPEED" --store=s.db --format=json -f many.tip >said 2>/dev/null &
	pid=$!
	sleep "$delay"
	kill -KILL $pid && cut=$((cut + 1))
	wait $pid 2>/dev/null
	names said >>acknowledged
	own s.db >there || { broken=$((broken + 1)); cat own.log >&2; }
	sort acknowledged >wanted
	[ -z "$(comm -23 wanted there)" ] || lost=$((lost + 1))
	said=$((said + $(names said | wc -l)))
done <delays
echo "# $cut killed while writing; $said remembered before"
[ $cut -ge $((KILLS * 9 / 10)) ] && [ $said -ge $((KILLS / 4)) ]
result $? "programs were killed in the middle of writes"
[ $broken -eq 0 ]
result $? "after each kill the store is whole"
[ $lost -eq 0 ]
result $? "what was said to be remembered is there"

# An import is all or nothing, and so is the change of what is there.
remembers i 600 >many.tip
"$TIPSPEED" --store=from.db -f many.tip -c 'export many.csv' >/dev/null 2>&1
"$TIPSPEED" --store=to.db -c 'import many.csv' 2>/dev/null
half=0
for delay in 0.010 0.014 0.018 0.022 0.026 0.030 0.034 0.038 0.042 0.046; do
	rm -f half.db*
	"$TIPSPEED" --store=half.db -c 'import many.csv' 2>/dev/null &
	pid=$!
	sleep $delay
	kill -KILL $pid 2>/dev/null
	wait $pid 2>/dev/null
	case $(own half.db | wc -l) in
	0 | 600) ;;
	*) half=1 ;;
	esac
done
[ $half -eq 0 ] && [ "$(own to.db | wc -l)" -eq 600 ]
result $? "an import is there whole or not at all"
"$TIPSPEED" --store=to.db -c 'export again.csv' 2>/dev/null
cmp many.csv again.csv
result $? "export, import, export gives the same bytes"

# Several at once, the first of them making the file.
for w in 1 2 3; do
	remembers w$w 40 >w$w.tip
	"$TIPSPEED" --store=both.db -f w$w.tip >w$w.out 2>w$w.log &
	eval "pid$w=$!"
done
reads=0
while kill -0 "$pid1" 2>/dev/null; do
	own both.db >/dev/null || { reads=1; cat own.log; }
done
wait "$pid1" && wait "$pid2" && wait "$pid3"
result $? "three programs write at once"
remark w1.log
[ "$(own both.db | wc -l)" -eq 120 ]
result $? "and all that they wrote is there"
[ $reads -eq 0 ]
result $? "a reader is not kept from reading"

# A row with the digest of a sheet that has more runs than the row, as an editor of
# text can make it.
awk 'BEGIN {
	printf "size_mm,feed"
	for (k = 0; k < 60; k++)
		printf ",product@%d", 50 + k
	for (i = 0; i < 10; i++) {
		printf "\n%g,%g", 16 / 2 ^ i, 100 - i * 9
		for (k = 0; k < 60; k++)
			printf ",%g", 100 - i * 8
	}
	print ""
}' >runs.csv
"$TIPSPEED" --store=few.db data/sites/tierp.csv \
	-c 'calibrate population=64 generations=2' -c 'save own.tip' \
	-c 'remember few; export few.csv' >out 2>log
"$TIPSPEED" --store=few.db runs.csv -c 'save runs.tip' >out 2>log
digests=$(sed -n 's/.*digest=//p' own.tip runs.tip | paste -sd /)
sed "s/$digests/" few.csv >false.csv
! cmp -s few.csv false.csv &&
	"$TIPSPEED" --store=false.db -c 'import false.csv' 2>log &&
	"$TIPSPEED" --store=false.db runs.csv -c 'recall few' >out 2>log
[ $? -eq 0 ] && grep -q 'runs: parameters from store: few' log
result $? "runs of a row with a false digest are not taken for those of a sheet"
remark log

# A full disk: a limit on the size of files that is met in the middle.
cp to.db full.db
before=$(own full.db | wc -l)
remembers f 600 >many.tip
(
	trap '' XFSZ
	ulimit -f 64
	"$TIPSPEED" --store=full.db -f many.tip >out 2>log
)
status=$?
[ $status -eq 5 ] && grep -q 'full.db: the store' log
result $? "a file that cannot grow is an error of the system"
remark log
[ "$(own full.db | wc -l)" -ge "$before" ]
result $? "and loses nothing"

# A disk that is full, where one may be made.
mkdir small
if mount -t tmpfs -o size=160k tmpfs small 2>/dev/null; then
	trap 'umount "$dir/small"; rm -rf "$dir"' EXIT
	"$TIPSPEED" --store=small/s.db --format=json -f many.tip >said 2>log
	status=$?
	[ $status -eq 5 ] && grep -q 'small/s.db: .*disk is full' log
	result $? "a full disk is told"
	remark log
	names said >wanted
	own small/s.db >there
	[ -s wanted ] && cmp -s wanted there
	result $? "and what was remembered before is there"
fi

# What cannot be written; root may write everywhere, so another user tries, who
# may not look into every clone.
mkdir closed open
cp to.db closed/s.db
cp "$TIPSPEED" tipspeed
cp data/sites/tierp.csv sheet.csv
chmod 755 "$dir" tipspeed sheet.csv
chmod 444 closed/s.db
chmod 555 closed
as_other=
[ "$(id -u)" -ne 0 ] ||
	as_other='setpriv --reuid=65534 --regid=65534 --clear-groups'
$as_other ./tipspeed --store=closed/s.db -c 'materials origin=own' >out 2>log
status=$?
[ $status -eq 0 ] && grep -q '^  i-600 ' out
result $? "a store in a read-only folder can be read"
remark log
chmod 000 closed
for store in closed/s.db sheet.csv/s.db; do
	$as_other ./tipspeed --store=$store -c 'materials origin=own' >out 2>log
	[ $? -eq 5 ] && grep -q "^-c:1:1: $store: the store cannot be opened" log
	result $? "it cannot be reached: $store"
	remark log
done
chmod 555 closed
# A file that cannot be replaced there is told before the command runs.
chmod 755 closed
echo old >closed/out.csv
chmod 666 closed/out.csv
chmod 555 closed
$as_other ./tipspeed --store=:memory: -c 'load none.csv > closed/out.csv' 2>log
[ $? -eq 5 ] && grep -q 'cannot write closed/out.csv: Permission denied' log
result $? "a file in a read-only folder cannot be replaced"
remark log
$as_other ./tipspeed --store=:memory: -c 'echo more >> closed/out.csv' 2>log &&
	[ "$(paste -sd ' ' closed/out.csv)" = 'old more' ]
result $? "but added to"
for store in closed/s.db closed/new.db none/new.db "$dir"; do
	$as_other ./tipspeed --store="$store" sheet.csv \
		-c "$params" -c remember >out 2>log
	status=$?
	[ $status -eq 5 ] && grep -q "^-c:2:1: $store: the store cannot be" log &&
		grep -q '^  hint: ' log
	result $? "it cannot be written: $(basename "$store")"
	remark log
done
chmod 755 closed

# No trace.
rm -rf share
home=$dir/home
mkdir "$home"
for c in version 'materials rock=granite' 'help remember' 'forget x' \
	'load data/sites/tierp.csv; recall tierp; guess; remember'; do
	HOME=$home XDG_DATA_HOME='' "$TIPSPEED" -c "$c" >/dev/null 2>&1
done
HOME=$home "$TIPSPEED" --store=:memory: data/sites/tierp.csv -c "$params" \
	-c 'remember x' -c 'materials x' >out 2>&1
result $? "a store in memory remembers"
[ -z "$(ls -A "$home")" ] && [ ! -e share ]
result $? "nothing is left where nothing was remembered"
HOME=$home XDG_DATA_HOME='' "$TIPSPEED" data/sites/tierp.csv -c "$params" \
	-c remember >out 2>&1
[ "$(stat -c %a "$home/.local/share/tipspeed")" = 700 ] &&
	[ "$(ls -A "$home/.local/share/tipspeed")" = store.db ]
result $? "the default place is a folder of the user's own"
finish
