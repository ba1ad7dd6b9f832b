/* Predictions to the last bit: their digests are those of tests/golden/predict,
 * whatever the compiler, its optimization and the processor.  All cases in the long
 * tests, else a third of them.
 * `make renew-bits` writes them anew: a change of them wants a reason.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <glob.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "fitted.h"
#include "often.h"
#include "sheets.h"

#include "core/answer/predict.h"
#include "core/answer/forecast.h"
#include "core/model/breakage.h"
#include "core/model/spectrum.h"
#include "core/posterior/ensemble.h"
#include "io/formats/collisions.h"

enum { LINE = 200 };

static const double SPEED[] = {60, 66.5, 72, 79, 86};

/* Tests run anywhere; srcdir, which make check sets, is the project's folder. */
static char *
in_project(const char *name)
{
	const char *srcdir = getenv("srcdir");
	return xasprintf("%s/%s", srcdir != NULL ? srcdir : ".", name);
}

static uint64_t
add(uint64_t digest, const double *x, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		/* Little endian, and one NAN and one 0. */
		uint64_t bits = isnan(x[i]) ? 1
				: x[i] == 0 ? 0
					    : el_bits_of_double(x[i]);
		for (unsigned k = 0; k < 64; k += 8) {
			unsigned char byte = (unsigned char)(bits >> k);
			digest = text_fnv1a_digest(digest, &byte, 1);
		}
	}
	return digest;
}

/* The table at a speed: answer, model, low and high at each sieve, sizes and
 * their bands. */
static uint64_t
add_table(uint64_t digest, const struct site *site, struct forecast *r)
{
	struct fraction whole = {0};
	struct prediction p =
	    predict_at_table_sieves(site, SITE_MEAN_FEED, &whole, r);
	size_t n = p.product.n;
	digest = add(digest, p.product.passing, n);
	digest = add(digest, p.model, n);
	digest = add(digest, p.low, n);
	digest = add(digest, p.high, n);
	digest = add(digest, p.size, PSD_SIZES + 1);
	digest = add(digest, p.range[0], 2 * (PSD_SIZES + 1));
	prediction_free(&p);
	return digest;
}

static uint64_t
digest_of(const struct site *site, const struct fit *fit,
    const struct posterior *posterior)
{
	struct fraction whole = {0};
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	struct psd sizes = predict_list_table_sieves(site, feed);
	size_t n;
	struct quantity *asked =
	    predict_table_quantities(site, feed, &whole, &n);
	struct forecast *r = forecast_new(feed, sizes.size, sizes.n, asked, n,
	    &fit->params, fit->settings, 0.8);
	struct ensemble *e = ensemble_new(posterior, feed, sizes.size, sizes.n);
	uint64_t digest = TEXT_DIGEST_START;
	for (size_t i = 0; i < ARRAY_LEN(SPEED); i++) {
		forecast_move_to_speed(r, e, ENSEMBLE_ANSWER, SPEED[i]);
		digest = add_table(digest, site, r);
	}
	free(asked);
	psd_free(&sizes);
	forecast_close(r);
	ensemble_free(e);
	return digest;
}

/* Whether the i-th of the sites or models is a case of this run. */
static bool
is_case(size_t i)
{
	return getenv("RENEW") != NULL || often(0, 1) > 0 || i % 4 == 0;
}

/* A line: the case, digests of its parameters and of its predictions. */
static void
write_line(FILE *to, const struct site *site, const char *name,
    const char *with, struct model_settings settings)
{
	struct calibrate_options options = quick_options(1);
	bool *use = xcalloc(site->n_run, sizeof *use);
	options.isa = isa_from_name(getenv("TIPSPEED_ISA"));
	options.settings = settings;
	options.bounds = bounds_default(settings.breakage);
	for (size_t r = 0; r < site->n_run; r++)
		use[r] = site->run[r].product.n > 0;
	struct fit fit = fitted(site, &options);
	struct posterior *posterior = posterior_new(site, &fit.params,
	    &(struct posterior_options){.use = use,
		.settings = fit.settings,
		.bounds = options.bounds,
		.seed = options.seed,
		.threads = 2,
		.isa = options.isa});
	uint64_t params = add(
	    TEXT_DIGEST_START, fit.params.at, BREAKAGES[settings.breakage]->n);
	fprintf(to, "%s%s %016" PRIx64 " %016" PRIx64 "\n", name, with, params,
	    digest_of(site, &fit, posterior));
	posterior_free(posterior);
	free(use);
}

