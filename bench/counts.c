/* counts NAME [N]: see counts.h and bench/README.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "counts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct kind {
	const char *name;
	bool (*count)(size_t n);
	size_t n;
} KINDS[] = {
    {"drift", count_drift, 60},
    {"guess", count_guess, 360},
    {"power", count_power, 2000},
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
	fprintf(stderr, "usage: counts drift|guess|power [N]\n");
	return 2;
}
