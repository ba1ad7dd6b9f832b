/* Draws frames on a canvas, which ncurses then shows.  Only that step depends
 * on ncurses.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/screen.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cli/restore.h"
#include "cli/terminal.h"

/* screen: NULL if frames are drawn but not shown.  frame: the last one, or
 * NULL.  ncurses has state of its own besides this. */
static struct display {
	SCREEN *screen;
	bool utf8, mouse, only_text;
	int depth, rows, columns;
	enum charset charset;
	enum theme theme;
	short pair[SERIES_COUNT]; /* 0 without colours */
	struct canvas *frame;
} display;

/* Series of the same colour share a pair, because ncurses would otherwise write
 * the colour again between them. */
static void
set_curses_colours(bool colour)
{
	display.depth = 0;
	memset(display.pair, 0, sizeof display.pair);
	if (!colour || !has_colors() || start_color() != OK)
		return;
	use_default_colors();
	display.depth = COLORS >= 256 ? 256 : COLORS >= 16 ? 16 : 8;
	for (int i = 0; i < SERIES_COUNT; i++) {
		int of = palette_colour_of_series(
		    (enum series)i, display.depth, display.theme);
		int j = 0;
		while (palette_colour_of_series(
			   (enum series)j, display.depth, display.theme) != of)
			j++;
		display.pair[i] = (short)(j + 1);
		init_pair(display.pair[i], (short)(of % display.depth), -1);
	}
	/* From one colour to another pair takes 5 bytes, to no pair 11. */
	bkgdset(' ' | COLOR_PAIR(display.pair[SERIES_TEXT]));
}

static void
set_terminal_modes(void)
{
	raw();
	noecho();
	nonl();
	keypad(stdscr, TRUE);
	nodelay(stdscr, TRUE);
	meta(stdscr, TRUE);
	set_escdelay(25);
	/* Sequences that most terminals send, whatever their descriptions
	 * say. */
	define_key("\033[A", KEY_UP);
	define_key("\033[B", KEY_DOWN);
	define_key("\033[C", KEY_RIGHT);
	define_key("\033[D", KEY_LEFT);
	define_key("\033[H", KEY_HOME);
	define_key("\033[F", KEY_END);
	define_key("\033[1;2D", KEY_SLEFT);
	define_key("\033[1;2C", KEY_SRIGHT);
	define_key("\033[1~", KEY_HOME);
	define_key("\033[4~", KEY_END);
	define_key("\033[5~", KEY_PPAGE);
	define_key("\033[6~", KEY_NPAGE);
	define_key("\033[200~", SCREEN_PASTE);
	define_key("\033[201~", SCREEN_PASTED);
	/* The description of the Linux console makes ^Z a key of its own. */
	define_key("\032", 0);
}

/* Makes the terminal mark pasted text, if it is one that ignores unknown
 * modes. */
static void
set_bracketed_paste(bool on)
{
	const char *cup = tigetstr("cup");
	if (cup == NULL || strncmp(cup, "\033[", 2) != 0)
		return;
	putp(on ? "\033[?2004h" : "\033[?2004l");
	fflush(stdout);
}

void
screen_set_theme(enum theme theme)
{
	bool other = theme != display.theme;
	display.theme = theme;
	if (other && display.screen != NULL && display.depth > 0)
		set_curses_colours(true);
}

bool
screen_open(bool colour)
{
	if (terminal_is_dumb())
		return false;
	display.screen = newterm(NULL, stdout, stdin);
	if (display.screen == NULL)
		return false;
	if (tigetstr("cup") == NULL) {
		endwin();
		delscreen(display.screen);
		return false;
	}
	restore_arm_tty_for_screen();
	display.utf8 = terminal_is_utf8();
	display.charset =
	    terminal_has_line_drawing() ? CHARSET_BRAILLE : CHARSET_ASCII;
	set_terminal_modes();
	set_curses_colours(colour);
	set_bracketed_paste(true);
	return true;
}

/* Ends ncurses.  If the terminal has no second screen, the picture stays, and
 * the shell continues in a row below it. */
static void
end_curses(void)
{
	screen_set_mouse(false);
	set_bracketed_paste(false);
	move(LINES - 1, 0);
	clrtoeol();
	refresh();
	endwin();
}

void
screen_close(void)
{
	end_curses();
	delscreen(display.screen);
	canvas_free(display.frame);
	display = (struct display){0};
}

