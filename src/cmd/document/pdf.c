/* Lays out a document on A4 pages, more than once: first to count the pages
 * and, if it has to fit on one page, to find the scale.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/document/pdf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "config.h"
#include "plot/picture.h"

/* In points.  LINE: the height of a line, in sizes of its letters. */
static const double SHORT_SIDE = 595.28, LONG_SIDE = 841.89, MARGIN = 42,
		    FOOT = 26, LINE = 1.3, GAP = 9;

struct pdf_layout {
	const struct document *document;
	double scale; /* of letters and distances */
	bool across;  /* the long side of the page is horizontal */
	size_t pages; /* in all; 0 while not known */
	struct pen *pen;
	double width, height; /* of the page */
	double y;             /* where the next part begins */
	size_t page;          /* the current one; at the end, the last */
	/* A table is too wide for the page, so its letters are smaller than the
	 * scale asks for. */
	bool shrunk;
};

static struct pen_style
scaled_text_style(const struct pdf_layout *p, double size, bool bold)
{
	return (struct pen_style){.size = size * p->scale, .bold = bold};
}

static double
width_within_margins(const struct pdf_layout *p)
{
	return p->width - 2 * MARGIN;
}

/* Draws a horizontal line from the left margin to `end`. */
static void
pdf_draw_horizontal_line(
    struct pdf_layout *p, double end, double y, double width)
{
	double x[] = {MARGIN, end}, at[] = {y, y};
	p->pen->path(p->pen, x, at, 2,
	    &(struct pen_stroke){SERIES_FEED, CHART_SOLID, width, PEN_OPEN});
}

static void
pdf_draw_page_foot(struct pdf_layout *p)
{
	struct pen_style style = {.size = 8};
	double y = p->height - FOOT;
	pdf_draw_horizontal_line(p, p->width - MARGIN, y - 10, 0.4);
	p->pen->text(p->pen, MARGIN, y, p->document->made_by, &style);
	style.anchor = PEN_END;
	FREED char *number =
	    xasprintf(tr("page %zu of %zu"), p->page, p->pages);
	p->pen->text(p->pen, p->width - MARGIN, y, number, &style);
}

static void
pdf_next_page(struct pdf_layout *p)
{
	pdf_draw_page_foot(p);
	p->pen->next(p->pen);
	p->page++;
	p->y = MARGIN;
}

/* Begins a new page, and returns true, unless a part of this height fits on the
 * current one. */
static bool
begin_page_unless_fits(struct pdf_layout *p, double height)
{
	if (p->y + height <= p->height - FOOT - 16 || p->y <= MARGIN)
		return false;
	pdf_next_page(p);
	return true;
}

static void
pdf_move_down(struct pdf_layout *p, double points)
{
	if (p->y > MARGIN)
		p->y += points * p->scale;
}

/* Returns how many bytes of the text fit on a line: whole words or, if not even
 * one fits, part of a word. */
static size_t
text_length_fitting_line(struct pdf_layout *p, const char *text, double width,
    const struct pen_style *style)
{
	size_t fits = 0;
	for (size_t n = 0; text[n] != '\0';) {
		const char *next = text + n;
		text_next_code_point(&next);
		size_t end = (size_t)(next - text);
		FREED char *part = xstrndup(text, end);
		bool wide = p->pen->width(p->pen, part, style) > width;
		if (wide && n > 0)
			return fits > 0 ? fits : n;
		n = end;
		if (text[n] == ' ' || text[n] == '\0')
			fits = n;
	}
	return strlen(text);
}

/* A text broken into lines. */
struct lines {
	size_t n;
	char **line;
};

static struct lines
break_into_lines(struct pdf_layout *p, const char *words, double width,
    const struct pen_style *style)
{
	struct lines lines = {0};
	FREED char *shown = text_with_control_escaped(words);
	const char *text = shown;
	do {
		size_t n =
		    p->pen->width(p->pen, text, style) <= width
			? strlen(text)
			: text_length_fitting_line(p, text, width, style);
		lines.line =
		    xgrow_by_one(lines.line, lines.n, sizeof *lines.line);
		lines.line[lines.n++] = xstrndup(text, n);
		text += n;
		text += strspn(text, " ");
	} while (*text != '\0');
	return lines;
}

static void
lines_free(struct lines *lines)
{
	for (size_t i = 0; i < lines->n; i++)
		free(lines->line[i]);
	free(lines->line);
}

static void
pdf_put_paragraph(
    struct pdf_layout *p, const char *text, const struct pen_style *style)
{
	double line = LINE * style->size;
	struct lines lines =
	    break_into_lines(p, text, width_within_margins(p), style);
	for (size_t i = 0; i < lines.n; i++) {
		begin_page_unless_fits(p, line);
		p->y += line;
		p->pen->text(
		    p->pen, MARGIN, p->y - 0.25 * line, lines.line[i], style);
	}
	lines_free(&lines);
}

