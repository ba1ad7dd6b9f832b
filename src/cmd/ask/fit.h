/* The quality of a fit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FIT_H
#define TIPSPEED_CMD_ASK_FIT_H

#include <stdbool.h>

#include "cmd/session/session.h"
#include "core/check/trust.h"

/* True if the entry was calibrated on products that are not measurably finer
 * than the feed, or its fit explains little that product = feed does not.
 * FIT_NOTHING_BREAKS: that in a sentence, with what to do, to be translated. */
extern const char *const FIT_NOTHING_BREAKS;
bool fit_nothing_breaks(const struct entry *entry);

/* True if parameter j is part of a notable flat direction, along which the
 * misfit hardly rises. */
bool fit_is_param_in_flat_direction(const struct fit *fit, size_t j);

/* Return the largest RMSE, 0..1, at a measured run, or NAN if there is none:
 * fit_largest_rmse_of_runs of these parameters, at all runs or the held-out
 * ones; fit_holdout_rmse of the entry's fit at the held-out ones. */
double fit_largest_rmse_of_runs(const struct entry *entry,
    const struct params *params, struct model_settings settings, bool holdout);
double fit_holdout_rmse(const struct entry *entry);

/* Returns false with an error if an appearance other than ratio is combined
 * with a method other than classes. */
bool fit_check_settings_agree(const struct model_settings *settings,
    size_t breakage, struct error *error);

/* Puts "params": {"beta":[4],"f_mat":..,"e0_min":..,"alpha":..}. */
void fit_put_params(struct fields *o, const struct params *p);

/* param_band_from_draws computes the middle range of the draws for parameter j
 * of the fit's model: NAN for a parameter in the gauge, where only the
 * direction matters.  fit_put_param_bands puts the ranges of the others as
 * "interval":
 * {"f_mat":[low, high], ..}, or null without draws. */
void param_band_from_draws(const struct posterior *p, const struct session *s,
    const struct params *fit, size_t j, double range[static 2]);
void fit_put_param_bands(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit);

/* True if the passings compared do not outnumber the parameters searched: such
 * a fit matches any noise, so it is not called good and has no band.  Beta
 * counts as four numbers, as reported, although its scale is free: one passing
 * to spare would not reveal noise either. */
bool fit_has_too_few_data(const struct fit *fit);

#endif
