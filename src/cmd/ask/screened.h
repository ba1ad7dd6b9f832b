/* A screened fraction of a product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SCREENED_H
#define TIPSPEED_CMD_ASK_SCREENED_H

#include "cmd/ask/asked.h"
#include "core/answer/predict.h"
#include "core/psd/quantity.h"

/* False with an error if the question's feed does not cover the fraction that
 * it asks for. */
bool screened_is_measured_alone(const struct question *q, struct error *error);

/* Returns that fraction of a measured product; free with psd_free. */
struct psd screened_measured(
    const struct psd *product, const struct fraction *fraction);

/* Returns a quantity of a measured product; NAN if its sieves do not cover
 * it. */
double screened_value(const struct psd *product, const struct quantity *q);

/* Returns ", fraction 0/4", or "" for the whole product.  The caller frees. */
char *screened_title(const struct fraction *fraction);

/* screened_note says in a sentence which share of the product the fraction is;
 * screened_put puts fields "fraction" and "share_pct".  Neither does anything
 * for the whole product. */
void screened_note(struct answer *r, const struct prediction *p);
void screened_put(struct fields *o, const struct prediction *p);

#endif
