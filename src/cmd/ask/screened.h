/* A screened fraction of a product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SCREENED_H
#define TIPSPEED_CMD_ASK_SCREENED_H

#include "cmd/ask/asked.h"
#include "core/answer/predict.h"
#include "core/psd/quantity.h"

/* Returns false with an error if the question's feed does not cover the sizes
 * of its fraction. */
bool screened_check_feed_covers(const struct question *q, struct error *error);

/* Returns a fraction of a measured product.  Free with psd_free. */
struct psd screened_fraction_of_product(
    const struct psd *product, const struct fraction *fraction);

/* Returns the passings of the same fraction of a prediction's feed at the
 * sieves of the table [p->product.n], 0..1.  The caller frees them. */
double *screened_feed_passings(const struct prediction *p);

/* Returns the value of a quantity for a measured product, or NAN if its sieves
 * do not cover it. */
double screened_quantity_of_product(
    const struct psd *product, const struct quantity *q);

/* Returns ", fraction 0/4", or "" for the whole product.  The caller frees
 * it. */
char *screened_fraction_title_suffix(const struct fraction *fraction);

/* screened_note_share adds a sentence that says how much of the product the
 * fraction is; screened_put_fraction_fields puts the fields "fraction" and
 * "share_pct". Neither does anything for the whole product. */
void screened_note_share(struct answer *r, const struct prediction *p);
void screened_put_fraction_fields(struct fields *o, const struct prediction *p);

#endif
