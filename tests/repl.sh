#!/bin/sh
# The prompt in a pseudo-terminal, and what takes its place without one.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
srcdir=$(cd "$srcdir" && pwd)
cd "$dir" || exit 99
HOME=$dir
XDG_STATE_HOME=$dir/state
XDG_CONFIG_HOME=$dir/config
export HOME XDG_STATE_HOME XDG_CONFIG_HOME TIPSPEED
unset NO_COLOR TIPSPEED_COLOR TIPSPEED_PAGER PAGER INPUTRC
mkdir -p "$dir/config/tipspeed"
cp data/sites/bro.csv 'two words.csv'
sed 's/66.19/39.19/' data/sites/tierp.csv >slips.csv
printf '%s\n' 'site,Odd' 'provenance,made up' 'size_mm,feed,product@69,product@79' \
	16,100,100,100 8,60,50.5,75 4,30,28,50 2,12,20,30 >faults.csv
{ sed '/^provenance/d' data/sites/tierp.csv; printf '\nRemark,ok\n'; } >foot.csv
mkdir bin
printf '#!/bin/sh\necho "MAN $*"\n' >bin/man
chmod +x bin/man
mkdir -p clone/build clone/man
cp "$TIPSPEED" clone/build/tipspeed
: >clone/man/tipspeed-tutorial.7
escape=$(printf '\033')

if command -v expect >/dev/null; then
	LC_ALL=C.UTF-8 timeout -k 2 300 expect "$srcdir/tests/repl.exp" >points 2>log
	result $? "the session with expect ends"
	remark log
	while read -r line; do
		case $line in
		'ok - '*) result 0 "${line#ok - }" ;;
		'not ok - '*) result 1 "${line#not ok - }" ;;
		*) printf '%s\n' "$line" ;;
		esac
	done <points
else
	n=1
	echo 'ok 1 # SKIP no expect here'
fi

printf '\n\n' | "$TIPSPEED" data/sites/tierp.csv >out 2>log
[ "$(wc -l <log)" -eq 1 ] && [ ! -s out ]
result $? "a script is offered nothing"
remark log

echo 'nonsense' >"$dir/config/tipspeed/init.tip"
echo seed | "$TIPSPEED" >out 2>log
result $? "a script does not read the init file"
[ "$(wc -l <out)" -eq 2 ] && [ ! -s log ] && ! grep -q "$escape" out
result $? "nor has it a prompt or an escape byte"

script() { echo load data/sites/tierp.csv; seq -f 'seed %.0f' 10000; echo seed; }
script | "$TIPSPEED" >out 2>log
[ $? -eq 0 ] && grep -q '10000$' out
result $? "a script of 10,000 lines"
{ head -c 1000000 /dev/zero | tr '\0' x; echo; } | "$TIPSPEED" >out 2>log
[ $? -eq 2 ] && [ "$(wc -c <log)" -lt 1000 ]
result $? "a line of 1 MB is refused in few words"
{ printf 'seed 3 #'; head -c 1000000 /dev/zero | tr '\0' x
	printf '\nseed\n'; } | "$TIPSPEED" >out 2>log
[ $? -eq 0 ] && grep -q '3$' out
result $? "a remark of 1 MB is passed over"
printf 'seed 1\nse\000ed 2\n' | "$TIPSPEED" >out 2>log
[ $? -eq 2 ] && grep -q '^stdin:2:1: expected UTF-8 text' log
result $? "NUL bytes are refused with their place"
{ "$TIPSPEED" data/sites/tierp.csv -c 'params set f_mat=2 e0_min=16 alpha=1' \
	-c 'sweep 20..120:0.1' 2>log; echo $? >status; } | head -n 1 >out
[ "$(wc -l <out)" -eq 1 ] && ! grep -qi 'error\|disk' log
result $? "a pipe that closes ends it quietly"

# Locales with a decimal comma, with another small letter of I, and with control
# characters among the bytes of UTF-8, made here: few machines have them.
LOCPATH=$dir
locales=C
for locale in sv_SE.UTF-8 tr_TR.UTF-8 sv_SE.ISO-8859-1; do
	if localedef -i "${locale%.*}" -f "${locale#*.}" ./$locale >out 2>&1; then
		export LOCPATH
		[ "$(LC_ALL=$locale locale decimal_point)" = , ]
		result $? "$locale is there"
		locales="$locales $locale"
	else
		n=$((n + 1))
		echo "ok $n - locale $locale # SKIP it cannot be made here"
	fi
done
for locale in $locales; do
	LC_ALL=$locale "$TIPSPEED" --lang=en data/sites/borlange.csv \
		-c 'set k 1.5' -c 'use börlange' -c set >out 2>log
	[ $? -eq 0 ] && grep -q 'k  *1\.5$' out
	result $? "locale $locale: the decimal sign is a point"
	LC_ALL=$locale "$TIPSPEED" --lang=en --store=:memory: \
		data/sites/tierp.csv -c 'params set f_mat=2 e0_min=16 alpha=1' \
		-c 'figures 72 FINES' -c 'remember "Örebro"' >out 2>log
	[ $? -eq 0 ] && grep -q '^remembered Örebro' out
	result $? "locale $locale: FINES is fines, and Ö is a letter"
done

"$TIPSPEED" data/sites/tierp.csv -c \
	'calibrate generations=1000000 tolerance=0 stall=0' >out 2>log &
pid=$!
tries=0
until grep -q 'generation  *[0-9]*0 ' log || [ $tries -ge 300 ]; do
	sleep 0.1
	tries=$((tries + 1))
done
kill -s USR1 $pid
tries=0
until grep -q '^tierp: generation [0-9]* of 1000000, best' log ||
	[ $tries -ge 300 ]; do
	sleep 0.1
	tries=$((tries + 1))
done
[ $tries -lt 300 ]
result $? "SIGUSR1 gets a line in a script, too"
kill -s TERM $pid
wait $pid

# How long the start takes, for whoever reads the log.
began=$(date +%s%N)
for i in 1 2 3 4 5 6 7 8 9 10; do "$TIPSPEED" -c version >out; done
echo "# tipspeed -c version: $((($(date +%s%N) - began) / 10000000)) ms"
finish
