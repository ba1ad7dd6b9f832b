/* Functions shared by commands that answer questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ANSWERS_H
#define TIPSPEED_CMD_ASK_ANSWERS_H

#include <stdbool.h>

#include "cmd/ask/asked.h"
#include "cmd/lang/command.h"
#include "core/model/breakage.h"
#include "core/answer/predict.h"

/* A break size below this, in m, is shown as none: particles of every size can
 * break. */
#define ANSWERS_NO_SIZE 1e-6

/* Returns a new answer about a site.  Its title is "Tierp, Granite, 11.2 mm: "
 * followed by the formatted text. */
struct answer *answer_new_about_site(
    const struct site *site, const char *command, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Puts the fields "feed" and "with" if the question assumes another feed or
 * machine.  answer_new_about_site calls it. */
void answers_put_feed_and_machine(struct answer *r, const struct site *site);

/* Return false if the site, or the current site, has no parameters yet, or if
 * the settings are incompatible; the error says what to do next. */
bool answers_require_params(
    const struct session *s, const struct entry *entry, struct error *error);
bool answers_require_params_current_site(
    struct session *s, struct error *error);

/* Returns true while the site is being calibrated, with the best parameters so
 * far in *params. */
bool answers_best_params_so_far(
    const struct session *s, const struct entry *entry, struct params *params);

/* True if the speed is outside the training speeds or, if these are unknown,
 * outside the measured speeds. */
bool answers_is_speed_extrapolated(const struct entry *entry, double speed);

/* Returns B(u) at the speed of the breaker.  If B depends on the size of the
 * parent, the site's top size is used. */
double answers_breakage_at_ratio(
    const struct breaker *b, double u, const struct site *site);

/* Returns the speed for a call that names none: that of the held-out run
 * nearest to the middle; without one, 74 m/s, or the middle if 74 is outside
 * site_default_speed_range. */
double answers_default_speed(const struct entry *entry);

/* True if the site's sheet is in rpm: every speed is a whole number of rpm of
 * its rotor, and not all are whole tenths of a m/s.  False if site is NULL. */
bool answers_is_sheet_in_rpm(const struct site *site);

/* Return a speed in the unit of the site's sheet: 1500, "rpm" and "1500 rpm" if
 * the sheet is in rpm; else, or if site is NULL, 70.69, "m/s" and "70.69 m/s"
 * or, with one decimal, "70.7 m/s".  decimals: of m/s; -1: as many as it has.
 * The caller frees the text. */
double answers_speed_in_sheet_unit(const struct site *site, double speed);
const char *answers_speed_unit(const struct site *site);
char *answers_speed_text(const struct site *site, double speed, int decimals);

/* Returns "65 to 85 m/s", or "65..85 m/s" if brief; "1307 to 1709 rpm" if the
 * sheet is in rpm.  The caller frees it. */
char *answers_speed_range_words(
    const struct site *site, double from, double to, bool brief);

/* Returns speeds at round rpm between two speeds, in m/s [*n]; at most `most`
 * of them.  NULL unless the site's sheet is in rpm.  The caller frees it. */
double *answers_list_round_rpm_speeds(
    const struct site *site, double from, double to, size_t most, size_t *n);

/* Returns at most seven round speeds, m/s [*n], in
 * settings_default_speed_range.  The caller frees it. */
double *answers_list_few_round_speeds(
    const struct session *s, const struct site *site, size_t *n);

/* Returns the index of the sieve for an answer that quotes one passing: 2 mm
 * or, without that sieve, the one with the passing closest to 50 %. */
size_t answers_default_sieve(const struct psd *product);

/* Returns the passing at answers_default_sieve, as a quantity of the whole
 * product. */
struct quantity answers_default_passing_quantity(const struct psd *product);

/* Makes a prediction the newest answer of `predict`, and its speed the one last
 * asked about. */
void answers_store_newest_prediction(struct session *s,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);

/* Sizes that every prediction has: those of PSD_PASSING, and the break size. */
enum { ANSWERS_BREAK = PSD_SIZES, ANSWERS_SIZES };

/* A name that `assert` knows.  It stands for the field at `path` in the newest
 * answer of one of the commands in `from`, which are separated by spaces. */
struct asserted {
	const char *name, *from, *path;
};
enum { ANSWERS_ASSERTED = 11 };
extern const struct asserted ASSERTED_NAMES[ANSWERS_ASSERTED];

/* For each size: its key in JSON and CSV, the key of its range, and its column
 * heading.  ANSWERS_SIZE_LIST has the sizes of PSD_PASSING as
 * quantities_parse_list_for_feed reads them. */
extern const struct product_size {
	const char *key, *range_key, *head;
} ANSWERS_SIZE[ANSWERS_SIZES];
#define ANSWERS_SIZE_LIST "P20,P50,P80"

/* Returns size i in mm, or NAN if it is outside the sieves or does not exist.
 */
double answers_product_size_mm(const struct prediction *p, size_t i);

/* Adds a cell with size i, or "below 0.063" or "none". */
void answers_add_size_cell(
    struct answer *r, const struct prediction *p, size_t i);

/* Adds the note "P20 1.14 mm, P50 2.91, P80 5.28", with ranges if there is a
 * band: "P20 1.14 mm (1.12 to 1.18)". */
void answers_note_p_sizes(struct answer *r, const struct prediction *p);

/* Returns "training speeds, 69 to 79 m/s" or "one measured speed, 72 m/s".  The
 * caller frees it. */
char *answers_training_range_text(
    const struct entry *entry, double slowest, double fastest);

/* Returns a speed as one would type it: "75.16", or "1450 rpm" if the site
 * states its rotor and the speed is a whole number of rpm.  The caller frees
 * it. */
char *speed_text_in_typed_unit(const struct site *site, double speed);

/* Adds what the answer is based on, after everything else.  With a band: which
 * runs correct the model, and what low and high mean.  Then the source of the
 * parameters, the feed, the model, and the light, which it frees.  speed: that
 * of the answer, with a warning if it is beyond the measured speeds; 0 if it
 * has none. */
void answers_note_basis_and_trust(const struct session *s, struct answer *r,
    const struct question *q, double speed, bool band, struct trust light);

/* As answers_note_basis_and_trust, with the light of the answer at that speed
 * or, if speed is 0, with the light of the fit. */
void answers_note_basis_and_trust_at_speed(const struct session *s,
    struct answer *r, const struct question *q, double speed, bool band);

/* Warns if fit_has_no_breakage, and says what to do. */
void answers_warn_if_nothing_breaks(
    struct answer *r, const struct entry *entry);

/* Adds what a fit is based on, and its light, which is freed. */
void answers_note_fit_basis_and_trust(const struct session *s, struct answer *r,
    const struct entry *entry, bool band, struct trust light);

/* As answers_note_basis_and_trust, but without band and light, for one of two
 * products. whose: the owner of the feed in words, or NULL.  light: if it warns
 * of the speed, no other warning does. */
void answers_note_basis_without_trust(const struct session *s, struct answer *r,
    const struct question *q, double speed, const char *whose,
    const struct trust *light);

/* Adds columns, and a row for each prediction: speed, energy, break size, P20,
 * P50, P80, the passing at the finest sieve, and whether the speed is
 * extrapolated. */
void answers_add_row_per_prediction(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n);

/* answers_put_low_high_field puts the list [low, high];
 * answers_put_product_size_fields puts the sizes of a prediction, "p20_mm" to
 * "break_mm". */
void answers_put_low_high_field(
    struct fields *o, const char *key, double low, double high);
void answers_put_product_size_fields(
    struct fields *o, const struct prediction *p);

/* If the prediction has a band, puts the ranges of its sizes and "level". */
void answers_put_p_size_bands(
    struct fields *o, const struct session *s, const struct prediction *p);

/* Returns "classes" or "continuous". */
const char *answers_method_name(enum method method);

/* answers_put_prediction_fields puts the fields of `predict`, see OUTPUT in
 * tipspeed(1); answers_put_products puts a list of these objects, "products".
 */
void answers_put_prediction_fields(const struct session *s, struct fields *o,
    const struct entry *entry, const struct params *params,
    const struct prediction *p);
void answers_put_products(const struct session *s, struct fields *o,
    const struct entry *entry, const struct prediction *p, size_t n);

#endif
