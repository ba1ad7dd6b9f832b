/* Fills the panel with blocks in order of importance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/panel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/draw/site_chart.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/quantity_words.h"
#include "io/sitefile/units.h"
#include "tui/widgets/envelope_check.h"
#include "tui/pane.h"
#include "tui/widgets/readout.h"
#include "tui/screen.h"
#include "tui/widgets/sieve_table.h"
#include "tui/cmdline.h"
#include "tui/folder.h"

/* Columns of a row of numbers: after the name come value, unit and, on a wide
 * panel, the band; the change is at the right. */
enum { VALUE = 5, UNIT = 12, BAND = 16, CHANGE_COLUMNS = 7, WIDE = 34 };

/* The rows that a block takes.  With fewer than `least` it is left out. */
struct wish {
	int least, most;
};

static bool
has_pinned_prediction(const struct tui *t)
{
	return t->view.pinned.site[0] != '\0';
}

/* Returns the numbers with which changes are computed, or NULL. */
static const struct numbers *
reference_numbers_for_changes(const struct tui *t)
{
	return has_pinned_prediction(t)            ? &t->view.pinned
	       : t->view.reference.site[0] != '\0' ? &t->view.reference
						   : NULL;
}

/* Returns true if a change is not shown as 0. */
static bool
is_change_visible(double change, int digits)
{
	return fabs(change) >= 0.5 * pow(10, -digits);
}

/* Draws the change, "-0.03", unless it would be shown as 0. */
static void
draw_number_change(
    const struct area *area, int row, double now, double was, int digits)
{
	if (isfinite(now) && isfinite(was) &&
	    is_change_visible(now - was, digits))
		screen_draw_text(area, row, area->columns - CHANGE_COLUMNS, 0,
		    "%+*.*f", CHANGE_COLUMNS, digits, now - was);
}

/* Draws a band, "5.29..5.44", on a wide panel.  On others, draws half its width
 * after the number, with the unit: "5.36\u00b10.08" or "5.36+-0.08".  Draws
 * nothing if there is no band. */
static void
draw_band_after_number(const struct area *area, int row, double low,
    double high, int digits, const char *unit)
{
	const double long_number = 100;
	if (!isfinite(low) || !isfinite(high))
		return;
	if (area->columns < WIDE) {
		bool ascii = screen_charset() == CHARSET_ASCII;
		if (high < long_number)
			screen_draw_text(area, row, UNIT - 1, LOOK_DIM,
			    "%s%.*f%s", ascii ? "+-" : "\u00b1", digits,
			    (high - low) / 2, unit + (ascii && unit[0] == ' '));
		return;
	}
	screen_draw_text(area, row, BAND, LOOK_DIM, "%.*f..%.*f",
	    high < long_number ? digits : 0, low,
	    high < long_number ? digits : 0, high);
}

static void
draw_size_or_why_none(
    const struct area *area, int row, unsigned look, double mm)
{
	char text[24];
	if (!isfinite(mm) || mm < 1000 * ANSWERS_NO_SIZE)
		screen_draw_text(area, row, VALUE + 1, look, "%s",
		    readout_size_or_reason_text(mm, text));
	else
		screen_draw_text(area, row, VALUE, look, "%6.2f mm", mm);
}

/* The speed, and the one that it is compared with. */
static struct wish
speed_rows_wanted(struct tui *t)
{
	bool other = has_pinned_prediction(t) &&
		     strcmp(t->view.pinned.site, t->view.current.site) != 0;
	return (struct wish){1, other ? 2 : 1};
}

/* Returns true if the sizes have changed: perhaps the site was calibrated
 * again. */
static bool
are_product_sizes_changed(const struct numbers *now, const struct numbers *was)
{
	bool changed = false;
	for (int i = 0; i < PSD_SIZES; i++)
		changed |= isfinite(was->size[i]) &&
			   is_change_visible(now->size[i] - was->size[i], 2);
	return changed;
}

