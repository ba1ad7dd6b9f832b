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
#include "cmd/ask/answers.h"
#include "cmd/ask/trust_light.h"
#include "cmd/draw/plots_limits.h"
#include "cmd/ask/quantity_words.h"
#include "io/sitefile/units.h"
#include "tui/widgets/envelope_check.h"
#include "tui/pane.h"
#include "tui/widgets/readout.h"
#include "tui/screen.h"
#include "tui/widgets/sieve_table.h"
#include "tui/cmdline.h"
#include "tui/folder.h"

/* A row of numbers: its name, then these columns; where the panel is wide a
 * band stands between value and change. */
enum { VALUE = 5, UNIT = 12, BAND = 16, CHANGE_COLUMNS = 7, WIDE = 34 };

/* What blocks are drawn from.  was: what changes are counted from, or NULL;
 * reason: the one that is shown, or NULL; tph: what is fed, t/h, NAN where that
 * is not known; back: what of it goes round, t/h. */
struct panel {
	struct tui *t;
	const struct numbers *was;
	const struct trust *light;
	const struct trust_reason *reason;
	double tph, back;
};

/* How many rows a block takes: at least, or it is left out, and where there is
 * room. */
struct wish {
	int least, most;
};

static bool
is_pinned(const struct tui *t)
{
	return t->view.pinned.site[0] != '\0';
}

/* Not 0 as shown. */
static bool
is_change_visible(double change, int digits)
{
	return fabs(change) >= 0.5 * pow(10, -digits);
}

/* "-0.03", what is now less what was; nothing where that is 0 as shown. */
static void
draw_change(
    const struct area *area, int row, double now, double was, int digits)
{
	if (isfinite(now) && isfinite(was) &&
	    is_change_visible(now - was, digits))
		screen_text(area, row, area->columns - CHANGE_COLUMNS, 0,
		    "%+*.*f", CHANGE_COLUMNS, digits, now - was);
}

/* "5.29..5.44" where the panel is wide, else half of that behind the number,
 * "5.36\u00b10.08", with that unit; nothing without a band. */
static void
draw_range(const struct area *area, int row, double low, double high,
    int digits, const char *unit)
{
	const double long_number = 100;
	if (!isfinite(low) || !isfinite(high))
		return;
	if (area->columns < WIDE) {
		if (screen_charset() != CHARSET_ASCII && high < long_number)
			screen_text(area, row, UNIT - 1, LOOK_DIM,
			    "\u00b1%.*f%s", digits, (high - low) / 2, unit);
		return;
	}
	screen_text(area, row, BAND, LOOK_DIM, "%.*f..%.*f",
	    high < long_number ? digits : 0, low,
	    high < long_number ? digits : 0, high);
}

/* Draws a size or why there is none. */
static void
draw_size(const struct area *area, int row, unsigned look, double mm)
{
	char text[24];
	if (!isfinite(mm) || mm < 1000 * ANSWERS_NO_SIZE)
		screen_text(
		    area, row, VALUE + 1, look, "%s", readout_size(mm, text));
	else
		screen_text(area, row, VALUE, look, "%6.2f mm", mm);
}

/* The speed, and what changes are counted from. */
static struct wish
speed_wish(const struct panel *p)
{
	const struct tui *t = p->t;
	bool other = is_pinned(t) &&
		     strcmp(t->view.pinned.site, t->view.current.site) != 0;
	return (struct wish){1, other ? 2 : 1};
}

/* At the same speed: by another calibration, say. */
static bool
is_changed(const struct panel *p)
{
	bool changed = false;
	for (int i = 0; i < PSD_SIZES && p->was != NULL; i++)
		changed |= isfinite(p->was->size[i]) &&
			   is_change_visible(
			       p->t->view.current.size[i] - p->was->size[i], 2);
	return changed;
}

