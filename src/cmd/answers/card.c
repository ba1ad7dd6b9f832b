/* card: a page for the operator with the products at several speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/outlook.h"
#include "cmd/document/document.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/moved.h"
#include "cmd/plant/plant.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/question.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "io/cells/datetime.h"
#include "io/sitefile/units.h"

/* What the card shows at each speed: P20, P50 and P80, then the user's figures;
 * whether the limits are met; and tonnes.  ranged: the index of the one figure
 * whose range is shown, as a page has no room for more. */
struct card_request {
	const struct question *question;
	size_t n, ranged;
	struct quantity *q;
	struct forecast *forecast;
	struct forecast *cut;       /* the ranged figure, for new belt cuts */
	struct condition_list list; /* limits of the product, or none */
	bool of_goal; /* the limits are those of the session's goal */
	struct conditions_search wanted;
	struct plant plant; /* circuit NULL: no flow was asked for */
	size_t n_line;
	struct plant_stream_row *line;
	char *power;
};

/* Adds a quantity that is not in the list yet.  Returns its index. */
static size_t
add_card_quantity(struct card_request *all, struct quantity q)
{
	size_t at = 0;
	while (at < all->n && !quantity_is_same(&all->q[at], &q))
		at++;
	if (at < all->n)
		return at;
	all->q = xrealloc(all->q, all->n + 1, sizeof *all->q);
	all->q[all->n++] = q;
	return at;
}

/* Adds the quantities named in a text.  The range of the first one is shown. */
static bool
parse_card_quantities(struct card_request *all, const char *text,
    const struct psd *feed, struct error *error)
{
	size_t n;
	FREED struct quantity *q = quantities_parse_list_for_feed(
	    text, &all->question->fraction, feed, true, &n, error);
	for (size_t i = 0; q != NULL && i < n; i++) {
		size_t at = add_card_quantity(all, q[i]);
		all->ranged = i == 0 ? at : all->ranged;
	}
	return q != NULL;
}

/* Adds two passings: at the feed's sieve nearest to 2 mm, and at the size of
 * fines or, if the feed does not cover it, at the finest sieve. */
static void
add_usual_card_passings(struct card_request *all, const struct psd *feed)
{
	bool fines = psd_covers_size(feed, QUANTITIES_FINES);
	struct quantity q = {
	    .kind = QUANTITY_PASSING, .fraction = all->question->fraction};
	double near = feed->size[0], finest = feed->size[feed->n - 1];
	for (size_t i = 1; i < feed->n; i++)
		if (fabs(log(feed->size[i] / 2e-3)) < fabs(log(near / 2e-3)))
			near = feed->size[i];
	/* Rounded as a limit that is typed in mm, so that the two compare
	 * equal. */
	q.x = units_m_to_mm(near) / 1000;
	all->ranged = add_card_quantity(all, q);
	q.x = fines ? QUANTITIES_FINES : units_m_to_mm(finest) / 1000;
	q.letter = fines ? 'f' : 0;
	add_card_quantity(all, q);
}

static void
card_request_free(struct card_request *all)
{
	plant_free(&all->plant);
	free(all->line);
	free(all->power);
	free(all->q);
	conditions_free(&all->list);
	forecast_close(all->wanted.forecast);
	forecast_close(all->forecast);
	forecast_close(all->cut);
}

/* Reads the plant if the call has tph= or circuit=. */
static bool
parse_plant_if_asked(struct session *s, struct card_request *all,
    const struct args *args, struct error *error)
{
	const void *const with_feed[] = {&args->fractions, &args->recycle,
	    &args->power, &args->prices, &args->kwh};
	if (args->tph > 0 || args->circuit != NULL) {
		bool ok =
		    plant_from_args(s, args, all->question, &all->plant, error);
		FREED char *fixed =
		    ok ? plant_fixed_speeds_text(&all->plant, NULL) : NULL;
		return fixed == NULL ? ok
				     : error_set(error, ERROR_USAGE,
					   "expected a circuit with a crusher "
					   "without speed=, got one in which "
					   "all have their own, %s m/s\n"
					   "write: flow circuit=%s",
					   fixed, args->circuit);
	}
	for (size_t i = 0; i < ARRAY_LEN(with_feed); i++)
		if (args_is_given(args, with_feed[i]))
			return error_set(error, ERROR_USAGE,
			    "expected tph= with %s=\nadd the new feed, such as "
			    "tph=120",
			    args_option_name(args, with_feed[i]));
	return true;
}

