#!/bin/sh
# A public data set of another machine and material, with odd sieves: it loads,
# calibrates and validates, and is told that the fit is poor.  The data are not
# part of the project; without them the test is skipped.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
D=${TIPSPEED_SPRITE:-$srcdir/../shared/data}
if [ ! -f "$D/sprite-jrs-feed.csv" ]; then
	echo "1..0 # SKIP the data set is not here"
	exit 0
fi
scratch
# convert SCREEN: a site file of the three speeds with that screen.
convert() {
	printf 'site,Corn stalk %s\n' "$1"
	echo 'provenance,knife mill and corn stalk: neither VSI nor rock'
	awk -F, -v screen="$1" '
	/^#/ || /size_mm/ { next }
	FILENAME ~ /feed/ { feed[$1] = $2; seen[$1]; next }
	$4 == screen && $3 == 20 && $5 > 0 {
		product[$2, $5] = $6; seen[$5]
		if (!($2 in speed)) { speed[$2]; order[++n] = $2 }
	}
	END {
		printf "999,size_mm,feed_fraction"
		for (i = 1; i <= n; i++)
			printf ",product_fraction@%s", order[i]
		print ""
		for (x in seen) {
			printf "%s,%s,%s", x, x, feed[x]
			for (i = 1; i <= n; i++)
				printf ",%s", product[order[i], x]
			print ""
		}
	}' "$D/sprite-jrs-feed.csv" "$D/sprite-jrs-products.csv" |
		sort -t, -k1,1gr | cut -d, -f2-
}
for screen in 12.7 $([ "$(often 0 1)" -eq 0 ] || echo 19.05); do
	convert $screen >"$dir/sprite.csv"
	"$TIPSPEED" "$dir/sprite.csv" -c 'set correction train' -c calibrate \
		-c validate -c 'predict band=on' >"$dir/out" 2>"$dir/log"
	result $? "screen $screen: loads, calibrates and validates"
	remark "$dir/log"
	grep -q '^warning: trust: red: the fit is poor' "$dir/out"
	result $? "screen $screen: the fit is called poor, the light is red"
	grep -q '^no uncertainty band: the fit is poor' "$dir/out"
	result $? "screen $screen: two speeds of a poor fit give no band"
	grep -q 'at 8.168 m/s: at worst' "$dir/out"
	result $? "screen $screen: the middle speed is held out"
	# Each speed asked for from the two others.
	"$TIPSPEED" "$dir/sprite.csv" -c 'validate holdout=each' \
		>"$dir/out" 2>"$dir/log"
	tr '\n' ' ' <"$dir/out" |
		grep -o '[0-9]* of [0-9]* sieves lie in the\|no band: the fit is poor' |
		awk '{ n++ } /sieves/ { bad += $1 < 0.7 * $3 }
		END { exit !(n == 3 && bad == 0) }'
	result $? "screen $screen: bands hold 70 % of the sieves, or there is none"
done
finish
