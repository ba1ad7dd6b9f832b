/* card: the sheet of speeds and products for the operator.
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
#include "cmd/plant/plant.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/question.h"
#include "cmd/lang/table.h"
#include "io/cells/datetime.h"
#include "io/sitefile/units.h"

/* What is asked at every speed: P20, P50 and P80, then the user's figures;
 * limits, and tonnes. */
struct asked {
	const struct question *question;
	size_t n;
	struct quantity *q;
	struct forecast *forecast;
	struct condition_list list; /* limits of the product, or none */
	struct wanted wanted;
	bool flows; /* the plant is worked out */
	struct flow_plan plan;
	struct plant plant;
	size_t n_line;
	struct plant_line *line;
	char *power;
};

/* Adds the quantities of a text to the list. */
static bool
add_list(struct asked *all, const char *text, const struct psd *feed,
    struct error *error)
{
	const struct fraction *fraction = &all->question->fraction;
	size_t n;
	FREED struct quantity *q =
	    quantities_asked(text, fraction, feed, true, &n, error);
	for (size_t i = 0; q != NULL && i < n; i++) {
		all->q = xrealloc(all->q, all->n + 1, sizeof *all->q);
		all->q[all->n++] = q[i];
	}
	return q != NULL;
}

/* Of the site's own sieves: what passes 2 mm or the one nearest to it, and the
 * fines, or else what passes the finest. */
static bool
add_usual_passings(
    struct asked *all, const struct psd *feed, struct error *error)
{
	size_t near = 0;
	for (size_t i = 0; i < feed->n; i++)
		if (fabs(log(feed->size[i] / 2e-3)) <
		    fabs(log(feed->size[near] / 2e-3)))
			near = i;
	FREED char *middle =
	    xasprintf("passing %.12g", units_mm(feed->size[near]));
	FREED char *finest =
	    psd_covers(feed, 6.3e-5)
		? xstrdup("fines")
		: xasprintf("passing %.12g", units_mm(feed->size[feed->n - 1]));
	return add_list(all, middle, feed, error) &&
	       add_list(all, finest, feed, error);
}

static void
card_request_free(struct asked *all)
{
	if (all->flows)
		plant_free(&all->plant);
	flow_plan_free(&all->plan);
	free(all->line);
	free(all->power);
	free(all->q);
	conditions_free(&all->list);
	forecast_close(all->wanted.forecast);
	forecast_close(all->forecast);
}

/* Tonnes are wanted where there is a feed or a circuit. */
static bool
read_flow(struct session *s, struct asked *all, const struct args *args,
    struct error *error)
{
	const void *const with_feed[] = {&args->fractions, &args->recycle,
	    &args->power, &args->prices, &args->kwh};
	if (args->tph > 0 || args->circuit != NULL)
		return flow_plan_read(
		    s, args, all->question, &all->plan, error);
	for (size_t i = 0; i < ARRAY_LEN(with_feed); i++)
		if (args_given(args, with_feed[i]))
			return error_set(error, ERROR_USAGE,
			    "expected tph= with %s=\n"
			    "add the new feed, as tph=120",
			    args_name(args, with_feed[i]));
	return true;
}

/* What the products of the plant are called is known when it was worked out
 * once. */
static bool
find_lines(struct asked *all, double speed, struct error *error)
{
	const struct circuit *c = all->plan.circuit;
	struct outcome o = plant_solve_at(&all->plant, speed);
	bool ok = !o.flow.open || plant_not_steady(&all->plant, &o, error);
	all->line = xcalloc(c->n_stream + c->n_unit, sizeof *all->line);
	all->n_line = plant_lines(&all->plant, &o, all->line);
	all->power = plant_power_words(&all->plant, &o);
	flow_free(&o.flow);
	return ok;
}

