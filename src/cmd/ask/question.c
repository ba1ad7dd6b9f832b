/* Makes questions from the options of a call.  No other place does.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/question.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/parse.h"
#include "cmd/session/invocation.h"
#include "cmd/session/undo.h"
#include "io/sitefile/units.h"

/* Returns "feed b.csv, cascade 10 %".  The caller frees it. */
static char *
scenario_text(const struct scenario *w)
{
	char *words = xstrdup("");
	if (w->feed != NULL)
		xappend_to_list(&words, ", ", "%s", w->feed->words);
	if (w->rotor > 0)
		xappend_to_list(
		    &words, ", ", tr("rotor %g mm"), units_m_to_mm(w->rotor));
	if (w->bypass > 0)
		xappend_to_list(
		    &words, ", ", tr("cascade %g %%"), 100 * w->bypass);
	if (w->k > 0)
		xappend_to_list(&words, ", ", "k %g", w->k);
	return words;
}

/* Returns a copy of the site with the feed, machine and sieves of the
 * scenario. */
static struct site *
copy_site_with_scenario(const struct site *own, const struct scenario *w)
{
	const struct blended *f = w->feed;
	struct site *site = f != NULL ? site_copy_with_feed(own, &f->feed,
					    blended_source_text(f), f->of)
				      : site_copy(own);
	xfree_and_set(&site->with, scenario_text(w));
	if (w->rotor > 0) {
		site->run_rotor = own->rotor;
		site->rotor = w->rotor;
	}
	site->n_shown = w->n_sieve;
	site->shown = xcalloc_doubles(w->n_sieve);
	for (size_t i = 0; i < w->n_sieve; i++)
		site->shown[i] = w->sieve[i];
	return site;
}

/* If the scenario changes anything, turns the question into one about a changed
 * copy of its entry. */
static void
apply_question_scenario(const struct session *s, struct question *q)
{
	const struct scenario *w = &q->scenario;
	const struct entry *loaded = q->entry;
	size_t runs = loaded->site->n_run;
	bool same_site = w->feed == NULL && !(w->rotor > 0) &&
			 !(w->bypass > 0) && !(w->k > 0) && w->n_sieve == 0;
	if (same_site && w->correction == s->set.correction)
		return;
	q->scenario.own = loaded;
	q->scenario.rock = w->feed != NULL ? w->feed->rock : "";
	q->changed = *loaded;
	q->changed.scenario = w;
	q->entry = &q->changed;
	if (same_site)
		return;
	q->changed.site = q->site = copy_site_with_scenario(loaded->site, w);
	q->changed.train = xcalloc(runs + 1, sizeof *loaded->train);
	memcpy(q->changed.train, loaded->train, runs * sizeof *loaded->train);
}

void
question_set_from_scenario(const struct session *s, const struct entry *loaded,
    const struct scenario *w, struct question *q)
{
	*q = question_of_whole_product(s, loaded, SITE_MEAN_FEED);
	q->scenario = *w;
	apply_question_scenario(s, q);
}

void
question_free(struct session *s, struct question *q)
{
	const struct entry *changed = &q->changed;
	blended_free(q->blend);
	free(q->sieves);
	free(q->speeds);
	if (q->site == NULL)
		return;
	moved_products_discard(s->moved);
	history_free_ensembles_of_site(changed->history, q->site);
	if (changed->origin != NULL)
		history_free_ensembles_of_site(
		    changed->origin->history, q->site);
	site_free(q->site);
	free(changed->train);
}

/* Reads the speed from speed= or rpm=, or takes the default if neither is
 * given. */
static bool
parse_speed_or_rpm(
    const struct args *args, struct question *q, struct error *error)
{
	const struct site *site = q->entry->site;
	double rpm = args->rpm, rotor = q->scenario.rotor;
	q->speed_given = args->speed > 0 || rpm > 0;
	q->speed =
	    args->speed > 0 ? args->speed : answers_default_speed(q->entry);
	if (!(rpm > 0))
		return true;
	double diameter = rotor > 0 ? rotor : site->rotor;
	const char *name = args->command->name;
	if (args->speed > 0)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a speed or rpm, got both", name);
	if (!(diameter > 0))
		return error_set(error, ERROR_USAGE,
		    "%s: expected the rotor's diameter with rpm, which %s does "
		    "not state\n"
		    "add rotor_mm=DIAMETER, or a line rotor_mm in the site "
		    "file",
		    name, site->name);
	q->speed = site_speed_from_rpm(site, rpm, diameter);
	return (q->speed >= 1 && q->speed <= SITE_FASTEST) ||
	       error_set(error, ERROR_USAGE,
		   "%s: expected a tip speed from 1 to %d m/s, got %g (%g "
		   "rpm with a rotor of %g mm)",
		   name, SITE_FASTEST, q->speed, rpm, units_m_to_mm(diameter));
}

