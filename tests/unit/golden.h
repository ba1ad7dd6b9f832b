/* Reads tests/golden/: feeds, and products that were computed from the model's
 * description by accurate quadrature or exact sums, outside this project.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_GOLDEN_H
#define TIPSPEED_TESTS_GOLDEN_H

#include <stdio.h>
#include <stdlib.h>

#include "made.h"

enum { GOLDEN_FEEDS = 8, GOLDEN_SIEVES = 16 };

/* A feed of tests/golden/golden-feeds.csv. */
struct golden_feed {
	char name[32];
	struct psd psd;
};

/* Tests run anywhere; srcdir, which make check sets, is the project's folder. */
static inline FILE *
golden_open(const char *name)
{
	const char *srcdir = getenv("srcdir");
	char *path = xasprintf(
	    "%s/tests/golden/%s", srcdir != NULL ? srcdir : ".", name);
	FILE *file = fopen(path, "r");
	if (file == NULL)
		fail_msg("%s is not there: set srcdir", path);
	free(path);
	return file;
}

/* Returns how many feeds there are; psd_free each. */
static inline size_t
golden_feeds(struct golden_feed feed[static GOLDEN_FEEDS])
{
	char line[200], name[32];
	double size, pct;
	size_t n = 0;
	FILE *file = golden_open("golden-feeds.csv");
	while (fgets(line, sizeof line, file) != NULL) {
		if (sscanf(line, "%31[^,],%lf,%lf", name, &size, &pct) != 3)
			continue;
		if (n == 0 || strcmp(feed[n - 1].name, name) != 0) {
			assert_true(n < GOLDEN_FEEDS);
			strcpy(feed[n].name, name);
			feed[n].psd = psd_new(GOLDEN_SIEVES);
			feed[n++].psd.n = 0;
		}
		struct psd *psd = &feed[n - 1].psd;
		assert_true(psd->n < GOLDEN_SIEVES);
		psd->size[psd->n] = size / 1000;
		psd->passing[psd->n++] = pct / 100;
	}
	fclose(file);
	return n;
}

/* One line of tests/golden/golden-products.csv. */
struct golden_line {
	char feed[32], method[16], form[16];
	double speed, size_mm, pct;
	struct params p;
};

/* Reads on to the next line with numbers; false at the end. */
static inline bool
golden_next(FILE *file, struct golden_line *g)
{
	char line[300];
	while (fgets(line, sizeof line, file) != NULL) {
		g->p.breakage = 0;
		double *b = g->p.beta;
		int n = sscanf(line,
		    "%*[^,],%31[^,],%15[^,],%15[^,],%lf,%lf,%lf,%lf,%lf,%lf,"
		    "%lf,%lf,%lf,%lf",
		    g->feed, g->method, g->form, &g->speed, b, b + 1, b + 2,
		    b + 3, &g->p.f_mat, &g->p.e0_min, &g->p.alpha, &g->size_mm,
		    &g->pct);
		if (n == 13)
			return true;
	}
	return false;
}

#endif
