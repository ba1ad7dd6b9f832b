/* Measures the cost of many runs: synthetic plants, measured at few and at many
 * speeds, are calibrated, drawn from and checked, each in its own process.
 * bench/README.md explains the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "core/search/calibrate.h"
#include "core/check/outliers.h"
#include "core/posterior/posterior.h"
#include "core/check/trust.h"
#include "measure.h"
#include "plants.h"

static const size_t RUNS[] = {3, 20, 80, 250};

/* Returns processor seconds, which other processes do not lengthen. */
static double
used(void)
{
	struct rusage u;
	getrusage(RUSAGE_SELF, &u);
	return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
	       1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

static long
most_memory(void)
{
	struct rusage u;
	getrusage(RUSAGE_SELF, &u);
	return u.ru_maxrss / 1000;
}

/* Returns the seconds since *from, sets *from to now, and updates *longest. */
static double
lap(double *from, double *longest)
{
	double now = used(), taken = now - *from;
	*from = now;
	*longest = fmax(*longest, taken);
	return taken;
}

static struct fit
calibrate(const struct site *site, const bool *train, double *step)
{
	struct calibrate_options o = calibrate_options_default();
	double from = used();
	o.train = train;
	struct calibration *c = calibration_new(site, &o);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		lap(&from, step);
	struct fit fit = calibration_best_fit(c);
	calibration_free(c);
	return fit;
}

static struct posterior *
draw(const struct site *site, const struct fit *fit, const bool *use,
    double *step)
{
	struct posterior_options o = {.use = use,
	    .settings = fit->settings,
	    .bounds = bounds_default(0),
	    .seed = 1,
	    .threads = 1,
	    .isa = ISA_BEST};
	double from = used();
	struct posterior_run *run =
	    posterior_begin_sampling(site, &fit->params, &o);
	lap(&from, step);
	while (!posterior_step(run))
		lap(&from, step);
	return posterior_end(run);
}

static void
print_row(size_t runs, bool all)
{
	struct plant plant = plant_of(RIGHT, 1);
	bool use[PLANT_RUNS], train[PLANT_RUNS] = {false};
	double begun = used(), step[2] = {0}, whole = 0;
	plant_measure(&plant, runs);
	struct site *site = plant_site(&plant, 1);
	for (size_t r = 0; r < runs; r++)
		use[r] = true;
	misfit_mark_default_training(site, train);
	printf("%5zu  %-5s", runs, all ? "all" : "ends");
	lap(&begun, &whole);
	struct fit fit = calibrate(site, all ? use : train, &step[0]);
	printf("%10.2f%8.3f%7ld", lap(&begun, &whole), step[0], most_memory());
	struct posterior *p = draw(site, &fit, use, &step[1]);
	double drawn = lap(&begun, &whole);
	printf("%10.2f%8.3f%7ld", drawn, step[1], most_memory());
	struct bounds bounds = bounds_default(0);
	trust_gather_evidence(site, train, use, &fit, &bounds, p, 0);
	printf("%10.2f", lap(&begun, &whole));
	struct outlier_findings d = outliers_find(site, p, 0);
	printf("%10.2f%7ld\n", lap(&begun, &whole), most_memory());
	fflush(stdout);
	outliers_free(&d);
	posterior_free(p);
	site_free(site);
}

int
main(void)
{
	measure_print_machine();
	printf(
	    "%5s  %-5s%25s%25s%10s%17s\n%5s  %-5s%10s%8s%7s%10s%8s%7s%10s%10s"
	    "%7s\n",
	    "", "", "calibration", "draws", "trust", "check", "runs", "train",
	    "s", "step", "MB", "s", "step", "MB", "s", "s", "MB");
	for (size_t i = 0; i < ARRAY_LEN(RUNS); i++)
		for (int all = 0; all < 2; all++) {
			fflush(stdout);
			pid_t child = fork();
			if (child < 0)
				return 1;
			if (child > 0) {
				waitpid(child, NULL, 0);
				continue;
			}
			print_row(RUNS[i], all == 1);
			_exit(0);
		}
	return 0;
}
