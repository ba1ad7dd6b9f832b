/* why: explains in plain words why the numbers are as they are.  Each sentence
 * follows from numbers of the current site; those that do not apply are
 * omitted.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/table.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/feed.h"
#include "cmd/lang/parse.h"
#include "core/model/breakage.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"
#include "core/check/validate.h"
#include "core/answer/mass_balance.h"
#include "io/sitefile/units.h"

/* Limits beyond which a number is worth a sentence. */
static const double FEW = 0.05; /* share of the feed above the break size */
static const double MOST_BREAKS = 0.85; /* share of what could break */
static const double SAMPLING = 0.01;    /* smallest difference in passing that
				      * samples can show */
static const double STILL = 0.001;      /* change of passing by 1 m/s */

/* What to explain: the prediction for a site at a speed.  rpm: that speed in
 * rpm, in brackets, or "". */
struct explained {
	struct session *s;
	const struct question *q;
	const struct entry *entry;
	const struct psd *feed;
	struct prediction p;
	const char *rpm;
	struct answer *answer;
};

/* Returns the share of the feed above the break size, 0..1. */
static double
feed_share_above_break_size(const struct explained *a)
{
	double x = a->p.break_size;
	return isfinite(x) && x > 0 ? 1 - psd_passing(a->feed, x) : x <= 0;
}

static void
note_what_breaks(const struct explained *a)
{
	const struct prediction *p = &a->p;
	double can = feed_share_above_break_size(a), does = p->selected;
	if (p->no_daughters)
		answer_note(a->answer,
		    "The appearance function gives no progeny, so "
		    "nothing breaks and the feed is unchanged");
	else if (p->break_size >= a->feed->size[0])
		answer_note(a->answer,
		    "At %.4g m/s%s only particles of %.3g mm or more break, "
		    "and the feed has none above %g mm: the feed is unchanged",
		    p->speed, a->rpm, 1000 * p->break_size,
		    units_m_to_mm(a->feed->size[0]));
	else if (p->break_size < ANSWERS_NO_SIZE)
		answer_note(a->answer,
		    "With %s every size can break; %.0f %% of the feed does at "
		    "%.4g m/s%s",
		    params_value_by_name(&a->entry->params, "e0_min") <= 0
			? "e0_min = 0"
			: tr("so low an alpha"),
		    100 * does, p->speed, a->rpm);
	else
		answer_note(a->answer,
		    "At %.4g m/s%s an impact has %.0f J/kg, which breaks "
		    "particles of %.3g mm or more; %.0f %% of the feed is that "
		    "coarse, and %.0f %% of the feed breaks",
		    p->speed, a->rpm, p->energy, 1000 * p->break_size,
		    100 * can, 100 * does);
}

static void
note_if_little_breaks(const struct explained *a)
{
	const struct prediction *p = &a->p;
	double can = feed_share_above_break_size(a), does = p->selected;
	if (p->no_daughters)
		return;
	double moved = psd_rms_difference(
	    p->feed.passing, p->product.passing, p->feed.n, NULL);
	if (can > 0 && can < FEW)
		answer_note(a->answer,
		    "So little of the feed is above the break size that the "
		    "product can hardly differ from the feed");
	else if (can >= FEW && does < MOST_BREAKS * can)
		answer_note(a->answer,
		    "Of the feed coarse enough to break, only %.0f %% does: "
		    "f_mat (%.3g) is low, so many particles just above the "
		    "threshold survive",
		    100 * does / can,
		    params_value_by_name(&a->entry->params, "f_mat"));
	if (p->break_size < a->feed->size[0] && moved < SAMPLING)
		answer_note(a->answer,
		    "Product and feed differ by %.2f points (RMSE), less than "
		    "two samples from the same belt differ",
		    100 * moved);
}

/* Says if a change of speed by 1 m/s hardly matters. */
static void
note_if_speed_hardly_matters(const struct explained *a)
{
	double v = a->p.speed, n = (double)a->p.product.n, sum = 0;
	struct prediction fast =
	    forecast_whole_product(a->s, a->entry, v + 1, a->p.feed_run);
	for (size_t i = 0; i < a->p.product.n; i++)
		sum +=
		    pow(fast.product.passing[i] - a->p.product.passing[i], 2);
	prediction_free(&fast);
	if (sqrt(sum / n) < STILL && a->p.break_size < a->feed->size[0])
		answer_note(a->answer,
		    "The speed hardly matters here: 1 m/s more changes the "
		    "product by %.2f points (RMSE)",
		    100 * sqrt(sum / n));
	if (a->s->set.model.method == METHOD_CLASSES)
		answer_note(a->answer,
		    "The method classes gives each size class one size, so the "
		    "product does not change while the break size moves within "
		    "a class, and then jumps");
}

