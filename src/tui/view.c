/* Makes the prediction for the full screen, and decides when to make it anew.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/pin.h"
#include "cmd/ask/asked.h"
#include "tui/captured.h"
#include "tui/pane.h"
#include "tui/widgets/envelope_check.h"
#include "tui/widgets/track.h"

/* If the slider has not been moved for so long, s, its next move begins a new
 * comparison. */
static const double PAUSE = 0.7;

/* Returns the numbers of a prediction for the site with that key. */
static struct numbers
summary_numbers_of_prediction(const char *key, const struct prediction *p)
{
	struct numbers n = {.speed = p->speed};
	if (p->product.n == 0)
		return n;
	snprintf(n.site, sizeof n.site, "%s", key);
	for (size_t i = 0; i < 3; i++)
		n.size[i] = answers_product_size_mm(p, i);
	n.break_mm = answers_product_size_mm(p, ANSWERS_BREAK);
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++)
		n.passing[i] =
		    psd_covers_size(&p->product, NUMBERS_SIEVE[i])
			? 100 * psd_passing(&p->product, NUMBERS_SIEVE[i])
			: NAN;
	return n;
}

static void
free_shown_prediction(struct tui *t)
{
	prediction_free(&t->view.shown);
	t->view.shown = (struct prediction){0};
	t->view.light_known = false;
}

static void
discard_shown_prediction(struct tui *t)
{
	free_shown_prediction(t);
	t->view.current = (struct numbers){0};
	t->view.of = (struct prediction_key){0};
}

/* Records what predictions depend on (struct fit_record) and, if that has
 * changed, discards what was computed from it. */
static void
discard_stale_predictions(struct tui *t)
{
	struct fit_record *b = &t->view.basis;
	const struct entry *entry = tui_current_site_entry(t);
	const struct settings *set = &t->session->set;
	if (entry != NULL && b->site == entry->site &&
	    b->origin == entry->origin &&
	    memcmp(&b->params, &entry->params, sizeof b->params) == 0 &&
	    settings_are_equal_but_for_looks(&b->set, set))
		return;
	if (entry == NULL || b->site != entry->site)
		t->view.of.speed = 0;
	origin_release(b->origin);
	*b = (struct fit_record){.set = *set};
	if (entry != NULL) {
		b->site = entry->site;
		b->origin = entry->origin;
		b->params = entry->params;
	}
	if (b->origin != NULL)
		b->origin->holders++;
	t->view.n_basis++;
	goals_discard_results(&t->view.goal);
	t->pending_key = NULL;
}

void
view_discard_outdated(struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	t->view.revision++;
	t->view.light_known = false;
	t->view.n_row = 0;
	tui_free_parity(&t->view.parity);
	discard_stale_predictions(t);
	if (entry != NULL && entry == session_entry_being_fitted(t->session))
		t->pending_key = NULL;
	const struct pin *pin = t->session->pin;
	t->view.pinned = pin != NULL
			     ? summary_numbers_of_prediction(pin->key, &pin->p)
			     : (struct numbers){0};
	if (isnan(
		session_number_in_last_answer(t->session, "predict", "speed")))
		discard_shown_prediction(t);
	t->view.holdout = entry != NULL && entry->has_fit
			      ? 100 * fit_largest_holdout_rmse(entry)
			      : NAN;
}

static struct prediction_key
make_prediction_key(const struct tui *t)
{
	const struct session *s = t->session;
	bool searching =
	    session_is_calibrating(s) && s->job.entry == s->current;
	return (struct prediction_key){.basis = t->view.n_basis,
	    .feed = tui_run_index_of_feed(t),
	    .generation =
		searching ? calibration_status(s->job.calibration).generation
			  : 0,
	    .speed = tui_slider_speed(t)};
}

void
view_predict_at_slider(struct tui *t)
{
	struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	track_run_pending_key(t, false);
	bool keep = t->keep_message;
	t->keep_message = false;
	if (entry == NULL)
		return;
	struct prediction_key was = t->view.of, key = make_prediction_key(t);
	bool forming = key.generation > 0;
	bool moved = was.speed != key.speed || was.feed != key.feed;
	bool other = was.speed == 0 || was.generation != key.generation,
	     first = other || !moved;
	if ((!entry->has_params && !forming) ||
	    (!other && !moved && was.basis == key.basis))
		return;
	/* Differences are not computed from a prediction of a running
	 * search. */
	if (!t->view.from_search &&
	    (t->clock - t->view.moved > PAUSE ||
		t->view.reference.site[0] == '\0' ||
		strcmp(t->view.reference.site, entry->key) != 0))
		t->view.reference = t->view.current;
	t->view.from_search = forming;
	if (!first)
		t->view.moved = t->clock;
	FREED char *where = tui_speed_and_feed_options(t);
	FREED char *line = xasprintf("predict %s", where);
	struct error error = {0};
	free_shown_prediction(t);
	if (!predict_at_screen_speed(s, tui_site_entry_for_prediction(t),
		tui_slider_speed(t), tui_run_index_of_feed(t), line,
		&t->view.shown, &error))
		captured_show_error(t, &error, line, ERROR_TYPED);
	if ((!first && !keep) || t->command == NULL) {
		xfree_and_set(&t->command, xstrdup(line));
		t->failed = false;
	}
	if (!first && !keep)
		t->message[0] = '\0';
	tui_set_feed_from_answer(t);
	t->view.of = make_prediction_key(t);
	t->view.current =
	    summary_numbers_of_prediction(entry->key, &t->view.shown);
}

void
view_predict_unrecorded(struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	discard_shown_prediction(t);
	if (entry == NULL)
		return;
	struct params params = entry->params;
	if (!answers_best_params_so_far(s, entry, &params) &&
	    !entry->has_params)
		return;
	struct question q = question_of_whole_product(
	    s, tui_site_entry_for_prediction(t), tui_run_index_of_feed(t));
	q.params = &params;
	t->view.shown = forecast_product(s, &q, tui_slider_speed(t));
	t->view.current =
	    summary_numbers_of_prediction(entry->key, &t->view.shown);
}

void
view_update(struct tui *t)
{
	view_predict_at_slider(t);
	pages_update(t);
}

void
view_free(struct tui *t)
{
	prediction_free(&t->view.shown);
	trust_free(&t->view.light);
	origin_release(t->view.basis.origin);
	free(t->view.row);
	goals_discard_results(&t->view.goal);
	tui_free_sheet(&t->view.sheet);
	tui_free_parity(&t->view.parity);
	envelope_check_free(t);
}
