#!/bin/sh
# Every shipped site, every other one in make check: from the first seed of the search
# the bits of tests/golden/calibrate, and a predicted curve at the held-out speed within
# the stated sampling noise of the curve that the site was made from; no cell is taken
# for a mistake.  A ninth of them, all in the long tests: the same misfit from other
# seeds, and the same answers to the last bit.
# `make renew-seeds` writes the bits anew: a change of them wants a reason.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
seeds=$(often 2 10) third=$(often 9 1) every=$(often 2 1) at=0
[ "${RENEW:-}" != 1 ] || every=1
golden=$srcdir/tests/golden/calibrate
[ "${RENEW:-}" != 1 ] || golden=$dir/golden
# The sessions of one site: all seeds found the same, and answered the same.
same_from_all() {
	sed -n 's/.*"command":"calibrate".*"misfit":\([^,]*\),.*/\1/p' \
		"$dir/out" | awk -v want="$seeds" '
		NR == 1 { low = high = $1 }
		$1 < low { low = $1 }
		$1 > high { high = $1 }
		END { printf "# misfit %.9g .. %.9g over %d seeds\n",
			low, high, NR
		    exit !(NR == want && low > 0 && high <= low * (1 + 1e-6)) }'
	result $? "$name: the same misfit from $seeds seeds"
	grep -E '"command":"(predict|find)"' "$dir/out" | sort | uniq -c |
		awk -v want="$seeds" '$1 != want { print "# " substr($0, 1, 300) }
			$1 == want { n++ }
			END { exit !(n == 3 && NR == 3) }'
	result $? "$name: the same answers from $seeds seeds"
}

for f in "$dir"/data/sites/*.csv; do
	name=$(basename "$f" .csv)
	made=$(sed -n 's/^provenance.*\(f_mat [0-9.]*\), \(E0_min [0-9.]*\), \(alpha [0-9.]*\),.*/\1 \2 \3/p' "$f" |
		sed 's/E0_min/e0_min/; s/\([a-z]\) \([0-9]\)/\1=\2/g')
	made="params set beta1=0 beta2=1 beta3=-1 beta4=0.5 $made"
	at=$((at + 1)) many=1
	[ $(((at + 1) % every)) -eq 0 ] || continue
	if [ $((at % third)) -eq 0 ]; then
		many=$seeds
		p80=$("$TIPSPEED" --format=json "$f" -c "$made" -c 'predict 74' \
			2>"$dir/log" |
			sed -n 's/.*"p80_mm":\([^,]*\),.*/\1/p' | tail -n 1)
	fi
	i=0
	while [ $i -lt "$many" ]; do
		i=$((i + 1))
		echo "calibrate seed=$i"
		[ "$many" -gt 1 ] || continue
		echo 'predict 72'
		echo 'predict 85'
		echo "find p80=$p80"
	done >"$dir/script"
	for what in check 'set format csv' 'predict 74 band=off' "$made" 'predict 74'; do
		echo "$what"
	done >>"$dir/script"
	"$TIPSPEED" --format=json "$f" <"$dir/script" >"$dir/out" 2>"$dir/log" ||
		remark "$dir/log"
	[ "$many" -eq 1 ] || same_from_all
	sed -n 's/.*"seed":1,.*\("misfit":[^,]*\),.*\("params":{[^}]*}\).*/\1 \2/p' \
		"$dir/out" | sed "s/^/$name /" >"$dir/bits"
	[ "${RENEW:-}" != 1 ] || cat "$dir/bits" >>"$golden"
	grep "^$name " "$golden" | diff - "$dir/bits" \
		>"$dir/diff" && [ -s "$dir/bits" ]
	result $? "$name: the bits of what is found"
	remark "$dir/diff"
	grep -q '"command":"check"' "$dir/out" &&
		! grep -q 'digits transposed\|from the fit\|is expected' "$dir/out"
	result $? "$name: nothing in it is suspected"
	grep '^predict,' "$dir/out" | awk -F, '
		$(NF - 5) in found { d = $(NF - 3) - found[$(NF - 5)]
			sum += d * d; n++; next }
		{ found[$(NF - 5)] = $(NF - 3) }
		END { printf "# RMSE to the true curve %.3f points, %d sieves\n",
			sqrt(sum / n), n
		    exit !(n >= 9 && sqrt(sum / n) <= 0.5) }'
	result $? "$name: the held-out curve within the noise"
done
[ "${RENEW:-}" != 1 ] || cp "$golden" "$srcdir/tests/golden/calibrate"
finish
