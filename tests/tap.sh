# Helpers of the shell tests: TAP on standard output.  Sourced, not run.
# SPDX-License-Identifier: GPL-3.0-or-later
n=0
bad=0

# result STATUS NAME: one test point.
result() {
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then
		printf 'ok %d - %s\n' $n "$2"
	else
		printf 'not ok %d - %s\n' $n "$2"
		bad=$((bad + 1))
	fi
}

# Lines of a file as TAP remarks.
remark() { sed 's/^/# /' "$1"; }

finish() {
	echo "1..$n"
	[ "$bad" -eq 0 ]
	exit $?
}

# often FEW MANY: how often a test repeats what it tries, FEW times in `make check`,
# MANY in `make check-long`.  TIPSPEED_TEST_LONG says how far between, 0 to 1.
often() {
	awk -v few="$1" -v many="$2" -v share="${TIPSPEED_TEST_LONG:-0}" 'BEGIN {
		share += 0
		print few + int((many - few) * (share < 1 ? share : 1)) }'
}

# wide_sheet: 1,900 sieves and 200 runs, which take a second to read.
wide_sheet() {
	awk 'BEGIN {
		printf "size_mm,feed"
		for (k = 0; k < 200; k++)
			printf ",product@%g", 60 + k / 10
		print ""
		for (i = 0; i < 1900; i++) {
			printf "%.6g,%.5g", 22.4 * exp(-i * log(355) / 1899), 100 - i / 20
			for (k = 0; k < 200; k++)
				printf ",%.5g", 100 - i / 21
			print ""
		}
	}'
}

# A folder of its own, with data/ as the shipped one.
scratch() {
	dir=$(mktemp -d) || exit 99
	trap 'rm -rf "$dir"' EXIT
	ln -s "$(cd "$srcdir" && pwd)/data" "$dir/data"
	# The store goes there too, and not to the home of whoever tests.
	XDG_DATA_HOME=$dir/share
	export XDG_DATA_HOME
	# Under sanitizers: fontconfig keeps what it found to the end of the
	# program, and not where it may write no cache.
	echo leak:libfontconfig >"$dir/leaks"
	# A day that does not pass: 2026-11-25.
	SOURCE_DATE_EPOCH=1795564800
	export SOURCE_DATE_EPOCH
	LSAN_OPTIONS=suppressions=$dir/leaks:print_suppressions=0
	export LSAN_OPTIONS
}

srcdir=${srcdir:-.}
TIPSPEED=${TIPSPEED:-$(pwd)/tipspeed}