/* Parses the text of feed= or `set feed`. */
static struct value
parse_feed_option_value(const char *text)
{
	struct value value = {.given = true};
	struct error none = {0};
	value_parse(SHARED_FEED, text, &value, &none);
	return value;
}

/* Returns the value of feed= or, if that is not given, of the setting; an empty
 * value if the command has no such option. */
static struct value
feed_option_or_setting(const struct session *s, const struct args *args)
{
	struct value none = {.given = false};
	return command_option_index(args->command, "feed") == OPTIONS
		   ? none
		   : parse_feed_option_value(
			 args->feed != NULL ? args->feed : s->set.feed);
}

/* Reads the sheets that feed= or the setting names, if they name any. */
static bool
read_named_feeds(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct value feed = feed_option_or_setting(s, args);
	if (!value_is_file(SHARED_FEED, &feed))
		return true;
	if (args->feed == NULL)
		q->scenario.feed =
		    blended_read_feed_setting(s, feed.text, error);
	else
		q->scenario.feed = q->blend =
		    blended_read_feeds(s, feed.text, error);
	return q->scenario.feed != NULL;
}

/* Reads sieves=.  The feeds must cover them. */
static bool
parse_sieves_option(
    const struct args *args, struct question *q, struct error *error)
{
	const struct number_list *sieves = &args->sieves;
	const struct site *site = q->entry->site;
	struct scenario *w = &q->scenario;
	if (sieves->n == 0)
		return true;
	w->sieve = q->sieves = xcalloc_doubles(sieves->n);
	for (size_t i = 0; i < sieves->n; i++)
		q->sieves[i] = sieves->at[i] / 1000;
	w->n_sieve = psd_sort_distinct_sizes(q->sieves, sieves->n, 1e-12);
	struct quantity finest = {
	    .kind = QUANTITY_PASSING, .x = w->sieve[w->n_sieve - 1]};
	bool ok = w->feed == NULL ||
		  quantities_check_feed_covers(&finest, &w->feed->feed, error);
	for (size_t i = 0; i < site->n_run && ok && w->feed == NULL; i++)
		ok = site->run[i].feed.n == 0 ||
		     quantities_check_feed_covers(
			 &finest, &site->run[i].feed, error);
	return ok;
}

/* Reads cut= and the screens; cut=off means the whole product.  With an
 * envelope, screens may be described without cut=, because its fraction is
 * meant. */
static bool
parse_size_fraction_options(const struct session *s, const struct args *args,
    struct question *q, struct error *error)
{
	bool envelope = (args->command->flags & COMMAND_SPEC) != 0 ||
			args->spec != NULL || s->spec != NULL;
	if (command_option_index(args->command, "cut") == OPTIONS ||
	    (args->cut != NULL && text_is_same_folded(args->cut, "off")))
		return true;
	if (args->cut == NULL && !envelope &&
	    (args->sharpness > 0 || args_is_given(args, &args->cut_size)))
		return error_set(error, ERROR_USAGE,
		    "sharpness= and cut_size= describe the screens of cut=, "
		    "which is not given\nadd a fraction such as cut=0/4");
	q->fraction.partition =
	    (struct partition){args->sharpness, args->cut_size / 100};
	return args->cut == NULL ||
	       quantities_parse_size_fraction(args->cut, &q->fraction, error);
}

/* Applies the scenario, and reads the options that need no file: the speeds,
 * the feed's run, and the fraction. */
static bool
parse_file_free_question_options(const struct session *s,
    const struct args *args, struct question *q, struct error *error)
{
	struct value feed = feed_option_or_setting(s, args);
	apply_question_scenario(s, q);
	if (args_is_given(args, &args->speeds)) {
		q->n_at = args->speeds.n;
		q->at = args->speeds.at;
	}
	bool speed = feed.number > 0; /* at which the feed was sampled */
	return (!speed || feed_find_run_sampled_at_speed(
			      q->entry->site, feed.number, &q->feed, error)) &&
	       parse_size_fraction_options(s, args, q, error);
}

