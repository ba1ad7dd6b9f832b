/* Functions shared by commands that answer questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/answers.h"

#include <math.h>
#include <stdarg.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/energies.h"
#include "core/numeric/elementary.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/quantity_words.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/units.h"

const struct product_size ANSWERS_SIZE[ANSWERS_SIZES] = {
    {"p20_mm", "p20_range_mm", N_("P20 mm")},
    {"p50_mm", "p50_range_mm", N_("P50 mm")},
    {"p80_mm", "p80_range_mm", N_("P80 mm")},
    {"break_mm", "break_range_mm", N_("break size mm")}};

void
answers_put_feed_and_machine(struct answer *r, const struct site *site)
{
	struct fields *o = answer_json_fields(r);
	if (site->feed_from[0] != '\0') {
		fields_put_values(o, "feed %s", site->feed_from);
		answer_repeat_fields_in_rows(r, "feed");
	}
	if (site->with[0] != '\0')
		fields_put_values(o, "with %s", site->with);
	answer_repeat_fields_in_rows(r, "with");
}

struct answer *
answer_new_about_site(
    const struct site *site, const char *command, const char *format, ...)
{
	struct answer *r = answer_new(command);
	va_list ap;
	va_start(ap, format);
	FREED char *title = xvasprintf(tr(format), ap),
		   *label = session_site_label(site);
	va_end(ap);
	answer_set_title(r, "%s: %s", label, title);
	answer_set_site(r, site->name, site->provenance);
	answers_put_feed_and_machine(r, site);
	return r;
}

bool
answers_require_params(
    const struct session *s, const struct entry *entry, struct error *error)
{
	if (entry->has_params)
		return fit_check_settings_allow_model(
		    &s->set.model, entry->params.breakage, error);
	return error_set(error, ERROR_USAGE, "%s has no parameters yet\n%s",
	    entry->site->name,
	    site_count_products(entry->site) > 0
		? tr("run 'calibrate', or supply them with 'recall' or 'params "
		     "set'")
		: tr("run 'guess' for an estimate, or 'params use SITE' for "
		     "another site's parameters: there is no product to "
		     "calibrate on"));
}

bool
answers_require_params_current_site(struct session *s, struct error *error)
{
	return answers_require_params(s, session_current_site_entry(s), error);
}

bool
answers_best_params_so_far(
    const struct session *s, const struct entry *entry, struct params *params)
{
	const struct entry *fitting = session_entry_being_fitted(s);
	if (fitting == NULL || fitting != entry_without_scenario(entry))
		return false;
	struct calibrate_status st = calibration_status(s->job.calibration);
	if (st.generation > 0)
		*params = st.params;
	return st.generation > 0;
}

bool
answers_is_speed_extrapolated(const struct entry *entry, double speed)
{
	double slowest, fastest;
	return !origin_training_speed_range(entry, &slowest, &fastest) ||
	       speed < slowest - 1e-9 || speed > fastest + 1e-9;
}

double
answers_breakage_at_ratio(
    const struct breaker *b, double u, const struct site *site)
{
	double log_u = el_log(u), log_x = el_log(site->run[0].feed.size[0]);
	const struct breakage *of = b->model;
	if (u >= 1)
		return 1;
	return of->finer(b, log_u, NULL) *
	       (of->at_size != NULL ? of->at_size(b, log_x + log_u, NULL) : 1);
}

double
answers_default_speed(const struct entry *entry)
{
	const double usual = 74;
	double from, to, speed = 0, middle = site_middle_speed(entry->site);
	for (size_t r = 0; r < entry->site->n_run; r++) {
		const struct run *run = &entry->site->run[r];
		if (!entry->train[r] && run->product.n > 0 &&
		    fabs(run->speed - middle) < fabs(speed - middle))
			speed = run->speed;
	}
	if (speed > 0)
		return speed;
	site_default_speed_range(entry->site, &from, &to);
	return usual >= from && usual <= to ? usual : middle;
}

size_t
answers_default_sieve(const struct psd *product)
{
	size_t middle = 0;
	for (size_t i = 0; i < product->n; i++) {
		if (fabs(product->size[i] - 2e-3) < 1e-9)
			return i;
		if (fabs(product->passing[i] - 0.5) <
		    fabs(product->passing[middle] - 0.5))
			middle = i;
	}
	return middle;
}

struct quantity
answers_default_passing_quantity(const struct psd *product)
{
	return (struct quantity){.kind = QUANTITY_PASSING,
	    .x = product->size[answers_default_sieve(product)]};
}

char *
speed_text_in_typed_unit(const struct site *site, double speed)
{
	double rotor = site->rotor;
	double rpm = rotor > 0 ? round(rotor_speed_to_rpm(speed, rotor)) : 0;
	bool same =
	    fabs(speed_in_unit_to_mps(rpm, SPEED_RPM, rotor) - speed) < 1e-6;
	return same ? xasprintf("%g rpm", rpm) : xasprintf("%g", speed);
}

bool
answers_is_sheet_in_rpm(const struct site *site)
{
	bool tenths = true;
	for (size_t r = 0; site != NULL && r < site->n_run; r++) {
		double v = site->run[r].speed;
		FREED char *typed = speed_text_in_typed_unit(site, v);
		if (v > 0 && strstr(typed, "rpm") == NULL)
			return false;
		tenths = tenths && fabs(10 * v - round(10 * v)) < 1e-6;
	}
	return site != NULL && site->rotor > 0 && !tenths;
}

double
answers_speed_in_sheet_unit(const struct site *site, double speed)
{
	return answers_is_sheet_in_rpm(site)
		   ? round(rotor_speed_to_rpm(speed, site->rotor))
		   : speed;
}

const char *
answers_speed_unit(const struct site *site)
{
	return answers_is_sheet_in_rpm(site) ? tr("rpm") : "m/s";
}

char *
answers_speed_text(const struct site *site, double speed, int decimals)
{
	double number = answers_speed_in_sheet_unit(site, speed);
	if (answers_is_sheet_in_rpm(site))
		return xasprintf(tr("%.0f rpm"), number);
	return decimals < 0 ? xasprintf("%g m/s", number)
			    : xasprintf("%.*f m/s", decimals, number);
}

char *
answers_speed_range_words(
    const struct site *site, double from, double to, bool brief)
{
	double low = answers_speed_in_sheet_unit(site, from),
	       high = answers_speed_in_sheet_unit(site, to);
	const char *unit = answers_speed_unit(site);
	return brief ? xasprintf("%g..%g %s", low, high, unit)
		     : xasprintf(tr("%g to %g %s"), low, high, unit);
}

/* Returns the multiples between two values of one of the steps [n_step]: the
 * smallest one that gives at most `most` of them, [*n]. */