static bool
card_request_read(struct session *s, struct asked *all, const struct args *args,
    double slowest, struct error *error)
{
	const struct entry *entry = all->question->entry;
	size_t run = all->question->feed;
	const struct psd *feed = site_feed(entry->site, run);
	bool ok =
	    add_list(all, ANSWERS_SIZE_LIST, feed, error) &&
	    (args_given(args, &args->of)
		    ? add_list(all, args->of, feed, error)
		    : add_usual_passings(all, feed, error)) &&
	    conditions_add_call(s, args, all->question, &all->list, error) &&
	    read_flow(s, all, args, error);
	if (!ok)
		return false;
	all->forecast = forecast_open(s, all->question, all->q, all->n);
	if (all->list.n > 0)
		all->wanted =
		    conditions_open(s, all->question, &all->list, NULL);
	all->flows = all->plan.circuit != NULL;
	if (!all->flows)
		return true;
	all->plant = plant_new(s, &all->plan);
	return find_lines(all, slowest, error);
}

/* What one speed gives: the quantities and their band, as they are shown,
 * tonnes of the plant's lines, NAN where it does not become steady. */
struct card_row {
	double speed, rpm, *value, low, high, *tph, kwh, earned, share;
	struct figure ranged; /* the figure whose range people see */
	bool holds;
	enum light light;
};

static void
work_out_flow(const struct asked *all, struct card_row *row)
{
	struct outcome o = plant_solve_at(&all->plant, row->speed);
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_line *line = &all->line[i];
		double tph = line->unit != NULL
				 ? flow_into_unit(&o.flow, line->unit)
				 : o.flow.tph[line->stream];
		row->tph[i] = o.flow.open ? NAN : tph;
	}
	row->kwh = o.flow.open ? NAN : o.kw / all->plan.circuit->tph;
	row->earned = o.flow.open ? NAN : o.money;
	flow_free(&o.flow);
}

/* The figure whose range a page has room for: the first that has a limit, or
 * the first behind the sizes. */
static size_t
ranged_figure(const struct asked *all)
{
	for (size_t c = 0; c < all->list.n; c++)
		for (size_t i = 0; i < all->n; i++)
			if (quantity_same(
				&all->q[i], &all->list.at[c].quantity))
				return i;
	return PSD_SIZES < all->n ? PSD_SIZES : PSD_SIZES - 1;
}

/* Where the feed does not tell a size at this speed nothing stands. */
static void
card_work_out(struct session *s, struct asked *all, double speed,
    struct card_row *row, struct trust *worst)
{
	enum { P80 = 2 };
	const struct entry *entry = all->question->entry;
	*row = (struct card_row){.speed = speed,
	    .rpm = units_rpm(speed, entry->site->rotor),
	    .value = xdoubles(all->n),
	    .tph = xdoubles(all->n_line + 1),
	    .share = NAN};
	forecast_at(all->forecast, speed);
	for (size_t i = 0; i < all->n; i++)
		row->value[i] = forecast_shown(all->forecast, i).value;
	struct figure p80 = forecast_shown(all->forecast, P80);
	row->low = p80.low;
	row->high = p80.high;
	row->ranged = forecast_shown(all->forecast, ranged_figure(all));
	if (all->flows)
		work_out_flow(all, row);
	if (all->list.n > 0) {
		forecast_at(all->wanted.forecast, speed);
		row->holds = wanted_holds(&all->wanted, SIZE_MAX);
		row->share = wanted_certainty(&all->wanted);
	}
	struct trust light = light_at(s, entry, speed, all->question->feed);
	row->light = light.light;
	light_worse(worst, light);
}

/* A column of the page: cells of numbers or of words, both [rows].  spare: the
 * larger, the sooner it is left out where there is no room. */
struct page_column {
	char *head, **word;
	double *number;
	int decimals, spare, wide;
};

struct page {
	size_t n, rows;
	struct page_column *column;
};

enum { WORDS = -1 };
enum { NEEDED, FIGURE, MEDIAN, RANGE, FINE };

