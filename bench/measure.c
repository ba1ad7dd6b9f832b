/* The clock, the machine and the sites.  bench.c and peers.cc do the measuring.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "measure.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/error.h"
#include "base/text.h"
#include "base/xalloc.h"
#include "core/numeric/isa.h"
#include "io/sitefile/site_read.h"

double
measure_now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

double
measure_median(double *value, size_t n)
{
	qsort(value, n, sizeof *value, rising);
	return n % 2 != 0 ? value[n / 2]
			  : (value[n / 2 - 1] + value[n / 2]) / 2;
}

unsigned
measure_threads(void)
{
	long n = sysconf(_SC_NPROCESSORS_ONLN);
	return n >= 1 ? (unsigned)n : 1;
}

/* Prints the first line of a file of /proc that begins with key; if it has a
 * colon, only the part after it. */
static void
print_proc(const char *label, const char *path, const char *key)
{
	char line[512];
	FILE *in = fopen(path, "r");
	while (in != NULL && fgets(line, sizeof line, in) != NULL) {
		if (strncmp(line, key, strlen(key)) != 0)
			continue;
		const char *colon = strchr(line, ':');
		printf("%-17s%s", label, colon != NULL ? colon + 2 : line);
		break;
	}
	if (in != NULL)
		fclose(in);
}

void
measure_print_machine(void)
{
	char date[32];
	time_t t = time(NULL);
	strftime(date, sizeof date, "%Y-%m-%d", gmtime(&t));
	printf("%-17s%s\n", "date", date);
	print_proc("processor", "/proc/cpuinfo", "model name");
	printf("%-17s%u\n", "cores", measure_threads());
	printf("%-17s%s\n", "instruction set",
	    isa_name(isa_usable_or_best(ISA_BEST)));
	printf("%-17s%s\n", "compiler", __VERSION__);
	print_proc("load at start", "/proc/loadavg", "");
}

/* Returns the seconds that all cores were neither idle nor waiting, including
 * stolen time. */
static double
all_work(void)
{
	double tick[8] = {0};
	FILE *in = fopen("/proc/stat", "r");
	if (in == NULL)
		return 0;
	bool good = fscanf(in, "cpu %lf %lf %lf %lf %lf %lf %lf %lf", &tick[0],
			&tick[1], &tick[2], &tick[3], &tick[4], &tick[5],
			&tick[6], &tick[7]) == 8;
	fclose(in);
	double sum = 0;
	for (size_t i = 0; i < 8 && good; i++)
		sum += i == 3 || i == 4 ? 0 : tick[i];
	return sum / (double)sysconf(_SC_CLK_TCK);
}

struct measure_load
measure_load(void)
{
	return (struct measure_load){measure_now(), all_work(),
	    (double)clock() / (double)CLOCKS_PER_SEC};
}

void
measure_print_others(const struct measure_load *since)
{
	struct measure_load now = measure_load();
	double others = (now.all - since->all) - (now.own - since->own);
	printf("\n(meanwhile other processes used %.2f cores)\n",
	    fmax(others, 0) / (now.clock - since->clock));
}

static int
is_site_file(const struct dirent *entry)
{
	const char *dot = strrchr(entry->d_name, '.');
	return dot != NULL && strcmp(dot, ".csv") == 0;
}

static struct site *
read_site(const char *folder, const char *name)
{
	struct error_list errors = {0};
	char *path = xasprintf("%s/%s", folder, name);
	struct site *site = site_read(path, &errors);
	if (site == NULL) {
		error_print(&errors.item[0], stderr);
		exit((int)errors.item[0].kind);
	}
	free(path);
	return site;
}

struct measure_sites
measure_read_sites(const char *data)
{
	struct dirent **entry = NULL;
	struct measure_sites sites = {0, NULL};
	char *folder = xasprintf("%s/sites", data);
	int found = scandir(folder, &entry, is_site_file, alphasort);
	if (found <= 0) {
		fprintf(
		    stderr, "%s: site files were wanted, found none\n", folder);
		exit(ERROR_SYSTEM);
	}
	sites.site = xcalloc((size_t)found, sizeof(struct site *));
	for (int i = 0; i < found; i++) {
		sites.site[sites.n++] = read_site(folder, entry[i]->d_name);
		free(entry[i]);
	}
	free(entry);
	free(folder);
	return sites;
}

void
measure_free_sites(struct measure_sites *sites)
{
	for (size_t i = 0; i < sites->n; i++)
		site_free(sites->site[i]);
	free(sites->site);
}

const char *
measure_stem(const struct site *site, char *buf)
{
	const char *slash = strrchr(site->path, '/');
	snprintf(buf, 64, "%s", slash != NULL ? slash + 1 : site->path);
	char *dot = strrchr(buf, '.');
	if (dot != NULL)
		*dot = '\0';
	return buf;
}

struct site *
measure_site(const struct measure_sites *sites, const char *name)
{
	char stem[64];
	for (size_t i = 0; i < sites->n; i++)
		if (text_is_same_folded(sites->site[i]->name, name) ||
		    text_is_same_folded(
			measure_stem(sites->site[i], stem), name))
			return sites->site[i];
	fprintf(
	    stderr, "the site %s was wanted, found none of that name\n", name);
	exit(ERROR_DATA);
}

struct misfit *
measure_misfit(const struct site *site, bool all_runs)
{
	bool *train = xcalloc(site->n_run, sizeof *train);
	misfit_mark_default_training(site, train);
	for (size_t r = 0; r < site->n_run && all_runs; r++)
		train[r] = true;
	struct misfit *m =
	    misfit_new(site, train, NULL, false, model_settings_default());
	free(train);
	return m;
}

struct calibrate_options
measure_full_run(unsigned threads)
{
	struct calibrate_options o = calibrate_options_default();
	o.population = 8000;
	o.generations = 800;
	o.tolerance = 0;
	o.stall = 0;
	o.polish = false;
	o.threads = threads;
	return o;
}

double
measure_calibrate(const struct site *site,
    const struct calibrate_options *options, struct fit *fit)
{
	double start = measure_now();
	struct calibration *c = calibration_new(site, options);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		;
	double took = measure_now() - start;
	*fit = calibration_best_fit(c);
	calibration_free(c);
	return took;
}
