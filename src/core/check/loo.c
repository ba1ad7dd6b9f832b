/* Leave-one-out expectations of a Gaussian vector from its inverse covariance
 * (Rasmussen and Williams 2006, section 5.4.2), with hyperparameters from a
 * pattern search without the cell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/loo.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>

#include "base/xalloc.h"
#include "core/posterior/discrepancy.h"
#include "core/numeric/elementary.h"
#include "core/search/misfit.h"
#include "core/model/product.h"

/* CLOSE: the number of candidates that are examined closely.  SEARCHED: a block
 * with more cells than this keeps its hyperparameters at the medians of their
 * priors, because searching for them would take seconds. */
enum { SMOOTHS = 5, CLOSE = 6, SEARCHED = 150, PRODUCTS = 0, FEEDS, BLOCKS };

enum smooth {
	SMOOTH_AMPLITUDE,
	SMOOTH_LENGTH,
	SMOOTH_SPEED,
	SMOOTH_RUN,
	SMOOTH_OWN
};

/* Medians and spreads as in struct hyper_info.  They apply to ln(P / (1 - P)),
 * except the last, which is the error of a passing. */
static const struct {
	double median, spread;
} SMOOTH[SMOOTHS] = {
    {0.5, 1}, {0.7, 0.4}, {0.1, 0.7}, {0.03, 0.7}, {0.0035, 0.3}};

/* The standard deviations of a cell that is left out and of a feed's own error,
 * and the smallest error of a passing. */
static const double FREE = 0.3, FEED_OWN = 0.0035, ROUNDING = 0.0005;

/* A curve ends with a corner at the screen that cut it, above COARSE or at the
 * first sieve below 100 %.  A smooth curve has no such corner, so these cells
 * get CORNER as an additional standard deviation of ln(P / (1 - P)). */
static const double COARSE = 0.8, CORNER = 0.6;

/* A passing nearer to 0 or 1 does not show how steep a curve is. */
static const double END = 0.0005;

/* Cells of the products, or of the feeds, with common hyperparameters.
 *   value   [n] differences from the fit, or ln(P / (1 - P))
 *   slope   [n] change of the value with the passing
 *   fixed   [n n] the part of the covariance that has no hyperparameters
 *   U       [n n] factor */
struct block {
	bool smooth;
	size_t n, first; /* first: index of its first cell */
	struct cell *cell;
	double *value, *slope, *fixed, *U, *work;
	double hyper[HYPERS]; /* logarithms */
	double level;         /* -ln of the posterior density at hyper */
};

/* of [n]: the cells, products first.  shift [n n]: row i is the u of cell i. */
struct leave_out {
	const struct site *site;
	size_t n;
	struct leave_out_cell *of;
	double *passing, *shift, *cross;
	bool *dropped;
	struct block block[BLOCKS];
	double noise;
};

static const struct psd *
curve_of_cell(const struct leave_out *l, const struct leave_out_cell *c)
{
	return site_feed_or_product(l->site, c->run, c->feed);
}

/* ---- The covariance and its hyperparameters ---- */

static void
compute_smooth_curve_covariance(const struct block *b, double *K)
{
	double h[SMOOTHS];
	for (size_t i = 0; i < SMOOTHS; i++)
		h[i] = el_exp(b->hyper[i]);
	for (size_t i = 0; i < b->n; i++)
		for (size_t j = 0; j <= i; j++) {
			const struct cell *x = &b->cell[i], *y = &b->cell[j];
			double apart = x->log_size - y->log_size;
			double near =
			    discrepancy_correlation(apart, h[SMOOTH_LENGTH]);
			double k =
			    h[SMOOTH_AMPLITUDE] * h[SMOOTH_AMPLITUDE] +
			    h[SMOOTH_SPEED] * h[SMOOTH_SPEED] * x->t * y->t;
			k *= near;
			if (x->run == y->run)
				k += h[SMOOTH_RUN] * h[SMOOTH_RUN] *
				     discrepancy_correlation(apart, 1);
			double own = h[SMOOTH_OWN] * x->h * b->slope[i];
			double least = ROUNDING * b->slope[i];
			K[j * b->n + i] =
			    k + (i == j ? own * own + least * least : 0);
		}
}