/* Puts the light in a frame, so that one notices it even without its colour. */
static void
pdf_put_trust_light(struct pdf_layout *p, const struct document_part *part)
{
	static const enum series INKS[] = {
	    SERIES_GREEN, SERIES_AMBER, SERIES_RED};
	enum { PAD = 8 };
	struct pen_style style = scaled_text_style(p, 11, true);
	double left = MARGIN, right = p->width - MARGIN;
	struct lines lines = break_into_lines(
	    p, part->text, width_within_margins(p) - 4 * PAD, &style);
	double height = (double)lines.n * LINE * style.size + 2 * PAD;
	pdf_move_down(p, 4);
	begin_page_unless_fits(p, height);
	double x[] = {left, right, right, left, left};
	double y[] = {p->y, p->y, p->y + height, p->y + height, p->y};
	double bar[] = {left, left + PAD, left + PAD, left};
	struct pen_stroke stroke = {
	    INKS[part->light], CHART_SOLID, 1.2, PEN_OPEN};
	p->pen->path(p->pen, x, y, ARRAY_LEN(x), &stroke);
	stroke.fill = PEN_FULL;
	p->pen->path(p->pen, bar, y, ARRAY_LEN(bar), &stroke);
	for (size_t i = 0; i < lines.n; i++)
		p->pen->text(p->pen, left + 2 * PAD,
		    p->y + PAD + ((double)i + 0.78) * LINE * style.size,
		    lines.line[i], &style);
	p->y += height;
	pdf_move_down(p, 6);
	lines_free(&lines);
}

static void
pdf_put_text_lines(struct pdf_layout *p, const char *text)
{
	struct pen_style style = scaled_text_style(p, 7.5, false);
	char *line;
	style.mono = true;
	while ((line = document_copy_next_text_line(&text)) != NULL) {
		pdf_put_paragraph(p, line, &style);
		free(line);
	}
}

/* Columns of a table that are put side by side. */
struct table_part {
	const struct answer_view *view;
	/* The columns [n] and their widths; the size of the letters. */
	size_t n, *column;
	double *width, size;
};

static double
longest_word_width(
    struct pdf_layout *p, const char *text, const struct pen_style *style)
{
	double most = 0;
	char *copy = xstrdup(text), *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save))
		most = fmax(most, p->pen->width(p->pen, word, style));
	free(copy);
	return most;
}

/* Makes columns as wide as their numbers and the words of their headings; texts
 * wider than `most` will be broken.  Returns the total width. */
static double
measure_column_widths(struct pdf_layout *p, struct table_part *g, double most)
{
	struct pen_style head = scaled_text_style(p, g->size, true);
	struct pen_style body = scaled_text_style(p, g->size, false);
	double sum = -GAP * p->scale;
	for (size_t i = 0; i < g->n; i++) {
		size_t c = g->column[i];
		double w = longest_word_width(p, g->view->head[c], &head);
		for (size_t r = 0; r < g->view->n_row; r++) {
			const struct answer_cell *cell =
			    &g->view->cell[r * g->view->n_column + c];
			double its = p->pen->width(p->pen, cell->text, &body);
			w = fmax(w, cell->is_text ? fmin(its, most) : its);
		}
		g->width[i] = w;
		sum += w + GAP * p->scale;
	}
	return sum;
}

/* Finds widths that fit the page: first breaks texts, then makes the letters
 * smaller. */
static void
fit_column_widths_to_page(struct pdf_layout *p, struct table_part *g)
{
	double room = width_within_margins(p), most = room;
	g->size = 8.5;
	while (measure_column_widths(p, g, most) > room && g->size > 4) {
		if (most > 0.25 * room) {
			most *= 0.9;
		} else {
			g->size *= 0.95;
			p->shrunk = true;
		}
	}
}

/* Puts a row; row 0 is that of the headings. */
static void
pdf_put_row(struct pdf_layout *p, const struct table_part *g, size_t row)
{
	struct pen_style style = scaled_text_style(p, g->size, row == 0);
	double line = LINE * style.size, x = MARGIN;
	FREED struct lines *cell = xcalloc(g->n, sizeof *cell);
	size_t most = 1;
	for (size_t i = 0; i < g->n; i++) {
		size_t c = g->column[i];
		cell[i] = break_into_lines(p,
		    row == 0
			? g->view->head[c]
			: g->view->cell[(row - 1) * g->view->n_column + c].text,
		    g->width[i] + 0.01, &style);
		most = cell[i].n > most ? cell[i].n : most;
	}
	for (size_t k = 0; k < most; k++, x = MARGIN) {
		begin_page_unless_fits(p, line);
		p->y += line;
		for (size_t i = 0; i < g->n; i++) {
			bool right =
			    document_is_number_column(g->view, g->column[i]);
			/* Headings are aligned at the bottom of their row. */
			size_t from = row == 0 ? most - cell[i].n : 0;
			style.anchor = right ? PEN_END : PEN_START;
			if (k >= from && k - from < cell[i].n)
				p->pen->text(p->pen,
				    x + (right ? g->width[i] : 0),
				    p->y - 0.28 * line, cell[i].line[k - from],
				    &style);
			x += g->width[i] + GAP * p->scale;
		}
	}
	for (size_t i = 0; i < g->n; i++)
		lines_free(&cell[i]);
}

