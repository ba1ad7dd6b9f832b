#!/bin/sh
# Plots written to files: each is of its kind and says where its data are from.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$dir" || exit 99
kinds='psd parity convergence spread residuals selection appearance map sweep'
for kind in $kinds; do
	for form in svg png pdf txt csv; do
		echo "plot $kind > $kind.$form"
	done
done >all.tip
"$TIPSPEED" data/sites/tierp.csv \
	-c 'calibrate population=50 generations=26 polish=off > fit.txt' \
	-f all.tip >out.txt 2>err.txt
result $? "every kind is written in every form"

bad=
for kind in $kinds; do
	if command -v xmllint >/dev/null; then
		xmllint --noout "$kind.svg" || bad="$bad $kind"
	else
		[ "$(grep -c '^<svg\|^</svg>' "$kind.svg")" = 2 ] ||
			bad="$bad $kind"
	fi
	grep -q '>data: .*drawn by tipspeed [0-9]' "$kind.svg" ||
		bad="$bad $kind"
done
result ${#bad} "SVG is well formed and names its data and program:$bad"

bad=
for kind in $kinds; do
	[ "$(head -c 4 "$kind.png" | tail -c 3)" = PNG ] || bad="$bad $kind"
	[ "$(head -c 5 "$kind.pdf")" = %PDF- ] || bad="$bad $kind"
	[ "$(wc -c <"$kind.png")" -gt 20000 ] || bad="$bad $kind"
done
result ${#bad} "PNG and PDF are such:$bad"

grep -q 'reconstructed from Table 3, not measured' psd.svg &&
	grep -q 'passing, %' psd.svg && grep -q 'size, mm' psd.svg
result $? "psd: provenance, axes with units"
bad=
for sieve in 0.063 0.125 0.25 0.5 1 2 4 5.6 8 11.2 16 22.4; do
	grep -q ">$sieve</text>" psd.svg || bad="$bad $sieve"
done
result ${#bad} "psd: every sieve has its label:$bad"
! grep -l "$(printf '\033')" ./*.txt >/dev/null
result $? "no escape in a text file, whatever the terminal"

sed 's/Tierp/<\&Tierp/' data/sites/tierp.csv >odd.csv
"$TIPSPEED" odd.csv -c 'plot psd > odd.svg' 2>err.txt &&
	grep -q '&lt;&amp;Tierp' odd.svg
result $? "a name of marks does no harm to SVG"

echo kept >kept.svg
"$TIPSPEED" data/sites/tierp.csv -c 'predict > kept.svg' 2>err.txt
[ $? = 2 ] && grep -q 'draws nothing' err.txt && grep -q kept kept.svg
result $? "a table does not go into a picture's file"
"$TIPSPEED" data/sites/tierp.csv -c 'plot psd >> kept.svg' 2>err.txt
[ $? = 2 ] && grep -q 'cannot be added' err.txt && grep -q kept kept.svg
result $? "a picture is not added to another"
finish
