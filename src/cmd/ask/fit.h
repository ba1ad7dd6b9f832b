/* How good a fit is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FIT_H
#define TIPSPEED_CMD_ASK_FIT_H

#include <stdbool.h>

#include "cmd/session/session.h"
#include "core/check/trust.h"

/* fit_has_no_breakage is true if the entry was calibrated on products that are
 * not measurably finer than the feed, or if its fit is hardly better than
 * assuming product = feed.  FIT_NOTHING_BREAKS says so in a sentence, to be
 * translated, with what to do. */
extern const char *const FIT_NOTHING_BREAKS;
bool fit_has_no_breakage(const struct entry *entry);

/* True if parameter j is part of a flat direction worth mentioning, along which
 * the misfit hardly rises. */
bool fit_is_param_poorly_determined(const struct fit *fit, size_t j);

/* Return the largest RMSE, 0..1, at a measured run, or NAN if there is none.
 * fit_largest_rmse_of_runs does so for these parameters, at the held-out runs
 * if `holdout` is true, otherwise at all; fit_largest_holdout_rmse for the
 * entry's fit, at the held-out runs. */
double fit_largest_rmse_of_runs(const struct entry *entry,
    const struct params *params, struct model_settings settings, bool holdout);
double fit_largest_holdout_rmse(const struct entry *entry);

/* Returns false with an error if an appearance other than ratio is set with a
 * breakage model or a method that it does not work with. */
bool fit_check_settings_allow_model(const struct model_settings *settings,
    size_t breakage, struct error *error);

/* Puts "params": {"beta":[4],"f_mat":..,"e0_min":..,"alpha":..}. */
void fit_put_params_in_json(struct fields *o, const struct params *p);

/* param_band_from_posterior computes the range of parameter j of the fit's
 * model, from the draws; NAN for a parameter of the gauge, of which only the
 * direction matters.  fit_put_param_bands puts the ranges of the others as
 * "interval": {"f_mat":[low, high], ..}, or null without draws. */
void param_band_from_posterior(const struct posterior *p,
    const struct session *s, const struct params *fit, size_t j,
    double range[static 2]);
void fit_put_param_bands(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit);

/* True if there are no more passings than parameters: such a fit matches any
 * noise, so it is not called good and has no band.  Beta counts as four
 * parameters, as reported, although its scale is free, because a single passing
 * to spare would not reveal noise either. */
bool fit_has_too_few_data(const struct fit *fit);

#endif