bool
question_from_args(struct session *s, const struct entry *loaded,
    const struct args *args, struct question *q, struct error *error)
{
	*q = question_of_whole_product(s, loaded, SITE_MEAN_FEED);
	q->scenario = (struct scenario){.rotor = args->rotor_mm / 1000,
	    .bypass = args->cascade / 100,
	    .k = args->k,
	    .correction = args_is_given(args, &args->correction)
			      ? (enum correction)args->correction
			      : s->set.correction};
	return parse_speed_or_rpm(args, q, error) &&
	       read_named_feeds(s, args, q, error) &&
	       parse_sieves_option(args, q, error) &&
	       parse_file_free_question_options(s, args, q, error);
}

bool
question_repeat_for_site(struct session *s, const struct entry *loaded,
    const struct args *args, const struct question *like, struct question *q,
    struct error *error)
{
	*q = question_of_whole_product(s, loaded, SITE_MEAN_FEED);
	q->scenario = like->scenario;
	q->speed_given = like->speed_given;
	q->speed =
	    like->speed_given ? like->speed : answers_default_speed(loaded);
	return parse_file_free_question_options(s, args, q, error);
}

bool
question_read_and_answer(struct session *s, const struct args *args,
    command_answer *answer, struct error *error)
{
	struct question q = {.entry = NULL};
	bool known = (args->command->flags & COMMAND_NEEDS_PARAMS) != 0;
	bool ok = (!known || answers_require_params_current_site(s, error)) &&
		  question_from_args(
		      s, session_current_site_entry(s), args, &q, error) &&
		  answer(s, args, &q, error);
	/* A command that is not saved leaves no trace for later ones. */
	bool saved = (args->command->flags & COMMAND_UNSAVED) == 0;
	if (ok && saved && q.speed_given) {
		s->last_asked.speed = q.speed;
		s->last_asked.found_by = NULL;
	}
	question_free(s, &q);
	return ok;
}

/* A cached question about the current site with the feed of `set feed`. */
struct site_with_feed {
	/* A copy of the loaded entry, to see whether it has changed. */
	struct entry of;
	struct question q;
	/* The setting. */
	char *text;
};

void
question_free_cached_site(struct session *s)
{
	struct site_with_feed *a = s->site_with_feed;
	if (a == NULL)
		return;
	question_free(s, &a->q);
	entry_clear(&a->of);
	free(a->text);
	s->site_with_feed = NULL;
	free(a);
}

/* Returns the feed in the sheets of `set feed`, or NULL if it names none. */
static const struct blended *
read_feed_set_by_user(struct session *s)
{
	struct error none = {0};
	struct value value = parse_feed_option_value(s->set.feed);
	return s->set.feed[0] != '\0' && value_is_file(SHARED_FEED, &value)
		   ? blended_read_feed_setting(s, s->set.feed, &none)
		   : NULL;
}

const struct entry *
question_site_with_feed_setting(struct session *s)
{
	const struct entry *loaded =
	    s->n_entry > 0 ? session_current_site_entry(s) : NULL;
	const struct blended *feed =
	    loaded != NULL ? read_feed_set_by_user(s) : NULL;
	struct site_with_feed *a = s->site_with_feed;
	if (feed == NULL)
		return loaded;
	if (a == NULL || strcmp(a->text, feed->text) != 0 ||
	    a->of.history != loaded->history ||
	    !session_entries_are_equal(&a->of, loaded)) {
		const struct scenario scenario = {
		    .feed = feed, .correction = s->set.correction};
		question_free_cached_site(s);
		s->site_with_feed = a = xcalloc(1, sizeof *a);
		a->of = entry_copy(loaded);
		a->text = xstrdup(feed->text);
		question_set_from_scenario(s, &a->of, &scenario, &a->q);
	}
	struct question *q = &a->q;
	q->scenario.own = loaded;
	q->scenario.feed = feed;
	q->scenario.rock = feed->rock;
	q->scenario.correction = s->set.correction;
	return q->entry;
}

/* Returns speeds [*n] in steps of 1 m/s or, if the sheet is in rpm, at round
 * rpm.  The caller frees them. */
