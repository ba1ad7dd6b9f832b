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
LC_ALL=C.UTF-8 timeout -k 2 100 expect "$script" "$TIPSPEED" \
	data/sites/tierp.csv >steps
[ "$(wc -l <steps)" -eq 400 ]
result $? "every step from 65 to 85 m/s and back writes something"
most=$(sort -n steps | tail -n 1)
[ "${most%% *}" -lt 600 ]
result $? "a step writes less than 600 bytes (most, and at: $most)"
finish
