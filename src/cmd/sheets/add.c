/* add: adds belt cuts from later days to the current site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/sheets/check.h"
#include "cmd/ask/cut.h"
#include "cmd/session/call_paths.h"
#include "cmd/session/sites.h"
#include "cmd/session/invocation.h"
#include "cmd/sheets/load.h"
#include "cmd/sheets/log.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "io/cells/datetime.h"
#include "io/fs/file.h"
#include "io/sitefile/column_header.h"

/* The files [n] of a call.  word: as load takes it; file: its name without
 * folders; when: the time of the cut as text, or ""; logged: the log's values
 * at that time. */
struct origins {
	size_t n;
	struct cut_source {
		char *word, *file, *when;
		struct logged logged;
	} * file;
};

static void
free_cut_sources(struct origins *o)
{
	for (size_t i = 0; i < o->n; i++) {
		free(o->file[i].word);
		free(o->file[i].file);
		free(o->file[i].when);
	}
	free(o->file);
}

/* How ambiguous dates, such as 5/11/2026, are read.  order: of day and month;
 * why: what shows that order, in words; now: only today's date shows it. */
struct date_reading {
	enum datetime_order order;
	const char *why;
	bool now;
};

/* Returns a moment as "2026-05-03" or "2026-05-03 10:15", or NULL if its date
 * is ambiguous and the order open.  The caller frees it. */
static char *
cut_date_and_time_text(const struct datetime *m, enum datetime_order order)
{
	double time = datetime_seconds_since_1970(m, order);
	if (isnan(time))
		return NULL;
	char *text = datetime_to_text(time);
	if (!m->has_time)
		text[strcspn(text, " ")] = '\0';
	return text;
}

/* Returns the order that gives no date in the future, if the other order gives
 * one; otherwise DATETIME_OPEN. */
static enum datetime_order
date_order_without_future(const struct site *cuts)
{
	FREED char *today = datetime_today_text();
	struct datetime m, now;
	bool after[2] = {false, false};
	datetime_parse(today, &now);
	double end =
	    datetime_seconds_since_1970(&now, DATETIME_OPEN) + 24 * 3600;
	for (size_t i = 0; i < cuts->n_note; i++) {
		if (!cut_parse_date(&cuts->note[i], &m) || m.plain)
			continue;
		after[0] = after[0] || datetime_seconds_since_1970(
					   &m, DATETIME_DAY_FIRST) >= end;
		after[1] = after[1] || datetime_seconds_since_1970(
					   &m, DATETIME_MONTH_FIRST) >= end;
	}
	if (after[0] == after[1])
		return DATETIME_OPEN;
	return after[0] ? DATETIME_MONTH_FIRST : DATETIME_DAY_FIRST;
}

/* Returns the order of day and month that dates= states, or else that of the
 * dates of a site. */
static enum datetime_order
day_month_order_given(const struct args *args, const struct site *site)
{
	if (!args_is_given(args, &args->dates))
		return cut_day_month_order(site);
	return args->dates == 0 ? DATETIME_DAY_FIRST : DATETIME_MONTH_FIRST;
}

/* Finds the order of day and month in the dates of cuts: from dates=, else from
 * their other dates, else from the dates of the site to which they are added,
 * else from today's date, after which no cut was taken. */
static struct date_reading
find_day_month_order_of_cuts(
    const struct args *args, const struct site *cuts, const struct site *site)
{
	struct date_reading how = {day_month_order_given(args, cuts),
	    args_is_given(args, &args->dates) ? tr("as dates= says")
					      : tr("as its other dates show"),
	    false};
	if (how.order == DATETIME_OPEN) {
		how.order = cut_day_month_order(site);
		how.why = tr("as the dates of earlier cuts show");
	}
	if (how.order == DATETIME_OPEN) {
		how.order = date_order_without_future(cuts);
		how.why = tr("as the other reading is in the future");
		how.now = how.order != DATETIME_OPEN;
	}
	return how;
}

/* Returns the moment as one word of the command: "2026-11-05T10:15". */
static char *
iso_datetime_text(const struct datetime *m, enum datetime_order order)
{
	char *text = cut_date_and_time_text(m, order);
	for (char *p = text; p != NULL && *p != '\0'; p++)
		if (*p == ' ')
			*p = 'T';
	return text;
}

/* Sets an error if the date is ambiguous and the order open.  before: what is
 * before the date in the call. */
