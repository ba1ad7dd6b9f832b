/* The answers of `validate`: on the runs of one site, and on all sites, from
 * one program or from parts written by several.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_SCORES_H
#define TIPSPEED_CMD_FIT_SCORES_H

#include "cmd/fit/trials.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* The names of a way to predict: its key, its column heading, and a noun for
 * sentences.  spare: when a narrow table leaves out its column, see
 * answer_add_optional_column. */
struct scores_way {
	const char *key, *head, *noun;
	int spare;
};
extern const struct scores_way SCORES_WAYS[VALIDATE_WAYS];

/* Puts "null": {"feed_rmse_pct": ..}. rmse: the errors of all ways, 0..1, of
 * which those of the null models are used. */
void put_null_model_rmse(
    struct fields *o, const double rmse[static VALIDATE_WAYS]);

/* Returns the answer on the held-out runs of one site: fields, tables, and
 * which way predicts best.  sieves: show every sieve; for programs instead of
 * P20, P50 and P80. */
struct answer *scores_build_answer_of_site(
    const struct trials *c, const struct site *site, bool sieves);

/* Returns the answer of `validate all`. */
struct answer *scores_build_answer_of_all_sites(const struct trials *c);

/* scores_put_rows_for_merging puts the runs as "rows" into the answer of a
 * part; scores_add_run_of_part reads one of these rows. */
void scores_put_rows_for_merging(struct fields *o, const struct trials *c);
void scores_add_run_of_part(struct trials *c, const struct part_row *row);

#endif
