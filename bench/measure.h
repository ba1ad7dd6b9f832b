/* What bench.c and peers.cc share: the clock, medians, the machine, the sites,
 * and one calibration with its time.  C11, also readable by C++.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_MEASURE_H
#define TIPSPEED_BENCH_MEASURE_H

#include <stdbool.h>
#include <stddef.h>

#include "../tests/unit/paper.h"
#include "core/search/calibrate.h"
#include "core/search/misfit.h"
#include "core/psd/site.h"

/* Seconds of a clock that never goes back. */
double measure_now(void);

/* Puts value [n] in rising order and returns the middle one; n >= 1. */
double measure_median(double *value, size_t n);

unsigned measure_threads(void);

/* Date, processor, cores, instruction set and load, a line each. */
void measure_print_machine(void);

/* The work of all processes and of this one so far, seconds of one core. */
struct measure_load {
	double clock, all, own;
};

struct measure_load measure_load(void);

/* A line that says how many cores others used since then: above some 0.1 the
 * figures of several threads are worth little. */
void measure_print_others(const struct measure_load *since);

/* The sites of DATA/sites in the order of the file names.  A fault, or no
 * site, ends the program with a message. */
struct measure_sites {
	size_t n;
	struct site **site;
};

struct measure_sites measure_read_sites(const char *data);
void measure_free_sites(struct measure_sites *sites);

/* The first site of that name or file name without ".csv"; a missing one ends
 * the program with a message. */
struct site *measure_site(const struct measure_sites *sites, const char *name);

/* File name of the site without folder and ".csv", in buf of 64. */
const char *measure_stem(const struct site *site, char *buf);

/* The misfit of the default training runs, or of all runs. */
struct misfit *measure_misfit(const struct site *site, bool all_runs);

/* The paper's full run: 8000 candidates, 800 generations, no early end, no
 * polish. */
struct calibrate_options measure_full_run(unsigned threads);

/* Calibrates to the end; returns the seconds it took. */
double measure_calibrate(const struct site *site,
    const struct calibrate_options *options, struct fit *fit);

#endif