static void
panel_draw_speed(struct panel *p, const struct area *area)
{
	const struct tui *t = p->t;
	const bool since =
	    p->was != NULL && p->was->speed != t->view.current.speed;
	enum { FROM = 10 };
	screen_text(area, 0, 0, LOOK_BOLD, "%.1f m/s", t->view.current.speed);
	if (is_pinned(t))
		screen_text(area, 0, FROM, LOOK_DIM, "vs pinned %.1f",
		    t->view.pinned.speed);
	else if (since)
		screen_text(
		    area, 0, FROM, LOOK_DIM, "since %.1f", p->was->speed);
	else if (is_changed(p))
		screen_text(area, 0, FROM, LOOK_DIM, "vs last answer");
	if (area->rows > 1)
		screen_text(
		    area, 1, 0, LOOK_DIM, "pinned: %s", t->view.pinned.site);
}

/* The crosshair where the curve passes so much. */
static void
touch_size(struct tui *t, const struct touched *touched)
{
	const struct psd *product = &t->view.shown.product;
	t->ui.level = (int)lround(100 * PSD_PASSING[touched->item]);
	double mm = t->view.shown.size[touched->item];
	t->ui.cross = true;
	t->ui.cross_at = 0;
	while (isfinite(mm) && t->ui.cross_at + 1 < product->n &&
	       product->size[t->ui.cross_at + 1] >= mm)
		t->ui.cross_at++;
}

static void
draw_p_sizes(struct panel *p, const struct area *area)
{
	struct tui *t = p->t;
	for (int i = 0; i < PSD_SIZES; i++) {
		const double *range = t->view.shown.range[i];
		screen_text(area, i, 0, LOOK_BOLD, "%s", PSD_NAME[i]);
		draw_size(area, i, LOOK_BOLD, t->view.current.size[i]);
		draw_range(area, i, 1000 * range[0], 1000 * range[1], 2, "");
		if (p->was != NULL)
			draw_change(area, i, t->view.current.size[i],
			    p->was->size[i], 2);
		hits_add(&t->hits, HIT_PRESS, area_row(area, i), touch_size,
		    (size_t)i);
	}
}

static void
draw_break(struct panel *p, const struct area *area)
{
	const struct tui *t = p->t;
	const double *range = t->view.shown.range[ANSWERS_BREAK];
	screen_text(area, 0, 0, 0, "%s", tr("break"));
	draw_size(area, 0, LOOK_PLAIN, t->view.current.break_mm);
	/* The draws' range need not hold the fit's value. */
	if (area->columns >= WIDE)
		draw_range(area, 0, 1000 * range[0], 1000 * range[1], 2, "");
	if (p->was != NULL)
		draw_change(
		    area, 0, t->view.current.break_mm, p->was->break_mm, 2);
	if (area->rows > 1)
		screen_text(area, 1, 0, 0,
		    area->columns < WIDE
			? N_("%4.0f J/kg: %.0f %% broken")
			: N_("%4.0f J/kg: %.0f %% of the feed breaks"),
		    t->view.shown.energy, 100 * t->view.shown.selected);
}

/* Sizes that sand is sold by, mm. */
static const double FRACTION_MM[NUMBERS_FRACTIONS] = {0.063, 2, 4};

static int
count_fractions(const struct panel *p)
{
	int n = 0;
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++)
		n += !isnan(p->t->view.current.passing[i]);
	return n;
}

static struct wish
fractions_wish(const struct panel *p)
{
	int n = count_fractions(p);
	return (struct wish){n, n};
}

/* The crosshair on the sieve, or the coarsest that is finer. */
static void
touch_fraction(struct tui *t, const struct touched *touched)
{
	const struct psd *product = &t->view.shown.product;
	const double near = 1.0001;
	t->ui.cross = true;
	t->ui.cross_at = 0;
	while (t->ui.cross_at + 1 < product->n &&
	       1000 * product->size[t->ui.cross_at] >
		   near * FRACTION_MM[touched->item])
		t->ui.cross_at++;
}

