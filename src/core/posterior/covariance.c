/* Cholesky factors of the covariance: of all cells at once, or for many cells
 * by Woodbury's formula, with a block for each run (Rasmussen and Williams
 * 2006, A.9).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/covariance.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

enum { TERMS = DISCREPANCY_TERMS, SIZES = COVARIANCE_SIZES };

/* The members after `many` are for many cells only.  size [n]: the index of
 * each cell's size.  first [blocks + 1]: the first cell of each run.  The rest
 * are offsets in a factor: at [blocks] of the blocks of E, at_K of K, which all
 * processes share, at_A of A, and at_slope of the slope. */
struct covariance {
	enum isa isa;
	size_t n;
	struct cell *cell;
	bool many;
	size_t sizes, *size;
	double log_size[SIZES];
	size_t blocks, largest, *first, *at, at_K, at_A, at_slope;
};

/* ---- The plan ---- */

/* Numbers the sizes of the cells.  Returns false if there are too many. */
static bool
enumerate_cell_sizes(struct covariance *c)
{
	c->sizes = 0;
	for (size_t i = 0; i < c->n; i++) {
		size_t s = 0;
		while (s < c->sizes && c->log_size[s] != c->cell[i].log_size)
			s++;
		if (s == SIZES)
			return false;
		if (s == c->sizes)
			c->log_size[c->sizes++] = c->cell[i].log_size;
		c->size[i] = s;
	}
	return true;
}

/* Moves the size of each cell to the nearest of SIZES even steps from the
 * finest to the coarsest. */
static void
snap_sizes_to_even_steps(struct cell *cell, size_t n)
{
	double least = INFINITY, most = -INFINITY;
	for (size_t i = 0; i < n; i++) {
		least = fmin(least, cell[i].log_size);
		most = fmax(most, cell[i].log_size);
	}
	double step = (most - least) / (SIZES - 1);
	for (size_t i = 0; i < n; i++)
		cell[i].log_size =
		    least + step * round((cell[i].log_size - least) / step);
}

static void
find_covariance_blocks_of_runs(struct covariance *c)
{
	c->first = xcalloc(c->n + 1, sizeof *c->first);
	c->at = xcalloc(c->n + 1, sizeof *c->at);
	for (size_t i = 1; i <= c->n; i++) {
		if (i < c->n && c->cell[i].run == c->cell[i - 1].run)
			continue;
		size_t b = c->blocks++, n = i - c->first[b];
		c->first[b + 1] = i;
		c->at[b + 1] = c->at[b] + n * n;
		c->largest = n > c->largest ? n : c->largest;
	}
	c->at_K = c->at[c->blocks];
	c->at_A = c->at_K + c->sizes * c->sizes;
	c->at_slope = c->at_A + TERMS * TERMS * c->sizes * c->sizes;
}

struct covariance *
covariance_new(enum isa isa, struct cell *cell, size_t n)
{
	struct covariance *c = xcalloc(1, sizeof *c);
	*c = (struct covariance){.isa = isa,
	    .n = n,
	    .many = n > COVARIANCE_FEW,
	    .cell = xcalloc(n, sizeof *cell)};
	memcpy(c->cell, cell, n * sizeof *cell);
	if (!c->many)
		return c;
	c->size = xcalloc(n, sizeof *c->size);
	if (!enumerate_cell_sizes(c)) {
		snap_sizes_to_even_steps(cell, n);
		memcpy(c->cell, cell, n * sizeof *cell);
		enumerate_cell_sizes(c);
	}
	find_covariance_blocks_of_runs(c);
	return c;
}

void
covariance_free(struct covariance *c)
{
	if (c == NULL)
		return;
	free(c->cell);
	free(c->size);
	free(c->first);
	free(c->at);
	free(c);
}

size_t
covariance_factor_size(const struct covariance *c)
{
	return c->many ? c->at_slope + 1 : c->n * c->n;
}

/* ---- The factor of many ---- */

/* The covariances of pairs of sizes: of a process, and of the error that the
 * cells of a run share. */
struct size_pairs {
	double f[SIZES * (SIZES + 1) / 2], error[SIZES * (SIZES + 1) / 2];
};

static void
fill_size_pair_covariances(const struct covariance *c,
    const double hyper[static HYPERS], struct size_pairs *pairs)
{
	size_t n = 0;
	for (size_t s = 0; s < c->sizes; s++)
		for (size_t k = 0; k <= s; k++)
			pairs->f[n++] = c->log_size[s] - c->log_size[k];
	discrepancy_covariances_of_pairs(
	    c->isa, n, hyper, pairs->f, pairs->error);
}

