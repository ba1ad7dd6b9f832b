#!/bin/sh
# The paper, figure by figure: what data/sessions/paper.tip writes, and doc/paper.md,
# which shows it; `RENEW=1` writes that anew.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
srcdir=$(cd "$srcdir" && pwd)
scratch
cd "$dir" || exit 99
tip=$srcdir/data/sessions/paper.tip
LC_ALL=C.UTF-8 "$TIPSPEED" -f "$tip" >out.txt 2>err.txt
status=$?
[ $status = 0 ] || remark err.txt
result $status "the script runs"

# Comments are its text, commands stand below, and what is drawn below these.
awk 'BEGIN {
	print "# The paper, figure by figure\n"
	print "Made from data/sessions/paper.tip by `make renew-paper`.\n"
}
function flush() {
	if (code != "") print "\n" code
	if (pictures != "") print pictures
	code = pictures = ""
}
/^#/ {
	if (was !~ /^#/) flush()
	sub(/^# ?/, "")
	print
	was = "#"
	next
}
{ was = $0 }
NF { code = code "    " $0 "\n" }
/^plot .* > .*svg$/ { pictures = pictures "![" $2 "](paper/" $NF ")\n" }
END { flush() }' "$tip" >paper.md
{
	echo 'What the last two say:'
	echo
	sed '/./s/^/    /' equations.txt
	echo
	sed '/./s/^/    /' claims.txt
} >>paper.md
if [ -n "$RENEW" ]; then
	mkdir -p "$srcdir/doc/paper"
	cp paper.md "$srcdir/doc/paper.md" && cp fig*.svg "$srcdir/doc/paper"
fi
cmp -s paper.md "$srcdir/doc/paper.md"
result $? "doc/paper.md shows what it writes: else make renew-paper"

wrong=
for i in 1 7 8 9 10; do
	cmp -s fig$i.svg "$srcdir/doc/paper/fig$i.svg" || wrong="$wrong fig$i.svg"
done
result ${#wrong} "its pictures are those in doc/paper:$wrong"

# Each curve or mark of a picture has its numbers.
wrong=
for i in 1 7 8 9 10; do
	[ -s fig$i.csv ] || wrong="$wrong fig$i.csv"
done
for name in 'feed 69 m/s' 'measured 69 m/s' 'predicted 69 m/s' \
	'measured 74 m/s (held out)' 'predicted 79 m/s'; do
	grep -qF ",$name," fig7.csv && grep -qF ">$name<" fig7.svg ||
		wrong="$wrong $name"
done
for speed in 65 85; do
	grep -q "predicted $speed m/s,2," fig9.csv || wrong="$wrong $speed"
done
[ "$(grep -c 'P50' fig8.csv)" = 19 ] && [ "$(grep -c 'table3/' fig10.csv)" = 19 ] &&
	[ "$(grep -c ',loaded sites,\|"loaded, a' fig10.csv)" = 19 ] &&
	[ "$(grep -c '>Glanshamar<\|>Össjö<' fig10.svg)" = 4 ] || wrong="$wrong sites"
result ${#wrong} "the numbers of each picture are beside it:$wrong"

wrong=
[ "$(sed 1d table2.csv | wc -l)" = 7 ] && [ "$(sed 1d table3.csv | wc -l)" = 19 ] &&
	[ -s table1.csv ] && [ -s validation.csv ] || wrong=tables
result ${#wrong} "the tables are whole"

# The figures of the account are those of the commands, whatever they are.
"$TIPSPEED" -c 'load tierp umea' -c 'calibrate all' -c 'set format json' \
	-c 'validate all' -c 'show claims' >json.txt 2>/dev/null
rms=$(grep -o '"p50":{"n":2,[^}]*' json.txt | sed -n '1s/.*"rms_pct":\([0-9.]*\).*/\1/p')
grep -q "$(printf 'P50 %.2f %%' "$rms")" json.txt
result $? "claims are worked out: P50 of two sites is that of validate all"
"$TIPSPEED" -c 'load tierp' -c calibrate -c 'show claims' 2>/dev/null >out.txt
grep -q 'rows of Table 3; chance' out.txt && ! grep -q nan out.txt
result $? "one fit has no correlation"
"$TIPSPEED" -c 'load tierp' -c 'show claims' >out.txt 2>err.txt
[ $? = 2 ] && grep -q "run 'calibrate all'" err.txt
result $? "without a fit there are none"
finish
