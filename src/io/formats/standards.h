/* The grading envelopes that come with the program, and the limits of the same
 * standards that are not on a passing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_STANDARDS_H
#define TIPSPEED_IO_FORMATS_STANDARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "io/formats/spec.h"

/* A limit as printed; least, most: NAN where there is none; unit: "-" of a
 * number without.  note: "" or what the standard says of it. */
struct standard_limit {
	char *standard, *item, *unit, *note;
	double least, most;
};

/* In the order of their files, data/envelopes.csv and
 * data/envelope-scalars.csv, as these were when the program was built. */
struct standards {
	size_t n, n_limit;
	struct spec **spec;
	struct standard_limit *limit;
};

struct standards *standards_shipped(void);
void standards_free(struct standards *standards);

/* Marks in match [n] the envelopes that are meant by these words: of those that
 * have each word, or one that begins so, without case, the ones that have them
 * in full; of several of which one has the name that all begin with, that, if
 * the words have all of its own name or a number.
 * Returns how many. */
size_t standards_match(
    const struct standards *standards, const char *words, bool *match);

/* The one that is meant, or NULL with an error that has the candidates. */
const struct spec *standards_find(
    const struct standards *standards, const char *words, struct error *error);

/* Whether a word is a path rather than the name of an envelope: there is such a
 * file, or it begins or ends as the name of one does. */
bool standards_is_path(const char *word);

#endif