/* Draws the speeds in the unit of the sheet, but in m/s if the pinned
 * prediction is of another site. */
static void
panel_draw_speed(struct tui *t, const struct area *area)
{
	const struct numbers *now = &t->view.current,
			     *was = reference_numbers_for_changes(t);
	bool other =
	    has_pinned_prediction(t) && strcmp(was->site, now->site) != 0;
	const struct site *site =
	    other ? NULL : tui_current_site_entry(t)->site;
	int decimals = answers_is_sheet_in_rpm(site) ? 0 : 1;
	FREED char *speed = answers_speed_text(site, now->speed, 1);
	enum { FROM = 10 };
	screen_draw_text(area, 0, 0, LOOK_BOLD, "%s", speed);
	if (has_pinned_prediction(t))
		screen_draw_text(area, 0, FROM, LOOK_DIM, "vs pinned %.*f",
		    decimals, answers_speed_in_sheet_unit(site, was->speed));
	else if (was != NULL && was->speed != now->speed)
		screen_draw_text(area, 0, FROM, LOOK_DIM, "vs %.*f", decimals,
		    answers_speed_in_sheet_unit(site, was->speed));
	else if (was != NULL && are_product_sizes_changed(now, was))
		screen_draw_text(area, 0, FROM, LOOK_DIM, "vs last answer");
	if (area->rows > 1)
		screen_draw_text(
		    area, 1, 0, LOOK_DIM, "pinned: %s", t->view.pinned.site);
}

/* Puts the crosshair at the size that was clicked, and at its passing. */
static void
on_click_size(struct tui *t, const struct mouse_event *touched)
{
	const struct psd *product = &t->view.shown.product;
	t->ui.crosshair_passing = (int)lround(100 * PSD_PASSING[touched->item]);
	double mm = t->view.shown.size[touched->item];
	t->ui.crosshair = true;
	t->ui.crosshair_sieve = 0;
	while (isfinite(mm) && t->ui.crosshair_sieve + 1 < product->n &&
	       product->size[t->ui.crosshair_sieve + 1] >= mm)
		t->ui.crosshair_sieve++;
}

static void
draw_p_sizes(struct tui *t, const struct area *area)
{
	const struct numbers *was = reference_numbers_for_changes(t);
	for (int i = 0; i < PSD_SIZES; i++) {
		const double *range = t->view.shown.range[i];
		screen_draw_text(area, i, 0, LOOK_BOLD, "%s", PSD_NAME[i]);
		draw_size_or_why_none(
		    area, i, LOOK_BOLD, t->view.current.size[i]);
		draw_band_after_number(
		    area, i, 1000 * range[0], 1000 * range[1], 2, "");
		if (was != NULL)
			draw_number_change(
			    area, i, t->view.current.size[i], was->size[i], 2);
		hits_add_mouse_handler(&t->hits, HIT_PRESS,
		    area_of_row(area, i), on_click_size, (size_t)i);
	}
}

static void
draw_break_size(struct tui *t, const struct area *area)
{
	const struct numbers *was = reference_numbers_for_changes(t);
	const double *range = t->view.shown.range[ANSWERS_BREAK];
	screen_draw_text(area, 0, 0, 0, "%s", tr("break"));
	draw_size_or_why_none(area, 0, LOOK_PLAIN, t->view.current.break_mm);
	/* The band comes from the draws.  If it does not include the value of
	 * the fit, it would be taken for an error. */
	double mm = t->view.current.break_mm;
	bool within = 1000 * range[0] <= mm && mm <= 1000 * range[1];
	if (area->columns >= WIDE && within)
		draw_band_after_number(
		    area, 0, 1000 * range[0], 1000 * range[1], 2, "");
	if (was != NULL)
		draw_number_change(
		    area, 0, t->view.current.break_mm, was->break_mm, 2);
	if (area->rows > 1)
		screen_draw_text(area, 1, 0, 0,
		    area->columns < WIDE
			? N_("%4.0f J/kg: %.0f %% broken")
			: N_("%4.0f J/kg: %.0f %% of the feed breaks"),
		    t->view.shown.energy, 100 * t->view.shown.selected);
}

