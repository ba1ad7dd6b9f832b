/* Assesses a fit by its null model, its held-out runs and its residuals, and
 * puts its parameters into answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/fit.h"

#include <math.h>

#include "base/tr.h"
#include "core/check/validate.h"

const char *const FIT_NOTHING_BREAKS =
    N_("the products are not measurably finer than the feed: there is nothing "
       "to calibrate on; is it their feed, and are these the right lines of "
       "the sheet ('show feed' and 'show product' have them)? if so, measure "
       "with a coarser feed or at a higher speed");

bool
fit_has_no_breakage(const struct entry *entry)
{
	const struct fit *fit = &entry->fit;
	return entry->has_fit &&
	       (trust_are_products_like_feed(entry->site) ||
		   fit->misfit > (1 - FIT_LEAST_GAIN) * fit->feed_misfit);
}

bool
fit_has_too_few_data(const struct fit *fit)
{
	return fit->cells <= fit->parameters;
}

double
fit_largest_rmse_of_runs(const struct entry *entry, const struct params *params,
    struct model_settings settings, bool holdout)
{
	const struct site *site = entry->site;
	double top = site_finest_sieve_all_pass(site), largest = NAN;
	for (size_t r = 0; r < site->n_run; r++) {
		if ((holdout && entry->train[r]) ||
		    misfit_count_covered_sieves(&site->run[r]) == 0)
			continue;
		largest = fmax(largest, validate_rmse_of_model(&site->run[r],
					    top, params, settings));
	}
	return largest;
}

double
fit_largest_holdout_rmse(const struct entry *entry)
{
	return fit_largest_rmse_of_runs(
	    entry, &entry->fit.params, entry->fit.settings, true);
}

void
fit_put_params_in_json(struct fields *o, const struct params *p)
{
	const struct breakage *of = breakage_model_of_params(p);
	struct fields *params = fields_add_object(o, "params");
	if (of->gauge > 0)
		fields_put_numbers(
		    params, of->gauge_name, p->at, of->gauge, NULL);
	for (size_t j = of->gauge; j < of->n; j++)
		fields_put_number(params, of->parameter[j].name, p->at[j]);
}

bool
fit_is_param_poorly_determined(const struct fit *fit, size_t j)
{
	const double worth_saying = 0.05, part_of_it = 0.25;
	return fit->flat.reach >= worth_saying &&
	       fabs(fit->flat.part[j]) >= part_of_it * fit->flat.reach;
}

bool
fit_check_settings_allow_model(
    const struct model_settings *settings, size_t breakage, struct error *error)
{
	const struct breakage *of = BREAKAGES[breakage];
	if (settings->appearance != APPEARANCE_RATIO && !of->forms)
		return error_set(error, ERROR_USAGE,
		    "this appearance works with the model %s only\n"
		    "run 'set appearance ratio'",
		    BREAKAGES[0]->name);
	if (settings->method == METHOD_CLASSES ||
	    settings->appearance == APPEARANCE_RATIO)
		return true;
	return error_set(error, ERROR_USAGE,
	    "this appearance works with the method classes only\n"
	    "run 'set method classes' or 'set appearance ratio'");
}

void
param_band_from_posterior(const struct posterior *p, const struct session *s,
    const struct params *fit, size_t j, double range[static 2])
{
	double value[POSTERIOR_DRAWS];
	const char *name = breakage_model_of_params(fit)->parameter[j].name;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		value[d] = params_value_by_name(&p->draw[d].params, name);
	ensemble_middle_interval(
	    value, settings_band_probability(&s->set), &range[0], &range[1]);
	/* Only the direction of these parameters matters, which a range cannot
	 * show. */
	if (j < breakage_model_of_params(fit)->gauge)
		range[0] = range[1] = NAN;
}

void
fit_put_param_bands(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit)
{
	const struct breakage *of = breakage_model_of_params(fit);
	if (posterior == NULL) {
		fields_put_values(o, "interval %g", NAN);
		return;
	}
	struct fields *interval = fields_add_object(o, "interval");
	for (size_t j = of->gauge; j < of->n; j++) {
		double range[2];
		param_band_from_posterior(posterior, s, fit, j, range);
		fields_put_values(
		    fields_add_list(interval, of->parameter[j].name), "%g %g",
		    range[0], range[1]);
	}
}
