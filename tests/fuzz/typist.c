/* Types anything at the prompt and at the full screen, each as a program in a
 * terminal of its own: keys, lines, pastes cut short, signals, stops, sizes from
 * 1 x 1.  In the end the program is to end, in the way and with a status that is
 * documented, with the terminal as it was.  What does not is told with the seed
 * of the walk and all that was typed.
 *   SEED=N     plays one walk again (STEPS=N: the first steps of it), and with
 *              SHRINK=1 looks for the few of its steps that do it
 *   SECONDS=N  walks for so long, from seed FROM on
 *   TIPSPEED_TEST_LONG=1  as SECONDS=1800
 * Without them a few walks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
/* Terminals as X/Open has them, and their sizes. */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"

/* Seconds of its own processor time that a program may take to end, and of the
 * clock where others have the machine. */
enum { LIMIT = 10, LIMIT_CLOCK = 60 };

/* What a sanitizer ends with, as the driver tells it to. */
enum { REPORTED = 99 };

/* The same walk from the same seed everywhere. */
static uint64_t state_of;

static size_t
below(size_t n)
{
	uint64_t z = (state_of += 0x9E3779B97F4A7C15U);
	z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
	z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
	return (size_t)((z ^ (z >> 31)) % n);
}

/* ---- what is typed */

enum kind { KEYS, SIGNAL, SIZE, NAP };

struct step {
	enum kind kind;
	char keys[200];
	int a, b; /* the signal; rows and columns; ms */
};

enum { STEPS = 120 };

struct walk {
	uint64_t seed;
	bool screen;
	const char *term, *locale, *inputrc;
	const char *argument[8];
	size_t n;
	struct step step[STEPS];
	int ending; /* a signal; 0: the terminal goes */
};

static const char *const LINES[] = {"load data/sites/bro.csv",
    "load data/sites/tierp.csv", "use tierp", "use bro", "calibrate",
    "calibrate generations=1000000 tolerance=0 stall=0", "calibrate all",
    "calibrate seed=2 polish=off", "continue", "accept", "help", "help predict",
    "show params", "why 74", "find p80=5.4", "predict 72", "predict 74",
    "predict 999", "plot parity", "plot response", "reset", "undo", "redo",
    "set k 2", "set goal p80=5..5.3", "set goal none", "bounds e0_min 0..25",
    "describe psd", "check", "sweep", "window", "guess", "screen",
    "screen width=40 height=10 keys=\"f Right\"", "league",
    "validate holdout=each", "load nothing.csv", "seed \\", "99", "seed 7",
    "predict 74 > out.csv", "sweep | cat >/dev/null", "save session.tip",
    "restore", "restore last", "remember mine", "recall mine", "materials",
    "pin 74", "compare pinned 72", "params set f_mat=2 e0_min=16 alpha=1",
    "calibrate; predict 74", "uncertainty", "identify", "report > r.html",
    "add plant.csv@70", "new site", "tui", "quit"};

static const char *const GOALS[] = {
    "p80=5..5.3", "p80=5.4", "passing 2 = 40..50", "none", "p50<", ""};

/* Of readline, and what both have. */
static const char *const CHORDS[] = {"\033[A", "\033[B", "\033[C", "\033[D",
    "\033[5~", "\033[6~", "\033[H", "\033[F", "\033[3~", "\033OA", "\033[1;2C",
    "\033[1;2D", "\033[Z", "\033OP", "\033[15~", "\t", "\t\t", "\r", "\r", "\r",
    "\033", "\033\033", "\033[", "\033O", "\001", "\002", "\003", "\005",
    "\006", "\007", "\010", "\013", "\014", "\016", "\017", "\020", "\022",
    "\024", "\025", "\026", "\027", "\030\025", "\030\022", "\030\030", "\030(",
    "\030)", "\030e", "\031", "\033y", "\032", "\037", "\035p", "\033.",
    "\033p", "\033n", "\033<", "\033>", "\0335", "\033-", "\033?", "\033*",
    "\033=", "\033&", "\033~", "\033#", "\033u", "\033\\", "\033r", "\033t",
    "\177", "\033\177", "\033d", "\033[200~", "\033[201~",
    "\033[200~seed 5\rpredict 7", "\033[200~seed 6\r\r\033[201~", "\303\245",
    "\303", "\377", "\342\200\256"};

