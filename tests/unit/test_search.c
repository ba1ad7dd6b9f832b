/* The search of a calibration: the genetic algorithm.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "made.h"

#include "core/search/ga.h"

enum { GENES = 7 };

/* A sphere, Rosenbrock's valley, and a plane that leads out of the box. */
static double
sphere(const double *x)
{
	double sum = 0;
	for (size_t g = 0; g < GENES; g++)
		sum += (x[g] - 0.3) * (x[g] - 0.3);
	return sum;
}

static double
rosenbrock(const double *x)
{
	double sum = 0;
	for (size_t g = 0; g + 1 < GENES; g++) {
		double a = x[g + 1] - x[g] * x[g], b = 1 - x[g];
		sum += 100 * a * a + b * b;
	}
	return sum;
}

static double
plane(const double *x)
{
	double sum = 0;
	for (size_t g = 0; g < GENES; g++)
		sum += g % 2 == 0 ? x[g] : -x[g];
	return sum;
}

/* The sphere with half of the box forbidden. */
static double
half_forbidden(const double *x)
{
	return x[0] > x[1] ? INFINITY : sphere(x);
}

static struct ga *
ga_of(
    size_t population, uint64_t seed, const double *lower, const double *upper)
{
	struct ga_options options = ga_options_default();
	options.population = population;
	options.seed = seed;
	if (options.elite > population / 4)
		options.elite = population / 4;
	return ga_new(&options, GENES, lower, upper);
}

static void
generation(struct ga *ga, size_t n, double (*f)(const double *))
{
	double *misfit = xcalloc_doubles(n);
	const double *const *gene = ga_next_candidates(ga);
	for (size_t i = 0; i < n; i++) {
		double x[GENES];
		for (size_t g = 0; g < GENES; g++)
			x[g] = gene[g][i];
		misfit[i] = f(x);
	}
	ga_set_misfits(ga, misfit);
	free(misfit);
}

static const double LOWER[GENES] = {-2, -2, -2, -2, -2, -2, -2};
static const double UPPER[GENES] = {2, 2, 2, 2, 2, 2, 2};

static void
the_box_is_respected(void **state)
{
	(void)state;
	enum { N = 400 };
	double (*const target[])(const double *) = {plane, sphere};
	static const double lower[GENES] = {-1000, -1000, -0.1, 0.001, 0, 0, 1};
	static const double upper[GENES] = {1000, 700.3, 0.7, 3, 30, 1, 1.1};
	for (size_t t = 0; t < ARRAY_LEN(target); t++) {
		struct ga *ga = ga_of(N, 5, lower, upper);
		for (int k = 0; k < 40; k++) {
			const double *const *gene = ga_next_candidates(ga);
			for (size_t g = 0; g < GENES; g++)
				for (size_t i = 0; i < N; i++)
					if (!(gene[g][i] >= lower[g] &&
						gene[g][i] <= upper[g]))
						fail_msg("generation %d: gene "
							 "%zu is %.17g",
						    k, g, gene[g][i]);
			generation(ga, N, target[t]);
		}
		ga_free(ga);
	}
}

static void
the_first_generation_fills_the_box(void **state)
{
	(void)state;
	enum { N = 4000 };
	struct ga *ga = ga_of(N, 9, LOWER, UPPER);
	const double *const *gene = ga_next_candidates(ga);
	for (size_t g = 0; g < GENES; g++) {
		double sum = 0, squares = 0;
		for (size_t i = 0; i < N; i++) {
			assert_true(gene[g][i] >= -2 && gene[g][i] <= 2);
			sum += gene[g][i];
			squares += gene[g][i] * gene[g][i];
		}
		expect_near("mean", sum / N, 0, 0.08);
		expect_near("variance", squares / N, 16.0 / 12, 0.08);
	}
	assert_true(gene[0][0] != gene[1][0] && gene[0][0] != gene[0][1]);
	ga_free(ga);
}

static bool
same_genes(struct ga *a, struct ga *b, size_t n)
{
	for (size_t g = 0; g < GENES; g++)
		if (memcmp(ga_next_candidates(a)[g], ga_next_candidates(b)[g],
			n * sizeof(double)) != 0)
			return false;
	return true;
}

static void
a_seed_is_a_search(void **state)
{
	(void)state;
	enum { N = 100 };
	struct ga *a = ga_of(N, 1, LOWER, UPPER);
	struct ga *b = ga_of(N, 1, LOWER, UPPER);
	struct ga *other = ga_of(N, 2, LOWER, UPPER);
	for (int k = 0; k < 20; k++) {
		assert_true(same_genes(a, b, N));
		assert_false(same_genes(a, other, N));
		generation(a, N, rosenbrock);
		generation(b, N, rosenbrock);
		generation(other, N, rosenbrock);
	}
	ga_free(a);
	ga_free(b);
	ga_free(other);
}

