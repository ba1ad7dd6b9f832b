#!/bin/sh
# Texts in other languages: each catalogue is whole, its formats take what the
# program gives them, and what programs read is the same in all. tests/lang has runs
# in Swedish, as tests/cases has in English; `RENEW=1` writes them anew.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
here=$(pwd)
srcdir=$(cd "$srcdir" && pwd)
scratch

# told NAME: passes when $dir/bad is empty, else shows it.
told() {
	remark "$dir/bad"
	[ ! -s "$dir/bad" ]
	result $? "$1"
}

if command -v xgettext >/dev/null && command -v msggrep >/dev/null; then
	make -C "$here" -s texts.pot >/dev/null 2>&1
	find "$srcdir/src" -name '*.c' | xgettext -L C --from-code=UTF-8 -k \
		-kanswer_columns:2 -o "$dir/columns.pot" -f - 2>/dev/null
fi
for po in "$srcdir"/po/*.po; do
	language=$(basename "$po" .po)
	command -v msgfmt >/dev/null || continue
	msgfmt -c -o /dev/null "$po" 2>"$dir/bad"
	told "$language: formats and line ends as in English"
	{
		msgattrib --untranslated --no-wrap "$po"
		msgattrib --only-fuzzy --no-wrap "$po"
		msgattrib --only-obsolete --no-wrap "$po"
		[ ! -f "$here/texts.pot" ] || msgcmp "$po" "$here/texts.pot" 2>&1
	} | sed -n '/^$/d; 1,20p' >"$dir/bad"
	told "$language: all is translated"
	[ -s "$dir/columns.pot" ] || continue
	# Keys of columns, which stand before a colon, are as in English.
	msgmerge -q -N --no-wrap "$po" "$dir/columns.pot" | msgattrib --no-obsolete \
		--no-wrap | awk '
		function keys(text, n, i, cell, all) {
			gsub(/^msg(id|str) "|"$/, "", text)
			n = split(text, cell, ",")
			for (i = 1; i <= n; i++) {
				sub(/:.*/, "", cell[i])
				gsub(/^ +| +$/, "", cell[i])
				all = all cell[i] ","
			}
			return all
		}
		/^msgid "./ { was = $0 }
		/^msgstr "[^"]/ && was != "" && keys($0) != keys(was) { print was; print }
		/^msgstr/ { was = "" }' >"$dir/bad"
	told "$language: keys of columns as in English"
done

# xgettext takes the commas of a compound literal for those between arguments: a text
# after one would be in no catalogue.
marks=$(awk '/^translating/ { on = 1 } on && /:/ { print } !/\\$/ { on = 0 }' \
	"$srcdir/Makefile.am" | grep -oE '[a-z_]+:[0-9]' | sed 's/:.//' | paste -sd'|' -)
find "$srcdir/src" -name '*.c' -exec grep -PzoH \
	"\\b($marks)\\([^;\"]*\\{[^}\"]*,[^}\"]*\\}[^\"(;]*\"[^\"]*[A-Za-z]{2}" {} + |
	tr '\0' '\n' >"$dir/bad"
told 'no text to be translated stands after a compound literal'

mkdir "$dir/bin"
ln -s "$TIPSPEED" "$dir/bin/tipspeed"
PATH=$dir/bin:$PATH
export LC_ALL=C.UTF-8
cd "$dir" || exit 99
for form in csv json; do
	for language in en sv; do
		tipspeed --lang=$language --format=$form data/sites/tierp.csv \
			-c 'recall table3/tierp' -c 'predict 90' -c validate \
			-c 'show site' -c 'check' -c 'why 74' -c 'find p80=5' \
			>$language.$form 2>/dev/null
	done
	diff en.$form sv.$form >bad
	told "$form is the same in Swedish"
done
for c in "$srcdir"/tests/lang/*/; do
	name=$(basename "$c")
	mkdir "$name"
	ln -s "$dir/data" "$name/data"
	(cd "$name" && sh "$c/cmd") >out 2>&1 </dev/null
	[ "${RENEW:-}" != 1 ] || cp out "$c/expected"
	diff "$c/expected" out >bad
	told "in Swedish: $name"
done
if command -v expect >/dev/null; then
	HOME=$dir TERM=vt100 expect -c 'log_user 1
		set timeout 30
		spawn tipspeed --lang=sv data/sites/tierp.csv
		expect -re {\[J/n, eller ett kommando\].*> $}
		send "j\r"
		expect -re {\[J/n, eller ett\s+kommando\].*> $}
		send "nej\r"
		expect -re {> $}
		send "quit\r"
		expect eof' >out 2>&1
	grep -q 'god inpassning' out && ! grep -q 'inget kommando' out
	found=$?
	result $found "a question in Swedish takes j and nej"
	[ $found = 0 ] || remark out
	# At 37 columns the ö of "högst" is at the edge; expect shows half of it as Ã.
	TERM=xterm timeout -k 2 60 expect -c '
		set timeout 30
		set stty_init "rows 24 columns 37"
		spawn -noecho tipspeed --lang=sv --store=:memory: \
			data/sites/tierp.csv -c {calibrate population=60 \
			generations=700 stall=0 tolerance=0 threads=1}
		expect eof' >out 2>&1
	grep -q 'kalibrerar' out && ! grep -q 'Ã' out
	result $? "a line of progress is cut between letters"
fi
tipspeed --lang=xx -c version >out 2>&1
[ $? = 2 ] && grep -q "expected --lang" out
result $? 'a language without a catalogue is refused'

# A catalogue from elsewhere, which a path in the place of a language would name: made
# up, with texts that write where they like.
mkdir -p away/bin/locale away/LC_MESSAGES
cp "$TIPSPEED" away/bin/tipspeed
if command -v msgfmt >/dev/null; then
	printf 'msgid "%s"\nmsgstr "%s"\n\n' '' 'Content-Type: text/plain; charset=UTF-8\n' \
		"there is no command '%s'" 'FOREIGN %n%n%n' |
		msgfmt -o away/LC_MESSAGES/tipspeed.mo -
	for path in ../.. sv:../..; do
		LANGUAGE=$path away/bin/tipspeed --safe -c nonsense >out 2>&1
		[ $? = 2 ] && grep -q "there is no command 'nonsense'" out
		result $? "LANGUAGE=$path names no catalogue"
	done
	LANGUAGE=../.. away/bin/tipspeed --safe --lang=../.. -c nonsense >out 2>&1
	[ $? = 2 ] && grep -q "expected --lang with a language .*, got '\.\./\.\.'" out
	result $? "nor does --lang=../.., which says so"
fi
finish