/* Solves the circuit once at a speed, because the names of its products are not
 * known before. */
static bool
solve_circuit_for_stream_names(
    struct card_request *all, double speed, struct error *error)
{
	const struct circuit *c = all->plant.circuit;
	struct plant_result o = plant_compute_flow_at_speed(&all->plant, speed);
	bool ok =
	    !o.flow.open || plant_set_error_not_steady(&all->plant, &o, error);
	all->line = xcalloc(c->n_stream + c->n_unit, sizeof *all->line);
	all->n_line = plant_list_streams(&all->plant, &o, all->line);
	all->power = plant_power_basis_text(&all->plant, &o);
	flow_free(&o.flow);
	return ok;
}

/* Takes the limits of the session's goal if the call has none.  A goal with a
 * single value is for find, and gives no limits. */
static bool
add_session_goal_limits(
    struct session *s, struct card_request *all, struct error *error)
{
	size_t n_value = 0;
	if (all->list.n > 0 || !goals_is_set(s))
		return true;
	bool ok = goals_parse(s, s->set.goal, question_feed(all->question),
	    &all->list, &n_value, error);
	if (n_value > 0)
		conditions_free(&all->list);
	all->of_goal = ok && n_value == 0;
	return ok;
}

/* Chooses the first figure with a limit, if any, as the one whose range is
 * shown. */
static void
choose_card_quantity_with_range(struct card_request *all)
{
	for (size_t c = all->list.n; c-- > 0;)
		for (size_t i = 0; i < all->n; i++)
			if (quantity_is_same(
				&all->q[i], &all->list.at[c].quantity))
				all->ranged = i;
}

static bool
parse_card_request(struct session *s, struct card_request *all,
    const struct args *args, double slowest, struct error *error)
{
	const struct psd *feed = question_feed(all->question);
	bool named = args_is_given(args, &args->of);
	if (!parse_card_quantities(all, ANSWERS_SIZE_LIST, feed, error))
		return false;
	if (!named)
		add_usual_card_passings(all, feed);
	bool ok =
	    (!named || parse_card_quantities(all, args->of, feed, error)) &&
	    conditions_add_from_args(
		s, args, all->question, &all->list, error) &&
	    add_session_goal_limits(s, all, error) &&
	    parse_plant_if_asked(s, all, args, error);
	if (!ok)
		return false;
	choose_card_quantity_with_range(all);
	all->forecast = forecast_open(s, all->question, all->q, all->n);
	all->cut = forecast_open(s, all->question, &all->q[all->ranged], 1);
	if (all->list.n > 0)
		all->wanted =
		    conditions_open_search(s, all->question, &all->list, NULL);
	return all->plant.circuit == NULL ||
	       solve_circuit_for_stream_names(all, slowest, error);
}

/* A row's speed and its verdicts.  share: of the draws, those that meet the
 * limits, NAN without draws; holds: the answer meets them; beyond: the speed is
 * beyond the measured ones. */
struct card_row {
	double speed, share;
	bool holds, beyond;
	enum light light;
};

/* The table of the card.  row: the index of the row being added; ranged: the
 * range of the ranged figure is shown; cut: the farthest that the range of a
 * new belt cut reaches from that figure; measured: its measured value is shown;
 * moved: the most by which samples were moved to the feed, 0..1 (moved.h). */
struct card_table {
	struct answer *answer;
	size_t row;
	bool ranged, measured;
	double cut, moved;
};

/* Ranks of columns: if the page is too narrow, the last of these are left out
 * first. */
enum { NEEDED, ASKED, FIGURE, MEDIAN, RANGE, SAMPLE, FINE, OTHER_UNIT };
enum { AS_NEEDED = -1 };

/* Adds a cell under `head` in the table for people and under `key` in that for
 * programs; a table whose name is NULL gets no cell.  The first row also adds
 * the column.  word: the text of the cell, or NULL for a number. */
