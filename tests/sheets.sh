#!/bin/sh
# Sheets of real programs and of many hands, in tests/sheets, come to what LIST says.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
cd "$srcdir/tests/sheets" || exit 99

# same A B: two site files as `write` writes them say the same: roles, speeds to
# 0.06 m/s, sieves to 0.6 %, passings to 0.15 points, and the same empty cells.
same() {
	awk -F , -v a="$1" -v b="$2" '
	function read_site(file, cell, line, i, on) {
		rows = 0
		while ((getline line < file) > 0) {
			on = on || line ~ /^size_mm/
			if (!on || line == "")
				continue
			columns = split(line, part, ",")
			for (i = 1; i <= columns; i++)
				cell[rows, i] = part[i]
			rows++
		}
		close(file)
		return rows * 100 + columns
	}
	function far(x, y, most) { return x - y > most || y - x > most }
	function unlike(x, y, r, c, p, q) {
		if (r == 0) {
			split(x, p, "@")
			split(y, q, "@")
			return p[1] != q[1] || far(p[2], q[2], 0.06)
		}
		if (x == "" || y == "")
			return x != y
		return far(x, y, c == 1 ? 0.006 * y : 0.15)
	}
	BEGIN {
		shape = read_site(a, x)
		if (shape != read_site(b, y)) {
			print "not as many rows or columns as in " b
			exit 1
		}
		for (r = 0; r < rows; r++)
			for (c = 1; c <= columns; c++)
				if (unlike(x[r, c], y[r, c], r, c)) {
					print x[0, c] " in row " r ": " \
						x[r, c] ", not " y[r, c]
					bad = 1
				}
		exit bad
	}'
}

# product ARGUMENTS: what is predicted at 72 m/s, as a site file.
product() {
	"$TIPSPEED" --store=:memory: --format=csv -c "load $1" \
		-c 'params set f_mat=2.18 e0_min=16.74 alpha=0.96' \
		-c 'predict 72' 2>>"$dir/log" | awk -F , '
		$1 == "command" { for (i = 1; i <= NF; i++) at[$i] = i
			print "size_mm,feed,product@72" }
		$1 == "predict" { print $at["sieve_mm"] "," $at["feed_pct"] "," \
			$at["passing_pct"] }'
}

# as_said ARGUMENTS FILE: loaded, and the same as the file.
as_said() {
	rm -f "$dir/got.csv"
	"$TIPSPEED" --store=:memory: -c "load $1" \
		-c "write $dir/got.csv" >"$dir/log" 2>&1 &&
		same "$dir/got.csv" "$2" >>"$dir/log"
}

# asked ARGUMENTS WORD: a question that the word answers, and nothing else.
asked() {
	"$TIPSPEED" --store=:memory: -c "load $1" >"$dir/log" 2>&1
	[ $? -eq 3 ] && grep -q 'hint: ' "$dir/log" && grep -q "$2" "$dir/log"
}

questions='columns=\|decimal=\|rotor_mm=\|sheet=\|range='
listed=0
while IFS='|' read -r arguments expected; do
	case $arguments in '#'* | '') continue ;; esac
	arguments=${arguments% }
	set -- $expected
	listed=$((listed + 1))
	case $1 in
	=) as_said "$arguments" "$2" ;;
	'?') as_said "$arguments" "$2" ||
		{ [ ! -f "$dir/got.csv" ] && asked "$arguments" "$questions"; } ;;
	'~') as_said "$arguments" "$2" ||
		{ [ ! -f "$dir/got.csv" ] && asked "$arguments" .; } ;;
	asks) asked "$arguments" "$2" ;;
	refuses) asked "$arguments" . ;;
	*) false ;;
	esac
	result $? "$arguments:$expected"
	[ "$bad" -eq "${was:-0}" ] || remark "$dir/log"
	was=$bad
	case $arguments in habit-*) [ "$1" = = ] || continue ;; *) continue ;; esac
	product "$arguments" >"$dir/product"
	cp "$2" "$dir/is.csv"
	product "$dir/is.csv" >"$dir/wanted"
	[ -s "$dir/product" ] && same "$dir/product" "$dir/wanted" >"$dir/log"
	result $? "$arguments: the product at 72 m/s"
	[ "$bad" -eq "$was" ] || remark "$dir/log"
	was=$bad
done <LIST
[ "$listed" -ge 60 ]
result $? "there are 60 sheets or more"
for f in *.csv *.txt *.xlsx *.ods; do
	grep -q "^\([^|]* \)*$f[ @]" LIST || echo "$f"
done >"$dir/log"
[ ! -s "$dir/log" ]
result $? "every sheet is listed"
remark "$dir/log"
finish
