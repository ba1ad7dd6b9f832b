/* How good a fit is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FIT_H
#define TIPSPEED_CMD_ASK_FIT_H

#include <stdbool.h>

#include "cmd/session/session.h"
#include "core/check/trust.h"

/* True when the fit explains little that product = feed does not. */
bool fit_breaks_nothing(const struct fit *fit);

/* True when parameter j is part of a flat direction worth speaking of: the
 * misfit hardly rises along it. */
bool fit_is_flat(const struct fit *fit, size_t j);

/* Returns the largest RMSE of the entry's fit at the runs held out, 0..1; NAN
 * without such a run. */
double fit_holdout_rmse(const struct entry *entry);

/* Returns the cell of a product (worst_sieve) that lies farthest off the
 * entry's fit, by more than a careful sample does; worst_difference is 0 if
 * none does. */
struct validation fit_outlier(const struct entry *entry);

/* False with an error if an appearance other than ratio is set with a method
 * other than classes. */
bool fit_settings_agree(const struct model_settings *settings, size_t breakage,
    struct error *error);

/* Puts "params": {"beta":[4],"f_mat":..,"e0_min":..,"alpha":..}. */
void fit_put_params(struct fields *o, const struct params *p);

/* fit_param_band gives the middle range of the draws of parameter j of the
 * fit's model, NAN for a parameter of which only the direction counts.
 * fit_put_bands puts the range of each other parameter as "interval":
 * {"f_mat":[low, high], ..}, or null without draws. */
void fit_param_band(const struct posterior *p, const struct session *s,
    const struct params *fit, size_t j, double range[static 2]);
void fit_put_bands(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit);

/* True if no more passings were compared than parameters searched: such a fit
 * matches any noise, so that it is not called good and has no band.  Beta
 * counts as the four numbers it is reported as, though its scale is free: one
 * passing to spare would show no noise either. */
bool fit_too_few(const struct fit *fit);

#endif
