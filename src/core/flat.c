/* The least determined direction of a fit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/flat.h"

#include <math.h>

#include "core/sensitivity.h"

struct flat
flat_direction(
    struct misfit *m, const struct params *p, const struct bounds *bounds)
{
	struct flat flat = {{0}, 0};
	struct sensitivity s = sensitivity_of(m, p, bounds, false, NULL);
	if (s.n == 0 || m->n_residual < s.n)
		return flat;
	size_t least = s.n - 1;
	double step = sqrt(0.1 * s.misfit) / fmax(s.sigma[least], 1e-12);
	for (size_t c = 0; c < s.n; c++) {
		double part = step * s.direction[least][c];
		flat.part[s.column[c]] = part;
		flat.reach = fmax(flat.reach, fabs(part));
	}
	return flat;
}