static struct wish
passing_rows_wanted(struct tui *t)
{
	int n = 0;
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++)
		n += !isnan(t->view.current.passing[i]);
	return (struct wish){n, n};
}

/* Puts the crosshair on the sieve of a fraction, or on the next finer one. */
static void
on_click_passing_number(struct tui *t, const struct mouse_event *touched)
{
	const struct psd *product = &t->view.shown.product;
	const double near = 1.0001;
	t->ui.crosshair = true;
	t->ui.crosshair_sieve = 0;
	while (t->ui.crosshair_sieve + 1 < product->n &&
	       product->size[t->ui.crosshair_sieve] >
		   near * NUMBERS_SIEVE[touched->item])
		t->ui.crosshair_sieve++;
}

/* Draws a row for each passing, from `row` on.  all: the number that stands for
 * 100 % in that unit. */
static void
draw_passing_rows(struct tui *t, const struct area *area, int row, double all,
    const char *unit)
{
	static const char *const NAME[] = {N_("fines "), "<2 mm", "<4 mm"};
	const struct numbers *was = reference_numbers_for_changes(t);
	const struct prediction *shown = &t->view.shown;
	struct psd low = shown->product, high = shown->product;
	low.passing = shown->low;
	high.passing = shown->high;
	for (size_t i = 0; i < NUMBERS_FRACTIONS && row < area->rows; i++) {
		double now = t->view.current.passing[i], part = all / 100;
		if (isnan(now))
			continue;
		screen_draw_text(area, row, 0, 0, "%s", tr(NAME[i]));
		screen_draw_text(
		    area, row, VALUE + 1, 0, "%5.1f %s", now * part, unit);
		if (shown->low != NULL)
			draw_band_after_number(area, row,
			    all * psd_passing(&low, NUMBERS_SIEVE[i]),
			    all * psd_passing(&high, NUMBERS_SIEVE[i]), 1,
			    unit[0] == '%' ? " %" : "    ");
		if (was != NULL)
			draw_number_change(
			    area, row, now * part, was->passing[i] * part, 1);
		hits_add_mouse_handler(&t->hits, HIT_PRESS,
		    area_of_row(area, row), on_click_passing_number, i);
		row++;
	}
}

static void
draw_passing_percents(struct tui *t, const struct area *area)
{
	draw_passing_rows(t, area, 0, 100, "%");
}

/* Returns the feed of the newest answer of flow, t/h, or NAN if that was about
 * another site.  Sets *back to the t/h that return to the crusher or bypass it,
 * which are not a share of the product. */
static double
newest_flow_feed_tph(const struct tui *t, double *back)
{
	const struct session *s = t->session;
	const struct answer *flow = NULL;
	for (size_t i = s->n_answer; i-- > 0 && flow == NULL;)
		if (strcmp(answer_command_name(s->answer[i]), "flow") == 0)
			flow = s->answer[i];
	*back = NAN;
	if (flow == NULL || strcmp(answer_view(flow).site,
				tui_current_site_entry(t)->site->name) != 0)
		return NAN;
	*back = answer_find_json_number(flow, "circulating_tph") +
		fmax(answer_find_json_number(flow, "crushers.cascade_tph"), 0);
	return answer_find_json_number(flow, "feed_tph");
}

static struct wish
tonnes_rows_wanted(struct tui *t)
{
	double back, tph = newest_flow_feed_tph(t, &back);
	int n = isnan(tph) ? 0 : back > 0 ? 2 : 1 + passing_rows_wanted(t).most;
	return (struct wish){n, n};
}

static void
draw_tonnes_per_hour(struct tui *t, const struct area *area)
{
	double back, tph = newest_flow_feed_tph(t, &back);
	if (back > 0) {
		screen_draw_text(
		    area, 0, 0, 0, "%.6g t/h, %.1f go back", tph, back);
		screen_draw_text(
		    area, 1, 0, LOOK_DIM, "for this speed type :flow");
		return;
	}
	screen_draw_text(area, 0, 0, LOOK_DIM, "of %.6g t/h", tph);
	draw_passing_rows(t, area, 1, tph, "t/h");
}

