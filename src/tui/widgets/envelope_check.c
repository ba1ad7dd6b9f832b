/* Opens the envelope once for a state of the session, and moves its forecast
 * with the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/envelope_check.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/answer/response.h"

/* revision, feed: what it was opened for; open: it could be; tenths: where it
 * is. */
struct envelope_check {
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
envelope_check_free(struct tui *t)
{
	if (t->envelope_check != NULL && t->envelope_check->open)
		grading_close(&t->envelope_check->grading);
	free(t->envelope_check);
	t->envelope_check = NULL;
}

static bool
is_current(const struct tui *t)
{
	const struct envelope_check *l = t->envelope_check;
	return l != NULL && l->revision == t->revision &&
	       l->feed == tui_feed(t);
}

void
envelope_check_update(struct tui *t)
{
	struct error error = {0};
	if (!is_wanted(t) || !is_current(t))
		envelope_check_free(t);
	if (!is_wanted(t))
		return;
	if (t->envelope_check == NULL) {
		t->envelope_check = xcalloc(1, sizeof *t->envelope_check);
		t->envelope_check->revision = t->revision;
		t->envelope_check->feed = tui_feed(t);
		t->envelope_check->open = grading_in_use(t->session,
		    tui_entry(t), t->envelope_check->feed,
		    &t->envelope_check->grading, &error);
	}
	if (t->envelope_check->open &&
	    t->envelope_check->tenths != t->ui.tenths)
		forecast_at(t->envelope_check->grading.conditions.forecast,
		    t->shown.speed);
	t->envelope_check->tenths = t->ui.tenths;
}

const struct grading *
envelope_check_now(const struct tui *t)
{
	bool now = is_wanted(t) && is_current(t) && t->envelope_check->open &&
		   t->envelope_check->tenths == t->ui.tenths;
	return now ? &t->envelope_check->grading : NULL;
}
