#!/bin/sh
# Documents: what a report holds, that its script makes it again, and, where
# there is a browser, that it shows and prints it.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99

# is_page FILE: well-formed, and fetches nothing.
is_page() {
	[ "$(head -n 1 "$1")" = '<!DOCTYPE html>' ] || return 1
	grep -qE 'src=|href=|url\(|@import|<script' "$1" && return 1
	[ "$(grep -o 'https*://[^"]*' "$1" | sort -u)" = "$(printf '%s\n' \
		http://www.w3.org/1999/xhtml http://www.w3.org/2000/svg)" ] ||
		[ "$(grep -c 'https*://' "$1")" = 1 ] || return 1
	if command -v xmllint >/dev/null; then
		sed 1d "$1" | xmllint --noout -
	else
		[ "$(grep -c '^<html\|^</html>' "$1")" = 2 ]
	fi
}

"$TIPSPEED" "$dir/data/sites/tierp.csv" -c calibrate \
	-c 'predict 70 > one.html' \
	-c 'plot psd > two.html' -c 'report "passing 2 = 30..36" speed=74 > tierp.html' >out.txt 2>err.txt &&
	is_page one.html && is_page two.html && is_page tierp.html
result $? "an answer, a plot and a report are pages"
grep -q 'wrote one.html: 1 table$' err.txt &&
	grep -q 'wrote two.html: 1 image$' err.txt
result $? "notes say what is in them"

sed -n 's,.*<h2>\(.*\)</h2>.*,\1,p' tierp.html >heads.txt
cat >want.txt <<'END'
Product at 74 m/s
How sure the answer is
Other speeds
Window
Card
Validation
Data
Check and mends
Fit
The script that makes this again
END
while read -r head; do
	grep -qxF "$head" heads.txt || echo "$head"
done <want.txt >missing.txt
remark missing.txt
[ ! -s missing.txt ]
result $? "a report has its sections"
sed -n '/<h1>/,/<h2>/p' tierp.html >top.txt
grep -q 'class="warning">The data were not measured at a plant' top.txt &&
	grep -q 'class="light green">Trust: green' top.txt
result $? "and says first what the data are and how sure the answer is"
! grep "^<p>No '" tierp.html
result $? "no command of it failed"

sed -n '/^<pre># A session/,/<\/pre>/p' tierp.html |
	sed 's/<[^>]*>//g; s/&gt;/>/g; s/&lt;/</g; s/&amp;/\&/g' >again.tip
mv tierp.html was.html
"$TIPSPEED" again.tip >out.txt 2>err.txt && cmp was.html tierp.html
result $? "its script makes it again"

# report_top WORDS: what stands above the first section of such a report.
report_top() {
	"$TIPSPEED" data/sites/tierp.csv -c 'calibrate > /dev/null' \
		-c "report $1 > top.html" >out.txt 2>err.txt &&
		sed -n '/<h1>/,/<h2>/p' top.html >top.txt
}
report_top '"passing 2 = 31..36" "passing 0.063 < 3"' &&
	grep -q '<p>Conditions: passing 2 mm 31 to 36 %, .*: at [0-9.]* m/s met over 99 times in 100; ' \
		top.txt && grep -q '; met at [0-9.]* to [0-9.]* m/s\.' top.txt &&
	speed=$(sed -n 's/.*<h2>Product at \(.*\) m.s<.*/\1/p' top.txt) &&
	grep -q ": at $speed m/s " top.txt && [ "$speed" != 74 ] &&
	grep -q '<p>at .* passes 2 mm: 8 times in 10' top.txt &&
	grep -q '<th[^>]*>met in 100<' top.html &&
	grep -q '<footer>.*: report "passing 2 = 31..36" "passing 0.063' top.html
result $? "a report says first that its conditions are met, at their best speed"
report_top '"passing 2 = 31..36" speed=84' &&
	grep -q 'class="warning">Conditions: .*: at 84.0 m/s met less than once in 100' top.txt &&
	grep -q '; met at ' top.txt && report_top '"passing 2 > 95"' &&
	grep -q 'class="warning">Conditions: .*no speed from 65 to 85' top.txt
result $? "and that they are missed"
for wrong in '"passing 2 = 45"' '"passing 0.01 < 5"' '"passing 2"'; do
	"$TIPSPEED" data/sites/tierp.csv -c "report $wrong > no.html" \
		>out.txt 2>err.txt
	[ $? = 2 ] && [ ! -e no.html ] || echo "$wrong"