static double
block_minus_log_prior(const struct block *b, double noise)
{
	const double known = 0.05;
	double sum = 0;
	if (!b->smooth)
		return discrepancy_minus_log_prior(b->hyper, noise);
	for (size_t i = 0; i < SMOOTHS; i++) {
		bool given = i == SMOOTH_OWN && noise > 0;
		double median = given ? noise : SMOOTH[i].median;
		double z = (b->hyper[i] - el_log(median)) /
			   (given ? known : SMOOTH[i].spread);
		sum += z * z / 2;
	}
	return sum;
}

/* Fills U with the covariance; only the upper triangle matters. */
static void
block_fill_covariance(struct block *b)
{
	if (b->smooth)
		compute_smooth_curve_covariance(b, b->U);
	else
		discrepancy_fill_covariance(
		    ISA_BEST, b->cell, b->n, b->hyper, b->U);
	for (size_t i = 0; i < b->n * b->n; i++)
		b->U[i] += b->fixed[i];
}

static double
block_minus_log_posterior(struct block *b, double noise)
{
	block_fill_covariance(b);
	discrepancy_cholesky(ISA_BEST, b->U, b->n);
	memcpy(b->work, b->value, b->n * sizeof *b->work);
	double level =
	    discrepancy_minus_log_density(ISA_BEST, b->U, b->n, b->work);
	return isfinite(level) ? level + block_minus_log_prior(b, noise)
			       : INFINITY;
}

/* Searches for the most probable hyperparameters, starting from the current
 * ones: tries a step up or down for each, and shorter steps when no step
 * helps. */
static void
search_hyperparameters(struct block *b, double noise)
{
	const double last = 0.06;
	size_t hypers = b->smooth ? SMOOTHS : HYPERS;
	double step = 0.5;
	b->level = block_minus_log_posterior(b, noise);
	while (step > last && b->n > 0 && b->n <= SEARCHED) {
		bool better = false;
		for (size_t k = 0; k < 2 * hypers; k++) {
			double was = b->hyper[k / 2];
			b->hyper[k / 2] += k % 2 == 0 ? step : -step;
			double level = block_minus_log_posterior(b, noise);
			if (level < b->level - 1e-3) {
				b->level = level;
				better = true;
			} else
				b->hyper[k / 2] = was;
		}
		step *= better ? 1 : 0.5;
	}
}

/* Leaves the cell out (sign 1), or includes it again (-1). */
static void
set_cell_left_out(struct leave_out *l, size_t cell, double sign)
{
	const double *u = l->shift + cell * l->n;
	for (size_t k = 0; k < BLOCKS; k++) {
		struct block *b = &l->block[k];
		for (size_t i = 0; i < b->n; i++)
			for (size_t j = 0; j < b->n; j++)
				b->fixed[i * b->n + j] += sign * FREE * FREE *
							  u[b->first + i] *
							  u[b->first + j];
	}
}

/* ---- The joint vector ---- */

/* Returns the error of a feed's passing that carries over to the products. */
static double
feed_error_seen_by_products(const struct leave_out *l)
{
	return l->noise > 0 ? l->noise : FEED_OWN;
}

/* Returns the factor [n n] of both blocks with the covariance between them. The
 * caller frees it. */
static double *
factor_joint_covariance(struct leave_out *l)
{
	double *U = xcalloc_doubles(l->n * l->n);
	const struct block *p = &l->block[PRODUCTS], *f = &l->block[FEEDS];
	for (size_t k = 0; k < BLOCKS; k++) {
		struct block *b = &l->block[k];
		block_fill_covariance(b);
		for (size_t i = 0; i < b->n; i++)
			for (size_t j = i; j < b->n; j++)
				U[(b->first + i) * l->n + b->first + j] =
				    b->U[i * b->n + j];
	}
	/* The feed's own error is a hyperparameter, but the error that carries
	 * over to the products is fixed.  If the former is smaller, the
	 * covariance between feeds and products shrinks with it; otherwise no
	 * set of errors could have this covariance. */
	double own =
	    el_exp(f->hyper[SMOOTH_OWN]) / feed_error_seen_by_products(l);
	for (size_t i = 0; i < f->n; i++)
		for (size_t j = 0; j < p->n; j++)
			U[j * l->n + f->first + i] =
			    fmin(own, 1) * l->cross[i * p->n + j];
	for (size_t c = 0; c < l->n; c++)
		for (size_t i = 0; i < f->n && l->dropped[c]; i++)
			for (size_t j = 0; j < p->n; j++)
				U[j * l->n + f->first + i] +=
				    FREE * FREE *
				    l->shift[c * l->n + f->first + i] *
				    l->shift[c * l->n + j];
	discrepancy_cholesky(ISA_BEST, U, l->n);
	return U;
}

