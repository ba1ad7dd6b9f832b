/* Commands that answer, and what they have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ANSWERS_H
#define TIPSPEED_CMD_ASK_ANSWERS_H

#include <stdbool.h>

#include "cmd/ask/asked.h"
#include "cmd/lang/command.h"
#include "core/model/breakage.h"
#include "core/answer/predict.h"

/* A break size below this, m, is none: every size can break. */
#define ANSWERS_NO_SIZE 1e-6

/* An answer about a site, headed "Tierp, Granite, 11.2 mm: " and what the
 * format says. */
struct answer *answers_new(const struct site *site, const char *command,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Puts "feed" and "with" where it is asked about another feed or machine;
 * answers_new does. */
void answers_put_variant(struct answer *r, const struct site *site);

/* False, with the next step, where the site (in use) has no parameters yet, or
 * the settings do not go together. */
bool answers_known(
    const struct session *s, const struct entry *entry, struct error *error);
bool answers_ready(struct session *s, struct error *error);

/* While the site is being calibrated: true, with the best parameters so far. */
bool answers_forming(
    const struct session *s, const struct entry *entry, struct params *params);

/* Whether a speed lies outside those that the parameters were trained at, or
 * were measured where that is not known. */
bool answers_extrapolates(const struct entry *entry, double speed);

/* B(u) at the breaker's speed, of a parent of the site's top size where it
 * depends on that. */
double answers_finer(
    const struct breaker *b, double u, const struct site *site);

/* The speed asked about where none is named: that of the held-out run nearest
 * to the middle, else 74 m/s, or the middle where that is beyond site_reach. */
double answers_usual(const struct entry *entry);

/* Round speeds over site_reach, seven at most.  The caller frees. */
double *answers_speeds(
    const struct session *s, const struct site *site, size_t *n);

/* The sieve whose passing stands for a product where a sentence has one: that
 * of 2 mm, else the one that half passes most nearly. */
size_t answers_sieve(const struct psd *product);

/* Keeps a prediction as the newest answer of `predict`. */
void answers_keep(struct session *s, const struct entry *entry,
    const struct params *params, const struct prediction *p);

/* The sizes every prediction has. */
enum { ANSWERS_P20, ANSWERS_P50, ANSWERS_P80, ANSWERS_BREAK, ANSWERS_SIZES };

/* What assert knows by a name of its own: a field of the newest answer of one
 * of these commands, with a space between two. */
struct asserted {
	const char *name, *from, *path;
};
enum { ANSWERS_ASSERTED = 11 };
extern const struct asserted ANSWERS_NAMES[ANSWERS_ASSERTED];

/* How one is called in json and csv, its range, and by people. */
extern const char *const ANSWERS_KEYS[ANSWERS_SIZES],
    *const ANSWERS_RANGES[ANSWERS_SIZES], *const ANSWERS_HEADS[ANSWERS_SIZES];

/* That size, mm; NAN where it lies outside the sieves, or there is none. */
double answers_size(const struct prediction *p, size_t i);

/* A cell with it, or with "below 0.063", or "none". */
void answers_size_cell(struct answer *r, const struct prediction *p, size_t i);

/* The note "P20 1.14 mm, P50 2.91, P80 5.28", with their ranges where a band is
 * given: "P20 1.14 mm (1.12 to 1.18)". */
void answers_note_sizes(struct answer *r, const struct prediction *p);

/* "training speeds, 69 to 79 m/s", "one measured speed, 72 m/s".  The caller
 * frees. */
char *answers_reach(const struct entry *entry, double slowest, double fastest);

/* A speed and its range, or NANs, in revolutions where the site states the
 * rotor. */
void answers_note_rpm(struct answer *r, const struct site *site, double speed,
    double low, double high);

/* What an answer rests on, behind all else: which runs correct it and what low
 * and high are, where it shows a band; where the parameters are from, the feed,
 * the model, and the light, which is freed.  speed: 0, or the one that it is
 * of, which may be beyond the measured ones. */
void answers_show_basis(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band, struct trust light);

/* The same with the light of the answer at that speed, or for 0 of the fit. */
void answers_show_basis_at(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band);

/* What a fit rests on, likewise; returns its light. */
enum light answers_show_basis_of_fit(const struct session *s, struct answer *r,
    const struct entry *entry, bool band);

/* All of it but band and light, of one side of a comparison.
 * whose: NULL, or what the feed is said to be of. */
void answers_note_basis(const struct session *s, struct answer *r,
    const struct question *q, double speed, const char *whose,
    const struct trust *light);

/* Columns and a row for each prediction: energy, break size, P20, P50, P80. */
void answers_speed_rows(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n);

/* Puts [low, high]; and "p20_mm" to "break_mm" of a prediction. */
void answers_put_pair(
    struct fields *o, const char *key, double low, double high);
void answers_put_sizes(struct fields *o, const struct prediction *p);

/* Puts the ranges of the sizes and "level", where it has a band. */
void answers_put_band(
    struct fields *o, const struct session *s, const struct prediction *p);

/* "classes" or "continuous". */
const char *answers_method(enum method method);

/* The JSON object of predict, see tipspeed(1), OUTPUT; and the list of several,
 * "products" of an object. */
void answers_put_prediction(const struct session *s, struct fields *o,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);
void answers_put_products(const struct session *s, struct fields *o,
    const struct entry *entry, const struct prediction *p, size_t n);

#endif
