/* The misfit of Eq 5: weighted squared differences, from the exact product and
 * its derivatives.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/misfit.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"

size_t
misfit_count_covered_sieves(const struct run *run)
{
	size_t n = 0;
	while (n < run->product.n &&
	       psd_covers_size(&run->feed, run->product.size[n]))
		n++;
	return n;
}

size_t
misfit_count_uninformative_sieves(const struct run *run, double top)
{
	size_t idle = 0, covered = misfit_count_covered_sieves(run);
	while (idle + 1 < covered && run->product.size[idle] > top)
		idle++;
	return idle;
}

size_t
misfit_mark_default_training(const struct site *site, bool *train)
{
	double slowest = INFINITY, fastest = 0;
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (site->run[r].product.n == 0)
			continue;
		slowest = fmin(slowest, site->run[r].speed);
		fastest = fmax(fastest, site->run[r].speed);
	}
	for (size_t r = 0; r < site->n_run; r++) {
		double v = site->run[r].speed;
		train[r] = site->run[r].product.n > 0 &&
			   (v == slowest || v == fastest);
		n += train[r];
	}
	return n;
}

static void
misfit_fill_run(struct misfit_run *to, const struct run *run, double top,
    double run_weight, bool by_sd)
{
	size_t idle = misfit_count_uninformative_sieves(run, top);
	by_sd = by_sd && run->product_sd != NULL;
	to->speed = run->speed;
	to->feed = run->feed;
	to->n = misfit_count_covered_sieves(run) - idle;
	to->sieve = xcalloc_doubles(to->n);
	to->measured = xcalloc_doubles(to->n);
	to->weight = xcalloc_doubles(to->n);
	for (size_t i = 0; i < to->n; i++) {
		size_t from = idle + i;
		to->sieve[i] = run->product.size[from];
		to->measured[i] = run->product.passing[from];
		to->weight[i] =
		    sqrt(run_weight) / (by_sd ? run->product_sd[from] : 1);
	}
}

struct misfit *
misfit_new(const struct site *site, const bool *train, const double *run_weight,
    bool by_sd, struct model_settings settings)
{
	struct misfit *m = xcalloc(1, sizeof *m);
	size_t widest = 0;
	double top = site_finest_sieve_all_pass(site);
	m->settings = settings;
	m->of = BREAKAGES[settings.breakage];
	m->run = xcalloc(site->n_run, sizeof *m->run);
	m->model = xcalloc(site->n_run, sizeof *m->model);
	for (size_t r = 0; r < site->n_run; r++) {
		if ((train != NULL && !train[r]) || site->run[r].product.n == 0)
			continue;
		struct misfit_run *run = &m->run[m->n_run];
		double weight = run_weight != NULL ? run_weight[r] : 1;
		misfit_fill_run(run, &site->run[r], top, weight, by_sd);
		run->run = r;
		m->model[m->n_run++] =
		    model_new(&run->feed, run->sieve, run->n, settings);
		m->n_residual += run->n;
		widest = run->n > widest ? run->n : widest;
	}
	m->passing = xcalloc_doubles(widest);
	m->d_passing = xcalloc_doubles(widest * m->of->n);
	return m;
}

void
misfit_limit_sieves_per_run(struct misfit *m, size_t most)
{
	m->n_residual = 0;
	for (size_t r = 0; r < m->n_run; r++) {
		struct misfit_run *run = &m->run[r];
		size_t n = run->n;
		m->n_residual += n < most ? n : most;
		if (n <= most)
			continue;
		for (size_t i = 0; i < most; i++) {
			size_t from = i * (n - 1) / (most - 1);
			run->sieve[i] = run->sieve[from];
			run->measured[i] = run->measured[from];
			run->weight[i] = run->weight[from];
		}
		run->n = most;
		model_free(m->model[r]);
		m->model[r] =
		    model_new(&run->feed, run->sieve, most, m->settings);
	}
}

size_t
misfit_count_changeable_passings(const struct misfit *m)
{
	size_t n = 0;
	for (size_t r = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++)
			n += psd_passing(&m->run[r].feed, m->run[r].sieve[i]) <
			     1;
	return n;
}

void
misfit_free(struct misfit *m)
{
	if (m == NULL)
		return;
	for (size_t r = 0; r < m->n_run; r++) {
		free(m->run[r].sieve);
		free(m->run[r].measured);
		free(m->run[r].weight);
		model_free(m->model[r]);
	}
	free(m->run);
	free(m->model);
	free(m->passing);
	free(m->d_passing);
	free(m);
}

bool
misfit_should_stop(const struct misfit *m)
{
	return m->stop != NULL && m->stop();
}

/* Computes d [run's n], the differences of run r, weighted or not.  Returns the
 * sum of their squares. */
static double
residuals_of_run(struct misfit *m, size_t r, const struct params *p,
    bool weighted, double *d)
{
	const struct misfit_run *run = &m->run[r];
	double sum = 0;
	model_set_params(m->model[r], p);
	model_compute_product(m->model[r], run->speed, m->passing);
	for (size_t i = 0; i < run->n; i++) {
		d[i] = m->passing[i] - run->measured[i];
		d[i] *= weighted ? run->weight[i] : 1;
		sum += d[i] * d[i];
	}
	return sum;
}

double
misfit_of_params(struct misfit *m, const struct params *p)
{
	return misfit_weighted_differences(m, p, NULL);
}

double
misfit_weighted_differences(struct misfit *m, const struct params *p, double *d)
{
	double sum = 0;
	for (size_t r = 0, at = 0; r < m->n_run; at += m->run[r++].n)
		sum += residuals_of_run(
		    m, r, p, true, d != NULL ? d + at : m->passing);
	return isfinite(sum) ? sum : INFINITY;
}

double
misfit_rmse(struct misfit *m, const struct params *p)
{
	double sum = 0;
	for (size_t r = 0; r < m->n_run; r++)
		sum += residuals_of_run(m, r, p, false, m->passing);
	return sqrt(sum / (double)(m->n_residual > 0 ? m->n_residual : 1));
}

double
misfit_jacobian(struct misfit *m, const struct params *p, double *r, double *J)
{
	double sum = 0;
	size_t n = m->of->n;
	for (size_t k = 0; k < m->n_run; k++) {
		const struct misfit_run *run = &m->run[k];
		model_set_params(m->model[k], p);
		model_jacobian(
		    m->model[k], run->speed, m->passing, m->d_passing);
		for (size_t i = 0; i < run->n; i++) {
			double w = run->weight[i];
			*r = w * (m->passing[i] - run->measured[i]);
			sum += *r * *r;
			for (size_t j = 0; j < n; j++)
				J[j] = w * m->d_passing[i * n + j];
			r++;
			J += n;
		}
	}
	return isfinite(sum) ? sum : INFINITY;
}

double
misfit_of_feed_as_product(const struct misfit *m)
{
	double sum = 0;
	for (size_t r = 0; r < m->n_run; r++) {
		const struct misfit_run *run = &m->run[r];
		for (size_t i = 0; i < run->n; i++) {
			double d = psd_passing(&run->feed, run->sieve[i]) -
				   run->measured[i];
			sum += run->weight[i] * run->weight[i] * d * d;
		}
	}
	return sum;
}