static void
add_mouse(char *to, size_t room)
{
	static const int BUTTONS[] = {0, 0, 0, 2, 32, 64, 65};
	snprintf(to, room, "\033[<%d;%zu;%zu%c",
	    BUTTONS[below(ARRAY_LEN(BUTTONS))], 1 + below(100), 1 + below(40),
	    below(3) == 0 ? 'm' : 'M');
}

/* Any character but the one that starts a shell. */
static void
add_letters(char *to)
{
	size_t n = 1 + below(6);
	for (size_t i = 0; i < n; i++) {
		char c = (char)(' ' + below(95));
		to[i] = c == '|' ? 'f' : c;
	}
	to[n] = '\0';
}

static void
type_keys(struct step *step, bool screen)
{
	const size_t room = sizeof step->keys;
	const char *line = LINES[below(ARRAY_LEN(LINES))];
	switch (below(screen ? 10 : 7)) {
	case 0:
	case 1:
		snprintf(step->keys, room, "%s%s%s", screen ? ":" : "", line,
		    below(5) == 0 ? "" : "\r");
		break;
	case 2:
		add_letters(step->keys);
		break;
	case 7:
		add_mouse(step->keys, room);
		break;
	case 8:
		snprintf(step->keys, room, "t%s%s",
		    GOALS[below(ARRAY_LEN(GOALS))], below(5) == 0 ? "" : "\r");
		break;
	case 9:
		step->keys[0] =
		    "12345f.sux?qoTgnpNyYcerzCLR+-[]m!/ "[below(35)];
		break;
	default:
		snprintf(
		    step->keys, room, "%s", CHORDS[below(ARRAY_LEN(CHORDS))]);
	}
}

static int
some_size(int usual)
{
	return below(3) == 0   ? 1 + (int)below(4)
	       : below(2) == 0 ? usual
			       : 1 + (int)(below(15) * below(15)) % (3 * usual);
}

static struct step
some_step(bool screen)
{
	static const int SIGNALS[] = {SIGINT, SIGWINCH, SIGTSTP, SIGCONT};
	struct step step = {.kind = KEYS};
	switch (below(12)) {
	case 0:
		step.kind = SIGNAL;
		/* ^C ends the full screen. */
		step.a = SIGNALS[screen && below(8) != 0
				     ? 1 + below(3)
				     : below(ARRAY_LEN(SIGNALS))];
		break;
	case 1:
		step.kind = SIZE;
		step.a = some_size(24);
		step.b = some_size(80);
		break;
	case 2:
		step.kind = NAP;
		step.a = (int)below(8) == 0 ? 400 : (int)below(60);
		break;
	default:
		type_keys(&step, screen);
	}
	return step;
}

static void
some_arguments(struct walk *w)
{
	size_t n = 0;
	if (below(6) == 0)
		w->argument[n++] = "--safe";
	if (below(8) == 0)
		w->argument[n++] = "--linear";
	if (below(5) != 0)
		w->argument[n++] = "data/sites/tierp.csv";
	if (w->screen && below(2) == 0)
		w->argument[n++] = "-cparams set f_mat=2 e0_min=16 alpha=1";
	if (w->screen)
		w->argument[n++] = "-ctui";
}

