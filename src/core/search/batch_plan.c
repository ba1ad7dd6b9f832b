/* Divides a misfit into the classes, sieves and weights that the kernel sums.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/batch_plan.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/model/appearance.h"
#include "core/model/classes.h"
#include "core/numeric/elementary.h"

/* Classes are at most this wide in ln x: a little more than a quarter octave,
 * so that each step of the EN 933 series (1.4 or 1.43) makes two. */
static const double WIDEST = 0.18;

/* Collects the feed and product sieves of all runs between the coarsest and the
 * finest feed sieve: ln x, coarsest first.  Returns their number. */
static size_t
collect_sieve_edges(const struct misfit *m, double *edge)
{
	double top = -1e3, bottom = 1e3;
	size_t n = 0, kept = 0;
	for (size_t r = 0; r < m->n_run; r++) {
		const struct psd *feed = &m->run[r].feed;
		for (size_t i = 0; i < feed->n; i++)
			edge[n++] = el_log(feed->size[i]);
		top = fmax(top, el_log(feed->size[0]));
		bottom = fmin(bottom, el_log(feed->size[feed->n - 1]));
	}
	for (size_t r = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++)
			edge[n++] = el_log(m->run[r].sieve[i]);
	for (size_t i = 0; i < n; i++)
		if (edge[i] <= top && edge[i] >= bottom)
			edge[kept++] = edge[i];
	return psd_sort_distinct_sizes(edge, kept, 1e-12);
}

static void
fill_plan_integration_classes(
    struct batch_plan *plan, const double *edge, size_t n)
{
	size_t room = 0;
	for (size_t e = 0; e + 1 < n; e++)
		room += (size_t)((edge[e] - edge[e + 1]) / WIDEST) + 1;
	plan->upper = xcalloc_doubles(room);
	plan->lower = xcalloc_doubles(room);
	plan->middle = xcalloc_doubles(room);
	for (size_t e = 0; e + 1 < n; e++) {
		double width = edge[e] - edge[e + 1];
		size_t parts = (size_t)(width / WIDEST) + 1;
		for (size_t i = 0; i < parts; i++) {
			size_t c = plan->n_class++;
			plan->upper[c] =
			    edge[e] - width * (double)i / (double)parts;
			plan->lower[c] =
			    i + 1 == parts ? edge[e + 1]
					   : edge[e] - width * (double)(i + 1) /
							   (double)parts;
			plan->middle[c] = (plan->upper[c] + plan->lower[c]) / 2;
		}
	}
}

/* Returns dF / d ln x of a feed at ln x = t. */
static double
feed_share_per_log_size(const struct psd *feed, double t)
{
	for (size_t i = 0; i + 1 < feed->n; i++) {
		double upper = el_log(feed->size[i]);
		double lower = el_log(feed->size[i + 1]);
		if (t <= upper && t >= lower)
			return (feed->passing[i] - feed->passing[i + 1]) /
			       (upper - lower);
	}
	return 0;
}

/* Returns -ln u of node j, which is proportional to j (1 + j / BEND): nodes lie
 * close near u = 1, where p(u) bends, and further apart below. */
static double
minus_log_size_ratio_of_node(size_t j)
{
	const double BEND = 16, last = KERNEL_NODES - 1;
	double deepest = -el_log(APPEARANCE_FINEST), at = (double)j;
	return deepest * at * (1 + at / BEND) / (last * (1 + last / BEND));
}

static void
fill_plan_progeny_nodes(struct batch_plan *plan)
{
	for (size_t j = 0; j < KERNEL_NODES; j++) {
		plan->log_u[j] = -minus_log_size_ratio_of_node(j);
		plan->u[j] = el_exp(-minus_log_size_ratio_of_node(j));
		plan->half_step[j] = (minus_log_size_ratio_of_node(j + 1) -
					 minus_log_size_ratio_of_node(j)) /
				     2;
	}
}

