#!/bin/sh
# How much a step of the slider writes to the terminal.  Where the feed sample
# changes with the speed, all curves do; so the sheet here has one feed.
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
awk -F, -v OFS=, '/^size_mm/ { rows = 1; print $1, "feed", $3, $5, $7; next }
	rows { print $1, $4, $3, $5, $7; next } { print }' \
	data/sites/tierp.csv >sheet.csv
LC_ALL=C.UTF-8 timeout -k 2 100 expect "$script" "$TIPSPEED" sheet.csv >steps
[ "$(wc -l <steps)" -eq 400 ]
result $? "every step from 65 to 85 m/s and back writes something"
most=$(sort -n steps | tail -n 1)
[ "${most%% *}" -lt 600 ]
result $? "a step writes less than 600 bytes (most, and at: $most)"
finish
