#!/bin/sh
# The manual is free of lint, and its examples do what it says.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
mkdir "$dir/man"
cp man/tipspeed.1 man/tipspeed-tui.1 "$srcdir"/man/*.[57] "$dir/man"
for page in "$dir"/man/*; do
	name=$(basename "$page")
	if command -v mandoc >/dev/null; then
		# In the folder, so that pages find each other.
		(cd "$dir/man" && mandoc -T lint -W style "$name") >"$dir/lint" 2>&1
		[ ! -s "$dir/lint" ]
		result $? "$name is free of lint"
		remark "$dir/lint"
	fi
	sh "$srcdir/man/check.sh" "$TIPSPEED" "$srcdir" "$page" >"$dir/tap" 2>&1
	status=$?
	grep -E '^(not )?ok' "$dir/tap" >"$dir/points"
	while read -r line; do
		case $line in
		ok*) result 0 "${line#ok - }" ;;
		*) result 1 "${line#not ok - }" ;;
		esac
	done <"$dir/points"
	[ $status -eq 0 ] || remark "$dir/tap"
	[ -s "$dir/points" ]
	result $? "$name has examples, and they ran"
done
# The sheet printed in README loads, and its command line runs.
sed -n '/^    site,My quarry/,/^$/s/^    //p' "$srcdir/README.md" >"$dir/my.csv"
"$TIPSPEED" "$dir/my.csv" -c check -c calibrate -c validate -c 'predict 67' \
	>"$dir/out" 2>"$dir/log"
result $? "the sheet in README loads and is calibrated"
grep -q '^P20 .*P50 .*P80 ' "$dir/out"
result $? "and its product is predicted"
finish
