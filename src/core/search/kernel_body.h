/* The kernel's arithmetic, compiled once for each instruction set.
 *
 * A candidate's misfit must never depend on its neighbours: a branch may depend
 * on all lanes of a block only if both ways give each lane the same bits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>

#include "core/search/kernel.h"
#include "core/search/lanes.h"
#include "core/search/batch_plan.h"

/* The whole kernel is compiled for each model. */
#define INLINE static inline __attribute__((always_inline))

/* A block's parameters and values derived from them.  own: parameters of the
 * model's appearance; over_total: the factor of the broken mass, 1 / total
 * times the share that does not bypass the rotor (D14). */
struct block {
	lanes f, alpha, over_alpha, f_e0, log_e0, log_full, kept, over_total,
	    own[7];
	/* Set if any lane has two strengths: values for the softer rock. */
	bool two;
	lanes softer, share;
	const struct impacts *impacts; /* NULL: a single impact at v^2/2 */
	const uint32_t *index;
	const struct kernel_out *out;
};

/* p = dB / d ln u at a node of u, and B up to the node, both times the
 * total. */
struct node {
	lanes p, below;
};

/* A model's part of the kernel.  strength: index of f_mat; e0_min and alpha
 * follow it.  nodes: fills a table [KERNEL_NODES], or one for each run if B
 * depends on the speed (per_run), and returns the total.  at_sieve: returns the
 * factor of B at a sieve of ln s, or NULL.  density: returns p at u for
 * `classes`, or NULL to use the nodes. */
struct lane_model {
	size_t strength;
	bool per_run;
	void (*load)(
	    struct block *b, const double *const *theta, const uint32_t *index);
	lanes (*nodes)(const struct block *b, const struct batch_plan *plan,
	    struct node *node);
	lanes (*at_sieve)(const struct block *b, double log_s);
	lanes (*density)(const struct block *b, const struct plan_run *run,
	    double u, double log_u, double log_y);
};

/* If f (x^alpha E - e0) exceeds this throughout a class, the whole class is
 * taken to break: less than 2e-4 of it does not, and still less of coarser
 * ones. */
static const double FULL = 9;

/* The slope of the exponent in ln x is alpha (f e0 + exponent).  If it is less
 * than this at x*, two Gauss points per class are as good as three. */
static const double SMOOTH = 6;

/* Gauss-Legendre points on an interval, measured from its upper end. */
struct gauss {
	size_t n;
	double from_top[3], weight[3];
};

static const struct gauss GAUSS_2 = {
    2, {0.2113248654051871, 0.7886751345948129, 0}, {0.5, 0.5, 0}};
static const struct gauss GAUSS_3 = {3,
    {0.1127016653792583, 0.5, 0.8872983346207417},
    {5.0 / 18, 8.0 / 18, 5.0 / 18}};

/* S is 0 below the size of log_e0 and 1 above that of log_full, where the
 * exponent reaches FULL. */
static inline void
set_breakage_threshold(struct block *b, lanes e0)
{
	double full = FULL;
	if (b->impacts != NULL && b->impacts->number < 1)
		full /= b->impacts->number;
	b->f_e0 = b->f * e0;
	b->log_e0 = lanes_log(e0);
	b->log_full = lanes_log(full / b->f + e0);
}

INLINE void
gather_params_to_lanes(const struct lane_model *m, struct block *b,
    const struct batch_plan *plan, const double *const *theta,
    const uint32_t *index)
{
	m->load(b, theta, index);
	b->f = lanes_gather(theta[m->strength], index) * plan->k;
	b->alpha = lanes_gather(theta[m->strength + 2], index);
	b->over_alpha = 1 / lanes_max(b->alpha, lanes_broadcast(1e-9));
	b->impacts = plan->impacts.n > 0 ? &plan->impacts : NULL;
	set_breakage_threshold(b, lanes_gather(theta[m->strength + 1], index));
	b->two = false;
	if (b->out->softer != NULL) {
		b->softer = lanes_gather(b->out->softer, index);
		b->share = lanes_gather(b->out->share, index);
		b->two = lanes_any(b->share > 0.0);
	}
	if (plan->bypass > 0)
		b->kept = 1 - lanes_gather(theta[plan->bypass], index);
}

