#!/bin/sh
# Every way out, from every state, leaves the terminal as it was: its settings, the
# screen it shows, the cursor and the mouse; the status is the one to expect, and what
# was changed is kept.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
# A sanitizer would take the faults, and all the memory there is.
ASAN_OPTIONS=$ASAN_OPTIONS:handle_segv=0:handle_sigbus=0:handle_sigfpe=0
export ASAN_OPTIONS
. "${srcdir:-.}/tests/mux.sh"
limits=$(command -v prlimit)
! grep -q __asan_init "$TIPSPEED" || limits=

quick='START=params set f_mat=2 e0_min=16 alpha=1'
change='bounds alpha 0.4'

# number SIGNAL: by the shell, as a kill that is a program is not everywhere.
number() {
	s=1
	until [ "$(kill -l $s)" = "$1" ]; do s=$((s + 1)); done
	echo $s
}

# enter STATE: the program is in it.
enter() {
	case $1 in
	prompt*) start 80 24 AT_PROMPT=1 ;;
	*) start 80 24 "$quick" ;;
	esac
	rm -f .local/state/tipspeed/session*
	case $1 in
	prompt*)
		want 'tierp>$'
		keys "$change" Enter
		want 'alpha.* 0\.4'
		;;
	*)
		want '\[74\.0\]'
		keys : "$change" Enter
		want ": $change"
		;;
	esac
	case $1 in
	calibrating)
		keys - - f y
		want 'generation [2-9] of 800'
		;;
	list)
		keys '?'
		want '^  Left Right '
		;;
	files)
		keys o
		want 'open a sheet, in'
		;;
	typing)
		keys : 'predict 7'
		want '^:predict 7'
		;;
	prompt)
		# Before the prompt the terminal echoes, and takes ^U and ^D itself.
		want '^tierp> *$'
		keys 'predict 7'
		want '^tierp> predict 7$'
		;;
	'prompt calibrating')
		keys 'calibrate generations=1000000 tolerance=0 stall=0' Enter
		want '^  calibrating: generation [1-9]'
		;;
	esac
}

# over STATE WAY STATUS: it has ended so, and nothing of it is left.
over() {
	want 'IT IS OVER'
	waits after
	[ "$(cat status)" = "$3" ] && cmp -s before after && [ "$(flags)" = '0 1 00' ] &&
		[ "$(marked)" = '?2004l' ] && grep -q "^$change\$" .local/state/tipspeed/session*.tip
	good=$?
	[ $good -eq 0 ] || {
		echo "# status $(cat status), screen $(flags), $(marked)"
		cat .local/state/tipspeed/session*.tip | sed 's/^/# /'
		diff before after | sed 's/^/# /'
	}
	result $good "$1: $2"
}

# Each third pair of a state and a signal, so that each of them is in three or so;
# all pairs in the long tests.
third=$(often 0 1) pair=0
for state in idle calibrating list files typing prompt 'prompt calibrating'; do
	for signal in SEGV BUS FPE ILL ABRT TERM HUP INT QUIT XCPU KILL; do
		pair=$((pair + 1))
		[ $((pair % 3)) -eq 0 ] || [ "$third" -eq 1 ] || continue
		# ^C is for the line and for the calibration there.
		case $state$signal in prompt*INT) continue ;; esac
		enter "$state"
		kill -s $signal "$(cat pid)"
		over "$state" "SIG$signal" $((128 + $(number $signal)))
	done
done

enter idle
keys q
over idle q 0
enter calibrating
keys q
over calibrating q 0
enter list
keys q q
over list 'q, q' 0
enter typing
keys C-u quit Enter
over typing quit 0
enter prompt
keys C-u C-d
over prompt '^D' 0

# A storm of sizes over a search at full speed, and the last one holds.
enter idle
keys : 'calibrate generations=1000000 tolerance=0 stall=0' Enter + + + + + + +
want 'pace: as many generations as possible'
awk 'BEGIN { srand(7); for (i = 0; i < 50; i++)
	print 1 + int(300 * rand() ^ 2), 1 + int(100 * rand() ^ 2) }' >sizes
while read -r columns rows; do
	mux resize-window -t one -x "$columns" -y "$rows"
done <sizes
mux resize-window -t one -x 1 -y 1
mux resize-window -t one -x 80 -y 24
want '74\.0 m/s  2738 J/kg .* held out' "50 sizes in a search"
keys q
over calibrating '50 sizes, then q' 0

# A shell with job control stops it in the midst, by key and by signal.
start 80 24 PS1='shell: ' HISTFILE= sh -i
want 'shell:$'
keys 'stty brkint; stty -a >before' Enter
keys "sh -c 'echo \$\$ >pid; exec \"\$TIPSPEED\" data/sites/tierp.csv -c tui'" Enter
want 'calibrates'
keys - - f
want 'generation [2-9] of 800'
for how in '^Z' SIGTSTP; do
	if [ $how = ^Z ]; then keys C-z; else kill -s TSTP "$(cat pid)"; fi
	want 'Stopped'
	keys 'stty -a >after' Enter
	waits after
	cmp -s before after && [ "$(flags)" = '0 1 00' ] && [ "$(marked)" = '?2004l' ]
	result $? "calibrating: $how gives the terminal back"
	rm after
	keys clear Enter fg Enter
	want 'generation [1-9][0-9]* of 800'
	[ "$(flags)" = '1 1 11' ] && [ "$(marked)" = '?2004h' ]
	result $? "and fg goes on with the search"
done
keys q
want 'shell:$'
keys 'echo status $?; stty -a >after' Enter
want 'status 0'
waits after
cmp -s before after
result $? "and then q leaves it as it was"

# From here on it gets no more memory, and is made to ask for some.
if [ -n "$limits" ]; then
	for state in idle calibrating list typing; do
		enter $state
		prlimit --as=1 --pid "$(cat pid)"
		mux resize-window -t one -x 300 -y 100
		over $state 'out of memory' 5
	done
	enter prompt
	prlimit --as=1 --pid "$(cat pid)"
	keys C-u 'calibrate population=1000000' Enter
	over prompt 'out of memory' 5
fi
finish
