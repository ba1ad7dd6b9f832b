#!/bin/sh
# The full screen in tmux: keys, sizes, a calibration, and every way out.
# With RENEW=1 it writes the golden screens anew: look at the difference.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
if ! command -v tmux >/dev/null; then
	echo '1..0 # SKIP no tmux here'
	exit 0
fi
scratch
golden=$(cd "$srcdir/tests" && pwd)/screens
cd "$dir" || exit 99
HOME=$dir
TMUX_TMPDIR=$dir
LC_ALL=C.UTF-8
export HOME TMUX_TMPDIR LC_ALL TIPSPEED
unset NO_COLOR TIPSPEED_COLOR TMUX XDG_STATE_HOME XDG_CONFIG_HOME
mux() { tmux -L tipspeed "$@"; }
trap 'mux kill-server 2>/dev/null; rm -rf "$dir"' EXIT

# What runs in the terminal: settings before and after, and the status.
cat >inside <<'EOF'
stty -a >before
"$TIPSPEED" data/sites/tierp.csv -c "${START:-calibrate}" -c tui
echo $? >status
stty -a >after
echo 'IT IS OVER'
exec sleep 1000
EOF

# A session of no use keeps the server alive between the others.
mux -f /dev/null new-session -d -s idle 'exec sleep 1000'

# start COLUMNS ROWS [VARIABLE=VALUE]...: a terminal of that size with the program.
start() {
	size="-x $1 -y $2"
	shift 2
	rm -f status after
	mux kill-session -t one 2>/dev/null
	# shellcheck disable=SC2086
	case $* in
	*'sh -'*) mux new-session -d -s one $size env "$@" ;;
	*) mux new-session -d -s one $size env "$@" sh ./inside ;;
	esac
}
keys() { mux send-keys -t one "$@"; }
shot() { mux capture-pane -t one -p >screen 2>&1; }
# want PATTERN [NAME]: waits until the screen has it, ten seconds at most.
want() {
	tries=0
	until shot; grep -q -e "$1" screen || [ $tries -ge 100 ]; do
		sleep 0.1
		tries=$((tries + 1))
	done
	[ $tries -lt 100 ]
	good=$?
	[ -z "${2:-}" ] && [ $good -eq 0 ] && return
	[ $good -eq 0 ] || remark screen
	result $good "${2:-the screen has $1}"
}
# same NAME: the screen is the golden one.
same() {
	[ -z "${RENEW:-}" ] || cp screen "$golden/$1"
	diff "$golden/$1" screen >difference
	good=$?
	remark difference
	result $good "the screen $1 (RENEW=1 writes it anew)"
}
p50() { sed -n 's/.*P50 \([0-9.]*\).*/\1/p' screen | head -n 1; }

start 80 24
want '\[74\.0\]' "it opens at the speed held out"
same 80x24
before=$(p50)
keys Right
want '\[74\.1\]' "an arrow moves the speed by 0.1"
keys Right Right Right Right
want '\[74\.5\]'
[ "$(p50)" != "$before" ]
result $? "and P50 follows"
want ': predict speed=74\.5' "the command it composed is shown"
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
		[ $tries -ge 30 ]; do
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
want '^\[*tipspeed\|Tierp, Granite'

keys c b
want 'crosshair 5\.6 mm  *50 %' "the crosshair reads the curves"
want 'band  *8[0-9.]* \.\. 8[0-9.]* %' "and the band at its sieve"
keys Left Up
want 'crosshair 4 mm  *55 %' "arrows move the sieve and the level"
want 'band  *6[0-9.]* \.\. 6[0-9.]* %'
keys Down b c x
want 'kept: tierp 74\.0' "a prediction is kept beside"
keys 7 8 Enter
want 'P50 2.81 mm  now -' "with what is now less than it"
want '%.*kept' "and a curve of its own"
want 'P50 2.* mm  *-0' "changes since the last pause"
want '78\.0 m/s  *since 7' "and since when"
keys e
want '^:plot psd speed=78.0 beside=tierp other=74.0 >' "e exports both"
keys Escape 7 4 Enter x
want '\[74\.0\]'
keys : 'set k 1.'
keys Enter
want ': set k 1\.' "a typed command"
keys : 'sh' Tab 'prod' Tab Enter
want 'product at each speed\|product' "completion, and what it prints"
keys q
keys : 'predict 99999' Enter
want '^! ' "an error is told"
keys '?'
want 'speed down by 0.1' "the list of keys"
keys / 'by 5'
want 'speed up by 5'
keys Down Enter
want '\[79\.0\]' "finds a word, and Enter does what it says"
keys 7 4 Enter : Up
want '^:predict 99999' "the history"
keys Escape

