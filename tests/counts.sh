#!/bin/sh
# What the program says of itself, counted by bench/counts on a few cases each,
# and what another seed of the draws changes in it.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
count()
{
	bench/counts "$1" "$2" >"$dir/out"
	result $? "$1"
	remark "$dir/out"
}
count advise "$(often 1 21)"
count doctor "$(often 2 42)"
count drift "$(often 1 50)"
count guess "$(often 38 360)"
league=$(often 0 14) # some 10 s of processor each
[ "$league" -eq 0 ] || count league "$league"
count params "$(often 1 60)"
count power "$(often 200 2000)"
count speeds "$(often 2 60)"
count window "$(often 5 140)"
bench/chance "${srcdir:-.}/data" "$(often 3 5)" tierp ossjo >"$dir/out"
result $? "what chance leaves"
remark "$dir/out"
finish
