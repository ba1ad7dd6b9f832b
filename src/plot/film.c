/* Cells that come and go at the same time are one group, which CSS shows for
 * that time: nothing is ever painted over.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/film.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "plot/picture.h"

static bool
is_same(const struct canvas_cell *a, const struct canvas_cell *b)
{
	return a->code == b->code && a->series == b->series &&
	       a->attribute == b->attribute;
}

static size_t
cells_of(const struct canvas *canvas)
{
	return (size_t)(canvas->columns * canvas->rows);
}

static struct canvas *
last_of(const struct film *film)
{
	return film->n > 0 ? film->canvas[film->n - 1] : NULL;
}

static bool
is_like(const struct canvas *a, const struct canvas *b)
{
	size_t i = 0, n = cells_of(a);
	while (i < n && is_same(&a->cell[i], &b->cell[i]))
		i++;
	return i == n;
}

void
film_add(struct film *film, const struct canvas *frame, unsigned ms)
{
	if (film->n > 0 && is_like(last_of(film), frame)) {
		film->ms[film->n - 1] += ms;
		return;
	}
	size_t n = film->n++;
	film->canvas = xrealloc(film->canvas, n + 1, sizeof(*film->canvas));
	film->ms = xrealloc(film->ms, n + 1, sizeof *film->ms);
	film->canvas[n] = canvas_new(frame->columns, frame->rows);
	memcpy(film->canvas[n]->cell, frame->cell,
	    cells_of(frame) * sizeof *frame->cell);
	film->ms[n] = ms;
}

void
film_free(struct film *film)
{
	for (size_t i = 0; i < film->n; i++)
		canvas_free(film->canvas[i]);
	free(film->canvas);
	free(film->ms);
	*film = (struct film){0};
}

/* A cell as it is from frame `from` until before frame `to`. */
struct stay {
	size_t from, to, cell;
};

struct stays {
	size_t n;
	struct stay *at;
};

static int
compare(const void *a, const void *b)
{
	const struct stay *x = a, *y = b;
	if (x->from != y->from)
		return x->from < y->from ? -1 : 1;
	if (x->to != y->to)
		return x->to < y->to ? -1 : 1;
	return (x->cell > y->cell) - (x->cell < y->cell);
}

/* Whether a cell is other than in the frame before; both halves of a wide
 * letter are taken together. */
static bool
changes(const struct film *film, size_t frame, size_t cell)
{
	const struct canvas_cell *was = film->canvas[frame - 1]->cell;
	const struct canvas_cell *now = film->canvas[frame]->cell;
	size_t n = cells_of(film->canvas[frame]);
	bool other = !is_same(&was[cell], &now[cell]);
	if (now[cell].code == 0 || was[cell].code == 0)
		other = other || !is_same(&was[cell - 1], &now[cell - 1]);
	if (cell + 1 < n &&
	    (now[cell + 1].code == 0 || was[cell + 1].code == 0))
		other = other || !is_same(&was[cell + 1], &now[cell + 1]);
	return other;
}

static bool
is_blank(const struct canvas_cell *cell)
{
	return (cell->code == ' ' || cell->code == 0x2800) &&
	       !(cell->attribute & CELL_REVERSE);
}

static struct stays
find_stays(const struct film *film)
{
	struct stays s = {0};
	size_t room = 0;
	for (size_t c = 0; c < cells_of(film->canvas[0]); c++)
		for (size_t from = 0, to; from < film->n; from = to) {
			to = from + 1;
			while (to < film->n && !changes(film, to, c))
				to++;
			if (is_blank(&film->canvas[from]->cell[c]))
				continue;
			if (s.n == room) {
				room = 2 * room + 256;
				s.at = xrealloc(s.at, room, sizeof *s.at);
			}
			s.at[s.n++] = (struct stay){from, to, c};
		}
	if (s.n > 0)
		qsort(s.at, s.n, sizeof *s.at, compare);
	return s;
}

/* A pen for less than pen_svg needs: whole numbers of PICTURE_GRID, looks by
 * class.  text, x: short texts of one row and look, which are written as one
 * with a place for each letter; most of what changes are digits. */
