/* The paper's model: Eq 3 and the cubic of Eq 1.  Compiled as scalar code, and
 * with LANES for the kernel.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LANES

#include "core/model/breakage_grunditz.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/model/continuous.h"

/* Index of f_mat, which e0_min and alpha follow. */
enum { F_MAT = 4 };

void
grunditz_compute_breaker_constants(struct breaker *b)
{
	struct params scaled = b->p;
	params_scale_largest_beta_to_1(&scaled);
	b->appearance = appearance_from_beta(scaled.beta);
}

double
grunditz_progeny_share_finer(const struct breaker *b, double log_u, double *d)
{
	const struct appearance *a = &b->appearance;
	double parts[4], sum = 0;
	if (a->n == 0)
		return 0;
	appearance_power_integrals_up_to(a, log_u, parts);
	for (size_t i = 0; i < 4; i++)
		sum += a->beta[i] * parts[i];
	double B = sum / a->total;
	if (d == NULL)
		return B;
	double scale = 1 / (a->total * params_largest_beta(&b->p));
	for (size_t i = 0; i < 4; i++)
		d[i] += (parts[i] - B * a->whole[i]) * scale;
	return B;
}

char *
grunditz_appearance_text(const struct params *p)
{
	return xasprintf(
	    "p(u) = max(0, %.4g %c %.4g u %c %.4g u^2 %c %.4g u^3), u = "
	    "progeny / parent",
	    p->beta[0], p->beta[1] < 0 ? '-' : '+', fabs(p->beta[1]),
	    p->beta[2] < 0 ? '-' : '+', fabs(p->beta[2]),
	    p->beta[3] < 0 ? '-' : '+', fabs(p->beta[3]));
}

static double
progeny_density(const struct breaker *b, double u, double log_u, double log_x)
{
	(void)log_u;
	(void)log_x;
	return appearance_density(b->p.beta, u);
}

/* Computes the product from integrals of the broken mass, without evaluating B.
 *
 * B(s/x) is, between the zeros of p(u), a combination of 1, ln x, 1/x, 1/x^2
 * and 1/x^3, so five integrals of S dF over x > t give every product exactly:
 *   J_m(t) = integral over x > e^t of S(x) g_m(x) dF,  g = 1, 1/x, .., ln x
 * They are summed from the coarse end, where they are small, so that their
 * differences keep their digits.  The derivatives with respect to f_mat, E0_min
 * and alpha need the same five integrals of dS; those with respect to beta are
 * free, because p is linear in beta between its zeros. */
enum { MOMENTS = 5 }; /* 1, 1/x, 1/x^2, 1/x^3, ln x */

/* The integrals over x > exp(edge[e]). */
struct moments {
	double of[SHAPES][MOMENTS];
};

/* Adds the integrals of S dF (n = 1) and of its derivatives (n = SHAPES), times
 * each g_m. */
static inline void
add_quadrature_panel_moments(const struct continuous_solver *c,
    const struct panel *panel, size_t n, struct moments *sum)
{
	double shape[SHAPES][GAUSS], x1[GAUSS];
	selection_shares_by_impacts(c->b, GAUSS, panel->t, shape[0]);
	for (size_t i = 0; i < GAUSS; i++)
		x1[i] = el_exp(-panel->t[i]);
	for (size_t i = 0; i < GAUSS; i++) {
		double g[MOMENTS] = {1, x1[i], x1[i] * x1[i],
		    x1[i] * x1[i] * x1[i], panel->t[i]};
		for (size_t s = 0; s < n; s++) {
			double mass = panel->weight[i] * shape[s][i];
			for (size_t m = 0; m < MOMENTS; m++)
				sum->of[s][m] += mass * g[m];
		}
	}
}

static void
add_moments_of_S(
    const struct continuous_solver *c, const struct panel *panel, void *data)
{
	add_quadrature_panel_moments(c, panel, 1, data);
}

static void
add_moments_with_derivatives(
    const struct continuous_solver *c, const struct panel *panel, void *data)
{
	add_quadrature_panel_moments(c, panel, SHAPES, data);
}

