#!/bin/sh
# Plots written to files: each is of its kind and says where its data are from.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
if "$TIPSPEED" -c version | grep -q 'without cairo'; then
	"$TIPSPEED" data/sites/tierp.csv -c 'plot psd speed=69 > a.svg' \
		-c 'plot psd speed=69 > a.png' >out.txt 2>err.txt
	[ $? = 2 ] && grep -q 'draws svg (built without cairo), not png' err.txt &&
		[ -s a.svg ] && [ ! -e a.png ]
	result $? "without cairo: svg is drawn, png refused"
	finish
fi
kinds='psd parity convergence spread residuals selection appearance map sweep
response profile correlation'
for kind in $kinds; do
	for form in svg png pdf txt csv; do
		echo "plot $kind > $kind.$form"
	done
done >all.tip
"$TIPSPEED" data/sites/tierp.csv \
	-c 'calibrate population=50 generations=26 polish=off > fit.txt' \
	-f all.tip >out.txt 2>err.txt
result $? "every kind is written in every form"

wrong=
for kind in $kinds; do
	if command -v xmllint >/dev/null; then
		xmllint --noout "$kind.svg" || wrong="$wrong $kind"
	else
		[ "$(grep -c '^<svg\|^</svg>' "$kind.svg")" = 2 ] ||
			wrong="$wrong $kind"
	fi
	tr '\n' ' ' <"$kind.svg" | grep -q '>data: .*drawn by tipspeed [0-9]' ||
		wrong="$wrong $kind"