static void
make_walk(struct walk *w, uint64_t seed)
{
	static const char *const TERMS[] = {"xterm", "xterm-256color", "vt100",
	    "linux", "screen", "dumb", "no-such-terminal"};
	static const char *const LOCALES[] = {"C.UTF-8", "C.UTF-8", "C"};
	static const char *const SETTINGS[] = {"", "", "set editing-mode vi\n",
	    "\"\\e[A\": history-search-backward\n"
	    "\"\\e[B\": history-substring-search-forward\n",
	    "set enable-bracketed-paste off\nset revert-all-at-newline on\n"};
	static const int ENDINGS[] = {
	    SIGTERM, SIGTERM, SIGTERM, SIGTERM, SIGHUP, SIGHUP, 0};
	state_of = seed * 0x2545F4914F6CDD1DU;
	*w = (struct walk){.seed = seed, .screen = below(2) == 0};
	w->term = TERMS[below(2) == 0 ? 0 : below(ARRAY_LEN(TERMS))];
	w->locale = LOCALES[below(ARRAY_LEN(LOCALES))];
	w->inputrc = SETTINGS[below(ARRAY_LEN(SETTINGS))];
	some_arguments(w);
	w->n = 10 + below(STEPS - 10);
	for (size_t i = 0; i < w->n; i++)
		w->step[i] = some_step(below(8) == 0 ? !w->screen : w->screen);
	w->ending = ENDINGS[below(ARRAY_LEN(ENDINGS))];
}

/* ---- the terminal */

/* What a walk came to. */
struct course {
	char folder[256];
	int master, news; /* news: status of the program, from its shell */
	pid_t shell, program;
	bool over, changed;
	int status;
	char state[80]; /* of one that had to be killed */
	char *last;     /* of what was written */
	size_t last_n;
};

/* What the shell tells: first the program's number, then how it ended. */
struct news {
	pid_t program;
	int status;
	bool changed; /* the terminal's settings are not as they were */
};

