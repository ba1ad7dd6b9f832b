#!/bin/sh
# Runs the examples of manual pages and compares what they print.
#
#   check.sh TIPSPEED_BINARY SRCDIR PAGE...
#
# An example is a display, from ".Bd -literal" to ".Ed".
#   "$ COMMAND"         is given to sh; the lines up to the next "$ " or the end
#                       of the display are its exact standard output.
#   "tipspeed> COMMAND" lines of a display are one script, which must exit 0.
#   .\" site-example    on the line before .Bd: the display is a site file,
#                       which must load without a fault.
#   .\" file NAME       on the line before .Bd: the display is that file.
#   .\" session         on the line before .Bd: all displays so marked are one
#                       session at a prompt with what it shows, see session.exp.
#                       RENEW=1 (make renew) writes what is shown now into PAGE.
#   .\" needs TOOL      on the line before .Bd: left out where there is no TOOL.
# Displays between ".ig" and ".." are not printed: they hold by assert what the
# prose above them says.
# Commands run in a folder of the page's own that holds a link to SRCDIR/data,
# with the binary on PATH as tipspeed; what they write to standard error is not
# looked at.  Output is TAP, the plan last.  Exit status 0: all examples did
# what they show; 1: some did not; 2: usage.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u

die() {
	printf 'check.sh: %s\n' "$1" >&2
	exit 2
}

[ $# -ge 3 ] || die 'usage: check.sh TIPSPEED_BINARY SRCDIR PAGE...'
[ -x "$1" ] || die "$1 is not a program"
[ -d "$2/data" ] || die "$2 has no folder data"
binary=$(CDPATH='' cd -- "$(dirname -- "$1")" && pwd)/$(basename -- "$1")
source=$(CDPATH='' cd -- "$2" && pwd)
shift 2

top=$(mktemp -d "${TMPDIR:-/tmp}/tipspeed-man.XXXXXX") || exit 2
trap 'rm -rf "$top"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
mkdir "$top/bin" && ln -s "$binary" "$top/bin/tipspeed" || exit 2
PATH=$top/bin:$PATH
HOME=$top/home XDG_STATE_HOME=$top/home XDG_CONFIG_HOME=$top/home
export PATH HOME XDG_STATE_HOME XDG_CONFIG_HOME
unset TIPSPEED_COLOR
# The day of tests/tap.sh, by whichever of the two this is run.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-1795564800}
export SOURCE_DATE_EPOCH
tests=0
failed=0

# Takes a page apart: for example N the files N.kind (shell, script, site, file,
# bad), N.text (what to run or load), N.want (its output), N.needs (a tool) and
# N.name (a file's); all sessions together in the file session.
extract() {
	awk -v folder="$2" '
	BEGIN {
		letter["\\(oa"] = "å"
		letter["\\(:a"] = "ä"
		letter["\\(:o"] = "ö"
	}
	function start(kind) {
		n++
		base = folder "/" sprintf("%04d", n)
		print kind > (base ".kind")
		close(base ".kind")
		printf "" > (base ".text")
		printf "" > (base ".want")
		if (needs != "")
			print needs > (base ".needs")
		close(base ".needs")
	}
	function finish() {
		if (base != "") {
			close(base ".text")
			close(base ".want")
		}
		base = ""
	}
	function bad(why) {
		finish()
		start("bad")
		print FILENAME ":" FNR ": " why > (base ".text")
		finish()
		was = "bad"
	}
	# What roff prints for a line of a display.
	function plain(line,   out, at, two, four) {
		out = ""
		while ((at = index(line, "\\")) > 0) {
			out = out substr(line, 1, at - 1)
			two = substr(line, at, 2)
			four = substr(line, at, 4)
			if (four in letter) {
				out = out letter[four]
				line = substr(line, at + 4)
				continue
			}
			if (two == "\\e")
				out = out "\\"
			else if (two == "\\-")
				out = out "-"
			else if (two == "\\ ")
				out = out " "
			else if (two != "\\&")
				bad("this escape is not known here: " two)
			line = substr(line, at + 2)
		}
		return out line
	}
	/^\.Bd .*-literal/ {
		if (inside)
			bad("a display within a display")
		inside = 1
		was = ""
		if (site || name != "") {
			was = site ? "site" : "file"
			start(was)
			if (name != "")
				print name > (base ".name")
			close(base ".name")
		} else if (session)
			was = "session"
		next
	}
	/^\.Ed/ {
		finish()
		inside = site = session = 0
		needs = name = ""
		next
	}
	!inside {
		site = $0 ~ /^\.\\" *site-example *$/
		session = $0 ~ /^\.\\" *session *$/
		needs = $0 ~ /^\.\\" *needs / ? $3 : ""
		name = $0 ~ /^\.\\" *file / ? $3 : ""
		next
	}
	/^\.\\"/ { next }
	{ line = plain($0) }
	was == "bad" { next }
	was == "session" { print line > (folder "/session"); next }
	was == "site" || was == "file" { print line > (base ".text"); next }
	substr(line, 1, 2) == "$ " {
		if (was == "script") {
			bad("a shell command among lines for tipspeed")
			next
		}
		finish()
		start("shell")
		was = "shell"
		print substr(line, 3) > (base ".text")
		next
	}
	substr(line, 1, 10) == "tipspeed> " {
		if (was == "shell" || was == "text") {
			bad("a line for tipspeed among others")
			next
		}
		if (was == "")
			start("script")
		was = "script"
		print substr(line, 11) > (base ".text")
		next
	}
	was == "shell" { print line > (base ".want"); next }
	was == "script" { bad("every line begins with tipspeed> or none"); next }
	{ was = "text" }
	END {
		if (inside)
			bad("the last display is not closed")
	}' "$1"
}

# tell 0|1 NAME [FILE with what to say]
tell() {
	tests=$((tests + 1))
	name=$(printf '%s' "$2" | sed 's/#/\\#/g')
	if [ "$1" -eq 0 ]; then
		printf 'ok - %s\n' "$name"
		return
	fi
	failed=$((failed + 1))
	printf 'not ok - %s\n' "$name"
	[ $# -lt 3 ] || sed 's/^/# /' "$3"
}

skip() {
	tests=$((tests + 1))
	printf 'ok - %s # SKIP no %s here\n' \
	    "$(printf '%s' "$1" | sed 's/#/\\#/g')" "$2"
}

# run_example PAGE BASE: the example in BASE.*, in the page's folder.
run_example() {
	page=$1
	base=$2
	kind=$(cat "$base.kind")
	text=$(cat "$base.text")
	if [ -f "$base.needs" ]; then
		tool=$(cat "$base.needs")
		if ! command -v "$tool" >/dev/null 2>&1; then
			skip "$page: $text" "$tool"
			return
		fi
	fi
	case $kind in
	shell)
		(cd "$work" && sh -c "$text" </dev/null) \
		    >"$base.got" 2>/dev/null
		diff -u "$base.want" "$base.got" >"$base.diff" 2>&1
		tell $? "$page: $text" "$base.diff"
		;;
	script)
		(cd "$work" && tipspeed -f "$base.text" </dev/null) \
		    >"$base.got" 2>&1
		status=$?
		printf 'exit status %s\n' "$status" >>"$base.got"
		tell "$((status != 0))" \
		    "$page: $(printf '%s' "$text" | tr '\n' ';' |
			sed 's/;/; /g')" "$base.got"
		;;
	site)
		cp "$base.text" "$work/example.csv"
		(cd "$work" && tipspeed example.csv -c check </dev/null) \
		    >"$base.got" 2>&1
		status=$?
		printf 'exit status %s\n' "$status" >>"$base.got"
		tell "$((status != 0))" "$page: the site file" "$base.got"
		;;
	file)
		cp "$base.text" "$work/$(cat "$base.name")"
		;;
	*)
		tell 1 "$page: a display" "$base.text"
		;;
	esac
}

