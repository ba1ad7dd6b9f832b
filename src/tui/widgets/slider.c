/* The slider's arithmetic and drawing: no terminal, no session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/slider.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "core/model/breakage.h"

struct slider_range
slider_range(double from, double to)
{
	return (struct slider_range){10 * (int)from, 10 * (int)to};
}

int
slider_clamp(struct slider_range range, int tenths)
{
	return tenths < range.least  ? range.least
	       : tenths > range.most ? range.most
				     : tenths;
}

int
slider_tenths(struct slider_range range, double speed)
{
	return slider_clamp(range, (int)lround(10 * speed));
}

bool
slider_has(struct slider_range range, double speed)
{
	return speed >= range.least / 10.0 && speed <= range.most / 10.0;
}

bool
slider_read(struct slider_range range, const char *text, int *tenths)
{
	double speed;
	if (!text_number(text, &speed) || !slider_has(range, speed))
		return false;
	*tenths = slider_tenths(range, speed);
	return true;
}

int
slider_column(struct slider_range range, int tenths, int width)
{
	double share = (double)(slider_clamp(range, tenths) - range.least) /
		       (range.most - range.least);
	return width > 1 ? (int)lround(share * (width - 1)) : 0;
}

int
slider_at(struct slider_range range, int column, int width)
{
	if (width < 2)
		return range.least;
	double share = (double)column / (width - 1);
	return slider_clamp(range,
	    range.least + (int)lround(share * (range.most - range.least)));
}

/* Lies beyond all speeds trained on. */
static bool
is_outside(int tenths, const struct slider_mark *mark, size_t n)
{
	bool below = false, above = false;
	for (size_t i = 0; i < n; i++) {
		below = below || (mark[i].trained && mark[i].tenths <= tenths);
		above = above || (mark[i].trained && mark[i].tenths >= tenths);
	}
	return !below || !above;
}

/* Cells of the track from column `from` on that nothing stands in, `wanted` of
 * them; the handle has cells [at, at + length). */
static bool
slider_is_free(
    const char *text, int width, int from, int wanted, int at, int length)
{
	for (int c = from; c < from + wanted; c++)
		if (c >= width || (c >= at && c < at + length) ||
		    (text[c] != 'x' && text[c] != '-'))
			return false;
	return true;
}

/* "69", or where words is set "69 m/s 2381 J/kg". */
static int
mark_label(const struct slider_mark *mark, bool words, char label[static 32])
{
	double v = mark->tenths / 10.0;
	return words ? snprintf(
			   label, 32, "%g m/s %.0f J/kg", v, energy_specific(v))
		     : snprintf(label, 32, "%g", v);
}

/* Whether the track is long enough for labels with units, and to be seen
 * between them. */
static bool
slider_has_room(const char *text, int width, struct slider_range range,
    const struct slider_mark *mark, size_t n)
{
	enum { BETWEEN = 5 };
	char label[32];
	for (size_t i = 0; i < n; i++) {
		int from = slider_column(range, mark[i].tenths, width) + 1;
		int length = mark_label(&mark[i], true, label);
		if (!slider_is_free(text, width, from, length + BETWEEN, 0, 0))
			return false;
	}
	return true;
}

/* Signs where there were runs, with the speed behind them where neither another
 * one nor the handle stands there. */
static void
slider_draw_marks(char *text, int width, struct slider_range range,
    const struct slider_mark *mark, size_t n, int at, int length, bool shorter)
{
	char label[32];
	for (size_t i = 0; i < n; i++)
		text[slider_column(range, mark[i].tenths, width)] =
		    mark[i].trained ? '|' : 'o';
	bool words = !shorter && slider_has_room(text, width, range, mark, n);
	for (size_t i = 0; i < n; i++) {
		int from = slider_column(range, mark[i].tenths, width) + 1;
		int wanted = mark_label(&mark[i], words, label);
		if (!slider_is_free(text, width, from, wanted + 1, at, length))
			wanted = mark_label(&mark[i], false, label);
		bool covered = from > at && from <= at + length;
		if (covered ||
		    !slider_is_free(text, width, from, wanted + 1, at, length))
			continue;
		memcpy(text + from, label, (size_t)wanted);
		/* "79?" would be a doubtful 79. */
		if (text[from + wanted] == 'x')
			text[from + wanted] = ' ';
	}
}

/* Kept cells are other signs until all labels stand. */
enum { KEPT = '=', KEPT_OUTSIDE = 'X' };

/* Returns whether there are any. */
static bool
keep_cells(char *text, int width, const bool *kept)
{
	bool any = false;
	for (int c = 0; c < width && kept != NULL; c++) {
		if (kept[c])
			text[c] = text[c] == 'x' ? KEPT_OUTSIDE : KEPT;
		any = any || kept[c];
	}
	return any;
}

static void
slider_give_back(char *text)
{
	for (; *text != '\0'; text++)
		*text = *text == KEPT           ? '-'
			: *text == KEPT_OUTSIDE ? 'x'
						: *text;
}

int
slider_draw(char *text, int width, struct slider_range range, int tenths,
    const struct slider_mark *mark, size_t n, const bool *kept)
{
	char label[16];
	text[0] = '\0';
	if (width < 1)
		return 0;
	for (int c = 0; c < width; c++)
		text[c] =
		    is_outside(slider_at(range, c, width), mark, n) ? 'x' : '-';
	text[width] = '\0';
	snprintf(label, sizeof label, "[%.1f]", tenths / 10.0);
	int length = (int)strlen(label),
	    at = slider_column(range, tenths, width);
	if (length > width) {
		strcpy(label, "#");
		length = 1;
	}
	at -= length / 2;
	at = at < 0 ? 0 : at > width - length ? width - length : at;
	bool any = keep_cells(text, width, kept);
	slider_draw_marks(text, width, range, mark, n, at, length, any);
	slider_give_back(text);
	memcpy(text + at, label, (size_t)length);
	return at;
}
