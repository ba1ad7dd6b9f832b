/* Quantities in words: "passing 2", "P80", "fm EN", "0/2", "P50 of 0/4".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_QUANTITY_WORDS_H
#define TIPSPEED_CMD_ASK_QUANTITY_WORDS_H

#include "cmd/lang/command.h"
#include "core/psd/quantity.h"

/* What passes this is called fines, m. */
#define QUANTITIES_FINES 0.000063

/* Reads one, of the whole product where it names no fraction; sizes in mm.
 * Screens separate as the partition says. */
bool quantities_read(const char *text, const struct partition *partition,
    struct quantity *q, struct error *error);

/* Whether the first word of a text is one, or begins one. */
bool quantities_begins(const char *text);

/* Reads all of a list with commas between; the caller frees.  NULL and an
 * error where one is none. */
struct quantity *quantities_list(const char *text,
    const struct partition *partition, size_t *n, struct error *error);

/* Reads a fraction, "0/4" or "4/8", mm. */
bool quantities_fraction(
    const char *text, struct fraction *fraction, struct error *error);

/* Of the fraction cut= where it names none itself; false for a fraction, which
 * would leave cut= without a meaning. */
bool quantities_cut(
    struct quantity *q, const struct fraction *cut, struct error *error);

/* Whether a feed tells of all sizes that it needs. */
bool quantities_covered(
    const struct quantity *q, const struct psd *feed, struct error *error);

/* "passing 2 mm", "P80 of 0/4", "fineness modulus (EN 12620)", "0/2"; and as a
 * key with its unit, "passing_2_pct", "p80_mm", "share_0_2_pct".  The caller
 * frees. */
char *quantities_words(const struct quantity *q);
char *quantities_key(const struct quantity *q);

/* The same as it is read: "p80", "passing 2 mm".  The caller frees. */
char *quantities_typed(const struct quantity *q);

/* "0/4". The caller frees. */
char *quantities_fraction_words(const struct fraction *fraction);

/* " (2.91 to 3.02)", or "" of what has no band.  The caller frees. */
char *quantities_band(double low, double high, int decimals);

/* " mm", " %" or "", as it stands after a number; the same without the space;
 * a value in it, and how many decimals people see. */
const char *quantities_after(const struct quantity *q);
const char *quantities_unit(const struct quantity *q);
double quantities_shown(const struct quantity *q, double value);
int quantities_decimals(const struct quantity *q);

/* The options of SHARED_CUT of a call: the fraction, or the whole product.
 * alone: screens may be described without one. */
bool quantities_option(const struct args *args, struct fraction *fraction,
    bool alone, struct error *error);

#endif
