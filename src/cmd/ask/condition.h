/* Conditions on a product in words: "passing 2 = 40..50", "P80 > 5".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CONDITION_H
#define TIPSPEED_CMD_ASK_CONDITION_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"

/* A list that grows. */
struct condition_list {
	size_t n;
	struct condition *at;
};

void conditions_add(struct condition_list *list, struct condition condition);
void conditions_free(struct condition_list *list);

/* Reads a condition: a quantity (quantity_words.h), then <, > or = and a number
 * or, after =, a range, or the words for these.  A quantity that names no
 * fraction is of `fraction`.  A single number after = is both limits. */
bool conditions_read(const char *text, const struct fraction *fraction,
    struct condition *condition, struct error *error);

/* Returns the quantity after max or min, maximise or minimise; NULL of other
 * words. */
const char *conditions_most_of(const char *text, bool *most);

/* True if a text may be a whole condition: a quantity with its limit, of which
 * the sign may be missing, or max and a quantity. */
bool conditions_may_be_whole(const char *text);

/* Puts the place of operand i to an error.  Returns false. */
bool conditions_set_error_place(
    const struct args *args, size_t i, struct error *error);

/* Returns the length of the first condition in a list with commas between; a
 * comma inside a number does not count. */
size_t conditions_length(const char *list);

/* Reads a text of conditions with commas between, and adds them to the list. */
bool conditions_read_list(const char *text, const struct fraction *fraction,
    struct condition_list *list, struct error *error);

/* Adds the operands of a call, whose sizes the feed must cover.  They are
 * ranges: a single value holds at single speeds only. */
bool conditions_add_operands(const struct args *args,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, struct error *error);

/* Adds the limits of an envelope (grading_limits) on a fraction, or for the
 * whole product on the fraction that the envelope is for.  words: a remark for
 * the answer, or NULL, which the caller frees. */
bool conditions_add_spec(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, char **words, struct error *error);

/* As conditions_add_spec, for the envelope that the option spec of a call
 * names, if it is given. */
bool conditions_add_option(struct session *s, const struct args *args,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, char **words, struct error *error);

/* True if a feed covers the sizes of the condition, those of its limits
 * included; else an error. */
bool conditions_check_covered(const struct condition *condition,
    const struct psd *feed, struct error *error);

/* Reads the options from and to of a call, else site_reach. */
bool conditions_speeds(const struct session *s, const struct args *args,
    const struct site *site, double *from, double *to, struct error *error);

/* conditions_words returns "passing 2 mm 40 to 50 %", "P80 at least 5 mm";
 * conditions_list_words all conditions with commas between; conditions_limit a
 * limit of the list, "passing 2 mm at most 50 %".  The caller frees. */
char *conditions_words(const struct condition *condition);
char *conditions_list_words(const struct condition_list *list);
char *conditions_limit(
    const struct condition_list *list, struct wanted_limit limit);

/* Adds columns and a row for each condition to an answer, or NULL, and objects
 * to the list "conditions": its limits, its value at the forecast's speed, with
 * the band, the margin and the range where it alone holds. */
void conditions_rows(struct answer *r, struct fields *o,
    const struct wanted *wanted, const struct speed_search *found);

/* Sets up the search for the list's conditions and a target, or NULL, of a
 * question over the speeds of site_reach.  List and target must outlive the
 * result; forecast_close frees its `forecast`. */
struct wanted conditions_open(const struct session *s, const struct question *q,
    const struct condition_list *list, const struct condition *target);

/* Returns the speeds at which all conditions hold, in words: "69.0 to 77.9",
 * "69.0 to 70.1 and 74.4", "74.42 to 74.47".  The caller frees. */
char *conditions_speeds_words(const struct speed_search *found);

/* Returns a margin in widths of the band; NAN for a model alone. */
double conditions_widths(const struct wanted *wanted, struct margin margin);

/* Returns "max 2/5" for "most 2/5", the words that find understands instead;
 * NULL for other words.  The caller frees. */
char *conditions_extreme(const char *text);

/* Returns the decimals for points by which a limit is missed, so that none is
 * shown as 0.0. */
int conditions_digits(double points);

/* Notes which conditions prevent a speed from being found, where none meets
 * all. */
void conditions_note_missed(struct answer *r, const struct wanted *wanted,
    const struct condition_list *list, const struct speed_search *found);

/* Notes which speeds were not searched, slower or faster, and how to search
 * them. */
void conditions_note_farther(
    struct answer *r, const struct wanted *wanted, bool slower, bool faster);

/* Returns "92 %"; draws never prove certainty, so "over 99 %" or "under 1 %",
 * never 0 or 100.  The caller frees. */
char *conditions_percent(double share);

/* Returns "over 99 %, met", "47 %, as likely as not": the probability that
 * conditions are met, with a verdict; share NAN: "met" or "missed", as in the
 * answer.  The caller frees. */
char *conditions_chance(double share, bool holds);

#endif
