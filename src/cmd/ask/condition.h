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

/* Reads one: a quantity (quantity_words.h), then <, > or = and a number or,
 * after =, a range, or the words for these; of the fraction where it names
 * none.  A single number after = is both limits. */
bool conditions_read(const char *text, const struct fraction *fraction,
    struct condition *condition, struct error *error);

/* How long the first of a list is, with commas between: a comma within a number
 * is none of these. */
size_t conditions_length(const char *list);

/* Adds what a text has, with commas between. */
bool conditions_read_list(const char *text, const struct fraction *fraction,
    struct condition_list *list, struct error *error);

/* Adds the operands of a call, which a feed has to tell of.  They are ranges:
 * a single value holds at single speeds only. */
bool conditions_add_operands(const struct args *args,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, struct error *error);

/* Adds the limits of an envelope (grading_limits) on a fraction, or where that
 * is all of the product the one that the envelope is for.  words: what is to be
 * said of it, or NULL, which the caller frees. */
bool conditions_add_spec(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, char **words, struct error *error);

/* The same of the envelope that the option spec of a call names, if it is
 * given. */
bool conditions_add_option(struct session *s, const struct args *args,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, char **words, struct error *error);

/* Whether a feed tells of the sizes that it needs, its limits among them. */
bool conditions_covered(const struct condition *condition,
    const struct psd *feed, struct error *error);

/* The options from and to of a call, else site_reach. */
bool conditions_speeds(const struct session *s, const struct args *args,
    const struct site *site, double *from, double *to, struct error *error);

/* "passing 2 mm 40 to 50 %", "P80 at least 5 mm"; a limit of the list "passing
 * 2 mm at most 50 %"; all of it with commas between; the caller frees. */
char *conditions_words(const struct condition *condition);
char *conditions_list_words(const struct condition_list *list);
char *conditions_limit(
    const struct condition_list *list, struct wanted_limit limit);

/* Columns and a row for each condition, of an answer or for NULL of none, and
 * objects of the list "conditions": its limits, its value at the speed the
 * forecast is at, with the band, the margin and where it alone holds. */
void conditions_rows(struct answer *r, struct fields *o,
    const struct wanted *wanted, const struct speed_search *found);

/* The list's quantities and the target's, or for NULL none, of a question, at
 * the speeds of site_reach; the list and the target must outlive it, whose
 * `forecast` is forecast_close's. */
struct wanted conditions_ask(const struct session *s, const struct question *q,
    const struct condition_list *list, const struct condition *target);

/* The speeds at which all hold: "69.0 to 77.9", "69.0 to 70.1 and 74.4",
 * "74.42 to 74.47".  The caller frees. */
char *conditions_speeds_words(const struct speed_search *found);

/* A margin in widths of the band; NAN of a model alone. */
double conditions_widths(const struct wanted *wanted, struct margin margin);

/* "max 2/5" for "most 2/5": what find takes instead; NULL of other words.  The
 * caller frees. */
char *conditions_extreme(const char *text);

/* Decimals for points that a limit is missed by, so that none reads 0.0. */
int conditions_digits(double points);

/* What stands in the way where no speed meets the conditions. */
void conditions_note_missed(struct answer *r, const struct wanted *wanted,
    const struct condition_list *list, const struct speed_search *found);

/* What was not searched, slower or faster, and how to. */
void conditions_note_farther(
    struct answer *r, const struct wanted *wanted, bool slower, bool faster);

/* "92 %"; draws alone never make sure: "over 99 %", "under 1 %".  The caller
 * frees. */
char *conditions_percent(double share);

/* "over 99 %, met", "47 %, as likely as not": how certain it is that conditions
 * are met, and what that makes of them; share NAN: met or missed, as the answer
 * has it.  The caller frees. */
char *conditions_chance(double share, bool holds);

#endif
