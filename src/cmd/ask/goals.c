/* Searches for the speeds that meet the goal, in parts, so that the screen
 * keeps responding.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/goals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/envelope.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/asked.h"
#include "core/psd/rotor_speed.h"
#include "io/fs/file.h"

/* Speeds searched in one step. */
enum { PART = 6 };

bool
goals_is_set(const struct session *s)
{
	return s->set.goal[0] != '\0';
}

void
goals_discard_results(struct goal *g)
{
	conditions_free(&g->list);
	speed_search_free(g->found);
	free(g->why);
	free(g->missed);
	free(g->met);
	*g = (struct goal){.n_value = 0};
}

bool
goals_is_condition_text(const char *text)
{
	FREED char *extreme = conditions_rewrite_superlative(text);
	return extreme != NULL || conditions_is_likely_complete(text) ||
	       text[strcspn(text, "<>=%")] != '\0' ||
	       quantities_is_beginning_of_text(text);
}

static bool
is_single_value_condition(const struct condition *c)
{
	return c->least == c->most;
}

/* An envelope's limits of 100 to 100 % and of 0 to 0 % are not values to reach:
 * they become a lower and an upper limit. */
static bool
add_limits_of_named_envelope(struct session *s, const char *name,
    const struct psd *feed, struct condition_list *list, struct error *error)
{
	const struct fraction whole = {.partition = PARTITION_IDEAL};
	const struct spec *spec = envelope_named_or_chosen(s, name, error);
	size_t i = list->n;
	bool ok =
	    spec != NULL && (feed == NULL || conditions_add_envelope(spec, NULL,
						 &whole, feed, list, error));
	for (; ok && i < list->n; i++) {
		struct condition *c = &list->at[i];
		if (is_single_value_condition(c) && c->least > 0)
			c->most = NAN;
		else if (is_single_value_condition(c))
			c->least = NAN;
	}
	xfree_and_set(&list->source, NULL);
	return ok;
}

/* Adds a condition or the limits of an envelope to the list. */
static bool
parse_condition_or_envelope(struct session *s, const char *text,
    const struct psd *feed, struct condition_list *list, struct error *error)
{
	const struct fraction whole = {.partition = PARTITION_IDEAL};
	struct condition c;
	if (!goals_is_condition_text(text))
		return add_limits_of_named_envelope(s, text, feed, list, error);
	if (!conditions_parse_one(text, &whole, &c, error) ||
	    (feed != NULL && !conditions_check_feed_covers(&c, feed, error)))
		return false;
	conditions_add(list, c);
	return true;
}

/* Moves the single value to the end, so that those before it are the ranges. */
static bool
move_value_condition_last(
    struct condition_list *list, size_t *n_value, struct error *error)
{
	size_t at = 0;
	*n_value = 0;
	for (size_t i = 0; i < list->n; i++)
		if (is_single_value_condition(&list->at[i])) {
			at = i;
			++*n_value;
		}
	if (*n_value > 1)
		return error_set(error, ERROR_USAGE,
		    "expected at most one single value, got %zu\nwrite ranges: "
		    "passing 2 = 40..50",
		    *n_value);
	if (*n_value == 0)
		return true;
	struct condition last = list->at[list->n - 1];
	list->at[list->n - 1] = list->at[at];
	list->at[at] = last;
	return true;
}

bool
goals_parse(struct session *s, const char *text, const struct psd *feed,
    struct condition_list *list, size_t *n_value, struct error *error)
{
	/* The name of a file may have the signs of conditions in it. */
	bool file = file_exists(text);
	if (file && !add_limits_of_named_envelope(s, text, feed, list, error))
		return false;
	for (const char *at = text; *at != '\0' && !file;) {
		size_t length = text_length_of_list_item(at);
		char *copy = xstrndup(at, length), *word = text_trim(copy);
		bool ok = word[0] == '\0' || parse_condition_or_envelope(
						 s, word, feed, list, error);
		free(copy);
		if (!ok)
			return false;
		at += length + (at[length] != '\0');
	}
	return move_value_condition_last(list, n_value, error);
}

bool
goals_is_search_done(const struct session *s, const struct goal *g)
{
	return goals_is_set(s) && g->found != NULL &&
	       g->found->done == g->found->n;
}