/* A row for each of them in a unit that 100 % is `all` of. */
static int
draw_passings(struct panel *p, const struct area *area, int row,
    const char *const name[NUMBERS_FRACTIONS], double all, const char *unit)
{
	struct tui *t = p->t;
	const struct prediction *shown = &t->view.shown;
	struct psd low = shown->product, high = shown->product;
	low.passing = shown->low;
	high.passing = shown->high;
	for (size_t i = 0; i < NUMBERS_FRACTIONS && row < area->rows; i++) {
		double now = t->view.current.passing[i], part = all / 100;
		if (isnan(now))
			continue;
		screen_text(area, row, 0, 0, "%s", name[i]);
		screen_text(
		    area, row, VALUE + 1, 0, "%5.1f %s", now * part, unit);
		if (shown->low != NULL)
			draw_range(area, row,
			    all * psd_passing(&low, FRACTION_MM[i] / 1000),
			    all * psd_passing(&high, FRACTION_MM[i] / 1000), 1,
			    unit[0] == '%' ? " %" : "    ");
		if (p->was != NULL)
			draw_change(area, row, now * part,
			    p->was->passing[i] * part, 1);
		hits_add(&t->hits, HIT_PRESS, area_row(area, row),
		    touch_fraction, i);
		row++;
	}
	return row;
}

static void
draw_fractions(struct panel *p, const struct area *area)
{
	static const char *const NAME[] = {"fines", "0/2", "0/4"};
	draw_passings(p, area, 0, NAME, 100, "%");
}

/* What the last flow was fed with: a share of that is a product's where all of
 * it goes through the crusher once. */
static struct wish
tonnes_wish(const struct panel *p)
{
	int n = isnan(p->tph) ? 0 : p->back > 0 ? 2 : 1 + count_fractions(p);
	return (struct wish){n, n};
}

static void
draw_tonnes(struct panel *p, const struct area *area)
{
	static const char *const NAME[] = {"fines", "0/2", "0/4"};
	if (p->back > 0) {
		screen_text(
		    area, 0, 0, 0, "%.6g t/h, %.1f go back", p->tph, p->back);
		screen_text(area, 1, 0, LOOK_DIM, "at this speed: :flow");
		return;
	}
	screen_text(area, 0, 0, LOOK_DIM, "of %.6g t/h", p->tph);
	draw_passings(p, area, 1, NAME, p->tph, "t/h");
}

/* The heading says the verdict; a row each, or as many of the worst as there is
 * room for. */
static struct wish
limits_wish(const struct panel *p)
{
	const struct grading *g = envelope_check_now(p->t);
	if (p->t->session->spec == NULL)
		return (struct wish){0, 0};
	return (struct wish){2, g == NULL ? 2 : 1 + (int)g->limits.n};
}

/* What a limit is of, as short as there is room for. */
static void
panel_name_quantity(const struct quantity *q, char *name, size_t size)
{
	FREED char *typed = quantities_as_typed(q);
	if (q->kind == QUANTITY_PASSING)
		snprintf(name, size, "%g", units_mm(q->x));
	else
		snprintf(name, size, "%s",
		    q->kind == QUANTITY_MODULUS ? "FM" : typed);
}

/* Limit i at the slider's speed: in, or by how much it is missed. */
static void
panel_draw_limit(
    const struct area *area, int row, const struct grading *g, size_t i)
{
	const struct condition *c = &g->limits.at[i];
	struct quantity q = c->quantity;
	char name[16], limits[32] = "";
	double least = quantities_shown(&q, c->least),
	       most = quantities_shown(&q, c->most);
	bool in = wanted_holds(&g->conditions, i);
	panel_name_quantity(&q, name, sizeof name);
	if (isnan(most))
		snprintf(limits, sizeof limits, ">= %g", least);
	else if (isnan(least))
		snprintf(limits, sizeof limits, "<= %g", most);
	else
		snprintf(limits, sizeof limits, "%g..%g", least, most);
	screen_text(area, row, 0, in ? LOOK_PLAIN : LOOK_BOLD, "%s", name);
	screen_text(area, row, VALUE, 0, "%6.*f", quantities_decimals(&q),
	    forecast_shown(g->conditions.forecast, i).value);
	if (!isnan(least) || !isnan(most))
		screen_text(area, row, UNIT, LOOK_DIM, "%s", limits);
	screen_text(area, row, area->columns - 3, in ? LOOK_PLAIN : LOOK_BOLD,
	    in ? N_(" in") : N_("OUT"));
}