/* Wants a heading with the verdict and a row for each limit; with less room,
 * the limits with the smallest margins are shown. */
static struct wish
screen_rows_wanted_for_limits(struct tui *t)
{
	const struct grading *g = envelope_check_at_slider(t);
	if (t->session->spec == NULL)
		return (struct wish){0, 0};
	return (struct wish){2, g == NULL ? 2 : 1 + (int)g->limits.n};
}

/* Writes the name of a limit's quantity in few letters. */
static void
short_quantity_name(const struct quantity *q, char *name, size_t size)
{
	FREED char *typed = quantities_text_to_type(q);
	if (q->kind == QUANTITY_PASSING)
		snprintf(name, size, "%g", units_m_to_mm(q->x));
	else
		snprintf(name, size, "%s",
		    q->kind == QUANTITY_MODULUS ? "FM" : typed);
}

/* Draws limit i, the value at the slider's speed, and whether it is within the
 * limit. */
static void
panel_draw_envelope_limit(
    const struct area *area, int row, const struct grading *g, size_t i)
{
	const struct condition *c = &g->limits.at[i];
	struct quantity q = c->quantity;
	char name[16], limits[32] = "";
	double least = quantities_value_in_shown_unit(&q, c->least),
	       most = quantities_value_in_shown_unit(&q, c->most);
	bool in = conditions_are_met(&g->conditions, i);
	short_quantity_name(&q, name, sizeof name);
	if (isnan(most))
		snprintf(limits, sizeof limits, ">= %g", least);
	else if (isnan(least))
		snprintf(limits, sizeof limits, "<= %g", most);
	else
		snprintf(limits, sizeof limits, "%g..%g", least, most);
	screen_draw_text(area, row, 0, in ? LOOK_PLAIN : LOOK_BOLD, "%s", name);
	screen_draw_text(area, row, VALUE, 0, "%6.*f", quantities_decimals(&q),
	    forecast_value_in_shown_unit(g->conditions.forecast, i).value);
	if (!isnan(least) || !isnan(most))
		screen_draw_text(area, row, UNIT, LOOK_DIM, "%s", limits);
	screen_draw_text(area, row, area->columns - 3,
	    in ? LOOK_PLAIN : LOOK_BOLD, in ? N_(" in") : N_("OUT"));
}

/* Returns the rank of limit i among margins [n], 0 for the smallest. */
static size_t
rank_of_limit_by_margin(const double *margin, size_t n, size_t i)
{
	size_t place = 0;
	for (size_t k = 0; k < n; k++)
		place += margin[k] < margin[i] ||
			 (k < i && !(margin[i] < margin[k]));
	return place;
}

/* Explains the light or the limits that were clicked. */
static void
on_click_verdict(struct tui *t, const struct mouse_event *touched)
{
	cmdline_run_line(t, touched->item == 0 ? "why" : "spec");
}

static void
panel_draw_envelope_limits(struct tui *t, const struct area *area)
{
	const struct grading *g = envelope_check_at_slider(t);
	struct area name = *area;
	name.columns -= 4;
	hits_add_mouse_handler(&t->hits, HIT_PRESS, *area, on_click_verdict, 1);
	/* With the fraction, if it fits. */
	FREED char *words = session_envelope_size_fraction_text(t->session);
	xappend_to_list(&words, " ", "%s", t->session->spec->name);
	bool fits = text_width_in_columns(words) <= name.columns;
	screen_draw_text(
	    &name, 0, 0, LOOK_DIM, "%s", fits ? words : t->session->spec->name);
	if (g == NULL) {
		screen_draw_text(area, 1, 0, 0,
		    session_is_calibrating(t->session)
			? N_("after the calibration")
			: N_("not on the feed's sieves"));
		return;
	}
	bool in = conditions_are_met(&g->conditions, SIZE_MAX);
	screen_draw_text(area, 0, area->columns - 3,
	    in ? LOOK_BOLD : LOOK_REVERSE, in ? N_(" in") : N_("OUT"));
	int row = 1;
	size_t n = g->limits.n;
	FREED double *margin = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		margin[i] = condition_margin(&g->conditions, i).passing;
	for (size_t i = 0; i < n; i++)
		if ((int)rank_of_limit_by_margin(margin, n, i) < area->rows - 1)
			panel_draw_envelope_limit(area, row++, g, i);
}