/* If the question has a fraction, says how much of the product is in it, and
 * how a faster rotor changes that. */
static void
note_share_in_fraction(const struct explained *a)
{
	const struct quantity share = {
	    .kind = QUANTITY_SHARE, .fraction = a->q->fraction};
	double v = a->p.speed;
	if (!fraction_is_screened(&share.fraction))
		return;
	struct prediction part = forecast_product(a->s, a->q, v);
	screened_note_share(a->answer, &part);
	screened_put_fraction_fields(answer_json_fields(a->answer), &part);
	struct forecast *slow = forecast_open(a->s, a->q, &share, 1);
	struct forecast *fast = forecast_open(a->s, a->q, &share, 1);
	forecast_set_speed(slow, v);
	forecast_set_speed(fast, v + 1);
	struct figure more = forecast_difference(slow, fast, 0);
	FREED char *band = quantities_band_text(units_fraction_to_pct(more.low),
	    units_fraction_to_pct(more.high), 2);
	answer_note(a->answer,
	    "1 m/s more changes that share by %+.2f points%s",
	    units_fraction_to_pct(more.value), band);
	forecast_close(slow);
	forecast_close(fast);
	prediction_free(&part);
}

static void
note_whether_in_training_range(const struct explained *a)
{
	const struct entry *entry = a->entry;
	double slow, fast, v = a->p.speed;
	if (!origin_training_speed_range(entry, &slow, &fast)) {
		answer_add_sentence(a->answer, ANSWER_WARNING,
		    "The training speeds of these parameters are not known");
		return;
	}
	FREED char *speeds = answers_training_range_text(entry, slow, fast);
	if (!answers_is_speed_extrapolated(entry, v)) {
		answer_note(a->answer, "%.4g m/s%s is within the %s", v, a->rpm,
		    speeds);
		return;
	}
	double near = v > fast ? fast : slow;
	double more =
	    specific_energy_at_speed(v) / specific_energy_at_speed(near) - 1;
	answer_add_sentence(a->answer, ANSWER_WARNING,
	    more > 0 ? N_("%.4g m/s%s is outside the %s: an impact has %.1f %% "
			  "more energy than at %g m/s, and no measurement "
			  "shows the effect")
		     : N_("%.4g m/s%s is outside the %s: an impact has %.1f %% "
			  "less energy than at %g m/s, and no measurement "
			  "shows the effect"),
	    v, a->rpm, speeds, 100 * fabs(more), near);
}

/* What the user can do about each cause; NULL if the reason says it itself. */
static const char *const REMEDY[] = {
    [TRUST_PATTERN] =
	N_("look at 'check' and 'plot residuals' for a sample that is off; if "
	   "all samples are right, 'league' compares other models"),
    [TRUST_HOLDOUT] = N_("sample that speed again; if the sample was right, "
			 "'league' compares other models"),
    [TRUST_BEYOND] = N_("take a belt cut at this speed, or as near to it as "
			"the crusher goes, 'add' it and calibrate again"),
    [TRUST_SLOW] = N_("take a belt cut slower than all others, 'add' it and "
		      "calibrate again"),
    [TRUST_FEED] = N_("take a belt cut with this feed, 'add' it and calibrate "
		      "again"),
    [TRUST_BOUND] = N_("widen it with 'params bounds', if the rock allows, and "
		       "calibrate again"),
    [TRUST_MACHINE] = N_("take a belt cut on that machine and 'load' it as a "
			 "site of its own"),
    [TRUST_ORIGIN] = N_("calibrate on products of this site, measured at two "
			"speeds or more"),
};

/* Gives reason i and, after the last reason with its cause, what to do about
 * it. */
static void
note_trust_reason(const struct explained *a, const struct trust *t, size_t i)
{
	enum trust_cause cause = t->reason[i].cause;
	answer_note(a->answer, "  %s: %s", tr(LIGHT_NAME[t->reason[i].light]),
	    t->reason[i].text);
	for (size_t k = i + 1; k < t->n; k++)
		if (t->reason[k].cause == cause)
			return;
	if (cause < ARRAY_LEN(REMEDY) && REMEDY[cause] != NULL)
		answer_note(a->answer, "  what to do: %s", tr(REMEDY[cause]));
}