static struct page_column *
page_column(struct page *page, char *head, int decimals, int spare)
{
	page->column =
	    xrealloc(page->column, page->n + 1, sizeof *page->column);
	struct page_column *c = &page->column[page->n++];
	*c = (struct page_column){.head = head,
	    .word = xcalloc(page->rows + 1, sizeof(*c->word)),
	    .number = xdoubles(page->rows + 1),
	    .decimals = decimals,
	    .spare = spare,
	    .wide = text_width(head)};
	return c;
}

/* Takes the word, NULL of a number. */
static void
page_cell(struct page_column *c, size_t row, double number, char *word)
{
	c->number[row] = number;
	c->word[row] =
	    word != NULL ? word : xasprintf("%.*f", c->decimals, number);
	int wide = text_width(c->word[row]);
	c->wide = wide > c->wide ? wide : c->wide;
}

/* "<2 mm": as short as a page for a wall wants it.  What all figures are of is
 * said below. */
static char *
page_head(const struct asked *all, const struct quantity *q)
{
	struct quantity own = *q;
	const struct fraction *cut = &all->question->fraction;
	if (cut->fine == own.fraction.fine &&
	    cut->coarse == own.fraction.coarse)
		own.fraction = (struct fraction){0};
	if (q->kind == QUANTITY_PASSING && q->letter == 0 &&
	    !fraction_screens(&own.fraction))
		return xasprintf("<%g mm", units_mm(q->x));
	char *words = quantities_words(&own);
	if (q->kind == QUANTITY_SHARE)
		xappend(&words, " %%");
	return words;
}

static void
page_flow(
    struct page *page, const struct asked *all, const struct card_row *row)
{
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_line *line = &all->line[i];
		struct page_column *c = page_column(page,
		    xasprintf(
			line->unit == NULL ? tr("%s back") : "%s", line->name),
		    1, NEEDED);
		for (size_t k = 0; k < page->rows; k++)
			page_cell(c, k, row[k].tph[i], NULL);
	}
	struct page_column *kwh =
	    page_column(page, xstrdup("kWh/t"), 2, FIGURE);
	for (size_t k = 0; k < page->rows; k++)
		page_cell(kwh, k, row[k].kwh, NULL);
	if (!all->plan.priced)
		return;
	struct page_column *earned =
	    page_column(page, xstrdup(tr("earned/h")), 0, NEEDED);
	for (size_t k = 0; k < page->rows; k++)
		page_cell(earned, k, row[k].earned, NULL);
}

/* level: of the band, %. */
static void
page_sizes(struct page *page, const struct asked *all,
    const struct card_row *row, double level)
{
	enum { P20, P50, P80, SIZES };
	static const int SPARE[SIZES] = {
	    [P20] = FINE, [P50] = MEDIAN, [P80] = NEEDED};
	for (size_t i = 0; i < all->n; i++) {
		const struct quantity *q = &all->q[i];
		int decimals = quantities_decimals(q);
		struct page_column *c = page_column(page, page_head(all, q),
		    decimals, i < SIZES ? SPARE[i] : FIGURE);
		for (size_t k = 0; k < page->rows; k++)
			page_cell(c, k, row[k].value[i], NULL);
		if (i != ranged_figure(all) || isnan(row[0].ranged.low))
			continue;
		c = page_column(
		    page, xasprintf(tr("%.0f %% range"), level), WORDS, RANGE);
		for (size_t k = 0; k < page->rows; k++)
			page_cell(c, k, NAN,
			    xasprintf("%.*f..%.*f", decimals, row[k].ranged.low,
				decimals, row[k].ranged.high));
	}
}

/* "amber", and "amber?" beyond the measured speeds.  The caller frees. */
static char *
light_cell(const struct asked *all, const struct card_row *row)
{
	bool beyond = answers_extrapolates(all->question->entry, row->speed);
	return xasprintf("%s%s", tr(LIGHT_NAME[row->light]), beyond ? "?" : "");
}

