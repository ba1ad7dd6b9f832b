/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/second_plot.h"

#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "tui/pane.h"
#include "tui/screen.h"

/* Drawn of what: another of any of these is drawn again. */
struct second_of {
	enum second which;
	size_t looked, feed;
	int rows, columns;
	enum charset charset;
};

struct second_plot {
	struct second_of of;
	struct canvas *canvas; /* NULL: there is none, as the error says */
	struct error error;
};

/* Where the pinned prediction is of another site than the one in use, that;
 * SIZE_MAX without. */
static size_t
other_site(const struct tui *t)
{
	const struct session *s = t->session;
	for (size_t i = 0; i < s->n_entry; i++)
		if (i != s->current && t->kept.product.n > 0 &&
		    strcmp(s->entry[i].key, t->pin.site) == 0)
			return i;
	return SIZE_MAX;
}

static enum second
which(const struct tui *t)
{
	return t->second == SECOND_OTHER && other_site(t) == SIZE_MAX
		   ? SECOND_RESPONSE
		   : t->second;
}

void
second_next(struct tui *t)
{
	t->second = which(t) == SECOND_RESPONSE ? SECOND_RESIDUALS
		    : which(t) == SECOND_RESIDUALS && other_site(t) != SIZE_MAX
			? SECOND_OTHER
			: SECOND_RESPONSE;
}

void
second_free(struct tui *t)
{
	if (t->second_plot != NULL)
		canvas_free(t->second_plot->canvas);
	free(t->second_plot);
	t->second_plot = NULL;
}

static struct second_of
wanted(const struct tui *t, const struct area *area)
{
	struct second_of of;
	/* Compared with all that lies between. */
	memset(&of, 0, sizeof of);
	of.which = which(t);
	of.looked = t->looked;
	of.feed = tui_feed(t);
	of.rows = area->rows;
	of.columns = area->columns;
	of.charset = screen_charset();
	return of;
}

/* Each of them, and as describe calls it. */
static const struct {
	enum plot_kind kind;
	const char *words;
} PLOTS[SECONDS] = {{PLOT_RESPONSE, "response"}, {PLOT_RESIDUALS, "residuals"},
    {PLOT_PSD, "psd site=pinned"}};

void
second_words(const struct tui *t, char **words)
{
	if (t->places.second.rows > 0 && !session_busy(t->session))
		xappend(words, "; describe %s", PLOTS[which(t)].words);
}

static void
take(struct tui *t, const struct second_of *of)
{
	struct plot_request request = plots_request(PLOTS[of->which].kind);
	second_free(t);
	struct second_plot *plot = t->second_plot = xcalloc(1, sizeof *plot);
	plot->of = *of;
	request.charset = of->charset;
	request.feed_speed = t->feed;
	/* The site's own curves with what was predicted of it. */
	if (of->which == SECOND_OTHER) {
		request.site = t->pin.site;
		request.speed = t->pin.speed;
		request.feed_speed = t->pin.feed;
		request.band = t->band;
		request.made = &t->kept;
	}
	plot->canvas = plots_draw(
	    t->session, &request, of->columns, of->rows, &plot->error);
}

void
second_draw(struct tui *t)
{
	struct area area = t->places.second;
	if (area.rows == 0)
		return;
	screen_wall(area.row, area.column - 2, area.rows);
	if (session_busy(t->session)) {
		screen_words(
		    &area, 0, 0, tr("drawn again when the calibration ends"));
		return;
	}
	struct second_of of = wanted(t, &area);
	if (t->second_plot == NULL ||
	    memcmp(&t->second_plot->of, &of, sizeof of) != 0)
		take(t, &of);
	const struct second_plot *plot = t->second_plot;
	if (plot->canvas != NULL) {
		screen_canvas(&area, plot->canvas);
		return;
	}
	int row = screen_words(&area, 0, LOOK_BOLD, plot->error.text);
	screen_words(&area, row, 0, plot->error.hint);
}
