#!/bin/sh
# The full screen on a real Linux console, that of a machine in qemu: run on
# request, as it wants a kernel. KERNEL=FILE names one, PICTURES=DIR keeps what
# the screen looked like. The machine's first serial port goes to qemu's
# monitor, so that the script inside presses keys; its second takes the results.
# shellcheck disable=SC1091,SC2154
# SPDX-License-Identifier: GPL-3.0-or-later
. "${srcdir:-.}/tests/tap.sh"
KERNEL=${KERNEL:-$(find /boot -name 'vmlinuz-*' 2>/dev/null | sort | tail -n 1)}
[ -r "$KERNEL" ] || why='no kernel to be read in /boot: name one by KERNEL=FILE'
for need in qemu-system-x86_64 busybox cpio tic; do
	command -v $need >/dev/null || why="no $need here"
done
! ldd "$(command -v busybox)" >/dev/null 2>&1 || why='busybox is not static'
[ -z "${why:-}" ] || {
	echo "1..0 # SKIP $why"
	exit 0
}
scratch
image=$dir/image
mkdir -p "$image/bin" "$image/usr/lib/locale" "$image/usr/share/terminfo"
cp "$TIPSPEED" "$image/bin/tipspeed"
cp "$(command -v busybox)" "$image/bin"
ldd "$TIPSPEED" | grep -o '/[^ ]*' | while read -r library; do
	mkdir -p "$image${library%/*}"
	cp "$library" "$image$library"
done
infocmp linux | tic -o "$image/usr/share/terminfo" -
cp -r /usr/lib/locale/C.utf8 "$image/usr/lib/locale"
cp "$srcdir/tests/tap.sh" "$srcdir/data/sites/umea.csv" "$image"

cat >"$image/start" <<'EOF'
p='params set f_mat=2 e0_min=16 alpha=1'
alias t='clear; tipspeed umea.csv -c "$p" -c tui'
alias r='tipspeed --reset-tty'
alias s='x=$?; stty -a >after; clear; echo "status $x"'
PS1='shell: '
EOF
cat >"$image/init" <<'EOF'
#!/bin/busybox sh
/bin/busybox --install -s /bin
mkdir dev proc tmp
mount -t devtmpfs dev dev
mount -t proc proc proc
exec 3>/dev/ttyS0 >/dev/ttyS1 2>&1
. ./tap.sh
export ENV=/start TERM=linux HOME=/tmp
press() { for key; do echo "sendkey $key" >&3; done; }
picture() { echo "screendump $1.ppm" >&3; }
# want PATTERN [NAME]: waits until the screen has it, 20 seconds at most.
want() {
	tries=0
	until
		{ fold -b -w 80 /dev/vcs1 && echo; } >screen
		grep -q -e "$1" screen || [ $tries -ge 100 ]
	do
		sleep 0.2
		tries=$((tries + 1))
	done
	[ $tries -lt 100 ]
	good=$?
	[ $good -eq 0 ] || remark screen
	[ $good -eq 0 ] && [ -z "$2" ] || result $good "${2:-the screen has $1}"
}
# Colours of the cells: the second of each two bytes behind the first four.
colours() {
	tail -c +5 /dev/vcsa1 | hexdump -v -e '2/1 "%02x " "\n"' | sort -u
}
# over STATUS WAY: what the shell has then.
over() {
	rm -f after
	press s ret
	want "^status $1 "
	cmp before after && ! colours | grep -v ' 07 *$'
	result $? "$2: settings and colours are as before"
}
leave() {
	(finish)
	poweroff -f
}
legible() {
	! colours | grep -q ' \(01\|78\) *$'
	result $? "$1: no dark blue on black, no grey on grey"
}
enter() {
	press t ret
	want '\[74\.0\]'
}

stty -F /dev/tty1 brkint
LC_ALL=C.UTF-8 setsid -c sh -i </dev/tty1 >/dev/tty1 2>&1 &
want '^shell: '
press s ret
want '^status 0'
mv after before
enter
[ $good -eq 0 ] || leave
want 'mouse off  ascii  8 colours' 'it knows what the console can do'
for page in 2 3 4 5 1; do
	press $page
	want "\[$page [A-Z]"
	picture page$page
	# But for the name of the site, and each font has that.
	! sed 's/^Ume[^ -~],//' screen | grep -q '[^ -~]'
	result $? "page $page has no character that the font has not"
	legible "page $page"
done
for move in right:74.1 shift-right:74.2 shift-l:75.2 pgup:80.2 pgdn:75.2 \
	left:75.1 home:65.0 end:85.0; do
	press ${move%:*}
	want "\[${move#*:}\]" "$move"
done
press c
want 'crosshair [0-9]' 'c is the crosshair'
picture crosshair
legible crosshair
press f1
want 'Left Right ' 'F1 lists the keys'
picture keys
press q shift-semicolon p r e d tab
want '^:predict' 'a command is completed'
picture line
press ctrl-u ret ctrl-z
want Stopped '^Z stops it'
over '[0-9]*' '^Z'
press f g ret
want '\[85\.0\]' 'fg goes on'
press q
want '^shell:'
over 0 q
for way in INT:130 TERM:143 SEGV:139; do
	enter
	killall -${way%:*} tipspeed
	want '^shell: *$'
	picture ${way%:*}
	over ${way#*:} ${way%:*}
done
enter
killall -KILL tipspeed
want Killed
press r ctrl-j
want '^shell: para' '--reset-tty leaves the prompt at the margin'
picture KILL
over 0 'SIGKILL, then --reset-tty'
leave
EOF
chmod +x "$image/init"
(cd "$image" && find . | cpio -o -H newc --quiet) >"$dir/cpio"
cd "$dir" || exit 99
mkfifo press
exec 3<>press
timeout 150 qemu-system-x86_64 -m 512 -nodefaults -display none -vga std \
	-no-reboot -kernel "$KERNEL" -initrd cpio -append 'quiet loglevel=0' \
	-serial file:press -serial file:results -monitor stdio <&3 >log 2>&1
tr -d '\r' <results
[ -z "${PICTURES:-}" ] || cp ./*.ppm "$PICTURES"
grep -q '^1\.\.' results && ! grep -q '^not ok' results
