#!/bin/sh
# Builds tests/fuzz/fuzz by clang in the folder fuzz, and lets each reader run for
# FUZZ_SECONDS, several side by side: all of them, or those named in FUZZ_READERS.
# A file of up to 64 kB that takes longer than 10 s is a finding, too.  What is found
# stays in fuzz/new (files that reach new code) and fuzz/found
# (crashes, leaks, hangs).  Fails where something was found.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
: "${srcdir:=.}" "${CLANG:=clang}" "${FUZZ_SECONDS:=30}"
srcdir=$(cd "$srcdir" && pwd)
corpus=$srcdir/tests/fuzz/corpus
jobs=$(nproc 2>/dev/null || echo 2)
mkdir -p fuzz/found && cd fuzz || exit 5
echo 'int LLVMFuzzerTestOneInput(void);
int LLVMFuzzerTestOneInput(void) { return 0; }' >probe.c
"$CLANG" -fsanitize=fuzzer probe.c -o probe 2>probe.log || {
	echo "fuzz: $CLANG with libFuzzer is missing; on Debian: apt-get install" \
		"clang libclang-rt-dev" >&2
	exit 5
}
if [ ! -f Makefile ]; then
	"$srcdir/configure" CC="$CLANG" --enable-sanitize \
		CFLAGS='-O1 -g -fsanitize=fuzzer-no-link' >configure.log || exit
fi
make -j"$jobs" tests/fuzz/fuzz >build.log || exit

if [ -z "${FUZZ_READERS:-}" ]; then
	FUZZ_READERS=$(ls "$corpus")
fi
TMPDIR=$(mktemp -d)
export TMPDIR srcdir corpus FUZZ_SECONDS
trap 'rm -rf "$TMPDIR"' EXIT
# shellcheck disable=SC2016,SC2086
printf '%s\n' $FUZZ_READERS | xargs -P "$jobs" -I READER sh -c '
	mkdir -p new/$1
	TIPSPEED_FUZZ=$1 tests/fuzz/fuzz -max_total_time="$FUZZ_SECONDS" \
		-max_len=65536 -timeout=10 -rss_limit_mb=1024 -close_fd_mask=3 \
		-print_final_stats=1 -artifact_prefix=found/$1- \
		new/$1 "$corpus/$1" >$1.log 2>&1 </dev/null
	status=$?
	sed -n "s/^stat::number_of_executed_units: */$1: runs /p" $1.log
	[ $status -eq 0 ] || { tail -n 50 $1.log; exit 1; }' sh READER
