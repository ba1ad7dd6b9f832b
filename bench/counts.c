/* counts NAME [N]: see counts.h and bench/README.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "counts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

static const struct kind {
	const char *name;
	bool (*count)(size_t n);
	size_t n;
} KINDS[] = {
    {"drift", count_drift, 60},
    {"guess", count_guess, 360},
    {"params", count_params, 100},
    {"power", count_power, 2000},
    {"speeds", count_speeds, 60},
};

bool
counts_share(size_t inside, size_t n, double least, double most)
{
	double share = (double)inside / (double)n, all = (double)n;
	/* As if one more were inside, and one more not: never 0. */
	double part = ((double)inside + 1) / (all + 2),
	       error = sqrt(part * (1 - part) / all);
	printf(" %3.0f +- %-3.1f", 100 * share, 100 * error);
	return share >= least - 3 * error && share <= most + 3 * error;
}

struct posterior *
counts_calibrate(const struct site *site, uint64_t seed, struct fit *fit)
{
	bool *use = xcalloc(site->n_run, sizeof *use);
	for (size_t r = 0; r < site->n_run; r++)
		use[r] = true;
	struct calibrate_options o = calibrate_options_default();
	o.train = use;
	o.seed = seed;
	struct calibration *c = calibration_new(site, &o);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		;
	*fit = calibration_fit(c);
	calibration_free(c);
	struct posterior *p = posterior_new(site, &fit->params,
	    &(struct posterior_options){.use = use,
		.settings = fit->settings,
		.bounds = o.bounds,
		.seed = 1,
		.threads = 2,
		.isa = ISA_BEST});
	free(use);
	return p;
}

int
main(int argc, char **argv)
{
	for (size_t k = 0; argc > 1 && k < sizeof KINDS / sizeof *KINDS; k++)
		if (strcmp(argv[1], KINDS[k].name) == 0) {
			size_t n =
			    argc > 2 ? strtoul(argv[2], NULL, 10) : KINDS[k].n;
			bool ok = KINDS[k].count(n);
			printf("%s %s\n", ok ? "ok" : "not ok", argv[1]);
			return ok ? 0 : 1;
		}
	fprintf(stderr, "usage: counts drift|guess|params|power|speeds [N]\n");
	return 2;
}