static void
add_integral_of_moments(const struct continuous_solver *c, double a, double b,
    double density, size_t n_shape, struct moments *sum)
{
	if (n_shape > 1)
		continuous_solver_visit_panels(
		    c, a, b, density, add_moments_with_derivatives, sum);
	else
		continuous_solver_visit_panels(
		    c, a, b, density, add_moments_of_S, sum);
}

static void
integrate_moments_above_each_edge(struct continuous_solver *c, size_t n_shape)
{
	memset(&c->above[0], 0, sizeof c->above[0]);
	for (size_t e = 0; e + 1 < c->n_edge; e++) {
		c->above[e + 1] = c->above[e];
		add_integral_of_moments(c, c->edge[e + 1], c->edge[e],
		    c->density[e], n_shape, &c->above[e + 1]);
	}
}

/* Returns the integrals over x > exp(t). */
static struct moments
moments_of_sizes_above(
    const struct continuous_solver *c, double t, size_t n_shape)
{
	size_t low = 0, high = c->n_edge;
	/* Find the last edge that is not below t. */
	while (high - low > 1) {
		size_t middle = (low + high) / 2;
		if (c->edge[middle] >= t - 1e-12)
			low = middle;
		else
			high = middle;
	}
	struct moments sum = c->above[low];
	bool inside = t < c->edge[low] - 1e-12 && low + 1 < c->n_edge;
	if (inside)
		add_integral_of_moments(
		    c, t, c->edge[low], c->density[low], n_shape, &sum);
	return sum;
}

/* Adds, for the interval of x between two tables of integrals, to Q_b =
 * integral of S(x) N_b(s/x) dF, where N_b is the part of B proportional to
 * beta_b.  On the interval N_b is base_b, plus the antiderivative of u^b inside
 * a piece of p. */
static void
add_integral_between_moment_sets(double log_s, size_t n_shape,
    const struct moments *from, const struct moments *to,
    const double base[static 4], bool inside, double Q[SHAPES][4])
{
	double s = el_exp(log_s), scale[4] = {0, s, s * s / 2, s * s * s / 3};
	for (size_t i = 0; i < n_shape; i++) {
		double d[MOMENTS];
		for (size_t m = 0; m < MOMENTS; m++)
			d[m] = from->of[i][m] - to->of[i][m];
		for (size_t b = 0; b < 4; b++)
			Q[i][b] += base[b] * d[0];
		if (!inside)
			continue;
		Q[i][0] += log_s * d[0] - d[4];
		for (size_t b = 1; b < 4; b++)
			Q[i][b] += scale[b] * d[b];
	}
}

/* Computes Q from u = 2^-10 up to 1: the pieces of p and the gaps between
 * them. */
static void
integrate_appearance_pieces(const struct continuous_solver *c, double log_s,
    size_t n_shape, double Q[SHAPES][4])
{
	const struct appearance *a = &c->b->appearance;
	memset(Q, 0, sizeof(double[SHAPES][4]));
	const double none[4] = {0}, *full = none;
	struct moments outer = {0}, inner;
	for (size_t i = 0; i < a->n; i++) {
		inner =
		    moments_of_sizes_above(c, log_s - a->log_lower[i], n_shape);
		add_integral_between_moment_sets(
		    log_s, n_shape, &inner, &outer, full, false, Q);
		outer =
		    moments_of_sizes_above(c, log_s - a->log_upper[i], n_shape);
		add_integral_between_moment_sets(
		    log_s, n_shape, &outer, &inner, a->base[i], true, Q);
		full = a->full[i];
	}
	inner = moments_of_sizes_above(c, log_s, n_shape);
	add_integral_between_moment_sets(
	    log_s, n_shape, &inner, &outer, full, false, Q);
}

static double
sum_weighted_by_beta(const struct appearance *a, const double parts[static 4])
{
	double sum = 0;
	for (size_t b = 0; b < 4; b++)
		sum += a->beta[b] * parts[b];
	return sum;
}

/* Computes the derivatives of (sum beta_b Q_b) / (sum beta_b T_b), where T has
 * the integral of each power of u over all pieces.  The appearance has beta
 * divided by its largest value; derivatives with respect to the unscaled beta
 * are smaller by the same factor. */