static void
put_card_cell(struct card_table *page, const char *key, const char *head,
    int decimals, int spare, double number, const char *word)
{
	struct answer *r = page->answer;
	for (int programs = 0; programs < 2; programs++) {
		const char *name = programs ? key : head;
		if (name == NULL)
			continue;
		if (programs)
			answer_begin_table_for_programs(r);
		else
			answer_resume_table_for_people(r);
		if (page->row == 0)
			answer_add_optional_column(r, name, name, spare);
		if (word != NULL)
			answer_add_text_cell(r, "%s", word);
		else
			answer_add_cells(r, "%.*f", decimals, number);
	}
}

static void
put_card_number_cell(struct card_table *page, const char *key, const char *head,
    int decimals, int spare, double number)
{
	put_card_cell(page, key, head, decimals, spare, number, NULL);
}

/* Takes ownership of the word. */
static void
put_card_text_cell(struct card_table *page, const char *key, const char *head,
    int spare, char *word)
{
	put_card_cell(page, key, head, AS_NEEDED, spare, NAN, word);
	free(word);
}

/* Returns a heading such as "<2 mm", short enough for a page on a wall.  It
 * leaves out the fraction of the question, which a note below the table
 * names. */
static char *
card_heading_of_quantity(
    const struct card_request *all, const struct quantity *q)
{
	struct quantity own = *q;
	const struct fraction *cut = &all->question->fraction;
	if (cut->fine == own.fraction.fine &&
	    cut->coarse == own.fraction.coarse)
		own.fraction = (struct fraction){0};
	if (q->kind == QUANTITY_PASSING && q->letter == 0 &&
	    !fraction_is_screened(&own.fraction))
		return xasprintf("<%g mm", units_m_to_mm(q->x));
	char *words = quantities_name(&own);
	if (q->kind == QUANTITY_SHARE)
		xappend(&words, " %%");
	return words;
}

/* Returns the heading of the range.  It names the figure, so that nobody takes
 * the range for that of P80, unless the name is much wider than the range. */
static char *
band_column_heading(const struct card_request *all)
{
	enum { WIDE = 9 };
	FREED char *head = card_heading_of_quantity(all, &all->q[all->ranged]);
	return text_width_in_columns(head) <= WIDE
		   ? xasprintf(tr("%s band"), head)
		   : xasprintf(tr("%.0f %% band"), 100 * all->question->level);
}

/* Returns the measured value of the ranged figure at a speed, or NAN.  Raises
 * *moved to the amount by which it was moved to the card's feed. */
static double
measured_card_value_at_speed(const struct session *s,
    const struct card_request *all, double speed, double *moved)
{
	const struct question *q = all->question;
	size_t n;
	return measured_mean_quantity_at_speed(
	    s, q->entry, q->feed, &all->q[all->ranged], speed, moved, &n);
}

enum { P20, P50, P80 };

static int
card_column_priority(const struct card_request *all, size_t i)
{
	return i == all->ranged ? NEEDED
	       : i == P80       ? ASKED
	       : i == P50       ? MEDIAN
	       : i == P20       ? FINE
				: FIGURE;
}

/* Returns an end of a band, or "-" if it is beyond the sieves.  The caller
 * frees it. */
static char *
end_of_band_text(int digits, double end)
{
	return isnan(end) ? xstrdup("-") : xasprintf("%.*f", digits, end);
}

/* Puts the range of the figure that has one.  Programs have that of P80 at any
 * rate. */
static void
put_card_band(struct card_table *page, const struct quantity *q,
    const char *head, struct figure f)
{
	int digits = quantities_decimals(q);
	FREED char *from = end_of_band_text(digits, f.low);
	FREED char *to = end_of_band_text(digits, f.high);
	put_card_text_cell(
	    page, NULL, head, RANGE, xasprintf("%s..%s", from, to));
	if (q->kind == QUANTITY_SIZE && q->x == PSD_PASSING[P80] &&
	    !fraction_is_screened(&q->fraction))
		return;
	FREED char *key = quantities_field_name(q);
	FREED char *low = xasprintf("%s_low", key);
	FREED char *high = xasprintf("%s_high", key);
	put_card_number_cell(page, low, NULL, digits, NEEDED, f.low);
	put_card_number_cell(page, high, NULL, digits, NEEDED, f.high);
}