static void
factor_covariance_of_run(const struct covariance *c, size_t b,
    const struct size_pairs *pairs, double own, double *U)
{
	size_t first = c->first[b], n = c->first[b + 1] - first;
	const struct cell *cell = c->cell + first;
	const size_t *size = c->size + first;
	for (size_t i = 0; i < n; i++) {
		for (size_t j = i; j < n; j++) {
			size_t pair =
			    discrepancy_index_of_pair(size[i], size[j]);
			U[i * n + j] =
			    pairs->error[pair] * cell[i].h * cell[j].h;
		}
		U[i * n + i] += own * own * cell[i].h * cell[i].h +
				DISCREPANCY_ROUNDING * DISCREPANCY_ROUNDING;
	}
	discrepancy_cholesky(c->isa, U, n);
}

/* Adds a run's part of B' E^-1 B to G, which has a [sizes * sizes] block for
 * each pair of terms.  Omits the slope.  work [largest * largest]. */
static void
add_run_to_coupling_matrix(const struct covariance *c, size_t b,
    const double *U, double *G, double *work)
{
	size_t first = c->first[b], n = c->first[b + 1] - first, S = c->sizes;
	double term[TERMS];
	discrepancy_speed_terms(c->cell[first].t, 1, term);
	for (size_t i = 0; i < n; i++) {
		double *column = work + i * n;
		memset(column, 0, n * sizeof *column);
		column[i] = c->cell[first + i].h;
		discrepancy_solve_lower(c->isa, U, n, column);
	}
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			double sum = 0, *to = G + c->size[first + i] * S +
					      c->size[first + j];
			for (size_t k = 0; k < n; k++)
				sum += work[i * n + k] * work[j * n + k];
			for (size_t p = 0; p < TERMS; p++)
				for (size_t q = p; q < TERMS; q++, to += S * S)
					*to += term[p] * term[q] * sum;
		}
}

/* Computes to = U G U', [n * n]; U is upper triangular. */
static void
multiply_matrix_on_both_sides(
    const double *U, const double *G, size_t n, double *work, double *to)
{
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			work[i * n + j] = 0;
			for (size_t k = i; k < n; k++)
				work[i * n + j] += U[i * n + k] * G[k * n + j];
		}
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			to[i * n + j] = 0;
			for (size_t k = j; k < n; k++)
				to[i * n + j] += work[i * n + k] * U[j * n + k];
		}
}

/* Returns the slope, or 1 for the first process. */
static double
slope_factor_of_covariance_term(
    const struct covariance *c, const double *factor, size_t term)
{
	return term == 0 ? 1 : factor[c->at_slope];
}

static void
factor_coupling_matrix(
    const struct covariance *c, const double *G, double *factor)
{
	size_t S = c->sizes, m = TERMS * S;
	double *A = factor + c->at_A;
	double *work = xcalloc_doubles(2 * S * S), *part = work + S * S;
	for (size_t j = 0; j < TERMS; j++)
		for (size_t k = j; k < TERMS; k++, G += S * S) {
			double scale =
			    slope_factor_of_covariance_term(c, factor, j) *
			    slope_factor_of_covariance_term(c, factor, k);
			multiply_matrix_on_both_sides(
			    factor + c->at_K, G, S, work, part);
			for (size_t i = 0; i < S * S; i++)
				A[(j * S + i / S) * m + k * S + i % S] =
				    scale * part[i];
		}
	for (size_t i = 0; i < m; i++)
		A[i * m + i] += 1;
	discrepancy_cholesky(c->isa, A, m);
	free(work);
}

static void
factor_covariance_by_woodbury(const struct covariance *c,
    const double log_hyper[static HYPERS], double *factor)
{
	enum { PAIRS = TERMS * (TERMS + 1) / 2 };
	struct size_pairs pairs;
	double hyper[HYPERS];
	for (size_t i = 0; i < HYPERS; i++)
		hyper[i] = el_exp(log_hyper[i]);
	factor[c->at_slope] = hyper[HYPER_SLOPE];
	fill_size_pair_covariances(c, hyper, &pairs);
	discrepancy_factor_pair_covariances(
	    c->isa, pairs.f, c->sizes, factor + c->at_K);
	double *G = xcalloc_doubles(PAIRS * c->sizes * c->sizes);
	double *work = xcalloc_doubles(c->largest * c->largest);
	for (size_t b = 0; b < c->blocks; b++) {
		double *U = factor + c->at[b];
		factor_covariance_of_run(c, b, &pairs, hyper[HYPER_OWN], U);
		add_run_to_coupling_matrix(c, b, U, G, work);
	}
	factor_coupling_matrix(c, G, factor);
	free(G);
	free(work);
}

/* ---- Its use ---- */

/* add_cells_to_discrepancy_terms adds B' d of a run to f, which has a value for
 * each term and size; add_discrepancy_to_cells adds B f to d.  Both omit the
 * slope.
 * */