/* Returns L^-1 y for the whole vector.  The caller frees it. */
static double *
standardise_joint_values(const struct leave_out *l, const double *U)
{
	double *y = xcalloc_doubles(l->n);
	for (size_t k = 0; k < BLOCKS; k++)
		memcpy(y + l->block[k].first, l->block[k].value,
		    l->block[k].n * sizeof *y);
	discrepancy_solve_lower(ISA_BEST, U, l->n, y);
	return y;
}

/* Returns z of a cell.  Sets *shift and *sd to its shift and the standard
 * deviation of the shift. */
static double
z_score_of_left_out_cell(const struct leave_out *l, const double *U,
    const double *y, size_t cell, double *shift, double *sd)
{
	FREED double *u = xcalloc_doubles(l->n);
	double dot = 0, squares = 0;
	memcpy(u, l->shift + cell * l->n, l->n * sizeof *u);
	discrepancy_solve_lower(ISA_BEST, U, l->n, u);
	for (size_t i = 0; i < l->n; i++) {
		dot += u[i] * y[i];
		squares += u[i] * u[i];
	}
	*shift = dot / squares;
	*sd = 1 / sqrt(squares);
	return dot / sqrt(squares);
}

static bool
is_neither_0_nor_100_percent(double P)
{
	return P > END && P < 1 - END;
}

static double
logit(double P)
{
	return el_log(P / (1 - P));
}

/* Sets the expected passing of a cell from its shift.  If the values are
 * logits, the shift is applied to the logit. */
static void
fill_expected_passing(
    const struct leave_out *l, struct leave_out_shift *s, double shift)
{
	double P = l->passing[s->cell];
	bool feed = s->cell >= l->block[FEEDS].first;
	const struct block *b = &l->block[feed ? FEEDS : PRODUCTS];
	s->expected = P - shift;
	if (b->smooth && is_neither_0_nor_100_percent(P)) {
		double slope = b->slope[s->cell - b->first];
		double z = logit(P) - slope * shift;
		s->expected = 1 / (1 + el_exp(-z));
		s->sd *= slope * s->expected * (1 - s->expected);
	}
	s->expected = fmin(fmax(s->expected, 0), 1);
}

/* ---- The search for the worst ---- */

/* Sets cell [CLOSE] to the cells with the largest |z| and returns their
 * number. */
static size_t
find_cells_of_largest_z(struct leave_out *l, size_t *cell)
{
	FREED double *U = factor_joint_covariance(l),
		     *y = standardise_joint_values(l, U);
	FREED double *z = xcalloc_doubles(l->n);
	double shift, sd;
	size_t n = 0;
	for (size_t c = 0; c < l->n; c++) {
		z[c] = fabs(z_score_of_left_out_cell(l, U, y, c, &shift, &sd));
		bool counts = !l->dropped[c] && isfinite(z[c]);
		z[c] = counts ? z[c] : -1;
		n += counts;
	}
	n = n < CLOSE ? n : CLOSE;
	gsl_sort_largest_index(cell, n, z, 1, l->n);
	return n;
}

static double
minus_log_posterior_at_best_hypers(struct leave_out *l)
{
	for (size_t k = 0; k < BLOCKS; k++)
		search_hyperparameters(&l->block[k], l->noise);
	return l->block[PRODUCTS].level + l->block[FEEDS].level;
}

/* Returns the shift of a cell with the hyperparameters that are most probable
 * if the cell is left out. */