/* A size that the curve does not reach at this speed leaves its cell empty. */
static void
put_card_quantities(struct card_table *page, const struct session *s,
    const struct card_request *all, double speed)
{
	size_t ranged = all->ranged;
	FREED char *range = band_column_heading(all);
	if (page->row == 0)
		page->ranged =
		    forecast_draws_of_quantity(all->forecast, ranged) != NULL;
	for (size_t i = 0; i < all->n; i++) {
		const struct quantity *q = &all->q[i];
		struct figure f =
		    forecast_value_in_shown_unit(all->forecast, i);
		int digits = quantities_decimals(q);
		FREED char *key = quantities_field_name(q),
			   *head = card_heading_of_quantity(all, q);
		put_card_number_cell(page, key, head, digits,
		    card_column_priority(all, i), f.value);
		if (i == ranged && page->ranged)
			put_card_band(page, q, range, f);
		FREED char *sample = xasprintf("%s_measured", key);
		if (i == ranged && page->measured)
			put_card_number_cell(page, sample, tr("measured"),
			    digits, SAMPLE,
			    measured_card_value_at_speed(
				s, all, speed, &page->moved));
	}
	struct figure p80 = forecast_value_in_shown_unit(all->forecast, P80);
	put_card_number_cell(page, "p80_low_mm", NULL, 2, NEEDED, p80.low);
	put_card_number_cell(page, "p80_high_mm", NULL, 2, NEEDED, p80.high);
	if (!page->ranged)
		return;
	forecast_set_speed_and_ensemble(all->cut, speed, ENSEMBLE_SAMPLE);
	struct figure cut = forecast_value_in_shown_unit(all->cut, 0);
	page->cut =
	    fmax(page->cut, fmax(cut.high - cut.value, cut.value - cut.low));
}

/* Puts the tonnes of each stream, the power and the earnings; NAN if the plant
 * has no steady state. */
static void
put_card_plant_cells(
    struct card_table *page, const struct card_request *all, double speed)
{
	struct plant_result o = plant_compute_flow_at_speed(&all->plant, speed);
	bool open = o.flow.open;
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_stream_row *line = &all->line[i];
		bool back = line->unit == NULL;
		double tph = back ? o.flow.tph[line->stream]
				  : flow_tph_into_unit(&o.flow, line->unit);
		FREED char *key =
		    xasprintf("%s_%s", back ? "back_tph" : "tph", line->name);
		FREED char *head =
		    xasprintf(back ? tr("%s back") : "%s", line->name);
		put_card_number_cell(
		    page, key, head, 1, NEEDED, open ? NAN : tph);
	}
	put_card_number_cell(page, "kwh_per_t", "kWh/t", 2, ASKED,
	    open ? NAN : o.kw / all->plant.circuit->tph);
	if (all->plant.priced)
		put_card_number_cell(page, "earnings", tr("earned/h"), 0,
		    NEEDED, open ? NAN : o.money);
	flow_free(&o.flow);
}

static void
put_limits_verdict_cells(struct card_table *page, const struct card_row *row)
{
	bool drawn = !isnan(row->share);
	put_card_text_cell(page, "limits", tr("limits"), NEEDED,
	    xstrdup(conditions_verdict(row->share, row->holds)));
	if (drawn) {
		bool sure = row->share < 0.01 || row->share > 0.99;
		answer_set_missing_text(
		    page->answer, row->share < 0.5 ? "<1" : ">99");
		put_card_number_cell(page, NULL, tr("met in 100"), 0, NEEDED,
		    sure ? NAN : 100 * row->share);
		answer_set_missing_text(page->answer, "-");
	}
	put_card_text_cell(page, "certain", NULL, NEEDED,
	    drawn ? conditions_probability_text(row->share) : xstrdup("-"));
	put_card_number_cell(
	    page, "certain_pct", NULL, 0, NEEDED, 100 * row->share);
}

/* Puts the speed in both units; for people the unit of the sheet comes
 * first. */
static void
put_card_speed_cells(struct card_table *page, const struct site *site, double v)
{
	bool in_rpm = answers_is_sheet_in_rpm(site);
	double rpm = rotor_speed_to_rpm(v, site->rotor);
	if (in_rpm)
		put_card_number_cell(page, NULL, tr("rpm"), 0, NEEDED, rpm);
	put_card_number_cell(page, NULL, "m/s", AS_NEEDED,
	    in_rpm ? OTHER_UNIT : NEEDED, round(100 * v) / 100);
	if (site->rotor > 0 && !in_rpm)
		put_card_number_cell(page, NULL, tr("rpm"), 0, NEEDED, rpm);
	put_card_number_cell(page, "speed", NULL, AS_NEEDED, NEEDED, v);
	if (site->rotor > 0)
		put_card_number_cell(page, "rpm", NULL, 0, NEEDED, rpm);
}