static double *
list_multiples_of_step(double from, double to, const double *steps,
    size_t n_step, size_t most, size_t *n)
{
	size_t i = 0;
	while (i + 1 < n_step && (to - from) / steps[i] >= (double)most)
		i++;
	double *at = xcalloc_doubles(most), first = ceil(from / steps[i]);
	for (*n = 0; *n < most && (first + (double)*n) * steps[i] <= to; (*n)++)
		at[*n] = (first + (double)*n) * steps[i];
	return at;
}

double *
answers_list_round_rpm_speeds(
    const struct site *site, double from, double to, size_t most, size_t *n)
{
	static const double STEPS[] = {
	    5, 10, 20, 25, 50, 100, 200, 500, 1000, 2000, 5000, 10000};
	double rotor = site->rotor;
	if (!answers_is_sheet_in_rpm(site))
		return NULL;
	double *speed = list_multiples_of_step(rotor_speed_to_rpm(from, rotor),
	    rotor_speed_to_rpm(to, rotor), STEPS, ARRAY_LEN(STEPS), most, n);
	for (size_t i = 0; i < *n; i++)
		speed[i] = speed_in_unit_to_mps(speed[i], SPEED_RPM, rotor);
	return speed;
}

double *
answers_list_few_round_speeds(
    const struct session *s, const struct site *site, size_t *n)
{
	enum { MOST = 7 };
	static const double STEPS[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100};
	double from, to;
	settings_default_speed_range(&s->set, site, &from, &to);
	double *speed = answers_list_round_rpm_speeds(site, from, to, MOST, n);
	return speed != NULL ? speed
			     : list_multiples_of_step(
				   from, to, STEPS, ARRAY_LEN(STEPS), MOST, n);
}