/* If the light is green, says so first, and why. */
static void
explain_if_trust_is_green(const struct explained *a, const struct trust *t)
{
	const struct evidence *e =
	    trust_evidence_of_calibration(a->s, a->entry);
	if (t->n > 0)
		return;
	answer_note(a->answer,
	    "Trust is green: nothing to worry about in the answer at %.4g "
	    "m/s%s",
	    a->p.speed, a->rpm);
	if (t->speed_sd > 0)
		answer_note(a->answer,
		    "The band allows for tip speeds that are off by %g %% "
		    "('set speed_sd'); if they are off by more, the true "
		    "product lies outside it more often than it says",
		    100 * t->speed_sd);
	if (t->remarks > 0)
		answer_note(a->answer,
		    "It lies between the measured speeds, where the "
		    "measurements correct what the model misses; beyond them "
		    "the remarks below are reasons for amber");
	else if (e != NULL)
		answer_note(a->answer,
		    "The residuals look like sampling errors: over all runs "
		    "they are %.2f points (RMS, less what other parameters "
		    "would explain), %.1f times the usual size, and those of "
		    "neighbouring sieves are not alike; %zu passings for %zu "
		    "parameters",
		    100 * e->unexplained, sqrt(e->size), e->cells,
		    e->parameters);
}

/* States the light, unless it is green, with its reasons and the remarks, and
 * puts it into the fields. */
static void
note_trust_light(const struct explained *a, const struct trust *t)
{
	if (t->n > 0)
		answer_add_sentence(a->answer,
		    t->light == LIGHT_RED ? ANSWER_WARNING : ANSWER_PLAIN,
		    t->light == LIGHT_RED
			? N_("Trust is red: do not rely on this answer")
			: N_("Trust is amber"));
	for (size_t i = 0; i < t->n; i++)
		note_trust_reason(a, t, i);
	for (size_t i = 0; i < t->remarks; i++)
		answer_note(a->answer, "  remark: %s", t->remark[i]);
	trust_put_fields(answer_json_fields(a->answer), t);
}

static void
note_origin_of_parameters(const struct explained *a, bool green)
{
	const struct entry *entry = a->entry;
	const struct fit *fit = &entry->fit;
	if (!entry->has_fit) {
		FREED char *details =
		    origin_training_speeds_text(entry->origin);
		bool own = entry->origin->from[0] == '\0';
		answer_note(a->answer,
		    "The parameters were %s%s%s%s, not calibrated on this "
		    "site's runs",
		    origin_of_params_text(entry), own ? "" : " (",
		    own ? "" : details, own ? "" : ")");
		return;
	}
	FREED char *flat = xstrdup("");
	const struct breakage *of = breakage_model_of_params(&fit->params);
	for (size_t j = 0; j < of->n; j++)
		if (fit_is_param_poorly_determined(fit, j))
			xappend_to_list(
			    &flat, ", ", "%s", of->parameter[j].name);
	xend_list_with(&flat, tr(" and "));
	if (flat[0] != '\0')
		answer_note(a->answer,
		    green
			? N_("The data do not determine %s well: very "
			     "different values, changed together, raise the "
			     "misfit by only 10 %%; that is of no consequence "
			     "to this answer")
			: N_("The data do not determine %s well: very "
			     "different values, changed together, raise the "
			     "misfit by only 10 %%; rely on the curves, not "
			     "on these values"),
		    flat);
}

/* Compares with a measured product at exactly this speed that was not used for
 * training. */
static void
note_held_out_difference(const struct explained *a)
{
	const struct site *site = a->entry->site;
	size_t r = site_run_at_speed(site, a->p.speed);
	for (size_t first = r; site->with[0] == '\0' && r < site->n_run &&
			       site->run[r].speed == site->run[first].speed;
	     r++) {
		if (a->entry->train[r] ||
		    misfit_count_covered_sieves(&site->run[r]) == 0)
			continue;
		struct validation v = validate_run(site, r, a->entry->train,
		    &a->entry->params, a->s->set.model);
		FREED char *rpm =
		    rotor_speed_rpm_text(site->rotor, v.speed, NAN);
		answer_note(a->answer,
		    validation_is_interpolation_better(&v)
			? N_("The held-out product measured at %g m/s%s%s "
			     "differs from the prediction by %.2f points on "
			     "average; a straight line through the training "
			     "products is closer")
			: N_("The held-out product measured at %g m/s%s%s "
			     "differs from the prediction by %.2f points on "
			     "average"),
		    v.speed, site->run[r].repeat, rpm,
		    100 * v.rmse[VALIDATE_MODEL]);
	}
}

