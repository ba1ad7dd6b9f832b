/* Collision energies are read from tables, lists and spectra, or refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/collisions.h"

#include <math.h>
#include <stdlib.h>

#include "sheets.h"

static const struct collisions_way PLAIN = {.speed = NAN};

/* As dem/merge writes them: two particles, four impacts, and one particle that
 * was never hit. */
static const char IMPACTS[] =
    "size_mm,particles,particles_kg,specific_energy_j_kg,impacts_kg,first_kg,"
    "first_j\n2,1,4e-6,1800,4e-6,4e-6,0.0072\n2,0,0,50,4e-6,0,0\n"
    "2,0,0,89,4e-6,0,0\n4,1,3e-5,11,3e-5,0,0\n6,1,1e-4,0,0,0,0\n";

static bool
take(const char *text, struct collisions_way way, struct collisions *c,
    struct error_list *errors)
{
	*errors = (struct error_list){0};
	return collisions_read(put_sheet(text, strlen(text)), &way, c, errors);
}

static void
near(double got, double want)
{
	if (!(fabs(got - want) <= 1e-6 * fabs(want)))
		fail_msg("%.17g was wanted, found %.17g", want, got);
}

static void
impacts_tell_of_particles(void **state)
{
	(void)state;
	struct collisions c;
	struct error_list errors;
	assert_true(take(IMPACTS, PLAIN, &c, &errors));
	assert_int_equal(c.rows, 5);
	assert_int_equal(c.impacts, 4);
	assert_int_equal(c.spectrum->n, 3);
	assert_true(c.spectrum->counted && c.spectrum->ordered);
	struct spectrum_size *all = spectrum_sum_over_sizes(c.spectrum);
	near(all->particles, 3);
	near(all->mass, 1.34e-4);
	near(spectrum_impacts_above_energy(all, 0, false).energy,
	    4e-6 * (1800 + 50 + 89) + 3e-5 * 11);
	near(spectrum_impacts_above_energy(all, 0, true).energy, 0.0072);
	free(all);
	collisions_clear(&c);
}

static void
tables_are_read_by_their_heads(void **state)
{
	(void)state;
	struct collisions_way list = PLAIN, named = PLAIN, fast = PLAIN;
	list.unit = "J/kg";
	fast.unit = "m/s";
	named.columns = "-,energy_mj,mass_g";
	const struct {
		const char *text;
		const struct collisions_way *way;
	} same[] = {{"100\n300\n", &list}, {"100,1\n300,1\n", &list},
	    {"14.142135623731\n24.494897427832\n", &fast},
	    {"Time (s);Relative Velocity Normal (m/s)\n1;14.142135623731\n"
	     "2;24.494897427832\n",
		&PLAIN},
	    {"id\tImpact Energy [J]\tParticle mass [g]\n1\t0.1\t1\n2\t0.6\t2\n",
		&PLAIN},
	    {"a,b,c\nx,100,1\nx,300,1\n", &named},
	    {"specific energy (kJ/kg),count\n0.1,3\n0.3,3\n", &PLAIN},
	    {"size (\xC2\xB5m),mass (mg),velocity (mm/s)\n"
	     "8000,1000,14142.135623731\n4000,2000,24494.897427832\n",
		&PLAIN}};
	for (size_t i = 0; i < ARRAY_LEN(same); i++) {
		struct collisions c;
		struct error_list errors;
		bool weighed = i == 4 || i == 7;
		assert_true(take(same[i].text, *same[i].way, &c, &errors));
		struct spectrum_size *all = spectrum_sum_over_sizes(c.spectrum);
		struct spectrum_bin sum =
		    spectrum_impacts_above_energy(all, 0, false);
		near(sum.energy / sum.mass, weighed ? 700.0 / 3 : 200);
		assert_false(c.spectrum->counted);
		assert_true(c.spectrum->size[0]->size < 0.009);
		free(all);
		collisions_clear(&c);
	}
}

static void
what_is_written_is_read_again(void **state)
{
	(void)state;
	struct collisions c, again;
	struct error_list errors;
	struct collisions_way way = PLAIN;
	way.speed = 69;
	assert_true(take(IMPACTS, way, &c, &errors));
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	collisions_write(&c, "a", out);
	fclose(out);
	assert_true(take(text, PLAIN, &again, &errors));
	near(again.spectrum->speed, 69);
	assert_int_equal(again.impacts, c.impacts);
	assert_true(again.spectrum->counted && again.spectrum->ordered);
	struct spectrum_size *a = spectrum_sum_over_sizes(c.spectrum);
	struct spectrum_size *b = spectrum_sum_over_sizes(again.spectrum);
	near(b->mass, a->mass);
	for (size_t first = 0; first < 2; first++)
		for (double cut = 0; cut < 2000; cut += 20)
			near(spectrum_impacts_above_energy(b, cut, first == 1)
				     .energy +
				 1,
			    spectrum_impacts_above_energy(a, cut, first == 1)
				    .energy +
				1);
	free(a);
	free(b);
	free(text);
	collisions_clear(&c);
	collisions_clear(&again);
}

static void
what_is_none_is_refused(void **state)
{
	(void)state;
	struct collisions_way two = PLAIN;
	two.columns = "energy,-";
	const struct {
		const char *text, *expected;
		const struct collisions_way *way;
		int line;
	} bad[] = {{"1\n2\n", "headings above the numbers", &PLAIN, 1},
	    {"a,b\n1,2\n", "column of specific energy", &PLAIN, 1},
	    {"energy_j,b\n1,2\n", "mass of the particle", &PLAIN, 1},
	    {"1,2\n", "mass of the particle", &two, 1},
	    {"velocity\n1\nx\n", "finite number", &PLAIN, 3},
	    {"velocity,weight\n1\n", "got fewer", &PLAIN, 2},
	    {"specific_energy\n-1\n", "at least 0", &PLAIN, 2},
	    {"velocity\n", "impacts, got none", &PLAIN, 1},
	    {"ITEM: TIMESTEP\n0\n", "a LIGGGHTS dump", &PLAIN, 1}};
	for (size_t i = 0; i < ARRAY_LEN(bad); i++) {
		struct collisions c;
		struct error_list errors;
		assert_false(take(bad[i].text, *bad[i].way, &c, &errors));
		assert_int_equal(errors.n, 1);
		if (strstr(errors.item[0].text, bad[i].expected) == NULL)
			fail_msg("'%s' was wanted, found '%s'", bad[i].expected,
			    errors.item[0].text);
		assert_int_equal(errors.item[0].line, bad[i].line);
		assert_null(c.spectrum);
	}
}

static bool
refuse(void *data, uint64_t rows)
{
	*(uint64_t *)data = rows;
	return false;
}

static void
reading_can_be_stopped(void **state)
{
	(void)state;
	enum { MANY = 300000 };
	uint64_t at = 0;
	struct collisions c;
	struct error_list errors;
	struct collisions_way way = PLAIN;
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	fputs("velocity\n", out);
	for (int i = 0; i < MANY; i++)
		fputs("20\n", out);
	fclose(out);
	way.progress = refuse;
	way.data = &at;
	assert_false(take(text, way, &c, &errors));
	assert_true(at > 0 && at < MANY);
	assert_int_equal(errors.item[0].kind, ERROR_CHECK);
	free(text);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(impacts_tell_of_particles),
	    cmocka_unit_test(tables_are_read_by_their_heads),
	    cmocka_unit_test(what_is_written_is_read_again),
	    cmocka_unit_test(what_is_none_is_refused),
	    cmocka_unit_test(reading_can_be_stopped)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