static struct wish
readout_rows_wanted(struct tui *t)
{
	enum { LEAST = 3 };
	int n = readout_count_rows(t);
	return (struct wish){n < LEAST ? n : LEAST, n};
}

/* Wants at least five rows: fewer sieves do not show a curve. */
static struct wish
sieve_rows_wanted(struct tui *t)
{
	enum { LEAST = 5 };
	int n = sieve_table_count_rows(t);
	return (struct wish){n < LEAST ? n : LEAST, n};
}

/* Returns the reason to show, or NULL if there is none: a speed beyond the
 * measured ones if that is one of them, else the first. */
static const struct trust_reason *
trust_reason_to_show(const struct trust *light)
{
	size_t first = 0;
	for (size_t i = light->n; i-- > 0;)
		if (light->reason[i].cause == TRUST_BEYOND)
			first = i;
	return light->n > 0 ? &light->reason[first] : NULL;
}

/* Returns the light of the prediction shown, which is computed once. */
static const struct trust *
light_of_shown_prediction(struct tui *t)
{
	struct view *v = &t->view;
	if (!v->light_known) {
		trust_free(&v->light);
		v->light = trust_in_answer_or_fit(
		    t->session, tui_site_entry_for_prediction(t), &v->shown);
		v->light_known = true;
	}
	return &v->light;
}

/* Wants as many rows with a reason as without, because otherwise the numbers
 * below would move when the speed changes.  Only a red light shows its whole
 * reason. */
static struct wish
trust_light_rows_wanted(struct tui *t)
{
	enum { TALL = 30, MANY = 4, FEW = 2 };
	const struct area *side = &t->layout.side;
	const struct trust *light = light_of_shown_prediction(t);
	const struct trust_reason *reason = trust_reason_to_show(light);
	if (light->light == LIGHT_RED && reason != NULL)
		return (struct wish){
		    MANY, 1 + text_count_rows(reason->text, side->columns)};
	return (struct wish){1, side->rows > TALL ? MANY : FEW};
}

/* What a reason is about, in a few words. */
static const char *const ABOUT[] = {[TRUST_FIT] = N_("doubtful fit"),
    [TRUST_DATA] = N_("few or doubtful data"),
    [TRUST_PATTERN] = N_("residuals have a pattern"),
    [TRUST_HOLDOUT] = N_("held-out run is missed"),
    [TRUST_BEYOND] = N_("beyond measured speeds"),
    [TRUST_SLOW] = N_("slower, less may break"),
    [TRUST_BAND] = N_("the band is wide"),
    [TRUST_FEED] = N_("unusual feed"),
    [TRUST_BOUND] = N_("a parameter at its bound"),
    [TRUST_MACHINE] = N_("another machine"),
    [TRUST_ORIGIN] = N_("not calibrated here")};

/* Draws as much of a reason as there is room for: all of it, what stands before
 * its colon, or its cause in a few words.  Returns false for a few words. */
static bool
draw_trust_reason(const struct area *area, const struct trust_reason *reason)
{
	const int rows = area->rows - 1;
	FREED char *text = xstrdup(reason->text);
	char *colon = strchr(text, ':');
	if (text_count_rows(text, area->columns) > rows && colon != NULL)
		*colon = '\0';
	bool fits = text_count_rows(text, area->columns) <= rows;
	screen_draw_wrapped(area, 1, 0, fits ? text : tr(ABOUT[reason->cause]));
	return fits;
}

