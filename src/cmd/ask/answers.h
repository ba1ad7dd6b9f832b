/* What commands that answer questions have in common.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ANSWERS_H
#define TIPSPEED_CMD_ASK_ANSWERS_H

#include <stdbool.h>

#include "cmd/ask/asked.h"
#include "cmd/lang/command.h"
#include "core/model/breakage.h"
#include "core/answer/predict.h"

/* A break size below this, m, counts as none: every size can break. */
#define ANSWERS_NO_SIZE 1e-6

/* Returns an answer about a site, headed "Tierp, Granite, 11.2 mm: " and the
 * text of the format. */
struct answer *answers_new(const struct site *site, const char *command,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Puts "feed" and "with" if the site is asked about with another feed or
 * machine; answers_new calls it. */
void answers_put_variant(struct answer *r, const struct site *site);

/* False, with an error that says what to do next, if the site (in use) has no
 * parameters yet, or the settings do not go together. */
bool answers_check_params(
    const struct session *s, const struct entry *entry, struct error *error);
bool answers_check_current(struct session *s, struct error *error);

/* While the site is being calibrated: true, with the best parameters so far. */
bool answers_best_so_far(
    const struct session *s, const struct entry *entry, struct params *params);

/* True if a speed lies outside those that the parameters were trained at or,
 * where these are not known, outside those measured. */
bool answers_extrapolates(const struct entry *entry, double speed);

/* Returns B(u) at the breaker's speed.  If B depends on the parent's size, the
 * site's top size is the parent. */
double answers_share_finer(
    const struct breaker *b, double u, const struct site *site);

/* Returns the speed to use if the call names none: that of the held-out run
 * nearest to the middle, else 74 m/s, or the middle if 74 is beyond
 * site_reach. */
double answers_usual_speed(const struct entry *entry);

/* Returns round speeds over site_reach, seven at most.  The caller frees. */
double *answers_speeds(
    const struct session *s, const struct site *site, size_t *n);

/* Returns the sieve to quote where a sentence has one passing: 2 mm, else the
 * sieve with the passing nearest to half. */
size_t answers_usual_sieve(const struct psd *product);

/* Keeps a prediction as the newest answer of `predict`. */
void answers_keep_prediction(struct session *s, const struct entry *entry,
    const struct params *params, const struct prediction *p);

/* The sizes in every prediction. */
enum { ANSWERS_P20, ANSWERS_P50, ANSWERS_P80, ANSWERS_BREAK, ANSWERS_SIZES };

/* Names for assert, each a field of the newest answer of these commands,
 * separated by spaces. */
struct asserted {
	const char *name, *from, *path;
};
enum { ANSWERS_ASSERTED = 11 };
extern const struct asserted ANSWERS_NAMES[ANSWERS_ASSERTED];

/* For each size its key in JSON and CSV, the key of its range, and its head for
 * people. */
extern const char *const ANSWERS_KEYS[ANSWERS_SIZES],
    *const ANSWERS_RANGES[ANSWERS_SIZES], *const ANSWERS_HEADS[ANSWERS_SIZES];

/* Returns size i, mm; NAN if it lies outside the sieves, or does not exist. */
double answers_size(const struct prediction *p, size_t i);

/* Adds a cell with size i, or with "below 0.063" or "none". */
void answers_size_cell(struct answer *r, const struct prediction *p, size_t i);

/* Adds the note "P20 1.14 mm, P50 2.91, P80 5.28", with ranges where there is a
 * band: "P20 1.14 mm (1.12 to 1.18)". */
void answers_note_sizes(struct answer *r, const struct prediction *p);

/* Returns "training speeds, 69 to 79 m/s", or "one measured speed, 72 m/s".
 * The caller frees. */
char *answers_reach_words(
    const struct entry *entry, double slowest, double fastest);

/* Adds a note with a speed and its range, or NANs, in revolutions, if the site
 * states the rotor. */
void answers_note_rpm(struct answer *r, const struct site *site, double speed,
    double low, double high);

/* Appends the basis of the answer, after everything else: if it has a band,
 * which runs correct it and what low and high mean; then the source of the
 * parameters, the feed, the model, and the light, which is freed.  speed: of
 * the answer, which may be beyond the measured ones, or 0. */
void answers_show_basis(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band, struct trust light);

/* As answers_show_basis, with the light of the answer at that speed, or for 0
 * of the fit. */
void answers_show_basis_at(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band);

/* Appends the basis of a fit; returns its light. */
enum light answers_show_basis_of_fit(const struct session *s, struct answer *r,
    const struct entry *entry, bool band);

/* As answers_show_basis, but without band and light, for one side of a
 * comparison.  whose: NULL, or the owner of the feed in words. */
void answers_note_basis(const struct session *s, struct answer *r,
    const struct question *q, double speed, const char *whose,
    const struct trust *light);

/* Adds columns and a row for each prediction: energy, break size, P20, P50,
 * P80. */
void answers_speed_rows(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n);

/* answers_put_pair puts [low, high]; answers_put_sizes "p20_mm" to "break_mm"
 * of a prediction. */
void answers_put_pair(
    struct fields *o, const char *key, double low, double high);
void answers_put_sizes(struct fields *o, const struct prediction *p);

/* Puts the ranges of the sizes and "level", if the prediction has a band. */
void answers_put_band(
    struct fields *o, const struct session *s, const struct prediction *p);

/* Returns "classes" or "continuous". */
const char *answers_method_word(enum method method);

/* answers_put_prediction puts the JSON object of predict, see tipspeed(1),
 * OUTPUT; answers_put_products the list of several, "products". */
void answers_put_prediction(const struct session *s, struct fields *o,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);
void answers_put_products(const struct session *s, struct fields *o,
    const struct entry *entry, const struct prediction *p, size_t n);

#endif
