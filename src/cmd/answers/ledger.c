/* The mass balance of an answer (core/answer/mass_balance.h) at two speeds,
 * class by class: what stays, what leaves and what comes, for people and for
 * programs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/answers/ledger.h"

#include <math.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/parse.h"
#include "core/answer/mass_balance.h"
#include "io/sitefile/units.h"

/* The site in use at two speeds with one feed. */
struct balance {
	struct session *s;
	const struct question *q;
	const struct entry *entry;
	const struct psd *feed;
	struct prediction p[2];
	struct ledger of[2];
};

/* "8/11.2", "0/0.063"; of class i. */
static char *
class_words(const struct psd *feed, size_t i)
{
	double finer = i + 1 < feed->n ? units_mm(feed->size[i + 1]) : 0;
	return xasprintf("%g/%g", finer, units_mm(feed->size[i]));
}

/* The cells behind the class's: three for each speed. */
static void
row_cells(struct answer *r, const double feed, double at[2][3], double change)
{
	answer_cells(r, "%.1f", 100 * feed);
	for (size_t k = 0; k < 2; k++)
		answer_cells(r, "%.1f %.1f %.1f", 100 * at[k][0],
		    100 * at[k][1], 100 * at[k][2]);
	answer_cells(r, "%.1f", 100 * change);
}

/* For people: what stays in a class, broken or not, what leaves it and what
 * comes, so that each row adds up to the feed's and the product's. */
static void
people_rows(struct answer *r, const struct balance *b)
{
	double sum[2][3] = {{0}}, feed = 0, all = 0;
	answer_columns(r, "class: on mm, feed_pct: feed %%");
	for (size_t k = 0; k < 2; k++) {
		double v = b->p[k].speed;
		answer_columns(r,
		    "stay_%zu: stay %g, left_%zu: left %g, "
		    "came_%zu: came %g",
		    k, v, k, v, k, v);
	}
	answer_columns(r, "change");
	for (size_t i = 0; i < b->feed->n; i++) {
		double at[2][3];
		for (size_t k = 0; k < 2; k++) {
			const struct ledger *l = &b->of[k];
			at[k][0] = l->unbroken[i] + l->within[i];
			at[k][1] = l->left[i];
			at[k][2] = l->arrived[i];
			for (size_t j = 0; j < 3; j++)
				sum[k][j] += at[k][j];
		}
		double change = b->of[1].product[i] - b->of[0].product[i];
		feed += b->of[0].feed[i];
		all += change;
		if (i + 1 < b->feed->n)
			answer_text(r, "%g", units_mm(b->feed->size[i + 1]));
		else
			answer_text(r, "pan");
		row_cells(r, b->of[0].feed[i], at, change);
	}
	answer_text(r, "sum");
	/* Not to be shown as -0.0. */
	row_cells(r, feed, sum, fabs(all) < 1e-9 ? 0 : all);
}

/* For programs: a row a speed and class. */
static void
program_rows(struct answer *r, const struct balance *b)
{
	answer_columns(r, "speed, from_mm, to_mm, feed_pct, unbroken_pct, "
			  "within_pct, left_pct, arrived_pct, product_pct");
	for (size_t k = 0; k < 2; k++) {
		const struct ledger *l = &b->of[k];
		for (size_t i = 0; i < l->n; i++)
			answer_cells(r, "%g %g %g %g %g %g %g %g %g",
			    b->p[k].speed,
			    i + 1 < l->n ? units_mm(b->feed->size[i + 1]) : 0,
			    units_mm(b->feed->size[i]), 100 * l->feed[i],
			    100 * l->unbroken[i], 100 * l->within[i],
			    100 * l->left[i], 100 * l->arrived[i],
			    100 * l->product[i]);
	}
}

static void
note_ways(struct answer *r, const struct balance *b)
{
	const struct ledger *a = &b->of[0], *z = &b->of[1];
	double more = z->broken - a->broken;
	/* Of what breaks less the largest fall. */
	bool faster = b->p[1].speed > b->p[0].speed;
	const struct ledger *low = faster ? a : z, *high = faster ? z : a;
	size_t out = ledger_most(high->left, low->left, a->n);
	size_t in = ledger_most(high->arrived, low->arrived, a->n);
	char *from = class_words(b->feed, out), *to = class_words(b->feed, in);
	if (fabs(more) < 5e-4)
		answer_note(r,
		    "From %g to %g m/s no more and no less of the feed breaks: "
		    "%.1f %%",
		    b->p[0].speed, b->p[1].speed, 100 * a->broken);
	else
		answer_note(r,
		    more > 0
			? N_("From %g to %g m/s %.1f points more of the feed "
			     "break (%.1f %%, then %.1f %%); most of it "
			     "leaves %s mm, and most arrives in %s mm")
			: N_("From %g to %g m/s %.1f points less of the feed "
			     "break (%.1f %%, then %.1f %%); most of what no "
			     "longer breaks stays in %s mm, and most is "
			     "missing in %s mm"),
		    b->p[0].speed, b->p[1].speed, 100 * fabs(more),
		    100 * a->broken, 100 * z->broken, from, to);
	fields_put(answer_fields(r), "broken_change_pct %g", 100 * more);
	free(from);
	free(to);
}