static bool
check_date_unambiguous(const struct datetime *m, const char *text,
    const char *before, enum datetime_order order, struct error *error)
{
	FREED char *day = iso_datetime_text(m, DATETIME_DAY_FIRST);
	FREED char *month = iso_datetime_text(m, DATETIME_MONTH_FIRST);
	return !isnan(datetime_seconds_since_1970(m, order)) ||
	       error_set(error, ERROR_USAGE,
		   "expected a date that can be read in one way, got '%s'\n"
		   "write year, month, day: %s%s or %s%s",
		   text, before, day, before, month);
}

/* Sets *day to the start of the day of a date, or to NAN if date is NULL.
 * order: for an ambiguous date. */
static bool
parse_cut_date(const char *date, enum datetime_order order, double *day,
    struct error *error)
{
	struct datetime m;
	*day = NAN;
	if (date == NULL)
		return true;
	if (!datetime_parse(date, &m) || !m.has_date)
		return error_set(error, ERROR_USAGE,
		    "expected a date such as 2026-05-03, got '%s'\n"
		    "write year, month, day: date=2026-05-03",
		    date);
	*day = datetime_seconds_since_1970(&m, order) - m.seconds;
	return check_date_unambiguous(&m, date, "date=", order, error);
}

/* Reads the time after @. day: the day of date= for a time without a date, or
 * NAN. */
static bool
parse_cut_time(const char *text, enum datetime_order order, double day,
    double *time, struct error *error)
{
	struct datetime m;
	if (text_ends_with(text, "rpm"))
		return error_set(error, ERROR_USAGE,
		    "expected the rotor's diameter with %s, got none\n"
		    "write: rotor_mm=DIAMETER, or a line rotor_mm in the site "
		    "file",
		    text);
	if (!datetime_parse(text, &m) || !m.has_time)
		return error_set(error, ERROR_USAGE,
		    "expected a tip speed or a time after @, got '%s'\n"
		    "for instance: add cut.csv@72, add "
		    "cut.csv@2026-05-03T10:15",
		    text);
	if (!m.has_date && isnan(day))
		return error_set(error, ERROR_USAGE,
		    "expected a day for the time %s, got none\n"
		    "write: date=2026-05-03, or @2026-05-03T%s",
		    text, text);
	*time = m.has_date ? datetime_seconds_since_1970(&m, order)
			   : day + m.seconds;
	if (m.has_date && !check_date_unambiguous(&m, text, "@", order, error))
		return false;
	return isnan(day) || day == datetime_start_of_day(*time) ||
	       error_set(error, ERROR_USAGE,
		   "expected the day of date= after @, got %s\n"
		   "leave one of the two out",
		   text);
}

/* Fills in *o for a word of the call.  A time, as in
 * "cut.csv@2026-05-03T10:15", is looked up in the log and replaced with the
 * speed then: "cut.csv@64.2". */
static bool
look_up_cut_speed_in_log(struct session *s, const struct args *args,
    const char *word, double day, double rotor, struct cut_source *o,
    struct error *error)
{
	const char *at = call_path_at_sign(word);
	size_t n = at != NULL ? (size_t)(at - word) : strlen(word);
	double time = NAN;
	FREED char *path = xstrndup(word, n);
	o->file = xstrdup(file_name_without_folders(path));
	o->word = xstrdup(word);
	o->when = isnan(day) ? xstrdup("") : datetime_to_text(day);
	if (!isnan(day))
		o->when[strcspn(o->when, " ")] = '\0';
	o->logged = (struct logged){NAN, NAN, NAN};
	if (at == NULL || heading_parse(at).speed > 0)
		return true;
	double window = 60 * args->window;
	if (!parse_cut_time(at + 1,
		day_month_order_given(
		    args, session_current_site_entry(s)->site),
		day, &time, error) ||
	    !log_find_speed_at_time(
		s, time, window / 2, rotor, &o->logged, error))
		return false;
	xfree_and_set(
	    &o->word, xasprintf("%.*s@%.1f", (int)n, word, o->logged.speed));
	xfree_and_set(&o->when, datetime_to_text(time));
	return true;
}

/* Returns what a site keeps about a cut, which the fit of power to speed and
 * feed rate reads: "72 m/s, 2026-05-03 10:15, 187 kW, 121 t/h, cut.csv". */
