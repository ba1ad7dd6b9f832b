/* Conditions on a product in words: "passing 2 = 40..50", "P80 > 5".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CONDITION_H
#define TIPSPEED_CMD_ASK_CONDITION_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"

/* Parses a condition: a quantity (quantity_words.h), then <, > or = (or words
 * for these) and a number or, after =, a range.  A single number after = is
 * both limits.  A quantity that names no fraction is one of `fraction`. */
bool conditions_parse_one(const char *text, const struct fraction *fraction,
    struct condition *condition, struct error *error);

/* Returns the quantity after max or min, maximise or minimise, or NULL for
 * other words. */
const char *conditions_parse_max_or_min(const char *text, bool *most);

/* True if a text may be a whole condition: a quantity with its limit, even
 * without a sign, or max and a quantity. */
bool conditions_is_likely_complete(const char *text);

/* Adds the position of operand i to an error.  Returns false. */
bool conditions_set_error_place(
    const struct args *args, size_t i, struct error *error);

/* Returns the length of the first condition in a list separated by commas; a
 * comma inside a number does not count. */
size_t conditions_length_of_first(const char *list);

/* Parses conditions separated by commas and adds them to the list. */
bool conditions_parse_list(const char *text, const struct fraction *fraction,
    struct condition_list *list, struct error *error);

/* Adds the operands of a call, whose sizes the question's feed must cover, and
 * the limits of its option spec.  Operands must be ranges, as a single value
 * holds only at single speeds. */
bool conditions_add_from_args(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error);

/* Adds the limits of an envelope (envelope_add_conditions) for a fraction or,
 * given the whole product, for the envelope's own fraction. */
bool conditions_add_envelope(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, struct error *error);

/* As conditions_add_envelope, for the envelope in the option spec of a call, if
 * given. */
bool conditions_add_envelope_option(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error);

/* Notes the source of the list's limits, if it has one. */
void conditions_note_source_of_limits(
    struct answer *r, const struct condition_list *list);

/* True if a feed covers the sizes of the condition and its limits.  Otherwise
 * sets an error. */
bool conditions_check_feed_covers(const struct condition *condition,
    const struct psd *feed, struct error *error);

/* Reads the options from and to of a call; the default is
 * settings_default_speed_range. */
bool conditions_speed_range_of_args(const struct session *s,
    const struct args *args, const struct site *site, double *from, double *to,
    struct error *error);

/* conditions_one_text returns "passing 2 mm 40 to 50 %" or "P80 at least 5 mm";
 * conditions_list_text all conditions, separated by commas;
 * conditions_limit_text a limit of conditions, "passing 2 mm at most 50 %".
 * The caller frees it. */
char *conditions_one_text(const struct condition *condition);
char *conditions_list_text(const struct condition_list *list);
char *conditions_limit_text(
    const struct condition *at, struct wanted_limit limit);

/* For each condition, conditions_add_rows adds a row to an answer,
 * conditions_put_list an object to the list "conditions": the limits, the value
 * at the forecast's speed with its band, the margin, and the range of speeds
 * where this condition holds by itself. */
void conditions_add_rows(struct answer *r, const struct wanted *wanted,
    const struct speed_search *found);
void conditions_put_list(struct fields *o, const struct wanted *wanted,
    const struct speed_search *found);

/* Prepares a question's search over settings_default_speed_range for the
 * list's conditions and a target, or NULL.  The list may be empty, if the
 * target is all that is sought.  List and target must outlive the result; free
 * its `forecast` with forecast_close. */
struct wanted conditions_open_search(const struct session *s,
    const struct question *q, const struct condition_list *list,
    const struct condition *target);

/* Return the speeds at which all conditions hold, in words: as the sheet has
 * them, "69.0 to 77.9" or "1319 to 1434"; or with units, and in rpm if the site
 * states the rotor: "67.7 to 73.6 m/s (1319 to 1434 rpm)".  site: or NULL, in
 * m/s.  The caller frees it. */
char *conditions_met_speeds_text(
    const struct speed_search *found, const struct site *site);
char *conditions_met_speeds_with_units(
    const struct wanted *wanted, const struct speed_search *found);

/* Returns how far the value at the forecast's speed is from the limit of a
 * margin, "2.99 mm" or "6.9 points".  The caller frees it. */
char *conditions_margin_text(const struct wanted *wanted, struct margin margin);

/* Returns the words that find understands, "max 2/5", for words such as "most
 * 2/5"; NULL for others.  The caller frees it. */
char *conditions_rewrite_superlative(const char *text);

/* Returns enough decimals to show the points by which a limit is missed as more
 * than 0.0. */
int conditions_decimals_of_miss(double points);

/* Returns the measured speed nearest to one beyond the measured speeds, m/s;
 * NAN if it lies between them or none were measured. */
double conditions_nearest_measured_speed(
    const struct wanted *wanted, double speed);

/* If no speed meets all conditions, notes which of them prevent it, and whether
 * the feed alone does.  Moves the forecast to the best speed. */
void conditions_note_why_unmet(struct answer *r, const struct wanted *wanted,
    const struct speed_search *found);

/* Notes that the feed alone is finer than a limit of a condition allows, which
 * no speed can put right.  most: its upper limit.  Returns false if that is not
 * the case. */
bool conditions_note_feed_is_finer(struct answer *r,
    const struct wanted *wanted, const struct condition *c, bool most);

/* Notes which speed to run at and the range in which the conditions hold with
 * the certainty of a band; in detail the slowest safe speed, too.  If the
 * answer meets them at no speed: where they are most likely to hold.  several:
 * there is more than one condition. */
void conditions_note_best_speed(struct answer *r, const struct wanted *wanted,
    bool several, bool detail, const struct speed_search *w);

/* As answers_show_basis, for an answer at a speed in a range of speeds: if the
 * light is worse at an end of the range beyond the measured speeds, the answer
 * has that light, and both are stated.  Puts "best_trust", the light at that
 * speed. */
void conditions_show_basis(struct answer *r, const struct question *q,
    const struct wanted *wanted, const struct speed_search *found,
    double speed);

/* conditions_note_unsearched_speeds notes which slower or faster speeds were
 * not searched, and how to search them, unless no answer there can be relied
 * on; conditions_note_no_reliable_speed says that if no speed was found.
 */
void conditions_note_unsearched_speeds(
    struct answer *r, const struct wanted *wanted, bool slower, bool faster);
void conditions_note_no_reliable_speed(
    struct answer *r, const struct wanted *wanted, bool slower, bool faster);

/* Returns "92 %", but "over 99 %" or "under 1 %" instead of 100 and 0, because
 * draws never prove certainty.  The caller frees it. */
char *conditions_probability_text(double share);

/* Returns "92 times in 100", "over 99 times in 100".  The caller frees it. */
char *conditions_times_in_100_text(double share);

/* Returns in words whether conditions are met, given the probability that they
 * are, "likely met", or, if that is NAN, whether the answer meets them. */
const char *conditions_verdict(double share, bool holds);

#endif