void
answers_store_newest_prediction(struct session *s, const struct entry *entry,
    const struct params *params, const struct prediction *p)
{
	struct answer *answer = answer_new("predict");
	answers_put_prediction_fields(
	    s, answer_json_fields(answer), entry, params, p);
	session_store_newest_answer(s, answer);
	session_set_last_question(s, p->speed, NULL);
}

static char *
size_beyond_sieves_text(const struct psd *psd, double passing)
{
	bool fine = psd->passing[psd->n - 1] >= passing;
	return xasprintf("%s %g", fine ? tr("below") : tr("above"),
	    units_m_to_mm(psd->size[fine ? psd->n - 1 : 0]));
}

double
answers_product_size_mm(const struct prediction *p, size_t i)
{
	return 1000 * p->size[i];
}

void
answers_add_size_cell(struct answer *r, const struct prediction *p, size_t i)
{
	FREED char *words = i == ANSWERS_BREAK ? xstrdup(tr("none"))
					       : size_beyond_sieves_text(
						     &p->curve, PSD_PASSING[i]);
	answer_set_missing_text(r, words);
	answer_add_cells(r, "%.2f", answers_product_size_mm(p, i));
}

/* Appends "P50 2.81", or "P20 below 0.063 mm", to a list; only the first has
 * its unit.  If there is a range, it follows: " (2.75 to 2.90)".  Its lower end
 * may be below the finest sieve. */
static void
append_p_size_with_range(
    char **list, const struct psd *psd, size_t i, const double *range)
{
	double x = psd_size_at_passing(psd, PSD_PASSING[i]);
	FREED char *size = isfinite(x)
			       ? xasprintf("%.2f", 1000 * x)
			       : size_beyond_sieves_text(psd, PSD_PASSING[i]);
	bool first = *list[0] == '\0';
	xappend_to_list(list, ", ", "%s %s%s", PSD_NAME[i], size,
	    first || size[0] > '9' ? " mm" : "");
	if (!isfinite(range[1]))
		return;
	if (isfinite(range[0]))
		xappend(list, tr(" (%.2f to %.2f)"), 1000 * range[0],
		    1000 * range[1]);
	else
		xappend(list, tr(" (below %g to %.2f)"),
		    units_m_to_mm(psd->size[psd->n - 1]), 1000 * range[1]);
}

void
answers_note_p_sizes(struct answer *r, const struct prediction *p)
{
	FREED char *sizes = xstrdup("");
	for (size_t i = 0; i < PSD_SIZES; i++)
		append_p_size_with_range(&sizes, &p->curve, i, p->range[i]);
	answer_note(r, "%s", sizes);
}

/* Notes the name of the model, unless it is the paper's. */
static void
note_model_if_not_of_paper(
    const struct session *s, struct answer *r, const struct entry *entry)
{
	size_t own = entry->params.breakage, set = s->set.model.breakage;
	if (!entry->has_params)
		return;
	if (own != set)
		answer_add_sentence(r, ANSWER_REMARK,
		    "these parameters belong to model %s; %s is set: "
		    "'calibrate' finds its own",
		    BREAKAGES[own]->name, BREAKAGES[set]->name);
	else if (own > 0)
		answer_add_sentence(
		    r, ANSWER_REMARK, "model: %s", BREAKAGES[own]->name);
}

char *
answers_training_range_text(
    const struct entry *entry, double slowest, double fastest)
{
	bool trained = origin_has_training_speeds(entry),
	     several = slowest < fastest;
	FREED char *rpm =
	    rotor_speed_rpm_text(site_run_rotor_diameter(entry->site), slowest,
		several ? fastest : NAN);
	if (several)
		return xasprintf(trained
				     ? tr("training speeds, %g to %g m/s%s")
				     : tr("measured speeds, %g to %g m/s%s"),
		    slowest, fastest, rpm);
	return xasprintf(trained ? tr("one training speed, %g m/s%s")
				 : tr("one measured speed, %g m/s%s"),
	    slowest, rpm);
}