static char *
cut_note_text(double speed, const struct cut_source *o)
{
	char *text = xasprintf("%g m/s", speed);
	if (o != NULL && o->when[0] != '\0')
		xappend(&text, ", %s", o->when);
	if (o != NULL && !isnan(o->logged.power))
		xappend(&text, tr(", %.4g kW"), o->logged.power);
	if (o != NULL && !isnan(o->logged.rate))
		xappend(&text, ", %.4g t/h", o->logged.rate);
	if (o != NULL)
		xappend(&text, ", %s", o->file);
	return text;
}

/* Returns the text of a note, with an ambiguous date written as year, month,
 * day. */
static char *
site_note_with_iso_date(const struct site_note *note, enum datetime_order order)
{
	struct datetime m;
	if (!cut_parse_date(note, &m) || m.plain || m.order != DATETIME_OPEN)
		return xstrdup(note->value);
	FREED char *day = cut_date_and_time_text(&m, order);
	const char *at = strstr(note->value, ", ") + strlen(", ");
	return day == NULL ? xstrdup(note->value)
			   : xasprintf("%.*s%s%s", (int)(at - note->value),
				 note->value, day, at + strcspn(at, ","));
}

/* Returns the note of a run.  If its sheet has one and no other time is known,
 * it is that note, with the file added. */
static char *
cut_note_of_run(const struct site *cuts, size_t run, const struct cut_source *o,
    enum datetime_order order)
{
	const struct site_note *said = cut_find_note(cuts, run);
	if (said == NULL || (o != NULL && o->when[0] != '\0'))
		return cut_note_text(cuts->run[run].speed, o);
	FREED char *words = site_note_with_iso_date(said, order);
	bool named = o == NULL || strstr(words, o->file) != NULL;
	return xasprintf(
	    "%s%s%s", words, named ? "" : ", ", named ? "" : o->file);
}

/* If the sheet's header has a single date, which the reader did not take as the
 * day of the cuts because it is ambiguous, takes it as the day of the only
 * file. */
static void
set_cut_day_from_header(
    const struct site *cuts, enum datetime_order order, struct origins *all)
{
	struct datetime m, said;
	size_t n = 0;
	for (size_t i = 0; i < cuts->n_note; i++) {
		if (strcmp(cuts->note[i].key, "cut") == 0)
			return;
		if (!cut_parse_date(&cuts->note[i], &m))
			continue;
		said = m;
		n++;
	}
	if (all->n != 1 || all->file[0].when[0] != '\0' || n != 1)
		return;
	char *day = cut_date_and_time_text(&said, order);
	if (day != NULL)
		xfree_and_set(&all->file[0].when, day);
}

/* Says how the first ambiguous date was read, or that it was not read. */
static void
note_ambiguous_date(struct session *s, const struct site *cuts,
    const struct date_reading *how, const struct origins *all)
{
	struct datetime m;
	size_t i = 0;
	while (i < cuts->n_note && (!cut_parse_date(&cuts->note[i], &m) ||
				       m.plain || m.order != DATETIME_OPEN))
		i++;
	if (i == cuts->n_note)
		return;
	FREED char *day = cut_date_and_time_text(&m, DATETIME_DAY_FIRST);
	FREED char *month = cut_date_and_time_text(&m, DATETIME_MONTH_FIRST);
	FREED char *said = xasprintf("%02d/%02d/%d", m.day, m.month, m.year);
	bool one = cuts->n_run == 1 && all->n == 1;
	bool day_first = how->order == DATETIME_DAY_FIRST;
	if (how->order == DATETIME_OPEN && one)
		session_print_note(s,
		    "  warning: the date %s can be %s or %s, so the cut has "
		    "none: 'undo', then add it with date=%s",
		    said, day, month, day);
	else if (how->order == DATETIME_OPEN)
		session_print_note(s,
		    "  warning: the date %s can be %s or %s, so the cut has "
		    "none: 'undo', then add the cuts with dates=day-first or "
		    "dates=month-first",
		    said, day, month);
	else
		session_print_note(s, "  the date %s is read as %s, %s", said,
		    day_first ? day : month, how->why);
	if (how->now && one)
		invocation_add_journal_options(
		    s, " date=%s", day_first ? day : month);
	else if (how->now)
		invocation_add_journal_options(
		    s, " dates=%s-first", day_first ? "day" : "month");
}

