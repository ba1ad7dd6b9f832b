/* card: the page for the cabin: what every speed gives.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/condition.h"
#include "cmd/document/document.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/forecast.h"
#include "cmd/plant/plant.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/table.h"
#include "io/sitefile/units.h"

/* What is asked at every speed: P20, P50 and P80, then the user's figures;
 * limits, and tonnes. */
struct asked {
	const struct question *question;
	size_t n;
	struct quantity *q;
	struct forecast *forecast;
	struct condition_list list; /* limits of the product, or none */
	char *limits; /* where those of an envelope are from, or NULL */
	struct wanted wanted;
	bool flows; /* the plant is worked out */
	struct flow_plan plan;
	struct plant plant;
	size_t n_line;
	struct plant_line *line;
};

/* Adds the quantities of a text to the list. */
static bool
add_list(struct asked *all, const char *text, const struct psd *feed,
    struct error *error)
{
	const struct fraction *fraction = &all->question->fraction;
	size_t n;
	struct quantity *q =
	    quantities_list(text, &fraction->partition, &n, error);
	bool ok = q != NULL;
	for (size_t i = 0; ok && i < n; i++)
		ok = quantities_cut(&q[i], fraction, error) &&
		     quantities_covered(&q[i], feed, error);
	for (size_t i = 0; ok && i < n; i++) {
		all->q = xrealloc(all->q, all->n + 1, sizeof *all->q);
		all->q[all->n++] = q[i];
	}
	free(q);
	return ok;
}

static bool
read_limits(struct session *s, struct asked *all, const struct args *args,
    const struct psd *feed, struct error *error)
{
	const struct fraction *fraction = &all->question->fraction;
	return conditions_add_operands(
		   args, fraction, feed, &all->list, error) &&
	       conditions_add_option(
		   s, args, fraction, feed, &all->list, &all->limits, error);
}

static void
asked_free(struct asked *all)
{
	if (all->flows)
		plant_free(&all->plant);
	flow_plan_free(&all->plan);
	free(all->line);
	free(all->q);
	free(all->limits);
	conditions_free(&all->list);
	forecast_close(all->wanted.forecast);
	forecast_close(all->forecast);
}

/* Tonnes are wanted where there is a feed or a circuit. */
static bool
read_flow(struct session *s, struct asked *all, const struct args *args,
    struct error *error)
{
	static const char *const WITH_FEED[] = {
	    "fractions", "recycle", "power", "prices", "kwh"};
	if (args_value(args, "tph")->given ||
	    args_value(args, "circuit")->given)
		return flow_plan_read(
		    s, args, all->question, &all->plan, error);
	for (size_t i = 0; i < ARRAY_LEN(WITH_FEED); i++)
		if (args_value(args, WITH_FEED[i])->given)
			return error_set(error, ERROR_USAGE,
			    "expected tph= with %s=\n"
			    "add the new feed, as tph=120",
			    WITH_FEED[i]);
	return true;
}

/* What the products of the plant are called is known when it was worked out
 * once. */
static bool
find_lines(struct asked *all, double speed, struct error *error)
{
	const struct circuit *c = all->plan.circuit;
	struct outcome o = plant_at(&all->plant, speed);
	bool ok = !o.flow.open || plant_not_steady(&all->plant, &o, error);
	all->line = xcalloc(c->n_stream + c->n_unit, sizeof *all->line);
	all->n_line = plant_lines(&all->plant, &o, all->line);
	flow_free(&o.flow);
	return ok;
}

static bool
read_asked(struct session *s, struct asked *all, const struct args *args,
    double slowest, struct error *error)
{
	const struct entry *entry = all->question->entry;
	size_t run = all->question->feed;
	const struct psd *feed = site_feed(entry->site, run);
	bool ok = add_list(all, "P20,P50,P80", feed, error) &&
		  add_list(all, args_value(args, "of")->text, feed, error) &&
		  read_limits(s, all, args, feed, error) &&
		  read_flow(s, all, args, error);
	if (!ok)
		return false;
	all->forecast = forecast_open(s, all->question, all->q, all->n);
	if (all->list.n > 0)
		all->wanted =
		    conditions_ask(s, all->question, &all->list, NULL);
	all->flows = all->plan.circuit != NULL;
	if (!all->flows)
		return true;
	all->plant = plant_new(s, &all->plan);
	return find_lines(all, slowest, error);
}

static void
flow_columns(struct answer *r, const struct asked *all)
{
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_line *line = &all->line[i];
		bool back = line->unit == NULL;
		char *key =
		    xasprintf("%s_%s", back ? "back_tph" : "tph", line->name);
		char *head =
		    xasprintf(back ? tr("%s back t/h") : "%s t/h", line->name);
		answer_column(r, key, head);
		free(head);
		free(key);
	}
	if (all->flows)
		answer_columns(r, "kwh_per_t: kWh/t");
	if (all->flows && all->plan.priced)
		answer_columns(r, "earnings: earned/h");
}

/* A column for each, with its unit. */
static void
add_columns(struct answer *r, const struct asked *all, bool rpm)
{
	answer_columns(r, "speed: m/s");
	if (rpm)
		answer_columns(r, "rpm: rpm");
	for (size_t i = 0; i < all->n; i++) {
		const struct quantity *q = &all->q[i];
		char *words = quantities_words(q), *key = quantities_key(q);
		char *head = xasprintf("%s%s", words, quantities_after(q));
		answer_column(r, key, head);
		free(head);
		free(key);
		free(words);
	}
	answer_columns(r, "p80_low_mm: P80 low, p80_high_mm: P80 high");
	flow_columns(r, all);
	if (all->list.n > 0)
		answer_columns(r, "limits: limits, certain: certain");
	answer_columns(r, "light: light");
}

