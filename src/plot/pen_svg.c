/* A pen that writes SVG, with text that stays text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "base/xalloc.h"
#include "plot/pen.h"

struct svg {
	struct pen pen;
	FILE *out;
};

/* Text of an element. */
static void
put_text(const char *text, FILE *out)
{
	for (; *text != '\0'; text++) {
		if (*text == '<')
			fputs("&lt;", out);
		else if (*text == '&')
			fputs("&amp;", out);
		else if (*text == '>')
			fputs("&gt;", out);
		else
			fputc(*text, out);
	}
}

static void
svg_path(struct pen *pen, const double *x, const double *y, size_t n,
    const struct pen_stroke *stroke)
{
	FILE *out = ((struct svg *)pen)->out;
	unsigned colour = pen_colour(stroke->series);
	int on, off;
	fputs("<path d=\"", out);
	for (size_t i = 0; i < n; i++)
		fprintf(out, "%c%.2f %.2f", i == 0 ? 'M' : 'L', x[i], y[i]);
	fputs(stroke->fill != PEN_OPEN ? "Z\"" : "\"", out);
	if (stroke->fill == PEN_OPEN)
		fputs(" fill=\"none\"", out);
	else
		fprintf(out, " fill=\"#%06x\"",
		    stroke->fill == PEN_WHITE ? 0xFFFFFF : colour);
	if (stroke->fill == PEN_TINT)
		fputs(" fill-opacity=\"0.2\"", out);
	if (stroke->width > 0)
		fprintf(out, " stroke=\"#%06x\" stroke-width=\"%.2f\"", colour,
		    stroke->width);
	chart_dash(stroke->line, &on, &off);
	if (off > 0 && stroke->width > 0)
		fprintf(out, " stroke-dasharray=\"%d %d\"", on, off);
	fputs("/>\n", out);
}

static void
svg_text(struct pen *pen, double x, double y, const char *text,
    const struct pen_style *style)
{
	static const char *const ANCHORS[] = {"start", "middle", "end"};
	FILE *out = ((struct svg *)pen)->out;
	fprintf(out,
	    "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" "
	    "text-anchor=\"%s\" fill=\"#%06x\"",
	    x, y, style->size, ANCHORS[style->anchor],
	    pen_colour(style->series));
	if (style->bold)
		fputs(" font-weight=\"bold\"", out);
	if (style->upward)
		fprintf(out, " transform=\"rotate(-90 %.2f %.2f)\"", x, y);
	fputc('>', out);
	put_text(text, out);
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

struct pen *
pen_svg(double width, double height, const char *title, const char *about,
    FILE *out)
{
	struct svg *svg = xcalloc(1, sizeof *svg);
	svg->pen = (struct pen){svg_path, svg_text, svg_close};
	svg->out = out;
	fprintf(out,
	    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
	    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%gpt\" "
	    "height=\"%gpt\" viewBox=\"0 0 %g %g\" "
	    "font-family=\"Helvetica, Arial, sans-serif\">\n<title>",
	    width, height, width, height);
	put_text(title, out);
	fputs("</title>\n<desc>", out);
	put_text(about, out);
	fputs("</desc>\n<rect width=\"100%\" height=\"100%\" "
	      "fill=\"#ffffff\"/>\n",
	    out);
	return &svg->pen;
}
