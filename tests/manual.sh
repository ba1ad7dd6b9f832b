#!/bin/sh
# The manual is free of lint, and its examples do what it says.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
mkdir "$dir/man"
cp man/tipspeed.1 man/tipspeed-tui.1 man/tipspeed-model.7 "$srcdir"/man/*.[57] "$dir/man"
for page in "$dir"/man/*; do
	name=$(basename "$page")
	if command -v mandoc >/dev/null; then
		# In the folder, so that pages find each other, and none that
		# an installed tipspeed has.
		(cd "$dir/man" && MANPATH=$dir/man mandoc -T lint -W style \
			"$name") >"$dir/lint" 2>&1
		[ ! -s "$dir/lint" ]
		result $? "$name is free of lint"
		remark "$dir/lint"
	fi
	if [ "$name" = tipspeed-tutorial.7 ] && command -v mandoc >/dev/null; then
		# Letters are struck over for bold.
		mandoc -T ascii -O width=80 "$page" |
			sed "s/.$(printf '\b')//g" >"$dir/printed"
		[ "$(wc -l <"$dir/printed")" -gt 600 ] &&
			! grep '.\{81\}' "$dir/printed" >"$dir/wide"
		result $? "$name fits a screen of 80 columns"
		remark "$dir/wide"
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
# The sheet printed in README loads, and its session and its command line run.
readme=$(cd "$srcdir" && pwd)/README.md
cd "$dir" || exit 99
sed -n '/^    site,My quarry/,/^$/s/^    //p' "$readme" >myquarry.csv
sed -n 's/^    [a-z-]*\( (fit)\)*> //p' "$readme" >session
[ "$(wc -l <session)" -ge 3 ]
result $? "README has a session"
XDG_DATA_HOME=$dir "$TIPSPEED" -f session >out 2>log
result $? "it runs on the sheet in README"
remark log
grep -q '^36 % passing 2 mm at 7[0-9.]* m/s' out && [ -s product.csv ] &&
	[ -s card.pdf ] && [ -s my-quarry.html ] && [ -s quarry.tip ]
result $? "finds a speed, and leaves the files"
sed -n '/^       at 72.0 m/,/^$/s/^ *\(.\)/\1/p' "$readme" >sentence
"$TIPSPEED" myquarry.csv -c calibrate -c 'predict 72' 2>log |
	sed -n '/^at 72.0 m/,/^P20/p' | sed '$d' >said
[ -s said ] && cmp said sentence
result $? "and the command line of README predicts what README says"
finish