/* Returns the file of a cut: the only one, or the one with its speed; or
 * NULL. */
static const struct cut_source *
find_file_of_cut(const struct origins *all, double speed)
{
	const struct cut_source *found = all->n == 1 ? &all->file[0] : NULL;
	for (size_t i = 0; i < all->n && found == NULL; i++) {
		const char *at = call_path_at_sign(all->file[i].word);
		double v;
		if (at != NULL && text_parse_number(at + 1, &v) &&
		    fabs(v - speed) < 1e-3)
			found = &all->file[i];
	}
	return found;
}

/* Warns of products that the site already has; notes feeds that differ. */
static void
warn_of_duplicate_cuts(
    struct session *s, const struct site *site, const struct site *cuts)
{
	for (size_t k = 0; k < cuts->n_run; k++) {
		const struct run *cut = &cuts->run[k];
		FREED char *rpm =
		    rotor_speed_rpm_text(site->rotor, cut->speed, NAN);
		for (size_t r = 0; r < site->n_run; r++) {
			if (cut_is_duplicate(&site->run[r], cut))
				session_print_note(s,
				    "  warning: these numbers are identical to "
				    "the product at %g m/s%s%s: was the cut "
				    "added before?",
				    cut->speed, site->run[r].repeat, rpm);
		}
		double apart = 0;
		for (size_t i = 0; i < cut->feed.n; i++) {
			double is = psd_passing_at_sieve(
			    site_feed_of_run(site, SITE_MEAN_FEED),
			    cut->feed.size[i]);
			if (!isnan(is))
				apart = fmax(
				    apart, fabs(is - cut->feed.passing[i]));
		}
		if (apart > 0)
			session_print_note(s,
			    "  the cut at %g m/s%s has a feed of its own, up "
			    "to %.1f points from that of the site: it is used "
			    "for this cut",
			    cut->speed, rpm, 100 * apart);
	}
}

/* If the site's feeds differ, names the one used for cuts without a feed. */
static void
note_feed_of_cuts(
    struct session *s, const struct site *site, const struct site *cuts)
{
	FREED char *words = feed_sampling_text(site, SITE_MEAN_FEED);
	bool lacking = false;
	for (size_t k = 0; k < cuts->n_run; k++)
		lacking = lacking || cuts->run[k].feed.n == 0;
	if (lacking && words != NULL)
		session_print_note(s, "  feed: %s", words);
}

/* How well the prediction matches the new cuts, from best to worst. */
enum verdict { CUTS_UNKNOWN, CUTS_MET, CUTS_OFF, CUTS_MISSED };

/* Returns the passing of predict's first sentence at the speed of a cut or, if
 * the cut was not sieved so fine, a passing that its sieves reach. */
static struct quantity
choose_passing_to_check_cut(
    const struct session *s, const struct entry *entry, size_t run)
{
	const struct run *cut = &entry->site->run[run];
	struct prediction p = forecast_whole_product(s, entry, cut->speed, run);
	struct quantity of = answers_default_passing_quantity(&p.product);
	prediction_free(&p);
	return psd_covers_size(&cut->product, of.x)
		   ? of
		   : answers_default_passing_quantity(&cut->product);
}

/* Returns "33.0 % passes 2 mm at 72 m/s, predicted 33.4 (32.6 to 34.1 for a
 * belt cut)".  The caller frees it. */
static char *
measured_vs_predicted_text(
    const struct session *s, const struct entry *entry, size_t run)
{
	const struct run *cut = &entry->site->run[run];
	const struct quantity of = choose_passing_to_check_cut(s, entry, run);
	const struct question q = question_of_whole_product(s, entry, run);
	struct forecast *f = forecast_open(s, &q, &of, 1);
	forecast_set_speed_and_ensemble(f, cut->speed, ENSEMBLE_SAMPLE);
	struct figure at = forecast_value_in_shown_unit(f, 0);
	FREED char *measured = quantities_sentence_with_value(
	    &of, psd_passing(&cut->product, of.x));
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, cut->speed, NAN);
	char *words = xasprintf(tr("%s at %g m/s%s%s, predicted %.1f"),
	    measured, cut->speed, cut->repeat, rpm, at.value);
	if (isfinite(at.low))
		xappend(&words, tr(" (%.1f to %.1f for a belt cut)"), at.low,
		    at.high);
	forecast_close(f);
	return words;
}

