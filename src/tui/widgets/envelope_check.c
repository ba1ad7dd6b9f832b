/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/envelope_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/answer/response.h"

/* looked, feed: what it was opened for; open: it could be; tenths: where it
 * is. */
struct limits {
	struct grading grading;
	bool open;
	size_t looked, feed;
	int tenths;
};

static bool
is_wanted(const struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	return entry != NULL && entry->has_params && t->session->spec != NULL &&
	       !session_busy(t->session) && t->shown.product.n > 0;
}

void
limits_free(struct tui *t)
{
	if (t->limits != NULL && t->limits->open)
		grading_close(&t->limits->grading);
	free(t->limits);
	t->limits = NULL;
}

static bool
is_current(const struct tui *t)
{
	const struct limits *l = t->limits;
	return l != NULL && l->looked == t->looked && l->feed == tui_feed(t);
}

/* Between the curve's sizes its straight lines are up to 0.2 points off: where
 * a limit is as near as that, all draws are moved, so that no verdict is
 * another than that of `spec`. */
static void
move(const struct tui *t, const struct wanted *c)
{
	const double near = 0.003;
	struct window_limit limit;
	bool close = false;
	response_take(c->response, t->shown.speed, &t->shown.curve);
	for (size_t i = 0; i < c->n; i++)
		close |= fabs(window_margin_of(c, i, &limit)) < near;
	if (close)
		response_at(c->response, t->shown.speed);
}

void
limits_update(struct tui *t)
{
	struct error error = {0};
	if (!is_wanted(t) || !is_current(t))
		limits_free(t);
	if (!is_wanted(t))
		return;
	if (t->limits == NULL) {
		t->limits = xcalloc(1, sizeof *t->limits);
		t->limits->looked = t->looked;
		t->limits->feed = tui_feed(t);
		t->limits->open = grading_in_use(t->session, tui_entry(t),
		    t->limits->feed, &t->limits->grading, &error);
	}
	if (t->limits->open && t->limits->tenths != t->tenths)
		move(t, &t->limits->grading.conditions);
	t->limits->tenths = t->tenths;
}

const struct grading *
limits_now(const struct tui *t)
{
	bool now = is_wanted(t) && is_current(t) && t->limits->open &&
		   t->limits->tenths == t->tenths;
	return now ? &t->limits->grading : NULL;
}