static struct leave_out_shift
compare_left_out_cell_to_others(struct leave_out *l, size_t cell, double level)
{
	struct leave_out_shift s = {.cell = cell};
	double was[BLOCKS][HYPERS], shift;
	for (size_t k = 0; k < BLOCKS; k++)
		memcpy(was[k], l->block[k].hyper, sizeof was[k]);
	set_cell_left_out(l, cell, 1);
	s.gain = level - minus_log_posterior_at_best_hypers(l);
	set_cell_left_out(l, cell, -1);
	FREED double *U = factor_joint_covariance(l),
		     *y = standardise_joint_values(l, U);
	s.z = z_score_of_left_out_cell(l, U, y, cell, &shift, &s.sd);
	fill_expected_passing(l, &s, shift);
	for (size_t k = 0; k < BLOCKS; k++)
		memcpy(l->block[k].hyper, was[k], sizeof was[k]);
	return s;
}

struct leave_out_shift
leave_out_shift_of_cell(struct leave_out *l, size_t cell)
{
	return compare_left_out_cell_to_others(
	    l, cell, minus_log_posterior_at_best_hypers(l));
}

struct leave_out_shift
leave_out_find_worst_cell(struct leave_out *l)
{
	struct leave_out_shift worst = {.gain = -INFINITY};
	size_t cell[CLOSE];
	double level = minus_log_posterior_at_best_hypers(l);
	size_t n = find_cells_of_largest_z(l, cell);
	for (size_t i = 0; i < n; i++) {
		struct leave_out_shift s =
		    compare_left_out_cell_to_others(l, cell[i], level);
		bool first = s.gain == worst.gain && s.cell < worst.cell;
		if (isfinite(s.z) && (s.gain > worst.gain || first))
			worst = s;
	}
	return worst;
}

void
leave_out_remove_cell(struct leave_out *l, size_t cell)
{
	l->dropped[cell] = true;
	set_cell_left_out(l, cell, 1);
}

size_t
leave_out_count_cells(const struct leave_out *l)
{
	return l->n;
}

struct leave_out_cell
leave_out_get_cell(const struct leave_out *l, size_t i)
{
	return l->of[i];
}

/* ---- Making it ---- */

static void
add_checkable_cell(struct leave_out *l, bool feed, size_t run, size_t sieve)
{
	struct leave_out_cell c = {feed, run, sieve};
	l->of = xrealloc(l->of, l->n + 1, sizeof *l->of);
	l->of[l->n++] = c;
}

static void
list_checkable_cells(struct leave_out *l, const struct posterior *posterior)
{
	const struct site *site = l->site;
	double top = site_finest_sieve_all_pass(site);
	for (size_t r = 0; r < site->n_run; r++) {
		const struct psd *psd = &site->run[r].product;
		size_t covered = misfit_count_covered_sieves(&site->run[r]);
		size_t idle =
		    misfit_count_uninformative_sieves(&site->run[r], top);
		for (size_t i = 0; i < psd->n; i++)
			if (posterior != NULL
				? i >= idle && i < covered
				: is_neither_0_nor_100_percent(psd->passing[i]))
				add_checkable_cell(l, false, r, i);
	}
	l->block[PRODUCTS].n = l->block[FEEDS].first = l->n;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct psd *psd = &site->run[r].feed;
		if (!site_run_has_feed_sample(site, r))
			continue;
		for (size_t i = 0; i < psd->n; i++)
			if (is_neither_0_nor_100_percent(psd->passing[i]))
				add_checkable_cell(l, true, r, i);
	}
	l->block[FEEDS].n = l->n - l->block[FEEDS].first;
}

/* True if 100 % of the curve passes the next coarser sieve. */
static bool
is_first_sieve_below_100_percent(const struct leave_out *l, size_t cell)
{
	const struct leave_out_cell *of = &l->of[cell];
	const struct psd *curve = curve_of_cell(l, of);
	return of->sieve > 0 && curve->passing[of->sieve - 1] >= 1;
}

/* Returns ln of the mean energy of the runs. */
static double
log_mean_energy(const struct site *site)
{
	double sum = 0, n = 0;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed > 0) {
			sum += site->run[r].speed * site->run[r].speed / 2;
			n++;
		}
	return n > 0 ? el_log(sum / n) : 0;
}

