/* ncurses, and nothing of what is shown on it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/screen.h"

#include <langinfo.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/rescue.h"
#include "ui/terminal.h"

/* ncurses keeps its state by itself, too. */
static struct {
	SCREEN *screen;
	bool utf8, mouse, wide_keys;
	int depth, rows, columns;
	enum charset charset;
	short pair[SERIES_COUNT]; /* 0 without colours */
} is;

/* The console has no braille, and a serial terminal nothing but ASCII. */
static enum charset
find_charset(void)
{
	const char *term = getenv("TERM");
	static const char *const plain[] = {"linux", "vt", "ansi", "cons"};
	for (size_t i = 0; i < ARRAY_LEN(plain) && term != NULL; i++)
		if (strncmp(term, plain[i], strlen(plain[i])) == 0)
			return CHARSET_ASCII;
	return is.utf8 ? CHARSET_BRAILLE : CHARSET_ASCII;
}

/* Series of one colour share a pair: ncurses would write the colour again from
 * one to the other. */
static void
set_colours(bool colour)
{
	is.depth = 0;
	memset(is.pair, 0, sizeof is.pair);
	if (!colour || !has_colors() || start_color() != OK)
		return;
	use_default_colors();
	is.depth = COLORS >= 256 ? 256 : COLORS >= 16 ? 16 : 8;
	for (int i = 0; i < SERIES_COUNT; i++) {
		int colour_of = canvas_colour((enum series)i, is.depth), j = 0;
		while (canvas_colour((enum series)j, is.depth) != colour_of)
			j++;
		is.pair[i] = (short)(j + 1);
		init_pair(is.pair[i], (short)colour_of, -1);
	}
	/* From a colour to a pair takes 5 bytes, to no pair at all 11. */
	bkgdset(' ' | COLOR_PAIR(is.pair[SERIES_TEXT]));
}

static void
set_modes(void)
{
	raw();
	noecho();
	nonl();
	keypad(stdscr, TRUE);
	nodelay(stdscr, TRUE);
	meta(stdscr, TRUE);
	set_escdelay(25);
}

bool
screen_open(bool colour)
{
	if (terminal_is_dumb())
		return false;
	is.screen = newterm(NULL, stdout, stdin);
	if (is.screen == NULL)
		return false;
	if (tigetstr("cup") == NULL) {
		endwin();
		delscreen(is.screen);
		return false;
	}
	rescue_prepare();
	is.utf8 = strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
	is.charset = find_charset();
	set_modes();
	set_colours(colour);
	screen_mouse(true);
	return true;
}

void
screen_close(void)
{
	screen_mouse(false);
	endwin();
	delscreen(is.screen);
	is.screen = NULL;
}

enum charset
screen_charset(void)
{
	return is.charset;
}

int
screen_depth(void)
{
	return is.depth;
}

static bool
has_mouse_keys(void)
{
	const char *keys = tigetstr("kmous");
	return keys != NULL && keys != (const char *)-1 && keys[0] != '\0';
}

/* ncurses asks for clicks only: 1002 reports motion while a button is held. */
bool
screen_mouse(bool on)
{
	if (on && !has_mouse_keys())
		return false;
	if (on)
		mousemask(ALL_MOUSE_EVENTS | REPORT_MOUSE_POSITION, NULL);
	if (on || is.mouse)
		putp(on ? "\033[?1002h" : "\033[?1002l");
	if (!on)
		mousemask(0, NULL);
	mouseinterval(0);
	fflush(stdout);
	is.mouse = on;
	return true;
}

void
screen_leave(void)
{
	bool mouse = is.mouse;
	screen_mouse(false);
	is.mouse = mouse;
	def_prog_mode();
	endwin();
	fflush(stdout);
}

void
screen_return(void)
{
	reset_prog_mode();
	bool mouse = is.mouse;
	screen_resize();
	refresh();
	if (mouse)
		screen_mouse(true);
}

void
screen_resize(void)
{
	struct winsize size = {0};
	if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 &&
	    size.ws_col > 0)
		resizeterm(size.ws_row, size.ws_col);
	clearok(curscr, TRUE);
}

void
screen_begin(int *rows, int *columns)
{
	erase();
	getmaxyx(stdscr, *rows, *columns);
	is.rows = *rows;
	is.columns = *columns;
}