static inline lanes
at_least_0(lanes a)
{
	return lanes_max(a, lanes_broadcast(0));
}

/* The broken mass S dF of a class, and its first moment about the middle. */
struct broken_share {
	lanes mass, moment;
};

/* Workspace of a block, in the thread's scratch. */
struct kernel_workspace {
	lanes *from, *full; /* [n_run] ln x* and ln x where S becomes 1 */
	struct broken_share *share; /* [n_run * n_class], and as many again */
	struct node *node;          /* [KERNEL_NODES] for each run, or once */
	size_t n_full;              /* number of classes, from the coarsest,
				     * that break entirely */
	size_t n_active;            /* number of classes of which any lane
				     * breaks some */
};

/* Fills the nodes of every run, or one table for all runs. */
INLINE void
tabulate_progeny_of_runs(const struct lane_model *m, struct block *b,
    const struct batch_plan *plan, const struct kernel_workspace *room)
{
	lanes sum = m->nodes(b, plan, room->node);
	/* If p is 0 everywhere, nothing breaks: product = feed. */
	b->over_total = (lanes)((sum > 0.0) & (lanes_mask)(1 / sum));
	if (plan->bypass > 0)
		b->over_total *= b->kept;
}

/* Returns x^alpha at ln x = t. */
static inline lanes
lanes_pow_alpha_at_log(const struct block *b, lanes t)
{
	return lanes_exp_quick(lanes_min(b->alpha * t, lanes_broadcast(708)));
}

/* Returns S with a spectrum of impacts (D15), at = f E x^alpha; see
 * selection_share_by_impacts. */
static inline lanes
broken_share_with_spectrum(const struct block *b, lanes at)
{
	const struct impacts *of = b->impacts;
	lanes kept = lanes_broadcast(0);
	for (size_t j = 0; j < of->n; j++)
		kept += of->share[j] *
			lanes_exp_quick(lanes_min(
			    b->f_e0 - of->ratio[j] * at, lanes_broadcast(0)));
	kept = lanes_max(kept, lanes_broadcast(1e-300));
	return 1 - lanes_exp_quick(of->number * lanes_log(kept));
}

/* Returns S of Eq 3, from power = x^alpha.  selection.h has the version for one
 * candidate. */
static inline lanes
lanes_broken_share(
    const struct block *b, double E, lanes power, lanes exp_of(lanes x))
{
	lanes y = b->f * E * power - b->f_e0;
	if (b->impacts != NULL)
		return broken_share_with_spectrum(b, b->f * E * power);
	return 1 - exp_of(lanes_min(-y, lanes_broadcast(0)));
}

/* Adds a Gauss point at this distance from the middle of its class. */
static inline void
add_gauss_point(struct broken_share *sum, const struct block *b, double E,
    lanes power, lanes weight, lanes distance)
{
	lanes S = lanes_broken_share(b, E, power, lanes_exp_quick);
	sum->mass += weight * S;
	sum->moment += weight * distance * S;
}

/* Returns the share of a class that breaks, if S > 0 throughout the class.
 * power: x^alpha at the points of g. */
static inline struct broken_share
broken_share_of_whole_class(const struct block *b,
    const struct batch_plan *plan, size_t c, const struct plan_run *run,
    const struct gauss *g, const lanes *power)
{
	double upper = plan->upper[c], width = upper - plan->lower[c];
	struct broken_share sum = {lanes_broadcast(0), lanes_broadcast(0)};
	for (size_t q = 0; q < g->n; q++) {
		double t = upper - width * g->from_top[q];
		add_gauss_point(&sum, b, run->E, power[q],
		    lanes_broadcast(g->weight[q]),
		    lanes_broadcast(t - plan->middle[c]));
	}
	double scale = run->mass[c] * width;
	return (struct broken_share){scale * sum.mass, scale * sum.moment};
}

/* Returns the share of a class that breaks, if x* of some lanes lies in the
 * class; the other lanes get the same bits as from
 * broken_share_of_whole_class. */
