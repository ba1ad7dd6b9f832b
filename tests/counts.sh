#!/bin/sh
# What the program says of itself, counted by bench/counts on a few cases each,
# and what another seed of the draws changes in it.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
# count KIND FEW MANY: none of it in `make check` where FEW is 0, else one at least.
count()
{
	times=$(often "$2" "$3")
	[ "$times" -gt 0 ] || [ -z "${TIPSPEED_TEST_LONG:-}" ] || times=1
	[ "$times" -gt 0 ] || return 0
	bench/counts "$1" "$times" >"$dir/out"
	result $? "$1"
	remark "$dir/out"
}
count advise 0 21
count doctor 0 42
count drift 0 50
count guess 38 360
count league 0 14
count params 1 60
count power 200 2000
count speeds 0 60
count window 2 140
bench/chance "${srcdir:-.}/data" "$(often 2 5)" tierp >"$dir/out"
result $? "what chance leaves"
remark "$dir/out"
finish
