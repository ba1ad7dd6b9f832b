/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/envelope_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/answer/response.h"

/* revision, feed: what it was opened for; open: it could be; tenths: where it
 * is. */
struct limits {
	struct grading grading;
	bool open;
	size_t revision, feed;
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
	return l != NULL && l->revision == t->revision &&
	       l->feed == tui_feed(t);
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
		t->limits->revision = t->revision;
		t->limits->feed = tui_feed(t);
		t->limits->open = grading_in_use(t->session, tui_entry(t),
		    t->limits->feed, &t->limits->grading, &error);
	}
	if (t->limits->open && t->limits->tenths != t->ui.tenths)
		forecast_at(
		    t->limits->grading.conditions.forecast, t->shown.speed);
	t->limits->tenths = t->ui.tenths;
}

const struct grading *
limits_now(const struct tui *t)
{
	bool now = is_wanted(t) && is_current(t) && t->limits->open &&
		   t->limits->tenths == t->ui.tenths;
	return now ? &t->limits->grading : NULL;
}
