#!/bin/sh
# The recipes of doc/recipes apply to this tree, each by itself and all together.  In
# `make check-long` the tree with all of them is built, and does what they say.  A
# recipe is a patch below a text, which has these lines:
#   Try: LINE         a line to run, in a folder that has data/
#   Prints: PATTERN   a line that it then prints, for grep
#   Tests: NAME..     programs of tests/unit or tests/fuzz that pass
#   Cases: NAME..     folders of tests/cases that are as expected
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
if ! command -v patch >/dev/null; then
	echo "1..0 # SKIP there is no patch"
	exit 0
fi
scratch
root=$(cd "$srcdir" && pwd)
build=$(pwd)
recipes=$root/doc/recipes

# copy_files RECIPE FOLDER: the files that it changes, as they are in this tree.
copy_files() {
	sed -n 's,^--- a/,,p' "$1" | while read -r file; do
		mkdir -p "$2/$(dirname "$file")" &&
			cp "$root/$file" "$2/$file" && chmod u+w "$2/$file"
	done
}
# apply RECIPE FOLDER NAME: one test point.
apply() {
	patch -d "$2" -p1 -f --fuzz=2 --no-backup-if-mismatch -r - \
		<"$1" >"$dir/out" 2>&1
	status=$?
	result $status "$3"
	[ $status = 0 ] && return
	remark "$dir/out"
	file=doc/recipes/$(basename "$1")
	echo "# In a clean tree: patch -p1 <$file, do by hand what was rejected," \
		"build; then 'git add -N .' and put 'git diff' below the text of $file."
}
for recipe in "$recipes"/*.patch; do
	name=$(basename "$recipe" .patch)
	mkdir -p "$dir/$name"
	copy_files "$recipe" "$dir/$name"
	copy_files "$recipe" "$dir/together"
	apply "$recipe" "$dir/$name" "$name applies"
	awk -v name="$name" '/^\+\+\+ / { files++; next }
		/^--- / { next }
		files && /^\+/ { more++ }
		files && /^-/ { less++ }
		END { printf "# %s: files %d, lines +%d -%d\n", name, files, more, less }
		' "$recipe"
done
for recipe in "$recipes"/*.patch; do
	apply "$recipe" "$dir/together" "$(basename "$recipe") applies beside the others"
done
# Also in a small part of check-long.
[ -n "${TIPSPEED_TEST_LONG:-}" ] || finish

# A copy of the tree and of what is built of it, but for the tests: make then makes
# what the recipes change.
cd "$root" || exit 99
below=.
case $build in "$root"/*) below=${build#"$root"/} ;; esac
if [ ! -f "$below/config.status" ]; then
	echo "# not built: the build is not in a folder of the sources"
	finish
fi
find "$below/tests" "$below/bench" -type f -perm -u+x -size +100k >"$dir/left_out"
parts=
for part in * .clang-format .ci; do
	[ -f "$part/config.status" ] && [ "$part" != "$below" ] || parts="$parts $part"
done
mkdir "$dir/tree"
# shellcheck disable=SC2086
tar -cf - -X "$dir/left_out" $parts | tar -xf - -C "$dir/tree"
for recipe in "$recipes"/*.patch; do
	apply "$recipe" "$dir/tree" "$(basename "$recipe") applies to the whole tree"
done
# What the make that runs this test was told is not for these.
unset MAKEFLAGS MFLAGS MAKELEVEL
cd "$dir/tree/$below" || exit 99
# configure wrote down where the tree was.
sed -i "s,$root,$dir/tree,g" config.status Makefile
programs=$(sed -n 's/^Tests: //p' "$recipes"/*.patch)
flags="$(sed -n 's/^CFLAGS = //p' Makefile) -Werror"
jobs=-j$(nproc)
# shellcheck disable=SC2086
make -s "$jobs" CFLAGS="$flags" all >"$dir/log" 2>&1 &&
	make -s "$jobs" CFLAGS="$flags" $programs >"$dir/log" 2>&1
status=$?
result $status "the tree with all recipes is built without a warning"
[ $status = 0 ] || { remark "$dir/log"; finish; }

# passes NAME COMMAND..: one test point.
passes() {
	name=$1
	shift
	srcdir=$dir/tree TIPSPEED=$PWD/tipspeed "$@" >"$dir/out" 2>&1
	status=$?
	result $status "$name"
	[ $status = 0 ] || remark "$dir/out"
}
passes tree.sh sh "$dir/tree/tests/tree.sh"
passes words.sh sh "$dir/tree/tests/words.sh"
for program in $programs; do
	passes "$program" "./$program"
done
for case in $(sed -n 's/^Cases: //p' "$recipes"/*.patch); do
	CASE=$case
	export CASE
	passes "case $case" sh "$dir/tree/tests/cases.sh"
done
PATH=$PWD:$PATH
cd "$dir" || exit 99
sed -n '/^Try: /p; /^Prints: /p' "$recipes"/*.patch >lines
while read -r word line; do
	case $word in
	Try:) sh -c "$line" >out 2>&1 </dev/null ;;
	Prints:)
		grep -q -e "$line" out
		status=$?
		result $status "prints $line"
		[ $status = 0 ] || remark out
		;;
	esac
done <lines
finish
