#!/bin/sh
# Table, help, manual and shell completion say the same words, and nothing else:
# commands, options, exit statuses, variables, pages of the manual.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
page=$PWD/man/tipspeed.1
bash=$PWD/completions/tipspeed
srcdir=$(cd "$srcdir" && pwd)
cd "$dir" || exit 99
"$TIPSPEED" --help >help
"$TIPSPEED" -c 'help all' >commands

# same NAME A B: the two files hold the same words, in any order.
same() {
	tr -s ' \t' '\n\n' <"$2" | grep . | sort >a
	tr -s ' \t' '\n\n' <"$3" | grep . | sort >b
	[ -s a ] && diff a b >diff
	result $? "$1"
	remark diff
}

# section NAME: that section of the manual.
section() {
	awk -v name="$1" '/^\.Sh / { here = $0 == ".Sh " name } here' "$page"
}

# block NAME: the lines set in by two blanks below a heading of the help.
block() { awk -v n="$1" '$0 == n { h = 1; next } /^[^ ]|^$/ { h = 0 } h' help; }

# Commands and their other names; one of two words is written show_sites here.
names() { sed -n 's/^  \([a-z, ]*[a-z]\)  .*/\1/p' "$1" | sed 's/, /,/; s/ /_/' |
	tr ',' '\n'; }
names commands >titles
two=$(grep _ titles | sed 's/\(.*\)_\(.*\)/s,^\\.It "\1 \2\\b,.It "\1_\2,/' | tr '\n' ';')
section() {
	awk -v name="$1" '/^\.Sh / { here = $0 == ".Sh " name } here' "$page" |
		sed "$two"
}
while read -r name; do
	"$TIPSPEED" -c "help $(echo "$name" | tr _ ' ')" |
		sed -n 's/^  also called //p' | tr ' ' _
done <titles >others
sort -u titles others >all
{
	section COMMANDS | sed -n 's/^\.It "\([a-z_]*\).*/\1/p'
	section COMMANDS | grep -A 1 '^Also called' |
		sed -n 's/^\.Cm \([a-z]*\) \.$/\1/p'
} >in_manual
same "commands: help and manual" all in_manual
sed 's/_.*//' titles others | sort -u >all
awk "/^\\t-c\\)/ { h = 1; next } h && /;;/ { exit }
	h { gsub(/words=|'/, \"\"); print }" "$bash" | tr -s ' \t' '\n\n' |
	grep . | sort -u >in_bash
same "commands: help and completion" all in_bash
names help >in_help
same "commands: help and --help" titles in_help

# Options of each command.
while read -r name; do
	"$TIPSPEED" -c "help $(echo "$name" | tr _ ' ')" >one
	full=$(sed -n '1s/ - .*//p' one | tr ' ' _)
	awk -v c="$full" '/^options$/ { h = 1; next } /^$/ { h = 0 }
		h && /^  [a-z]/ { print c "." $1 }' one
	tr '\n' ' ' <one | sed -n 's/.*  also takes \(.*\):  *help options.*/\1/p' |
		tr -d ',' | tr -s ' ' '\n' | sed "s/^/shared $full./"
	echo
done <titles | grep . | sort -u >both_options
section COMMANDS | awk '/^\.It "/ { c = $2; gsub(/"/, "", c) }
	/^\.It Cm / { print (c == "" ? "" : c ".") $3 }
	/^Also takes / { h = 1; $1 = $2 = "" }
	h { last = /\)\.$/; gsub(/,|\(see|above\)\./, " ")
		for (i = 1; i <= NF; i++) print "shared " c "." $i; h = !last }' \
	>both_in_manual
grep -v '^shared' both_options >all_options
grep '^[a-z_]*\.' both_in_manual >in_manual
same "options of commands: help and manual" all_options in_manual
sed -n 's/^shared //p' both_options >all
sed -n 's/^shared //p' both_in_manual >in_manual
same "shared options of commands: help and manual" all in_manual
"$TIPSPEED" -c 'help options' | sed -n 's/^  \([a-z][a-z_]*\) .*/\1/p' >all
grep -v '[ .]' both_in_manual >in_manual
same "shared options: help and manual" all in_manual
[ "$(sort -u all)" = "$(sed -n 's/^shared [a-z_]*\.//p' both_options | sort -u)" ]
result $? "shared options: each is told, and told of a command"

# Nobody reads on where it has scrolled away.
longest() { wc -l | awk -v n="$1" '$1 == 0 || $1 > n { exit 1 }'; }
"$TIPSPEED" -c help | longest 24
result $? "help fits a screen of 24 lines"
long=
for name in options $(cat titles); do
	"$TIPSPEED" -c "help $(echo "$name" | tr _ ' ')" >one
	longest 40 <one || long="$long $name"
done
result ${#long} "help of each command within 40 lines:$long"
section COMMANDS | awk '/^\.It "/' | tr -d '"' >usages
awk '{ c = $2; for (i = 3; i <= NF; i++) if ($i ~ /^\[[a-z0-9_]+=/) {
	sub(/^\[/, "", $i); sub(/=.*/, "", $i); print c "." $i } }' usages >in_usage
same "options of commands: help and usage" all_options in_usage

# Options of the command line, and what they take.
awk '/^  -/ { for (i = 1; i <= NF && $i ~ /^-/; i++) { sub(/,$/, "", $i)
	sub(/=.*/, "", $i); print $i } }' help >all