/* b is asked for part by part, the last part first. */
static void
parts_and_instructions_breed_the_same_bits(void **state)
{
	(void)state;
	enum { N = 333, PART = 5 * GA_PART };
	struct ga_options options = ga_options_default();
	options.population = N;
	for (int isa = ISA_BASE; isa <= ISA_BEST; isa++) {
		options.isa = ISA_BASE;
		struct ga *a = ga_new(&options, GENES, LOWER, UPPER);
		options.isa = (enum isa)isa;
		struct ga *b = ga_new(&options, GENES, LOWER, UPPER);
		for (int k = 0; k < 12; k++) {
			generation(a, N, rosenbrock);
			generation(b, N, rosenbrock);
			for (size_t i = N / PART + 1; i-- > 0;)
				ga_next_candidates_subset(b, i * PART,
				    (i + 1) * PART < N ? (i + 1) * PART : N);
			const double *const *x = ga_next_candidates(a);
			const double *const *y =
			    ga_next_candidates_subset(b, 0, 0);
			for (size_t g = 0; g < GENES; g++)
				assert_memory_equal(
				    x[g], y[g], N * sizeof(double));
		}
		ga_free(a);
		ga_free(b);
	}
}

static double
flat(const double *x)
{
	(void)x;
	return 1;
}

/* Without crossover and mutation a child is a copy of its parent, and where all
 * are equally good the parent hangs on the draw alone. */
static void
each_generation_draws_anew(void **state)
{
	(void)state;
	enum { N = 100 };
	struct ga_options options = {.population = N,
	    .tournament = 1,
	    .elite = 1,
	    .seed = 1,
	    .isa = ISA_BEST};
	struct ga *ga = ga_new(&options, GENES, LOWER, UPPER);
	double first[N];
	size_t parent[N], moved = 0;
	memcpy(first, ga_next_candidates(ga)[0], sizeof first);
	generation(ga, N, flat);
	for (size_t i = 0; i < N; i++) {
		parent[i] = 0;
		while (first[parent[i]] != ga_next_candidates(ga)[0][i])
			parent[i]++;
	}
	generation(ga, N, flat);
	for (size_t i = 0; i < N; i++)
		moved +=
		    ga_next_candidates(ga)[0][i] != first[parent[parent[i]]];
	assert_true(moved > N / 2);
	ga_free(ga);
}

/* Without crossover what is no parent's gene has mutated. */
static void
genes_mutate_as_often_as_asked(void **state)
{
	(void)state;
	enum { N = 400 };
	struct ga_options options = {.population = N,
	    .tournament = 2,
	    .elite = 1,
	    .mutation = 0.2,
	    .seed = 3,
	    .isa = ISA_BEST};
	struct ga *ga = ga_new(&options, GENES, LOWER, UPPER);
	double mutated = 0;
	generation(ga, N, rosenbrock);
	for (size_t g = 0; g < GENES; g++)
		for (size_t i = 1; i < N; i++) {
			size_t parent = 0;
			while (parent < N &&
			       ga_genes_of_last_generation(ga)[g][parent] !=
				   ga_next_candidates(ga)[g][i])
				parent++;
			mutated += parent == N;
		}
	expect_near("share", mutated / (GENES * (N - 1)), 0.2, 0.03);
	ga_free(ga);
}

static void
the_best_never_rises_and_is_what_was_told(void **state)
{
	(void)state;
	enum { N = 50 };
	struct ga *ga = ga_of(N, 3, LOWER, UPPER);
	double before = INFINITY;
	for (size_t k = 1; k <= 60; k++) {
		generation(ga, N, rosenbrock);
		struct ga_status s = ga_status(ga);
		assert_true(s.best <= before);
		assert_true(s.best <= s.median && s.median <= s.worst);
		assert_true(rosenbrock(ga_best_genes(ga)) == s.best);
		assert_int_equal(s.generation, k);
		before = s.best;
	}
	ga_free(ga);
}