/* Where limit i stands among margins [n], the least first. */
static size_t
rank_of_limit(const double *margin, size_t n, size_t i)
{
	size_t place = 0;
	for (size_t k = 0; k < n; k++)
		place += margin[k] < margin[i] ||
			 (k < i && !(margin[i] < margin[k]));
	return place;
}

/* What says more of the light, and of the limits. */
static void
touch_verdict(struct tui *t, const struct touched *touched)
{
	cmdline_run(t, touched->item == 0 ? "why" : "spec");
}

static void
panel_draw_limits(struct panel *p, const struct area *area)
{
	struct tui *t = p->t;
	const struct grading *g = envelope_check_now(t);
	struct area name = *area;
	name.columns -= 4;
	hits_add(&t->hits, HIT_PRESS, *area, touch_verdict, 1);
	/* The fraction, where the name has room behind it. */
	FREED char *words = plots_limits_words(t->session);
	xlist(&words, " ", "%s", t->session->spec->name);
	bool fits = text_width(words) <= name.columns;
	screen_text(
	    &name, 0, 0, LOOK_DIM, "%s", fits ? words : t->session->spec->name);
	if (g == NULL) {
		screen_text(area, 1, 0, 0,
		    session_busy(t->session) ? N_("after the calibration")
					     : N_("not on the feed's sieves"));
		return;
	}
	bool in = wanted_holds(&g->conditions, SIZE_MAX);
	screen_text(area, 0, area->columns - 3, in ? LOOK_BOLD : LOOK_REVERSE,
	    in ? N_(" in") : N_("OUT"));
	int row = 1;
	size_t n = g->limits.n;
	FREED double *margin = xdoubles(n);
	for (size_t i = 0; i < n; i++)
		margin[i] = wanted_margin(&g->conditions, i).passing;
	for (size_t i = 0; i < n; i++)
		if ((int)rank_of_limit(margin, n, i) < area->rows - 1)
			panel_draw_limit(area, row++, g, i);
}

static struct wish
readings_wish(const struct panel *p)
{
	enum { LEAST = 3 };
	int n = readout_rows(p->t);
	return (struct wish){n < LEAST ? n : LEAST, n};
}

static void
draw_readings(struct panel *p, const struct area *area)
{
	readout_draw(p->t, area);
}

/* Of a few sieves nobody sees a curve. */
static struct wish
sieves_wish(const struct panel *p)
{
	enum { LEAST = 5 };
	int n = sieve_table_rows(p->t);
	return (struct wish){n < LEAST ? n : LEAST, n};
}

static void
draw_sieves(struct panel *p, const struct area *area)
{
	sieve_table_draw(p->t, area);
}

/* As many rows whether there is a doubt or not, or the numbers below would move
 * with the speed; what is red says all of its reason. */
static struct wish
light_wish(const struct panel *p)
{
	enum { TALL = 30, MANY = 4, FEW = 2 };
	const struct area *side = &p->t->layout.side;
	if (p->light->light == LIGHT_RED && p->reason != NULL)
		return (struct wish){
		    MANY, 1 + text_count_rows(p->reason->text, side->columns)};
	return (struct wish){1, side->rows > TALL ? MANY : FEW};
}

/* What a reason is about, in a few words. */
static const char *const ABOUT[] = {[TRUST_FIT] = N_("doubtful fit"),
    [TRUST_DATA] = N_("few or doubtful data"),
    [TRUST_PATTERN] = N_("residuals have a pattern"),
    [TRUST_HOLDOUT] = N_("held-out run is missed"),
    [TRUST_BEYOND] = N_("beyond the measured speeds"),
    [TRUST_SLOW] = N_("slower, less may break"),
    [TRUST_BAND] = N_("the band is wide"),
    [TRUST_FEED] = N_("unusual feed"),
    [TRUST_BOUND] = N_("a parameter at its bound"),
    [TRUST_MACHINE] = N_("another machine"),
    [TRUST_ORIGIN] = N_("not calibrated here")};