static struct page
page_of(const struct asked *all, const struct card_row *row, size_t rows,
    double level)
{
	struct page page = {.rows = rows};
	struct page_column *c = page_column(&page, xstrdup("m/s"), 0, NEEDED);
	for (size_t k = 0; k < rows; k++)
		page_cell(c, k, row[k].speed, xasprintf("%g", row[k].speed));
	if (all->question->entry->site->rotor > 0) {
		c = page_column(&page, xstrdup("rpm"), 0, NEEDED);
		for (size_t k = 0; k < rows; k++)
			page_cell(c, k, row[k].rpm, NULL);
	}
	page_sizes(&page, all, row, level);
	if (all->flows)
		page_flow(&page, all, row);
	if (all->list.n > 0) {
		c = page_column(
		    &page, xstrdup(tr("limits met")), WORDS, NEEDED);
		for (size_t k = 0; k < rows; k++)
			page_cell(c, k, NAN,
			    conditions_chance(row[k].share, row[k].holds));
	}
	c = page_column(&page, xstrdup(tr("trust")), WORDS, NEEDED);
	for (size_t k = 0; k < rows; k++)
		page_cell(c, k, NAN, light_cell(all, &row[k]));
	return page;
}

static void
page_drop(struct page *page, size_t at)
{
	struct page_column *c = &page->column[at];
	for (size_t k = 0; k < page->rows; k++)
		free(c->word[k]);
	free(c->word);
	free(c->number);
	free(c->head);
	memmove(c, c + 1, (--page->n - at) * sizeof *c);
}

/* Leaves out what can be spared until a row is one line of 80; what that was,
 * or "", which the caller frees.  Where it is not enough the table is wider: it
 * stays one. */
static char *
page_drop_to_fit(struct page *page, struct answer *r)
{
	enum { ROOM = 79, GAP = 2 };
	char *dropped = xstrdup("");
	for (;;) {
		int wide = 0;
		size_t most = 0;
		for (size_t i = 0; i < page->n; i++) {
			wide += GAP + page->column[i].wide;
			if (page->column[i].spare > page->column[most].spare)
				most = i;
		}
		if (wide <= ROOM)
			return dropped;
		if (page->column[most].spare == NEEDED) {
			answer_set_width(r, wide + 1);
			return dropped;
		}
		xlist(&dropped, ", ", "%s", page->column[most].head);
		page_drop(page, most);
	}
}

static bool
page_has_spare(const struct page *page, int spare)
{
	for (size_t i = 0; i < page->n; i++)
		if (page->column[i].spare == spare)
			return true;
	return false;
}

/* For people: a line a speed. */
static void
add_page(struct answer *r, struct page *page)
{
	for (size_t i = 0; i < page->n; i++)
		answer_column(r, page->column[i].head, page->column[i].head);
	for (size_t k = 0; k < page->rows; k++)
		for (size_t i = 0; i < page->n; i++) {
			struct page_column *c = &page->column[i];
			if (c->decimals == WORDS)
				answer_text(r, "%s", c->word[k]);
			else
				answer_cells(r, "%.*f",
				    i == 0 ? -1 : c->decimals, c->number[k]);
		}
}

static void
add_key(struct answer *r, const char *key)
{
	answer_column(r, key, key);
}

static void
add_flow_keys(struct answer *r, const struct asked *all)
{
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_line *line = &all->line[i];
		FREED char *key = xasprintf("%s_%s",
		    line->unit == NULL ? "back_tph" : "tph", line->name);
		add_key(r, key);
	}
	if (all->flows)
		add_key(r, "kwh_per_t");
	if (all->flows && all->plan.priced)
		add_key(r, "earnings");
}

static void
add_keys(struct answer *r, const struct asked *all, bool rpm)
{
	add_key(r, "speed");
	if (rpm)
		add_key(r, "rpm");
	for (size_t i = 0; i < all->n; i++) {
		FREED char *key = quantities_key(&all->q[i]);
		add_key(r, key);
	}
	add_key(r, "p80_low_mm");
	add_key(r, "p80_high_mm");
	add_flow_keys(r, all);
	if (all->list.n > 0) {
		add_key(r, "limits");
		add_key(r, "certain");
	}
	add_key(r, "light");
}

