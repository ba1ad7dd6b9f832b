/* Eq 2 to the letter: P = B S f + (I - S) f on the feed's size classes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/classes.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/model/selection.h"
#include "core/numeric/elementary.h"

/* n feed sieves make n classes: n - 1 intervals and the pan. */
struct classes_solver {
	const struct breaker *b;
	enum appearance_form form;
	size_t n_sieve;
	double *sieve;
	struct psd feed;    /* its sieves and passings */
	struct psd product; /* on the feed's sieves */
	double *x, *f, *S, *matrix;
};

void
classes_compute_sizes(const struct psd *feed, double *x)
{
	size_t pan = feed->n - 1;
	for (size_t i = 0; i < pan; i++)
		x[i] = sqrt(feed->size[i] * feed->size[i + 1]);
	x[pan] = feed->size[pan] / 2;
}

void
classes_appearance_matrix(const struct breaker *b, enum appearance_form form,
    const double *x, size_t n, double *a)
{
	for (size_t i = 0; i < n; i++) {
		double sum = 0, log_x = el_log(x[i]);
		for (size_t j = 0; j < n; j++) {
			double u = appearance_argument(form, x[i], x[j]);
			a[j * n + i] = j < i ? 0
					     : b->model->density(b, u,
						   el_log(x[j]) - log_x, log_x);
			sum += a[j * n + i];
		}
		bool broken = sum > 0 && isfinite(sum);
		for (size_t j = i; j < n; j++)
			a[j * n + i] = broken ? a[j * n + i] / sum : j == i;
	}
}

struct classes_solver *
classes_solver_new(const struct breaker *b, const struct psd *feed,
    const double *sieve, size_t n, enum appearance_form form)
{
	struct classes_solver *c = xcalloc(1, sizeof *c);
	c->b = b;
	c->form = form;
	c->n_sieve = n;
	c->sieve = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		c->sieve[i] = sieve[i];
	c->feed = psd_copy(feed);
	c->product = psd_copy(feed);
	c->x = xcalloc_doubles(feed->n);
	c->f = xcalloc_doubles(feed->n);
	c->S = xcalloc_doubles(feed->n);
	c->matrix = xcalloc_doubles(feed->n * feed->n);
	classes_compute_sizes(feed, c->x);
	for (size_t i = 0; i + 1 < feed->n; i++)
		c->f[i] = feed->passing[i] - feed->passing[i + 1];
	c->f[feed->n - 1] = feed->passing[feed->n - 1];
	return c;
}

void
classes_solver_free(struct classes_solver *c)
{
	if (c == NULL)
		return;
	psd_free(&c->feed);
	psd_free(&c->product);
	free(c->sieve);
	free(c->x);
	free(c->f);
	free(c->S);
	free(c->matrix);
	free(c);
}

static void
compute_breakage_matrix_and_shares(struct classes_solver *c)
{
	classes_appearance_matrix(c->b, c->form, c->x, c->feed.n, c->matrix);
	for (size_t i = 0; i < c->feed.n; i++)
		c->S[i] = selection_share_at_log_size(c->b, el_log(c->x[i]));
}

void
classes_solver_compute_product(struct classes_solver *c, double *passing)
{
	size_t n = c->feed.n;
	compute_breakage_matrix_and_shares(c);
	double finer = 0;
	for (size_t j = n; j-- > 0;) {
		double mass = (1 - c->S[j]) * c->f[j];
		for (size_t i = 0; i <= j; i++)
			mass += c->matrix[j * n + i] * c->S[i] * c->f[i];
		finer += mass;
		c->product.passing[j] = finer < 1 ? finer : 1;
	}
	for (size_t i = 0; i < c->n_sieve; i++)
		passing[i] = psd_passing(&c->product, c->sieve[i]);
}

bool
classes_solver_is_feed_broken(struct classes_solver *c)
{
	compute_breakage_matrix_and_shares(c);
	for (size_t i = 0; i < c->feed.n; i++)
		if (c->matrix[i * c->feed.n + i] < 1)
			return true;
	return false;
}

double
classes_solver_broken_feed_share(struct classes_solver *c)
{
	double sum = 0;
	compute_breakage_matrix_and_shares(c);
	for (size_t i = 0; i < c->feed.n; i++)
		sum += c->S[i] * c->f[i];
	return sum;
}