/* By how much the answer's change differs from the model's: the largest, and
 * where. */
static double
corrected_change(const struct balance *b, double *sieve)
{
	const struct prediction *p = b->p;
	double most = 0;
	for (size_t i = 0; i < p->product.n; i++) {
		double answer =
		    p[1].product.passing[i] - p[0].product.passing[i];
		double off = answer - (p[1].model[i] - p[0].model[i]);
		if (fabs(off) <= fabs(most))
			continue;
		most = off;
		*sieve = p->product.size[i];
	}
	return most;
}

static void
note_correction(struct answer *r, const struct balance *b)
{
	double sieve = 0, most = corrected_change(b, &sieve);
	bool corrected = b->p[0].low != NULL;
	answer_say(r, ANSWER_REMARK,
	    "On each sieve, in %% of the feed's mass: stay + left = feed, "
	    "stay + came = product; what breaks and is still in its class "
	    "stays");
	if (corrected)
		answer_say(r, ANSWER_REMARK,
		    "The ledger is of the model alone: what the runs show it "
		    "to leave out cannot be split by classes; with it the "
		    "passing changes by up to %.2f points otherwise (at %g mm)",
		    100 * fabs(most), units_mm(sieve));
	else
		answer_say(
		    r, ANSWER_REMARK, "The ledger is of the model alone");
	fields_put(answer_fields(r), "answer_differs_pct %g",
	    corrected ? 100 * most : NAN);
}

static void
put_shares(struct fields *o, const char *key, const double *share, size_t n)
{
	fields_numbers(o, key, share, n, units_pct);
}

static void
put_balance(struct fields *o, const struct balance *b)
{
	size_t n = b->feed->n;
	fields_numbers(o, "sieve_mm", b->feed->size, n, units_mm);
	put_shares(o, "feed_pct", b->of[0].feed, n);
	struct fields *list = fields_list(o, "at");
	for (size_t k = 0; k < 2; k++) {
		const struct ledger *l = &b->of[k];
		struct fields *at = fields_object(list, NULL);
		fields_put(at, "speed %g extrapolated %d broken_pct %g",
		    b->p[k].speed,
		    answers_extrapolates(b->entry, b->p[k].speed),
		    100 * l->broken);
		put_shares(at, "unbroken_pct", l->unbroken, n);
		put_shares(at, "within_pct", l->within, n);
		put_shares(at, "left_pct", l->left, n);
		put_shares(at, "arrived_pct", l->arrived, n);
		put_shares(at, "product_pct", l->product, n);
	}
}

static void
give(struct balance *b)
{
	const struct entry *entry = b->entry;
	struct answer *r = answers_new(entry->site, "why",
	    "where the mass goes, %g and %g m/s", b->p[0].speed, b->p[1].speed);
	people_rows(r, b);
	answer_for_programs(r);
	program_rows(r, b);
	note_ways(r, b);
	note_correction(r, b);
	for (size_t k = 0; k < 2; k++)
		if (answers_extrapolates(entry, b->p[k].speed))
			answer_say(r, ANSWER_WARNING,
			    "%g m/s is outside the training speeds",
			    b->p[k].speed);
	answer_note(r, "picture: plot psd speed=%g other=%g", b->p[0].speed,
	    b->p[1].speed);
	put_balance(answer_fields(r), b);
	answers_show_basis(
	    b->s, r, b->q, 0, false, light_worst(b->s, entry, b->p, 2));
	session_answer(b->s, r);
}

bool
balance_answer(struct session *s, const struct args *args,
    const struct question *q, struct error *error)
{
	const struct entry *entry = q->entry;
	double v[2] = {q->speed, 0};
	if (fraction_screens(&q->fraction))
		return error_set(error, ERROR_USAGE,
		    "why: expected no cut= with two speeds, where each class "
		    "of the product is told\n"
		    "leave out cut=, or one of the speeds");
	if (!value_number(args->operand[0], "m/s", &v[1]) || v[1] < 1 ||
	    v[1] > SITE_FASTEST)
		return error_set(error, ERROR_USAGE,
		    "why: expected speeds from 1 to %d m/s, got %s",
		    SITE_FASTEST, args->operand[0]);
	struct balance b = {.s = s,
	    .q = q,
	    .entry = entry,
	    .feed = site_feed(entry->site, q->feed)};
	for (size_t k = 0; k < 2; k++) {
		b.p[k] = forecast_whole(s, entry, v[k], q->feed);
		b.of[k] = ledger_new(
		    b.feed, &entry->params, outlook_settings(s, entry), v[k]);
	}
	give(&b);
	for (size_t k = 0; k < 2; k++) {
		prediction_free(&b.p[k]);
		ledger_free(&b.of[k]);
	}
	return true;
}
