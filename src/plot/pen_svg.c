/* A pen that writes SVG, in which text stays text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "plot/pen.h"

struct svg {
	struct pen pen;
	struct pen_paper paper;
	FILE *out;
};

static const char SANS[] = "Helvetica, Arial, sans-serif";

static void
svg_draw_path(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_stroke *stroke)
{
	const struct svg *svg = (struct svg *)pen;
	FILE *out = svg->out;
	unsigned colour = svg->paper.ink[stroke->series];
	int on, off;
	fputs("<path d=\"", out);
	for (size_t i = 0; i < n; i++)
		fprintf(out, "%c%.2f %.2f", i == 0 ? 'M' : 'L', x[i], y[i]);
	fputs(stroke->fill != PEN_OPEN ? "Z\"" : "\"", out);
	if (stroke->fill == PEN_OPEN)
		fputs(" fill=\"none\"", out);
	else
		fprintf(out, " fill=\"#%06x\"",
		    stroke->fill == PEN_PAPER ? svg->paper.colour : colour);
	if (stroke->fill == PEN_TINT)
		fputs(" fill-opacity=\"0.2\"", out);
	if (stroke->width > 0)
		fprintf(out, " stroke=\"#%06x\" stroke-width=\"%.2f\"", colour,
		    stroke->width);
	chart_dash_lengths(stroke->line, &on, &off);
	if (off > 0 && stroke->width > 0)
		fprintf(out, " stroke-dasharray=\"%d %d\"", on, off);
	fputs("/>\n", out);
}

/* Draws bars.  Level ones and dots are written in the shortest form that SVG
 * has. */
static void
svg_draw_bars(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_bar *bar)
{
	const struct svg *svg = (struct svg *)pen;
	fprintf(svg->out,
	    "<path fill=\"none\" stroke=\"#%06x\" stroke-width=\"%g\"",
	    svg->paper.ink[bar->series], bar->width);
	if (bar->opacity < 1)
		fprintf(svg->out, " stroke-opacity=\"%g\"", bar->opacity);
	if (bar->round)
		fputs(" stroke-linecap=\"round\"", svg->out);
	fputs(" d=\"", svg->out);
	for (size_t i = 0; i < 2 * n; i += 2) {
		fprintf(svg->out, "M%g %g", x[i], y[i]);
		if (fabs(y[i] - y[i + 1]) < 1e-9)
			fprintf(svg->out, "h%g", x[i + 1] - x[i]);
		else
			fprintf(svg->out, "L%g %g", x[i + 1], y[i + 1]);
	}
	fputs("\"/>\n", svg->out);
}

static void
svg_draw_text(struct pen *pen, double x, double y, const char *text,
    const struct pen_style *style)
{
	static const char *const ANCHORS[] = {"start", "middle", "end"};
	const struct svg *svg = (struct svg *)pen;
	FILE *out = svg->out;
	fprintf(out,
	    "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" "
	    "text-anchor=\"%s\" fill=\"#%06x\"",
	    x, y, style->size, ANCHORS[style->anchor],
	    style->inverse ? svg->paper.colour : svg->paper.ink[style->series]);
	if (style->length > 0)
		fprintf(out, " textLength=\"%g\"", style->length);
	if (style->faint)
		fprintf(out, " fill-opacity=\"%g\"", PEN_FAINT);
	if (style->mono && !svg->paper.mono)
		fprintf(out, " font-family=\"%s\"", PEN_MONO);
	if (style->bold)
		fputs(" font-weight=\"bold\"", out);
	if (style->upward)
		fprintf(out, " transform=\"rotate(-90 %.2f %.2f)\"", x, y);
	fputc('>', out);
	text_print_xml(text, out);
	fputs("</text>\n", out);
}

static bool
svg_close(struct pen *pen)
{
	struct svg *svg = (struct svg *)pen;
	fputs("</svg>\n", svg->out);
	bool ok = !ferror(svg->out);
	free(svg);
	return ok;
}

static void
svg_write_background(const struct svg *svg, double width, double height)
{
	const struct pen_paper *p = &svg->paper;
	if (p->corner > 0)
		fprintf(svg->out,
		    "<rect x=\"0.5\" y=\"0.5\" width=\"%g\" height=\"%g\" "
		    "rx=\"%g\" fill=\"#%06x\" stroke=\"#%06x\"/>\n",
		    width - 1, height - 1, p->corner, p->colour, p->edge);
	else
		fprintf(svg->out,
		    "<rect width=\"100%%\" height=\"100%%\" fill=\"#%06x\"/>\n",
		    p->colour);
}

struct pen *
pen_new_svg(double width, double height, const struct pen_paper *paper,
    const char *title, const char *about, bool other, FILE *out)
{
	struct svg *svg = xcalloc(1, sizeof *svg);
	svg->pen = (struct pen){.path = svg_draw_path,
	    .bars = svg_draw_bars,
	    .text = svg_draw_text,
	    .close = svg_close};
	svg->paper = *paper;
	svg->out = out;
	if (!other)
		fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n", out);
	fprintf(out,
	    "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
	    "width=\"%gpt\" height=\"%gpt\" viewBox=\"0 0 %g %g\" "
	    "font-family=\"%s\">\n<title>",
	    width, height, width, height, paper->mono ? PEN_MONO : SANS);
	text_print_xml(title, out);
	fputs("</title>\n<desc>", out);
	text_print_xml(about, out);
	fputs("</desc>\n", out);
	svg_write_background(svg, width, height);
	return &svg->pen;
}
