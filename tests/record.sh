#!/bin/sh
# tests/record is the same twice and has every command, and tests/record-compare
# notices what differs, and how.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
export TIPSPEED
tests=$(cd "$srcdir/tests" && pwd)
for d in a b; do
	"$tests/record" --sites=tierp --lists=known,hostile "$dir/$d" >"$dir/log" 2>&1
	result $? "record $d"
	remark "$dir/log"
done
compare() { "$tests/record-compare" "$@" >"$dir/out" 2>&1; }
compare "$dir/a" "$dir/b"
[ $? = 0 ] && grep -q '^no difference in [1-9][0-9]* answers$' "$dir/out"
result $? "the same twice"
[ -s "$dir/out" ] && remark "$dir/out"

[ "$(grep -A 2 '^@@ echo' "$dir/a/tierp/known.table" | tr '\n' ' ')" = \
	'@@ echo one two one two @@ why ' ]
result $? "what is printed stands below its command"

# differs FILE EXPRESSION KIND STATUS WHAT: sed's EXPRESSION on a file of b is told as
# KIND, with STATUS under --last-digits.
differs() {
	sed "$2" "$dir/a/tierp/$1" >"$dir/b/tierp/$1"
	compare "$dir/a" "$dir/b"
	[ $? = 1 ] && grep -q "^$3.*tierp/$1: " "$dir/out" &&
		{ compare --last-digits "$dir/a" "$dir/b"; [ $? = "$4" ]; }
	status=$?
	result $status "$5"
	[ $status = 0 ] || remark "$dir/out"
	cp "$dir/a/tierp/$1" "$dir/b/tierp/$1"
}
p50='"p50_mm":\([0-9]*\.[0-9]\{11\}\)[0-9]*'
differs known.json "s/$p50/\"p50_mm\":\\11/" 'last digits  predict  *json  *p50_mm' 0 \
	'a last digit in JSON'
differs known.json 's/"p50_mm":[0-9]/&9/' 'values  *predict  *json  *p50_mm' 1 \
	'a number in JSON'
differs known.json 's/"trust":"[a-z]*"/"trust":"blue"/' \
	'text  *predict  *json  *trust' 1 'a word in JSON'
differs known.json 's/"p50_mm":/"p51_mm":/' 'missing  *predict  *json  *p51_mm' 1 \
	'a key of JSON'
differs known.csv '/^@@ predict 72$/,/^@@ predict 85/s/^\(predict,.*\.[0-9]\{9\}[0-9]*\)\(,72,\)/\17\2/' \
	'last digits  predict  *csv' 0 'a last digit in CSV'
differs known.csv '/^@@ figures/,/^@@ find/s/,p50_mm,/,p50_mm,9/' \
	'values  *figures  *csv  *value' 1 'a number in CSV'
differs known.csv '/^@@ figures/,/^@@ find/{/,p50_mm,/d;}' \
	'missing  *figures  *csv  *row' 1 'a row of CSV'
differs known.table 's/^trust: .*/trust: perhaps/' 'text  *predict  *table  *trust' 1 \
	'a sentence of a text'
differs known.table '/^@@ predict 72$/,/^@@ predict 85/s/^\(P20 [0-9]*\.[0-9]\)[0-9]/\19/' \
	'values  *predict  *table  *P20' 1 'a number in a text'
differs hostile.table 's/^@@ status 2/@@ status 3/' 'values  *window  *table  *@@ status #' 1 \
	'an exit status'
differs hostile.table '/^@@ window$/,/^@@ status/d' 'missing  *window  *table  *the answer' \
	1 'an answer'
rm "$dir/b/tierp/hostile.json"
compare "$dir/a" "$dir/b"
[ $? = 1 ] && grep -q '^missing .* the file, in the second' "$dir/out"
result $? "a file"
mkdir "$dir/none"
compare "$dir/none" "$dir/none"
[ $? = 1 ] && grep -q '^record-compare: nothing' "$dir/out"
result $? "two empty folders are no proof"
"$tests/record" --sites=tierp "$dir/a" 2>"$dir/out"
[ $? = 2 ] && grep -q 'is not empty$' "$dir/out"
result $? "nothing is recorded over a record"

# All commands but those that have nothing to answer here.
sed 's/#.*//' "$tests"/records/*.tip | tr -s ' ;' '\n\n' | sort -u >"$dir/words"
missing=
for c in $("$TIPSPEED" -c 'help all' | awk '/^  [a-z]/ { sub(",", "", $1); print $1 }'); do
	grep -qx "$c" "$dir/words" || missing="$missing $c"
done
result ${#missing} "every command is recorded:$missing"
finish
