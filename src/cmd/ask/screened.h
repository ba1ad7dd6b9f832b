/* A prediction of a screened fraction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SCREENED_H
#define TIPSPEED_CMD_ASK_SCREENED_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"
#include "core/psd/quantity.h"

/* What is wanted of a prediction.  sieve [n] m, coarsest first; n is 0 where
 * they are to stay. */
struct screened {
	struct fraction fraction;
	size_t n;
	double *sieve;
};

/* A fraction; false where the feed does not tell of it. */
bool screened_read(const struct fraction *fraction, const struct psd *feed,
    struct screened *wanted, struct error *error);

/* Turns the prediction, made with these parameters, into that. */
void screened_take(const struct session *s, const struct entry *entry,
    const struct params *params, const struct screened *wanted,
    struct prediction *p);

/* What was measured, of that fraction; psd_free. */
struct psd screened_measured(
    const struct psd *product, const struct fraction *fraction);

/* A quantity of what was measured; NAN where that does not tell. */
double screened_value(const struct psd *product, const struct quantity *q);

/* ", fraction 0/4", or "" of the whole product.  The caller frees. */
char *screened_title(const struct prediction *p);

/* What share of the product the fraction is, in a sentence, and into fields
 * "fraction" and "share_pct"; nothing of the whole product. */
void screened_note(struct answer *r, const struct prediction *p);
void screened_put(struct fields *o, const struct prediction *p);

#endif
