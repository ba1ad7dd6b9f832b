/* Conditions on a product in words, such as "passing 2 = 40..50" or "P80 > 5".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CONDITION_H
#define TIPSPEED_CMD_ASK_CONDITION_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"

/* Parses a condition: a quantity (quantity_words.h), then <, > or =, or words
 * for these, and a number or, after =, a range.  A single number after =
 * becomes both limits.  If the quantity names no fraction, it applies to
 * `fraction`. */
bool conditions_parse_one(const char *text, const struct fraction *fraction,
    struct condition *condition, struct error *error);

/* Returns the quantity after max, min, maximise or minimise, or NULL for other
 * words.  *most: the largest value is meant. */
const char *conditions_parse_max_or_min(const char *text, bool *most);

/* True if the text may be a complete condition: a quantity and its limit, even
 * without a sign between them, or max or min and a quantity. */
bool conditions_is_likely_complete(const char *text);

/* Parses conditions separated by commas and appends them to the list. */
bool conditions_parse_list(const char *text, const struct fraction *fraction,
    struct condition_list *list, struct error *error);

/* Appends the operands of a call as conditions, and the limits of its option
 * spec.  The question's feed must cover their sizes.  Operands must be ranges,
 * because a single value is reached only at single speeds. */
bool conditions_add_from_args(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error);

/* Appends the limits of an envelope (envelope_limits_to_conditions) on its
 * fraction (envelope_fraction). */
bool conditions_add_envelope(const struct spec *spec, const char *cut,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, struct error *error);

/* As conditions_add_envelope, for the option spec of a call, if it is given. */
bool conditions_add_envelope_option(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error);

/* Notes where the limits in the list come from, if that is known. */
void conditions_note_source_of_limits(
    struct answer *r, const struct condition_list *list);

/* True if the feed's sieves cover the sizes in the condition and its limits;
 * otherwise sets an error. */
bool conditions_check_feed_covers(const struct condition *condition,
    const struct psd *feed, struct error *error);

/* Reads the options from and to of a call; the default is
 * settings_default_speed_range. */
bool conditions_parse_search_range(const struct session *s,
    const struct args *args, const struct site *site, double *from, double *to,
    struct error *error);

/* conditions_one_text returns "passing 2 mm 40 to 50 %" or "P80 at least 5 mm";
 * conditions_list_text returns all conditions, separated by commas;
 * conditions_limit_text returns a single limit, "passing 2 mm at most 50 %".
 * The caller frees them. */
char *conditions_one_text(const struct condition *condition);
char *conditions_list_text(const struct condition_list *list);
char *conditions_limit_text(
    const struct condition *at, struct wanted_limit limit);

/* conditions_add_answer_rows adds a table row for each condition;
 * conditions_put_fields puts a list "conditions" with an object for each.  They
 * have the limits, the value at the forecast's speed with its band, the margin,
 * and the range of speeds in which this condition holds, whatever the others
 * do. */
void conditions_add_answer_rows(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found);
void conditions_put_fields(struct fields *o,
    const struct conditions_search *wanted, const struct speed_search *found);

/* Prepares a search over settings_default_speed_range for a question's product,
 * the conditions in the list and a target, or NULL.  The list may be empty if
 * only the target is sought.  List and target must outlive the result; free its
 * `forecast` with forecast_close. */
struct conditions_search conditions_open_search(const struct session *s,
    const struct question *q, const struct condition_list *list,
    const struct condition *target);

/* Return the speeds at which all conditions hold, in words.  The first uses the
 * unit of the sheet: "69.0 to 77.9" or "1319 to 1434"; m/s if site is NULL.
 * The second names the unit, and adds rpm if the site states its rotor: "67.7
 * to 73.6 m/s (1319 to 1434 rpm)".  The caller frees them. */
char *conditions_met_speeds_text(
    const struct speed_search *found, const struct site *site);
char *conditions_met_speeds_text_with_units(
    const struct conditions_search *wanted, const struct speed_search *found);

/* Returns the distance between the value at the forecast's speed and the limit
 * of the margin, as "2.99 mm" or "6.9 points".  The caller frees it. */
char *conditions_margin_text(
    const struct conditions_search *wanted, struct margin margin);

/* Returns "max 2/5" for a text such as "most 2/5", and "max passing 2 mm" for
 * "max 2 mm", which find does not understand; NULL for other texts.  The caller
 * frees it. */
char *conditions_rewrite_superlative(const char *text);

/* Returns the number of decimals with which a miss of so many points is not
 * shown as 0.0. */
int conditions_decimals_of_miss(double points);

/* Returns the measured speed, m/s, nearest to a speed outside the measured
 * range; NAN if the speed is inside it or none was measured. */
double conditions_nearest_measured_speed(
    const struct conditions_search *wanted, double speed);

/* If no speed meets all conditions, notes which conditions prevent it, and
 * whether the feed alone does.  Leaves the forecast at the best speed. */
void conditions_note_why_unmet(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found);

/* If the feed itself is already too fine for a limit of the condition (its
 * upper limit if `most`), notes that no speed can help, and returns true. */
bool conditions_note_feed_too_fine(struct answer *r,
    const struct conditions_search *wanted, const struct condition *c,
    bool most);

/* Notes which speed to run at, and the range of speeds in which the conditions
 * hold with the probability of the band; if `detail`, also the slowest safe
 * speed.  If the answer meets the conditions at no speed, notes where they are
 * most likely to hold.  several: there is more than one condition. */
void conditions_note_best_speed(struct answer *r,
    const struct conditions_search *wanted, bool several, bool detail,
    const struct speed_search *w);

/* As answers_note_basis_and_trust, for an answer at a speed in a range of
 * speeds: if the light is worse at an end of the range beyond the measured
 * speeds, the answer has that light, and both are stated.  Puts "best_trust",
 * the light at that speed. */
void conditions_note_basis_and_trust(struct answer *r, const struct question *q,
    const struct conditions_search *wanted, const struct speed_search *found,
    double speed);

/* conditions_note_unsearched_speeds notes that slower or faster speeds were not
 * searched, and how to search them, unless no answer there can be relied on;
 * conditions_note_no_reliable_speed does so, or says why not, if no speed was
 * found. */
void conditions_note_unsearched_speeds(struct answer *r,
    const struct conditions_search *wanted, bool slower, bool faster);
void conditions_note_no_reliable_speed(struct answer *r,
    const struct conditions_search *wanted, bool slower, bool faster);

/* Returns the sign between the two ends of a range, as in "40..50", "40 to 50"
 * and "40-50", and its length; NULL if there is only one number, which may
 * begin with a minus sign. */
const char *conditions_find_range_sign(const char *text, size_t *length);

/* Returns "92 %", but "over 99 %" and "under 1 %" at the ends, because a number
 * of draws never proves certainty.  The caller frees it. */
char *conditions_probability_text(double share);

/* Returns "92 times in 100" or "over 99 times in 100".  The caller frees it. */
char *conditions_times_in_100_text(double share);

/* Returns whether conditions are met, as words: "likely met" by the probability
 * that they are or, if that is NAN, by whether the answer meets them. */
const char *conditions_verdict(double share, bool holds);

#endif
