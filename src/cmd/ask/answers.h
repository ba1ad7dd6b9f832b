/* Functions shared by commands that answer questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ANSWERS_H
#define TIPSPEED_CMD_ASK_ANSWERS_H

#include <stdbool.h>

#include "cmd/ask/asked.h"
#include "cmd/lang/command.h"
#include "core/model/breakage.h"
#include "core/answer/predict.h"

/* A smaller break size, m, counts as none: every size can break. */
#define ANSWERS_NO_SIZE 1e-6

/* Returns an answer about a site, with the title "Tierp, Granite, 11.2 mm: "
 * and the formatted text. */
struct answer *answer_about_site(const struct site *site, const char *command,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Puts "feed" and "with" if the question assumes another feed or machine;
 * answer_about_site calls it. */
void answers_put_feed_and_machine(struct answer *r, const struct site *site);

/* Return false, with an error that says what to do next, if the (current) site
 * has no parameters yet or the settings are incompatible. */
bool answers_require_params(
    const struct session *s, const struct entry *entry, struct error *error);
bool answers_require_params_of_current(struct session *s, struct error *error);

/* While the site is being calibrated, returns true and the best parameters so
 * far. */
bool answers_best_params_so_far(
    const struct session *s, const struct entry *entry, struct params *params);

/* True if a speed is outside the training speeds or, if these are unknown,
 * outside the measured speeds. */
bool answers_is_speed_extrapolated(const struct entry *entry, double speed);

/* Returns B(u) at the breaker's speed.  If B depends on the parent's size, the
 * site's top size is the parent. */
double answers_breakage_at_ratio(
    const struct breaker *b, double u, const struct site *site);

/* Returns the default speed of a call: that of the held-out run nearest to the
 * middle, else 74 m/s, or the middle if 74 is beyond site_default_speed_range.
 */
double answers_default_speed(const struct entry *entry);

/* True if the site's sheet is in rpm: its speeds are whole rpm of its rotor,
 * and not all of them tenths of a m/s.  site: or NULL. */
bool answers_is_sheet_in_rpm(const struct site *site);

/* Return a speed as the site's sheet has it: 1500, "rpm" and "1500 rpm" of a
 * sheet in rpm; else 70.69 and "70.69 m/s" or, with one decimal, "70.7 m/s".
 * site: or NULL, in m/s.  decimals: of m/s; -1: as many as it has.  The caller
 * frees the text. */
double answers_speed_number(const struct site *site, double speed);
const char *answers_speed_unit(const struct site *site);
char *answers_speed_text(const struct site *site, double speed, int decimals);

/* Returns "65 to 85 m/s", or in brief "65..85 m/s"; "1307 to 1709 rpm" for a
 * sheet in rpm.  The caller frees it. */
char *answers_speed_range_words(
    const struct site *site, double from, double to, bool brief);

/* Returns round rpm from one speed to another, as m/s [*n], at most `most`;
 * NULL unless the site's sheet is in rpm.  The caller frees it. */
double *answers_speeds_at_round_rpm(
    const struct site *site, double from, double to, size_t most, size_t *n);

/* Returns at most seven round speeds over site_default_speed_range.  The caller
 * frees it. */
double *answers_list_few_round_speeds(
    const struct session *s, const struct site *site, size_t *n);

/* Returns the sieve for a sentence that quotes one passing: 2 mm, else the
 * sieve with the passing closest to 50 %. */
size_t answers_default_sieve(const struct psd *product);

/* Returns the passing of that sieve as a quantity of the whole product. */
struct quantity answers_default_passing_quantity(const struct psd *product);

/* Keeps a prediction as the newest answer of `predict`. */
void answers_keep_newest_prediction(struct session *s,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);

/* The sizes in every prediction: those of PSD_PASSING and the break size. */
enum { ANSWERS_BREAK = PSD_SIZES, ANSWERS_SIZES };

/* Names for assert: each stands for the field at path of the newest answer from
 * these commands, which are separated by spaces. */
struct asserted {
	const char *name, *from, *path;
};
enum { ANSWERS_ASSERTED = 11 };
extern const struct asserted ANSWERS_NAMES[ANSWERS_ASSERTED];

/* For each size, its key in JSON and CSV, the key of its range, and its heading
 * for people; the sizes of PSD_PASSING as a list for
 * quantities_parse_list_for_feed. */
extern const struct product_size {
	const char *key, *range_key, *head;
} ANSWERS_SIZE[ANSWERS_SIZES];
#define ANSWERS_SIZE_LIST "P20,P50,P80"

/* Returns size i, mm, or NAN if it is outside the sieves or does not exist. */
double answers_product_size_mm(const struct prediction *p, size_t i);

/* Adds a cell with size i, "below 0.063" or "none". */
void answers_add_size_cell(
    struct answer *r, const struct prediction *p, size_t i);

/* Adds the note "P20 1.14 mm, P50 2.91, P80 5.28", with ranges if there is a
 * band: "P20 1.14 mm (1.12 to 1.18)". */
void answers_note_sizes(struct answer *r, const struct prediction *p);

/* Returns "training speeds, 69 to 79 m/s" or "one measured speed, 72 m/s".  The
 * caller frees it. */
char *answers_known_speeds_text(
    const struct entry *entry, double slowest, double fastest);

/* Returns a speed as it is typed in a line: "75.16", or "1450 rpm" if the site
 * states the rotor and that is this speed.  The caller frees it. */
char *speed_as_typed(const struct site *site, double speed);

/* Appends the basis of the answer, after everything else: for an answer with a
 * band, which runs correct it and what low and high mean; then the source of
 * the parameters, the feed, the model, and the light, which it frees.  speed:
 * that of the answer, noted if it is beyond the measured speeds, or 0. */
void answers_show_basis(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band, struct trust light);

/* As answers_show_basis, with the light of the answer at that speed or, for 0,
 * that of the fit. */
void answers_show_basis_at_speed(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band);

/* Warns if nothing measurable breaks at the site, and says what to do. */
void answers_warn_if_nothing_breaks(
    struct answer *r, const struct entry *entry);

/* Appends the basis of a fit and returns its light. */
enum light answers_show_fit_basis(const struct session *s, struct answer *r,
    const struct entry *entry, bool band);

/* As answers_show_basis, but without band and light, for one side of a
 * comparison.  whose: the owner of the feed in words, or NULL. */
void answers_note_basis_of_side(const struct session *s, struct answer *r,
    const struct question *q, double speed, const char *whose,
    const struct trust *light);

/* Adds columns and a row for each prediction: energy, break size, P20, P50,
 * P80. */
void answers_add_row_per_prediction(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n);

/* answers_put_low_high puts [low, high]; answers_put_sizes puts "p20_mm" to
 * "break_mm" of a prediction. */
void answers_put_low_high(
    struct fields *o, const char *key, double low, double high);
void answers_put_sizes(struct fields *o, const struct prediction *p);

/* Puts the ranges of the sizes and "level", if the prediction has a band. */
void answers_put_size_bands(
    struct fields *o, const struct session *s, const struct prediction *p);

/* Returns "classes" or "continuous". */
const char *answers_method_name(enum method method);

/* answers_put_prediction puts the JSON object of predict, see OUTPUT in
 * tipspeed(1); answers_put_products puts a list of several, "products". */
void answers_put_prediction(const struct session *s, struct fields *o,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);
void answers_put_products(const struct session *s, struct fields *o,
    const struct entry *entry, const struct prediction *p, size_t n);

#endif
