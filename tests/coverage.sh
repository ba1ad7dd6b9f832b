#!/bin/sh
# A few plants of each law of bench/coverage, of which most do not follow the
# model: the 80 % band holds the true product, and the answer errs less than
# interpolation.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
plants=$(often 0 200)
if [ "$plants" -eq 0 ] && [ -z "${TIPSPEED_TEST_LONG:-}" ]; then
	echo '1..0 # SKIP counted in make check-long'
	exit 0
fi
scratch
bench/coverage $((plants > 0 ? plants : 1)) >"$dir/out"
status=$?
sed -n 's/^not ok //p; s/^ok //p' "$dir/out" >"$dir/lines"
while read -r line; do
	grep -q "^ok $line" "$dir/out"
	result $? "$line"
done <"$dir/lines"
[ $status -eq 0 ] && [ "$(grep -c . "$dir/lines")" -eq 3 ]
result $? "three speeds were counted"
remark "$dir/out"
# At the count of tipspeed-model(7): shares held, errors and lights are its own.
if [ "$plants" -eq 200 ]; then
	awk '/\+-/ {
		n = split(substr($0, 33), v)
		law = substr($0, 1, 32)
		sub(/ *$/, "", law)
		print law " Ta " v[1] " " v[2] " " v[3] " Ta " v[4] " " v[5] " " v[6]
		print law " Ta " v[10] " " v[11] " " v[12] " Ta " v[13] " " v[14] \
		    " " v[15] " Ta " v[16] " " v[17] " " v[18]
		print law " " v[n - 4] " " v[n - 3] " " v[n - 2] " " v[n - 1] " " v[n]
	}' "$dir/out" >"$dir/rows"
	tr -s ' ' <"$srcdir/man/tipspeed-model.7.in" | sed 's/^\.It //' >"$dir/page"
	grep -vxFf "$dir/page" "$dir/rows" >"$dir/missing"
	[ -s "$dir/rows" ] && [ ! -s "$dir/missing" ]
	result $? "tipspeed-model(7) has these counts"
	remark "$dir/missing"
fi
finish
