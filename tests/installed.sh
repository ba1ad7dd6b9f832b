#!/bin/sh
# What an installed program finds by itself, from an empty folder: its sites by
# their names.  What its package wants to be built.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
here=$(pwd)
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
# The script of the paper: to its first picture, in the long tests all of it.
mkdir "$dir/paper"
paper=$(find "$dir/root" -name paper.tip)
made=16
if [ "$(often 0 100)" -eq 0 ]; then
	made=2
	sed '/^calibrate/,$d' "$paper" >paper.tip
	paper=$PWD/paper.tip
fi
(cd "$dir/paper" && "$program" -f "$paper") >out 2>err &&
	[ "$(ls "$dir/paper" | wc -l)" = $made ] &&
	{ [ $made = 2 ] || grep -q 'borne out' out; }
result $? "and the script of the paper runs in an empty folder"
remark err
for name in tierp.csv ../tierp ./bro nowhere; do
	"$program" -c "load $name" >out 2>err
	[ $? -eq 5 ] && grep -q "$name: cannot read" err
	result $? "$name is a file, and is not there"
done
"$program" data/sites/tierp.csv 2>err
[ $? -eq 5 ] && tr -d '\n ' <err | grep -q "/share/tipspeed/sites/tierp.csv$"
result $? "an example's data/sites/tierp.csv is named where it is installed"
remark err
"$program" --safe -c 'load bro' 2>&1 | grep -q '^-c:1:1: load is not allowed'
result $? "--safe has names off as files"

# The line of make deb that builds, with a dpkg that has nothing installed: what it
# misses without the tests is nothing that only they need.
cd "$here" || exit 99
if [ -d "$srcdir/debian" ] && command -v dpkg-checkbuilddeps >/dev/null; then
	mkdir "$dir/admin" "$dir/bin" "$dir/package"
	: >"$dir/admin/status"
	cp -R "$srcdir/debian" "$dir/package"
	printf '#!/bin/sh\ndpkg-checkbuilddeps --admindir="%s" 2>&1\n' \
		"$dir/admin" >"$dir/bin/dpkg-buildpackage"
	chmod +x "$dir/bin/dpkg-buildpackage"
	# misses OPTIONS: what dpkg says.
	misses() {
		export DEB_BUILD_OPTIONS="$1"
		line=$(${MAKE:-make} -n -o dist deb | grep dpkg-buildpackage |
			sed 's/^cd [^ ]* && //')
		(cd "$dir/package" && PATH="$dir/bin:$PATH" sh -c "$line") \
			>"$dir/missed"
		grep -q libgsl-dev "$dir/missed"
	}
	misses parallel=2 && grep -q 'expect.*cmocka.*mandoc.*tmux' "$dir/missed"
	result $? "make deb wants what tests need"
	misses 'nocheck parallel=2' &&
		! grep -qE 'expect|cmocka|mandoc|tmux' "$dir/missed"
	result $? "but not with nocheck"
	remark "$dir/missed"
fi
finish