static void
fill_broken_mass_derivatives(const struct continuous_solver *c, double broken,
    double total, const double T[static 4], double Q[SHAPES][4], double *row)
{
	const struct appearance *a = &c->b->appearance;
	double scale = params_largest_beta(&c->b->p);
	for (size_t b = 0; b < 4; b++)
		row[b] = (Q[0][b] - broken * T[b]) / total / scale;
	for (size_t i = 1; i < SHAPES; i++)
		row[F_MAT + i - 1] = sum_weighted_by_beta(a, Q[i]) / total;
}

static void
compute_product_by_moments(
    struct continuous_solver *c, double *passing, double *d_passing)
{
	const struct appearance *a = &c->b->appearance;
	size_t n_shape = d_passing != NULL ? SHAPES : 1;
	const double *T = a->whole;
	if (c->above == NULL)
		c->above = xcalloc(c->n_edge, sizeof *c->above);
	integrate_moments_above_each_edge(c, n_shape);
	double total = sum_weighted_by_beta(a, T);
	for (size_t i = 0; i < c->n_sieve; i++) {
		passing[i] = c->feed_passing[i];
		if (c->log_sieve[i] >= c->edge[0] || !(total > 0))
			continue;
		double Q[SHAPES][4];
		integrate_appearance_pieces(c, c->log_sieve[i], n_shape, Q);
		double broken = sum_weighted_by_beta(a, Q[0]) / total;
		if (d_passing != NULL)
			fill_broken_mass_derivatives(c, broken, total, T, Q,
			    d_passing + i * c->b->model->n);
		passing[i] += broken;
		passing[i] = passing[i] < 1 ? passing[i] : 1;
	}
}

static const struct param_info PARAMETERS[] = {
    GRUNDITZ_BETA, SELECTION_PARAMETERS, BYPASS_PARAMETER};

KERNELS(grunditz);

BREAKAGE_ROWS(GRUNDITZ, "grunditz", N_("Eqs 1 to 3 of the paper"), 7,
    .source = "Grunditz et al. 2021", .parameter = PARAMETERS, .gauge = 4,
    .gauge_name = "beta", .forms = true, .reference = PARAMS_MOST,
    .strength = F_MAT, .prepare = grunditz_compute_breaker_constants,
    .finer = grunditz_progeny_share_finer, .density = progeny_density,
    .product = compute_product_by_moments,
    .appearance_text = grunditz_appearance_text, .kernel = KERNEL_ROW(grunditz))

#else /* LANES */

static inline void
grunditz_load_params(
    struct block *b, const double *const *theta, const uint32_t *index)
{
	for (size_t m = 0; m < 4; m++)
		b->own[m] = lanes_gather(theta[m], index);
}

/* Returns p(u), clipped at 0. */
static inline lanes
grunditz_progeny_density(const struct block *b, const struct plan_run *run,
    double u, double log_u, double log_y)
{
	(void)run;
	(void)log_u;
	(void)log_y;
	const lanes *beta = b->own;
	return at_least_0(
	    beta[0] + u * (beta[1] + u * (beta[2] + u * beta[3])));
}

/* Computes p at the nodes of u and its integral up to each.  Returns the
 * total. */
static inline lanes
grunditz_tabulate_progeny(
    const struct block *b, const struct batch_plan *plan, struct node *node)
{
	const struct plan_run *run = &plan->run[0];
	size_t last = KERNEL_NODES - 1;
	lanes sum = lanes_broadcast(0);
	node[last].p = grunditz_progeny_density(b, run, plan->u[last], 0, 0);
	node[last].below = sum;
	for (size_t n = last; n-- > 0;) {
		node[n].p = grunditz_progeny_density(b, run, plan->u[n], 0, 0);
		sum += plan->half_step[n] * (node[n + 1].p + node[n].p);
		node[n].below = sum;
	}
	return sum;
}

KERNEL(grunditz, .strength = 4, .load = grunditz_load_params,
    .nodes = grunditz_tabulate_progeny, .density = grunditz_progeny_density)

#endif