static double
table_rule_end_x(const struct pdf_layout *p, const struct table_part *g)
{
	double x = MARGIN - GAP * p->scale;
	for (size_t i = 0; i < g->n; i++)
		x += g->width[i] + GAP * p->scale;
	return x;
}

/* Puts all rows, and the headings again on each page. */
static void
pdf_put_table_columns(struct pdf_layout *p, struct table_part *g)
{
	double line = LINE * g->size * p->scale;
	fit_column_widths_to_page(p, g);
	begin_page_unless_fits(p, 5 * line);
	for (size_t row = 0; row <= g->view->n_row; row++) {
		bool again = row > 0 && begin_page_unless_fits(p, line);
		if (again)
			pdf_put_row(p, g, 0);
		if (again || row == 1) {
			pdf_draw_horizontal_line(
			    p, table_rule_end_x(p, g), p->y, 0.7);
			pdf_move_down(p, 1.5);
		}
		pdf_put_row(p, g, row);
	}
	pdf_draw_horizontal_line(p, table_rule_end_x(p, g), p->y + 1, 0.3);
	pdf_move_down(p, 5);
}

static void
pdf_put_table(struct pdf_layout *p, const struct answer_view *v)
{
	struct table_part g = {.view = v,
	    .column = xcalloc(v->n_column + 1, sizeof *g.column),
	    .width = xcalloc_doubles(v->n_column + 1)};
	bool all = p->document->one_page;
	for (size_t from, to = 0;
	     document_find_columns_that_fit(v, all, &from, &to);) {
		g.n = 0;
		g.size = 8.5;
		for (size_t c = 0; c < to; c = c == 0 ? from : c + 1)
			g.column[g.n++] = c;
		pdf_put_table_columns(p, &g);
	}
	free(g.column);
	free(g.width);
}

static void
pdf_put_sentences(
    struct pdf_layout *p, const struct answer_view *v, bool warnings)
{
	struct pen_style style = scaled_text_style(p, 9, warnings);
	for (size_t i = 0; i < v->n_sentence; i++)
		if ((v->sentence[i].grade == ANSWER_WARNING) == warnings) {
			pdf_put_paragraph(p, v->sentence[i].text, &style);
			pdf_move_down(p, 1.5);
		}
}

/* Returns how much of an answer has to be on the page of its title: the whole
 * table, unless that is long. */
static double
answer_height_kept_together(
    const struct pdf_layout *p, const struct answer_view *v)
{
	static const double TITLE = 40, ROW = 8.5, LEAST = 60, LONG = 0.45;
	double table = p->scale * (TITLE + LINE * ROW * (double)(v->n_row + 2));
	return table > LONG * p->height ? LEAST * p->scale : table;
}

static void
pdf_put_answer(struct pdf_layout *p, const struct answer *answer, bool top)
{
	struct answer_view v = answer_view(answer);
	struct pen_style title = scaled_text_style(p, 9.5, true);
	struct pen_style about = scaled_text_style(p, 8, false);
	about.series = SERIES_FEED;
	pdf_move_down(p, 6);
	begin_page_unless_fits(p, answer_height_kept_together(p, &v));
	if (v.title != NULL && !top)
		pdf_put_paragraph(p, v.title, &title);
	if (v.provenance != NULL) {
		FREED char *text = xasprintf(tr("Data: %s"), v.provenance);
		pdf_put_paragraph(p, text, &about);
	}
	pdf_put_sentences(p, &v, true);
	pdf_move_down(p, 3);
	pdf_put_table(p, &v);
	pdf_put_sentences(p, &v, false);
}

static const char PROGRAM[] = "tipspeed " PACKAGE_VERSION;

static double
scale_of_picture_in_pdf(const struct pdf_layout *p)
{
	return fmin(p->scale, width_within_margins(p) / PICTURE_WIDTH);
}

static double
pdf_chart_height(const struct pdf_layout *p, const struct chart *chart)
{
	return scale_of_picture_in_pdf(p) *
	       chart_picture_height(chart, PROGRAM);
}