struct pencil {
	struct pen pen;
	FILE *out;
	char look[40], *text, *x;
};

static long
grid(double points)
{
	return lround(points / PICTURE_GRID);
}

static void
put_bars(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_bar *bar)
{
	FILE *out = ((struct pencil *)pen)->out;
	long at[2] = {0, 0};
	fprintf(out, "<path class=\"s%d\" stroke-width=\"%.3g\"",
	    (int)bar->series, bar->width / PICTURE_GRID);
	if (bar->opacity < 1)
		fprintf(out, " stroke-opacity=\"%g\"", bar->opacity);
	if (!bar->round)
		fputs(" stroke-linecap=\"butt\"", out);
	fputs(" d=\"", out);
	for (size_t i = 0; i < 2 * n; i += 2) {
		const long from[2] = {grid(x[i]), grid(y[i])};
		const long to[2] = {grid(x[i + 1]), grid(y[i + 1])};
		fprintf(out, "%c%ld %ld", i == 0 ? 'M' : 'm', from[0] - at[0],
		    from[1] - at[1]);
		if (from[1] == to[1])
			fprintf(out, "h%ld", to[0] - from[0]);
		else
			fprintf(
			    out, "l%ld %ld", to[0] - from[0], to[1] - from[1]);
		at[0] = to[0];
		at[1] = to[1];
	}
	fputs("\"/>", out);
}

static void
put_texts(struct pencil *pencil)
{
	if (pencil->text == NULL)
		return;
	fprintf(pencil->out, "<text %s x=\"%s\">", pencil->look, pencil->x);
	text_put_xml(pencil->text, pencil->out);
	fputs("</text>", pencil->out);
	free(pencil->text);
	free(pencil->x);
	pencil->text = pencil->x = NULL;
}

static void
put_text(struct pen *pen, double x, double y, const char *text,
    const struct pen_style *style)
{
	enum { SHORT = 6 };
	struct pencil *pencil = (struct pencil *)pen;
	const long one = grid(style->size * PICTURE_LETTER);
	char look[sizeof pencil->look];
	snprintf(look, sizeof look, "class=\"t%d%s%s\" y=\"%ld\"",
	    style->inverse ? SERIES_COUNT : (int)style->series,
	    style->bold ? " b" : "", style->faint ? " f" : "", grid(y));
	if (pencil->text != NULL && strcmp(look, pencil->look) != 0)
		put_texts(pencil);
	memcpy(pencil->look, look, sizeof look);
	if (text_width(text) > SHORT || text_width(text) != (int)strlen(text)) {
		fprintf(pencil->out, "<text %s x=\"%ld\" textLength=\"%ld\">",
		    look, grid(x), grid(style->length));
		text_put_xml(text, pencil->out);
		fputs("</text>", pencil->out);
		return;
	}
	if (pencil->text == NULL) {
		pencil->text = xstrdup("");
		pencil->x = xstrdup("");
	}
	for (long i = 0; text[i] != '\0'; i++)
		xlist(&pencil->x, " ", "%ld", grid(x) + one * i);
	xappend(&pencil->text, "%s", text);
}

/* Where in a round a frame begins, %. */
static double
share(const struct film *film, size_t frame)
{
	double before = 0, all = 0;
	for (size_t i = 0; i < film->n; i++) {
		before += i < frame ? film->ms[i] : 0;
		all += film->ms[i];
	}
	return 100 * before / all;
}

/* The stay after the group that begins at one. */
static size_t
group_end(const struct stays *stays, size_t first)
{
	const struct stay *a = &stays->at[first];
	size_t i = first;
	while (i < stays->n && stays->at[i].from == a->from &&
	       stays->at[i].to == a->to)
		i++;
	return i;
}

static bool
is_always(const struct film *film, const struct stay *stay)
{
	return stay->from == 0 && stay->to == film->n;
}

