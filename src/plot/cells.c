/* Cells of a terminal as a picture: runs of text, and shapes for what is to
 * join from cell to cell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "plot/pen.h"

/* In points: a cell is as wide as most monospaced letters of its size. */
#define CELL_WIDTH 6.0
#define CELL_HEIGHT 12.0
#define LETTERS 10.0
#define BASE_LINE 9.25
#define MARGIN 8.0

/* What bars of one kind have in common. */
enum kind { GROUND, SHADE, BLOCK, LINE, HEAVY, DOT, KINDS };
static const struct {
	double width, opacity;
	bool round;
} KIND[KINDS] = {[GROUND] = {CELL_HEIGHT, 1, false},
    [SHADE] = {CELL_HEIGHT, 0.3, false},
    [BLOCK] = {CELL_HEIGHT / 2, 1, false},
    [LINE] = {0.8, 1, true},
    [HEAVY] = {1.6, 1, true},
    [DOT] = {2.3, 1, true}};

/* In eighths of the cell. */
struct bar {
	unsigned char x0, y0, x1, y1;
};

enum { BARS = 8 };

/* Characters that are drawn with a pen. */
static const struct shape {
	uint32_t code;
	enum kind kind;
	unsigned n;
	struct bar bar[4];
} SHAPES[] = {{0x00B7, DOT, 1, {{4, 4, 4, 4}}},
    {0x2500, LINE, 1, {{0, 4, 8, 4}}}, {0x2501, HEAVY, 1, {{0, 4, 8, 4}}},
    {0x2502, LINE, 1, {{4, 0, 4, 8}}},
    {0x2508, LINE, 2, {{1, 4, 2, 4}, {5, 4, 6, 4}}},
    {0x250A, LINE, 2, {{4, 1, 4, 2}, {4, 5, 4, 6}}},
    {0x2514, LINE, 2, {{4, 0, 4, 4}, {4, 4, 8, 4}}},
    {0x2524, LINE, 2, {{4, 0, 4, 8}, {0, 4, 4, 4}}},
    {0x252C, LINE, 2, {{0, 4, 8, 4}, {4, 4, 4, 8}}},
    {0x254C, LINE, 2, {{0, 4, 2, 4}, {5, 4, 7, 4}}},
    {0x254E, LINE, 2, {{4, 0, 4, 3}, {4, 5, 4, 7}}},
    {0x2591, SHADE, 1, {{0, 4, 8, 4}}}};

/* Quarters of a cell that are full: top left, top right, and below them. */
static unsigned
quarters(uint32_t code)
{
	static const struct {
		uint32_t code;
		unsigned set;
	} CODES[] = {{0x2580, 3}, {0x2584, 12}, {0x2588, 15}, {0x258C, 5},
	    {0x2590, 10}, {0x2596, 4}, {0x2597, 8}, {0x2598, 1}, {0x2599, 13},
	    {0x259A, 9}, {0x259B, 7}, {0x259C, 11}, {0x259D, 2}, {0x259E, 6},
	    {0x259F, 14}};
	for (size_t i = 0; i < ARRAY_LEN(CODES); i++)
		if (CODES[i].code == code)
			return CODES[i].set;
	return 0;
}

/* The shape of a character; n is 0 for one that is text. */
static size_t
shape_of(uint32_t code, enum kind *kind, struct bar bar[static BARS])
{
	/* Dots 1 to 8 of braille: column, row. */
	static const unsigned char DOTS[BARS][2] = {
	    {2, 1}, {2, 3}, {2, 5}, {6, 1}, {6, 3}, {6, 5}, {2, 7}, {6, 7}};
	size_t n = 0;
	for (size_t i = 0; i < ARRAY_LEN(SHAPES); i++)
		if (SHAPES[i].code == code) {
			*kind = SHAPES[i].kind;
			memcpy(bar, SHAPES[i].bar, sizeof SHAPES[i].bar);
			return SHAPES[i].n;
		}
	if (code >= 0x2800 && code <= 0x28FF) {
		*kind = DOT;
		for (unsigned i = 0; i < BARS; i++)
			if (code >> i & 1)
				bar[n++] = (struct bar){DOTS[i][0], DOTS[i][1],
				    DOTS[i][0], DOTS[i][1]};
		return n;
	}
	unsigned set = quarters(code);
	*kind = BLOCK;
	for (unsigned i = 0; i < 4; i++)
		if (set >> i & 1) {
			unsigned char x = i % 2 ? 4 : 0, y = i / 2 ? 6 : 2;
			bar[n++] =
			    (struct bar){x, y, (unsigned char)(x + 4), y};
		}
	return n;
}

