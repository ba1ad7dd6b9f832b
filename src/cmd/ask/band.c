/* Uncertainty as commands show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/band.h"

#include <math.h>
#include <stdlib.h>

#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "core/posterior/ensemble.h"

void
band_parameter(const struct posterior *p, const struct session *s,
    const struct params *fit, size_t j, double range[static 2])
{
	double value[POSTERIOR_DRAWS];
	const char *name = breakage_of(fit)->parameter[j].name;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		value[d] = params_value(&p->draw[d].params, name);
	ensemble_range(value, settings_level(&s->set), fit->at[j], range);
}

void
band_put_interval(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit)
{
	if (posterior == NULL) {
		fields_put(o, "interval %g", NAN);
		return;
	}
	struct fields *interval = fields_object(o, "interval");
	const struct breakage *of = breakage_of(fit);
	for (size_t j = 0; j < of->n; j++) {
		double range[2];
		band_parameter(posterior, s, fit, j, range);
		answers_put_pair(
		    interval, of->parameter[j].name, range[0], range[1]);
	}
}

void
band_put(struct fields *o, const struct session *s, const struct prediction *p)
{
	if (p->low == NULL)
		return;
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		answers_put_pair(o, ANSWERS_RANGES[i], 1000 * p->range[i][0],
		    1000 * p->range[i][1]);
	fields_put(o, "level %g", 100 * settings_level(&s->set));
}
