/* Values derived from the state of the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/tui_state.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/question.h"

const double NUMBERS_SIEVE[NUMBERS_FRACTIONS] = {0.063e-3, 2e-3, 4e-3};

const double PACES[PACE_COUNT] = {0, 1, 2, 5, 10, 20, 50, INFINITY};

const struct entry *
tui_current_site_entry(const struct tui *t)
{
	const struct session *s = t->session;
	return s->n_entry > 0 ? &s->entry[s->current] : NULL;
}

const struct site *
tui_current_site(const struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	return entry != NULL ? entry->site : NULL;
}

double
tui_rotor_diameter(const struct tui *t)
{
	return tui_current_site(t) != NULL ? tui_current_site(t)->rotor : 0;
}

const struct entry *
tui_site_entry_for_prediction(const struct tui *t)
{
	return t->ui.feed > 0 ? tui_current_site_entry(t)
			      : question_site_with_feed_setting(t->session);
}

const char *
tui_why_no_prediction(const struct tui *t)
{
	return tui_current_site_entry(t) == NULL ? tr(TUI_NO_SITE)
	       : session_is_calibrating(t->session)
		   ? tr("no prediction until the calibration ends")
	       : site_count_products(tui_current_site(t)) == 0
		   ? tr("no product: type :guess")
		   : tr("no prediction yet: f calibrates");
}

struct slider_range
tui_slider_range(const struct tui *t)
{
	const struct site *site = tui_current_site(t);
	double from, to;
	settings_default_speed_range(&t->session->set, site, &from, &to);
	return slider_range(
	    from, to, answers_is_sheet_in_rpm(site) ? site->rotor : 0);
}

void
tui_set_slider_speed(struct tui *t, double speed)
{
	t->ui.speed = speed;
}

void
tui_set_slider_position(struct tui *t, int position)
{
	struct slider_range range = tui_slider_range(t);
	position = slider_clamped_position(range, position);
	t->ui.speed = slider_speed_of_position(range, position);
	if (!(tui_rotor_diameter(t) > 0))
		return;
	const struct site *site = tui_current_site(t);
	for (size_t r = site->n_run; r-- > 0;)
		if (slider_position_of_speed(range, site->run[r].speed) ==
		    position)
			t->ui.speed = site->run[r].speed;
}

int
tui_slider_position(const struct tui *t)
{
	return slider_position_of_speed(tui_slider_range(t), t->ui.speed);
}

const struct site *
tui_pinned_site(const struct tui *t)
{
	const struct session *s = t->session;
	for (size_t i = 0; i < s->n_entry; i++)
		if (strcmp(s->entry[i].key, t->view.pinned.site) == 0)
			return s->entry[i].site;
	return NULL;
}

double
tui_slider_speed(const struct tui *t)
{
	struct slider_range range = tui_slider_range(t);
	return tui_rotor_diameter(t) > 0 && slider_has_speed(range, t->ui.speed)
		   ? round(100 * t->ui.speed) / 100
		   : slider_speed_of_position(range, tui_slider_position(t));
}

size_t
tui_run_index_of_feed(const struct tui *t)
{
	const struct entry *entry = tui_site_entry_for_prediction(t);
	return entry != NULL
		   ? feed_run_at_speed_or_mean(entry->site, t->ui.feed)
		   : SITE_MEAN_FEED;
}

const struct psd *
tui_feed_curve(const struct tui *t)
{
	return site_feed_of_run(
	    tui_site_entry_for_prediction(t)->site, tui_run_index_of_feed(t));
}

const char *
tui_other_feed(const struct tui *t)
{
	return tui_site_entry_for_prediction(t)->site->with;
}

/* Returns the parameters by which measured products are moved to the feed, or
 * NULL.  They are those of the prediction shown beside them, and are written to
 * `room`. */
static const struct params *
params_to_move_products(const struct tui *t, struct params *room)
{
	const struct entry *entry = tui_site_entry_for_prediction(t);
	*room = entry->params;
	return answers_best_params_so_far(t->session, entry, room) ||
		       entry->has_params
		   ? room
		   : NULL;
}

const struct psd *
tui_product_adjusted_to_feed(const struct tui *t, size_t run)
{
	struct params room;
	return measured_product_moved_to_feed(t->session,
	    tui_site_entry_for_prediction(t), params_to_move_products(t, &room),
	    run, tui_run_index_of_feed(t));
}

