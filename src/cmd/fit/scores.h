/* What `validate all` sums up: the runs of many sites, of one program or of the
 * parts that several wrote.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_SCORES_H
#define TIPSPEED_CMD_FIT_SCORES_H

#include "core/check/validate.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* How each way is called: in keys, over its column, and in sentences; and each
 * size in keys. */
struct scores_way {
	const char *key, *head, *noun;
};
extern const struct scores_way SCORES_WAYS[VALIDATE_WAYS];
extern const char *const SCORES_SIZES[PSD_SIZES];

/* "null": {"feed_rmse_pct": ..}: what the null models err by, 0..1. */
void scores_put_null(struct fields *o, const double rmse[static VALIDATE_WAYS]);

/* A run that was compared: of which site, among all loaded ones; its key; where
 * its data are from. */
struct scored {
	size_t index;
	char *key, *source;
	struct validation v;
};

/* In the order of the sites.  each: every speed was held out in turn; left_out:
 * sites without such a run. */
struct scores {
	bool each;
	size_t n, left_out;
	struct scored *item;
};

/* Adds a copy. */
void scores_add(struct scores *scores, const struct scored *item);
void scores_clear(struct scores *scores);

/* The answer of `validate all`. */
struct answer *scores_answer(const struct scores *scores);

/* Puts the runs as "rows" of a part, and takes one of a part. */
void scores_put(struct fields *o, const struct scores *scores);
void scores_take(struct scores *scores, const struct part_site *site);

#endif
