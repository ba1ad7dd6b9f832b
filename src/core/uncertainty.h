/* What the data leave open: other fits that they allow, and the band of
 * products that these give.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_UNCERTAINTY_H
#define TIPSPEED_CORE_UNCERTAINTY_H

#include <stdint.h>

#include "core/misfit.h"
#include "core/params.h"
#include "core/psd.h"

enum { UNCERTAINTY_DRAWS = 200, UNCERTAINTY_LEVEL = 80 };

/* Fits that the data allow, drawn as often as they are plausible (see .c)
 * within the search bounds, a step beyond which is not taken.  Parameters held
 * fixed stay; one on its bound moves inward only.
 *   draw          beta scaled to 1
 *   low, high     the middle 80 % of each parameter, widened to hold the fit
 *   deviation     s of struct plausible */
struct uncertainty {
	struct params draw[UNCERTAINTY_DRAWS];
	double low[PARAMS_MOST], high[PARAMS_MOST];
	double deviation;
};

/* m: of the training runs, as the fit was found; p: its optimum.  The same seed
 * gives the same bits.  About 0.1 s, and as many times longer as there are more
 * sieves than 24; NULL where the misfit was stopped meanwhile.  free() it. */
struct uncertainty *uncertainty_new(struct misfit *m, const struct params *p,
    const struct bounds *bounds, uint64_t seed);

/* The middle 80 % of the products of the draws, and the product of the fit
 * itself.  low, high [n] passing, 0..1; sizes in m, the smaller first; NAN
 * where that of a P lies below the finest sieve. */
struct band {
	size_t n;
	double *low, *high;
	union {
		struct {
			double p20[2], p50[2], p80[2], break_size[2];
		};
		double size[PSD_SIZES + 1][2];
	};
};

/* product: that of the fit, p, at the speed v (m/s) from the feed: its sieves
 * are the band's.  1 to 2 ms.  Cannot fail; free with band_free. */
struct band uncertainty_band(const struct uncertainty *u,
    const struct params *p, const struct psd *feed, const struct psd *product,
    struct model_settings settings, double v);
void band_free(struct band *band);

#endif