static enum verdict
compare_cut_to_prediction(struct session *s, size_t run)
{
	const struct entry *entry = session_current_site_entry(s);
	const struct site *site = entry->site;
	if (!entry->has_params ||
	    misfit_count_covered_sieves(&site->run[run]) == 0)
		return CUTS_UNKNOWN;
	struct cut cut = cut_compare_with_prediction(s, entry, run);
	FREED char *both = measured_vs_predicted_text(s, entry, run);
	FREED char *words = cut_comparison_text(&cut);
	double from, to;
	if (answers_is_speed_extrapolated(entry, site->run[run].speed) &&
	    origin_training_speed_range(entry, &from, &to)) {
		FREED char *reach =
		    answers_training_range_text(entry, from, to);
		xappend_to_list(&words, "; ",
		    tr("it lies outside the %s, where the answer rests on the "
		       "model"),
		    reach);
	}
	/* Fewer passings are in the band than chance and shared errors make
	 * likely. */
	bool nearly = !cut.no_band && 4 * cut.inside < 3 * cut.n;
	session_print_note(s,
	    cut.off      ? N_("  not quite as expected: %s; %s")
	    : cut.missed ? N_("  warning: not as expected: %s; %s")
	    : nearly     ? N_("  nearly as expected: %s; %s")
			 : N_("  as expected: %s; %s"),
	    both, words);
	return cut.off ? CUTS_OFF : cut.missed ? CUTS_MISSED : CUTS_MET;
}

/* Compares each new run with its prediction and notes the result or, if there
 * are many, how many are missed.  from: see site_copy_with_cuts.  Returns the
 * worst verdict. */
static enum verdict
compare_cuts_to_predictions(
    struct session *s, const struct site *old, const size_t *from, size_t n)
{
	enum { FEW = 3 };
	const struct entry *entry = session_current_site_entry(s);
	enum verdict worst = CUTS_UNKNOWN, one;
	size_t compared = 0, missed = 0;
	for (size_t r = 0; r < entry->site->n_run; r++) {
		if (entry->site->run[r].product.n == 0 ||
		    (from[r] != SIZE_MAX && old->run[from[r]].product.n > 0))
			continue;
		if (n <= FEW) {
			one = compare_cut_to_prediction(s, r);
			worst = one > worst ? one : worst;
		} else if (entry->has_params) {
			compared++;
			missed +=
			    cut_compare_with_prediction(s, entry, r).missed;
		}
	}
	if (compared == 0)
		return worst;
	if (missed > 0)
		session_print_note(s,
		    tr_n("  warning: %zu of the %zu cuts is not as expected",
			"  warning: %zu of the %zu cuts are not as expected",
			missed),
		    missed, compared);
	else
		session_print_note(
		    s, "  all %zu cuts are as expected", compared);
	return missed > 0 ? CUTS_MISSED : CUTS_MET;
}

static void
print_speeds_of_products(struct session *s)
{
	const struct entry *entry = session_current_site_entry(s);
	FREED char *speeds =
	    session_speeds_of_runs_text(entry->site, ", ", NULL, true);
	FREED char *rpm =
	    session_rpm_of_runs_in_brackets(entry->site, NULL, true);
	session_print_note(
	    s, "  %s has products at %s m/s%s", entry->key, speeds, rpm);
}

/* Suggests what to do after n cuts were compared.  For a calibrated site it
 * judges all cuts since its calibration, as suggest_next_step does. */
static void
suggest_step_after_cuts(struct session *s, enum verdict worst, size_t n)
{
	const struct entry *entry = session_current_site_entry(s);
	struct later later = cut_compare_runs_since_fit(s, entry);
	if (later.n > 0) {
		worst = later.missed ? CUTS_MISSED
			: later.off  ? CUTS_OFF
				     : CUTS_MET;
		n = later.n;
	}
	if (later.twice) {
		session_print_note(
		    s, "  next: 'undo', unless two samples came out the same");
		return;
	}
	session_print_note(
	    s, !entry->has_params ? N_("  next: 'calibrate'")
	       : worst == CUTS_MISSED && n > 1 && entry->has_fit
		   ? N_("  next: 'drift' follows the cuts one by one")
	       : worst == CUTS_MISSED
		   ? N_("  next: check how the cut and its feed were taken; if "
			"they are right, 'calibrate train=all'")
	       : worst == CUTS_OFF
		   ? N_("  next: take one more cut before anything is changed")
	       : !entry->has_fit ? N_("  next: nothing needs to be done")
	       : n > 1 ? N_("  next: 'calibrate' includes them in the answers")
		       : N_("  next: 'calibrate' includes it in the answers"));
}