/* Collects the speeds that give the single value within the ranges. */
static void
find_speeds_that_meet_goal(struct goal *g)
{
	g->met = xcalloc(g->found->n_root + 1, sizeof *g->met);
	for (size_t k = 0; k < g->found->n_root; k++)
		if (g->found->root[k].holds)
			g->met[g->n_met++] = g->found->root[k].speed;
}

/* Returns a speed at which the binding limit shows: an end of the window inside
 * the search or, without one, the best speed. */
static double
speed_at_binding_limit(
    const struct goal *g, double best, double from, double to)
{
	for (size_t i = 0; i < g->found->n_inside && g->n_value == 0; i++) {
		const struct speed_range *in = &g->found->inside[i];
		if (in->to < to || in->from > from)
			return in->to < to ? in->to : in->from;
	}
	return best;
}

/* Returns the value that misses a condition, with enough digits to tell it from
 * the limit.  The caller frees it. */
static char *
value_beyond_limit_text(const struct condition *c, double value, bool most)
{
	const struct quantity *q = &c->quantity;
	const char *unit = quantities_unit(q);
	double bound =
	    quantities_value_in_shown_unit(q, most ? c->most : c->least);
	FREED char *name = quantities_name(q);
	char number[32], edge[32];
	int digits = 3;
	if (isnan(value))
		return xasprintf(tr("%s beyond the sieves"), name);
	snprintf(edge, sizeof edge, "%g", bound);
	do
		snprintf(number, sizeof number, "%.*g", digits++,
		    quantities_value_in_shown_unit(q, value));
	while (strcmp(number, edge) == 0 && digits < 9);
	char *words = xasprintf(
	    "%s %s%s%s", name, number, unit[0] != '\0' ? " " : "", unit);
	if (!is_single_value_condition(c))
		xappend(&words, " (%s %s)", most ? tr("max") : tr("min"), edge);
	return words;
}

/* Finds which condition binds and, if no speed meets the goal, which value
 * stands in the way. */
static void
find_binding_condition(const struct session *s, const struct entry *entry,
    struct goal *g, struct conditions_search all)
{
	double best = goals_best_speed(s, g, answers_default_speed(entry));
	bool met = g->n_met > 0 || (g->n_value == 0 && g->found->n_inside > 0);
	double at = speed_at_binding_limit(g, best, all.from, all.to);
	all.n = g->list.n;
	if (isnan(at))
		return;
	forecast_set_speed(all.forecast, at);
	struct margin margin = condition_margin(&all, SIZE_MAX);
	if (!isfinite(margin.passing))
		return;
	g->binds = margin.limit.i;
	if (!met)
		g->missed = value_beyond_limit_text(&g->list.at[g->binds],
		    forecast_value_with_band(all.forecast, g->binds).value,
		    margin.limit.most);
}

/* Parses the goal again, because another feed may not cover its sizes. */
static void
parse_goal_for_feed(
    struct session *s, const struct site *site, struct goal *g, size_t feed)
{
	struct error error = {0};
	goals_discard_results(g);
	g->feed = feed;
	if (!goals_parse(s, s->set.goal, site_feed_of_run(site, feed), &g->list,
		&g->n_value, &error))
		g->why = xstrdup(error.text);
}

bool
goals_is_search_needed(
    const struct session *s, const struct goal *g, size_t feed)
{
	bool begun = g->feed == feed && (g->why != NULL || g->found != NULL);
	return goals_is_set(s) &&
	       (!begun || (g->why == NULL && !goals_is_search_done(s, g)));
}

void
goals_step_search(
    struct session *s, const struct entry *entry, struct goal *g, size_t feed)
{
	if (!goals_is_search_needed(s, g, feed))
		return;
	if (g->found == NULL || g->feed != feed)
		parse_goal_for_feed(s, entry->site, g, feed);
	if (g->why != NULL)
		return;
	struct question q = question_of_whole_product(s, entry, feed);
	struct condition_list ranges = {
	    .n = g->list.n - g->n_value, .at = g->list.at};
	struct conditions_search w = conditions_open_search(
	    s, &q, &ranges, g->n_value > 0 ? &g->list.at[ranges.n] : NULL);
	if (g->found == NULL)
		g->found = speed_search_new(&w);
	bool done = false;
	for (int k = 0; k < PART && !done; k++)
		done = speed_search_step(g->found, &w);
	if (done && g->n_value > 0)
		find_speeds_that_meet_goal(g);
	if (done)
		find_binding_condition(s, entry, g, w);
	forecast_close(w.forecast);
}