/* For programs, met is what is the more likely. */
static void
card_add_row(struct answer *r, const struct asked *all,
    const struct card_row *row, bool rpm)
{
	answer_cells(r, "%g", row->speed);
	if (rpm)
		answer_cells(r, "%.0f", row->rpm);
	for (size_t i = 0; i < all->n; i++)
		answer_cells(
		    r, "%.*f", quantities_decimals(&all->q[i]), row->value[i]);
	answer_cells(r, "%.2f %.2f", row->low, row->high);
	for (size_t i = 0; i < all->n_line; i++)
		answer_cells(r, "%.1f", row->tph[i]);
	if (all->flows)
		answer_cells(r, "%.2f", row->kwh);
	if (all->flows && all->plan.priced)
		answer_cells(r, "%.0f", row->earned);
	if (all->list.n > 0) {
		bool met = isnan(row->share) ? row->holds : row->share >= 0.5;
		FREED char *certain = isnan(row->share)
					  ? xstrdup("-")
					  : conditions_percent(row->share);
		answer_cells(r, "%s", met ? tr("met") : tr("missed"));
		answer_text(r, "%s", certain);
	}
	answer_cells(r, "%s", tr(LIGHT_NAME[row->light]));
}

static void
note_flow(struct answer *r, const struct asked *all)
{
	if (!all->flows)
		return;
	const char *back = all->plan.back;
	bool returns = back != NULL && back[0] != '\0';
	if (returns)
		answer_note(r, "%g t/h of new feed, %s back to the crusher; %s",
		    all->plan.circuit->tph, back, all->power);
	else
		answer_note(r, "%g t/h of new feed; %s", all->plan.circuit->tph,
		    all->power);
	if (returns)
		answer_say(r, ANSWER_REMARK,
		    "sizes and passings are those of the new feed's product, "
		    "without what comes back; tonnes include it");
}

/* That no row is likely to meet the limits; where one is, the rows say so. */
static void
note_unmet(struct answer *r, const struct card_row *row, size_t n)
{
	size_t best = 0;
	for (size_t i = 1; i < n; i++)
		if (row[i].share > row[best].share)
			best = i;
	FREED char *share = conditions_percent(row[best].share);
	if (row[best].share < 0.01)
		answer_say(r, ANSWER_WARNING,
		    "no speed on this page meets the limits");
	else if (row[best].share < 0.5)
		answer_say(r, ANSWER_WARNING,
		    "no speed on this page is likely to meet the limits: the "
		    "surest, %g m/s, does with %s probability",
		    row[best].speed, share);
}

static void
note_limits(struct answer *r, const struct asked *all,
    const struct card_row *row, size_t n)
{
	FREED char *words = conditions_list_words(&all->list);
	if (all->list.n > 0) {
		answer_note(r, "limits: %s", words);
		note_unmet(r, row, n);
	}
	conditions_note_source(r, &all->list);
}

/* What the figures are, of which machine, found how, and who answers for
 * them. */