/* What stands before its colon, or a few words, where there is no room for all
 * of it. */
static void
draw_reason(const struct area *area, const struct trust_reason *reason)
{
	const int rows = area->rows - 1;
	FREED char *text = xstrdup(reason->text);
	char *colon = strchr(text, ':');
	if (text_count_rows(text, area->columns) > rows && colon != NULL)
		*colon = '\0';
	bool fits = text_count_rows(text, area->columns) <= rows;
	screen_words(area, 1, 0, fits ? text : tr(ABOUT[reason->cause]));
}

static void
draw_fit_quality(const struct tui *t, const struct area *area)
{
	double fit = 100 * tui_current_entry(t)->fit.rmse,
	       held = t->view.holdout;
	screen_text(area, 1, 0, 0,
	    !isfinite(held)        ? N_("fit %.2f points")
	    : area->columns < WIDE ? N_("fit %.2f, held out %.1f")
				   : N_("fit %.2f, held out %.1f points"),
	    fit, held);
}

/* In reverse, as what comes out is read by it; below it the first reason, or
 * how well the fit holds. */
static void
draw_light(struct panel *p, const struct area *area)
{
	static const enum series SERIES[] = {
	    SERIES_GREEN, SERIES_AMBER, SERIES_RED};
	const struct trust *light = p->light;
	FREED char *words =
	    xasprintf(tr("trust %s"), tr(LIGHT_NAME[light->light]));
	if (light->n > 0 && area->columns >= WIDE)
		xappend(&words,
		    tr_n(", %zu reason, see :why", ", %zu reasons, see :why",
			light->n),
		    light->n);
	else if (light->n > 0)
		xappend(&words, tr(", %zu, see :why"), light->n);
	FREED char *row =
	    xasprintf("%s%*s", words, area->columns - text_width(words), "");
	screen_series(
	    area, 0, 0, SERIES[light->light], LOOK_BOLD | LOOK_REVERSE, row);
	hits_add(&p->t->hits, HIT_PRESS, *area, touch_verdict, 0);
	if (p->reason != NULL)
		draw_reason(area, p->reason);
	else if (tui_current_entry(p->t)->has_fit)
		draw_fit_quality(p->t, area);
}

/* From the top down.  rank: in this order they get the least rows they need,
 * and then what they may have more; apart: a blank row above it where there is
 * one left; always: what it takes whatever there is to show. */
enum { BLOCKS = 9 };
static const struct block {
	int rank;
	bool apart;
	struct wish (*wish)(const struct panel *p);
	struct wish always;
	void (*draw)(struct panel *p, const struct area *area);
} BLOCK[BLOCKS] = {
    {1, false, light_wish, {0, 0}, draw_light},
    {2, true, speed_wish, {0, 0}, panel_draw_speed},
    {0, false, NULL, {PSD_SIZES, PSD_SIZES}, draw_p_sizes},
    {5, false, NULL, {1, 2}, draw_break},
    {6, false, fractions_wish, {0, 0}, draw_fractions},
    {4, true, limits_wish, {0, 0}, panel_draw_limits},
    {8, true, tonnes_wish, {0, 0}, draw_tonnes},
    {3, true, readings_wish, {0, 0}, draw_readings},
    {7, true, sieves_wish, {0, 0}, draw_sieves},
};