/* Says what the site file states about its data. */
static void
note_data_provenance(const struct explained *a)
{
	FREED char *from = site_provenance_first_clause(a->entry->site, "");
	if (strcmp(site_data_kind(from), "not stated") == 0)
		answer_note(a->answer,
		    "The site file does not state where its data are from");
	else
		answer_note(a->answer,
		    site_is_data_made_up(from)
			? N_("The data were not measured at a plant: %s")
			: N_("The site file states the provenance of its data: "
			     "%s"),
		    from);
}

/* The site in use at two speeds with one feed. */
struct mass_change {
	struct session *s;
	const struct question *q;
	const struct psd *feed;
	struct prediction p[2];
	struct mass_balance of[2];
};

/* Returns "8/11.2" or "0/0.063" for class i. */
static char *
size_class_text(const struct psd *feed, size_t i)
{
	double finer = i + 1 < feed->n ? units_m_to_mm(feed->size[i + 1]) : 0;
	return xasprintf("%g/%g", finer, units_m_to_mm(feed->size[i]));
}

/* Adds the cells to the right of the class: the feed, three for each speed, and
 * the change. */
static void
add_mass_balance_cells(
    struct answer *r, const double feed, double at[2][3], double change)
{
	answer_add_cells(r, "%.1f", 100 * feed);
	for (size_t k = 0; k < 2; k++)
		answer_add_cells(r, "%.1f %.1f %.1f", 100 * at[k][0],
		    100 * at[k][1], 100 * at[k][2]);
	answer_add_cells(r, "%.1f", 100 * change);
}

/* For people: what stays in each class, broken or not, what leaves it and what
 * comes in.  stay + left is the feed, stay + came the product. */