section OPTIONS | sed -n 's/^\.It Fl //p' |
	awk '{ for (i = 1; i <= NF; i++) { if ($i == "," || $i == "Ns") continue
		if ($i == "=" || $i == "Ar") break
		print "-" $i } }' | sed 's/,$//' >in_manual
same "options: --help and manual" all in_manual
awk '/case \$cur in/ { h = 1 } h && /words=/ { print; exit }' "$bash" |
	sed "s/.*words='//; s/'//; s/=//g" >in_bash
same "options: --help and completion" all in_bash
for option in format color; do
	sed -n "s/^  --$option=.*: //p" help >all
	awk -v o="--$option)" '$1 == o { h = 1; next } h { print; exit }' \
		"$bash" | sed "s/.*words='//; s/'//" >in_bash
	same "--$option: --help and completion" all in_bash
	section OPTIONS | awk -v o="-$option" '/^\.It Fl / { h = $3 == o } h' |
		sed -n 's/^\.Cm \([a-z]*\).*/\1/p' >in_manual
	same "--$option: --help and manual" all in_manual
done

# Exit statuses, also those of the source.
block 'exit status' | sed -n 's/^  \([0-9][0-9]*\)$/\1/p' >all
section 'EXIT STATUS' | sed -n 's/^\.It \([0-9]*\)$/\1/p' >in_manual
same "exit statuses: --help and manual" all in_manual
{
	sed -n 's/^	ERROR_[A-Z]* = \([0-9]*\).*/\1/p' \
		"$srcdir/src/base/error.h"
	# 128 and the signals that are caught to end the program.
	grep -oE 'sigaction\(SIG(HUP|INT|TERM)' "$srcdir/src/cli/signals.c" |
		sed 's/.*SIGHUP/129/; s/.*SIGINT/130/; s/.*SIGTERM/143/'
} | sort -nu >in_source
same "exit statuses: --help and source" all in_source

# The one that is met least: what goes back hardly breaks.
"$TIPSPEED" data/sites/tierp.csv -c 'params set f_mat=2.18 e0_min=16.74 alpha=0.96' \
	-c 'flow tph=100 fractions=0/22.4 recycle=0/22.4' >out 2>err
[ $? -eq 4 ] && grep -q 'circulate for 100 t/h' err &&
	awk '/^  4$/ { h = 1; next } /^  [0-9]/ { h = 0 } h' help | grep -q circuit
result $? "status 4: a circuit that does not become steady, as --help says"

# Variables, also those of the source.
block environment | sed -n 's/^  \([A-Z_][A-Z_]*\)$/\1/p' >all
section ENVIRONMENT | sed -n 's/^\.It Ev \([A-Z_]*\)$/\1/p' >in_manual
same "variables: --help and manual" all in_manual
{
	find "$srcdir/src" -name '*.c' -exec cat {} + | tr -s '\n\t ' '   ' |
		grep -oE '(getenv|xdg_user_file_path)\( ?"[A-Z_]+"' |
		sed 's/.*"\(.*\)"/\1/' | sort -u
	grep -oE 'setenv\("[A-Z]+' "$srcdir"/src/base/tr.c | sed 's/.*"//'
	cat "$srcdir"/src/*.c "$srcdir"/src/base/tr.c |
		grep -oE 'setlocale\(LC_[A-Z]+' | sed 's/setlocale(//' | sort -u
} | sort -u >in_source
same "variables: --help and source" all in_source

# Pages.
section COMMANDS | sed -n 's/^\.It "help_page .*\[page=\(.*\)\]"/\1/p' |
	tr '|' '\n' >all
for f in "$page" "$srcdir"/man/*.[0-9] "$srcdir"/man/*-*.in; do
	basename "$f" | sed 's/\..*//; s/^tipspeed-//'
done >in_man
same "pages: help man and the folder" all in_man

# The completion does what it says: complete WORD..., at the end of the last.
if command -v bash >/dev/null; then
	complete() {
		bash -c 'compopt() { :; }; . "$0"; COMP_WORDS=("$@")
			COMP_CWORD=$(($# - 1)); _tipspeed
			echo "${COMPREPLY[*]}"' "$bash" tipspeed "$@"
	}
	[ "$(complete -c predi)" = predict ]
	result $? "bash: a command behind -c"
	[ "$(complete -c "'predi")" = predict ]
	result $? "bash: also in a quote"
	[ "$(complete --form)" = --format= ]
	result $? "bash: an option"
	[ "$(complete --format = c)" = csv ] &&
		[ "$(complete --format =)" = 'table csv json markdown' ]
	result $? "bash: what an option takes"
	[ -z "$(complete data/)" ]
	result $? "bash: files are left to bash"
fi

"$TIPSPEED" -c 'help plot' | tr -s ' \n' '  ' >plot
"$TIPSPEED" -c 'plot pie' 2>&1 | sed -n '/the plots are:/,$p' |
	sed 's/.*are://' | tr -s ' ' '\n\n' | grep . >kinds
[ -s kinds ] && while read -r kind; do
	grep -q " $kind: " plot || echo "$kind"
done <kinds >missing
[ ! -s missing ]
result $? "the help of plot tells what each kind shows"
remark missing
finish
