# Helpers of the tests that look at a terminal: the program within tmux, with a
# server and a home of its own. Sourced after tap.sh, not run.
# shellcheck shell=sh disable=SC2154
# SPDX-License-Identifier: GPL-3.0-or-later
if ! command -v tmux >/dev/null; then
	echo '1..0 # SKIP no tmux here'
	exit 0
fi
scratch
cd "$dir" || exit 99
HOME=$dir
TMUX_TMPDIR=$dir
LC_ALL=C.UTF-8
export HOME TMUX_TMPDIR LC_ALL TIPSPEED
unset NO_COLOR TIPSPEED_COLOR TMUX XDG_STATE_HOME XDG_CONFIG_HOME
mux() { tmux -L tipspeed "$@"; }
# A program that is no longer wanted.  Hung up together with its terminal a leak
# sanitizer would go round for ever: its own stop is undone by the hang-up.
drop() {
	[ -s pid ] && [ ! -e status ] || return 0
	case $(readlink "/proc/$(cat pid)/exe") in
	*tipspeed) kill -KILL "$(cat pid)" 2>/dev/null ;;
	esac
}
trap 'drop; mux kill-server 2>/dev/null; rm -rf "$dir"' EXIT

# What runs in the terminal: settings before and after, and the status.
cat >inside <<'EOF'
settings() { stty -a | sed 's/ rows [0-9]*; columns [0-9]*;//'; }
stty brkint
settings >before
sh -c 'echo $$ >pid
	set -- -c "${START:-calibrate}" -c tui
	[ -z "$AT_PROMPT" ] || shift 4
	exec "$TIPSPEED" data/sites/tierp.csv "$@"'
echo $? >status
[ "$(cat status)" -ne 137 ] || "$TIPSPEED" --reset-tty
settings >after
echo 'IT IS OVER'
exec sleep 1000
EOF

# A session of no use keeps the server alive between the others.
mux -f /dev/null new-session -d -s idle 'exec sleep 1000'

# start COLUMNS ROWS [VARIABLE=VALUE]...: a terminal of that size with the program.
start() {
	size="-x $1 -y $2"
	shift 2
	drop
	rm -f status after pid
	mux kill-session -t one 2>/dev/null
	# shellcheck disable=SC2086
	case $* in
	*'sh -'*) mux new-session -d -s one $size env "$@" ;;
	*) mux new-session -d -s one $size env "$@" sh ./inside ;;
	esac
	mux pipe-pane -t one 'cat >bytes'
}
# marked: whether pasted text is marked, "?2004h", by what was written last.
marked() { LC_ALL=C grep -ao '?2004[hl]' bytes | tail -n 1; }
# paste TEXT: as a terminal pastes it, in marks where these were asked for.
paste() {
	mux set-buffer -b clip -- "$1"
	mux paste-buffer -p -b clip -t one
}
keys() { mux send-keys -t one "$@"; }
shot() { mux capture-pane -t one -p >screen 2>&1; }
# want PATTERN [NAME]: waits until the screen has it, thirty seconds at most.
want() {
	tries=0
	until shot; grep -q -e "$1" screen || [ $tries -ge 1000 ]; do
		sleep 0.03
		tries=$((tries + 1))
	done
	[ $tries -lt 1000 ]
	good=$?
	[ -z "${2:-}" ] && [ $good -eq 0 ] && return
	[ $good -eq 0 ] || remark screen
	result $good "${2:-the screen has $1}"
}
# waits FILE: until it has something in it, thirty seconds at most.
waits() {
	tries=0
	until [ -s "$1" ] || [ $tries -ge 1000 ]; do
		sleep 0.03
		tries=$((tries + 1))
	done
}

# tmux tells in these whether the screen is the other one, the cursor shown and
# the mouse asked for: "1 1 11" within the program, "0 1 00" outside.
flags() {
	mux display-message -t one -p \
		'#{alternate_on} #{cursor_flag} #{mouse_any_flag}#{mouse_button_flag}'
}