/* Notes what the sheet of another feed leaves open. */
static void
note_data_missing_for_other_feed(struct answer *r, const struct entry *entry)
{
	const struct site *site = entry->site;
	const struct psd *feed = &site->run[site->n_run - 1].feed;
	size_t n;
	FREED double *sieve = site_all_sieves(site, &n);
	if (!psd_covers_size(feed, sieve[n - 1]))
		answer_add_sentence(r, ANSWER_REMARK,
		    "nothing is known below %g mm: the feed was not sieved "
		    "that fine",
		    units_m_to_mm(feed->size[feed->n - 1]));
	if (entry->scenario->rock[0] == '\0' && site->rock[0] != '\0')
		answer_add_sentence(r, ANSWER_REMARK,
		    "rock of the feed not stated; that of the site assumed "
		    "(%s)",
		    site->rock);
}

/* Notes what neither title nor light say about another feed or machine. */
static void
note_other_feed_or_machine(struct answer *r, const struct entry *entry)
{
	const struct scenario *w = entry->scenario;
	if (w == NULL)
		return;
	if (w->feed != NULL)
		note_data_missing_for_other_feed(r, entry);
	if (w->rotor > 0 && !(entry_rotor_of_calibration(w->own) > 0))
		answer_add_sentence(r, ANSWER_REMARK,
		    "measured rotor not stated; %g mm assumed",
		    units_m_to_mm(w->rotor));
}

void
answers_warn_if_nothing_breaks(struct answer *r, const struct entry *entry)
{
	if (fit_has_no_breakage(entry_without_scenario(entry)))
		answer_add_sentence(
		    r, ANSWER_WARNING, "%s", tr(FIT_NOTHING_BREAKS));
}

/* Warns of a speed beyond the measured ones, unless the light does so. */
static void
warn_beyond_measured_speeds(struct answer *r, const struct entry *entry,
    double speed, const struct trust *light)
{
	double slowest, fastest;
	if ((light->n > 0 && light->reason[0].cause == TRUST_BEYOND) ||
	    !(speed > 0) ||
	    !origin_training_speed_range(entry, &slowest, &fastest) ||
	    !answers_is_speed_extrapolated(entry, speed))
		return;
	FREED char *speeds =
	    answers_training_range_text(entry, slowest, fastest);
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, speed, NAN);
	answer_add_sentence(r, ANSWER_WARNING, "%.*f m/s%s is outside the %s",
	    units_speed_decimals(speed), speed, rpm, speeds);
}

void
answers_note_basis_without_trust(const struct session *s, struct answer *r,
    const struct question *q, double speed, const char *whose,
    const struct trust *light)
{
	if (whose == NULL)
		answers_warn_if_nothing_breaks(r, q->entry);
	warn_beyond_measured_speeds(r, q->entry, speed, light);
	origin_add_note_to_answer(r, q->entry);
	feed_add_note_to_answer(r, q->entry->site, q->feed, whose, q->moved);
	feed_note_assumed_top_size(r, q->entry->site, whose);
	note_other_feed_or_machine(r, q->entry);
	note_model_if_not_of_paper(s, r, q->entry);
}

void
answers_note_basis_and_trust(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band, struct trust light)
{
	if (band)
		band_note_meaning(r, s, q->entry, true);
	else
		correction_note_unless_all(r, s, q->entry);
	answers_note_basis_without_trust(s, r, q, speed, NULL, &light);
	trust_add_to_answer(r, light);
}

void
answers_note_basis_and_trust_at_speed(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band)
{
	answers_note_basis_and_trust(
	    s, r, q, speed, band, trust_at_speed(s, q->entry, speed, q->feed));
}

void
answers_note_fit_basis_and_trust(const struct session *s, struct answer *r,
    const struct entry *entry, bool band, struct trust light)
{
	if (band)
		band_note_meaning(r, s, entry, false);
	answers_warn_if_nothing_breaks(r, entry);
	origin_add_note_to_answer(r, entry);
	feed_note_assumed_top_size(r, entry->site, NULL);
	note_model_if_not_of_paper(s, r, entry);
	trust_add_to_answer(r, light);
}

const char *
answers_method_name(enum method method)
{
	return method == METHOD_CLASSES ? "classes" : "continuous";
}

void
answers_put_low_high_field(
    struct fields *o, const char *key, double low, double high)
{
	fields_put_values(fields_add_list(o, key), "%g %g", low, high);
}

void
answers_put_product_size_fields(struct fields *o, const struct prediction *p)
{
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		fields_put_number(
		    o, ANSWERS_SIZE[i].key, answers_product_size_mm(p, i));
}