/* Puts the row of one speed.  Beyond the measured speeds the light has a
 * question mark, "amber?". */
static void
put_card_row(struct card_table *page, struct session *s,
    const struct card_request *all, struct card_row *row, struct trust *worst)
{
	const struct entry *entry = all->question->entry;
	double v = row->speed;
	put_card_speed_cells(page, entry->site, v);
	forecast_set_speed(all->forecast, v);
	put_card_quantities(page, s, all, v);
	struct trust light = trust_at_speed(s, entry, v, all->question->feed);
	row->light = light.light;
	row->beyond = answers_is_speed_extrapolated(entry, v);
	trust_replace_if_worse(worst, light);
	const char *name = tr(LIGHT_NAME[row->light]);
	put_card_text_cell(page, NULL, tr("trust"), NEEDED,
	    xasprintf("%s%s", name, row->beyond ? "?" : ""));
	if (all->plant.circuit != NULL)
		put_card_plant_cells(page, all, v);
	if (all->list.n > 0) {
		forecast_set_speed(all->wanted.forecast, v);
		row->holds = conditions_are_met(&all->wanted, SIZE_MAX);
		row->share = conditions_probability(&all->wanted);
		put_limits_verdict_cells(page, row);
	}
	put_card_text_cell(page, "light", NULL, NEEDED, xstrdup(name));
	page->row++;
}

/* Titles the card "hollow_lane (Hollow Lane Quarry): card of 2026-11-27".  If a
 * site is named only after its file, the first line of its sheet, up to a comma
 * or a dash, is added, because the cabin knows it by that name.  Lines of two
 * cells, such as "Date, 12 May", are not names. */
static void
set_card_title(struct answer *r, const struct site *site, const char *today)
{
	const char *slash = strrchr(site->path, '/');
	const char *file = slash != NULL ? slash + 1 : site->path;
	bool of_file = strncmp(file, site->name, strlen(site->name)) == 0;
	FREED char *label = session_site_label(site);
	for (size_t i = 0; i < site->n_note && of_file; i++) {
		bool title = i == 0 && strchr(site->note[i].key, ' ') != NULL;
		if (site->note[i].value[0] != '\0' && !title)
			continue;
		FREED char *line = xstrdup(site->note[i].key);
		char *dash = strstr(line, " - ");
		if (dash != NULL)
			*dash = '\0';
		line[strcspn(line, ",")] = '\0';
		answer_set_title(r, "%s (%s): card of %s", label, line, today);
		return;
	}
}

static void
note_plant_and_power(struct answer *r, const struct card_request *all)
{
	if (all->plant.circuit == NULL)
		return;
	const char *back = all->plant.back;
	bool returns = back != NULL && back[0] != '\0';
	if (returns)
		answer_note(r, "%g t/h of new feed, %s back to the crusher; %s",
		    all->plant.circuit->tph, back, all->power);
	else
		answer_note(r, "%g t/h of new feed; %s",
		    all->plant.circuit->tph, all->power);
	if (returns)
		answer_add_sentence(r, ANSWER_REMARK,
		    "sizes and passings are those of the new feed's product, "
		    "without what comes back; tonnes include it");
}

/* Warns if no row is likely to meet the limits. */
static void
warn_if_limits_never_met(struct answer *r, const struct site *site,
    const struct card_row *row, size_t n)
{
	size_t best = 0;
	for (size_t i = 1; i < n; i++)
		if (row[i].share > row[best].share)
			best = i;
	FREED char *rpm =
	    rotor_speed_rpm_text(site->rotor, row[best].speed, NAN);
	FREED char *often = conditions_times_in_100_text(row[best].share);
	if (row[best].share < 0.01)
		answer_add_sentence(r, ANSWER_WARNING,
		    "no speed on this page meets the limits");
	else if (row[best].share < 0.5)
		answer_add_sentence(r, ANSWER_WARNING,
		    "no speed on this page is likely to meet the limits: the "
		    "most likely, %g m/s%s, meets them %s",
		    row[best].speed, rpm, often);
}