static void
note_basis(struct answer *r, const struct session *s, const struct asked *all,
    const char *dropped, bool range)
{
	const struct question *q = all->question;
	const struct site *site = q->entry->site;
	FREED char *speeds = session_speeds(site, ", ", NULL, true);
	FREED char *feed = feed_words(site, q->feed);
	bool fines = false;
	for (size_t i = 0; i < all->n; i++)
		fines = fines || (all->q[i].kind == QUANTITY_PASSING &&
				     all->q[i].letter != 0);
	answer_note(r, "P20, P50, P80 in mm, passing in %%%s%s",
	    fines ? tr(", fines under 0.063 mm") : "",
	    all->flows ? tr(", fractions in t/h") : "");
	if (fraction_screens(&q->fraction)) {
		FREED char *cut = quantities_fraction_text(&q->fraction);
		answer_note(r, "all of these of the fraction %s", cut);
	}
	if (dropped[0] != '\0')
		answer_note(r, "left out, as there is no room: %s", dropped);
	if (range)
		answer_note(r,
		    "%.0f %% range: of the figure at its left; the true value "
		    "lies in it with %.0f %% probability",
		    100 * q->level, 100 * q->level);
	if (site->machine[0] != '\0')
		answer_note(r, "machine: %s", site->machine);
	answer_note(r, "model: %s, %s; %s",
	    breakage_of(&q->entry->params)->name, origin_words(q->entry),
	    outlook_words(s, q->entry));
	if (feed == NULL)
		answer_note(r, "feed: %s",
		    site->with[0] != '\0' ? site->with : tr("as sampled"));
	answer_note(r,
	    "green: confirmed by measurements at %s m/s; amber: from the model "
	    "alone, or doubtful; red: do not rely on it; ?: beyond the "
	    "measured speeds",
	    speeds);
}

/* The lights stand in the rows.  Where none of them is green the least bad says
 * why, of measured speeds first; programs are given the worst. */
static void
note_light(struct answer *r, const struct session *s, const struct question *q,
    const struct card_row *row, size_t n, struct trust *worst)
{
	size_t best = 0;
	for (size_t i = 1; i < n; i++) {
		bool within = !answers_extrapolates(q->entry, row[i].speed);
		bool better = row[i].light < row[best].light;
		if (better ||
		    (row[i].light == row[best].light && within &&
			answers_extrapolates(q->entry, row[best].speed)))
			best = i;
	}
	answers_note_basis(s, r, q, 0, NULL, worst);
	if (n > 0 && row[best].light != LIGHT_GREEN) {
		FREED char *said =
		    light_words_at(s, q->entry, row[best].speed, q->feed);
		answer_say(r,
		    row[best].light == LIGHT_RED ? ANSWER_WARNING
						 : ANSWER_REMARK,
		    "%s", said);
	}
	light_put(answer_fields(r), worst);
	trust_free(worst);
}

static void
rows_free(struct card_row *row, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		free(row[i].value);
		free(row[i].tph);
	}
	free(row);
}

static struct answer *
card_answer(struct session *s, struct asked *all, const double *speed, size_t n)
{
	const struct entry *entry = all->question->entry;
	bool rpm = entry->site->rotor > 0;
	FREED char *today = moment_today();
	struct answer *r =
	    answers_new(entry->site, "card", "card of %s", today);
	struct trust light = light_of_prediction(s, entry, NULL);
	struct card_row *row = xcalloc(n, sizeof *row);
	for (size_t i = 0; i < n; i++)
		card_work_out(s, all, speed[i], &row[i], &light);
	struct page page = page_of(all, row, n, 100 * all->question->level);
	FREED char *dropped = page_drop_to_fit(&page, r);
	add_page(r, &page);
	answer_fill_for_programs(r);
	add_keys(r, all, rpm);
	for (size_t i = 0; i < n; i++)
		card_add_row(r, all, &row[i], rpm);
	fields_put(answer_fields(r), "date %s machine %s model %s", today,
	    entry->site->machine, breakage_of(&entry->params)->name);
	note_limits(r, all, row, n);
	note_flow(r, all);
	note_basis(r, s, all, dropped, page_has_spare(&page, RANGE));
	note_light(r, s, all->question, row, n, &light);
	while (page.n > 0)
		page_drop(&page, page.n - 1);
	free(page.column);
	rows_free(row, n);
	return r;
}

bool
cmd_card(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct asked all = {.question = q};
	question_usual_speeds(s, q, true);
	bool ok = card_request_read(s, &all, args, q->at[q->n_at - 1], error);
	if (ok && s->document != NULL)
		s->document->one_page = true;
	if (ok)
		session_show_answer(s, card_answer(s, &all, q->at, q->n_at));
	card_request_free(&all);
	return ok;
}