static struct node_interpolation
interpolation_weights_at_log_ratio(double depth)
{
	struct node_interpolation v = {.node = KERNEL_NODES - 2};
	if (depth > minus_log_size_ratio_of_node(KERNEL_NODES - 1))
		return v;
	v.node = 0;
	while (v.node < KERNEL_NODES - 2 &&
	       minus_log_size_ratio_of_node(v.node + 1) < depth)
		v.node++;
	double step = minus_log_size_ratio_of_node(v.node + 1) -
		      minus_log_size_ratio_of_node(v.node);
	v.coarse = (minus_log_size_ratio_of_node(v.node + 1) - depth) / step;
	v.fine = 1 - v.coarse;
	v.below_coarse = step * v.coarse * v.coarse / 2;
	v.below_fine = step * v.coarse - v.below_coarse;
	return v;
}

static void
fill_batch_plan_sieve(
    const struct batch_plan *plan, struct plan_sieve *s, double log_s)
{
	s->log_size = log_s;
	s->view = xcalloc(plan->n_class, sizeof *s->view);
	for (size_t c = 0; c < plan->n_class; c++) {
		if (plan->lower[c] < log_s - 1e-12)
			break;
		s->n_above = c + 1;
		s->view[c] =
		    interpolation_weights_at_log_ratio(plan->middle[c] - log_s);
	}
}

/* Lists the sieves of all runs together, and each run's passings at them. */
static void
fill_plan_sieves_and_targets(struct batch_plan *plan, const struct misfit *m)
{
	size_t room = m->n_residual, n = 0, cell = 0;
	FREED double *sieve = xcalloc_doubles(room);
	for (size_t r = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++)
			sieve[n++] = m->run[r].sieve[i];
	plan->n_sieve = psd_sort_distinct_sizes(sieve, n, 0);
	plan->sieve = xcalloc(plan->n_sieve, sizeof *plan->sieve);
	for (size_t s = 0; s < plan->n_sieve; s++)
		fill_batch_plan_sieve(plan, &plan->sieve[s], el_log(sieve[s]));
	for (size_t r = 0; r < m->n_run; r++) {
		const struct misfit_run *from = &m->run[r];
		struct plan_run *run = &plan->run[r];
		run->n_target = plan->n_sieve;
		run->target = xcalloc(plan->n_sieve, sizeof *run->target);
		for (size_t i = 0, s = 0; i < from->n; i++) {
			while (sieve[s] > from->sieve[i])
				s++;
			run->target[s].cell = cell++;
			run->target[s].difference =
			    psd_passing(&from->feed, sieve[s]) -
			    from->measured[i];
			run->target[s].measured = from->measured[i];
			run->target[s].weight = from->weight[i];
		}
	}
}

static void
fill_batch_plan_for_continuous(struct batch_plan *plan, const struct misfit *m)
{
	size_t room = m->n_residual;
	for (size_t r = 0; r < m->n_run; r++)
		room += m->run[r].feed.n;
	plan->one_feed = true;
	FREED double *edge = xcalloc_doubles(room);
	fill_plan_integration_classes(plan, edge, collect_sieve_edges(m, edge));
	fill_plan_progeny_nodes(plan);
	for (size_t r = 0; r < m->n_run; r++) {
		struct plan_run *run = &plan->run[r];
		run->mass = xcalloc_doubles(plan->n_class);
		run->whole = xcalloc_doubles(plan->n_class);
		for (size_t c = 0; c < plan->n_class; c++) {
			run->mass[c] = feed_share_per_log_size(
			    &m->run[r].feed, plan->middle[c]);
			run->whole[c] =
			    run->mass[c] * (plan->upper[c] - plan->lower[c]);
			plan->one_feed = plan->one_feed &&
					 run->mass[c] == plan->run[0].mass[c];
		}
	}
	fill_plan_sieves_and_targets(plan, m);
	plan->scratch = KERNEL_LANES * 2 * plan->n_run *
			(2 * plan->n_class + 1 + KERNEL_NODES);
}