struct display *
screen_begin_offscreen(int rows, int columns, enum charset charset, int depth)
{
	struct display *was = xcalloc(1, sizeof *was);
	*was = display;
	display = (struct display){.rows = rows,
	    .columns = columns,
	    .charset = charset,
	    .depth = depth,
	    .utf8 = true};
	return was;
}

struct canvas *
screen_end_offscreen(struct display *was)
{
	struct canvas *frame = display.frame;
	display = *was;
	free(was);
	return frame;
}

const struct canvas *
screen_last_frame(void)
{
	return display.frame;
}

void
screen_omit_charts_and_lines(bool on)
{
	display.only_text = on;
}

void
screen_size(int *rows, int *columns)
{
	*rows = display.rows;
	*columns = display.columns;
}

enum charset
screen_charset(void)
{
	return display.charset;
}

int
screen_colour_count(void)
{
	return display.depth;
}

/* Returns true if the terminal reports the mouse.  The description of the Linux
 * console says that it does, but its mouse is that of gpm, which does not
 * report in this way. */
static bool
has_mouse_reports(void)
{
	if (strncmp(termname(), "linux", 5) == 0)
		return false;
	const char *keys = tigetstr("kmous");
	return keys != NULL && keys != (const char *)-1 && keys[0] != '\0';
}

/* Mode 1002 reports motion while a button is held; ncurses asks for clicks
 * only. */
bool
screen_set_mouse(bool on)
{
	if (display.screen == NULL)
		return true;
	if (on && !has_mouse_reports())
		return false;
	if (on)
		mousemask(ALL_MOUSE_EVENTS | REPORT_MOUSE_POSITION, NULL);
	if (on || display.mouse)
		putp(on ? "\033[?1002h" : "\033[?1002l");
	if (!on)
		mousemask(0, NULL);
	mouseinterval(0);
	fflush(stdout);
	display.mouse = on;
	return true;
}

void
screen_suspend_curses(void)
{
	bool mouse = display.mouse;
	def_prog_mode();
	end_curses();
	display.mouse = mouse;
	fflush(stdout);
}

void
screen_resume_curses(void)
{
	reset_prog_mode();
	bool mouse = display.mouse;
	screen_resize();
	refresh();
	set_bracketed_paste(true);
	if (mouse)
		screen_set_mouse(true);
}

void
screen_resize(void)
{
	struct winsize size = {0};
	if (display.screen == NULL)
		return;
	/* When this runs out of memory, ncurses 6.4 has corrupted the heap. */
	if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 &&
	    size.ws_col > 0 && resizeterm(size.ws_row, size.ws_col) == ERR)
		xalloc_fail();
	clearok(curscr, TRUE);
}

void
screen_begin_frame(int *rows, int *columns)
{
	if (display.screen != NULL)
		getmaxyx(stdscr, display.rows, display.columns);
	canvas_free(display.frame);
	display.frame = canvas_new(display.columns, display.rows);
	display.frame->theme = display.theme;
	screen_size(rows, columns);
}

static void
screen_set_cell(
    int row, int column, uint32_t code, unsigned look, enum series series)
{
	if (row < 0 || row >= display.rows || column < 0 ||
	    column >= display.columns)
		return;
	*canvas_cell_at(display.frame, column, row) = (struct canvas_cell){
	    code, (unsigned char)series, (unsigned char)look};
}

int
screen_draw_clipped_text(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text)
{
	if (row < 0 || row >= area->rows || column < 0)
		return column;
	return canvas_draw_text_within(display.frame, area->column + column,
		   area->row + row, area->column + area->columns, text, series,
		   look) -
	       area->column;
}

int
screen_draw_text_in_series_colour(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text)
{
	FREED char *fitted = text_cut_to_width(text, area->columns - column);
	bool whole = strcmp(fitted, text) == 0;
	int end =
	    screen_draw_clipped_text(area, row, column, series, look, fitted);
	return whole || row < 0 || row >= area->rows ? end : area->columns;
}

int
screen_draw_text(const struct area *area, int row, int column, unsigned look,
    const char *format, ...)
{
	char text[512];
	va_list ap;
	va_start(ap, format);
	vsnprintf(text, sizeof text, tr(format), ap);
	va_end(ap);
	return screen_draw_text_in_series_colour(
	    area, row, column, SERIES_TEXT, look, text);
}

