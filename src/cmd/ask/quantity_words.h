/* Quantities in words, such as "passing 2", "P80", "fm EN", "0/2" or "P50 of
 * 0/4".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_QUANTITY_WORDS_H
#define TIPSPEED_CMD_ASK_QUANTITY_WORDS_H

#include "cmd/lang/command.h"
#include "core/psd/quantity.h"

/* The size below which particles are fines, m. */
#define QUANTITIES_FINES 0.000063

/* Parses a quantity, with sizes in mm.  If it names no fraction, it is one of
 * the whole product.  partition: describes the screens. */
bool quantities_parse_one(const char *text, const struct partition *partition,
    struct quantity *q, struct error *error);

/* Returns the length of the word before a size for what passes it, as in "under
 * 2 mm", or is retained, as in "over 8 mm"; or 0. */
size_t quantities_word_before_size(const char *text, bool *retained);

/* True if the first word of the text, or the first of a list such as "cu,cc",
 * is a quantity or begins one. */
bool quantities_is_beginning_of_text(const char *text);

/* Returns completion n for a goal, "p80=" or "passing ": a few of each kind
 * that can be typed.  NULL after the last. */
const char *quantities_nth_completion(size_t n);

/* Parses a fraction in mm, "0/4" or "4/8". */
bool quantities_parse_size_fraction(
    const char *text, struct fraction *fraction, struct error *error);

/* Applies the option cut= to a quantity that names no fraction.  Returns false
 * if the quantity is itself a fraction, to which cut= cannot apply. */
bool quantities_apply_cut_option(
    struct quantity *q, const struct fraction *cut, struct error *error);

/* True if the feed's sieves cover all sizes of the quantity; otherwise sets an
 * error. */
bool quantities_check_feed_covers(
    const struct quantity *q, const struct psd *feed, struct error *error);

/* Parses quantities separated by commas, [*n], and applies cut= to each.  One
 * that the feed does not cover is an error if `all` is true, and otherwise left
 * out.  Returns NULL with an error.  The caller frees the list. */
struct quantity *quantities_parse_list_for_feed(const char *text,
    const struct fraction *cut, const struct psd *feed, bool all, size_t *n,
    struct error *error);

/* quantities_name returns "passing 2 mm", "P80 of 0/4", "fineness modulus (EN
 * 12620)" or "0/2"; quantities_field_name a key with the unit, "passing_2_pct",
 * "p80_mm" or "share_0_2_pct".  The caller frees them. */
char *quantities_name(const struct quantity *q);
char *quantities_field_name(const struct quantity *q);

/* Returns "33.9 % passes 2 mm" or "P80 is 5.24 mm".  value: in core's unit.
 * The caller frees it. */
char *quantities_sentence_with_value(const struct quantity *q, double value);

/* Returns the quantity as one would type it: "p80", "passing 2 mm".  The caller
 * frees it. */
char *quantities_text_to_type(const struct quantity *q);

/* Returns "0/4".  The caller frees it. */
char *quantities_fraction_text(const struct fraction *fraction);

/* Returns " (2.91 to 3.02)", or "" without a band.  The caller frees it. */
char *quantities_band_text(double low, double high, int decimals);

/* quantities_unit_suffix returns the unit to write after a number: " mm", " %"
 * or ""; quantities_difference_suffix that of the difference of two values, "
 * points" for percentages; quantities_unit the unit without the space.
 * quantities_is_size is true if the unit is mm.  quantities_value_in_shown_unit
 * converts a value to this unit, and quantities_decimals returns how many
 * decimals to show. */
const char *quantities_unit_suffix(const struct quantity *q);
const char *quantities_difference_suffix(const struct quantity *q);
const char *quantities_unit(const struct quantity *q);
bool quantities_is_size(const struct quantity *q);
double quantities_value_in_shown_unit(const struct quantity *q, double value);
int quantities_decimals(const struct quantity *q);

#endif