static void
fill_batch_plan_run_for_classes(struct plan_run *run,
    const struct misfit_run *from, enum appearance_form form, size_t first)
{
	const struct psd *feed = &from->feed;
	size_t n = run->n_size = feed->n;
	FREED double *x = xcalloc_doubles(n);
	classes_compute_sizes(feed, x);
	run->mass = xcalloc_doubles(n);
	run->log_size = xcalloc_doubles(n);
	run->argument = xcalloc_doubles(n * n);
	run->view = xcalloc(n * n, sizeof *run->view);
	for (size_t i = 0; i < n; i++) {
		run->log_size[i] = el_log(x[i]);
		run->mass[i] =
		    feed->passing[i] - (i + 1 < n ? feed->passing[i + 1] : 0);
		for (size_t j = 0; j < n; j++) {
			run->argument[i * n + j] =
			    appearance_argument(form, x[i], x[j]);
			if (j >= i)
				run->view[i * n + j] =
				    interpolation_weights_at_log_ratio(
					el_log(x[i] / x[j]));
		}
	}
	run->n_target = from->n;
	run->target = xcalloc(from->n, sizeof *run->target);
	for (size_t s = 0; s < from->n; s++) {
		struct plan_target *t = &run->target[s];
		double size = from->sieve[s];
		while (t->sieve + 2 < n && feed->size[t->sieve + 1] > size)
			t->sieve++;
		double upper = feed->size[t->sieve];
		double lower = feed->size[t->sieve + 1];
		double share = el_log(size / lower) / el_log(upper / lower);
		t->share = fmin(fmax(share, 0), 1);
		t->feed = psd_passing(feed, size);
		t->measured = from->measured[s];
		t->weight = from->weight[s];
		t->cell = first + s;
	}
}

static void
fill_batch_plan_for_classes(struct batch_plan *plan, const struct misfit *m)
{
	size_t widest = 0, cell = 0;
	for (size_t r = 0; r < m->n_run; r++) {
		fill_batch_plan_run_for_classes(
		    &plan->run[r], &m->run[r], m->settings.appearance, cell);
		cell += m->run[r].n;
		if (plan->run[r].n_size > widest)
			widest = plan->run[r].n_size;
	}
	fill_plan_progeny_nodes(plan);
	plan->scratch =
	    KERNEL_LANES * (3 * widest + 2 * plan->n_run * KERNEL_NODES);
}

static void
fill_plan_break_size_bins(struct batch_plan *plan, const struct misfit *m)
{
	double mean = 0, low = 1e3, high = -1e3;
	for (size_t r = 0; r < m->n_run; r++) {
		const struct psd *feed = &m->run[r].feed;
		mean += plan->run[r].E / (double)m->n_run;
		low = fmin(low, el_log(feed->size[feed->n - 1]));
		high = fmax(high, el_log(feed->size[0]));
	}
	plan->over_E = 1 / mean;
	plan->bottom = low;
	plan->per_bin = KERNEL_BINS / (high - low);
}

void
batch_plan_set_speed(struct batch_plan *plan, size_t run, double v)
{
	plan->run[run].v = v;
	plan->run[run].E = specific_energy_at_speed(v);
	plan->run[run].log_E = el_log(plan->run[run].E);
}

void
batch_plan_fill(struct batch_plan *plan, const struct misfit *m)
{
	const struct breakage *of = BREAKAGES[m->settings.breakage];
	*plan = (struct batch_plan){.method = m->settings.method,
	    .k = m->settings.k,
	    .bypass = of->bypass ? of->n - 1 : 0,
	    .n_run = m->n_run,
	    .run = xcalloc(m->n_run, sizeof *plan->run)};
	plan->impacts = m->settings.impacts;
	if (plan->impacts.n > 0) {
		const struct impacts *i = &plan->impacts;
		plan->log_most = el_log(i->ratio[i->n - 1]);
		plan->log_least = el_log(i->ratio[0]);
	}
	for (size_t r = 0; r < m->n_run; r++)
		batch_plan_set_speed(plan, r, m->run[r].speed);
	fill_plan_break_size_bins(plan, m);
	if (plan->method == METHOD_CLASSES)
		fill_batch_plan_for_classes(plan, m);
	else
		fill_batch_plan_for_continuous(plan, m);
}

void
batch_plan_clear(struct batch_plan *plan)
{
	for (size_t r = 0; r < plan->n_run; r++) {
		free(plan->run[r].mass);
		free(plan->run[r].whole);
		free(plan->run[r].target);
		free(plan->run[r].log_size);
		free(plan->run[r].argument);
		free(plan->run[r].view);
	}
	for (size_t s = 0; s < plan->n_sieve; s++)
		free(plan->sieve[s].view);
	free(plan->run);
	free(plan->sieve);
	free(plan->upper);
	free(plan->lower);
	free(plan->middle);
}