int
screen_draw_wrapped_rows(const struct area *area, int row, int rows,
    unsigned look, const char *text, const char *more)
{
	char *wrapped = text_wrapped(text, area->columns), *save = NULL;
	for (char *line = strtok_r(wrapped, "\n", &save);
	     line != NULL && rows > 0; line = strtok_r(NULL, "\n", &save)) {
		bool cut = --rows == 0 && *save != '\0';
		FREED char *part = text_wrapped(line,
		    area->columns - (cut ? text_width_in_columns(more) : 0));
		part[strcspn(part, "\n")] = '\0';
		int end = screen_draw_text_in_series_colour(
		    area, row, 0, SERIES_TEXT, look, part);
		if (cut)
			screen_draw_text_in_series_colour(
			    area, row, end, SERIES_TEXT, look, more);
		row++;
	}
	free(wrapped);
	return row;
}

int
screen_draw_wrapped(
    const struct area *area, int row, unsigned look, const char *text)
{
	return screen_draw_wrapped_rows(
	    area, row, area->rows - row, look, text, " ..");
}

void
screen_clear_area(const struct area *area)
{
	for (int row = 0; row < area->rows; row++)
		screen_draw_text(area, row, 0, 0, "%*s", area->columns, "");
}

void
screen_draw_horizontal_rule(const struct area *area)
{
	bool lines = display.charset != CHARSET_ASCII;
	for (int c = 0;
	     c < area->columns && area->rows > 0 && !display.only_text; c++)
		screen_set_cell(area->row, area->column + c,
		    lines ? 0x2500 : '-', LOOK_DIM, SERIES_TEXT);
}

void
screen_draw_vertical_rule(int row, int column, int rows)
{
	bool lines = display.charset != CHARSET_ASCII;
	for (int r = 0; r < rows && !display.only_text; r++)
		screen_set_cell(row + r, column, lines ? 0x2502 : '|', LOOK_DIM,
		    SERIES_TEXT);
}

void
screen_draw_canvas(const struct area *area, const struct canvas *canvas)
{
	if (display.only_text)
		return;
	for (int r = 0; r < area->rows && r < canvas->rows; r++)
		for (int c = 0; c < area->columns && c < canvas->columns; c++) {
			const struct canvas_cell *at =
			    &canvas->cell[r * canvas->columns + c];
			if (at->code != 0)
				screen_set_cell(area->row + r, area->column + c,
				    at->code, at->attribute,
				    (enum series)at->series);
		}
}

/* Returns the attributes of a cell.  With eight colours, bright ones are
 * bold. */
static attr_t
curses_attributes_of_cell(const struct canvas_cell *cell)
{
	unsigned look = cell->attribute;
	enum series series = (enum series)cell->series;
	bool faint = canvas_is_cell_faint(display.frame, cell, display.depth);
	bool bright =
	    display.depth == 8 &&
	    palette_colour_of_series(series, display.depth, display.theme) >= 8;
	return ((look & LOOK_BOLD) || bright ? A_BOLD : 0) |
	       (faint ? A_DIM : 0) | ((look & LOOK_REVERSE) ? A_REVERSE : 0);
}

/* Returns a letter without its accent, for a terminal with ASCII only; '?' if
 * there is no such letter. */
static wchar_t
letter_without_accent(uint32_t code)
{
	char letter[5], *folded = text_fold_case_and_accents(
			    canvas_encode_code_point(code, letter));
	char bare = folded[0] > 0 && folded[1] == '\0' ? folded[0] : '?';
	bool capital = code >= 0xC0 && code < 0xDF && bare >= 'a';
	free(folded);
	return capital ? bare - 'a' + 'A' : bare;
}

/* Gives ncurses a cell.  Blank cells have been erased; the right half of a wide
 * letter comes with the left. */
static void
add_cell_to_curses(int row, int column)
{
	const struct canvas_cell *from =
	    canvas_cell_at(display.frame, column, row);
	wchar_t text[2] = {(wchar_t)from->code, 0};
	cchar_t cell;
	if (from->code == 0 ||
	    (from->code == ' ' && !(from->attribute & CELL_REVERSE)))
		return;
	if (!display.utf8 && from->code > 126)
		text[0] = letter_without_accent(from->code);
	setcchar(&cell, text, curses_attributes_of_cell(from),
	    display.pair[from->series], NULL);
	mvadd_wch(row, column, &cell);
}

void
screen_show_frame(int row, int column)
{
	if (display.screen == NULL)
		return;
	erase();
	for (int r = 0; r < display.rows; r++)
		for (int c = 0; c < display.columns; c++)
			add_cell_to_curses(r, c);
	move(row < display.rows ? row : display.rows - 1,
	    column < display.columns ? column : display.columns - 1);
	refresh();
}