static double *
list_every_round_speed(
    const struct site *site, double from, double to, size_t *n)
{
	enum { MOST_RPM = 20 };
	double *at = answers_list_round_rpm_speeds(site, from, to, MOST_RPM, n);
	if (at != NULL)
		return at;
	*n = (size_t)floor(to - from) + 1;
	at = xcalloc_doubles(*n);
	for (size_t i = 0; i < *n; i++)
		at[i] = from + (double)i;
	return at;
}

/* Returns the speeds and the measured ones between `from` and `to`, sorted
 * [*n], with room for one more.  A measured speed replaces those that differ
 * from it by less than `same`.  The caller frees it. */
static double *
merge_with_measured_speeds(const struct site *site, const double *speed,
    size_t n_speed, double from, double to, double same, size_t *n)
{
	size_t n_own = 0;
	double *at = xcalloc_doubles(n_speed + site->n_run + 1);
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].product.n > 0 && site->run[r].speed >= from &&
		    site->run[r].speed <= to &&
		    !site_run_repeats_speed(site, r))
			at[n_own++] = site->run[r].speed;
	*n = n_own;
	for (size_t i = 0; i < n_speed; i++) {
		bool near = false;
		for (size_t k = 0; k < n_own; k++)
			near = near || fabs(at[k] - speed[i]) < same;
		if (!near)
			at[(*n)++] = speed[i];
	}
	gsl_sort(at, 1, *n);
	return at;
}

/* Returns round speeds, the measured ones, and the one last asked about, sorted
 * [*n].  The caller frees them. */
static double *
list_round_and_measured_speeds(
    const struct site *site, double from, double to, double last, size_t *n)
{
	size_t n_round;
	FREED double *round = list_every_round_speed(site, from, to, &n_round);
	double *at =
	    merge_with_measured_speeds(site, round, n_round, from, to, 0.1, n);
	bool there = !(last > from) || !(last < to);
	for (size_t i = 0; i < *n; i++)
		there = there || fabs(at[i] - last) < 1e-9;
	if (!there)
		at[(*n)++] = last;
	gsl_sort(at, 1, *n);
	return at;
}

void
question_use_default_speeds(
    const struct session *s, struct question *q, bool each)
{
	const struct site *site = q->entry->site;
	double from, to;
	if (q->n_at > 0)
		return;
	if (!each) {
		q->at = q->speeds =
		    answers_list_few_round_speeds(s, site, &q->n_at);
		return;
	}
	settings_default_speed_range(&s->set, site, &from, &to);
	q->at = q->speeds = list_round_and_measured_speeds(
	    site, from, to, s->last_asked.speed, &q->n_at);
}

/* The steps of a range in rpm are only roughly equal. */
void
question_add_measured_speeds_to_range(struct question *q)
{
	const double shown = 0.005; /* speeds have two decimals at most */
	const double *at = q->at;
	size_t n = q->n_at, i = 1;
	while (i + 1 < n && at[i] > at[i - 1] &&
	       fabs(at[i + 1] - 2 * at[i] + at[i - 1]) < shown)
		i++;
	if (n < 3 || i + 1 < n)
		return;
	q->at = q->speeds = merge_with_measured_speeds(
	    q->entry->site, at, n, at[0], at[n - 1], shown, &q->n_at);
}

double
question_last_speed_or_usual(struct session *s, double usual)
{
	double last = s->last_asked.speed;
	if (!(last > 0))
		return usual;
	char number[32];
	invocation_add_journal_options(
	    s, " speed=%s", text_shortest_exact_number(last, number));
	return last;
}

void
question_use_last_speed(struct session *s, struct question *q)
{
	if (!q->speed_given)
		q->speed = question_last_speed_or_usual(s, q->speed);
}

void
question_use_last_speed_and_feed(
    const struct session *s, const struct args *args, struct question *q)
{
	double last = session_number_in_last_answer(s, "predict", "speed");
	double fed = session_number_in_last_answer(s, "predict", "feed_mps");
	const struct site *site = q->entry->site;
	if (q->speed_given || (isnan(last) && !(s->last_asked.speed > 0)))
		return;
	q->speed = s->last_asked.speed > 0 ? s->last_asked.speed : last;
	if (args->feed == NULL && q->scenario.feed == NULL && isfinite(fed) &&
	    site_run_at_speed(site, fed) < site->n_run)
		q->feed = site_run_at_speed(site, fed);
}

const struct psd *
question_feed(const struct question *q)
{
	return site_feed_of_run(q->entry->site, q->feed);
}