static inline struct broken_share
broken_share_of_split_class(const struct block *b,
    const struct batch_plan *plan, size_t c, const struct plan_run *run,
    const struct gauss *g, lanes from)
{
	double upper = plan->upper[c];
	lanes bottom =
	    lanes_min(lanes_max(from, lanes_broadcast(plan->lower[c])),
		lanes_broadcast(upper));
	lanes width = upper - bottom;
	struct broken_share sum = {lanes_broadcast(0), lanes_broadcast(0)};
	for (size_t q = 0; q < g->n; q++) {
		lanes t = upper - width * g->from_top[q];
		add_gauss_point(&sum, b, run->E, lanes_pow_alpha_at_log(b, t),
		    lanes_broadcast(g->weight[q]), t - plan->middle[c]);
	}
	lanes scale = run->mass[c] * width;
	return (struct broken_share){scale * sum.mass, scale * sum.moment};
}

/* Computes the shares of class c in every run.  any: some lane breaks some of
 * it; all: every lane breaks all of it in every run. */
static inline void
compute_broken_shares_of_class(const struct block *b,
    const struct batch_plan *plan, size_t c, const struct gauss *g,
    const struct kernel_workspace *room, bool *any, bool *all)
{
	double lower = plan->lower[c], upper = plan->upper[c];
	lanes power[3] = {{0}};
	bool have_power = false;
	*any = false;
	*all = true;
	for (size_t r = 0; r < plan->n_run; r++) {
		const struct plan_run *run = &plan->run[r];
		struct broken_share *share =
		    &room->share[r * plan->n_class + c];
		lanes from = room->from[r];
		lanes_mask full = room->full[r] <= lower;
		share->mass = lanes_broadcast(run->whole[c]);
		share->moment = lanes_broadcast(0);
		if (lanes_all(full)) {
			*any = true;
			continue;
		}
		*all = false;
		if (!lanes_any(from < upper)) {
			share->mass = share->moment;
			continue;
		}
		*any = true;
		bool whole = lanes_all(from <= lower);
		double width = upper - lower;
		for (size_t q = 0; whole && !have_power && q < g->n; q++)
			power[q] = lanes_pow_alpha_at_log(
			    b, lanes_broadcast(upper - width * g->from_top[q]));
		have_power = have_power || whole;
		struct broken_share part =
		    whole
			? broken_share_of_whole_class(b, plan, c, run, g, power)
			: broken_share_of_split_class(b, plan, c, run, g, from);
		share->mass = lanes_select(full, share->mass, part.mass);
		share->moment = (lanes)(~full & (lanes_mask)part.moment);
	}
}

static inline void
compute_broken_shares(const struct block *b, const struct batch_plan *plan,
    const struct gauss *g, struct kernel_workspace *room)
{
	bool any = true, all = true;
	for (size_t r = 0; r < plan->n_run; r++) {
		double log_E = plan->run[r].log_E;
		double most = log_E + plan->log_most;
		double least = log_E + plan->log_least;
		room->from[r] = (b->log_e0 - most) * b->over_alpha;
		room->full[r] = (b->log_full - least) * b->over_alpha;
	}
	size_t c = 0;
	for (room->n_full = 0; c < plan->n_class; c++) {
		bool full = all;
		compute_broken_shares_of_class(b, plan, c, g, room, &any, &all);
		if (!any)
			break;
		all = all && full;
		room->n_full += all;
	}
	room->n_active = c;
}

/* Mixes the shares of the softer rock into those of the harder.  The two parts
 * of a rock break independently. */
static inline void
mix_softer_rock_shares(const struct block *b, const struct batch_plan *plan,
    const struct gauss *g, struct kernel_workspace *room)
{
	struct block soft = *b;
	struct kernel_workspace other = *room;
	size_t n = plan->n_class;
	other.share += plan->n_run * n;
	set_breakage_threshold(&soft, b->softer);
	compute_broken_shares(&soft, plan, g, &other);
	for (size_t r = 0; r < plan->n_run; r++)
		for (size_t c = room->n_full; c < other.n_active; c++) {
			struct broken_share *to = &room->share[r * n + c];
			const struct broken_share *of = &other.share[r * n + c];
			if (c >= room->n_active)
				to->mass = to->moment = lanes_broadcast(0);
			to->mass += b->share * (of->mass - to->mass);
			to->moment += b->share * (of->moment - to->moment);
		}
	room->n_active = other.n_active;
}

