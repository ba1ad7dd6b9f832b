/* The code that the benchmarks share: the clock, medians, the machine, the
 * sites, and one timed calibration.  C11 that C++ can include.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_MEASURE_H
#define TIPSPEED_BENCH_MEASURE_H

#include <stdbool.h>
#include <stddef.h>

#include "../tests/unit/paper.h"
#include "core/search/calibrate.h"
#include "core/search/misfit.h"
#include "core/psd/site.h"

/* Returns the seconds of a clock that never goes back. */
double measure_now(void);

/* Sorts value [n], n >= 1, in rising order and returns the median. */
double measure_median(double *value, size_t n);

unsigned measure_threads(void);

/* Prints date, processor, cores, instruction set, compiler and load, a line
 * each. */
void measure_print_machine(void);

/* The processor time of all processes and of this one so far, seconds of one
 * core. */
struct measure_load {
	double clock, all, own;
};

struct measure_load measure_load(void);

/* Prints how many cores other processes have used since then.  Above some 0.1,
 * the figures for several threads are worth little. */
void measure_print_others(const struct measure_load *since);

/* The sites of DATA/sites in the order of their file names.  If a file has a
 * fault or there are none, the program ends with a message. */
struct measure_sites {
	size_t n;
	struct site **site;
};

struct measure_sites measure_read_sites(const char *data);
void measure_free_sites(struct measure_sites *sites);

/* Returns the first site with that name, or file name without ".csv".  If there
 * is none, the program ends with a message. */
struct site *measure_site(const struct measure_sites *sites, const char *name);

/* Writes the site's file name without folder and ".csv" to buf [64], and
 * returns buf. */
const char *measure_stem(const struct site *site, char *buf);

/* Returns the misfit of the default training runs, or of all runs. */
struct misfit *measure_misfit(const struct site *site, bool all_runs);

/* Returns the options of the paper's full run: 8000 candidates, 800
 * generations, no early end, no polish. */
struct calibrate_options measure_full_run(unsigned threads);

/* Calibrates to the end and sets *fit.  Returns the seconds that it took. */
double measure_calibrate(const struct site *site,
    const struct calibrate_options *options, struct fit *fit);

#endif