static void
draw_fit_quality(const struct tui *t, const struct area *area)
{
	double fit = 100 * tui_current_site_entry(t)->fit.rmse,
	       held = t->view.holdout;
	int decimals = fit < 10 && held < 10 ? 2 : 1;
	if (!isfinite(held))
		screen_draw_text(area, 1, 0, 0, "fit %.2f points", fit);
	else
		screen_draw_text(area, 1, 0, 0,
		    area->columns < WIDE ? N_("fit %.*f, held out %.*f")
					 : N_("fit %.*f, held out %.*f points"),
		    decimals, fit, decimals, held);
}

/* Draws the light in reverse, because everything else depends on it, and below
 * it the first reason or, without one, how good the fit is. */
static void
panel_draw_light(struct tui *t, const struct area *area)
{
	static const enum series SERIES[] = {
	    SERIES_GREEN, SERIES_AMBER, SERIES_RED};
	const struct trust *light = light_of_shown_prediction(t);
	FREED char *words =
	    xasprintf(tr("trust %s"), tr(LIGHT_NAME[light->light]));
	if (light->n > 0 && area->columns >= WIDE)
		xappend(&words,
		    tr_n(", %zu reason, see :why", ", %zu reasons, see :why",
			light->n),
		    light->n);
	else if (light->n > 0)
		xappend(&words, tr_n(", see :why", ", :why has %zu", light->n),
		    light->n);
	FREED char *row = xasprintf(
	    "%s%*s", words, area->columns - text_width_in_columns(words), "");
	screen_draw_text_in_series_colour(
	    area, 0, 0, SERIES[light->light], LOOK_BOLD | LOOK_REVERSE, row);
	hits_add_mouse_handler(&t->hits, HIT_PRESS, *area, on_click_verdict, 0);
	if (light->n > 0)
		t->reason_shown =
		    draw_trust_reason(area, trust_reason_to_show(light));
	else if (tui_current_site_entry(t)->has_fit)
		draw_fit_quality(t, area);
}

/* The blocks of the panel, from the top down.  rank: the order in which blocks
 * get their least rows, and then what they want beyond that.  apart: has a
 * blank row above it if one is left.  wish: returns the rows wanted; if NULL,
 * `always` has them. */
enum { BLOCKS = 9 };
static const struct block {
	int rank;
	bool apart;
	void (*draw)(struct tui *t, const struct area *area);
	struct wish (*wish)(struct tui *t);
	struct wish always;
} BLOCK[BLOCKS] = {
    {1, false, panel_draw_light, .wish = trust_light_rows_wanted},
    {2, true, panel_draw_speed, .wish = speed_rows_wanted},
    {0, false, draw_p_sizes, .always = {PSD_SIZES, PSD_SIZES}},
    {5, false, draw_break_size, .always = {1, 2}},
    {6, false, draw_passing_percents, .wish = passing_rows_wanted},
    {4, true, panel_draw_envelope_limits,
	.wish = screen_rows_wanted_for_limits},
    {8, true, draw_tonnes_per_hour, .wish = tonnes_rows_wanted},
    {3, true, readout_draw_at_crosshair, .wish = readout_rows_wanted},
    {7, true, sieve_table_draw, .wish = sieve_rows_wanted},
};

/* Shares `left` rows among the blocks; rows [BLOCKS] receives the rows of
 * each. */
static void
panel_distribute_rows(struct tui *t, int left, int rows[BLOCKS])
{
	struct wish wish[BLOCKS];
	size_t at[BLOCKS];
	for (size_t i = 0; i < BLOCKS; i++) {
		wish[i] =
		    BLOCK[i].wish != NULL ? BLOCK[i].wish(t) : BLOCK[i].always;
		at[BLOCK[i].rank] = i;
	}
	for (size_t r = 0; r < BLOCKS; r++) {
		int least = wish[at[r]].least;
		rows[at[r]] = least <= left ? least : 0;
		left -= rows[at[r]];
	}
	for (size_t r = 0; r < BLOCKS; r++) {
		int more = wish[at[r]].most - rows[at[r]];
		if (rows[at[r]] == 0 || more <= 0)
			continue;
		more = more < left ? more : left;
		rows[at[r]] += more;
		left -= more;
	}
}

