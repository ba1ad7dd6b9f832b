/* The summaries of `validate`: of the runs of one site, and of many sites, from
 * one program or from the parts that several wrote.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_SCORES_H
#define TIPSPEED_CMD_FIT_SCORES_H

#include "cmd/fit/trials.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* Names of each way to predict: in keys, over its column, and in sentences. */
struct scores_way {
	const char *key, *head, *noun;
};
extern const struct scores_way SCORES_WAYS[VALIDATE_WAYS];

/* Puts "null": {"feed_rmse_pct": ..}: the errors of the null models, 0..1. */
void scores_put_null(struct fields *o, const double rmse[static VALIDATE_WAYS]);

/* Returns the answer on the runs of this site: fields, tables, and which
 * predicts best.  sieves: csv has a row a sieve, in place of one a size. */
struct answer *scores_site_answer(
    const struct trials *c, const struct site *site, bool sieves);

/* Returns the answer of `validate all`. */
struct answer *scores_answer(const struct trials *c);

/* scores_put writes the runs as "rows" of a part; scores_add_part_site reads
 * those of one site of a part. */
void scores_put(struct fields *o, const struct trials *c);
void scores_add_part_site(struct trials *c, const struct part_site *site);

#endif
