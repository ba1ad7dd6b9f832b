#!/bin/sh
# The full screen in tmux: keys, sizes, a calibration, and every way out.
# `make renew` writes the golden screens anew: look at the difference.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
golden=$(cd "${srcdir:-.}/tests" && pwd)/screens
. "${srcdir:-.}/tests/mux.sh"

# same NAME: the screen is the golden one.
same() {
	[ -z "${RENEW:-}" ] || cp screen "$golden/$1"
	diff "$golden/$1" screen >difference
	good=$?
	remark difference
	result $good "the screen $1 (make renew writes it anew)"
}
p50() { sed -n 's/.*P50  *\([0-9.]*\)±.*/\1/p' screen | head -n 1; }
# generation FILE: how far the search is on the screen kept there.
generation() {
	sed -n 's/.*generation \([0-9]*\) of .*/\1/p' "$1" | head -n 1
}
# further NAME: the search comes further than it was in the file shot.
further() {
	tries=0
	until shot; [ "$(generation screen)" -gt "$(generation shot)" ] ||
		[ $tries -ge 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done 2>/dev/null
	[ $tries -lt 300 ]
	result $? "$1"
}

# cursor X,Y NAME: the cursor comes to stand there.
cursor() {
	tries=0
	until at=$(mux display-message -t one -p '#{cursor_x},#{cursor_y}')
		[ "$at" = "$1" ] || [ $tries -ge 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	[ "$at" = "$1" ]
	result $? "the cursor is on $2 (at $at)"
}

start 80 24
want '\[74\.0\]' "it opens at the speed held out"
want '◎' "the curve of P80 over the speeds comes when there is time"
same 80x24
before=$(p50)
keys : 'screen > shot' Enter
want ': screen > shot'
# A terminal does not tell blanks in reverse at the end of a row.
sed 's/ *$//' shot | diff "$golden/80x24" - >difference
good=$?
remark difference
result $good "screen writes what the terminal shows"
keys Right
want '\[74\.1\]' "an arrow moves the speed by 0.1"
keys Right Right Right Right
want '\[74\.5\]'
[ -n "$before" ] && [ "$(p50)" != "$before" ]
result $? "and P50 follows"
want ': predict speed=74\.5' "the command it composed is shown"
cursor 35,20 'the slider'
keys Home
want '\[65\.0\]' "Home"
want 'EXTRAPOLATED' "outside the speeds trained on it says so"
keys End
want '\[85\.0\]' "End"
keys 7 2 . 3 Enter
want '\[72\.3\]' "a typed speed"
keys 7 4 Enter
want '\[74\.0\]'
for size in '100 30' '40 12' '20 5'; do
	# shellcheck disable=SC2086
	set -- $size
	mux resize-window -t one -x "$1" -y "$2"
	tries=0
	until shot; [ "$(wc -l <screen)" -eq "$2" ] && grep -q '\[74\.0\]' screen ||
		[ $tries -ge 300 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	sleep 0.3
	shot
	same "$1x$2"
done
mux resize-window -t one -x 10 -y 1
want '74.0' "one row"
mux resize-window -t one -x 300 -y 100
want 'J/kg' "300 x 100"
mux resize-window -t one -x 80 -y 24
want '^\[*tipspeed\|^Tierp'

keys c b
want 'crosshair 5\.6 mm  *50 %' "the crosshair reads the curves"
want 'band  *8[0-9.]* \.\. 8[0-9.]* %' "and the band at its sieve"
cursor 33,20 'the slider'
keys Down '>'
want 'crosshair 4 mm  *55 %' "keys move the sieve and the level"
want 'band  *6[0-9.]* \.\. 6[0-9.]* %'
keys '<' b c x
want '74\.0 m/s  vs pinned 74\.0' "a prediction is kept beside"
keys 7 8 Enter
want '78\.0 m/s  vs pinned 74\.0'
want 'P50  *2\.69±0\.0[0-9]  *-0\.16' "with what is now less than it"
want '╌ pinned' "and a curve of its own"
keys : 'flow tph=120' Enter
want '120 t/h at 78 m.s' "a command with a speed takes the slider's"
keys q
keys e
want '^:compare pinned 78\.0 > tierp-78.0.xlsx' "e exports both"
keys Escape x 7 4 Enter
want '^: predict speed=74\.0 '
keys : 'set k 1.'
keys Enter
want ': set k 1\.' "a typed command"
keys : 'sh' Tab 'prod' Tab Enter
want 'product at each speed\|product' "completion, and what it prints"
keys q : 'plot psd' Enter
want 'data: reconstructed'
! grep -q '\[0' screen
result $? "without escapes, on a terminal with colours"
keys q
keys : 'help trust' Enter
want '[a-z] .*back'
longest=$(head -n 21 screen | sed 's/ *$//' | awk '{ print length }' | sort -n | tail -n 1)
mux resize-window -t one -x 50 -y 24
want '^Tierp.*\] 2 3 4 5'
! grep -q 'more right' screen && [ "$longest" -gt 70 ]
result $? "a text gets other lines on a narrower terminal"
mux resize-window -t one -x 80 -y 24
want '^Tierp.*2 Fit'
keys q
keys : 'predict 99999' Enter
want '^! ' "an error is told"
keys '?'
want '^  Left Right  *the slider of the page ' "the list of keys"
keys / 'by 5'
want 'speed up by 5'
cursor 5,23 'the word to find'
keys Down Enter
want '\[79\.0\]' "finds a word, and Enter does what it says"
keys 7 4 Enter : Up
want '^:predict 99999' "the history"
keys Escape 7 1
cursor 9,22 'a speed that is typed'
keys Escape

keys 2
want 'generation 1 ---' "the page Fit"
keys - - f y
want 'CALIBRATING' "it can be watched"
keys '=74.1' Enter
want '\[74\.1\]' "the speed moves while it runs"
keys : 'screen > shot' Enter
want 'wrote shot: 24 lines'
grep -q CALIBRATING shot
result $? "a picture has the calibration"
further "and does not stop it"
keys Space
want 'PAUSED' "pause"
keys Space + + + + + + + +
want 'calibrated: good' "a calibration to its end"
keys - - - - f y
want 'CALIBRATING.* 1[0-9] of' "a calibration to be edited"
keys : 'bounds e0_min 0..9' Enter
want 'continues within the new bounds' \
	"a bound edited while it runs holds from there on"
want 'generation [1-9][0-9] of'
keys Space
want 'PAUSED'
keys : 'bounds e0_min 0..12' Enter
want ': bounds e0_min 0..12'
keys Space + + + + + + + +
want 'calibrated: good' "and it comes to its end"
keys : 'show params' Enter
want 'e0_min  *1[0-2]\.' "within them"
keys q
keys '=65' Enter End Left Left Left
want 'generation 1 .*\]-' "the generations are gone through"
keys Home
want 'generation 1 \[1\]-' "to the first of them"
keys s 3
want 'sieve mm' "the page Data"
keys 5
want '\* tierp  *Granite  *11\.2  *69 o74 79  *good  *0\.3.  *0\.4.  *3\.[34].[?]' \
	"the page Sites says how far each is calibrated"
keys 1 u
want ': undo' "undo"
keys U
want ': redo'
keys w 'kept.tip' Enter
want ': save kept.tip'
tries=0
until [ -s kept.tip ] || [ $tries -ge 300 ]; do sleep 0.1; tries=$((tries + 1)); done
"$TIPSPEED" -f kept.tip -c 'save again.tip' >replay 2>log
cmp kept.tip again.tip >>log && grep -q '^bounds e0_min 0..12$' kept.tip
good=$?
[ $good -eq 0 ] || remark log
result $good "the session is written as a script that does the same"
keys q
want 'IT IS OVER' "q leaves"
[ "$(cat status)" = 0 ] && cmp -s before after && ! grep -q 'J/kg' screen
result $? "and the terminal is as it was"
start 80 24
want '\[74\.0\]'
keys f
want 'calibrate it again'
keys y
want 'CALIBRATING'
keys q
want 'the calibration was stopped' "q says that it stops a calibration"

# What is pasted is typed into an open line, and never run.
# sums: what is in the folder, but for what the tests themselves write there.
sums() {
	find . -type f ! -name screen ! -name bytes ! -name sums ! -name difference \
		-exec cksum {} + | sort
}
start 80 24
want '\[74\.0\]'
paste ':sites | touch stray
:bounds alpha 0.4
q'
want '^:sites | touch stray *$' "pasted text is no keys"
keys Escape
want '\[74\.0\]'
keys calibrate
want '^:calibrate *$' "nor is a word that is typed"
keys Escape
want '\[74\.0\]'
keys :
paste 'set k 1.5
set k 3
'
want '^:set k 1\.5 *$' "it goes into an open line"
want 'only part of the pasted text was used'
keys Enter
want ': set k 1\.5 ' "which Return runs, and nothing else"
keys 7
paste '2qx.3'
want 'speed: 72\.3_' "of a speed that is typed it has digits"
keys Escape '?' /
paste 'by 5
'
want '^/by 5  2 keys  Enter run it' "it is a word to find"
keys Escape
want '^  Left Right '
keys Escape
want '\[74\.0\]'
awk 'BEGIN { srand(5); printf ":"; for (i = 0; i < 20000; i++)
	printf "%c", rand() < 0.1 ? 13 : 1 + int(126 * rand()) }' >random
sums >sums
mux load-buffer -b clip random
for line in '' :; do
	# shellcheck disable=SC2086
	[ -z "$line" ] || keys $line
	mux paste-buffer -p -b clip -t one
	sleep 1
done
keys Escape
want '\[74\.0\]'
sums | diff sums - >difference
good=$?
remark difference
[ ! -e stray ] || good=1
result $good "random bytes that are pasted change no file"
awk 'BEGIN { for (i = 0; i < 20000; i++) print ":q what is pasted is no key" }' \
	>much
mux load-buffer -b clip much
mux paste-buffer -p -b clip -t one
keys Escape
want '\[74\.0\]'
keys Right
want '\[74\.1\]' "nor do 600 kB"
keys -l "$(printf '\033[200~')"
sleep 0.3
keys q
sleep 2.5
keys Escape
want '\[74\.1\]'
keys Right
want '\[74\.2\]' "a paste that does not end holds the keys for 2 seconds"
echo mine >mine.csv
keys : 'sites > mine.csv' Enter
want '^mine.csv exists: replace it? y/n' "a file is not replaced unasked"
paste y
sleep 0.3
keys Right
want '^! mine.csv was not replaced'
[ "$(cat mine.csv)" = mine ]
result $? "any key but y is a no, and so is what is pasted"
keys : 'sites > mine.csv' Enter
want '^mine.csv exists'
for size in '40 12' '20 5' '80 24'; do
	# shellcheck disable=SC2086
	set -- $size
	mux resize-window -t one -x "$1" -y "$2"
	want 'replace it? y/n' "the question at $1 x $2"
done
want 'm/s  [0-9]* J/kg ──'
keys C-z y
want '^wrote mine.csv: 1 row$'
grep -q '^sites,' mine.csv
result $? "y replaces it"
printf '%s\n' 'Sieve mm;Feed;Product 1;Product 2' '8;100;100;100' '4;40;60;65' \
	'1;5;15;19' >open.csv
keys : 'load open.csv' Enter
want "column 3 'Product 1': tip speed" "what a sheet leaves open is asked"
for size in '40 12' '20 5' '100 30' '80 24'; do
	# shellcheck disable=SC2086
	set -- $size
	mux resize-window -t one -x "$1" -y "$2"
	want '^.*> *\|^> *$' "the dialogue at $1 x $2"
done
want 'Esc gives up'
keys Escape
want 'what column 3 is' "Escape gives up"
keys q : 'load open.csv' Enter
want "column 3 'Product 1'"
paste 'banana'
want '> banana' "what is pasted comes into its line"
keys Enter
want "expected a tip speed.*'banana'" "what is no answer is asked again"
keys C-z 6 8 Left Delete 9 Enter
want "column 4 'Product 2'" "it is edited as commands are, ^Z is no answer"
want '3  Product 1 .*product@69' "answers stand in the table"
keys C-c
want 'what column 3 is' "^C gives up"
keys q : 'load open.csv' Enter
want "column 3 'Product 1'"
keys 69 Enter
want "column 4 'Product 2'"
keys 79 Enter
want 'loaded open: 2 runs' "with all answers it is loaded"
keys q : 'use tierp' Enter
want '^\[*tipspeed\|^Tierp'
keys : 'predict > here.csv' Enter
want '^wrote here.csv: 12 rows$' "what was written stays told"
"$TIPSPEED" data/sites/tierp.csv -c 'calibrate; set k 1.5' \
	-c 'predict 74.2 > there.csv' >log 2>&1
cmp here.csv there.csv
result $? "predict > FILE writes the prediction on the screen"
keys : 'predict 72 > here.csv' Enter
want '\[72\.0\]'
want '^wrote here.csv: 12 rows$' "also where it moves the slider"
keys q
want 'IT IS OVER'
[ "$(marked)" = '?2004l' ]
result $? "pasted text is not marked any more"
rm -f .local/state/tipspeed/session*

# A shell of its own, for job control.
start 80 24 PS1='shell: ' HISTFILE= sh -i
keys "'$TIPSPEED' data/sites/tierp.csv -c calibrate -c tui" Enter
want '\[74\.0\]'
keys C-z
want 'Stopped\|Suspended' "^Z"
[ "$(flags)" = '0 1 00' ]
result $? "gives the terminal back"
keys fg Enter
want '\[74\.0\]' "and fg comes back"
keys Right
want '\[74\.1\]'
keys : 'show params | sort' Enter
want 'Return: back' "a shell command has the terminal to itself"
mux resize-window -t one -x 90 -y 24
sleep 0.3
shot
grep -q 'Return: back' screen
result $? "and keeps it when the terminal changes its size"
mux resize-window -t one -x 80 -y 24
keys C-z
want '^shell: *$' "^Z there stops the program"
keys fg Enter
sleep 0.3
keys Enter
want '^ 65 ╌' "and Return: back after it"
keys : 'show params | { echo begun; exec sleep 100; }' Enter
want '^begun'
keys C-z
want '^shell: *$' "^Z stops a shell command and the program with it"
keys fg Enter
sleep 0.3
keys C-c
want 'Return: back' "fg goes on with both"
keys Enter
want '^ 65 ╌'
keys q
want 'shell:$'

start 80 24 TERM=xterm-256color
want '\[74\.0\]'
# gesture PATTERN NAME EVENT..: a press, motions and a release.  On a busy machine
# one may come torn in two, which is no mouse any more: tried three times.
gesture() {
	pattern=$1 name=$2 again=0
	shift 2
	while [ $((again += 1)) -le 3 ]; do
		for event; do
			# shellcheck disable=SC2086
			press $event
		done
		tries=0
		until shot; grep -q -e "$pattern" screen || [ $tries -ge 20 ]; do
			sleep 0.1
			tries=$((tries + 1))
		done
		[ $tries -lt 20 ] && break
	done
	want "$pattern" "$name"
}
press() { keys -l "$(printf '\033[<%s' "$1")"; }
gesture '\[65\.0\]' "a click sets the speed" '0;5;21M' '0;5;21m'
gesture '\[85\.0\]' "dragging moves it" \
	'0;5;21M' '32;40;21M' '32;76;21M' '0;76;21m'
gesture '\[84\.9\]' "and the wheel" '65;40;10M'
keys z
want 'this key has no function'
gesture '^READY' "a message goes at the next click" '0;30;6M' '0;30;6m'
keys c
# The column of a word in the heading.
heading() { awk -v word="$1" 'NR == 1 { print index($0, word) }' screen; }
sites=$(heading '5 Sites')
gesture 'site  *rock.*parameters' "a click opens a page" "0;$sites;1M" "0;$sites;1m"
keys 1 7
want 'speed: 7_'
gesture 'site  *rock.*parameters' "also while a speed is typed" \
	"0;$sites;1M" "0;$sites;1m"
keys '?' / by
press '65;40;10M'
want '^/by  9 keys ' "the wheel types nothing into the word to find"
keys Escape
want '^  Left Right '
keys q q
want 'IT IS OVER'

# The same by the coding that terminals like tmux and screen have: motion comes
# without a button.
start 80 24 TERM=tmux-256color
want '\[74\.0\]'
keys -H 1b 5b 43
want '\[74\.1\]' "an arrow as sent where cursor keys are not in their own mode"
# shellcheck disable=SC2046
press() { keys -H 1b 5b 4d $(printf '%x ' $((32 + $1)) $((32 + $2)) $((32 + $3))); }
gesture '\[65\.0\]' "a click coded as X10 has it" '0 5 21' '3 5 21'
gesture '\[85\.0\]' "and a drag" '0 5 21' '32 40 21' '32 76 21' '3 76 21'
keys q
want 'IT IS OVER'

start 80 24 START='echo hello'
want 'f calibrates' "without parameters it says what to do"
keys q
want 'IT IS OVER'
echo tui >open.tip
start 80 24 'START=source open.tip'
want 'f calibrates'
keys : 'bounds alpha 0.4' Enter
want ': bounds alpha 0\.4'
grep -q '^bounds alpha 0.4$' .local/state/tipspeed/session*.tip
result $? "what is typed there is kept also where a script opened it"
keys q
sleep 0.5
keys q
want 'IT IS OVER'
rm -f .local/state/tipspeed/session*
start 80 24 XDG_STATE_HOME=/dev/null
want '\[74\.0\]'
! grep -q history screen
result $? "a remark on the history does not stand on the screen"
keys q
want 'the history cannot be saved' "but before it"
# What it makes of a terminal, and that the shell goes on in a row of its own.
# kind WORDS VARIABLE=VALUE..: WORDS are those at the right of its status line.
kind() {
	words=$1
	shift
	start 80 24 "$@"
	want '\[74\.0\]'
	mux pipe-pane -t one 'cat >bytes'
	keys C-l Right
	want '\[74\.1\]'
	want "$words\$"
	right=$?
	keys q
	want '^IT IS OVER'
	mux pipe-pane -t one
	[ $right -eq 0 ] && [ "$(flags)" = '0 1 00' ]
	result $? "$*: $words"
}
high=$(printf '[\200-\377]')
colour=$(printf '\033\\[[0-9;]*3[0-9][0-9;]*m')
kind 'mouse off  ascii  0 colours' TERM=vt100
! LC_ALL=C grep -q "?100[026]h\|$colour" bytes
result $? "without a word of mouse and colour"
kind 'mouse off  ascii  8 colours' TERM=ansi
kind 'mouse off  ascii  8 colours' TERM=linux
kind 'mouse on  utf8  8 colours' TERM=xterm
kind 'mouse on  utf8  8 colours' TERM=screen
kind 'mouse on  utf8  256 colours' TERM=screen-256color
kind 'mouse on  utf8  256 colours' TERM=xterm-256color
LC_ALL=C grep -q "$colour" bytes
result $? "with colours"
kind 'mouse on  utf8  0 colours' TERM=xterm-256color NO_COLOR=1
! LC_ALL=C grep -q "$colour" bytes
result $? "without one"
kind 'mouse on  ascii  256 colours' TERM=xterm-256color LC_ALL=C
! LC_ALL=C grep -q "$high" bytes
result $? "and not a byte beyond ASCII"
start 80 24 TERM=xterm LC_ALL=C \
	'START=load data/sites/ossjo.csv; params set f_mat=1 e0_min=9 alpha=1'
want '^Ossjo' "a name there is without its accents"
keys q
start 80 24 TERM=vt100 sh -c \
	'"$TIPSPEED" data/sites/tierp.csv -c "plot psd"; exec sleep 1000'
want '^100+' "plot has the same characters there as the full screen"
start 80 24 TERM=linux PS1='shell: ' HISTFILE= sh -i
want 'shell:$'
keys '"$TIPSPEED" data/sites/tierp.csv -c tui' Enter
want '\[74\.0\]'
keys C-z
want Stopped '^Z is ^Z also where it has a key of its own'
start 80 24 TERM=vt100
want '\[74\.0\]'
keys M
want 'this terminal has no mouse' "M says so where there is none"
keys PageUp
want '\[79\.0\]' "keys that its description does not have"
keys -l "$(printf '\033[99;5:3X\033Oy')"
keys Right
want '\[79\.1\]' "a sequence that nobody knows is no keys"
for term in dumb no-such-terminal ''; do
	start 80 24 "TERM=$term"
	want 'cannot show full-screen mode' "TERM=$term cannot, and is told so"
done

# What is read for long is said, and both keys stop it.
wide_sheet >wide.csv
for key in Escape C-c; do
	start 80 24
	want '\[74\.0\]'
	keys -l ':load wide.csv wide.csv wide.csv wide.csv wide.csv wide.csv'
	keys Enter
	want 'WORKING  load wide.csv' "a load that takes long says so"
	keys $key
	want 'stopped: load wide.csv' "and $key stops it"
done

"$TIPSPEED" -c tui >out 2>log </dev/null
[ $? -eq 2 ] && grep -q 'expected a terminal' log
result $? "without a terminal tui is an error"
"$TIPSPEED" --reset-tty >out
grep -q '?1002l.*?25h.*?1049l' out
result $? "--reset-tty writes what mends a terminal"
start 80 24 sh -c "\"\$TIPSPEED\" data/sites/tierp.csv --linear -c tui"
want 'tierp>$' "--linear opens the prompt"
keys 'plot psd' Enter
want 'feed: from 0.453 % at 0.063 mm'
! grep -q '┬\|--+--' screen
result $? "and plot tells its picture there"
finish