done >missing.txt
remark missing.txt
[ ! -s missing.txt ]
result $? "conditions that cannot be used are refused"
report_top 'tph=120 speed=70' && grep -q '<h2>Flow' top.html &&
	grep -q '120 t/h at 70 m/s' top.html && ! grep "^<p>No '" top.html &&
	grep -q '^report speed=70 tph=120 &gt;' top.html
result $? "with tph= there is its flow"

"$TIPSPEED" data/sites/tierp.csv -c 'report > bare.html' >out.txt 2>err.txt &&
	is_page bare.html &&
	grep -q "class=\"warning\">The site is not calibrated.*'calibrate'" \
		bare.html && grep -q '<h2>First estimate' bare.html &&
	! grep -q '<h2>Fit' bare.html
result $? "without a calibration it says what is missing"
"$TIPSPEED" data/sites/tierp.csv data/sites/bro.csv -c 'calibrate all' \
	-c 'report > two.html' >out.txt 2>err.txt &&
	is_page two.html && grep -q '<h2>All loaded sites' two.html
result $? "several sites have a section"
"$TIPSPEED" data/sites/tierp.csv -c calibrate -c 'add data/cuts/tierp-may.csv' \
	-c 'report "passing 2 = 30..50" tph=200 > cuts.html' >out.txt 2>err.txt &&
	is_page cuts.html && grep -q '<h2>Routine cuts' cuts.html &&
	! grep "^<p>No '" cuts.html && ! grep -q '<h2>Routine cuts' two.html
result $? "and so have routine cuts"
[ "$(sed -n '/<h2>Card/,/<h2>How/p' cuts.html | grep -c '<table')" = 1 ]
result $? "its card with limits and tonnes is one table"

if "$TIPSPEED" -c version | grep -q 'without cairo'; then
	"$TIPSPEED" data/sites/tierp.csv -c 'report > a.pdf' >out.txt 2>err.txt
	[ $? = 2 ] && grep -q 'hint: > FILE.html works' err.txt && [ ! -e a.pdf ]
	result $? "without cairo: no paper"
else
	for i in 1 2; do
		"$TIPSPEED" data/sites/tierp.csv -c calibrate \
			-c 'report > a.pdf' >out.txt 2>err.txt
		mv a.pdf "$i.pdf"
		sleep 1
	done
	[ "$(head -c 5 1.pdf)" = %PDF- ] && cmp 1.pdf 2.pdf &&
		grep -q 'wrote a.pdf: .* images, [5-9] pages' err.txt
	result $? "on paper it is the same bytes a second later"
	"$TIPSPEED" data/sites/tierp.csv \
		-c 'params set f_mat=2.18 e0_min=16.74 alpha=0.96' \
		-c 'card speeds=50..100:1 tph=120 fractions=0/2,2/5,5/8 > a.pdf' \
		-c 'sweep > b.pdf; card > upright.pdf' \
		-c 'card "passing 2 > 30" tph=120 fractions=0/0.25,0.25/0.5,0.5/1,1/2,2/4,4/5.6,5.6/8,8/11.2,11.2/16 > across.pdf' \
		2>err.txt &&
		grep -q 'wrote across.pdf: 1 table, 1 page$' err.txt &&
		grep -q 'wrote a.pdf: 1 table, 1 page$' err.txt &&
		grep -q 'wrote b.pdf: 1 table, 1 page$' err.txt
	result $? "a card is one page, and so is any answer that is short"
	grep -aq 'MediaBox \[ 0 0 595' upright.pdf &&
		grep -aq 'MediaBox \[ 0 0 84[12]' across.pdf
	result $? "a card that is wide is turned, for larger letters"
fi

browser=$(command -v chromium || command -v chromium-browser)
if [ -n "$browser" ]; then
	timeout 60 "$browser" --headless --no-sandbox --disable-gpu \
		--user-data-dir="$dir/browser" --print-to-pdf=printed.pdf \
		--dump-dom "file://$dir/was.html" >dom.html 2>err.txt
	[ "$(grep -c '<tr' dom.html)" = "$(grep -c '<tr' was.html)" ] &&
		[ "$(grep -c '<svg' dom.html)" = "$(grep -c '<svg' was.html)" ]
	result $? "a browser shows all of it"
else
	n=$((n + 1))
	echo "ok $n - a browser shows all of it # SKIP no chromium here"
fi
finish
