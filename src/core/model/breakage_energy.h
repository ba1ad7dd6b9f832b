/* The code that grunditz-energy shares with grunditz-t10.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_BREAKAGE_ENERGY_H
#define TIPSPEED_CORE_MODEL_BREAKAGE_ENERGY_H

#include <math.h>

#include "base/tr.h"
#include "core/model/breakage_grunditz.h"

/* Indices of the breaker's own values: (E / E_ref)^-gamma, ln (E / E_ref) and,
 * in grunditz-t10, (E / E_ref)^kappa. */
enum { OWN_GAMMA, OWN_LOG_RATIO, OWN_KAPPA };

#define ENERGY_PARAMETERS                                                  \
	{"gamma", "-", 0, 2, -10, 10, 0,                                   \
	    N_("appearance: finer with energy if above 0"), 0.4},          \
	{                                                                  \
		"e_ref", "J/kg", 0, 0, 1e-3, 1e6, NAN,                     \
		    N_("energy at which beta holds: mean of the training " \
		       "runs"),                                            \
		    0                                                      \
	}

/* See the fields of that name in struct breakage. */
void energy_compute_breaker_constants(struct breaker *b);
double energy_progeny_share_finer(
    const struct breaker *b, double log_u, double *d);
double energy_progeny_density(
    const struct breaker *b, double u, double log_u, double log_x);
char *energy_appearance_text(const struct params *p);

#endif