/* Rows [BLOCKS] out for a panel of so many. */
static void
panel_share_rows(const struct panel *p, int left, int rows[BLOCKS])
{
	struct wish wish[BLOCKS];
	size_t at[BLOCKS];
	for (size_t i = 0; i < BLOCKS; i++) {
		wish[i] =
		    BLOCK[i].wish != NULL ? BLOCK[i].wish(p) : BLOCK[i].always;
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

/* A blank row above those that stand apart, where there are some left. */
static void
draw_blocks(struct panel *p)
{
	const struct area *side = &p->t->layout.side;
	int rows[BLOCKS], left = side->rows, row = 0;
	panel_share_rows(p, side->rows, rows);
	for (size_t i = 0; i < BLOCKS; i++) {
		left -= rows[i];
		if (BLOCK[i].draw == draw_light)
			p->t->reason_shown = rows[i] > 1;
	}
	for (size_t i = 0; i < BLOCKS; i++) {
		if (rows[i] == 0)
			continue;
		if (BLOCK[i].apart && row > 0 && left > 0) {
			left--;
			row++;
		}
		BLOCK[i].draw(p, &(struct area){side->row + row, side->column,
				     rows[i], side->columns});
		row += rows[i];
	}
}

/* What the newest flow was fed with, where that was of this site; what goes
 * past the rotor counts as what goes back: neither is a share of the
 * product. */
static void
take_tonnes(struct panel *p)
{
	const struct session *s = p->t->session;
	p->tph = p->back = NAN;
	for (size_t i = s->n_answer; i-- > 0;) {
		const struct answer *a = s->answer[i];
		if (strcmp(answer_command(a), "flow") != 0)
			continue;
		if (strcmp(answer_view(a).site,
			tui_current_entry(p->t)->site->name) != 0)
			return;
		p->tph = answer_number(a, "feed_tph");
		p->back = answer_number(a, "circulating_tph") +
			  fmax(answer_number(a, "crushers.cascade_tph"), 0);
		return;
	}
}

/* The first reason, but one that came with the slider's speed before those of
 * all speeds; NULL: none. */
static const struct trust_reason *
panel_reason(const struct trust *light)
{
	size_t first = 0;
	for (size_t i = light->n; i-- > 0;)
		if (light->reason[i].cause == TRUST_BEYOND)
			first = i;
	return light->n > 0 ? &light->reason[first] : NULL;
}

/* The light of what is shown, once for all that tells of it. */
static const struct trust *
light_shown(struct tui *t)
{
	struct view *v = &t->view;
	if (!v->lit) {
		trust_free(&v->light);
		v->light = light_of_prediction(
		    t->session, tui_entry_asked_about(t), &v->shown);
		v->lit = true;
	}
	return &v->light;
}

static void
take_light(struct panel *p)
{
	p->light = light_shown(p->t);
	p->reason = panel_reason(p->light);
}

/* Without a prediction there is what to do, and what is pinned or was read. */
static void
draw_nothing(const struct tui *t)
{
	const struct area *side = &t->layout.side;
	const struct site *site = tui_current_entry(t)->site;
	int row = 0;
	/* The row of numbers has said it already. */
	if (t->layout.numbers.rows == 0)
		screen_text(side, row++, 0, 0, "nothing predicted yet");
	screen_text(side, row++, 0, 0,
	    site_products(site) > 0 ? N_("Enter calibrates")
				    : N_("no product: type :guess"));
	row++;
	if (!is_pinned(t)) {
		FREED char *read = folder_site(site);
		pane_lines(side, row, read);
		return;
	}
	screen_text(side, row++, 0, LOOK_BOLD, "pinned: %.1f m/s %s",
	    t->view.pinned.speed, t->view.pinned.site);
	for (int i = 0; i < PSD_SIZES; i++) {
		screen_text(side, row + i, 0, 0, "P%.0f", 100 * PSD_PASSING[i]);
		draw_size(side, row + i, LOOK_PLAIN, t->view.pinned.size[i]);
	}
}

void
panel_draw(struct tui *t)
{
	const struct area *side = &t->layout.side;
	t->reason_shown = false;
	if (side->rows == 0)
		return;
	screen_vertical_rule(side->row, t->layout.wall, side->rows);
	if (t->view.current.site[0] == '\0') {
		draw_nothing(t);
		return;
	}
	struct panel p = {.t = t,
	    .was = is_pinned(t)                        ? &t->view.pinned
		   : t->view.reference.site[0] != '\0' ? &t->view.reference
						       : NULL};
	take_tonnes(&p);
	take_light(&p);
	draw_blocks(&p);
}

/* The light in so many columns, or in `most` in the shortest words, with its
 * first reason: what stands before its last colon, or its first, else a few
 * words on what it is about, as far as there is room. */
static char *
light_words(const struct trust *light, int columns, int most)
{
	const char *name = tr(LIGHT_NAME[light->light]);
	const struct trust_reason *reason = panel_reason(light);
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
	       text_width(way[i]) > (i == 3 ? most : columns))
		i++;
	words = way[i];
	for (size_t k = 0; k < ARRAY_LEN(way); k++)
		if (k != i)
			free(way[k]);
	return words;
}

char *
panel_words(struct tui *t, int columns, int most)
{
	const struct grading *g = envelope_check_now(t);
	bool side = t->layout.side.rows > 0;
	if (t->ui.page != PAGE_PREDICT || t->view.current.site[0] == '\0' ||
	    (side && t->reason_shown))
		return xstrdup("");
	const struct trust *light = light_shown(t);
	FREED char *limits = xstrdup("");
	if (g != NULL && !side)
		xappend(&limits,
		    wanted_holds(&g->conditions, SIZE_MAX) ? tr(", in %s")
							   : tr(", out of %s"),
		    t->session->spec->name);
	int taken = text_width(limits);
	char *words = side && light->n == 0
			  ? xstrdup("")
			  : light_words(light, columns - taken, most - taken);
	xappend(&words, "%s", limits);
	return words;
}

/* The same in four characters at most, where there is little room: a number cut
 * by its end would be another. */
static const char *
short_size(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, "off");
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
panel_row(struct tui *t)
{
	const struct area *area = &t->layout.numbers;
	const struct prediction *p = &t->view.shown;
	char a[24], b[24], c[24], d[24];
	/* The list of sites tells of the marked one, which may be another. */
	if (area->rows == 0 ||
	    (t->ui.page == PAGE_SITES &&
		t->ui.list[PAGE_SITES].at != t->session->current))
		return;
	if (t->view.current.site[0] == '\0')
		screen_text(area, 0, 0, 0,
		    area->columns < 21 ? N_("not predicted yet")
				       : N_("nothing predicted yet"));
	else if (t->ui.cross && t->ui.cross_at < p->product.n) {
		bool narrow = area->columns < 34, least = area->columns < 24;
		double mm = 1000 * psd_size(&p->curve, t->ui.level / 100.0);
		screen_text(area, 0, 0, LOOK_BOLD,
		    least    ? "%g %.1f%% P%d %s"
		    : narrow ? N_("%g %.1f %% P%d %s mm")
			     : N_("%g mm %.1f %%  %d %% %s"),
		    units_mm(p->product.size[t->ui.cross_at]),
		    100 * p->product.passing[t->ui.cross_at], t->ui.level,
		    narrow ? short_size(mm, a) : readout_size(mm, a));
	} else if (area->columns < 34)
		screen_text(area, 0, 0, LOOK_BOLD, "P50 %s P80 %s mm",
		    short_size(t->view.current.size[1], b),
		    short_size(t->view.current.size[2], c));
	else if (area->columns < 60)
		screen_text(area, 0, 0, LOOK_BOLD, "P20 %s P50 %s P80 %s mm",
		    short_size(t->view.current.size[0], a),
		    short_size(t->view.current.size[1], b),
		    short_size(t->view.current.size[2], c));
	else
		screen_text(area, 0, 0, LOOK_BOLD,
		    "P20 %s  P50 %s  P80 %s  break size %s",
		    readout_size(t->view.current.size[0], a),
		    readout_size(t->view.current.size[1], b),
		    readout_size(t->view.current.size[2], c),
		    readout_size(t->view.current.break_mm, d));
}
