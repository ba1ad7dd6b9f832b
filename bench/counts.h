/* Checks of what the program promises: counts how often it holds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_COUNTS_H
#define TIPSPEED_BENCH_COUNTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/posterior/posterior.h"
#include "core/search/calibrate.h"
#include "plants.h"

/* Each prints its table for n cases of a kind.  Returns false if a count is
 * outside its limits. */
bool count_advise(size_t n);
bool count_doctor(size_t n);
bool count_drift(size_t n);
bool count_guess(size_t n);
bool count_league(size_t n);
bool count_params(size_t n);
bool count_power(size_t n);
bool count_speeds(size_t n);
bool count_window(size_t n);

/* Prints a share in per cent with its standard error.  Returns true if it lies
 * within least..most, give or take three standard errors. */
bool counts_share(size_t inside, size_t n, double least, double most);

/* Sums of a number, or of 0 or 1, over plants.  counts_add ignores NAN;
 * counts_print prints the mean times a scale, with its standard error, which
 * counts_error returns; counts_between returns true if the mean lies within
 * least..most, give or take three standard errors. */
struct counts_mean {
	double n, sum, squares;
};
void counts_add(struct counts_mean *mean, double value);
double counts_error(const struct counts_mean *mean);
void counts_print(const struct counts_mean *mean, double scale);
bool counts_between(const struct counts_mean *mean, double least, double most);

/* Returns plant i, and sets *number to its number.  The laws take turns; no
 * prior or threshold was chosen with these plants. */
struct plant counts_plant(size_t i, uint64_t *number);

/* Calibrates with these options and returns the fit. */
struct fit counts_fit(
    const struct site *site, const struct calibrate_options *options);

/* A session, and its answers.  counts_talk opens one with a site, whose
 * ownership it takes. */
struct counts_talk;
struct counts_talk *counts_talk(struct site *site);
void counts_talk_end(struct counts_talk *talk);

/* Runs a line and returns its answer in JSON, valid until the next line.  Ends
 * the program if the line is refused. */
const char *counts_say(struct counts_talk *talk, const char *line);

/* Returns the number after a key, or NAN if there is none. */
double counts_number(const char *json, const char *key);

/* Calibrates a site on all its runs and draws from the posterior.  Free with
 * posterior_free. */
struct posterior *counts_calibrate(
    const struct site *site, uint64_t seed, struct fit *fit);

#endif
