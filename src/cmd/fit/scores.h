/* The summaries of `validate`: for the runs of one site, and for many sites,
 * from one program or from parts written by several.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_SCORES_H
#define TIPSPEED_CMD_FIT_SCORES_H

#include "cmd/fit/trials.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* Names of each way to predict, for keys, column headings and sentences, and
 * which of them a narrow table can spare: see answer_column_to_spare. */
struct scores_way {
	const char *key, *head, *noun;
	int spare;
};
extern const struct scores_way SCORES_WAYS[VALIDATE_WAYS];

/* Puts "null": {"feed_rmse_pct": ..}: the errors of the null models, 0..1. */
void put_null_model_rmse(
    struct fields *o, const double rmse[static VALIDATE_WAYS]);

/* Returns the answer on the runs of this site: fields, tables, and which way
 * predicts best.  sieves: csv has a row for each sieve instead of each size. */
struct answer *scores_site_answer(
    const struct trials *c, const struct site *site, bool sieves);

/* Returns the answer of `validate all`. */
struct answer *scores_all_sites_answer(const struct trials *c);

/* scores_put_part_rows writes the runs as "rows" of a part;
 * scores_add_run_of_part reads one of them. */
void scores_put_part_rows(struct fields *o, const struct trials *c);
void scores_add_run_of_part(struct trials *c, const struct part_row *row);

#endif
