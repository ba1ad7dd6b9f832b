/* Counts of what the program says of itself: what is promised, and how often it
 * was so.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_COUNTS_H
#define TIPSPEED_BENCH_COUNTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/posterior/posterior.h"
#include "core/search/calibrate.h"
#include "plants.h"

/* Each prints its table for n cases of a kind; false: outside its limits. */
bool count_advise(size_t n);
bool count_doctor(size_t n);
bool count_drift(size_t n);
bool count_guess(size_t n);
bool count_league(size_t n);
bool count_params(size_t n);
bool count_power(size_t n);
bool count_speeds(size_t n);
bool count_window(size_t n);

/* Prints a share in per cent with its standard error; whether it lies within
 * least..most but for three standard errors. */
bool counts_share(size_t inside, size_t n, double least, double most);

/* A number or a truth of each plant.  Adding leaves out NAN; printing shows the
 * mean times a scale, with its standard error; between: whether the mean lies
 * within least..most but for three standard errors. */
struct counts_mean {
	double n, sum, squares;
};
void counts_add(struct counts_mean *mean, double value);
double counts_error(const struct counts_mean *mean);
void counts_print(const struct counts_mean *mean, double scale);
bool counts_between(const struct counts_mean *mean, double least, double most);

/* Plant i of those that are counted on: the laws by turns, of plants that no
 * prior or threshold was chosen on. */
struct plant counts_plant(size_t i, uint64_t *number);

/* Calibrates with these options. */
struct fit counts_fit(
    const struct site *site, const struct calibrate_options *options);

/* A session that has a site, which it then owns, and what it answers. */
struct counts_talk;
struct counts_talk *counts_talk(struct site *site);
void counts_talk_end(struct counts_talk *talk);

/* Runs a line and returns its answer in JSON, until the next line; ends the
 * program where it is refused. */
const char *counts_say(struct counts_talk *talk, const char *line);

/* Returns the number behind a key, NAN where there is none. */
double counts_number(const char *json, const char *key);

/* Calibrates a site on all its runs and draws; posterior_free. */
struct posterior *counts_calibrate(
    const struct site *site, uint64_t seed, struct fit *fit);

#endif
