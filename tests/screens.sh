#!/bin/sh
# What the program draws of its full screen is what was looked at: the screens in
# tests/screens, the text in README and its picture.
# `make renew` writes them anew: look at the difference.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
srcdir=$(cd "$srcdir" && pwd)
cd "$dir" || exit 99
LC_ALL=C.UTF-8
export LC_ALL
unset NO_COLOR TIPSPEED_COLOR

# compare NAME OLD NEW: the old file is like the new one, or becomes it.
compare() {
	[ "${RENEW:-}" != 1 ] || cp "$3" "$2"
	diff "$2" "$3" >difference 2>&1
	same=$?
	result $same "$1"
	[ $same -eq 0 ] || { remark difference; echo "# make renew"; }
}

# Names of digits alone are those of tests/tui.sh, from a real terminal.
mkdir screens
echo mine >mine.csv
printf '%s\n' site,Norra rock,Granite size_mm,feed 22.4,100 16,90 8,52 4,28 \
	1,7 >norra.csv
head='size_mm,feed,product@69,product@79'
printf '%s\n' site,Mixed "$head" 8,100,100,100 4,50,80,70 >mixed.csv
printf '%s\n' "$head" 8,100,99.5,100 4,5O,8O,90 >faults.csv
printf '%s\n' site,Mill rock,Granite top_size_mm,40 \
	size_mm,feed,product@6.5,product@8.2,product@9.8 80,100,100,100,100 \
	31.5,70.9,88.2,92.8,94.5 16,36,56.9,67.5,72.4 8,18,29.4,38.6,44.5 \
	4,9,14.7,19.9,24.1 2,4.5,6.7,9.9,12.4 1,2.3,3.7,5.4,6.1 >mill.csv
printf '%s\n' site,Boulders rock,Gneiss size_mm,feed,product@69,product@79 \
	500,100,100,100 300,90,95,96 150,60,70,75 63,25,33,38 20,7,11,14 >boulders.csv
printf '%s\n' site,Poor size_mm,feed,product@69,product@79 22.4,100,100,100 \
	11.2,90,92.5,97.5 5.6,45,60,65 2,16,20,34 0.5,5,9,8 0.063,0.5,0.9,1.4 \
	>poor.csv
printf '%s\n' site,Twice size_mm,feed,product@69,product@69,product@79 \
	22.4,100,100,100,100 8,63,93,93.4,94.1 4,31,59.6,60.3,69 2,15,30.2,30.6,36 \
	0.5,3.5,7,7.3,9.2 0.063,0.4,0.9,0.9,1.2 >twice.csv
printf '%s\n' 'Sikt (mm);Ingående;Produkt 1;Produkt 2' '11,2;100;100;100' \
	'8;62,1;75,0;78,1' '5,6;40;55;60' '4;25;42;48' '1;5;15;19' >open.csv
{
	echo 'Sieve mm;Feed;Product 1;Product 2;Product 3;Product 4;Product 5'
	printf '%s\n' '8;100;100;100;100;100;100' '4;50;60;62;64;66;68' \
		'1;5;11;12;13;14;15'
} >many.csv
printf '%s\n' 'Sieve (mm),Feed,Product 1464 rpm,Product 1676 rpm' \
	8,100,100,100 4,50,70,80 1,5,12,15 >rpm.csv
"$TIPSPEED" -f "$srcdir/tests/screens.tip" >out 2>log
good=$?
remark log >all
[ $good -eq 0 ] || cat all
result $good "every screen is drawn"
[ "${RENEW:-}" != 1 ] || rm -f "$srcdir"/tests/screens/[a-z]*
for screen in screens/*; do
	name=${screen#screens/}
	compare "screen $name" "$srcdir/tests/screens/$name" "$screen"
done
for golden in "$srcdir"/tests/screens/[a-z]*; do
	[ -e "screens/${golden##*/}" ] && continue
	result 1 "screen ${golden##*/} is drawn by tests/screens.tip"
done

cat >readme.tip <<'END'
load data/sites/tierp.csv
calibrate
screen width=80 height=24 charset=ascii > text
screen > workbench.svg
END
"$TIPSPEED" -f readme.tip >out 2>log
result $? "the screens of README are drawn"
# The text stands behind the line that names its command, and a blank one.
awk 'FILENAME == "text" { text[++n] = $0; next }
	at > 1 && at <= n + 1 { print "    " text[at++ - 1]; next }
	at == 1 { at = 2 } /`screen width=80 height=24` is the text/ { at = 1 }
	{ print }' text "$srcdir/README.md" >README.md
compare "README has the text of the screen" "$srcdir/README.md" README.md
compare "and its picture" "$srcdir/doc/workbench.svg" workbench.svg
finish
