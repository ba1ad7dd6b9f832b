/* A product held against a grading envelope: spec, and find spec=.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_GRADING_H
#define TIPSPEED_CMD_GRADING_H

#include <stdbool.h>

#include "cmd/session.h"
#include "core/inverse.h"
#include "io/spec.h"

/* An envelope with a model of one feed on those of its sieves that the feed
 * tells: the first `n` of the spec. */
struct grading {
	struct spec *spec;
	size_t n;
	struct inverse inverse;
	struct envelope envelope;
};

/* Reads the file; feed: the run of the site in use whose feed to take.  Faults
 * of the file are told as session_load does. */
bool grading_open(struct session *s, const char *path, size_t feed,
    struct grading *grading, struct error *error);
void grading_close(struct grading *grading);

/* A row for each sieve: limits, passing at speed v and "ok", "above", "below"
 * or "not known". */
void grading_rows(struct answer *r, struct grading *grading, double v);

/* Where the limits are from, and which sieves are not judged. */
void grading_notes(struct answer *r, const struct grading *grading);

/* Puts spec, source and the columns of grading_rows into its JSON. */
void grading_put(struct answer *r, const struct spec *spec);

#endif
