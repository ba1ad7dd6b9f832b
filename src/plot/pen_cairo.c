/* A pen that writes PNG and PDF through cairo.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cairo-pdf.h>
#include <cairo.h>
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "plot/pen.h"

/* Pixels of a PNG per point: 300 to the inch, as journals ask for. */
#define PNG_SCALE (300.0 / 72)

struct picture {
	struct pen pen;
	struct pen_paper paper;
	cairo_surface_t *surface;
	cairo_t *cairo;
	bool pdf;
	FILE *out;
};

static cairo_status_t
write_cairo_bytes(void *out, const unsigned char *bytes, unsigned n)
{
	return fwrite(bytes, 1, n, out) == n ? CAIRO_STATUS_SUCCESS
					     : CAIRO_STATUS_WRITE_ERROR;
}

static void
cairo_pen_set_colour(cairo_t *c, unsigned rgb, double opacity)
{
	cairo_set_source_rgba(c, (rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0,
	    (rgb & 255) / 255.0, opacity);
}

static void
cairo_pen_draw_path(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_stroke *stroke)
{
	const struct picture *p = (struct picture *)pen;
	cairo_t *c = p->cairo;
	unsigned colour = p->paper.ink[stroke->series];
	int on, off;
	chart_dash_lengths(stroke->line, &on, &off);
	double dash[2] = {on, off};
	cairo_new_path(c);
	for (size_t i = 0; i < n; i++)
		cairo_line_to(c, x[i], y[i]);
	if (stroke->fill != PEN_OPEN) {
		cairo_close_path(c);
		cairo_pen_set_colour(c,
		    stroke->fill == PEN_PAPER ? p->paper.colour : colour,
		    stroke->fill == PEN_TINT ? 0.2 : 1);
		cairo_fill_preserve(c);
	}
	cairo_pen_set_colour(c, colour, 1);
	cairo_set_dash(c, dash, off > 0 ? 2 : 0, 0);
	cairo_set_line_width(c, stroke->width);
	if (stroke->width > 0)
		cairo_stroke(c);
}

static void
cairo_pen_draw_bars(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_bar *bar)
{
	const struct picture *p = (struct picture *)pen;
	cairo_t *c = p->cairo;
	cairo_new_path(c);
	for (size_t i = 0; i < 2 * n; i += 2) {
		cairo_move_to(c, x[i], y[i]);
		cairo_line_to(c, x[i + 1], y[i + 1]);
	}
	cairo_pen_set_colour(c, p->paper.ink[bar->series], bar->opacity);
	cairo_set_dash(c, NULL, 0, 0);
	cairo_set_line_width(c, bar->width);
	cairo_set_line_cap(
	    c, bar->round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
	cairo_stroke(c);
	cairo_set_line_cap(c, CAIRO_LINE_CAP_BUTT);
}

static void
cairo_pen_set_font(const struct picture *p, const struct pen_style *style)
{
	cairo_select_font_face(p->cairo,
	    p->paper.mono || style->mono ? "monospace" : "sans-serif",
	    CAIRO_FONT_SLANT_NORMAL,
	    style->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
	cairo_set_font_size(p->cairo, style->size);
}

static double
cairo_pen_measure_text(
    struct pen *pen, const char *words, const struct pen_style *style)
{
	const struct picture *p = (struct picture *)pen;
	cairo_text_extents_t size;
	FREED char *text = text_with_control_escaped(words);
	cairo_pen_set_font(p, style);
	cairo_text_extents(p->cairo, text, &size);
	return size.x_advance;
}

static void
cairo_pen_begin_page(struct pen *pen)
{
	cairo_show_page(((struct picture *)pen)->cairo);
}

static void
cairo_pen_set_origin(struct pen *pen, double x, double y, double scale)
{
	cairo_t *c = ((struct picture *)pen)->cairo;
	cairo_identity_matrix(c);
	cairo_translate(c, x, y);
	cairo_scale(c, scale, scale);
}

static void
cairo_pen_draw_text(struct pen *pen, double x, double y, const char *words,
    const struct pen_style *style)
{
	const struct picture *p = (struct picture *)pen;
	const struct pen_paper *paper = &p->paper;
	cairo_t *c = p->cairo;
	cairo_text_extents_t size;
	/* cairo draws nothing more after text that is not UTF-8. */
	FREED char *text = text_with_control_escaped(words);
	cairo_pen_set_font(p, style);
	cairo_text_extents(c, text, &size);
	cairo_pen_set_colour(c,
	    style->inverse ? paper->colour : paper->ink[style->series],
	    style->faint ? PEN_FAINT : 1);
	cairo_save(c);
	cairo_translate(c, x, y);
	if (style->length > 0 && size.x_advance > 0)
		cairo_scale(c, style->length / size.x_advance, 1);
	if (style->upward)
		cairo_rotate(c, -acos(0));
	cairo_move_to(c, -size.x_advance * (double)style->anchor / 2, 0);
	cairo_show_text(c, text);
	cairo_restore(c);
}

static void
set_pdf_metadata(
    cairo_surface_t *pdf, cairo_pdf_metadata_t what, const char *words)
{
	FREED char *text = text_with_control_escaped(words);
	cairo_pdf_surface_set_metadata(pdf, what, text);
}

static bool
cairo_pen_close(struct pen *pen)
{
	struct picture *p = (struct picture *)pen;
	cairo_status_t written = CAIRO_STATUS_SUCCESS;
	bool ok = cairo_status(p->cairo) == CAIRO_STATUS_SUCCESS;
	if (p->pdf)
		cairo_surface_finish(p->surface);
	else
		written = cairo_surface_write_to_png_stream(
		    p->surface, write_cairo_bytes, p->out);
	ok = ok && written == CAIRO_STATUS_SUCCESS &&
	     cairo_surface_status(p->surface) == CAIRO_STATUS_SUCCESS;
	cairo_destroy(p->cairo);
	cairo_surface_destroy(p->surface);
	free(p);
	return ok;
}

struct pen *
pen_new_cairo(double width, double height, const struct pen_paper *paper,
    const char *title, const char *about, bool pdf, FILE *out)
{
	struct picture *p = xcalloc(1, sizeof *p);
	p->pen = (struct pen){.path = cairo_pen_draw_path,
	    .bars = cairo_pen_draw_bars,
	    .text = cairo_pen_draw_text,
	    .close = cairo_pen_close,
	    .width = cairo_pen_measure_text,
	    .next = cairo_pen_begin_page,
	    .place = cairo_pen_set_origin};
	p->paper = *paper;
	p->pdf = pdf;
	p->out = out;
	if (pdf) {
		p->surface = cairo_pdf_surface_create_for_stream(
		    write_cairo_bytes, out, width, height);
		set_pdf_metadata(p->surface, CAIRO_PDF_METADATA_TITLE, title);
		set_pdf_metadata(p->surface, CAIRO_PDF_METADATA_SUBJECT, about);
		/* A time would make a different file of the same chart. */
		set_pdf_metadata(
		    p->surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
	} else {
		p->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24,
		    (int)ceil(width * PNG_SCALE),
		    (int)ceil(height * PNG_SCALE));
	}
	p->cairo = cairo_create(p->surface);
	if (!pdf)
		cairo_scale(p->cairo, PNG_SCALE, PNG_SCALE);
	cairo_pen_set_colour(p->cairo, paper->colour, 1);
	cairo_paint(p->cairo);
	return &p->pen;
}
