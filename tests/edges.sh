#!/bin/sh
# Input without an end, descriptors that are missing, files that may not grow.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
sheet=data/sites/tierp.csv
quick='params set f_mat=2.18 e0_min=16.74 alpha=0.96'

# told STATUS WORDS NAME: how the last run ended, and what it said.
told() {
	[ $status -eq "$1" ] && { [ -z "$2" ] || grep -q "$2" err; }
	good=$?
	[ $good -eq 0 ] || { echo "# status $status"; remark err; }
	result $good "$3"
}
# try COMMAND...: at most a minute of it.
try() {
	timeout 60 "$@" >out 2>err
	status=$?
}
# ours ARGUMENT...: of the program, without a store.
ours() { try "$TIPSPEED" --store=:memory: "$@"; }

# An assertion behind a line that is too long must not be passed over.
{ head -c 30000000 /dev/zero | tr '\0' ' '; echo; echo 'assert 1 = 2'; } >long
ours -f long
told 2 '^long:1:1: expected lines of at most 10 MB' 'a line of 30 MB in a script'
ours -f - <long
told 2 '^stdin:1:1: expected lines of at most 10 MB' 'a line of 30 MB on standard input'
ours -f - </dev/zero
told 2 '^stdin:1:1: expected lines of at most 10 MB' 'a line without an end'
{ echo; yes '\' | head -c 21000000; } >long
ours -f long
told 2 '^long:[0-9]*:1: expected lines of at most 10 MB' 'lines that go on and on'
printf 'assert 1 = 1\n\nassert 1 = \\\n 2' >short
ours -f short
told 1 '^short:3:' 'lines that end with the file'
ours -f /dev/zero
told 5 'expected a file or a pipe, got a device' 'a device as a script'
ours /dev/zero
told 5 'expected a file or a pipe, got a device' 'a device as a sheet'
try "$TIPSPEED" --store=/dev/zero -c materials
told 5 'the store cannot be opened: this is a folder' 'a device as a store'
ours -f /dev/null
told 0 '' 'nothing as a script'
{ printf 'energy_j_kg\n100\n200\n'; head -c 11000000 /dev/zero | tr '\0' 1; } >long
ours -c 'energy load long speed=69'
told 5 'cannot be read to its end' 'a line of 11 MB among collision energies'

mkfifo pipe
cat $sheet >pipe &
ours pipe -c "$quick"
told 0 'loaded Tierp' 'a sheet from a pipe'
yes 1,2 >pipe 2>/dev/null &
ours pipe
told 3 'at most 10 MB' 'a sheet without an end from a pipe'
{ sleep 0.3; echo 'assert 1 = 2'; } >pipe &
ours -f pipe
told 1 '^pipe:1:1: assertion failed' 'a script from a pipe'
wait
cat $sheet | "$TIPSPEED" --store=:memory: /dev/stdin -c "$quick" 2>err
status=$?
told 0 'loaded Tierp' 'a sheet from standard input'
for kind in '' '-f'; do
	env --default-signal=INT "$TIPSPEED" --store=:memory: $kind pipe 2>err &
	pid=$!
	sleep 0.5
	kill -s INT $pid
	wait $pid
	status=$?
	told 130 'cannot read' "nobody writes to a pipe: ^C${kind:+, $kind}"
done
env --default-signal=INT "$TIPSPEED" --store=:memory: $sheet \
	-c "$quick" -c 'predict 74 > pipe' 2>err &
pid=$!
# So that a program that does not answer goes on and fails.
{ sleep 20; exec cat pipe; } >/dev/null &
reader=$!
sleep 1
kill -s INT $pid
wait $pid
status=$?
kill $reader
told 130 'cannot write pipe' 'nobody reads from a pipe: ^C'

# Results and messages in one file.
"$TIPSPEED" --store=:memory: $sheet -c "$quick" -c 'predict 74 > /dev/stderr' \
	-c nonsense 2>err
[ $? -eq 2 ] && grep -q '^loaded Tierp' err && grep -q '^  sieve mm' err &&
	grep -q 'no command' err
result $? 'results follow messages on standard error'

# Without a place for messages they must not go into a file.
"$TIPSPEED" --store=:memory: $sheet -c "$quick" -c 'predict 74 > one.csv' 2>err
"$TIPSPEED" --store=:memory: $sheet -c "$quick" -c 'predict 74 > two.csv' 2>&-
status=$?
: >err
cmp one.csv two.csv || status=1
told 0 '' 'standard error is closed'
"$TIPSPEED" --store=:memory: $sheet -c "$quick" -c 'predict 74' 2>err >&-
status=$?
told 5 'not all results could be written' 'standard output is closed'
"$TIPSPEED" --store=:memory: $sheet -c "$quick" -c 'predict 74 > three.csv' \
	-c 'nonsense' <&- >&- 2>&-
[ $? -eq 2 ] && cmp one.csv three.csv
result $? 'all three are closed'
"$TIPSPEED" --store=:memory: \
	-c 'echo x | (exec 3>mine; [ -e /proc/self/fd/2 ] && echo open >&3)' 2>&-
[ "$(cat mine)" = open ]
result $? 'nor does a shell command lack one'

# Some file systems tell only when a file is closed that it could not be written.
if strace -qq -o calls -y -e trace=close "$TIPSPEED" -c version >out 2>/dev/null &&
	number=$(grep -n '^close(1<' calls | cut -d: -f1) && [ -n "$number" ]; then
	try strace -qq -o calls -e trace=close \
		-e inject=close:error=EDQUOT:when="$number" "$TIPSPEED" -c version
	told 5 'not all results could be written' 'a failure to close standard output'
else
	n=$((n + 1))
	echo "ok $n - a failure to close # SKIP strace cannot trace here"
fi

# Each part of a workbook is written to a file of its own, where the disk may be full.
ours $sheet -c "$quick" -c 'predict 74 > whole.xlsx'
torn=0
for number in 25 28 31 34 37 40; do
	if strace -f -qq -o calls -e trace=write \
		-e inject=write:error=ENOSPC:when=$number "$TIPSPEED" \
		--store=:memory: $sheet -c "$quick" -c 'predict 74 > x.xlsx' 2>err; then
		cmp -s whole.xlsx x.xlsx || torn=$((torn + 1))
	fi
done
[ -s whole.xlsx ] && [ $torn -eq 0 ]
result $? "a disk that is full for a part of a workbook, $torn torn"

# A file may have no more than so many blocks of 512 or 1024 bytes.
(
	ulimit -f 20
	"$TIPSPEED" --store=:memory: $sheet -c "$quick" \
		-c 'plot psd > picture.png' 2>err
)
status=$?
told 5 'File too large' 'a file larger than may be'
[ ! -e picture.png ] && [ -z "$(ls picture.png.* 2>/dev/null)" ]
result $? 'and nothing is left of it'
# The shell counts its signals by itself.
(
	ulimit -f 20
	"$TIPSPEED" --store=:memory: $sheet -c "$quick" \
		-c 'predict 74 | sh -c "grep SigIgn /proc/self/status" > ignored'
) >out 2>&1
[ "$(awk '{ print substr($2, length($2) - 5, 1) }' ignored)" = 0 ]
result $? 'shells get the usual end by a file too large'
finish