static bool
check_or_journal_digest(const struct site *site, const char *digest,
    struct session *s, struct error *error)
{
	FREED char *found = xasprintf("%016" PRIx64, site->digest);
	bool good = digest == NULL || strcmp(digest, found) == 0;
	if (!good)
		error_set(error, ERROR_DATA,
		    "expected the site to have digest %s with these cuts, got "
		    "%s: numbers of a cut, of the log or of the site have "
		    "changed\n"
		    "leave out digest= to add them anyway; results will change",
		    digest, found);
	if (good && digest == NULL)
		invocation_add_journal_options(s, " digest=%s", found);
	return good;
}

/* Adds the notes about the cuts, in the order of the sheet, which drift follows
 * for cuts without a date. */
static void
add_cut_notes_to_site(struct session *s, struct site *site,
    const struct site *cuts, const struct origins *all,
    enum datetime_order order)
{
	FREED size_t *place = xcalloc(cuts->n_run + 1, sizeof *place);
	for (size_t k = 0; k < cuts->n_run; k++) {
		size_t i = k;
		for (; i > 0; i--) {
			size_t before = place[i - 1];
			if (cuts->run[before].place <= cuts->run[k].place)
				break;
			place[i] = before;
		}
		place[i] = k;
	}
	for (size_t k = 0; k < cuts->n_run; k++) {
		double v = cuts->run[place[k]].speed;
		FREED char *note = cut_note_of_run(
		    cuts, place[k], find_file_of_cut(all, v), order);
		site_notes_append(&site->note, &site->n_note, "cut", note);
		session_print_note(s, "added a cut: %s", note);
	}
}

/* If the provenance begins with the day of the sheet, adds the day of the last
 * cut: "sheet of 2026-11-02, cuts to 2026-11-19". */
static void
add_last_cut_day_to_provenance(struct site *site)
{
	static const char SHEET[] = "sheet of ", CUTS[] = ", cuts to ";
	enum { DAY = sizeof "2026-11-19" - 1 };
	char last[DAY + 1] = "";
	struct datetime m;
	if (strncmp(site->provenance, SHEET, strlen(SHEET)) != 0)
		return;
	for (size_t i = 0; i < site->n_note; i++) {
		const struct site_note *note = &site->note[i];
		const char *day = strstr(note->value, ", ");
		if (strcmp(note->key, "cut") == 0 && cut_parse_date(note, &m) &&
		    m.plain && strncmp(day + 2, last, DAY) > 0)
			snprintf(last, sizeof last, "%.*s", DAY, day + 2);
	}
	if (last[0] == '\0')
		return;
	size_t clause = strcspn(site->provenance, ";");
	FREED char *first = xstrndup(site->provenance, clause);
	char *cuts = strstr(first, CUTS);
	if (cuts != NULL)
		cuts[0] = '\0';
	xfree_and_set(&site->provenance, xasprintf("%s%s%s%s", first, CUTS,
					     last, site->provenance + clause));
}

/* Returns the start of the day that the note of a run states, or NAN. */
static double
cut_day_of_run(const struct site *site, size_t run, enum datetime_order order)
{
	struct datetime m;
	const struct site_note *note = cut_find_note(site, run);
	return note != NULL && cut_parse_date(note, &m)
		   ? datetime_start_of_day(
			 datetime_seconds_since_1970(&m, order))
		   : (double)NAN;
}

/* Drops cuts that the site has already, with the same day and numbers: a
 * laboratory may write the cuts of each week below those of the week before. */
static void
drop_known_cuts(struct session *s, const struct site *site, struct site *cuts,
    enum datetime_order order)
{
	for (size_t k = 0; k < cuts->n_run; k++) {
		double day = cut_day_of_run(cuts, k, order);
		size_t r = 0;
		while (r < site->n_run &&
		       (!cut_is_duplicate(&site->run[r], &cuts->run[k]) ||
			   cut_day_of_run(site, r, order) != day))
			r++;
		if (r == site->n_run || isnan(day))
			continue;
		session_print_note(s, "not added, as %s has it: %s",
		    session_current_site_entry(s)->key,
		    cut_find_note(site, r)->value);
		const struct site_note *note = cut_find_note(cuts, k);
		site_drop_note(cuts, (size_t)(note - cuts->note));
		site_drop_run(cuts, k--);
	}
}

