/* Feeds from other sheets: a single one, or several mixed by mass.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_BLENDED_H
#define TIPSPEED_CMD_ASK_BLENDED_H

#include "cmd/session/session.h"

/* One part of a blend.  share: of the mass. */
struct blend_part {
	char *file;
	struct site *sheet;
	const struct psd *feed;
	double share;
};

/* A feed that is mixed from parts. */
struct blended {
	size_t n;
	struct blend_part *part;
	/* The sum of the shares. */
	double sum;
	struct psd feed;
	/* text: as typed.  words: "60 % a.csv + 40 % b.csv".  of: the
	 * provenance that the sheets state.  rock: "Granite and Gneiss",
	 * or "". */
	char *text, *words, *of, *rock;
};

/* Adds the feed in FILE or FILE@SPEED, which load_feed reads, as a part. */
bool blended_add_feed(struct session *s, const char *file, double share,
    struct blended *b, struct error *error);

/* Mixes the parts, whose shares may have any sum. */
void blended_mix_feeds(struct blended *b);

/* Reads the feed in FILE, or a blend "a.csv*0.6+b.csv*0.4" whose shares sum to
 * 1.  Returns NULL with an error on failure.  Free with blended_free. */
struct blended *blended_read_feeds(
    struct session *s, const char *text, struct error *error);
void blended_free(struct blended *b);

/* Returns where the feed is from, for programs.  The blend owns the text. */
const char *blended_source_text(const struct blended *b);

/* As blended_read_feeds, for the feed in `set feed`.  The session owns the
 * result. */
const struct blended *blended_read_feed_setting(
    struct session *s, const char *text, struct error *error);

#endif