double
goals_best_speed(const struct session *s, const struct goal *g, double speed)
{
	if (!goals_is_search_done(s, g))
		return NAN;
	if (g->n_value == 0)
		return g->found->best;
	size_t near = 0, last = g->found->n - 1;
	const double *over = g->found->over;
	if (g->n_met == 0 && g->list.n > 1)
		return g->found->best;
	if (g->n_met == 0) /* the end of the search that misses it least */
		return g->found
		    ->speed[fabs(over[last]) >= fabs(over[0]) ? 0 : last];
	for (size_t i = 1; i < g->n_met; i++)
		if (fabs(g->met[i] - speed) < fabs(g->met[near] - speed))
			near = i;
	return g->met[near];
}

/* Returns "70.8 to 78.0", or "1413 to 1513" if the sheet is in rpm; "from 67.2
 * on" if one end is only that of the search.  at: begin with "at" if there are
 * two ends.  units: in m/s with its unit, and rpm beside it if the site states
 * its rotor.  The caller frees it. */
static char *
goal_speed_range_text(const struct speed_search *found, double from, double to,
    bool at, const struct site *site, bool units)
{
	bool slowest = from <= found->speed[0],
	     fastest = to >= found->speed[found->n - 1];
	if (slowest && fastest)
		return xstrdup(tr("at all speeds"));
	FREED char *rpm = rotor_speed_rpm_text(units ? site->rotor : 0,
	    slowest ? to : from, slowest || fastest ? (double)NAN : to);
	FREED char *unit = xasprintf("%s%s", units ? " m/s" : "", rpm);
	int decimals = 1;
	if (!units && answers_is_sheet_in_rpm(site)) {
		decimals = 0;
		from = answers_speed_in_sheet_unit(site, from);
		to = answers_speed_in_sheet_unit(site, to);
	}
	return slowest   ? xasprintf(tr("up to %.*f%s"), decimals, to, unit)
	       : fastest ? xasprintf(tr("from %.*f%s on"), decimals, from, unit)
			 : xasprintf(at ? tr("at %.*f to %.*f%s")
					: tr("%.*f to %.*f%s"),
			       decimals, from, decimals, to, unit);
}

/* Returns "at 71.2", "at 65.0 to 70.1 and 73.0 to 75.6", or "" if no speed
 * meets the goal.  The caller frees it. */
static char *
goal_met_speeds_text(const struct goal *g, const struct site *site, bool units)
{
	const double narrow = 0.09;
	const struct speed_range *in = g->found->inside;
	if (g->n_value == 0 && g->found->n_inside == 1 &&
	    in->to - in->from > narrow)
		return goal_speed_range_text(
		    g->found, in->from, in->to, true, site, units);
	bool in_rpm = !units && answers_is_sheet_in_rpm(site);
	FREED char *words = g->n_value == 0 ? conditions_met_speeds_text(
						  g->found, units ? NULL : site)
					    : xstrdup("");
	for (size_t i = 0; i < g->n_met; i++)
		xappend_to_list(&words, tr(" and "), "%.*f", in_rpm ? 0 : 1,
		    in_rpm ? answers_speed_in_sheet_unit(site, g->met[i])
			   : g->met[i]);
	FREED char *rpm =
	    units && g->n_met == 1
		? rotor_speed_rpm_text(site->rotor, g->met[0], NAN)
		: xstrdup("");
	return words[0] == '\0' ? xstrdup("")
				: xasprintf(tr("at %s%s%s"), words,
				      units ? " m/s" : "", rpm);
}

/* Returns "80 % certain 71.2 to 77.5"; the longer forms omit the speeds if they
 * are all that meet the goal.  "" for a single value, without a band, or if no
 * speed meets the goal.  The caller frees it. */
static char *
certain_speeds_text(const struct session *s, const struct goal *g,
    const struct site *site, enum goals_length length)
{
	bool units = length < GOALS_PLAIN && answers_is_sheet_in_rpm(site);
	double level = 100 * settings_band_probability(&s->set);
	const double *sure = g->found->sure;
	if (g->n_value > 0 || g->found->n_inside == 0 ||
	    isnan(g->found->best_certain))
		return xstrdup("");
	/* One range, and certain throughout. */
	const struct speed_range *in = g->found->inside;
	if (g->found->n_inside == 1 && in->from >= sure[0] &&
	    in->to <= sure[1] && length < GOALS_PLAIN)
		return xasprintf(tr("%.0f %% certain"), level);
	if (!isfinite(sure[0]))
		return xasprintf(tr("no speed is %.0f %% certain"), level);
	FREED char *range = goal_speed_range_text(
	    g->found, sure[0], sure[1], false, site, units);
	return xasprintf(tr("%.0f %% certain %s"), level, range);
}