static struct impacts
impacts_of(const char *path)
{
	const struct collisions_way way = {.speed = NAN};
	struct error_list errors = {0};
	struct collisions c;
	assert_true(collisions_read(path, &way, &c, &errors));
	struct impacts impacts =
	    spectrum_group_impacts_by_energy(c.spectrum, 10);
	collisions_clear(&c);
	return impacts;
}

/* One site by the other models, too, and with collision energies. */
static void
write_others(FILE *to, const struct site *site, const char *name)
{
	struct model_settings settings = model_settings_default();
	for (size_t i = 1; i < breakage_count_models(); i++) {
		if (!is_case(i))
			continue;
		char *with = xasprintf(",%s", BREAKAGES[i]->name);
		settings.breakage = (unsigned)i;
		write_line(to, site, name, with, settings);
		free(with);
	}
	char *energies = in_project("data/energy/vsi-69.csv");
	settings = model_settings_default();
	settings.impacts = impacts_of(energies);
	write_line(to, site, name, ",vsi-69", settings);
	free(energies);
}

static void
write_site(FILE *to, const char *path, bool whole)
{
	struct error_list errors = {0};
	struct site *site = site_read(path, &errors);
	assert_non_null(site);
	char *name = xstrdup(strrchr(path, '/') + 1);
	*strrchr(name, '.') = '\0';
	if (whole)
		write_line(to, site, name, "", model_settings_default());
	if (strcmp(name, "tierp") == 0)
		write_others(to, site, name);
	free(name);
	site_free(site);
}

static void
write_all(FILE *to)
{
	char *pattern = in_project("data/sites/*.csv");
	glob_t sites;
	assert_int_equal(glob(pattern, 0, NULL, &sites), 0);
	assert_int_equal(sites.gl_pathc, 19);
	for (size_t i = 0; i < sites.gl_pathc; i++)
		write_site(to, sites.gl_pathv[i], is_case(i));
	globfree(&sites);
	free(pattern);
}

/* Reads on to the line of a case; false if there is none. */
static bool
find_line(FILE *golden, const char *like, char line[LINE])
{
	size_t n = strcspn(like, " ");
	while (fgets(line, LINE, golden) != NULL)
		if (strncmp(line, like, n) == 0 && line[n] == ' ')
			return true;
	return false;
}

static void
predictions_are_the_same_to_the_last_bit(void **state)
{
	(void)state;
	char *path = in_project("tests/golden/predict"), *got = NULL;
	char want[LINE], line[LINE];
	bool renew = getenv("RENEW") != NULL;
	size_t size, n = 0, other = 0;
	FILE *golden = fopen(path, renew ? "w" : "r");
	FILE *made = renew ? golden : open_memstream(&got, &size);
	assert_non_null(golden);
	assert_non_null(made);
	write_all(made);
	fclose(made);
	if (renew) {
		free(path);
		return;
	}
	made = fmemopen(got, size, "r");
	assert_non_null(made);
	while (fgets(line, sizeof line, made) != NULL) {
		bool same =
		    find_line(golden, line, want) && strcmp(line, want) == 0;
		if (!same)
			print_message("# got %s", line);
		other += !same;
		n++;
	}
	assert_int_equal(n, often(0, 1) > 0 ? 27 : 7);
	assert_int_equal(other, 0);
	fclose(made);
	fclose(golden);
	free(got);
	free(path);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(predictions_are_the_same_to_the_last_bit),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