static void
a_fixed_gene_stays(void **state)
{
	(void)state;
	enum { N = 200 };
	double lower[GENES], upper[GENES];
	memcpy(lower, LOWER, sizeof lower);
	memcpy(upper, UPPER, sizeof upper);
	lower[3] = upper[3] = 0.1;
	lower[5] = upper[5] = 0;
	struct ga *ga = ga_of(N, 4, lower, upper);
	for (int k = 0; k < 30; k++) {
		for (size_t i = 0; i < N; i++) {
			assert_true(ga_next_candidates(ga)[3][i] == 0.1);
			assert_true(ga_next_candidates(ga)[5][i] == 0);
		}
		generation(ga, N, sphere);
	}
	ga_free(ga);
}

static void
minima_are_found_roughly(void **state)
{
	(void)state;
	enum { N = 1000 };
	static const struct {
		double (*f)(const double *);
		int generations;
		double best;
	} rows[] = {{sphere, 60, 1e-3}, {rosenbrock, 150, 5},
	    {half_forbidden, 60, 1e-3}, {plane, 60, -13.9}};
	for (size_t i = 0; i < ARRAY_LEN(rows); i++)
		for (uint64_t seed = 1; seed <= 3; seed++) {
			struct ga *ga = ga_of(N, seed, LOWER, UPPER);
			for (int k = 0; k < rows[i].generations; k++)
				generation(ga, N, rows[i].f);
			if (!(ga_status(ga).best <= rows[i].best))
				fail_msg("row %zu, seed %d: %g", i, (int)seed,
				    ga_status(ga).best);
			ga_free(ga);
		}
}

static double
infinite(const double *x)
{
	return x[0] > 1e9 ? 0 : INFINITY;
}

static void
infinite_misfits_are_survived(void **state)
{
	(void)state;
	enum { N = 64 };
	struct ga *ga = ga_of(N, 6, LOWER, UPPER);
	for (int k = 0; k < 5; k++)
		generation(ga, N, infinite);
	struct ga_status s = ga_status(ga);
	assert_true(isinf(s.best) && isinf(s.median) && isinf(s.worst));
	assert_true(ga_best_genes(ga)[0] >= -2 && ga_best_genes(ga)[0] <= 2);
	for (int k = 0; k < 40; k++)
		generation(ga, N, sphere);
	double best = ga_status(ga).best;
	assert_true(best < 1);
	generation(ga, N, infinite); /* what was told before still counts */
	assert_true(
	    ga_status(ga).best == best && sphere(ga_best_genes(ga)) == best);
	ga_free(ga);
}

static void
leaders_and_spread_are_those_of_the_generation(void **state)
{
	(void)state;
	enum { N = 101, ELITE = 16 };
	double p10, p90;
	struct ga *ga = ga_of(N, 7, LOWER, UPPER);
	for (int k = 0; k < 5; k++)
		generation(ga, N, rosenbrock);
	const uint32_t *index = ga_get_candidate_ranking(ga);
	double before = -1, at[N];
	for (size_t i = 0; i < N; i++) {
		double x[GENES];
		for (size_t g = 0; g < GENES; g++)
			x[g] = ga_genes_of_last_generation(ga)[g][index[i]];
		assert_true(rosenbrock(x) >= before);
		before = rosenbrock(x);
		at[i] = 0;
	}
	for (size_t i = 0; i < N; i++)
		at[index[i]]++;
	for (size_t g = 0; g < GENES; g++) {
		size_t below = 0, above = 0;
		ga_quantiles_of_gene(ga, g, &p10, &p90);
		for (size_t i = 0; i < N; i++)
			assert_true(at[i] == 1);
		for (size_t i = ELITE; i < N; i++) {
			below += ga_genes_of_last_generation(ga)[g][i] < p10;
			above += ga_genes_of_last_generation(ga)[g][i] > p90;
		}
		/* A tenth of the others at either end. */
		assert_true(p10 <= p90 && below <= 8 && above <= 8);
		assert_true(below + above >= 8 || p10 == p90);
	}
	assert_true(before == ga_status(ga).worst);
	ga_free(ga);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_box_is_respected),
	    cmocka_unit_test(the_first_generation_fills_the_box),
	    cmocka_unit_test(a_seed_is_a_search),
	    cmocka_unit_test(parts_and_instructions_breed_the_same_bits),
	    cmocka_unit_test(each_generation_draws_anew),
	    cmocka_unit_test(genes_mutate_as_often_as_asked),
	    cmocka_unit_test(the_best_never_rises_and_is_what_was_told),
	    cmocka_unit_test(a_fixed_gene_stays),
	    cmocka_unit_test(minima_are_found_roughly),
	    cmocka_unit_test(infinite_misfits_are_survived),
	    cmocka_unit_test(leaders_and_spread_are_those_of_the_generation),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