/* Draws the blocks.  Those that stand apart have a blank row above them, as
 * long as rows are left. */
static void
panel_draw_blocks(struct tui *t)
{
	const struct area *side = &t->layout.side;
	int rows[BLOCKS], left = side->rows, row = 0;
	panel_distribute_rows(t, side->rows, rows);
	for (size_t i = 0; i < BLOCKS; i++)
		left -= rows[i];
	for (size_t i = 0; i < BLOCKS; i++) {
		if (rows[i] == 0)
			continue;
		if (BLOCK[i].apart && row > 0 && left > 0) {
			left--;
			row++;
		}
		BLOCK[i].draw(t, &(struct area){side->row + row, side->column,
				     rows[i], side->columns});
		row += rows[i];
	}
}

/* Says what to do while there is no prediction, and shows what is pinned or
 * else how the sheet was read. */
static void
draw_why_nothing_predicted(const struct tui *t)
{
	const struct area *side = &t->layout.side;
	const struct site *site = tui_current_site_entry(t)->site;
	int row = 0;
	/* The row of numbers already says it. */
	if (t->layout.numbers.rows == 0)
		screen_draw_text(side, row++, 0, 0, "nothing predicted yet");
	screen_draw_text(side, row++, 0, 0,
	    site_count_products(site) > 0 ? N_("Enter calibrates")
					  : N_("no product: type :guess"));
	row++;
	if (!has_pinned_prediction(t)) {
		FREED char *read = folder_site_summary_text(site);
		pane_draw_text_lines(side, row, read);
		return;
	}
	FREED char *speed =
	    answers_speed_text(tui_pinned_site(t), t->view.pinned.speed, 1);
	screen_draw_text(side, row++, 0, LOOK_BOLD, "pinned: %s %s", speed,
	    t->view.pinned.site);
	for (int i = 0; i < PSD_SIZES; i++) {
		screen_draw_text(
		    side, row + i, 0, 0, "P%.0f", 100 * PSD_PASSING[i]);
		draw_size_or_why_none(
		    side, row + i, LOOK_PLAIN, t->view.pinned.size[i]);
	}
}

void
panel_draw(struct tui *t)
{
	const struct area *side = &t->layout.side;
	t->reason_shown = false;
	if (side->rows == 0)
		return;
	screen_draw_vertical_rule(side->row, t->layout.wall, side->rows);
	if (t->view.current.site[0] == '\0')
		draw_why_nothing_predicted(t);
	else
		panel_draw_blocks(t);
}

/* Returns the light with its reason in the longest form that fits into
 * `columns`.  The forms are: the reason up to its last colon, up to its first
 * colon, its cause in a few words, the same with only the colour, which may
 * take `most` columns, and no reason. */
static char *
trust_light_text(const struct trust *light, int columns, int most)
{
	const char *name = tr(LIGHT_NAME[light->light]);
	const struct trust_reason *reason = trust_reason_to_show(light);
	char *words = xasprintf(tr("trust %s"), name);
	if (reason == NULL)
		return words;
	const char *about = tr(ABOUT[reason->cause]);
	const char *last = strrchr(reason->text, ':');
	int first = (int)strcspn(reason->text, ":;"),
	    all = last != NULL ? (int)(last - reason->text) : first;
	char *way[] = {xasprintf("%s: %.*s", words, all, reason->text),
	    xasprintf("%s: %.*s", words, first, reason->text),
	    xasprintf("%s: %s", words, about), xasprintf("%s: %s", name, about),
	    words};
	size_t i = 0;
	while (i + 1 < ARRAY_LEN(way) &&
	       text_width_in_columns(way[i]) > (i == 3 ? most : columns))
		i++;
	words = way[i];
	for (size_t k = 0; k < ARRAY_LEN(way); k++)
		if (k != i)
			free(way[k]);
	return words;
}

