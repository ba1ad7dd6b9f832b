#!/bin/sh
# How much a step of the slider writes to the terminal, at a site with a feed for
# each run: the slider keeps one, or all curves would jump halfway between runs.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
if ! command -v expect >/dev/null; then
	echo '1..0 # SKIP no expect here'
	exit 0
fi
scratch
script=$(cd "$srcdir/tests" && pwd)/steps.exp
cd "$dir" || exit 99
HOME=$dir
export HOME
unset NO_COLOR TIPSPEED_COLOR
# steps KEYS WAYS: how many bytes each step writes after these keys, to the file steps;
# sets most, and ends: the most of the four at the ends of the measured speeds, where
# the light and its words change with all else that says so (D21).
steps()
{
	LC_ALL=C.UTF-8 timeout -k 2 100 expect "$script" "$TIPSPEED" \
		data/sites/tierp.csv "$1" "$2" >steps
	at='(68.9|69.0|79.0|79.1)$'
	most=$(grep -Ev " $at" steps | sort -n | tail -n 1)
	ends=$(grep -E " $at" steps | sort -n | tail -n 1)
}
# Each way once: up with nothing over it and with the band, down with all else that can be
# laid over it; in the long tests there and back each time.
long=$(often 0 1) up=both down=both each=400
[ "$long" -eq 1 ] || up=up down=down each=200
steps '' $up
[ "$(wc -l <steps)" -eq $each ]
result $? "every step between 65 and 85 m/s writes something"
[ "${most%% *}" -lt 900 ]
result $? "a step writes less than 900 bytes (most, and at: $most)"
[ "${ends%% *}" -lt 1000 ]
result $? "one over an end of the measured speeds less than 1000 (most, and at: $ends)"
steps "$(printf 'bt5.2\r')" $up
[ "$(wc -l <steps)" -eq $each ] && [ "${most%% *}" -lt 900 ]
result $? "with a goal and the band less than 900 (most, and at: $most)"
# Between 73.0 and 73.1 the strip of differences goes from 2 points to 1, and all in it is
# drawn anew.
steps "$(printf 'bxt5.2\r:spec use "ASTM C33"\rc')" $down
scaled=$(grep -E ' 73.[01]$' steps | sort -n | tail -n 1)
most=$(grep -Ev ' 73.[01]$' steps | grep -Ev " $at" | sort -n | tail -n 1)
[ "$(wc -l <steps)" -eq $each ] && [ "${most%% *}" -lt 900 ]
result $? "with envelope, pin and crosshair less than 900 (most, and at: $most)"
[ "${scaled%% *}" -lt 1000 ]
result $? "one that changes the scale of the strip less than 1000 (at: $scaled)"
finish