static attr_t
attributes(unsigned look)
{
	return ((look & LOOK_BOLD) ? A_BOLD : 0) |
	       ((look & LOOK_DIM) && is.depth == 256 ? A_DIM : 0) |
	       ((look & LOOK_REVERSE) ? A_REVERSE : 0);
}

/* The next character of UTF-8; a byte that is none becomes '?'. */
static wchar_t
next_character(const char **text)
{
	const unsigned char *p = (const unsigned char *)*text;
	int more = p[0] >= 0xF0 ? 3 : p[0] >= 0xE0 ? 2 : p[0] >= 0xC0 ? 1 : 0;
	uint32_t code = more == 0 ? p[0] : p[0] & (0x3FU >> more);
	for (int i = 1; i <= more; i++) {
		if ((p[i] & 0xC0) != 0x80) {
			*text += i;
			return L'?';
		}
		code = code << 6 | (p[i] & 0x3F);
	}
	*text += more + 1;
	return code < ' ' || (more == 0 && code > 126) ? L'?' : (wchar_t)code;
}

static void
put_cell(int row, int column, uint32_t code, unsigned look, enum series series)
{
	wchar_t text[2] = {(wchar_t)code, 0};
	cchar_t cell;
	if (!is.utf8 && code > 126)
		text[0] = L'?';
	setcchar(&cell, text, attributes(look), is.pair[series], NULL);
	mvadd_wch(row, column, &cell);
}

/* A letter without its accent, where there is nothing but ASCII. */
static wchar_t
bare_letter(const char *bytes, size_t n)
{
	char *letter = xstrndup(bytes, n), *folded = text_fold(letter);
	wchar_t bare = folded[0] > 0 && folded[1] == '\0' ? folded[0] : L'?';
	free(letter);
	free(folded);
	return bare;
}

int
screen_series(const struct area *area, int row, int column, enum series series,
    unsigned look, const char *text)
{
	if (row < 0 || row >= area->rows || column < 0)
		return column;
	while (*text != '\0') {
		const char *from = text;
		wchar_t c = next_character(&text);
		if (!is.utf8 && c > 126)
			c = bare_letter(from, (size_t)(text - from));
		int width = is.utf8 ? wcwidth(c) : 1;
		if (width < 0 || column + width > area->columns)
			break;
		if (width > 0)
			put_cell(area->row + row, area->column + column,
			    (uint32_t)c, look, series);
		column += width;
	}
	return column;
}

int
screen_text(const struct area *area, int row, int column, unsigned look,
    const char *format, ...)
{
	char text[512];
	va_list ap;
	va_start(ap, format);
	vsnprintf(text, sizeof text, format, ap);
	va_end(ap);
	return screen_series(area, row, column, SERIES_TEXT, look, text);
}

void
screen_rule(const struct area *area)
{
	bool lines = is.charset != CHARSET_ASCII;
	for (int c = 0; c < area->columns && area->rows > 0; c++)
		put_cell(area->row, area->column + c, lines ? 0x2500 : '-',
		    LOOK_DIM, SERIES_TEXT);
}

void
screen_wall(int row, int column, int rows)
{
	bool lines = is.charset != CHARSET_ASCII;
	for (int r = 0; r < rows; r++)
		put_cell(row + r, column, lines ? 0x2502 : '|', LOOK_DIM,
		    SERIES_TEXT);
}

/* A blank shows no colour: it has that of the line which moves most, so that
 * less is written. */
static void
blank_row(int row, int column, int columns)
{
	cchar_t blank;
	setcchar(&blank, L" ", A_NORMAL, is.pair[SERIES_BREAK], NULL);
	mvhline_set(row, column, &blank, columns);
}

void
screen_canvas(const struct area *area, const struct canvas *canvas)
{
	int columns =
	    canvas->columns < area->columns ? canvas->columns : area->columns;
	for (int r = 0; r < canvas->rows && r < area->rows; r++) {
		blank_row(area->row + r, area->column, columns);
		const struct canvas_cell *at =
		    canvas->cell + r * canvas->columns;
		for (int c = 0; c < columns; c++, at++) {
			bool blank = at->code == ' ' && at->attribute == 0 &&
				     at->series == SERIES_TEXT;
			if (at->code != 0 && !blank)
				put_cell(area->row + r, area->column + c,
				    at->code, at->attribute,
				    (enum series)at->series);
		}
	}
}

void
screen_show(int row, int column)
{
	move(row < is.rows ? row : is.rows - 1,
	    column < is.columns ? column : is.columns - 1);
	wnoutrefresh(stdscr);
	doupdate();
}
