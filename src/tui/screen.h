/* The terminal as a full screen: ncurses, opened, written on and put away.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCREEN_H
#define TIPSPEED_TUI_SCREEN_H

#include <stdbool.h>

#include "plot/canvas.h"
#include "tui/layout.h"

/* How a piece of text looks: bits. */
enum {
	LOOK_PLAIN = 0,
	LOOK_BOLD = CELL_BOLD,
	LOOK_DIM = CELL_DIM,
	LOOK_REVERSE = CELL_REVERSE
};

/* Codes of the marks around pasted text, in no terminal's description. */
enum { SCREEN_PASTE = 0x7000, SCREEN_PASTED };

/* Takes the terminal over.  False where it has no such abilities or ncurses
 * does not know it; then nothing is changed. */
bool screen_open(bool colour);
void screen_close(void);

/* Draws aside of any terminal, with all characters there are, on frames of
 * that size, until screen_back: that gives the terminal back, where there is
 * one, and returns the last frame, which the caller frees, or NULL without one.
 * The two may be nested. */
struct display;
struct display *screen_aside(
    int rows, int columns, enum charset charset, int depth);
struct canvas *screen_back(struct display *was);

/* Leaves out canvases, rules and walls of what is drawn aside, for a screen
 * reader. */
void screen_only_text(bool on);

/* The last one, which stays with the screen; NULL where there was none. */
const struct canvas *screen_frame(void);

/* Of the last frame. */
void screen_size(int *rows, int *columns);

/* What lines are drawn with here. */
enum charset screen_charset(void);

/* Number of colours in use, 0 without. */
int screen_depth(void);

/* The colours from the next frame on. */
void screen_theme(enum theme theme);

/* Has the mouse reported or not; false where the terminal has none. */
bool screen_mouse(bool on);
bool screen_mouse_on(void);

/* Leaves the terminal to somebody else for a while, and takes it back. */
void screen_leave(void);
void screen_return(void);

/* Asks the terminal for its size; all is drawn again. */
void screen_resize(void);

/* A new frame, of the size it has now. */
void screen_begin(int *rows, int *columns);

/* UTF-8 from the cell of an area on, cut at its right edge; nothing below its
 * last row.  Returns the column after it, within the area. */
int screen_text(const struct area *area, int row, int column, unsigned look,
    const char *format, ...) __attribute__((format(printf, 5, 6)));

/* The same in the colour of a series. */
int screen_series(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text);

/* Text in as many rows of the area as it takes, broken at spaces.  Returns the
 * row after it. */
int screen_words(
    const struct area *area, int row, unsigned look, const char *text);

/* The same in so many rows at most: what is cut ends in `more`, as " ..". */
int screen_words_within(const struct area *area, int row, int rows,
    unsigned look, const char *text, const char *more);

/* Blanks all over the area. */
void screen_clear(const struct area *area);

/* A line along the row, or along the column, of the area. */
void screen_rule(const struct area *area);
void screen_wall(int row, int column, int rows);

/* A canvas at the top left of an area, which is as large or larger. */
void screen_canvas(const struct area *area, const struct canvas *canvas);

/* Ends the frame with the cursor there: what changed is sent. */
void screen_show(int row, int column);

#endif
