#!/bin/sh
# What an installed program finds by itself, from an empty folder: its sites by
# their names.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
${MAKE:-make} install "DESTDIR=$dir/root" >"$dir/log" 2>&1
result $? "make install below another root"
program=$(find "$dir/root" -type f -name tipspeed -perm -100 | head -n 1)
[ -n "$program" ] || { remark "$dir/log"; finish; }
mkdir "$dir/empty"
cd "$dir/empty" || exit 99

"$program" -c 'load tierp Bro' -c 'save s.tip' >out 2>err
result $? "load finds shipped sites by name"
remark err
grep -q "^load $dir/root/.*/tierp.csv digest=" s.tip
result $? "the session has the file that was read"
"$program" -f s.tip -c sites 2>&1 | grep -q '\*bro  *Bro'
result $? "and can be run again"
(cd / && "$program" tierp -c sites 2>&1) | grep -q '\*tierp'
result $? "on the command line, too"
cp "$dir/data/sites/atle.csv" tierp
"$program" -c 'load tierp' 2>&1 | grep -q '^loaded Atle'
result $? "a file of that name comes first"
for name in tierp.csv ../tierp ./bro nowhere; do
	"$program" -c "load $name" >out 2>err
	[ $? -eq 5 ] && grep -q "$name: cannot read" err
	result $? "$name is a file, and is not there"
done
"$program" --safe -c 'load bro' 2>&1 | grep -q '^-c:1:1: load is off'
result $? "--safe has names off as files"
finish