/* Returns which part of the outcome, or of its certain speeds alone, is beyond
 * the measured speeds, to be translated, or "". */
static const char *
goal_extrapolation_text(
    const struct entry *entry, const struct goal *g, double best, bool certain)
{
	const double *ends = g->found->sure;
	const struct speed_range sure = {.from = ends[0], .to = ends[1]},
				 *in = certain ? &sure : g->found->inside;
	bool window = g->n_value == 0 && g->found->n_inside > 0;
	if (isfinite(best) && answers_is_speed_extrapolated(entry, best))
		return window ? N_("best extrapolated") : N_("extrapolated");
	for (size_t n = certain ? 1 : g->found->n_inside; window && n > 0; n--)
		if (answers_is_speed_extrapolated(entry, in[n - 1].from) ||
		    answers_is_speed_extrapolated(entry, in[n - 1].to))
			return N_("partly extrapolated");
	return "";
}

/* Returns that no speed in the search meets the goal and, except for
 * GOALS_SHORT, which comes nearest.  The caller frees it. */
static char *
goal_met_nowhere_text(const struct site *site, const struct goal *g,
    double best, enum goals_length length)
{
	double from = g->found->speed[0], to = g->found->speed[g->found->n - 1];
	FREED char *range =
	    answers_speed_range_words(site, from, to, length == GOALS_SHORT);
	if (length == GOALS_SHORT)
		return xasprintf(tr("at no speed %s"), range);
	char *words = xasprintf(tr("at no speed from %s"), range);
	if (isfinite(best))
		xappend(&words, tr(", nearest %.*f"),
		    answers_is_sheet_in_rpm(site) ? 0 : 1,
		    answers_speed_in_sheet_unit(site, best));
	return words;
}

/* Returns at which speeds the goal is met and how certain that is, or in the
 * shorter forms only the certain speeds; if no speed meets it, the nearest one.
 * The caller frees it. */
static char *
goal_met_or_nearest_text(const struct session *s, const struct entry *entry,
    const struct goal *g, double speed, enum goals_length length)
{
	bool full = length < GOALS_PLAIN;
	double best = goals_best_speed(s, g, speed);
	FREED char *certain = certain_speeds_text(s, g, entry->site, length);
	bool told = length < GOALS_SHORT && certain[0] != '\0',
	     alone = told && !full && isfinite(g->found->sure[0]);
	const char *beyond = goal_extrapolation_text(entry, g, best, alone);
	char *words = goal_met_speeds_text(g, entry->site, full);
	if (words[0] == '\0')
		xfree_and_set(&words,
		    goal_met_nowhere_text(entry->site, g, best, length));
	if (g->missed != NULL && full)
		xappend(&words, ": %s", g->missed);
	if (alone)
		words[0] = '\0';
	if (told)
		xappend_to_list(&words, ", ", "%s", certain);
	if (beyond[0] != '\0' && length < GOALS_UNMARKED)
		xappend(&words, ", %s", tr(beyond));
	return words;
}

char *
goals_outcome_text(const struct session *s, const struct entry *entry,
    const struct goal *g, double speed, enum goals_length length)
{
	bool full = length == GOALS_FULL;
	const char *text = s->set.goal;
	if (!goals_is_set(s))
		return xstrdup("");
	if (g->why != NULL)
		return xasprintf(
		    tr("goal: %s"), full ? g->why : tr("not known"));
	bool fitted = entry != NULL && entry->has_params;
	if (!fitted && length != GOALS_SHORT)
		return xasprintf(tr("goal: %s"), tr("needs a calibration"));
	if (!goals_is_search_done(s, g))
		return length == GOALS_SHORT
			   ? xstrdup(tr("goal"))
			   : xasprintf(tr("goal%s%s: being worked out"),
				 full ? " " : "", full ? text : "");
	FREED char *end = goal_met_or_nearest_text(s, entry, g, speed, length);
	return full ? xasprintf(tr("goal %s: met %s"), text, end)
		    : xasprintf(tr("goal %s"), end);
}
