/* Feeds from other sheets: a single one, or several mixed by mass.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_BLENDED_H
#define TIPSPEED_CMD_ASK_BLENDED_H

#include "cmd/session/session.h"

/* One feed: file, sheet, feed and part. */
struct blend_part {
	char *file;
	struct site *sheet;
	const struct psd *feed;
	double share;
};

/* All n parts and their mixture.  text: as typed; words: "60 % a.csv + 40 %
 * b.csv"; of: the provenance in the sheets; rock: "Granite and Gneiss", or
 * "". */
struct blended {
	size_t n;
	struct blend_part *part;
	double sum;
	struct psd feed;
	char *text, *words, *of, *rock;
};

/* Adds the feed that load_feed reads from FILE or FILE@SPEED. */
bool blended_add_feed(struct session *s, const char *file, double share,
    struct blended *b, struct error *error);

/* Mixes the parts, whose shares may have any sum. */
void blended_mix_feeds(struct blended *b);

/* Reads FILE, or a blend "a.csv*0.6+b.csv*0.4" with shares that sum to 1.  On
 * failure, returns NULL with an error.  Free with blended_free. */
struct blended *blended_read_feeds(
    struct session *s, const char *text, struct error *error);
void blended_free(struct blended *b);
void blended_clear(struct blended *b);

/* Returns the source of the feed, for programs; borrowed. */
const char *blended_source_text(const struct blended *b);

/* As blended_read_feeds, for the feed of `set feed`, which the session owns. On
 * failure, returns NULL with an error. */
const struct blended *blended_read_feed_setting(
    struct session *s, const char *text, struct error *error);

#endif
