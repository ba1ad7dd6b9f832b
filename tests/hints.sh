#!/bin/sh
# Each hint of an error in tests/cases that is a command works where it is told: the
# command and its options are known, and it does not end in the same error.
# A case is run with a program in the place of tipspeed that keeps, of each run
# that fails, the folder, the words and the error; then the hint is run in the
# place of the command that failed.
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
scratch
mkdir "$dir/bin" "$dir/.kept" "$dir/.known"
REAL=$TIPSPEED
KEPT=$dir/.kept
export REAL KEPT
cat >"$dir/bin/tipspeed" <<'END'
#!/bin/sh
err=$(mktemp "$KEPT/err.XXXXXX")
"$REAL" "$@" 2>"$err"
status=$?
cat "$err" >&2
if [ $status -gt 0 ] && [ $status -lt 5 ] && grep -q '^  hint: ' "$err"; then
	k=$KEPT/$(($(ls -d "$KEPT"/[0-9]* 2>/dev/null | wc -l) + 1))
	mkdir "$k" && cp -R . "$k/folder" 2>/dev/null
	mv "$err" "$k/err"
	: >"$k/words"
	for word; do printf '%s\036' "$word" >>"$k/words"; done
else
	rm -f "$err"
fi
exit $status
END
chmod +x "$dir/bin/tipspeed"

# is_command WORD
is_command() {
	case $1 in *[!a-z]* | '') return 1 ;; esac
	[ -e "$dir/.known/$1" ] || {
		"$REAL" -c "help $1" 2>/dev/null | sed -n '1s, - .*,,p' | grep -q .
		echo $? >"$dir/.known/$1"
	}
	[ "$(cat "$dir/.known/$1")" -eq 0 ]
}

# The last error and its hint, each as one line.
error_of() {
	awk '/^ +hint: / { hint = $0; sub(/^ +hint: /, "", hint); on = 1; next }
		on && /^      / { sub(/^ +/, ""); hint = hint " " $0; next }
		/^[^ ]/ { error = $0 }
		{ on = 0 }
		END { sub(/^[^ ]*:[0-9]+(:[0-9]+)?: /, "", error)
			print error; print hint }' "$1"
}

# What of a hint may be a command: what is in quotes, and what is after a colon,
# up to where the sentence goes on.
candidates() {
	printf '%s\n' "$1" | awk '{
		text = $0
		while (match(text, /\047[^\047]+\047/)) {
			print substr(text, RSTART + 1, RLENGTH - 2)
			text = substr(text, RSTART + RLENGTH)
		}
		if (match($0, /: .*/))
			print substr($0, RSTART + 2) }' |
		sed 's/, or .*//; s/; \(or\|another\|others\|it\|they\) .*//' |
		sed 's/@SPEED/@72/g; s/SPEED/72/g; s/DIAMETER/900/g; s/point|comma/point/'
}

# run KEPT COMMAND: the words of the run with the command in the place of what
# failed, and nothing after it.
run() (
	kept=$1 command=$2
	cd "$kept/folder" || exit 99
	at=$(sed -n 's/^-c:\([0-9]*\):.*/\1/p' "$kept/err" | tail -n 1)
	file=$(grep -v '^ ' "$kept/err" | tail -n 1 |
		sed 's/:.*//; s/, sheet .*//')
	set --
	n=0 is_c=0 done=0
	while IFS= read -r word; do
		[ $done -eq 0 ] || continue
		if [ $is_c -eq 1 ]; then
			is_c=0
			n=$((n + 1))
			case $at:$word in
			"$n":*) done=1 ;;
			:*"$file"*) done=1 ;;
			*) set -- "$@" -c "$word" ;;
			esac
			continue
		fi
		case $word in
		-c) is_c=1 ;;
		-f | -) exit 100 ;;
		"$file") done=1 ;;
		*) set -- "$@" "$word" ;;
		esac
	done <<-END
	$(tr '\036' '\n' <"$kept/words")
	END
	HOME=$kept XDG_DATA_HOME=$kept/share timeout 60 "$REAL" "$@" \
		-c "$command" >/dev/null 2>"$kept/again" </dev/null
)

PATH=$dir/bin:$PATH
cases=$(cd "$srcdir/tests/cases" && pwd)
tried=0
# One case of eighteen, all in the long tests.
step=$(often 18 1) at=0
: >"$dir/.seen"
for expected in $(grep -l '^ *hint: ' "$cases"/*/expected); do
	at=$((at + 1))
	[ $((at % step)) -eq 0 ] || continue
	c=$(dirname "$expected")
	name=$(basename "$c")
	rm -rf "$KEPT"/*
	mkdir "$dir/$name"
	ln -s "$dir/data" "$dir/$name/data"
	(cd "$dir/$name" && LC_ALL=C.UTF-8 sh "$c/cmd") >/dev/null 2>&1 </dev/null
	: >"$dir/log"
	for k in "$KEPT"/[0-9]*; do
		[ -d "$k" ] || continue
		error_of "$k/err" >"$k/told"
		error=$(sed -n 1p "$k/told")
		candidates "$(sed -n 2p "$k/told")" >"$k/lines"
		while IFS= read -r line; do
			is_command "${line%% *}" || continue
			case $line in *FILE* | *NAME* | *PART*) continue ;; esac
			[ "$(grep -cxF -e "$line" "$dir/.seen")" -lt 2 ] ||
				continue
			echo "$line" >>"$dir/.seen"
			run "$k" "$line"
			status=$?
			[ $status -lt 99 ] || continue
			tried=$((tried + 1))
			error_of "$k/again" >"$k/told2"
			again=$(sed -n 1p "$k/told2")
			strange='no command\|no option\|unexpected word'
			if [ $status -ne 0 ] && { [ "$again" = "$error" ] ||
				grep -q "$strange" "$k/again"; }; then
				echo "$error"
				echo "  hint: $line"
				echo "  then: $again"
			fi
		done <"$k/lines" >>"$dir/log"
	done
	[ ! -s "$dir/log" ]
	result $? "case $name: the hints work"
	remark "$dir/log"
done
[ $tried -ge $((100 / step)) ]
result $? "there are hints that are commands ($tried)"
finish