/* When a group is seen; without motion it is as its attribute says. */
static void
put_times(
    const struct film *film, const struct stay *stay, size_t id, FILE *out)
{
	double from = share(film, stay->from), to = share(film, stay->to);
	fprintf(out, "@keyframes k%zu{", id);
	if (stay->from == 0)
		fputs("0%{visibility:visible}", out);
	else if (stay->to == film->n)
		fprintf(out, "0%%{visibility:hidden}%.4g%%{visibility:visible}",
		    from);
	else
		fprintf(out,
		    "0%%,%.4g%%{visibility:hidden}%.4g%%{visibility:visible}",
		    to, from);
	if (stay->from == 0)
		fprintf(out, "%.4g%%{visibility:hidden}", to);
	fprintf(out, "}#k%zu{animation-name:k%zu}\n", id, id);
}

static void
put_style(const struct film *film, const struct stays *stays,
    const struct pen_paper *paper, FILE *out)
{
	double ms = 0;
	fprintf(
	    out, "<style>\n.b{font-weight:bold}.f{fill-opacity:%g}", PEN_FAINT);
	for (int i = 0; i < SERIES_COUNT; i++)
		fprintf(out, ".s%d{stroke:#%06x}.t%d{fill:#%06x}", i,
		    paper->ink[i], i, paper->ink[i]);
	for (size_t i = 0; i < film->n; i++)
		ms += film->ms[i];
	fprintf(out,
	    ".t%d{fill:#%06x}\n"
	    "@media (prefers-reduced-motion:no-preference){\n"
	    "g{animation:%gs step-end infinite}\n",
	    SERIES_COUNT, paper->colour, ms / 1000);
	for (size_t i = 0, id = 0; i < stays->n; i = group_end(stays, i))
		if (!is_always(film, &stays->at[i]))
			put_times(film, &stays->at[i], id++, out);
	fputs("}\n</style>\n", out);
}

/* The cells of a group; what is always there has no name. */
static void
put_group(const struct film *film, const struct stays *stays, size_t first,
    size_t *id, int depth, FILE *out)
{
	struct pencil pencil = {
	    .pen = {.bars = put_bars, .text = put_text}, .out = out};
	const struct stay *stay = &stays->at[first];
	const struct canvas *frame = film->canvas[stay->from];
	struct canvas *part = canvas_new(frame->columns, frame->rows);
	for (size_t i = first, end = group_end(stays, first); i < end; i++)
		part->cell[stays->at[i].cell] = frame->cell[stays->at[i].cell];
	if (is_always(film, stay))
		fputs("<g>", out);
	else
		fprintf(out, "<g id=\"k%zu\"%s>", (*id)++,
		    stay->to < film->n ? " visibility=\"hidden\"" : "");
	picture_cells_draw(part, depth, &pencil.pen);
	put_texts(&pencil);
	fputs("</g>\n", out);
	canvas_free(part);
}

bool
film_write(const struct film *film, int depth, const char *title,
    const char *about, FILE *out)
{
	static const double letters = 10;
	double size[2];
	struct pen_paper paper =
	    picture_cells_paper(film->canvas[0], depth, size);
	struct stays stays = find_stays(film);
	long width = grid(size[0]), height = grid(size[1]);
	fprintf(out,
	    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
	    "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
	    "width=\"%gpt\" height=\"%gpt\" viewBox=\"0 0 %ld %ld\" "
	    "font-family=\"%s\" font-size=\"%.4g\" "
	    "stroke-linecap=\"round\">\n<title>",
	    size[0], size[1], width, height, PEN_MONO, letters / PICTURE_GRID);
	text_put_xml(title, out);
	fputs("</title>\n<desc>", out);
	text_put_xml(about, out);
	fputs("</desc>\n", out);
	put_style(film, &stays, &paper, out);
	fprintf(out,
	    "<rect x=\"0.5\" y=\"0.5\" width=\"%ld\" height=\"%ld\" rx=\"%g\" "
	    "fill=\"#%06x\" stroke=\"#%06x\"/>\n",
	    width - 1, height - 1, paper.corner / PICTURE_GRID, paper.colour,
	    paper.edge);
	for (size_t i = 0, id = 0; i < stays.n; i = group_end(&stays, i))
		put_group(film, &stays, i, &id, depth, out);
	fputs("</svg>\n", out);
	free(stays.at);
	return !ferror(out);
}