char *
panel_trust_text(struct tui *t, int columns, int most)
{
	const struct grading *g = envelope_check_at_slider(t);
	bool side = t->layout.side.rows > 0;
	if (t->ui.page != PAGE_PREDICT || t->view.current.site[0] == '\0' ||
	    (side && t->reason_shown))
		return xstrdup("");
	const struct trust *light = light_of_shown_prediction(t);
	FREED char *limits = xstrdup("");
	if (g != NULL && !side)
		xappend(&limits,
		    conditions_are_met(&g->conditions, SIZE_MAX)
			? tr(", in %s")
			: tr(", out of %s"),
		    t->session->spec->name);
	int taken = text_width_in_columns(limits);
	char *words =
	    side && light->n == 0
		? xstrdup("")
		: trust_light_text(light, columns - taken, most - taken);
	xappend(&words, "%s", limits);
	return words;
}

/* Writes a size, mm, in at most four characters, because a number that is cut
 * would be another number. */
static const char *
short_size_text(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, tr("off"));
	else if (isinf(mm))
		snprintf(text, 24, tr("none"));
	else
		snprintf(text, 24, "%.*f",
		    mm < 9.995   ? 2
		    : mm < 99.95 ? 1
				 : 0,
		    mm);
	return text;
}

void
panel_draw_row_of_numbers(struct tui *t)
{
	const struct area *area = &t->layout.numbers;
	const struct prediction *p = &t->view.shown;
	char a[24], b[24], c[24], d[24];
	/* The list of sites describes the selected site, which may be
	 * another. */
	if (area->rows == 0 ||
	    (t->ui.page == PAGE_SITES &&
		t->ui.list[PAGE_SITES].at != t->session->current))
		return;
	if (t->view.current.site[0] == '\0')
		screen_draw_text(area, 0, 0, 0,
		    area->columns < 21 ? N_("not predicted yet")
				       : N_("nothing predicted yet"));
	else if (t->ui.crosshair && t->ui.crosshair_sieve < p->product.n) {
		bool narrow = area->columns < 34, least = area->columns < 24;
		double mm = 1000 * psd_size_at_passing(&p->curve,
				       t->ui.crosshair_passing / 100.0);
		screen_draw_text(area, 0, 0, LOOK_BOLD,
		    least    ? "%g %.1f%% P%d %s"
		    : narrow ? N_("%g %.1f %% P%d %s mm")
			     : N_("%g mm %.1f %%  %d %% %s"),
		    units_m_to_mm(p->product.size[t->ui.crosshair_sieve]),
		    100 * p->product.passing[t->ui.crosshair_sieve],
		    t->ui.crosshair_passing,
		    narrow ? short_size_text(mm, a)
			   : readout_size_or_reason_text(mm, a));
	} else if (area->columns < 34)
		screen_draw_text(area, 0, 0, LOOK_BOLD, "P50 %s P80 %s mm",
		    short_size_text(t->view.current.size[1], b),
		    short_size_text(t->view.current.size[2], c));
	else if (area->columns < 60)
		screen_draw_text(area, 0, 0, LOOK_BOLD,
		    "P20 %s P50 %s P80 %s mm",
		    short_size_text(t->view.current.size[0], a),
		    short_size_text(t->view.current.size[1], b),
		    short_size_text(t->view.current.size[2], c));
	else
		screen_draw_text(area, 0, 0, LOOK_BOLD,
		    "P20 %s  P50 %s  P80 %s  break size %s",
		    readout_size_or_reason_text(t->view.current.size[0], a),
		    readout_size_or_reason_text(t->view.current.size[1], b),
		    readout_size_or_reason_text(t->view.current.size[2], c),
		    readout_size_or_reason_text(t->view.current.break_mm, d));
}
