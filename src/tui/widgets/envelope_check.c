/* Opens the envelope once for each state of the session and moves its forecast
 * with the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/envelope_check.h"

#include <stdlib.h>

#include "base/xalloc.h"

/* revision, feed: of the view and the prediction that it was opened for.  open:
 * opening it succeeded.  speed: that of its forecast, m/s. */
struct envelope_check {
	struct grading grading;
	bool open;
	size_t revision, feed;
	double speed;
};

static bool
envelope_check_is_wanted(const struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	return entry != NULL && entry->has_params && t->session->spec != NULL &&
	       !session_is_calibrating(t->session) &&
	       t->view.shown.product.n > 0;
}

void
envelope_check_free(struct tui *t)
{
	struct envelope_check *l = t->view.envelope_check;
	if (l != NULL && l->open)
		envelope_close(&l->grading);
	free(l);
	t->view.envelope_check = NULL;
}

static bool
is_envelope_check_up_to_date(const struct tui *t)
{
	const struct envelope_check *l = t->view.envelope_check;
	return l != NULL && l->revision == t->view.revision &&
	       l->feed == tui_run_index_of_feed(t);
}

void
envelope_check_update(struct tui *t)
{
	if (!envelope_check_is_wanted(t) || !is_envelope_check_up_to_date(t))
		envelope_check_free(t);
	if (!envelope_check_is_wanted(t))
		return;
	struct envelope_check *l = t->view.envelope_check;
	if (l == NULL) {
		t->view.envelope_check = l = xcalloc(1, sizeof *l);
		l->revision = t->view.revision;
		l->feed = tui_run_index_of_feed(t);
		l->open = envelope_open_chosen_forecast(t->session,
		    tui_site_entry_for_prediction(t), l->feed, &l->grading,
		    NULL);
	}
	if (l->open && l->speed != tui_slider_speed(t))
		forecast_set_speed(
		    l->grading.conditions.forecast, t->view.shown.speed);
	l->speed = tui_slider_speed(t);
}

const struct grading *
envelope_check_at_slider(const struct tui *t)
{
	const struct envelope_check *l = t->view.envelope_check;
	bool now = envelope_check_is_wanted(t) &&
		   is_envelope_check_up_to_date(t) && l->open &&
		   l->speed == tui_slider_speed(t);
	return now ? &l->grading : NULL;
}