static void
add_size_class_rows_for_people(struct answer *r, const struct mass_change *b)
{
	double sum[2][3] = {{0}}, feed = 0, all = 0;
	answer_add_columns(r, "class: on mm, feed_pct: feed %%");
	for (size_t k = 0; k < 2; k++) {
		double v = b->p[k].speed;
		answer_add_columns(r,
		    "stay_%zu: stay %g, left_%zu: left %g, came_%zu: came %g",
		    k, v, k, v, k, v);
	}
	answer_add_columns(r, "change");
	for (size_t i = 0; i < b->feed->n; i++) {
		double at[2][3];
		for (size_t k = 0; k < 2; k++) {
			const struct mass_balance *l = &b->of[k];
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
			answer_add_text_cell(
			    r, "%g", units_m_to_mm(b->feed->size[i + 1]));
		else
			answer_add_text_cell(r, "pan");
		add_mass_balance_cells(r, b->of[0].feed[i], at, change);
	}
	answer_add_text_cell(r, "sum");
	/* A sum of -0.0 is shown as 0.0. */
	add_mass_balance_cells(r, feed, sum, fabs(all) < 1e-9 ? 0 : all);
}

/* For programs: a row for each speed and class. */
static void
add_size_class_rows_for_programs(struct answer *r, const struct mass_change *b)
{
	answer_add_columns(r, "speed, from_mm, to_mm, feed_pct, unbroken_pct, "
			      "within_pct, left_pct, arrived_pct, product_pct");
	for (size_t k = 0; k < 2; k++) {
		const struct mass_balance *l = &b->of[k];
		for (size_t i = 0; i < l->n; i++)
			answer_add_cells(r, "%g %g %g %g %g %g %g %g %g",
			    b->p[k].speed,
			    i + 1 < l->n ? units_m_to_mm(b->feed->size[i + 1])
					 : 0,
			    units_m_to_mm(b->feed->size[i]), 100 * l->feed[i],
			    100 * l->unbroken[i], 100 * l->within[i],
			    100 * l->left[i], 100 * l->arrived[i],
			    100 * l->product[i]);
	}
}

static void
note_where_mass_goes(struct answer *r, const struct mass_change *b)
{
	const struct mass_balance *a = &b->of[0], *z = &b->of[1];
	double more = z->broken - a->broken;
	/* The classes where the higher speed adds most to what leaves or
	 * arrives. */
	bool faster = b->p[1].speed > b->p[0].speed;
	const struct mass_balance *low = faster ? a : z, *high = faster ? z : a;
	size_t out = mass_balance_largest_class(high->left, low->left, a->n);
	size_t in =
	    mass_balance_largest_class(high->arrived, low->arrived, a->n);
	FREED char *from = size_class_text(b->feed, out),
		   *to = size_class_text(b->feed, in);
	FREED char *rpm = rotor_speed_rpm_text(
	    b->q->entry->site->rotor, b->p[0].speed, b->p[1].speed);
	if (fabs(more) < 5e-4)
		answer_note(r,
		    "From %g to %g m/s%s the same share of the feed breaks: "
		    "%.1f %%",
		    b->p[0].speed, b->p[1].speed, rpm, 100 * a->broken);
	else
		answer_note(r,
		    more > 0
			? N_("From %g to %g m/s%s %.1f points more of the feed "
			     "break (%.1f %%, then %.1f %%); most of it "
			     "leaves %s mm, and most arrives in %s mm")
			: N_("From %g to %g m/s%s %.1f points less of the feed "
			     "break (%.1f %%, then %.1f %%); most of what no "
			     "longer breaks stays in %s mm, and most is "
			     "missing in %s mm"),
		    b->p[0].speed, b->p[1].speed, rpm, 100 * fabs(more),
		    100 * a->broken, 100 * z->broken, from, to);
	fields_put_values(
	    answer_json_fields(r), "broken_change_pct %g", 100 * more);
}

/* Returns the largest difference, with its sign, between the change of the
 * answer and that of the model alone, and sets *sieve to its sieve, m. */
static double
largest_change_not_in_model(const struct mass_change *b, double *sieve)
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
note_balance_ignores_correction(struct answer *r, const struct mass_change *b)
{
	double sieve = 0, most = largest_change_not_in_model(b, &sieve);
	bool corrected = b->p[0].low != NULL;
	answer_add_sentence(r, ANSWER_REMARK,
	    "On each sieve, in %% of the feed's mass: stay + left = feed, stay "
	    "+ came = product; what breaks and is still in its class stays");
	if (corrected)
		answer_add_sentence(r, ANSWER_REMARK,
		    "The mass balance is that of the model alone, because its "
		    "correction cannot be divided among classes; in the "
		    "corrected answer, the change in passing differs by up to "
		    "%.2f points (at %g mm)",
		    100 * fabs(most), units_m_to_mm(sieve));
	else
		answer_add_sentence(
		    r, ANSWER_REMARK, "The mass balance is of the model alone");
	fields_put_values(answer_json_fields(r), "answer_differs_pct %g",
	    corrected ? 100 * most : NAN);
}

static void
put_mass_balance_fields(struct fields *o, const struct mass_change *b)
{
	size_t n = b->feed->n;
	fields_put_numbers(o, "sieve_mm", b->feed->size, n, units_m_to_mm);
	fields_put_numbers(
	    o, "feed_pct", b->of[0].feed, n, units_fraction_to_pct);
	struct fields *list = fields_add_list(o, "at");
	for (size_t k = 0; k < 2; k++) {
		const struct mass_balance *l = &b->of[k];
		struct fields *at = fields_add_object(list, NULL);
		fields_put_values(at, "speed %g extrapolated %d broken_pct %g",
		    b->p[k].speed,
		    answers_is_speed_extrapolated(b->q->entry, b->p[k].speed),
		    100 * l->broken);
		fields_put_numbers(
		    at, "unbroken_pct", l->unbroken, n, units_fraction_to_pct);
		fields_put_numbers(
		    at, "within_pct", l->within, n, units_fraction_to_pct);
		fields_put_numbers(
		    at, "left_pct", l->left, n, units_fraction_to_pct);
		fields_put_numbers(
		    at, "arrived_pct", l->arrived, n, units_fraction_to_pct);
		fields_put_numbers(
		    at, "product_pct", l->product, n, units_fraction_to_pct);
	}
}

static void
show_mass_balance(struct mass_change *b)
{
	const struct entry *entry = b->q->entry;
	FREED char *rpm = rotor_speed_rpm_text(
	    entry->site->rotor, b->p[0].speed, b->p[1].speed);
	struct answer *r = answer_new_about_site(entry->site, "why",
	    "where the mass goes, %g and %g m/s%s", b->p[0].speed,
	    b->p[1].speed, rpm);
	add_size_class_rows_for_people(r, b);
	answer_begin_table_for_programs(r);
	add_size_class_rows_for_programs(r, b);
	note_where_mass_goes(r, b);
	note_balance_ignores_correction(r, b);
	for (size_t k = 0; k < 2; k++) {
		double v = b->p[k].speed;
		FREED char *own =
		    rotor_speed_rpm_text(entry->site->rotor, v, NAN);
		if (answers_is_speed_extrapolated(entry, v))
			answer_add_sentence(r, ANSWER_WARNING,
			    "%g m/s%s is outside the training speeds", v, own);
	}
	answer_note(r, "picture: plot psd speed=%g other=%g", b->p[0].speed,
	    b->p[1].speed);
	put_mass_balance_fields(answer_json_fields(r), b);
	answers_note_basis_and_trust(b->s, r, b->q, 0, false,
	    trust_worst_of_predictions(b->s, entry, b->p, 2));
	session_show_answer(b->s, r);
}

/* Answers `why 69 79`, whose second speed is an operand. */
static bool
explain_change_between_speeds(struct session *s, const struct args *args,
    const struct question *q, struct error *error)
{
	const struct entry *entry = q->entry;
	double v[2] = {q->speed, 0};
	if (fraction_is_screened(&q->fraction))
		return error_set(error, ERROR_USAGE,
		    "why: expected no cut= with two speeds, which show each "
		    "class of the product\nleave out cut=, or one of the "
		    "speeds");
	if (!value_parse_number(args->operand[0], "m/s", &v[1]) || v[1] < 1 ||
	    v[1] > SITE_FASTEST)
		return error_set(error, ERROR_USAGE,
		    "why: expected speeds from 1 to %d m/s, got %s",
		    SITE_FASTEST, args->operand[0]);
	struct mass_change b = {.s = s, .q = q, .feed = question_feed(q)};
	for (size_t k = 0; k < 2; k++) {
		b.p[k] = forecast_whole_product(s, entry, v[k], q->feed);
		b.of[k] = mass_balance_new(b.feed, &entry->params,
		    model_settings_with_scenario(s, entry), v[k]);
	}
	show_mass_balance(&b);
	for (size_t k = 0; k < 2; k++) {
		prediction_free(&b.p[k]);
		mass_balance_free(&b.of[k]);
	}
	return true;
}

bool
cmd_why(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	if (args->n_operand > 0)
		return explain_change_between_speeds(s, args, q, error);
	question_use_last_speed_and_feed(s, args, q);
	if (!screened_check_feed_covers(q, error))
		return false;
	const struct entry *entry = q->entry;
	double v = q->speed;
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, v, NAN);
	const char *by = q->speed_given ? NULL : s->last_asked.found_by;
	struct explained a = {.s = s,
	    .q = q,
	    .entry = entry,
	    .feed = question_feed(q),
	    .p = forecast_whole_product(s, entry, v, q->feed),
	    .rpm = rpm,
	    .answer = answer_new_about_site(entry->site, "why",
		by != NULL
		    ? N_("why, at %.4g m/s%s, the speed that '%s' showed")
		    : N_("why, at %.4g m/s%s"),
		v, rpm, by)};
	struct trust trust = trust_in_answer_or_fit(s, entry, &a.p);
	fields_put_values(answer_json_fields(a.answer), "speed %g", v);
	bool breaks = !fit_has_no_breakage(entry_without_scenario(entry));
	answers_warn_if_nothing_breaks(a.answer, entry);
	explain_if_trust_is_green(&a, &trust);
	if (breaks) {
		note_what_breaks(&a);
		note_if_little_breaks(&a);
		note_if_speed_hardly_matters(&a);
	}
	note_share_in_fraction(&a);
	note_whether_in_training_range(&a);
	if (breaks)
		note_held_out_difference(&a);
	note_trust_light(&a, &trust);
	if (breaks)
		note_origin_of_parameters(&a, trust.light == LIGHT_GREEN);
	note_data_provenance(&a);
	feed_note_how_to_set_top_size(a.answer, entry->site);
	feed_add_note_to_answer(a.answer, entry->site, q->feed, NULL, 0);
	if (breaks && a.p.low != NULL)
		answer_note(a.answer,
		    "'advise' names the sample that would narrow the band "
		    "most");
	trust_free(&trust);
	prediction_free(&a.p);
	return session_show_answer(s, a.answer);
}