/* Returns the name of a site, or "" if it is that of its file. */
static const char *
name_unless_of_file(const struct site *site)
{
	const char *file = file_name_without_folders(site->path);
	size_t n = strlen(site->name);
	bool same = strncmp(file, site->name, n) == 0;
	return same && (file[n] == '.' || file[n] == '\0') ? "" : site->name;
}

static void
warn_of_cuts_of_other_site(
    struct session *s, const struct site *site, const struct site *cuts)
{
	const char *stated[][2] = {
	    {name_unless_of_file(site), name_unless_of_file(cuts)},
	    {site->machine, cuts->machine}, {site->rock, cuts->rock}};
	for (size_t i = 0; i < ARRAY_LEN(stated); i++)
		if (stated[i][0][0] != '\0' && stated[i][1][0] != '\0' &&
		    !text_is_same_folded(stated[i][0], stated[i][1]))
			session_print_note(s,
			    "  warning: the site has '%s', the sheet of the "
			    "cuts '%s': 'undo' if they are of another site",
			    stated[i][0], stated[i][1]);
}

static bool
add_cuts_to_current_site(struct session *s, const struct args *args,
    struct site *cuts, struct origins *all, struct error *error)
{
	const struct site *old = session_current_site_entry(s)->site;
	const struct date_reading how =
	    find_day_month_order_of_cuts(args, cuts, old);
	drop_known_cuts(s, old, cuts, how.order);
	if (cuts->n_run == 0)
		return true;
	FREED size_t *from = xcalloc(old->n_run + cuts->n_run, sizeof *from);
	struct site *site = site_copy_with_cuts(old, cuts, from);
	char number[32];
	if (site_assumed_top_size(cuts) > site_assumed_top_size(old))
		site_notes_append(&site->note, &site->n_note, SITE_ASSUMED_TOP,
		    text_shortest_exact_number(
			site_assumed_top_size(cuts), number));
	if (!check_or_journal_digest(site, args->digest, s, error)) {
		site_free(site);
		return false;
	}
	if (!(site->rotor > 0))
		site->rotor = args->rotor_mm / 1000;
	set_cut_day_from_header(cuts, how.order, all);
	add_cut_notes_to_site(s, site, cuts, all, how.order);
	add_last_cut_day_to_provenance(site);
	if (args->date == NULL)
		note_ambiguous_date(s, cuts, &how, all);
	load_print_how_site_was_read(s, cuts);
	warn_of_cuts_of_other_site(s, old, cuts);
	warn_of_duplicate_cuts(s, old, cuts);
	note_feed_of_cuts(s, site, cuts);
	session_replace_site_by_extended(s, site, from);
	s->entry[s->current].new_cuts += cuts->n_run;
	check_warn_coarser_product(s, site);
	print_speeds_of_products(s);
	enum verdict worst =
	    compare_cuts_to_predictions(s, old, from, cuts->n_run);
	suggest_step_after_cuts(s, worst, cuts->n_run);
	return true;
}

bool
cmd_add(struct session *s, const struct args *args, struct error *error)
{
	const struct site *site = session_current_site_entry(s)->site;
	double day,
	    rotor = args->rotor_mm > 0 ? args->rotor_mm / 1000 : site->rotor;
	struct origins all = {
	    .file = xcalloc(args->n_operand, sizeof *all.file)};
	FREED const char **word = xcalloc(args->n_operand, sizeof(*word));
	bool good = parse_cut_date(
	    args->date, day_month_order_given(args, site), &day, error);
	for (size_t i = 0; i < args->n_operand && good; i++) {
		good = look_up_cut_speed_in_log(s, args, args->operand[i], day,
		    rotor, &all.file[all.n++], error);
		word[i] = all.file[i].word;
	}
	struct site *cuts =
	    good ? load_cuts(s, args, word, rotor, error) : NULL;
	good = cuts != NULL &&
	       add_cuts_to_current_site(s, args, cuts, &all, error);
	site_free(cuts);
	free_cut_sources(&all);
	return good;
}
