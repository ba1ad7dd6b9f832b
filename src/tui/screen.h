/* The terminal as a full screen, by ncurses.
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

/* Codes of the marks around pasted text, which no terminal's description
 * contains. */
enum { SCREEN_PASTE = 0x7000, SCREEN_PASTED };

/* Takes over the terminal.  False, and nothing changed, if the terminal lacks
 * the abilities or ncurses does not know it. */
bool screen_open(bool colour);
void screen_close(void);

/* From screen_aside until screen_back frames are drawn apart from any terminal,
 * with all characters, in that size.  screen_back gives the terminal back, if
 * there is one, and returns the last frame, which the caller frees, or NULL
 * without one.  Pairs may be nested. */
struct display;
struct display *screen_aside(
    int rows, int columns, enum charset charset, int depth);
struct canvas *screen_back(struct display *was);

/* Leaves out canvases, rules and walls of frames drawn apart, for a screen
 * reader. */
void screen_only_text(bool on);

/* Returns the last frame, which the screen owns; NULL if there is none. */
const struct canvas *screen_frame(void);

/* The size of the last frame. */
void screen_size(int *rows, int *columns);

/* Returns the characters that lines are drawn with. */
enum charset screen_charset(void);

/* Returns the number of colours in use, 0 without. */
int screen_depth(void);

/* Sets the colours from the next frame on. */
void screen_theme(enum theme theme);

/* Turns reports of the mouse on or off; false if the terminal has no mouse. */
bool screen_mouse(bool on);
bool screen_mouse_on(void);

/* screen_leave leaves the terminal to another program, screen_return takes it
 * back. */
void screen_leave(void);
void screen_return(void);

/* Asks the terminal for its size; everything is drawn again. */
void screen_resize(void);

/* Begins a frame, in the terminal's present size. */
void screen_begin(int *rows, int *columns);

/* Draws UTF-8 from a cell of an area on, fitted (see text_fitted) where the
 * area's right edge would cut it; nothing below its last row.  Returns the
 * column after it, within the area. */
int screen_text(const struct area *area, int row, int column, unsigned look,
    const char *format, ...) __attribute__((format(printf, 5, 6)));

/* As screen_text, in the colour of a series. */
int screen_series(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text);

/* As screen_series, of a text that goes on behind the edge. */
int screen_part(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text);

/* Draws text in as many rows of the area as it needs, broken at spaces; what
 * these do not hold is " ..".  Returns the row after it. */
int screen_words(
    const struct area *area, int row, unsigned look, const char *text);

/* As screen_words, in at most `rows` rows: text that is cut ends in `more`, as
 * " ..". */
int screen_words_within(const struct area *area, int row, int rows,
    unsigned look, const char *text, const char *more);

/* Clears the area. */
void screen_clear(const struct area *area);

/* Draw a line along the area's row, or down a column. */
void screen_rule(const struct area *area);
void screen_wall(int row, int column, int rows);

/* Draws a canvas at the top left of an area, which is as large or larger. */
void screen_canvas(const struct area *area, const struct canvas *canvas);

/* Ends the frame, with the cursor at that cell, and sends what changed. */
void screen_show(int row, int column);

#endif