struct sheet {
	const struct canvas *canvas;
	struct pen *pen;
	int depth; /* of colour; with 256 what is dim is faint */
	double *x, *y;
	size_t n; /* bars gathered in x, y [2 n] */
};

static const struct canvas_cell *
cell_at(const struct sheet *s, int column, int row)
{
	return &s->canvas->cell[row * s->canvas->columns + column];
}

static bool
is_faint(const struct sheet *s, const struct canvas_cell *cell)
{
	return s->depth >= 256 && (cell->attribute & CELL_DIM);
}

/* The places of bars are multiples of 3/4. */
static bool
is_same(double a, double b)
{
	return fabs(a - b) < 0.1;
}

/* A level one that begins where the last one ends makes that longer. */
static void
gather(struct sheet *s, int column, int row, const struct bar *bar)
{
	double left = MARGIN + CELL_WIDTH * column;
	double top = MARGIN + CELL_HEIGHT * row;
	double x0 = left + bar->x0 * CELL_WIDTH / 8;
	double y0 = top + bar->y0 * CELL_HEIGHT / 8;
	size_t last = s->n > 0 ? 2 * s->n - 1 : 0;
	bool joins = s->n > 0 && bar->y0 == bar->y1 && bar->x1 > bar->x0 &&
		     is_same(s->x[last], x0) && is_same(s->y[last], y0) &&
		     is_same(s->y[last - 1], y0);
	if (!joins) {
		s->x[2 * s->n] = x0;
		s->y[2 * s->n] = y0;
		last = 2 * s->n++ + 1;
	}
	s->x[last] = left + bar->x1 * CELL_WIDTH / 8;
	s->y[last] = top + bar->y1 * CELL_HEIGHT / 8;
}

/* All bars of a kind and colour at once: a screen has thousands. */
static void
draw_bars(struct sheet *s, enum kind kind, enum series series, bool faint)
{
	static const struct bar whole = {0, 4, 8, 4};
	s->n = 0;
	for (int row = 0; row < s->canvas->rows; row++)
		for (int column = 0; column < s->canvas->columns; column++) {
			const struct canvas_cell *cell =
			    cell_at(s, column, row);
			enum kind its;
			struct bar bar[BARS];
			if (kind == SHADE && canvas_is_shaded(cell, s->depth)) {
				if (series == SERIES_BAND && !faint)
					gather(s, column, row, &whole);
				continue;
			}
			if (cell->series != series ||
			    is_faint(s, cell) != faint)
				continue;
			if (kind == GROUND) {
				if (cell->attribute & CELL_REVERSE)
					gather(s, column, row, &whole);
				continue;
			}
			size_t n = shape_of(cell->code, &its, bar);
			for (size_t i = 0; i < n && its == kind; i++)
				gather(s, column, row, &bar[i]);
		}
	if (s->n > 0)
		s->pen->bars(s->pen, s->x, s->y, s->n,
		    &(struct pen_bar){series, KIND[kind].width,
			KIND[kind].opacity * (faint ? PEN_FAINT : 1),
			KIND[kind].round});
}

static bool
is_text(const struct canvas_cell *cell)
{
	enum kind kind;
	struct bar bar[BARS];
	return cell->code > ' ' && cell->code != 0x2800 &&
	       shape_of(cell->code, &kind, bar) == 0;
}