/* Returns B times the total. */
static inline lanes
interpolate_progeny_share(
    const struct node_interpolation *v, const struct node *node)
{
	const struct node *at = node + v->node;
	return at[1].below +
	       (v->below_fine * at[1].p + v->below_coarse * at[0].p);
}

static inline lanes
interpolate_progeny_density(
    const struct node_interpolation *v, const struct node *node)
{
	const struct node *at = node + v->node;
	return v->fine * at[1].p + v->coarse * at[0].p;
}

/* Returns the mass that the first n classes of a run, which break entirely,
 * contribute below a sieve. */
static inline lanes
mass_below_from_whole_classes(const struct plan_run *run,
    const struct plan_sieve *sieve, size_t n, const struct node *node)
{
	lanes sum = lanes_broadcast(0);
	for (size_t c = 0; c < n; c++)
		sum += run->whole[c] *
		       interpolate_progeny_share(&sieve->view[c], node);
	return sum;
}

/* Adds the mass of the classes from..n-1, for one run or a pair of runs.  If B
 * and p are the same for both, they are interpolated only once. */
INLINE void
add_mass_from_split_classes(const struct lane_model *m,
    const struct plan_sieve *sieve, size_t from, size_t n, bool pair,
    const struct node *const node[static 2],
    const struct broken_share *share[static 2], lanes below[static 2])
{
	lanes first = below[0], second = below[1];
	for (size_t c = from; c < n; c++) {
		lanes B = interpolate_progeny_share(&sieve->view[c], node[0]);
		lanes p = interpolate_progeny_density(&sieve->view[c], node[0]);
		first += share[0][c].mass * B - share[0][c].moment * p;
		if (!pair)
			continue;
		if (m->per_run) {
			B = interpolate_progeny_share(&sieve->view[c], node[1]);
			p = interpolate_progeny_density(
			    &sieve->view[c], node[1]);
		}
		second += share[1][c].mass * B - share[1][c].moment * p;
	}
	below[0] = first;
	below[1] = second;
}

/* Returns the square of a weighted difference and stores the difference on
 * request. */
static inline lanes
square_and_store_difference(
    const struct plan_target *t, const struct block *b, lanes d)
{
	d *= t->weight;
	if (b->out->difference != NULL && t->weight > 0)
		for (size_t l = 0; l < LANES; l++)
			b->out->difference[t->cell * b->out->stride +
					   b->index[l]] = d[l];
	return d * d;
}

/* Returns the sum over the runs of a sieve's squared weighted differences. */
INLINE lanes
sum_squares_at_sieve(const struct lane_model *m, const struct batch_plan *plan,
    const struct block *b, size_t s, const struct kernel_workspace *room)
{
	const struct plan_sieve *sieve = &plan->sieve[s];
	size_t n =
	    sieve->n_above < room->n_active ? sieve->n_above : room->n_active;
	size_t full = room->n_full < n ? room->n_full : n;
	bool once = plan->one_feed && !m->per_run;
	lanes squares = lanes_broadcast(0), whole = squares;
	if (once)
		whole = mass_below_from_whole_classes(
		    &plan->run[0], sieve, full, room->node);
	for (size_t r = 0; r < plan->n_run; r += 2) {
		bool pair = r + 1 < plan->n_run;
		size_t other = r + pair;
		const struct plan_run *run[2] = {
		    &plan->run[r], &plan->run[other]};
		const struct broken_share *share[2] = {
		    room->share + r * plan->n_class,
		    room->share + other * plan->n_class};
		const struct node *node[2] = {room->node, room->node};
		if (m->per_run) {
			node[0] += r * KERNEL_NODES;
			node[1] += other * KERNEL_NODES;
		}
		lanes below[2] = {whole, whole};
		for (size_t i = 0; i < 1 + (size_t)pair && !once; i++)
			below[i] = mass_below_from_whole_classes(
			    run[i], sieve, full, node[i]);
		if (pair)
			add_mass_from_split_classes(
			    m, sieve, full, n, true, node, share, below);
		else
			add_mass_from_split_classes(
			    m, sieve, full, n, false, node, share, below);
		if (m->at_sieve != NULL) {
			lanes share_at = m->at_sieve(b, sieve->log_size);
			below[0] *= share_at;
			below[1] *= share_at;
		}
		for (size_t i = 0; i < 1 + (size_t)pair; i++) {
			const struct plan_target *t = &run[i]->target[s];
			squares += square_and_store_difference(
			    t, b, t->difference + below[i] * b->over_total);
		}
	}
	return squares;
}

