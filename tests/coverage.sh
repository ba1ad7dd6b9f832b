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
finish
