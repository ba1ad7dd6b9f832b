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

/* Marks in match [n] the envelopes that the words name, and returns how many.
 * A name matches that has each word, or one that begins with it, ignoring case;
 * names that have the words in full come before others; of several, the one
 * whose name the others begin with is chosen, if the words have all of its own
 * name or a number. */
size_t standards_match(
    const struct standards *standards, const char *words, bool *match);

/* The one that is meant, or NULL with an error that has the candidates. */
const struct spec *standards_find(
    const struct standards *standards, const char *words, struct error *error);

/* Whether a word is a path rather than the name of an envelope: there is such a
 * file, or it begins or ends as the name of one does. */
bool standards_is_path(const char *word);

#endif
