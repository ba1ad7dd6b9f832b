/* The terminal as a full screen, using ncurses.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCREEN_H
#define TIPSPEED_TUI_SCREEN_H

#include <stdbool.h>

#include "plot/canvas.h"
#include "tui/layout.h"

/* The look of a piece of text, as bits. */
enum {
	LOOK_PLAIN = 0,
	LOOK_BOLD = CELL_BOLD,
	LOOK_DIM = CELL_DIM,
	LOOK_REVERSE = CELL_REVERSE
};

/* Codes for the marks around pasted text, which no terminal description
 * contains. */
enum { SCREEN_PASTE = 0x7000, SCREEN_PASTED };

/* Takes control of the terminal.  Returns false and changes nothing if ncurses
 * does not know the terminal, or if it cannot move its cursor. */
bool screen_open(bool colour);
void screen_close(void);

/* Between screen_begin_offscreen and screen_end_offscreen, frames are drawn in
 * that size without a terminal, with all letters.  screen_end_offscreen
 * restores the terminal, if any, and returns the last frame, or NULL if none
 * was drawn; the caller frees it.  Pairs may be nested. */
struct display;
struct display *screen_begin_offscreen(
    int rows, int columns, enum charset charset, int depth);
struct canvas *screen_end_offscreen(struct display *was);

/* If `on`, leaves charts and lines between areas out of offscreen frames, for a
 * screen reader. */
void screen_omit_charts_and_lines(bool on);

/* Returns the last frame, which the screen owns, or NULL.  For tests. */
const struct canvas *screen_last_frame(void);

/* Returns the size of the last frame. */
void screen_size(int *rows, int *columns);

/* Returns the characters with which lines are drawn. */
enum charset screen_charset(void);

/* Returns the number of colours in use, or 0. */
int screen_colour_count(void);

/* Sets the colours from the next frame on. */
void screen_set_theme(enum theme theme);

/* Turns mouse reports on or off.  Returns false if the terminal has no
 * mouse. */
bool screen_set_mouse(bool on);

/* screen_suspend_curses leaves the terminal to another program;
 * screen_resume_curses takes it back. */
void screen_suspend_curses(void);
void screen_resume_curses(void);

/* Queries the terminal's size and redraws everything. */
void screen_resize(void);

/* Begins a frame of the terminal's current size. */
void screen_begin_frame(int *rows, int *columns);

/* Draws UTF-8 text from a cell of an area, shortened (text_cut_to_width) if it
 * would cross the right edge; draws nothing below the last row.  Returns the
 * column after the text, within the area. */
int screen_draw_text(const struct area *area, int row, int column,
    unsigned look, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* As screen_draw_text, in the colour of a series. */
int screen_draw_text_in_series_colour(const struct area *area, int row,
    int column, enum series series, unsigned look, const char *text);

/* As screen_draw_text_in_series_colour, for the visible part of a text that
 * continues beyond the edge. */
int screen_draw_clipped_text(const struct area *area, int row, int column,
    enum series series, unsigned look, const char *text);

/* Draws text in as many rows of the area as needed, broken at spaces; the rest,
 * if any, becomes " ..".  Returns the row after it. */
int screen_draw_wrapped(
    const struct area *area, int row, unsigned look, const char *text);

/* As screen_draw_wrapped, in at most `rows` rows; text that is cut ends in
 * `more`, such as " ..". */
int screen_draw_wrapped_rows(const struct area *area, int row, int rows,
    unsigned look, const char *text, const char *more);

/* Clears the area. */
void screen_clear_area(const struct area *area);

/* screen_draw_horizontal_rule draws a line along the first row of an area;
 * screen_draw_vertical_rule draws one down a column. */
void screen_draw_horizontal_rule(const struct area *area);
void screen_draw_vertical_rule(int row, int column, int rows);

/* Draws a canvas at the top left of an area, which must be at least as
 * large. */
void screen_draw_canvas(const struct area *area, const struct canvas *canvas);

/* Ends the frame, with the cursor at that cell, and sends the changes. */
void screen_show_frame(int row, int column);

#endif