static void
note_limits_of_card(struct answer *r, const struct card_request *all,
    const struct card_row *row, size_t n)
{
	FREED char *words = conditions_list_text(&all->list);
	if (all->list.n > 0) {
		answer_note(r,
		    all->of_goal ? N_("limits: %s, the goal that is set; 'set "
				      "goal none' leaves them out")
				 : N_("limits: %s"),
		    words);
		warn_if_limits_never_met(r, all->question->entry->site, row, n);
		answer_note_on_column(r, tr("met in 100"),
		    "met in 100: how many times in 100 all limits are met at "
		    "that speed");
	}
	conditions_note_source_of_limits(r, &all->list);
}

/* Explains the range, and how far a belt cut may lie from the figure. */
static void
note_meaning_of_band(
    struct answer *r, const struct card_request *all, double cut)
{
	const struct quantity *of = &all->q[all->ranged];
	double level = 100 * all->question->level;
	int digits = quantities_decimals(of);
	double step = pow(10, -digits);
	FREED char *range = band_column_heading(all);
	FREED char *figure = card_heading_of_quantity(all, of);
	answer_note_on_column(r, range,
	    "%s: of the figure to its left; the true value lies within it with "
	    "%.0f %% probability",
	    range, level);
	FREED char *words = quantities_name(of);
	if (isfinite(cut))
		answer_note_on_column(r, figure,
		    "%s: a new belt cut may show up to %.*f%s more or less "
		    "than that figure, in %.0f %% of all cuts",
		    words, digits, step * ceil(cut / step),
		    quantities_difference_suffix(of), level);
}

static void
note_meaning_of_measured_column(
    struct answer *r, const struct card_request *all, double moved)
{
	const double SHOWN = 5e-4; /* changes a tenth of a point */
	FREED char *of = quantities_name(&all->q[all->ranged]);
	answer_note_on_column(r, tr("measured"),
	    moved > SHOWN
		? N_("measured: %s of the sample taken at that speed, moved to "
		     "the feed of this card, by up to %.1f points")
		: N_("measured: %s of the sample taken at that speed"),
	    of, 100 * moved);
}

/* Explains those words of the column "trust" that occur.  feed: the note on the
 * feed, or NULL; if it names the measured speeds, they are not repeated. */
static void
note_meaning_of_trust_words(struct answer *r, const struct site *site,
    const char *feed, const struct card_row *row, size_t n)
{
	bool occurs[] = {
	    [LIGHT_GREEN] = false, [LIGHT_AMBER] = false, [LIGHT_RED] = false};
	bool beyond = false;
	for (size_t i = 0; i < n; i++) {
		occurs[row[i].light] = true;
		beyond = beyond || row[i].beyond;
	}
	FREED char *speeds =
	    session_speeds_of_runs_text(site, ", ", NULL, true);
	FREED char *rpm = session_rpm_of_runs_in_brackets(site, NULL, true);
	bool named = feed != NULL && strstr(feed, speeds) != NULL;
	FREED char *words =
	    occurs[LIGHT_GREEN] && named
		? xstrdup(tr("green: confirmed by measurements"))
		: xasprintf(occurs[LIGHT_GREEN]
				? tr("green: confirmed by measurements at %s "
				     "m/s%s")
				: tr("measured at %s m/s%s"),
		      speeds, rpm);
	if (occurs[LIGHT_AMBER])
		xappend(
		    &words, tr("; amber: from the model alone, or doubtful"));
	if (occurs[LIGHT_RED])
		xappend(&words, tr("; red: do not rely on it"));
	if (beyond)
		xappend(&words, tr("; ?: beyond the measured speeds"));
	answer_note(r,
	    "trust says how far to rely on the figures, not whether they meet "
	    "limits; %s",
	    words);
}

/* Notes what the figures mean, the machine, and the model and data behind
 * them. */