done
result ${#wrong} "SVG is well formed and names its data and program:$wrong"

wrong=
for kind in $kinds; do
	[ "$(head -c 4 "$kind.png" | tail -c 3)" = PNG ] || wrong="$wrong $kind"
	[ "$(head -c 5 "$kind.pdf")" = %PDF- ] || wrong="$wrong $kind"
	[ "$(wc -c <"$kind.png")" -gt 20000 ] || wrong="$wrong $kind"
done
result ${#wrong} "PNG and PDF are such:$wrong"

# A figure for a column of a journal is as wide as that, its letters are readable,
# and nothing begins beyond its edge or is larger than it.
"$TIPSPEED" data/sites/tierp.csv -c 'calibrate population=50 generations=26' \
	-c 'set figure_mm 85' -c 'plot psd speed=74 band=on > column.svg' \
	-c 'predict 74 > predict.svg' -c 'plot response > response85.svg' \
	-c 'plot correlation > correlation85.svg' -c 'plot psd > column.pdf' \
	-c 'set figure_mm 170' -c 'plot runs > page.svg' >out.txt 2>err.txt
result $? "figures are drawn for a column and a page"
wrong=
for figure in column predict response85 correlation85; do
	grep -q '^<svg.* width="241pt"' $figure.svg || wrong="$wrong $figure"
	tr '<' '\n' <$figure.svg | awk -F '"' '/^text / && !/rotate/ {
		split($0, part, ">")
		letters = length(part[2])
		size = $6
		from = $2 - ($8 == "middle" ? 0.5 : $8 == "end") * letters * size / 2
		if (from < 0 || from + letters * size / 2 > 245 ||
			size < 5 || size > 9) {
			print "'$figure': " $0
			bad = 1
		}
	}
	END { exit bad }' >>err.txt || wrong="$wrong $figure"
done
grep -q '^<svg.* width="482pt"' page.svg || wrong="$wrong page"
! command -v pdfinfo >/dev/null || pdfinfo column.pdf |
	grep -q '^Page size: *241 x' || wrong="$wrong pdf"
result ${#wrong} "they are 85 and 170 mm wide, and all of them can be read:$wrong"
remark err.txt
"$TIPSPEED" data/sites/tierp.csv -c 'plot psd width=60 > narrow.svg' 2>err.txt
grep -q 'figure_mm' err.txt
result $? "width=, of text, is said to be so"

"$TIPSPEED" data/sites/borlange.csv -c calibrate -c 'predict 72 > one.svg' \
	-c 'plot psd speed=72 band=on > two.svg' \
	-c 'predict 72 band=off > three.svg' -c 'predict 72 > four.png' \
	>out.txt 2>err.txt &&
	cmp one.svg two.svg && ! cmp -s one.svg three.svg &&
	[ "$(head -c 4 four.png | tail -c 3)" = PNG ] && ! grep 'product at' out.txt
result $? "predict draws what plot psd draws, and prints nothing beside it"
"$TIPSPEED" data/sites/bro.csv -c 'sweep > sweep.png' 2>err.txt
[ $? = 2 ] && grep -q 'hint: use plot sweep > sweep.png' err.txt
result $? "a command that draws nothing names the plot that does"

grep -q 'reconstructed from Table 3, not measured' psd.svg &&
	grep -q 'passing, %' psd.svg && grep -q 'size, mm' psd.svg
result $? "psd: provenance, axes with units"
wrong=
for sieve in 0.063 0.125 0.25 0.5 1 2 4 5.6 8 11.2 16 22.4; do
	grep -q ">$sieve</text>" psd.svg || wrong="$wrong $sieve"
done
result ${#wrong} "psd: every sieve has its label:$wrong"
awk 'BEGIN { print "site,Fine\nrock,Gneiss\nsize_mm,feed"
	for (i = 0; i < 64; i++) {
		x = 500 * exp(-i * log(500000) / 63)
		printf "%.4g,%.3f\n", x, i == 0 ? 100 : 100 * x / (x + 60)
	} }' >fine.csv
"$TIPSPEED" fine.csv -c 'plot psd > fine.svg' 2>err.txt
awk -F '"' '/font-size="8.0" text-anchor="middle"/ {
	split($0, part, /[<>]/)
	half = 5.09 * length(part[3]) / 2
	if (n[$4]++ && $2 - half < end[$4])
		print "", part[3]
	end[$4] = $2 + half
}' fine.svg >touching
[ -s fine.svg ] && [ ! -s touching ]
result $? "labels of 64 sieves do not touch:$(tr -d '\n' <touching)"
! grep -l "$(printf '\033')" ./*.txt >/dev/null
result $? "no escape in a text file, whatever the terminal"

TERM=xterm-256color "$TIPSPEED" --color=always data/sites/tierp.csv \
	-c 'plot psd' 2>err.txt | grep -q "$(printf '\033')"
[ $? = 1 ]
result $? "nor in a pipe"

"$TIPSPEED" data/sites/tierp.csv -c calibrate -c 'screen > screen.svg' \
	-c 'screen > screen.png' -c 'screen > screen.pdf' \
	-c 'screen > screen.txt' >out.txt 2>err.txt
result $? "the full screen is written in every form"
if command -v xmllint >/dev/null; then
	xmllint --noout screen.svg
	result $? "its SVG is well formed"
fi
grep -q '<title>tipspeed, .*Tierp, Granite, 11.2 mm at 74.0 m/s<' screen.svg &&
	grep -q '<desc>.*Data: reconstructed from Table 3, not' screen.svg &&
	grep -q '>\[74.0\]<' screen.svg && grep -q '\[74.0\]' screen.txt
result $? "says what it shows, and has its words"
[ "$(head -c 4 screen.png | tail -c 3)" = PNG ] &&
	[ "$(head -c 5 screen.pdf)" = %PDF- ]
result $? "PNG and PDF of it are such"

sed 's/Tierp/<\&Tierp/' data/sites/tierp.csv >odd.csv
"$TIPSPEED" odd.csv -c 'plot psd > odd.svg' 2>err.txt &&
	grep -q '&lt;&amp;Tierp' odd.svg
result $? "a name of marks does no harm to SVG"

# A form feed, C1, U+FFFE, U+FFFF and a mark of direction.
printf 'site,Q\302\233\302\237\357\277\276Z\nrock,x\014y\nprovenance,a\342\200\256b\357\277\277\n' \
	>odd.csv
sed -n '/^size/,$p' data/sites/tierp.csv >>odd.csv
wrong=
for c in 'plot psd' 'screen width=60 height=16'; do
	"$TIPSPEED" odd.csv -c "$c > odd.svg" -c "$c > odd.pdf" -c "$c > odd.png" \
		2>err.txt || wrong="$wrong $c"
	grep -q 'Q\\u009b\\u009f\\ufffeZ, x\\x0cy' odd.svg || wrong="$wrong $c"
	[ "$(LC_ALL=C tr -d '\n -~\200-\377' <odd.svg | wc -c)" = 0 ] || wrong="$wrong $c"
	LC_ALL=C grep -q "$(printf '\302[\200-\237]\|\357\277[\276\277]\|\342\200\256')" \
		odd.svg && wrong="$wrong $c"
	if command -v xmllint >/dev/null; then
		xmllint --noout odd.svg || wrong="$wrong $c"
	fi
	[ "$(head -c 5 odd.pdf)" = %PDF- ] && [ "$(wc -c <odd.png)" -gt 10000 ] ||
		wrong="$wrong $c"
done
result ${#wrong} "what XML forbids is shown in SVG, and drawn in PDF and PNG:$wrong"

echo kept >kept.svg
"$TIPSPEED" data/sites/tierp.csv -c 'validate > kept.svg' 2>err.txt
[ $? = 2 ] && grep -q 'cannot make an image' err.txt && grep -q kept kept.svg
result $? "a table does not go into a picture's file"
"$TIPSPEED" data/sites/tierp.csv -c 'plot psd >> kept.svg' 2>err.txt
[ $? = 2 ] && grep -q 'cannot be appended' err.txt && grep -q kept kept.svg
result $? "a picture is not added to another"

finish
