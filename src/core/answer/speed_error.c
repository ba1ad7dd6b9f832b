/* Propagates the errors of stated speeds through a straight line in v^2.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/speed_error.h"

#include <math.h>

double
speed_error_times(const struct site *site, double v)
{
	double n = 0, mean = 0, squares = 0;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].product.n > 0) {
			n++;
			mean += site->run[r].speed * site->run[r].speed;
		}
	mean /= n;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].product.n > 0) {
			double v_r = site->run[r].speed;
			squares += (v_r * v_r - mean) * (v_r * v_r - mean);
		}
	double off = (v * v - mean) * (v * v - mean);
	return sqrt(1 + 1 / n + (off > 0 ? off / squares : 0));
}