static double
now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double
processor_time(pid_t pid)
{
	clockid_t clock;
	struct timespec t = {0};
	if (clock_getcpuclockid(pid, &clock) == 0)
		clock_gettime(clock, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void
nap(int ms)
{
	poll(NULL, 0, ms);
}

static bool
same_settings(const struct termios *was)
{
	struct termios t;
	return tcgetattr(0, &t) != 0 ||
	       (t.c_lflag == was->c_lflag && t.c_iflag == was->c_iflag &&
		   t.c_oflag == was->c_oflag);
}

static void
put_file(const char *path, const char *text)
{
	FILE *out = fopen(path, "w");
	if (out == NULL || fputs(text, out) < 0 || fclose(out) != 0) {
		perror(path);
		exit(99);
	}
}

static void
become_program(const struct walk *w)
{
	static const char *const ASAN =
	    "exitcode=99:log_path=report:handle_segv=2:handle_sigbus=2:"
	    "handle_abort=2:handle_sigfpe=2:handle_sigill=2:detect_leaks=";
	const char *program = getenv("TIPSPEED");
	char *argument[10] = {xstrdup(program != NULL ? program : "tipspeed")};
	for (size_t i = 0; w->argument[i] != NULL; i++)
		argument[i + 1] = xstrdup(w->argument[i]);
	setenv("TERM", w->term, 1);
	setenv("LC_ALL", w->locale, 1);
	setenv("INPUTRC", "inputrc", 1);
	setenv("TIPSPEED_PAGER", "cat", 1);
	setenv("MANPAGER", "cat", 1);
	/* Hung up together with its terminal, the look for leaks stops itself
	 * for ever. */
	char *asan = xasprintf("%s%d", ASAN, w->ending != 0);
	setenv("ASAN_OPTIONS", asan, 1);
	setenv("UBSAN_OPTIONS", "exitcode=99:log_path=report", 1);
	setenv("LSAN_OPTIONS", "suppressions=leaks:print_suppressions=0", 1);
	execvp(argument[0], argument);
	_exit(127);
}

static pid_t job;

static void
hang_up(int signal)
{
	kill(-job, signal);
	kill(-job, SIGCONT);
}

/* False at its end. */
static bool
wait_for_stop(pid_t pid)
{
	siginfo_t what;
	while (
	    waitid(P_PID, (id_t)pid, &what, WEXITED | WSTOPPED | WNOWAIT) != 0)
		;
	return what.si_code == CLD_STOPPED;
}

/* Stands for a shell with job control, so that ^Z stops the program and this
 * goes on with it, and a terminal that goes hangs it up. */
static void
be_shell(const struct walk *w, const char *terminal, int tell)
{
	/* Keys that it gets itself while the program is stopped. */
	static const int KEPT_OFF[] = {SIGTTOU, SIGINT, SIGQUIT, SIGTSTP};
	struct termios was;
	struct news news = {0};
	struct sigaction passes = {
	    .sa_handler = hang_up, .sa_flags = SA_RESTART};
	setsid();
	int fd = open(terminal, O_RDWR);
	if (fd < 0 || ioctl(fd, TIOCSCTTY, 0) != 0)
		_exit(98);
	for (int i = 0; i < 3; i++)
		dup2(fd, i);
	for (size_t i = 0; i < ARRAY_LEN(KEPT_OFF); i++)
		signal(KEPT_OFF[i], SIG_IGN);
	tcgetattr(0, &was);
	pid_t pid = fork();
	if (pid == 0) {
		setpgid(0, 0);
		tcsetpgrp(0, getpid());
		for (size_t i = 0; i < ARRAY_LEN(KEPT_OFF); i++)
			signal(KEPT_OFF[i], SIG_DFL);
		close(tell);
		become_program(w);
	}
	job = pid;
	sigaction(SIGHUP, &passes, NULL);
	news.program = pid;
	ssize_t written = write(tell, &news, sizeof news);
	int status;
	while (wait_for_stop(pid)) {
		bool changed = !same_settings(&was);
		siginfo_t what = {0};
		/* Who was told to go on meanwhile may have the terminal. */
		waitid(P_PID, (id_t)pid, &what, WSTOPPED | WNOHANG);
		if (what.si_pid != pid)
			continue;
		news.changed |= changed;
		tcsetpgrp(0, getpgrp());
		nap(3);
		tcsetpgrp(0, pid);
		kill(-pid, SIGCONT);
	}
	waitpid(pid, &status, 0);
	news.changed |= !same_settings(&was);
	news.status = status;
	written += write(tell, &news, sizeof news);
	_exit(written != 2 * sizeof news);
}

static int
remove_one(const char *path, const struct stat *s, int kind, struct FTW *f)
{
	(void)s, (void)kind, (void)f;
	return remove(path);
}

static void
copy_in(const char *folder, const char *name)
{
	const char *srcdir = getenv("srcdir");
	char *command = xasprintf("mkdir -p %s/data/sites && cp %s/data/%s "
				  "%s/data/%s && chmod u+w %s/data/%s",
	    folder, srcdir != NULL ? srcdir : ".", name, folder, name, folder,
	    name);
	if (system(command) != 0)
		exit(99);
	free(command);
}

static void
make_folder(struct course *c, const struct walk *w)
{
	const char *where = getenv("TMPDIR");
	snprintf(c->folder, sizeof c->folder, "%s/tipspeed-typist-XXXXXX",
	    where != NULL ? where : "/tmp");
	if (mkdtemp(c->folder) == NULL) {
		perror(c->folder);
		exit(99);
	}
	copy_in(c->folder, "sites/tierp.csv");
	copy_in(c->folder, "sites/bro.csv");
	char *path = xasprintf("%s/inputrc", c->folder);
	put_file(path, w->inputrc);
	free(path);
	/* fontconfig keeps what it found to the end of the program, ncurses
	 * what it made for a terminal that it then refuses, and readline what
	 * it was at when it gave up. */
	path = xasprintf("%s/leaks", c->folder);
	put_file(path, "leak:libfontconfig\nleak:libtinfo\nleak:libreadline\n");
	free(path);
}

static void
resize(const struct course *c, int rows, int columns)
{
	struct winsize size = {
	    .ws_row = (unsigned short)rows, .ws_col = (unsigned short)columns};
	ioctl(c->master, TIOCSWINSZ, &size);
}

static void
start(struct course *c, const struct walk *w)
{
	int both[2];
	struct news news;
	make_folder(c, w);
	c->master = posix_openpt(O_RDWR | O_NOCTTY);
	if (c->master < 0) {
		printf("1..0 # SKIP no pseudo-terminal here\n");
		exit(0);
	}
	if (grantpt(c->master) != 0 || unlockpt(c->master) != 0 ||
	    pipe(both) != 0) {
		perror("terminal");
		exit(99);
	}
	fcntl(c->master, F_SETFL, O_NONBLOCK);
	resize(c, 24, 80);
	c->shell = fork();
	if (c->shell == 0) {
		char *terminal = xstrdup(ptsname(c->master));
		close(c->master);
		close(both[0]);
		setenv("HOME", c->folder, 1);
		if (chdir(c->folder) == 0)
			be_shell(w, terminal, both[1]);
		_exit(98);
	}
	close(both[1]);
	c->news = both[0];
	if (read(c->news, &news, sizeof news) != sizeof news)
		exit(99);
	c->program = news.program;
}

/* ---- a walk */

enum { KEPT = 3000 };

static void
keep(struct course *c, const char *bytes, size_t n)
{
	if (c->last == NULL)
		c->last = xcalloc(2 * KEPT + 4096, 1);
	memcpy(c->last + c->last_n, bytes, n);
	c->last_n += n;
	if (c->last_n > 2 * KEPT) {
		memmove(c->last, c->last + c->last_n - KEPT, KEPT);
		c->last_n = KEPT;
	}
}

/* Reads what is written for so many ms, and quiet: until nothing more comes.
 * False when the program has ended. */
static bool
listen_for(struct course *c, int ms, int quiet)
{
	double end = now() + 1e-3 * ms;
	char bytes[4096];
	struct news news;
	while (!c->over) {
		struct pollfd in[2] = {{.fd = c->master, .events = POLLIN},
		    {.fd = c->news, .events = POLLIN}};
		int left = (int)(1e3 * (end - now()));
		int wait = quiet > 0 && quiet < left ? quiet : left;
		if (poll(in, 2, wait > 0 ? wait : 0) == 0 &&
		    (wait == quiet || wait <= 0))
			return true;
		ssize_t n = in[0].fd >= 0 && in[0].revents != 0
				? read(c->master, bytes, sizeof bytes)
				: 0;
		if (n > 0)
			keep(c, bytes, (size_t)n);
		else if (in[0].revents & POLLHUP)
			nap(1);
		if (n <= 0 && in[1].revents != 0) {
			c->over = true;
			if (read(c->news, &news, sizeof news) != sizeof news)
				news = (struct news){.status = 98 << 8};
			c->status = news.status;
			c->changed = news.changed;
		}
		if (now() >= end)
			break;
	}
	return !c->over;
}

static void
take_step(struct course *c, const struct step *step)
{
	size_t n = strlen(step->keys);
	switch (step->kind) {
	case KEYS:
		for (size_t i = 0; i < n && !c->over;) {
			ssize_t got = write(c->master, step->keys + i, n - i);
			if (got < 0 && errno != EAGAIN && errno != EINTR)
				return;
			i += got > 0 ? (size_t)got : 0;
			if (i < n)
				listen_for(c, 5, 0);
		}
		break;
	case SIGNAL:
		kill(c->program, step->a);
		break;
	case SIZE:
		resize(c, step->a, step->b);
		break;
	case NAP:
		listen_for(c, step->a, 0);
	}
}

static void
play(struct course *c, const struct walk *w)
{
	const double patience = now() + LIMIT_CLOCK;
	/* Before it catches signals ^C ends it as any program. */
	while (c->last_n == 0 && listen_for(c, 100, 0) && now() < patience)
		;
	listen_for(c, 5000, 150);
	for (size_t i = 0; i < w->n && !c->over; i++) {
		take_step(c, &w->step[i]);
		/* Some keys in one go, and some into what the last did. */
		if (i % 4 == 3)
			listen_for(c, 60, 15);
		else
			listen_for(c, 1, 0);
	}
}

/* Whether it runs, sleeps or is stopped, and who traces it: a sanitizer does
 * while it looks for leaks. */
static void
take_state(struct course *c)
{
	char line[80], *path = xasprintf("/proc/%d/status", (int)c->program);
	FILE *in = fopen(path, "r");
	size_t n = 0;
	while (in != NULL && fgets(line, sizeof line, in) != NULL) {
		line[strcspn(line, "\n")] = '\0';
		if (strncmp(line, "State:", 6) == 0 ||
		    strncmp(line, "TracerPid:", 10) == 0)
			n += (size_t)snprintf(c->state + n, sizeof c->state - n,
			    "%s%s", n > 0 ? ", " : "", line);
	}
	if (in != NULL)
		fclose(in);
	free(path);
}

/* False where it had to be killed. */
static bool
end(struct course *c, const struct walk *w)
{
	if (c->over)
		return true;
	double began = now(), used = processor_time(c->program);
	/* A ^Z that meets a pager before it is one stops that alone, and no
	 * shell is told. */
	kill(-c->program, SIGCONT);
	if (w->ending != 0)
		kill(c->program, w->ending);
	else
		close(c->master), c->master = -1;
	for (;;) {
		if (!listen_for(c, 50, 0))
			return true;
		double clock = now() - began;
		double own = processor_time(c->program) - used;
		if ((clock > LIMIT && own > LIMIT) || clock > LIMIT_CLOCK)
			break;
	}
	take_state(c);
	kill(c->program, SIGKILL);
	listen_for(c, 5000, 0);
	return false;
}

/* ---- findings */

static void
escaped(const char *bytes, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		unsigned char b = (unsigned char)bytes[i];
		if (b >= ' ' && b < 127 && b != '\\')
			putchar(b);
		else
			printf("\\%03o", b);
	}
}

static void
tell_walk(const struct walk *w)
{
	printf("#   TERM=%s LC_ALL=%s INPUTRC: ", w->term, w->locale);
	escaped(w->inputrc, strlen(w->inputrc));
	printf("\n#   tipspeed");
	for (size_t i = 0; w->argument[i] != NULL; i++)
		printf(" '%s'", w->argument[i]);
	putchar('\n');
	for (size_t i = 0; i < w->n; i++) {
		const struct step *s = &w->step[i];
		printf("#   %3zu ", i + 1);
		switch (s->kind) {
		case KEYS:
			printf("keys ");
			escaped(s->keys, strlen(s->keys));
			break;
		case SIGNAL:
			printf("signal %d", s->a);
			break;
		case SIZE:
			printf("size %d x %d", s->a, s->b);
			break;
		case NAP:
			printf("wait %d ms", s->a);
		}
		putchar('\n');
	}
	printf("#   the end: %s %d\n", w->ending != 0 ? "signal" : "hang-up",
	    w->ending);
}

/* The sanitizer's own words; false where there are none. */
static bool
tell_reports(const char *folder, bool tell)
{
	char *command = xasprintf(
	    tell ? "head -n 40 %s/report.* 2>/dev/null | sed 's/^/#   /'"
		 : "ls %s/report.* >/dev/null 2>&1",
	    folder);
	fflush(stdout);
	bool found = system(command) == 0;
	free(command);
	return found;
}

/* What is wrong with how it ended, or NULL. */
static const char *
fault(const struct course *c, const struct walk *w, bool ended)
{
	const int s = c->status;
	if (!ended)
		return w->ending != 0 ? "a signal is not answered"
				      : "it does not end with its terminal";
	if (tell_reports(c->folder, false))
		return "a sanitizer's report";
	if (WIFSIGNALED(s))
		return "ended by a signal that was not sent";
	if (!WIFEXITED(s))
		return "neither ended nor stopped";
	int status = WEXITSTATUS(s);
	bool noted = status == 128 + SIGINT || status == 128 + SIGHUP ||
		     status == 128 + SIGTERM;
	if (status == REPORTED || (status > 5 && !noted))
		return "a status that is not documented";
	if (c->changed && w->ending != 0)
		return "the terminal's settings are not as they were";
	return NULL;
}

/* Plays a walk; what is wrong with it, or NULL. */
static const char *
walk(const struct walk *w, bool tell)
{
	struct course c = {0};
	start(&c, w);
	play(&c, w);
	bool ended = end(&c, w);
	const char *wrong = fault(&c, w, ended);
	if (wrong != NULL && tell) {
		printf("# %s: SEED=%ju, status %s%d\n", wrong,
		    (uintmax_t)w->seed, WIFSIGNALED(c.status) ? "signal " : "",
		    WIFSIGNALED(c.status) ? WTERMSIG(c.status)
					  : WEXITSTATUS(c.status));
		tell_walk(w);
		if (c.state[0] != '\0')
			printf("#   it was killed: %s\n", c.state);
		tell_reports(c.folder, true);
		printf("#   it wrote last: ");
		escaped(c.last != NULL ? c.last : "", c.last_n);
		putchar('\n');
	}
	if (c.master >= 0)
		close(c.master);
	close(c.news);
	waitpid(c.shell, NULL, 0);
	nftw(c.folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
	free(c.last);
	return wrong;
}

static void
without(struct walk *w, size_t from, size_t n)
{
	memmove(w->step + from, w->step + from + n,
	    (w->n - from - n) * sizeof w->step[0]);
	w->n -= n;
}

/* Leaves steps out, many and then few at a time, as long as the same is wrong.
 * What depends on the time may come back only now and then, so that each is
 * tried twice. */
static void
shrink(struct walk *w, const char *wrong)
{
	static struct walk less;
	for (size_t n = w->n / 2; n > 0; n /= 2)
		for (size_t from = 0; from + n <= w->n;) {
			less = *w;
			without(&less, from, n);
			if (walk(&less, false) == wrong ||
			    walk(&less, false) == wrong)
				*w = less;
			else
				from += n;
		}
}

static double
wanted(const char *name, double otherwise)
{
	const char *text = getenv(name);
	return text != NULL && text[0] != '\0' ? strtod(text, NULL) : otherwise;
}

/* A few walks, or for so many seconds, from a seed on; how many had a finding.
 */
static uint64_t
many_walks(uint64_t *seed, double seconds)
{
	enum { FEW = 6 };
	static struct walk w;
	const double end = now() + seconds;
	const uint64_t from = *seed;
	uint64_t bad = 0;
	do {
		make_walk(&w, (*seed)++);
		bad += walk(&w, true) != NULL;
		fflush(stdout);
	} while (seconds > 0 ? now() < end : *seed < from + FEW);
	return bad;
}

static bool
one_walk(uint64_t seed)
{
	static struct walk w;
	make_walk(&w, seed);
	double most = wanted("STEPS", STEPS);
	w.n = (double)w.n < most ? w.n : (size_t)most;
	const char *wrong = walk(&w, true);
	if (wrong != NULL && wanted("SHRINK", 0) > 0) {
		shrink(&w, wrong);
		walk(&w, true);
	}
	return wrong != NULL;
}

int
main(void)
{
	static const char *const OTHERS[] = {"NO_COLOR", "TIPSPEED_COLOR",
	    "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "LANGUAGE"};
	const bool all = wanted("TIPSPEED_TEST_LONG", 0) > 0;
	const double one = wanted("SEED", 0);
	const uint64_t from = (uint64_t)wanted("FROM", 1);
	uint64_t seed = from, bad;
	signal(SIGPIPE, SIG_IGN);
	for (size_t i = 0; i < ARRAY_LEN(OTHERS); i++)
		unsetenv(OTHERS[i]);
	bad = one > 0 ? one_walk((uint64_t)one)
		      : many_walks(&seed, wanted("SECONDS", all ? 1800 : 0));
	printf("%sok 1 - walks at the terminal from seed %ju on, %ju with a "
	       "finding\n1..1\n",
	    bad > 0 ? "not " : "", (uintmax_t)(one > 0 ? one : (double)from),
	    (uintmax_t)bad);
	return bad > 0;
}