static bool
is_alike(const struct canvas_cell *a, const struct canvas_cell *b)
{
	return a->series == b->series && a->attribute == b->attribute;
}

/* The column behind a run of text from `from` on: cells alike, with no more
 * than one blank between two words. */
static int
run_end(const struct sheet *s, int from, int row)
{
	const struct canvas_cell *cell = cell_at(s, 0, row);
	int end = from + 1;
	for (int c = from + 1; c < s->canvas->columns; c++) {
		bool wide = cell[c].code == 0;
		bool text =
		    is_text(&cell[c]) && is_alike(&cell[c], &cell[from]);
		if (!wide && !text && (cell[c].code != ' ' || end < c))
			break;
		end = wide || text ? c + 1 : end;
	}
	return end;
}

static void
draw_text(struct sheet *s, int row)
{
	char *text = xcalloc((size_t)s->canvas->columns + 1, 5);
	for (int c = 0, end; c < s->canvas->columns; c = end) {
		const struct canvas_cell *cell = cell_at(s, c, row);
		char *at = text, code[5];
		end = c + 1;
		if (!is_text(cell))
			continue;
		end = run_end(s, c, row);
		for (int i = 0; i < end - c; i++)
			if (cell[i].code != 0)
				at =
				    stpcpy(at, canvas_utf8(cell[i].code, code));
		s->pen->text(s->pen, MARGIN + CELL_WIDTH * c,
		    MARGIN + CELL_HEIGHT * row + BASE_LINE, text,
		    &(struct pen_style){.size = LETTERS,
			.length = CELL_WIDTH * (end - c),
			.bold = cell->attribute & CELL_BOLD,
			.inverse = cell->attribute & CELL_REVERSE,
			.faint = is_faint(s, cell),
			.series = (enum series)cell->series});
	}
	free(text);
}

/* What xterm makes of a colour by its number. */
static unsigned
palette(int colour)
{
	static const unsigned FIRST[16] = {0x000000, 0xCD3131, 0x0DBC79,
	    0xCDCD00, 0x3B78FF, 0xBC3FBC, 0x11A8CD, 0xE5E5E5, 0x666666,
	    0xF14C4C, 0x23D18B, 0xF5F543, 0x61A2FF, 0xD670D6, 0x29B8DB,
	    0xFFFFFF};
	static const unsigned LEVEL[6] = {0, 95, 135, 175, 215, 255};
	if (colour < 16)
		return FIRST[colour];
	unsigned at = (unsigned)colour - 16;
	return LEVEL[at / 36] << 16 | LEVEL[at / 6 % 6] << 8 | LEVEL[at % 6];
}

bool
picture_cells(const struct canvas *canvas, int depth, enum picture_form form,
    const char *title, const char *about, FILE *out)
{
	struct pen_paper paper = {
	    .colour = 0x161B22, .edge = 0x484F58, .corner = 6, .mono = true};
	size_t most = 2 * BARS * (size_t)(canvas->columns * canvas->rows);
	struct sheet s = {.canvas = canvas,
	    .depth = depth,
	    .x = xdoubles(most),
	    .y = xdoubles(most)};
	for (int i = 0; i < SERIES_COUNT; i++) {
		int colour = canvas_colour((enum series)i, depth);
		paper.ink[i] = colour < 0 ? 0xDFE3E8 : palette(colour);
	}
	s.pen = pen_open(form, 2 * MARGIN + CELL_WIDTH * canvas->columns,
	    2 * MARGIN + CELL_HEIGHT * canvas->rows, &paper, title, about, out);
	for (int kind = 0; kind < KINDS; kind++)
		for (int i = 0; i < SERIES_COUNT; i++)
			for (int faint = 0; faint < 2; faint++)
				draw_bars(&s, (enum kind)kind, (enum series)i,
				    faint == 1);
	for (int row = 0; row < canvas->rows; row++)
		draw_text(&s, row);
	free(s.x);
	free(s.y);
	return s.pen->close(s.pen);
}