static void
pdf_put_chart(struct pdf_layout *p, const struct chart *chart)
{
	double height = pdf_chart_height(p, chart);
	pdf_move_down(p, 6);
	begin_page_unless_fits(p, height);
	p->pen->place(p->pen, MARGIN, p->y, scale_of_picture_in_pdf(p));
	chart_picture_draw(chart, PROGRAM, p->pen);
	p->pen->place(p->pen, 0, 0, 1);
	p->y += height;
}

/* Puts heading i on the same page as what follows, so that it does not end a
 * page. */
static void
pdf_put_heading(struct pdf_layout *p, size_t i)
{
	enum { OWN = 30, LEAST = 40 };
	const struct document *d = p->document;
	const struct document_part *next =
	    i + 1 < d->n ? &d->part[i + 1] : &d->part[i];
	struct pen_style style = scaled_text_style(p, 13, true);
	double kept = LEAST * p->scale;
	if (next->answer != NULL) {
		struct answer_view v = answer_view(next->answer);
		kept = answer_height_kept_together(p, &v);
	} else if (next->chart != NULL) {
		kept = pdf_chart_height(p, next->chart);
	}
	pdf_move_down(p, 14);
	begin_page_unless_fits(p, OWN * p->scale + kept);
	pdf_put_paragraph(p, d->part[i].text, &style);
	pdf_draw_horizontal_line(p, p->width - MARGIN, p->y + 1, 0.7);
	pdf_move_down(p, 3);
}

static void
pdf_put_document_part(struct pdf_layout *p, size_t i)
{
	const struct document_part *part = &p->document->part[i];
	struct pen_style style =
	    scaled_text_style(p, 9, part->kind == DOCUMENT_WARNING);
	switch (part->kind) {
	case DOCUMENT_HEADING:
		pdf_put_heading(p, i);
		break;
	case DOCUMENT_WORDS:
	case DOCUMENT_WARNING:
		pdf_put_paragraph(p, part->text, &style);
		pdf_move_down(p, 2);
		break;
	case DOCUMENT_LIGHT:
		pdf_put_trust_light(p, part);
		break;
	case DOCUMENT_TEXT:
		pdf_put_text_lines(p, part->text);
		break;
	case DOCUMENT_ANSWER:
		pdf_put_answer(p, part->answer, i == p->document->titled_by);
		break;
	case DOCUMENT_PICTURE:
		pdf_put_chart(p, part->chart);
		break;
	}
}

/* Lays out all parts at the scale of the layout, and returns the bytes of the
 * file, or NULL on failure. */
static char *
lay_out_pdf(struct pdf_layout *p, size_t *n)
{
	const struct document *d = p->document;
	char *bytes = NULL;
	FILE *out = text_open_memory(&bytes, n);
	p->width = p->across ? LONG_SIDE : SHORT_SIDE;
	p->height = p->across ? SHORT_SIDE : LONG_SIDE;
	p->y = MARGIN;
	p->page = 1;
	p->shrunk = false;
	p->pen = picture_new_pdf_pages(
	    p->width, p->height, d->title, d->made_by, out);
	bool ok = p->pen != NULL;
	if (ok) {
		struct pen_style title = scaled_text_style(p, 16, true);
		pdf_put_paragraph(p, d->title, &title);
		for (size_t i = 0; i < d->n; i++)
			pdf_put_document_part(p, i);
		pdf_draw_page_foot(p);
		ok = p->pen->close(p->pen);
	}
	fclose(out);
	if (!ok)
		xfree_and_set(&bytes, NULL);
	return bytes;
}

/* Finds the largest scale at which all fits on one page, upright or across,
 * without shrinking a table. */
static void
scale_to_one_page(struct pdf_layout *p)
{
	enum { STEPS = 7 };
	size_t n;
	double best = 0.3;
	bool best_across = false;
	for (int across = 0; across < 2; across++) {
		double low = best, high = 2;
		p->across = across == 1;
		for (int i = 0; i < STEPS; i++) {
			p->scale = (low + high) / 2;
			free(lay_out_pdf(p, &n));
			if (p->page == 1 && !p->shrunk) {
				low = best = p->scale;
				best_across = p->across;
			} else {
				high = p->scale;
			}
		}
	}
	p->scale = best;
	p->across = best_across;
}

char *
document_to_pdf(const struct document *d, size_t *n, size_t *pages)
{
	struct pdf_layout p = {.document = d, .scale = 1};
	if (!picture_can_draw_format(PICTURE_PDF))
		return NULL;
	if (d->one_page)
		scale_to_one_page(&p);
	free(lay_out_pdf(&p, n));
	p.pages = p.page;
	char *bytes = lay_out_pdf(&p, n);
	*pages = p.page;
	return bytes;
}