# What differs from run to run, as the page has it.
steady() {
	sed -e 's/done in [0-9.]* s/done in 0.1 s/' \
	    -e 's/threads [0-9][0-9]*/threads 2/' \
	    -e "s|$XDG_DATA_HOME|/home/you/.local/share|"
}

# Puts what a session shows, in FILE, into the displays of PAGE.
renew() {
	awk -v sign='^([$]|([a-z][^ >]*( [(][a-z]+[)])?)?>) ' '
	FNR == NR {
		n += $0 ~ sign
		gsub(/\\/, "\\e")
		sub(/^[.\047]/, "\\\\\\&&")
		block[n] = block[n] $0 "\n"
		next
	}
	/^\.Ed/ { inside = 0 }
	inside && $0 ~ sign { printf "%s", block[++command] }
	!inside
	/^\.Bd/ && was { inside = 1 }
	{ was = $0 ~ /^\.\\" *session *$/ }' "$1" "$2" >"$top/page" &&
	cat "$top/page" >"$2"
}

# run_session PAGE PATH: its session, in the page's folder.
run_session() {
	[ -f "$cases/session" ] || return 0
	if ! command -v expect >/dev/null 2>&1; then
		skip "$1: the session" expect
		return
	fi
	(cd "$work" && expect "$source/man/session.exp" "$cases/session") \
	    2>&1 | steady >"$cases/got"
	diff -u "$cases/session" "$cases/got" >"$cases/diff"
	same=$?
	[ -z "${RENEW-}" ] || { renew "$cases/got" "$2" && same=0; }
	tell $same "$1: the session, else make renew" "$cases/diff"
}

number=0
for path in "$@"; do
	number=$((number + 1))
	page=$(basename -- "$path")
	work=$top/work-$number
	cases=$top/cases-$number
	mkdir "$work" "$cases" && ln -s "$source/data" "$work/data" || exit 2
	XDG_DATA_HOME=$top/share-$number
	export XDG_DATA_HOME
	if ! extract "$path" "$cases" 2>"$cases/extract"; then
		tell 1 "$page: read" "$cases/extract"
		continue
	fi
	for kind_file in "$cases"/*.kind; do
		[ -f "$kind_file" ] || continue
		run_example "$page" "${kind_file%.kind}"
	done
	run_session "$page" "$path"
done
printf '1..%d\n' "$tests"
[ "$failed" -eq 0 ]