void
answers_put_p_size_bands(
    struct fields *o, const struct session *s, const struct prediction *p)
{
	for (size_t i = 0; i < ANSWERS_SIZES && p->low != NULL; i++)
		answers_put_low_high_field(o, ANSWERS_SIZE[i].range_key,
		    1000 * p->range[i][0], 1000 * p->range[i][1]);
	if (p->low != NULL)
		fields_put_values(
		    o, "level %g", 100 * settings_band_probability(&s->set));
}

void
answers_put_prediction_fields(const struct session *s, struct fields *o,
    const struct entry *entry, const struct params *params,
    const struct prediction *p)
{
	const struct psd *product = &p->product;
	fields_put_values(o, "speed %g extrapolated %d method %s", p->speed,
	    answers_is_speed_extrapolated(entry, p->speed),
	    answers_method_name(s->set.model.method));
	fields_put_numbers(
	    o, "sieve_mm", product->size, product->n, units_m_to_mm);
	fields_put_numbers(o, "passing_pct", product->passing, product->n,
	    units_fraction_to_pct);
	fields_put_numbers(
	    o, "model_pct", p->model, product->n, units_fraction_to_pct);
	answers_put_product_size_fields(o, p);
	screened_put_fraction_fields(o, p);
	fields_put_values(
	    o, "model %s", breakage_model_of_params(params)->name);
	energies_put_field(o, s);
	fit_put_params_in_json(o, params);
	fields_put_values(
	    o, ".feed_mps %g", feed_sampling_speed(entry->site, p->feed_run));
	if (entry->has_fit)
		fields_put_values(o, "verdict %s",
		    verdict_on_fit(entry, light_of_answer_or_fit(s, entry, p)));
	if (origin_is_from_store(entry->origin))
		fields_put_values(o, "recalled %s", entry->origin->material);
	origin_put_param_source(o, entry);
}

void
answers_put_products(const struct session *s, struct fields *o,
    const struct entry *entry, const struct prediction *p, size_t n)
{
	struct fields *list = fields_add_list(o, "products");
	for (size_t i = 0; i < n; i++) {
		struct fields *product = fields_add_object(list, NULL);
		fields_put_values(product, "command %s site %s", "predict",
		    entry->site->name);
		answers_put_prediction_fields(
		    s, product, entry, &entry->params, &p[i]);
		struct trust light = trust_in_answer_or_fit(s, entry, &p[i]);
		trust_put_fields(product, &light);
		trust_free(&light);
	}
}

void
answers_add_row_per_prediction(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n)
{
	double rotor = entry->site->rotor;
	answer_add_columns(r, "speed: m/s");
	if (rotor > 0)
		answer_add_columns(r, "rpm: rpm");
	answer_add_optional_column(r, "energy_j_kg", "J/kg", 1);
	answer_add_columns(r, "break_mm: break mm");
	for (size_t k = 0; k < PSD_SIZES; k++)
		answer_add_column(r, ANSWERS_SIZE[k].key, ANSWERS_SIZE[k].head);
	double size = p[0].product.size[p[0].product.n - 1];
	FREED char *head = fabs(size - QUANTITIES_FINES) < 1e-9
			       ? xstrdup(tr("fines %"))
			       : xasprintf("< %g mm, %%", units_m_to_mm(size));
	answer_add_column(r, "finest_pct", head);
	answer_add_columns(r, "extrapolated: extrapolated");
	for (size_t i = 0; i < n; i++) {
		size_t finest = p[i].product.n - 1;
		bool round = fabs(fmod(10 * p[i].speed + 0.5, 1) - 0.5) < 1e-6;
		answer_add_cells(r, round ? "%g" : "%.2f", p[i].speed);
		if (rotor > 0)
			answer_add_cells(
			    r, "%.0f", rotor_speed_to_rpm(p[i].speed, rotor));
		answer_add_cells(r, "%.0f", p[i].energy);
		answers_add_size_cell(r, &p[i], ANSWERS_BREAK);
		for (size_t k = 0; k < PSD_SIZES; k++)
			answers_add_size_cell(r, &p[i], k);
		answer_add_cells(r, "%.1f %s",
		    units_fraction_to_pct(p[i].product.passing[finest]),
		    answers_is_speed_extrapolated(entry, p[i].speed)
			? tr("yes")
			: tr("no"));
	}
}
