/* Collision energies are read from dumps, tables, lists and spectra, or
 * refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/collisions.h"

#include <math.h>
#include <stdlib.h>

#include "sheets.h"

static const struct collisions_way PLAIN = {
    .speed = NAN, .cut = 10, .density = 1000};

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

#define HEADS                                                               \
	"ITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n" \
	"0 1\nITEM: ENTRIES c_t[1] c_t[2] c_t[3] c_t[4] c_t[5] c_t[6] "     \
	"c_t[7] c_t[8] c_t[9] c_t[10] c_t[11] c_t[12] c_t[13] c_t[14]\n"
#define AT(step) "ITEM: TIMESTEP\n" step "\n" HEADS

/* Particle 7 meets the bed (1, at rest) at 60, then 50 m/s in two snapshots;
 * leaves, and comes again at 10; meets particle 8 at 20 m/s along x. */
static const char DUMP[] = AT("0") "0 0 0 1 0 0 0 0 0 -60 5 0 1 7\n" AT(
    "4") "0 0 0 1 0 0 0 0 0 -50 5 0 1 7\n" AT("8")
    AT("12") "1 0 0 0 0 0 -10 0 0 0 0 0 7 1\n" AT(
	"16") "0 0 0 2 0 0 12 1 0 -8 1 0 7 8\n";

static void
contacts_become_impacts(void **state)
{
	(void)state;
	struct collisions c;
	struct error_list errors;
	assert_true(take(DUMP, PLAIN, &c, &errors));
	assert_int_equal(c.rows, 4);
	assert_int_equal(c.snapshots, 5);
	/* Two of 7 on the bed, and one each of 7 and 8. */
	assert_int_equal(c.impacts, 4);
	struct spectrum_size *all = spectrum_whole(c.spectrum);
	near(all->particles, 2);
	/* 60^2/2, 10^2/2, and 20^2/8 for either of two alike. */
	near(spectrum_above(all, 0, false).energy, 1800 + 50 + 50 + 50);
	near(spectrum_above(all, 0, true).energy, 1800 + 50);
	free(all);
	collisions_clear(&c);
}

static void
sizes_share_energy_by_mass(void **state)
{
	(void)state;
	struct collisions c;
	struct error_list errors;
	struct collisions_way way = PLAIN;
	static const char ATOMS[] = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n"
				    "2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n"
				    "0 1\nITEM: ATOMS id radius \n7 0.001\n"
				    "8 0.002\n";
	char *particles = xstrdup(put_sheet(ATOMS, strlen(ATOMS)));
	char *kept = xasprintf("%s.atoms", particles);
	assert_int_equal(rename(particles, kept), 0);
	way.particles = kept;
	assert_true(take(DUMP, way, &c, &errors));
	assert_int_equal(c.spectrum->n, 2);
	/* m M / (m + M) v^2 / (4 m), M = 8 m: 88.9 J/kg for 7, 11.1 for 8. */
	struct spectrum_bin large =
	    spectrum_above(c.spectrum->size[0], 0, false);
	struct spectrum_bin small =
	    spectrum_above(c.spectrum->size[1], 0, false);
	near(large.energy / large.mass, 100.0 / 9);
	near(small.energy / c.spectrum->size[1]->mass, 1800 + 50 + 800.0 / 9);
	collisions_clear(&c);
	remove(kept);
	free(kept);
	free(particles);
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
	    {"specific energy (kJ/kg),count\n0.1,3\n0.3,3\n", &PLAIN}};
	for (size_t i = 0; i < ARRAY_LEN(same); i++) {
		struct collisions c;
		struct error_list errors;
		bool weighed = i == 4;
		assert_true(take(same[i].text, *same[i].way, &c, &errors));
		struct spectrum_size *all = spectrum_whole(c.spectrum);
		struct spectrum_bin sum = spectrum_above(all, 0, false);
		near(sum.energy / sum.mass, weighed ? 700.0 / 3 : 200);
		assert_false(c.spectrum->counted);
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
	assert_true(take(DUMP, way, &c, &errors));
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_memory(&text, &n);
	collisions_write(&c, "a", out);
	fclose(out);
	assert_true(take(text, PLAIN, &again, &errors));
	near(again.spectrum->speed, 69);
	assert_int_equal(again.impacts, c.impacts);
	assert_true(again.spectrum->counted && again.spectrum->ordered);
	struct spectrum_size *a = spectrum_whole(c.spectrum);
	struct spectrum_size *b = spectrum_whole(again.spectrum);
	near(b->mass, a->mass);
	for (size_t first = 0; first < 2; first++)
		for (double cut = 0; cut < 2000; cut += 20)
			near(spectrum_above(b, cut, first == 1).energy + 1,
			    spectrum_above(a, cut, first == 1).energy + 1);
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
	    {AT("0") "0 0 0 1 0 0 0 0 0 -60 5 0 1.5 7\n", "whole numbers",
		&PLAIN, 10},
	    {"ITEM: TIMESTEP\n0\nITEM: ATOMS id radius\n1 1\n", "got atoms",
		&PLAIN, 3}};
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
	FILE *out = text_memory(&text, &n);
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
	    cmocka_unit_test(contacts_become_impacts),
	    cmocka_unit_test(sizes_share_energy_by_mass),
	    cmocka_unit_test(tables_are_read_by_their_heads),
	    cmocka_unit_test(what_is_written_is_read_again),
	    cmocka_unit_test(what_is_none_is_refused),
	    cmocka_unit_test(reading_can_be_stopped)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
