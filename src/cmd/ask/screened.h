/* A screened fraction of a product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SCREENED_H
#define TIPSPEED_CMD_ASK_SCREENED_H

#include "cmd/ask/asked.h"
#include "core/answer/predict.h"
#include "core/psd/quantity.h"

/* False with an error where the question's feed does not tell of the fraction
 * that it asks for. */
bool screened_tells(const struct question *q, struct error *error);

/* What was measured, of that fraction; psd_free. */
struct psd screened_measured(
    const struct psd *product, const struct fraction *fraction);

/* A quantity of what was measured; NAN where that does not tell. */
double screened_value(const struct psd *product, const struct quantity *q);

/* ", fraction 0/4", or "" of the whole product.  The caller frees. */
char *screened_title(const struct fraction *fraction);

/* What share of the product the fraction is, in a sentence, and into fields
 * "fraction" and "share_pct"; nothing of the whole product. */
void screened_note(struct answer *r, const struct prediction *p);
void screened_put(struct fields *o, const struct prediction *p);

#endif
