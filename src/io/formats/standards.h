/* The grading envelopes that come with the program, and the limits of the same
 * standards that are not on a passing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_STANDARDS_H
#define TIPSPEED_IO_FORMATS_STANDARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "io/formats/spec.h"

/* A limit as printed.  least, most: NAN if there is none; unit: "-" for a
 * number without a unit.  note: "", or the standard's own remark. */
struct standard_limit {
	char *standard, *item, *unit, *note;
	double least, most;
};

/* The envelopes and limits in the order of their files, data/envelopes.csv and
 * data/envelope-scalars.csv, as these were when the program was built. */
struct standards {
	size_t n, n_limit;
	struct spec **spec;
	struct standard_limit *limit;
};

struct standards *standards_shipped(void);
void standards_free(struct standards *standards);

/* Marks in match [n] the envelopes that the words name, and returns how many.
 * A name matches if for each of the words it contains that word, or one that
 * begins with it, ignoring case.  If some names contain all the words in full,
 * only those match.  If several match, the one that the others begin with is
 * chosen, provided the words contain all of its name or a number. */
size_t standards_match(
    const struct standards *standards, const char *words, bool *match);

/* Returns the envelope that the words mean, or NULL with an error that lists
 * the candidates. */
const struct spec *standards_find(
    const struct standards *standards, const char *words, struct error *error);

/* True if a word is a path rather than the name of an envelope: such a file
 * exists, or the word begins or ends as a file name does. */
bool standards_is_path(const char *word);

#endif
