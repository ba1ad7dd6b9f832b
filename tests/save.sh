#!/bin/sh
# A saved session, run again anywhere, gives the very same results, and saved
# again the very same script.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
here="$dir/a b å\"q;#>"
mkdir "$here" "$dir/else"
cp "$srcdir"/data/sites/tierp.csv "$srcdir"/data/sites/bro.csv \
	"$srcdir/data/table3.csv" "$srcdir/data/specs/en-12620-0-4.csv" "$here"
cp "$srcdir/data/sites/ossjo.csv" "$here/"'a "quoted" name.csv'

# same FILE FILE: alike but for the seconds of calibrations.
same() {
	sed 's/"seconds":[^,]*//' "$1" >"$dir/left"
	sed 's/"seconds":[^,]*//' "$2" | diff "$dir/left" - >"$dir/diff"
}

# replays NAME OPTIONS SCRIPT: runs the script, saves, and runs what was saved.
replays() {
	rm -f "$dir"/*.tip
	(cd "$here" && "$TIPSPEED" $2 -c "$3" -c 'save ../one.tip') \
		>"$dir/first" 2>"$dir/log"
	result $? "$1: saved"
	(cd "$dir/else" && "$TIPSPEED" ../one.tip -c 'save ../two.tip') \
		>"$dir/second" 2>"$dir/log"
	result $? "$1: replayed in another folder"
	same "$dir/first" "$dir/second"
	result $? "$1: the results are the same"
	remark "$dir/diff"
	cmp "$dir/one.tip" "$dir/two.tip" >"$dir/diff" 2>&1
	result $? "$1: the script is the same"
	# Some of them, all in the long tests.
	restores=$((restores + 1))
	[ $((restores % $(often 4 1))) -eq 0 ] || return 0
	(cd "$dir/else" && "$TIPSPEED" --seed=99 --format=csv \
		-c 'load ../data/sites/umea.csv' -c 'restore ../one.tip' \
		-c 'save ../three.tip') >"$dir/third" 2>"$dir/log"
	same "$dir/first" "$dir/third" && cmp -s "$dir/one.tip" "$dir/three.tip"
	result $? "$1: and so they are restored in the midst of another"
	remark "$dir/diff"
}

fit='params set f_mat=2 e0_min=16 alpha=1'
quick='population=200 generations=8'
restores=0
replays 'one site' '' "load tierp.csv; calibrate $quick; predict 74; validate
	sweep 70..80:5; show product; check; echo \"a \"\"b\\ #>\" å"
replays 'names with blanks and quotes' --format=json \
	"load \"a \"\"quoted\"\" name.csv\" ./bro.csv; use ÖSSJÖ
	calibrate seed=5 $quick; predict; use bro; calibrate $quick; sweep 70,80"
replays 'settings' '--seed=7 --format=csv' "synth table3.csv site=Umeå seed=3
	set method classes k 2; bounds alpha 0.5; seed; set; calibrate $quick
	params set f_mat=2; params; predict 74; bounds default; bounds
	set format json csv semicolon; predict 75 feed=69; drop umea"
replays 'all sites' '' "load tierp.csv bro.csv; calibrate all $quick polish=off
	predict; sites"
replays 'stopped in the search' --format=json "load tierp.csv
	calibrate $quick pause=5; predict 74; seed 3; continue; predict 74"
replays 'stopped and accepted' --format=json "load tierp.csv
	calibrate $quick pause=5; accept; sweep 70,71"
replays 'stopped in the polish' --format=json "load tierp.csv
	calibrate $quick pause=11; continue pause=13; predict 75"
replays 'bounds edited in the search' --format=json "load tierp.csv
	calibrate $quick pause=3; bounds e0_min 0..9; continue pause=5
	bounds alpha 0.5; bounds e0_min 0..50; continue; predict 75"
grep -q '"bounds_edited_at":5' "$dir/first"
result $? "bounds edited in the search: the result says so"
replays 'bounds edited in the polish' --format=json "load tierp.csv
	calibrate $quick pause=11; bounds f_mat 0.5..0.7; continue; predict 75"
replays 'stopped among all' --format=json "load tierp.csv bro.csv
	calibrate all $quick pause=12; use tierp; predict 75"
replays 'stopped between sites' --format=json "load tierp.csv bro.csv
	calibrate all $quick polish=off pause=8; use tierp; predict 75"
replays 'questions whose results went elsewhere' --format=json "load tierp.csv
	calibrate $quick; predict 71; predict 72 feed=69 > product.csv; pin
	find p80=5.2 | cat >product.csv
	why; predict; describe psd beside=pinned"
replays 'an envelope' '' "load tierp.csv; params set f_mat=2 e0_min=16 alpha=1
	find spec=en-12620-0-4.csv"
replays 'an envelope as the goal' --format=json "load tierp.csv; $fit
	set goal en-12620-0-4.csv; predict 74"
mkdir "$dir/plain"
cp "$here/tierp.csv" "$here/en-12620-0-4.csv" "$dir/plain"
odd=$here here=$dir/plain
replays 'an envelope and a condition as the goal' '' "load tierp.csv; $fit
	set goal=\"passing 2 = 40,5..50; ./en-12620-0-4.csv\" k=2; predict 74"
here=$odd
long=$(printf '%0120d' 0)
mkdir "$here/$long"
cp "$here/tierp.csv" "$here/bro.csv" "$here/$long"
replays 'a blend of feeds far down' --format=json "load tierp.csv; $fit
	set feed $long/tierp.csv@69*0.5+$long/bro.csv@69*0.5; predict 74"
replays 'files aside' --format=json "load tierp.csv
	calibrate $quick pause=6 > fit.json
	predict 74 | cat >product.csv
	continue > fit.json
	predict 74 > product.json; write copy.csv replace=on; sweep 70,71"

# What was undone is not in it, nor what came before a reset.
run() { (cd "$here" && "$TIPSPEED" "$@"); }
run -c "load bro.csv; reset; load tierp.csv; params set f_mat=2 e0_min=16 alpha=1
	predict 71; predict 72; seed 3; undo; redo; undo; predict 73
	set k 2; predict 76; undo; load bro.csv; undo; redo
	save ../undone.tip" >"$dir/out" 2>"$dir/log"
grep -v '^#' "$dir/undone.tip" | sed 's/".*\/\([a-z]*.csv\)"/\1/' >"$dir/out"
cat >"$dir/want" <<'END'
load tierp.csv digest=812272b685abdf02
params set f_mat=2 e0_min=16 alpha=1
predict 73
load bro.csv digest=7cf447237a8dfa59
END
diff "$dir/want" "$dir/out" >"$dir/diff"
result $? "what was undone is left out"
remark "$dir/diff"
run --format=json -c "load tierp.csv; $fit; pin 69; load bro.csv; undo; predict
	save ../asked.tip" 2>"$dir/log" | tail -n 1 >"$dir/want"
run ../asked.tip 2>"$dir/log" | tail -n 1 | diff "$dir/want" - >"$dir/diff"
result $? "nor does the speed that a question takes from the latest one differ"
remark "$dir/diff"
run -c "load tierp.csv; source ../undone.tip; undo; undo
	restore ../undone.tip; undo; save ../empty.tip" >"$dir/out" 2>&1
result $? "source and restore are one step each"
[ "$(grep -vc '^#' "$dir/empty.tip")" -eq 0 ]
result $? "an empty session is an empty script"

# refused NAME STATUS WORDS [OPTION] COMMANDS
refused() {
	run ${5:+"$4"} -c "${5:-$4}" >"$dir/out" 2>&1
	[ $? -eq "$2" ] && grep -q "$3" "$dir/out"
	result $? "$1 is refused"
}
sed 's/92.92/92.93/' "$here/tierp.csv" >"$here/bro.csv"
refused 'a sheet that has changed' 3 'expected a site file with digest 7cf447237a8dfa59, got' \
	'source ../undone.tip'
# changes FILE WORDS: a session with the command is saved, the file changed
changes() {
	cp "$here/$1" "$dir/was"
	rm -f "$dir/files.tip" "$dir/again.tip"
	run -c "load tierp.csv; params set f_mat=2 e0_min=16 alpha=1" \
		-c "$2; save ../files.tip replace=on" >"$dir/out" 2>&1
	run -c 'restore ../files.tip; save ../again.tip replace=on' \
		>"$dir/out" 2>&1
	cmp -s "$dir/files.tip" "$dir/again.tip"
	result $? "$2 is saved and restored as it was"
	echo >>"$here/$1"
	refused "$2 with another file" 3 "$1 with digest .*has changed" \
		'restore ../files.tip'
	rm "$here/$1"
	refused "$2 without its file" 3 'cannot be read' 'restore ../files.tip'
	cp "$dir/was" "$here/$1"
}
printf 'size_mm,feed\n16,100\n8,62\n4,31\n2,17\n1,8\n' >"$here/north one.csv"
printf 'size_mm,min_pct,max_pct\n4,10,90\n2,5,60\n' >"$here/own.csv"
cat >"$here/own.circuit" <<'END'
feed,new,80
crusher,new,crushed
stockpile,crushed
END
changes 'north one.csv' 'blend tierp.csv@74=60 "north one.csv=40"'
changes 'north one.csv' 'predict 72 feed="north one.csv"'
changes own.csv 'spec own.csv'
changes own.csv 'find p80=5 spec=own.csv'
changes own.circuit 'flow tph=100 circuit=own.circuit'
run --store=s.db -c 'load tierp.csv; params set f_mat=2 e0_min=16 alpha=1
	remember pit; recall pit; predict 74; save ../pit.tip
	params set f_mat=1; remember pit replace=on' >"$dir/out" 2>&1
refused 'a material that has changed' 3 'it has changed' \
	'--store=s.db' 'source ../pit.tip'
refused 'a material that is gone' 2 "no material 'pit'" 'source ../pit.tip'
# A folder with the script and its sheets is found wherever it is moved and
# wherever the script is run from; names of other folders stay as they are.
plant="$dir/plant"
mkdir -p "$plant/sheets"
cp "$here/tierp.csv" "$plant/sheets/tierp"
cp "$here/tierp.csv" "$here/north one.csv" "$here/own.csv" "$plant/sheets"
cp "$srcdir/data/sites/bro.csv" "$plant"
cp "$srcdir/data/sites/umea.csv" "$dir"
cp "$srcdir/data/energy/vsi-69.csv" "$plant/sheets"
(cd "$plant/sheets" && "$TIPSPEED" --format=json -c "load tierp ../bro.csv
	load ../../umea.csv; use tierp; params set f_mat=2 e0_min=16 alpha=1
	spec own.csv; set goal=\"passing 2 = 30..50; ./own.csv\"
	predict 72 feed=\"north one.csv*0.5+tierp.csv@69*0.5\"
	energy load vsi-69.csv" -c 'save ../quarry' -c 'save tierp.tip') \
	>"$dir/first" 2>"$dir/log"
result $? 'a session is saved above its sheets'
remark "$dir/log"
! grep -v "^load $dir/umea.csv\|^#" "$plant/quarry.tip" |
	grep "$dir" && grep -q "^load $dir/umea.csv" "$plant/quarry.tip" &&
	grep -q '^load sheets/tierp ' "$plant/quarry.tip" &&
	grep -q '^load ./tierp ' "$plant/sheets/tierp.tip"
result $? 'and names them from its folder'
mv "$plant" "$dir/moved"
# Answers name the sheets by their paths.
same_but_for_folders() {
	for file in first second; do
		sed 's#[^" ;*+]*/\([^"/ ;*+]*\.csv\)#\1#g; s#/[^"*+]*/##g' \
			"$dir/$file" | grep -v '"command":"load"' >"$dir/$file.txt"
	done
	same "$dir/first.txt" "$dir/second.txt"
}
echo nonsense >"$dir/else/bro.csv"
printf 'source moved/quarry.tip\nwrite bro.csv replace=on\n' >"$dir/outer.tip"
for from in / "$dir/else" "$dir/moved" "$dir/moved/sheets"; do
	(cd "$from" && "$TIPSPEED" --format=json "$dir/moved/quarry.tip") \
		>"$dir/second" 2>"$dir/log" && same_but_for_folders
	result $? "it is found from $(basename "$from")"
	remark "$dir/log"
done
(cd "$dir/else" && "$TIPSPEED" --format=json -f ../outer.tip) \
	>"$dir/second" 2>"$dir/log" && same_but_for_folders &&
	grep -q '^size_mm' "$dir/else/bro.csv" && [ ! -e "$dir/bro.csv" ]
result $? 'a script that sources it finds it; what it writes is written here'
remark "$dir/log"

mkdir -p "$dir/own/sub"
cp "$here/tierp.csv" "$dir/own"
cp "$here/bro.csv" "$dir/own/sub/cut.csv"
printf 'load tierp.csv\nwrite cut.csv\nreset\nload cut.csv\n' \
	>"$dir/own/sub/own.tip"
(cd "$dir/own" && "$TIPSPEED" sub/own.tip) >"$dir/out" 2>&1
tail -n 1 "$dir/out" | grep -q '^loaded Tierp'
result $? 'a script reads what it wrote, not a file of that name beside it'
remark "$dir/out"

refused 'a script that is there' 2 'already exists' 'save ../undone.tip'
refused 'another name' 2 'ends in .tip' 'save results.csv'
refused 'a device' 2 'ends in .tip, got ./dev/full.' 'save /dev/full'
refused 'a folder that is not there' 5 'cannot write' 'save no/such.tip'
refused 'a digest for two files' 2 'one file' 'load a b digest=1'
name=$(printf 'line\nbreak.csv')
cp "$here/tierp.csv" "$here/$name"
(cd "$here" && "$TIPSPEED" "$name" -c 'save ../three.tip replace=on') \
	>"$dir/out" 2>&1
[ $? -eq 3 ] && grep -q 'cannot write' "$dir/out"
result $? "a name that no script can hold is refused"
mkdir -p "$dir/state/tipspeed"
for pid in 99999 100002; do
	printf '# 1 command, %s\nload tierp.csv\n' "$pid" \
		>"$dir/state/tipspeed/session-$pid.tip"
done
touch -d '2026-11-25 10:00:00.1' "$dir/state/tipspeed/session-99999.tip"
touch -d '2026-11-25 10:00:00.2' "$dir/state/tipspeed/session-100002.tip"
XDG_STATE_HOME=$dir/state "$TIPSPEED" -c restore >"$dir/out" 2>&1
grep -o 'command, [0-9]*' "$dir/out" | head -n 1 | grep -q 100002
result $? "of two sessions kept in one second the later comes first"
finish
