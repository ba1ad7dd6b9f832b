/* Feeds of other sheets, one or several mixed by mass.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_BLENDED_H
#define TIPSPEED_CMD_ASK_BLENDED_H

#include "cmd/session/session.h"

/* One feed: its file, the sheet, its feed, and its part. */
struct blend_part {
	char *file;
	struct site *sheet;
	const struct psd *feed;
	double share;
};

/* All n parts, and their mixture.  text: as they were named; words: "60 % a.csv
 * + 40 % b.csv"; of: what the sheets say of their data; rock: "Granite and
 * Gneiss", or "". */
struct blended {
	size_t n;
	struct blend_part *part;
	double sum;
	struct psd feed;
	char *text, *words, *of, *rock;
};

/* Adds the feed that load_feed reads of FILE or FILE@SPEED. */
bool blended_add(struct session *s, const char *file, double share,
    struct blended *b, struct error *error);

/* Mixes the parts, whose shares may have any sum. */
void blended_mix(struct blended *b);

/* Reads FILE, or a blend "a.csv*0.6+b.csv*0.4" with shares that sum to 1; on
 * failure returns false with an error.  Free with blended_clear even then. */
bool blended_read(struct session *s, const char *text, struct blended *b,
    struct error *error);
void blended_clear(struct blended *b);

/* Returns the source of the feed, for programs; borrowed. */
const char *blended_from(const struct blended *b);

/* As blended_read, for the feed that is set; the session owns it.  NULL with an
 * error. */
const struct blended *blended_read_cached(
    struct session *s, const char *text, struct error *error);
void blended_free(struct blended *b);

#endif
