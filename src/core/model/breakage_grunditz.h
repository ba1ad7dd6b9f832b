/* The code that the paper's model shares with grunditz-energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_BREAKAGE_GRUNDITZ_H
#define TIPSPEED_CORE_MODEL_BREAKAGE_GRUNDITZ_H

#include "core/model/breakage.h"

#define GRUNDITZ_BETA                                                          \
	{"beta1", "-", -1000, 1000, -1e9, 1e9, 0, "appearance: constant term", \
	    0},                                                                \
	    {"beta2", "-", -1000, 1000, -1e9, 1e9, 1, "appearance: term in u", \
		0},                                                            \
	    {"beta3", "-", -1000, 1000, -1e9, 1e9, -1,                         \
		"appearance: term in u squared", 0},                           \
	{                                                                      \
		"beta4", "-", -1000, 1000, -1e9, 1e9, 0.5,                     \
		    "appearance: term in u cubed", 0                           \
	}

/* See the fields of that name in struct breakage. */
void grunditz_compute_breaker_constants(struct breaker *b);
double grunditz_progeny_share_finer(
    const struct breaker *b, double log_u, double *d);
char *grunditz_appearance_text(const struct params *p);

#endif