keys 2
want 'generation 1 ---' "the page Fit"
keys - - f
want 'CALIBRATING' "it can be watched"
keys Right
want '\[74\.1\]' "the speed moves while it runs"
keys Space
want 'PAUSED' "pause"
keys Space + + + + + + + +
want 'calibrated: good' "a calibration to its end"
keys Tab Home
keys Left Left Left
want 'generation 1 .*\]-' "the generations are gone through"
keys s 3
want 'sieve mm' "the page Data"
keys 5
want '\* tierp  *Granite  *11.2 69 o74 79 good  *0\.3.  *0\.4.  *3\.5.x' \
	"the page Sites says how far each is calibrated"
keys 1 u
want ': undo' "undo"
keys U
want ': redo'
keys w 'kept.tip' Enter
want ': save kept.tip'
tries=0
until [ -s kept.tip ] || [ $tries -ge 30 ]; do sleep 0.1; tries=$((tries + 1)); done
"$TIPSPEED" -f kept.tip >replay 2>log
result $? "the session is written as a script that runs"
keys q
want 'IT IS OVER' "q leaves"
[ "$(cat status)" = 0 ] && cmp -s before after && ! grep -q 'rotor tip' screen
result $? "and the terminal is as it was"

# tmux tells in these whether the screen is the other one, the cursor shown and
# the mouse asked for.
flags='#{alternate_on} #{cursor_flag} #{mouse_any_flag}#{mouse_button_flag}'
for signal in SEGV ABRT TERM HUP INT BUS FPE ILL; do
	start 80 24
	want '\[74\.0\]'
	during=$(mux display-message -t one -p "$flags")
	kill -s $signal "$(pgrep -n -f "^$TIPSPEED data/sites/tierp.csv" || echo 0)"
	want 'IT IS OVER'
	tries=0
	until [ -s after ] || [ $tries -ge 50 ]; do sleep 0.1; tries=$((tries + 1)); done
	[ "$during" = '1 1 11' ] && cmp -s before after &&
		[ "$(mux display-message -t one -p "$flags")" = '0 1 00' ]
	result $? "SIG$signal leaves the terminal as it was ($(cat status))"
done

# A shell of its own, for job control.
start 80 24 PS1='shell: ' HISTFILE= sh -i
keys "'$TIPSPEED' data/sites/tierp.csv -c calibrate -c tui" Enter
want '\[74\.0\]'
keys C-z
want 'Stopped\|Suspended' "^Z"
[ "$(mux display-message -t one -p "$flags")" = '0 1 00' ]
result $? "gives the terminal back"
keys fg Enter
want '\[74\.0\]' "and fg comes back"
keys Right
want '\[74\.1\]'
keys : 'show params | sort' Enter
want 'Return goes back' "a shell command has the terminal to itself"
keys Enter
want '^65\|^ 65 x'
keys q
want 'shell:$'

start 80 24 TERM=xterm-256color
want '\[74\.0\]'
press() { keys -l "$(printf '\033[<%s' "$1")"; }
press '0;5;21M'
press '0;5;21m'
want '\[65\.0\]' "a click sets the speed"
press '0;5;21M'
press '32;40;21M'
press '32;76;21M'
press '0;76;21m'
want '\[85\.0\]' "dragging moves it"
press '65;40;10M'
want '\[84\.9\]' "and the wheel"
press '0;65;1M'
press '0;65;1m'
want 'site  *rock.*parameters' "a click opens a page"
keys q
want 'IT IS OVER'

start 80 24 START='echo hello'
want 'f calibrates' "without parameters it says what to do"
keys q
want 'IT IS OVER'
for vars in 'TERM=vt100' 'TERM=linux' 'TERM=xterm' 'NO_COLOR=1' 'LC_ALL=C'; do
	start 80 24 "$vars"
	want '\[74\.0\]' "$vars"
	keys q
	want 'IT IS OVER'
done
start 80 24 TERM=dumb
want 'cannot show a full screen' "a terminal that cannot is told so"

"$TIPSPEED" -c tui >out 2>log </dev/null
[ $? -eq 2 ] && grep -q 'wants a terminal' log
result $? "without a terminal tui is an error"
"$TIPSPEED" --reset-tty >out
grep -q '?1002l.*?25h.*?1049l' out
result $? "--reset-tty writes what mends a terminal"
start 80 24 sh -c "\"\$TIPSPEED\" data/sites/tierp.csv --linear -c tui"
want 'tierp>$' "--linear opens the prompt"
finish