static void
fill_covariance_of_smooth_curves(
    struct leave_out *l, struct block *b, bool feed)
{
	double middle = log_mean_energy(l->site);
	for (size_t i = 0; i < b->n; i++) {
		size_t c = b->first + i;
		double P = l->passing[c], v = l->site->run[l->of[c].run].speed;
		double x = curve_of_cell(l, &l->of[c])->size[l->of[c].sieve];
		b->cell[i] = (struct cell){.run = l->of[c].run,
		    .log_size = el_log(x),
		    .t = feed ? 0 : discrepancy_speed_to_coordinate(v, middle),
		    .h = discrepancy_scale_at_passing(P)};
		b->value[i] = logit(P);
		b->slope[i] = 1 / (P * (1 - P));
		l->shift[c * l->n + c] = b->slope[i];
	}
	for (size_t k = 0; k < SMOOTHS; k++)
		b->hyper[k] = el_log(SMOOTH[k].median);
	/* The prior of the level, the steepness, and their change with the
	 * speed. */
	for (size_t i = 0; i < b->n; i++)
		for (size_t j = 0; j < b->n; j++) {
			const struct cell *x = &b->cell[i], *y = &b->cell[j];
			double P = l->passing[b->first + i];
			double sizes = (x->log_size - b->cell[0].log_size) *
				       (y->log_size - b->cell[0].log_size);
			b->fixed[i * b->n + j] =
			    25 + 4 * sizes + x->t * y->t * (0.1 + 0.01 * sizes);
			bool corner =
			    P > COARSE ||
			    is_first_sieve_below_100_percent(l, b->first + i);
			b->fixed[i * b->n + j] +=
			    i == j && corner ? CORNER * CORNER : 0;
		}
}

/* Adds the covariance that a parameter's bounds allow.  J: its column of a
 * Jacobian with n columns; wide: half the width of the bounds.  A parameter
 * that may move a passing by more than `far` is practically free, and a larger
 * variance would drown the errors in rounding. */
static void
add_covariance_within_param_bounds(
    struct block *b, const double *J, size_t n, double wide)
{
	const double far = 10;
	double most = 0;
	for (size_t i = 0; i < b->n; i++)
		most = fmax(most, fabs(J[i * n]));
	wide = fmin(wide, far / fmax(most, 1e-300));
	for (size_t i = 0; i < b->n; i++)
		for (size_t k = 0; k < b->n; k++)
			b->fixed[i * b->n + k] +=
			    wide * wide * J[i * n] * J[k * n];
}

static void
fill_block_of_residuals(
    struct leave_out *l, struct block *b, const struct posterior *p)
{
	struct misfit *m = misfit_new(l->site, NULL, NULL, false, p->settings);
	size_t n = m->of->n;
	FREED double *J = xcalloc_doubles(b->n * n);
	misfit_jacobian(m, &p->fit, b->value, J);
	for (size_t i = 0; i < b->n; i++) {
		const struct leave_out_cell *c = &l->of[i];
		const struct run *run = &l->site->run[c->run];
		double P = run->product.passing[c->sieve];
		b->value[i] = -b->value[i];
		b->slope[i] = l->shift[i * l->n + i] = 1;
		b->cell[i] = (struct cell){.run = c->run,
		    .log_size = el_log(run->product.size[c->sieve]),
		    .t = discrepancy_speed_to_coordinate(run->speed, p->middle),
		    .h = discrepancy_scale_at_passing(P - b->value[i] / 2)};
	}
	for (size_t j = 0; j < n; j++)
		add_covariance_within_param_bounds(
		    b, J + j, n, (p->bounds.upper[j] - p->bounds.lower[j]) / 2);
	for (size_t k = 0; k < HYPERS; k++)
		b->hyper[k] = el_log(HYPER[k].median);
	misfit_free(m);
}

/* Computes gain [covered], the change of a run's product per change of a
 * passing of its feed. */
static void
product_change_per_feed_passing(const struct run *run, size_t sieve,
    const struct posterior *p, double *gain)
{
	const double more = 1e-4;
	size_t n = misfit_count_covered_sieves(run);
	double *product[2] = {xcalloc_doubles(n), xcalloc_doubles(n)};
	for (size_t k = 0; k < 2; k++) {
		struct psd feed = psd_copy(&run->feed);
		feed.passing[sieve] += k == 1 ? more : -more;
		struct model *model =
		    model_new(&feed, run->product.size, n, p->settings);
		model_set_params(model, &p->fit);
		model_compute_product(model, run->speed, product[k]);
		model_free(model);
		psd_free(&feed);
	}
	for (size_t i = 0; i < n; i++)
		gain[i] = (product[1][i] - product[0][i]) / (2 * more);
	free(product[0]);
	free(product[1]);
}