INLINE lanes
misfits_by_continuous_model(const struct lane_model *m,
    const struct batch_plan *plan, struct block *b, bool smooth,
    double *scratch)
{
	lanes *at = (lanes *)(void *)scratch, sum = lanes_broadcast(0);
	size_t n_run = plan->n_run;
	struct kernel_workspace room = {.from = at, .full = at + n_run};
	room.share = (void *)(at + 2 * n_run);
	room.node = (void *)(room.share + 2 * n_run * plan->n_class);
	tabulate_progeny_of_runs(m, b, plan, &room);
	if (smooth)
		compute_broken_shares(b, plan, &GAUSS_2, &room);
	else
		compute_broken_shares(b, plan, &GAUSS_3, &room);
	if (b->two)
		mix_softer_rock_shares(
		    b, plan, smooth ? &GAUSS_2 : &GAUSS_3, &room);
	for (size_t s = 0; s < plan->n_sieve; s++)
		sum += sum_squares_at_sieve(m, plan, b, s, &room);
	return sum;
}

/* Computes the selection for each class of a run, method `classes`. */
static inline void
compute_class_break_shares(
    const struct block *b, const struct plan_run *run, lanes *S)
{
	for (size_t i = 0; i < run->n_size; i++) {
		lanes w = lanes_exp(b->alpha * run->log_size[i]);
		S[i] = lanes_broken_share(b, run->E, w, lanes_exp);
		if (!b->two)
			continue;
		struct block soft = *b;
		soft.f_e0 = b->f * b->softer;
		lanes softer = lanes_broken_share(&soft, run->E, w, lanes_exp);
		S[i] += b->share * (softer - S[i]);
	}
}

/* Breaks parent class i into the product q. */
INLINE void
break_size_class(const struct lane_model *m, const struct block *b,
    const struct plan_run *run, const struct node *node, size_t i, lanes S,
    lanes *p, lanes *q)
{
	lanes sum = lanes_broadcast(0);
	size_t n = run->n_size;
	for (size_t j = i; j < n; j++) {
		double log_y = run->log_size[j];
		p[j] = m->density != NULL
			   ? m->density(b, run, run->argument[i * n + j],
				 log_y - run->log_size[i], log_y)
			   : interpolate_progeny_density(
				 &run->view[i * n + j], node);
		sum += p[j];
	}
	double f = run->mass[i];
	lanes_mask breaks = sum > 0.0;
	q[i] += f * lanes_select(breaks, 1 - S, lanes_broadcast(1));
	lanes share = (lanes)(breaks & (lanes_mask)(S * f / sum));
	for (size_t j = i; j < n; j++)
		q[j] += p[j] * share;
}

INLINE lanes
evaluate_run_by_size_classes(const struct lane_model *m,
    const struct batch_plan *plan, const struct block *b,
    const struct plan_run *run, const struct node *node, double *scratch)
{
	size_t n = run->n_size;
	lanes *S = (lanes *)(void *)scratch, *p = S + n, *q = p + n;
	lanes sum = lanes_broadcast(0);
	for (size_t i = 0; i < n; i++)
		q[i] = lanes_broadcast(0);
	compute_class_break_shares(b, run, S);
	for (size_t i = 0; i < n; i++)
		break_size_class(m, b, run, node, i, S[i], p, q);
	for (size_t j = n - 1; j-- > 0;)
		q[j] += q[j + 1];
	for (size_t s = 0; s < run->n_target; s++) {
		const struct plan_target *t = &run->target[s];
		lanes coarse = q[t->sieve], fine = q[t->sieve + 1];
		lanes P = fine + t->share * (coarse - fine);
		if (plan->bypass > 0)
			P = t->feed + b->kept * (P - t->feed);
		sum += square_and_store_difference(t, b, P - t->measured);
	}
	return sum;
}

