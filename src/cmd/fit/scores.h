/* The summary of `validate all`: the runs of many sites, from one program or
 * from the parts that several wrote.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_SCORES_H
#define TIPSPEED_CMD_FIT_SCORES_H

#include "core/check/validate.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* Names of each way to predict: in keys, over its column, and in sentences; and
 * of each size in keys. */
struct scores_way {
	const char *key, *head, *noun;
};
extern const struct scores_way SCORES_WAYS[VALIDATE_WAYS];
extern const char *const SCORES_SIZES[PSD_SIZES];

/* Puts "null": {"feed_rmse_pct": ..}: the errors of the null models, 0..1. */
void scores_put_null(struct fields *o, const double rmse[static VALIDATE_WAYS]);

/* A compared run: the index of its site among all loaded ones; its key; the
 * source of its data. */
struct scored {
	size_t index;
	char *key, *source;
	struct validation v;
};

/* Compared runs, in the order of the sites.  each: every speed was held out in
 * turn; left_out: sites without such a run. */
struct scores {
	bool each;
	size_t n, left_out;
	struct scored *item;
};

/* Adds a copy. */
void scores_add(struct scores *scores, const struct scored *item);
void scores_clear(struct scores *scores);

/* Returns the answer of `validate all`. */
struct answer *scores_answer(const struct scores *scores);

/* scores_put writes the runs as "rows" of a part; scores_add_part_site reads
 * those of one site of a part. */
void scores_put(struct fields *o, const struct scores *scores);
void scores_add_part_site(struct scores *scores, const struct part_site *site);

#endif
