/* Compares each run that was not trained on with all ways to predict it
 * (validate_run), and sums their errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/comparison.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/posterior/ensemble.h"
#include "core/search/misfit.h"
#include "core/check/trust.h"

void
comparison_drop(void *of)
{
	struct comparison *c = of;
	for (size_t i = 0; i < c->n; i++) {
		free(c->item[i].name);
		free(c->item[i].train);
		free(c->item[i].corrected);
	}
	free(c->item);
	free(c->options);
	free(c);
}

void
comparison_take(struct comparison *c, struct comparison *from)
{
	c->left_out += from->left_out;
	c->item = xrealloc(c->item, c->n + from->n + 1, sizeof *c->item);
	for (size_t i = 0; i < from->n; i++)
		c->item[c->n++] = from->item[i];
	from->n = 0;
	comparison_drop(from);
}

double *
comparison_corrected(const struct run *run, const struct posterior *posterior,
    double level, size_t *within)
{
	size_t n = misfit_covered(run);
	*within = 0;
	if (posterior == NULL)
		return NULL;
	double *passing = xdoubles(n);
	struct ensemble *e =
	    ensemble_new(posterior, &run->feed, run->product.size, n);
	ensemble_at(e, run->speed);
	ensemble_mean(e, passing);
	for (size_t i = 0; i < n; i++) {
		double P = run->product.passing[i], low, high;
		ensemble_band(e, ENSEMBLE_SAMPLE, i, level, &low, &high);
		/* To the 0.01 % that sheets are rounded to. */
		*within += P >= low - 1e-4 && P <= high + 1e-4;
	}
	ensemble_free(e);
	return passing;
}

/* Speeds of the training runs. */
static size_t
count_trained(const struct site *site, const bool *train)
{
	size_t n = 0;
	double last = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		n += train[r] && site->run[r].speed != last;
		last = train[r] ? site->run[r].speed : last;
	}
	return n;
}

static void
compare(struct comparison *c, const struct predicted_by *by, size_t run)
{
	const struct site *site = by->site;
	const struct posterior *posterior = by->posterior;
	c->item = xrealloc(c->item, c->n + 1, sizeof *c->item);
	struct compared *item = &c->item[c->n++];
	size_t within;
	double *corrected =
	    comparison_corrected(&site->run[run], posterior, c->level, &within);
	*item = (struct compared){.entry = by->entry,
	    .site = site,
	    .name =
		xasprintf("%g%s", site->run[run].speed, site->run[run].repeat),
	    .train = xcalloc(site->n_run, sizeof *by->train),
	    .params = by->params,
	    .settings = by->settings,
	    .corrected = corrected,
	    .v = validate_run(
		site, run, by->train, &by->params, by->settings, corrected),
	    .open =
		trust_without_band(by->rmse, count_trained(site, by->train))};
	memcpy(item->train, by->train, site->n_run * sizeof *by->train);
	item->has_band = !c->all && posterior != NULL && !item->open;
	item->within = item->has_band ? within : 0;
}

void
comparison_add(struct comparison *c, const struct predicted_by *by)
{
	for (size_t r = 0; r < by->site->n_run; r++)
		if (!by->train[r] && misfit_covered(&by->site->run[r]) > 0)
			compare(c, by, r);
}

void
comparison_rmse(const struct comparison *c, double rmse[static VALIDATE_WAYS])
{
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		double sum = 0;
		for (size_t i = 0; i < c->n; i++)
			sum += pow(c->item[i].v.rmse[way], 2);
		rmse[way] = sqrt(sum / (double)c->n);
	}
}

double *
comparison_passing(const struct compared *item, enum validate_way way)
{
	double *passing = xdoubles(item->v.n_sieve);
	validate_passing(item->site, item->v.run, item->train, &item->params,
	    item->settings, way, passing);
	if (way == VALIDATE_CORRECTED && item->corrected != NULL)
		memcpy(passing, item->corrected,
		    item->v.n_sieve * sizeof *passing);
	return passing;
}