static void
add_cells_to_discrepancy_terms(
    const struct covariance *c, size_t b, const double *d, double *f)
{
	double term[TERMS];
	discrepancy_speed_terms(c->cell[c->first[b]].t, 1, term);
	for (size_t i = c->first[b]; i < c->first[b + 1]; i++)
		for (size_t j = 0; j < TERMS; j++)
			f[j * c->sizes + c->size[i]] +=
			    term[j] * c->cell[i].h * d[i];
}

static void
add_discrepancy_to_cells(
    const struct covariance *c, size_t b, const double *f, double *d)
{
	double term[TERMS];
	discrepancy_speed_terms(c->cell[c->first[b]].t, 1, term);
	for (size_t i = c->first[b]; i < c->first[b + 1]; i++)
		for (size_t j = 0; j < TERMS; j++)
			d[i] += term[j] * c->cell[i].h *
				f[j * c->sizes + c->size[i]];
}

/* multiply_discrepancy_by_upper computes L' f of each process, times the slope;
 * multiply_discrepancy_by_lower computes L f.  Both work in place, in an order
 * in which no value is overwritten before it has been read. */
static void
multiply_discrepancy_by_upper(
    const struct covariance *c, const double *factor, double *f)
{
	const double *K = factor + c->at_K;
	size_t S = c->sizes;
	for (size_t j = 0; j < TERMS; j++, f += S)
		for (size_t i = 0; i < S; i++) {
			double sum = 0;
			for (size_t k = i; k < S; k++)
				sum += K[i * S + k] * f[k];
			f[i] =
			    slope_factor_of_covariance_term(c, factor, j) * sum;
		}
}

static void
multiply_discrepancy_by_lower(
    const struct covariance *c, const double *factor, double *f)
{
	const double *K = factor + c->at_K;
	size_t S = c->sizes;
	for (size_t j = 0; j < TERMS; j++, f += S)
		for (size_t i = S; i-- > 0;) {
			double sum = 0;
			for (size_t k = 0; k <= i; k++)
				sum += K[k * S + i] * f[k];
			f[i] =
			    slope_factor_of_covariance_term(c, factor, j) * sum;
		}
}

double
covariance_minus_log_density(
    const struct covariance *c, const double *factor, double *d)
{
	if (!c->many)
		return discrepancy_minus_log_density(c->isa, factor, c->n, d);
	double f[TERMS * SIZES] = {0}, level = 0;
	size_t m = TERMS * c->sizes;
	for (size_t b = 0; b < c->blocks; b++) {
		size_t first = c->first[b], n = c->first[b + 1] - first;
		const double *U = factor + c->at[b];
		level += discrepancy_minus_log_density(c->isa, U, n, d + first);
		discrepancy_solve_upper(U, n, d + first);
		add_cells_to_discrepancy_terms(c, b, d, f);
	}
	multiply_discrepancy_by_upper(c, factor, f);
	level += discrepancy_minus_log_density(c->isa, factor + c->at_A, m, f);
	for (size_t i = 0; i < m; i++)
		level -= f[i] * f[i];
	return level;
}

/* Computes E^-1 d of a run in place. */
static void
solve_covariance_of_run(
    const struct covariance *c, const double *factor, size_t b, double *d)
{
	size_t first = c->first[b], n = c->first[b + 1] - first;
	const double *U = factor + c->at[b];
	discrepancy_solve_lower(c->isa, U, n, d + first);
	discrepancy_solve_upper(U, n, d + first);
}

static void
solve_by_woodbury(const struct covariance *c, const double *factor, double *d)
{
	const double *A = factor + c->at_A;
	double f[TERMS * SIZES] = {0}, *less = xcalloc_doubles(c->n);
	size_t m = TERMS * c->sizes;
	for (size_t b = 0; b < c->blocks; b++) {
		solve_covariance_of_run(c, factor, b, d);
		add_cells_to_discrepancy_terms(c, b, d, f);
	}
	multiply_discrepancy_by_upper(c, factor, f);
	discrepancy_solve_lower(c->isa, A, m, f);
	discrepancy_solve_upper(A, m, f);
	multiply_discrepancy_by_lower(c, factor, f);
	for (size_t b = 0; b < c->blocks; b++) {
		add_discrepancy_to_cells(c, b, f, less);
		solve_covariance_of_run(c, factor, b, less);
	}
	for (size_t i = 0; i < c->n; i++)
		d[i] -= less[i];
	free(less);
}

void
covariance_compute_factor(const struct covariance *c,
    const double log_hyper[static HYPERS], double *factor)
{
	if (c->many)
		factor_covariance_by_woodbury(c, log_hyper, factor);
	else
		discrepancy_factor_covariance(
		    c->isa, c->cell, c->n, log_hyper, factor);
}

void
covariance_solve(const struct covariance *c, const double *factor, double *d)
{
	if (c->many) {
		solve_by_woodbury(c, factor, d);
		return;
	}
	discrepancy_solve_lower(c->isa, factor, c->n, d);
	discrepancy_solve_upper(factor, c->n, d);
}