/* Puts the response of the products to a feed's cell into the cell's shift.
 * The products are compared with the model's product of the feed in the site
 * file, so a feed that is too fine makes them seem too coarse. */
static void
fill_products_response_to_feed(
    struct leave_out *l, size_t cell, const struct posterior *p)
{
	const struct leave_out_cell *of = &l->of[cell];
	bool shared = !l->site->individual_feeds;
	double *u = l->shift + cell * l->n;
	FREED double *gain = xcalloc_doubles(l->block[PRODUCTS].n);
	for (size_t i = 0; i < l->block[PRODUCTS].n; i++) {
		const struct leave_out_cell *c = &l->of[i];
		const struct run *run = &l->site->run[c->run];
		if (c->run != of->run && !shared)
			continue;
		if (c->sieve == 0)
			product_change_per_feed_passing(
			    run, of->sieve, p, gain);
		u[i] = -gain[c->sieve];
	}
}

/* Adds the feeds' own errors to the products, and their covariance with the
 * feeds. */
static void
add_feed_error_covariance(struct leave_out *l)
{
	struct block *p = &l->block[PRODUCTS], *f = &l->block[FEEDS];
	for (size_t c = 0; c < f->n; c++) {
		double sd = feed_error_seen_by_products(l) * f->cell[c].h;
		const double *u = l->shift + (f->first + c) * l->n;
		for (size_t i = 0; i < p->n; i++) {
			for (size_t j = 0; j < p->n; j++)
				p->fixed[i * p->n + j] += sd * sd * u[i] * u[j];
			l->cross[c * p->n + i] =
			    sd * sd * u[i] * u[f->first + c];
		}
	}
}

static void
block_init(struct block *b, bool smooth)
{
	b->smooth = smooth;
	b->cell = xcalloc(b->n + 1, sizeof *b->cell);
	b->value = xcalloc_doubles(b->n);
	b->slope = xcalloc_doubles(b->n);
	b->work = xcalloc_doubles(b->n);
	b->fixed = xcalloc_doubles(b->n * b->n);
	b->U = xcalloc_doubles(b->n * b->n);
}

struct leave_out *
leave_out_new(
    const struct site *site, const struct posterior *posterior, double noise)
{
	struct leave_out *l = xcalloc(1, sizeof *l);
	l->site = site;
	l->noise = noise;
	list_checkable_cells(l, posterior);
	block_init(&l->block[PRODUCTS], posterior == NULL);
	block_init(&l->block[FEEDS], true);
	l->passing = xcalloc_doubles(l->n);
	l->shift = xcalloc_doubles(l->n * l->n);
	l->cross = xcalloc_doubles(l->block[FEEDS].n * l->block[PRODUCTS].n);
	l->dropped = xcalloc(l->n + 1, sizeof *l->dropped);
	for (size_t i = 0; i < l->n; i++)
		l->passing[i] =
		    curve_of_cell(l, &l->of[i])->passing[l->of[i].sieve];
	fill_covariance_of_smooth_curves(l, &l->block[FEEDS], true);
	if (posterior == NULL) {
		fill_covariance_of_smooth_curves(l, &l->block[PRODUCTS], false);
		return l;
	}
	fill_block_of_residuals(l, &l->block[PRODUCTS], posterior);
	for (size_t c = l->block[FEEDS].first; c < l->n; c++)
		fill_products_response_to_feed(l, c, posterior);
	add_feed_error_covariance(l);
	return l;
}

void
leave_out_free(struct leave_out *l)
{
	if (l == NULL)
		return;
	for (size_t k = 0; k < BLOCKS; k++) {
		struct block *b = &l->block[k];
		free(b->cell);
		free(b->value);
		free(b->slope);
		free(b->work);
		free(b->fixed);
		free(b->U);
	}
	free(l->of);
	free(l->passing);
	free(l->shift);
	free(l->cross);
	free(l->dropped);
	free(l);
}