bool
tui_is_product_moved_to_feed(const struct tui *t, size_t run)
{
	struct params room;
	return largest_change_by_moving_to_feed(t->session,
		   tui_site_entry_for_prediction(t),
		   params_to_move_products(t, &room), run,
		   tui_run_index_of_feed(t)) > MOVED_MENTIONED;
}

void
tui_set_feed_from_answer(struct tui *t)
{
	double feed =
	    session_number_in_last_answer(t->session, "predict", "feed_mps");
	if (isfinite(feed))
		t->ui.feed = feed;
	else
		tui_set_feed_from_setting(t);
}

void
tui_set_feed_from_setting(struct tui *t)
{
	double set;
	t->ui.feed = text_parse_number(t->session->set.feed, &set) ? set : 0;
}

char *
tui_speed_and_feed_options(const struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	double speed = tui_slider_speed(t);
	bool tenth = speed == round(10 * speed) / 10;
	struct slider_range range = tui_slider_range(t);
	int position = tui_slider_position(t);
	bool turns = range.rotor > 0 &&
		     speed == slider_speed_of_position(range, position);
	FREED char *at =
	    turns ? xasprintf("speed=%drpm", position)
		  : xasprintf(tenth ? "speed=%.1f" : "speed=%g", speed);
	/* True if `set feed` names a sheet that cannot be read. */
	bool mean = !(t->ui.feed > 0) &&
		    tui_site_entry_for_prediction(t) == entry &&
		    t->session->set.feed[0] != '\0' &&
		    strcmp(t->session->set.feed, "mean") != 0;
	if (entry == NULL || mean || !entry->site->individual_feeds ||
	    !(t->ui.feed > 0))
		return xasprintf("%s%s", at, mean ? " feed=mean" : "");
	return xasprintf("%s feed=%g", at, t->ui.feed);
}

char *
tui_command_at_slider(const struct tui *t)
{
	FREED char *where = tui_speed_and_feed_options(t);
	return t->view.pinned.site[0] != '\0'
		   ? xasprintf("compare pinned %s", where + strlen("speed="))
		   : xasprintf("predict %s", where);
}

struct search_shown
tui_calibration_history(const struct tui *t)
{
	return tui_current_site_entry(t) != NULL
		   ? search_of_site_to_show(
			 t->session, tui_current_site_entry(t))
		   : (struct search_shown){0};
}

size_t
tui_count_generations(const struct tui *t)
{
	struct search_shown past = tui_calibration_history(t);
	return past.n + (past.n > 0 && past.polished);
}

size_t
tui_shown_generation_number(const struct tui *t)
{
	size_t n = tui_count_generations(t);
	return t->ui.generation > 0 && t->ui.generation < n ? t->ui.generation
							    : n;
}

void
tui_show_generation(struct tui *t, size_t step)
{
	t->ui.generation = step < tui_count_generations(t) ? step : 0;
}

size_t
tui_shown_unpolished_generation(const struct tui *t)
{
	size_t n = tui_calibration_history(t).n,
	       step = tui_shown_generation_number(t);
	return step < n ? step : n;
}

double
tui_calibration_seconds(const struct tui *t)
{
	return t->ran + (t->held ? 0 : t->clock - t->started);
}

void
tui_clear_click_areas(struct tui *t)
{
	hits_clear_click_areas(&t->hits);
	hits_end_drag(&t->hits);
	t->n_drawn = 0;
}

void
tui_free_sheet(struct sheet *sheet)
{
	free(sheet->sieve);
	free(sheet->column);
	outliers_free(&sheet->doctor);
	*sheet = (struct sheet){.site = NULL};
}

void
tui_free_parity(struct parity *parity)
{
	trials_clear(&parity->runs);
	chart_free(parity->chart);
	*parity = (struct parity){.next = 0};
}

void
tui_set_message(struct tui *t, bool bad, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	vsnprintf(t->message, sizeof t->message, tr(format), ap);
	va_end(ap);
	t->bad = bad;
}

void
tui_append_to_message(struct tui *t, const char *more)
{
	FREED char *said = xstrdup(t->message);
	if (more[0] != '\0' && (t->viewer.text == NULL || said[0] == '\0'))
		tui_set_message(t, t->bad, "%s%s%s", said,
		    said[0] != '\0' ? "; " : "", more);
}