static void
note_basis_of_card(struct answer *r, const struct session *s,
    const struct card_request *all, const struct card_table *page,
    const struct card_row *row, size_t n)
{
	const struct question *q = all->question;
	const struct site *site = q->entry->site;
	FREED char *feed = feed_sampling_text(site, q->feed);
	bool fines = false;
	for (size_t i = 0; i < all->n; i++)
		fines = fines || (all->q[i].kind == QUANTITY_PASSING &&
				     all->q[i].letter != 0);
	answer_note(r, "P20, P50, P80 in mm, passing in %%%s%s",
	    fines ? tr(", fines under 0.063 mm") : "",
	    all->plant.circuit != NULL ? tr(", fractions in t/h") : "");
	if (fraction_is_screened(&q->fraction)) {
		FREED char *cut = quantities_fraction_text(&q->fraction);
		answer_note(r, "all of these refer to the fraction %s", cut);
	}
	if (page->ranged)
		note_meaning_of_band(r, all, page->cut);
	if (page->measured)
		note_meaning_of_measured_column(r, all, page->moved);
	if (site->machine[0] != '\0')
		answer_note(r, "machine: %s", site->machine);
	answer_note(r, "equations: %s, %s; %s",
	    breakage_model_of_params(&q->entry->params)->source,
	    origin_of_params_text(q->entry), correction_in_words(s, q->entry));
	if (feed == NULL)
		answer_note(r, "feed: %s",
		    site->feed_from[0] != '\0' ? site->feed_from
					       : tr("as sampled"));
	note_meaning_of_trust_words(r, site, feed, row, n);
}

/* If no row is green, gives the reasons for the best light, preferably one at a
 * measured speed.  Programs get the worst light. */
static void
note_reasons_for_best_trust(struct answer *r, const struct session *s,
    const struct question *q, const struct card_row *row, size_t n,
    struct trust *worst)
{
	size_t best = 0;
	for (size_t i = 1; i < n; i++) {
		bool alike = row[i].light == row[best].light;
		if (row[i].light < row[best].light ||
		    (alike && !row[i].beyond && row[best].beyond))
			best = i;
	}
	answers_note_basis_without_trust(s, r, q, 0, NULL, worst);
	if (n > 0 && row[best].light != LIGHT_GREEN) {
		FREED char *said = trust_in_words_at_speed(
		    s, q->entry, row[best].speed, q->feed);
		answer_add_sentence(r,
		    row[best].light == LIGHT_RED ? ANSWER_WARNING
						 : ANSWER_REMARK,
		    "%s", said);
	}
	trust_put_fields(answer_json_fields(r), worst);
	trust_free(worst);
}

static struct answer *
build_card_answer(
    struct session *s, struct card_request *all, const double *speed, size_t n)
{
	const struct entry *entry = all->question->entry;
	FREED char *today = datetime_today_text();
	struct answer *r =
	    answer_new_about_site(entry->site, "card", "card of %s", today);
	set_card_title(r, entry->site, today);
	struct trust light = trust_in_answer_or_fit(s, entry, NULL);
	FREED struct card_row *row = xcalloc(n, sizeof *row);
	struct card_table page = {.answer = r, .cut = NAN};
	for (size_t i = 0; i < n; i++)
		page.measured =
		    page.measured || !isnan(measured_card_value_at_speed(
					 s, all, speed[i], &page.moved));
	for (size_t i = 0; i < n; i++) {
		row[i] = (struct card_row){.speed = speed[i], .share = NAN};
		put_card_row(&page, s, all, &row[i], &light);
		n = session_is_interrupted(s) ? i + 1 : n;
	}
	fields_put_values(answer_json_fields(r), "date %s machine %s model %s",
	    today, entry->site->machine,
	    breakage_model_of_params(&entry->params)->name);
	answer_begin_table_for_programs(r);
	answer_add_rows_as_json_objects(r, "rows");
	answer_resume_table_for_people(r);
	note_limits_of_card(r, all, row, n);
	note_plant_and_power(r, all);
	note_basis_of_card(r, s, all, &page, row, n);
	note_reasons_for_best_trust(r, s, all->question, row, n, &light);
	return r;
}

bool
cmd_card(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct card_request all = {.question = q};
	question_add_measured_speeds_to_range(q);
	question_use_default_speeds(s, q, true);
	bool ok = parse_card_request(s, &all, args, q->at[q->n_at - 1], error);
	if (ok && s->document != NULL)
		s->document->one_page = true;
	if (ok && s->document != NULL && all.of_goal)
		session_print_note(s,
		    "the card has the limits of the goal that is set; 'set "
		    "goal none' leaves them out");
	if (ok)
		session_show_answer(
		    s, build_card_answer(s, &all, q->at, q->n_at));
	card_request_free(&all);
	return ok;
}
