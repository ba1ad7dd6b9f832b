#!/bin/sh
# The tree itself: layers, circles, what core may use, sizes of functions.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
cd "$srcdir" || exit 99
tmp=$(mktemp) || exit 99
trap 'rm -f "$tmp"' EXIT

# none NAME: passes when $tmp is empty, else shows it.
none() {
	remark "$tmp"
	[ ! -s "$tmp" ]
	result $? "$1"
}

# layer NAME ALLOWED...: NAME includes only itself and the layers allowed.
layer() {
	name=$1
	shift
	allowed=$(printf '%s\n' "$name" "$@" | paste -sd '|' -)
	grep -rnE '^#include "[a-z]+/' "src/$name" |
		grep -vE "#include \"($allowed)/" >"$tmp"
	none "$name includes only: $*"
}
layer base
layer core base
layer io core base
layer plot base
layer cmd io plot core base
layer cli cmd io plot core base
layer tui cli cmd io plot core base

# of NAME PATTERN: the files of a layer, in whatever folders.
of() {
	find "src/$1" -name "$2" | LC_ALL=C sort
}
# rooms LAYER FOLDER...: the folders of a layer stand in this order: none includes
# from one behind it, but for the pairs in `upward`, of which there are to be fewer.
# Files that stand in no folder may include from all.
upward='cmd/ask/blended.c cmd/sheets/load.h
cmd/session/sites.c cmd/fit/job.h'
rooms() {
	layer=$1
	shift
	grep -roE "^#include \"$layer/[a-z]+/[a-z_0-9]+.h" "src/$layer"/*/ |
		sed 's,^src/,,; s,:#include ",/,' |
		awk -F/ -v order="$*" 'BEGIN {
			n = split(order, names, " ")
			for (i = 1; i <= n; i++)
				place[names[i]] = i
		}
		place[$2] < place[$(NF - 1)] || !place[$2] {
			print $1 "/" $2 "/" $3, $(NF - 2) "/" $(NF - 1) "/" $NF
		}' | grep -vxF "$upward" >"$tmp"
	none "folders of $layer in order: $*"
}
rooms core numeric psd model search posterior answer check
rooms io fs cells sitefile store formats
rooms cmd lang document session ask fit run draw plant answers sheets
grep -rl '^#include "tui/pages/' src/tui/widgets >"$tmp"
none "widgets know no page"

# Files of a layer that have grown into each other are one, or lack a third: none
# includes, by way of others, one that includes it (.c and .h are taken as one).
# What is left when files that include none of the rest, or that none of the rest
# includes, are taken away again and again, is in such a circle or between two.
circles() {
	for f in $(of "$1" '*.[ch]'); do
		sed -n "s,^#include \"$1/\(.*/\)*\(.*\)\.h\".*,$(basename "${f%.*}") \2,p" "$f"
	done | sort -u | awk -v layer="$1" '$1 != $2 { from[++n] = $1; to[n] = $2 }
		END {
			do {
				split("", out)
				split("", in_)
				for (i = 1; i <= n; i++) {
					out[from[i]] = 1
					in_[to[i]] = 1
				}
				was = n
				n = 0
				for (i = 1; i <= was; i++)
					if (to[i] in out && from[i] in in_) {
						from[++n] = from[i]
						to[n] = to[i]
					}
			} while (n < was)
			for (i = 1; i <= n; i++)
				print "src/" layer ": " from[i] " includes " to[i]
		}' >"$tmp"
	none "no circle of files in $1"
}
# What a header declares is defined in the .c of its name.
at_home() {
	for h in $(of "$1" '*.h'); do
		sed 's,/\*.*\*/,,; /\/\*/,/\*\//d; /^#/d' "$h" | awk '
			/^(static|typedef)/ { skip = 1 }
			/^[a-z].*[ *][a-z_0-9]+\(/ && !skip {
				sub(/\(.*/, "")
				sub(/.*[ *]/, "")
				print
			}
			/[;}]$/ { skip = 0 }' | awk -v h="$h" -v c="${h%.h}.c" '
			BEGIN {
				while ((getline line <c) > 0)
					if (match(line, /^[a-z_0-9]+\(/))
						has[substr(line, 1, RLENGTH - 1)]
			}
			!($0 in has) { print h ": " $0 " is not in " c }'
	done >"$tmp"
	none "headers of $1 declare what the .c of their name defines"
}
for layer in base core io plot cmd cli tui; do
	circles $layer
	at_home $layer
done

# What core must not use.
for word in 'stdio\.h' 'time\.h' 'signal\.h' 'getenv' 'unistd\.h' 'locale\.h' \
	'printf' 'errno'; do
	grep -rnwE "$word" src/core >"$tmp"
	none "core is free of $word"
done
grep -rnE 'str(n?casecmp|coll)\(|iscntrl' src >"$tmp"
none "the locale does not say which letters are the same"
grep -lE 'sqlite3\.h' -r src | grep -v '^src/io/' >"$tmp"
none "SQLite in io only"
grep -lE 'cairo' -r src | grep -v '^src/plot/' >"$tmp"
none "cairo in plot only"
grep -lE 'readline/' -r src | grep -vE '^src/(cli/|tui/widgets/edit\.c)' >"$tmp"
none "readline in cli, its history in the full screen's editor"
grep -lE 'n?curses\.h' -r src | grep -vE '^src/(tui/|cli/(restore|terminal)\.)' >"$tmp"
none "ncurses in tui, and where a terminal is asked or put right"

# Words reach a terminal by reports, notes, errors, canvases and
# text_print_escaped, which
# show what it would act on; the files left out print their own words.
awk 'FNR == 1 { all = "" }
	{ all = all " " $0 }
	/[;{}]$/ {
		# A translation has the conversions of its text.
		gsub(/tr\("/, "\"", all)
		if (all ~ /(printf|puts|fwrite)\(/ &&
		    all ~ /stderr|stdout|->out|->notes/ &&
		    all ~ /%[-.*0-9]*s|puts\([^"]|fwrite/)
			print FILENAME ":" FNR ": " all
		all = ""
	}' $(of cmd '*.c') $(of cli '*.c') $(of tui '*.c') \
		src/main.c |
	grep -v '^src/cli/\(batch\|ask\|pager\|progress\|repl\|history\)\.c' >"$tmp"
none "words of others are not printed as they are"

# Variables outside functions: only constant tables, but for
# those of terminals.
awk '/^(static )?[a-z_ ]+\**[a-z_]+(\[.*\])?( = .*)?;$/ &&
	!/const|typedef|extern|^struct [a-z_]+;|return/ { print FILENAME ": " $0 }' \
	$(find src -name '*.c' ! -path 'src/[ct][lu]i/*' ! -path src/main.c) \
	>"$tmp"
none "no file-scope variables outside cli and tui"

# A function runs from the line of its name in column 0 to the closing brace.
awk 'FNR == 1 { name = "" }
	/^[a-zA-Z_]+\(/ && !/;$/ { name = $0; start = FNR }
	/^}/ && name != "" {
		if (FNR - start > 50)
			print FILENAME ": " FNR - start " lines: " name
		name = ""
	}' $(find src -name '*.[ch]') tests/unit/*.c >"$tmp"
none "no function over 50 lines"

awk 'length > 0 {
	line = $0; gsub(/\t/, "        ", line)
	gsub(/[\200-\277]/, "", line)
	if (length(line) > 80) print FILENAME ":" FNR ": " length(line)
	}' $(find src -name '*.[ch]') >"$tmp"
none "no line over 80 columns"

awk 'FNR > 12 { nextfile }
	FNR == 1 { seen[FILENAME] }
	/SPDX-License-Identifier/ { delete seen[FILENAME] }
	END { for (f in seen) print f }' $(find src/*/ -name '*.[ch]') >"$tmp"
none "every file opens with its duty and its licence"
awk '/SPDX/ { print FILENAME }
	{ nextfile }' $(of . '*.c') >"$tmp"
none "a .c opens with what it does, before its licence"

# A .c with a header of its name includes that first.
grep -m1 -H '^#include' $(find src -name '*.c') | while IFS=: read -r f first; do
	h=${f%.c}.h
	[ ! -f "$h" ] || [ "$first" = "#include \"${h#src/}\"" ] ||
		echo "$f: $first"
done >"$tmp"
none "a file includes its own header first"

find src -name '*.[ch]' -printf '%h\n' | sort | uniq -c |
	awk '$1 > 42 { print $2 ": " $1 " files" }' >"$tmp"
none "no folder with more than 42 files"

grep -nwE 'TODO|FIXME|XXX' -r src tests/unit man >"$tmp"
none "no marks left"

# The guides name files and identifiers that there are; minimize_crash is an option of
# the fuzzer, table3_text.c is made.
guides="HACKING.md bench/README.md dem/README.md doc/architecture.md
	doc/experiments.md $(echo doc/decisions/*.md doc/building-blocks/*.md)"
find src tests bench tools dem -name '*.[ch]' -printf '%f\n' | sort -u >"$tmp.there"
grep -ohE '[a-z_0-9]+\.[ch]\b' $guides | sort -u | grep -vx table3_text.c |
	comm -23 - "$tmp.there" >"$tmp"
grep -ohE '[a-z0-9]+(/[a-z_0-9-]+)+\.(c|h|md|sh|tip)\b' $guides | sort -u |
	while read -r f; do
		[ -e "$f" ] || [ -e "src/$f" ] || [ -e "doc/$f" ] || echo "$f"
	done >>"$tmp"
grep -ohE '[a-z]+\.patch\b' $guides | sort -u | while read -r f; do
	[ -e "doc/recipes/$f" ] || echo "$f"
done >>"$tmp"
grep -rohIE '[A-Za-z]+(_[A-Za-z0-9]+)+' src tests tools bench data dem man Makefile.am \
	configure.ac .ci | sort -u >"$tmp.words"
grep -ohE '\b[a-z]+(_[a-z0-9]+)+\b' $guides | grep -vx minimize_crash | sort -u |
	comm -23 - "$tmp.words" >>"$tmp"
grep -rohE 'doc(/[a-z-]+)+\.md' src README.md | sort -u | while read -r f; do
	[ -e "$f" ] || echo "$f"
done >>"$tmp"
rm "$tmp.words"
none "guides name files and identifiers that there are"

# A name with a file behind it in brackets is a function that the file defines.
for f in $guides; do
	tr -s '\n\t ' ' ' <"$f" | grep -oE '`[a-z_0-9]+` \([a-z_0-9/]+\.[ch]\)' |
		tr -d '`()' | while read -r name file; do
		grep -qsE "(^|[ *])$name\(" $(find src -path "*/${file#src/}") </dev/null ||
			echo "$f: $name is not in $file"
	done
done >"$tmp"
none "guides name functions in the file that defines them"

# In code, a line "// FILE.h" names the header that has the declarations below it, and
# "struct X { .. };" lists members of X.  Blanks, comments and attributes do not count.
awk '
# Text between the braces that open at place `at`.
function body(text, at,    depth, i, c) {
	for (i = at; i <= length(text); i++) {
		c = substr(text, i, 1)
		depth += (c == "{") - (c == "}")
		if (c == "}" && depth == 0)
			return substr(text, at, i - at)
	}
}
function header(file,    line, text, macro) {
	while ((getline line <("src/" file)) > 0) {
		macro = macro || line ~ /^#/
		if (!macro)
			text = text line " "
		macro = macro && line ~ /\\$/
	}
	close("src/" file)
	gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, "", text)
	gsub(/[ \t]+/, "", text)
	gsub(/__attribute__\(\(([^()]|\([^()]*\))*\)\)/, "", text)
	return ";" text
}
# True if the text has these words as a whole declaration.
function declares(text, words,    at, after) {
	while ((at = index(text, words)) > 0) {
		after = substr(text, at + length(words), 1)
		if (substr(text, at - 1, 1) ~ /[;{}]/ && after ~ /[;{]/)
			return 1
		text = substr(text, at + 1)
	}
}
function look(words) {
	seen++
	if (!declares(inside != "" ? inside : has[file], words))
		print FILENAME ":" FNR ": not in " file ": " words
}
function end() {
	if (rest != "")
		print FILENAME ":" FNR ": no end: " rest
	rest = inside = ""
}
FNR == 1 { file = "" }
!/^    / { end() }
/^    / {
	if (/^    \/\/ [a-z_\/]+\.h$/) {
		file = $2
		if (!(file in has))
			has[file] = header(file)
	}
	sub(/\/\/.*/, "")
	gsub(/[ \t]+/, "")
	rest = rest $0
	while (match(rest, /[;{}]/)) {
		c = substr(rest, RSTART, 1)
		words = substr(rest, 1, RSTART - 1)
		rest = substr(rest, RSTART + 1)
		if (c == "{") {
			look(words)
			inside = body(has[file], index(has[file], words "{") + length(words))
		} else if (c == "}")
			inside = ""
		else if (words != "")
			look(words)
	}
}
END {
	end()
	if (seen < 100)
		print "only " seen + 0 " declarations"
}' doc/building-blocks/*.md >"$tmp"
none "what the guides say can be called is declared so"

[ "$(wc -l <HACKING.md)" -le 200 ]
result $? "HACKING.md has 200 lines at most"

# Headers that comments name are there.
grep -rhE '/\*|^[[:space:]]*\*' src --include='*.[ch]' | grep -oE '\b[a-z_]{4,}\.h\b' |
	sort -u | grep -vx ctype.h | comm -23 - "$tmp.there" >"$tmp"
rm "$tmp.there"
none "comments name headers that there are"

# What the full screen exported by the way is soon committed by the way.
git ls-files 2>/dev/null | grep -v / | grep -vxE '\.clang-format|\.gitignore|'\
'COPYING|HACKING\.md|Makefile\.am|NEWS|README\.md|bootstrap|configure\.ac' >"$tmp"
none "no stray file at the top"
finish
