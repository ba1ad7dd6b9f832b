/* The slider's arithmetic and drawing: no terminal, no session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/slider.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

int
slider_clamp(int tenths)
{
	return tenths < SLIDER_LEAST  ? SLIDER_LEAST
	       : tenths > SLIDER_MOST ? SLIDER_MOST
				      : tenths;
}

int
slider_tenths(double speed)
{
	return slider_clamp((int)lround(10 * speed));
}

bool
slider_read(const char *text, int *tenths)
{
	double speed;
	if (!text_number(text, &speed) || speed < SLIDER_LEAST / 10.0 ||
	    speed > SLIDER_MOST / 10.0)
		return false;
	*tenths = slider_tenths(speed);
	return true;
}

int
slider_column(int tenths, int width)
{
	double share = (double)(slider_clamp(tenths) - SLIDER_LEAST) /
		       (SLIDER_MOST - SLIDER_LEAST);
	return width > 1 ? (int)lround(share * (width - 1)) : 0;
}

int
slider_at(int column, int width)
{
	if (width < 2)
		return SLIDER_LEAST;
	double share = (double)column / (width - 1);
	return slider_clamp(
	    SLIDER_LEAST + (int)lround(share * (SLIDER_MOST - SLIDER_LEAST)));
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

/* Its sign, and the speed behind it where there is room. */
static void
draw_mark(char *text, int width, const struct slider_mark *mark)
{
	char label[16];
	int at = slider_column(mark->tenths, width);
	text[at] = mark->trained ? '|' : 'o';
	snprintf(label, sizeof label, "%g", mark->tenths / 10.0);
	int n = (int)strlen(label);
	for (int i = 1; i <= n + 1; i++)
		if (at + i < width && strchr("x-", text[at + i]) == NULL)
			return;
	if (at + n < width)
		memcpy(text + at + 1, label, (size_t)n);
}

int
slider_draw(
    char *text, int width, int tenths, const struct slider_mark *mark, size_t n)
{
	text[0] = '\0';
	if (width < 1)
		return 0;
	for (int c = 0; c < width; c++)
		text[c] = is_outside(slider_at(c, width), mark, n) ? 'x' : '-';
	text[width] = '\0';
	for (size_t i = 0; i < n; i++)
		draw_mark(text, width, &mark[i]);
	char label[16];
	snprintf(label, sizeof label, "[%.1f]", tenths / 10.0);
	int length = (int)strlen(label);
	if (length > width) {
		int at = slider_column(tenths, width);
		text[at] = '#';
		return at;
	}
	int at = slider_column(tenths, width) - length / 2;
	at = at < 0 ? 0 : at > width - length ? width - length : at;
	memcpy(text + at, label, (size_t)length);
	return at;
}