/* Nothing stands where the plant does not become steady. */
static void
add_flow(struct answer *r, const struct asked *all, double v)
{
	struct outcome o = plant_at(&all->plant, v);
	for (size_t i = 0; i < all->n_line; i++) {
		const struct plant_line *line = &all->line[i];
		double tph = line->unit != NULL ? flow_into(&o.flow, line->unit)
						: o.flow.tph[line->stream];
		answer_cells(r, "%.1f", o.flow.open ? NAN : tph);
	}
	answer_cells(
	    r, "%.2f", o.flow.open ? NAN : o.kw / all->plan.circuit->tph);
	if (all->plan.priced)
		answer_cells(r, "%.0f", o.flow.open ? NAN : o.money);
	flow_free(&o.flow);
}

/* Whether the limits hold, else the one that is missed most. */
static void
add_limits(struct answer *r, struct asked *all, double v)
{
	forecast_at(all->wanted.forecast, v);
	answer_cells(r, "%s",
	    wanted_holds(&all->wanted, SIZE_MAX) ? tr("met") : tr("missed"));
	double share = wanted_certainty(&all->wanted);
	char *certain = isnan(share) ? xstrdup("-") : conditions_percent(share);
	answer_text(r, "%s", certain);
	free(certain);
}

/* Where the feed does not tell a size at this speed nothing stands. */
static void
add_row(struct answer *r, struct session *s, struct asked *all, double v,
    struct trust *worst)
{
	enum { P80 = 2 };
	const struct entry *entry = all->question->entry;
	double rotor = entry->site->rotor;
	forecast_at(all->forecast, v);
	struct figure p80 = forecast_figure(all->forecast, P80);
	struct trust light = light_at(s, entry, v, all->question->feed);
	answer_cells(r, "%g", v);
	if (rotor > 0)
		answer_cells(r, "%.0f", units_rpm(v, rotor));
	for (size_t i = 0; i < all->n; i++) {
		double value = quantities_shown(
		    &all->q[i], forecast_figure(all->forecast, i).value);
		bool one = quantities_decimals(&all->q[i]) == 1;
		answer_cells(r, one ? "%.1f" : "%.2f", value);
	}
	answer_cells(r, "%.2f %.2f", 1000 * p80.low, 1000 * p80.high);
	if (all->flows)
		add_flow(r, all, v);
	if (all->list.n > 0)
		add_limits(r, all, v);
	answer_cells(r, "%s", tr(LIGHT_NAME[light.light]));
	light_worse(worst, light);
}

static void
note_flow(struct answer *r, const struct asked *all)
{
	if (!all->flows)
		return;
	char *power = plant_power_words(&all->plant);
	const char *back = all->plan.back;
	bool returns = back != NULL && back[0] != '\0';
	if (returns)
		answer_note(r, "%g t/h of new feed, %s back to the crusher; %s",
		    all->plan.circuit->tph, back, power);
	else
		answer_note(
		    r, "%g t/h of new feed; %s", all->plan.circuit->tph, power);
	free(power);
	if (returns)
		answer_say(r, ANSWER_REMARK,
		    "sizes and passings are those of the new feed's product, "
		    "without what comes back; tonnes are with it");
}

static void
note_limits(struct answer *r, const struct asked *all)
{
	char *words = conditions_list_words(&all->list);
	if (all->list.n > 0)
		answer_note(r, "limits: %s", words);
	if (all->limits != NULL)
		answer_say(r, ANSWER_REMARK, "%s", all->limits);
	free(words);
}

/* 65 to 85 by 1 m/s, or the speeds given; the caller frees. */
static double *
card_speeds(const struct args *args, const struct site *site, size_t *n)
{
	const struct value *given = args_value(args, "speeds");
	double from, to;
	site_reach(site, &from, &to);
	*n = given->n > 0 ? given->n : (size_t)floor(to - from) + 1;
	double *speed = xdoubles(*n);
	for (size_t i = 0; i < *n; i++)
		speed[i] = given->n > 0 ? given->list[i] : from + (double)i;
	return speed;
}

static struct answer *
card_answer(struct session *s, struct asked *all, const double *speed, size_t n)
{
	const struct entry *entry = all->question->entry;
	struct answer *r =
	    answers_new(entry->site, "card", "what each tip speed gives");
	struct trust light = light_of(s, entry, NULL);
	add_columns(r, all, entry->site->rotor > 0);
	for (size_t i = 0; i < n; i++)
		add_row(r, s, all, speed[i], &light);
	note_limits(r, all);
	note_flow(r, all);
	answers_show_basis(s, r, all->question, 0,
	    forecast_draws(all->forecast, 0) != NULL, light);
	return r;
}

bool
cmd_card(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct asked all = {.question = q};
	size_t n;
	double *speed = card_speeds(args, q->entry->site, &n);
	bool ok = read_asked(s, &all, args, speed[n - 1], error);
	if (ok && s->document != NULL)
		s->document->one_page = true;
	if (ok)
		session_answer(s, card_answer(s, &all, speed, n));
	free(speed);
	asked_free(&all);
	return ok;
}