INLINE lanes
evaluate_block_by_size_classes(const struct lane_model *m,
    const struct batch_plan *plan, const struct block *b, double *scratch)
{
	struct node *node = (void *)scratch;
	lanes sum = lanes_broadcast(0);
	if (m->density == NULL)
		m->nodes(b, plan, node);
	for (size_t r = 0; r < plan->n_run; r++) {
		size_t table = m->per_run ? r * KERNEL_NODES : 0;
		sum += evaluate_run_by_size_classes(m, plan, b, &plan->run[r],
		    node + table, (void *)(node + plan->n_run * KERNEL_NODES));
	}
	return sum;
}

INLINE void
evaluate_candidate_block(const struct lane_model *m,
    const struct batch_plan *plan, const double *const *theta,
    const uint32_t *index, bool smooth, double *scratch,
    const struct kernel_out *out)
{
	struct block b;
	b.index = index;
	b.out = out;
	gather_params_to_lanes(m, &b, plan, theta, index);
	lanes sum =
	    plan->method == METHOD_CLASSES
		? evaluate_block_by_size_classes(m, plan, &b, scratch)
		: misfits_by_continuous_model(m, plan, &b, smooth, scratch);
	for (size_t l = 0; l < LANES; l++)
		out->misfit[index[l]] = sum[l] <= 1e300 ? sum[l] : HUGE_VAL;
}

INLINE void
evaluate_candidate_lanes(const struct lane_model *m,
    const struct batch_plan *plan, const double *const *theta,
    const uint32_t *index, bool smooth, double *scratch,
    const struct kernel_out *out)
{
	for (size_t i = 0; i < KERNEL_LANES; i += LANES)
		evaluate_candidate_block(
		    m, plan, theta, index + i, smooth, scratch, out);
}

static inline void
bin_candidates_by_break_size(const struct lane_model *m,
    const struct batch_plan *plan, const double *const *theta, size_t first,
    uint16_t *bin)
{
	for (size_t i = 0; i < KERNEL_LANES; i += LANES) {
		const double *const *eq3 = theta + m->strength;
		lanes f = lanes_load(eq3[0] + first + i) * plan->k;
		lanes e0 = lanes_load(eq3[1] + first + i);
		lanes alpha = lanes_load(eq3[2] + first + i);
		lanes log_x = lanes_log(e0 * plan->over_E) / (alpha + 1e-9);
		lanes at = lanes_max(
		    (log_x - plan->bottom) * plan->per_bin, lanes_broadcast(0));
		at = lanes_min(at, lanes_broadcast(KERNEL_BINS - 1));
		lanes stiff = alpha * f * e0;
		for (size_t l = 0; l < LANES; l++)
			bin[i + l] =
			    (uint16_t)((int32_t)at[l] +
				       (stiff[l] < SMOOTH ? KERNEL_BINS : 0));
	}
}

/* Defines a model's kernel for this instruction set from the fields of its
 * struct lane_model. */
#define KERNEL_JOIN(model, isa) model##_kernel_##isa
#define KERNEL_NAME(model, isa) KERNEL_JOIN(model, isa)
#define KERNEL(model, ...)                                                     \
	static const struct lane_model model##_lanes = {__VA_ARGS__};          \
	static void model##_evaluate(const struct batch_plan *plan,            \
	    const double *const *theta, const uint32_t *index, bool smooth,    \
	    double *scratch, const struct kernel_out *out)                     \
	{                                                                      \
		evaluate_candidate_lanes(                                      \
		    &model##_lanes, plan, theta, index, smooth, scratch, out); \
	}                                                                      \
	static void model##_sort(const struct batch_plan *plan,                \
	    const double *const *theta, size_t first, uint16_t *bin)           \
	{                                                                      \
		bin_candidates_by_break_size(                                  \
		    &model##_lanes, plan, theta, first, bin);                  \
	}                                                                      \
	extern const struct model_kernel KERNEL_NAME(model, ISA);              \
	const struct model_kernel KERNEL_NAME(model, ISA) = {                  \
	    model##_evaluate, model##_sort};
