/* The grading envelopes that come with the program, and other limits of the
 * same standards, which are not limits of passing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_STANDARDS_H
#define TIPSPEED_IO_FORMATS_STANDARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "io/formats/spec.h"

/* A limit as the standard prints it.  least, most: NAN if there is none; unit:
 * "-" for a dimensionless number.  note: the standard's own remark, or "". */
struct standard_limit {
	char *standard, *item, *unit, *note;
	double least, most;
};

/* The envelopes and limits in the order of data/envelopes.csv and
 * data/envelope-scalars.csv, which are built into the program. */
struct standards {
	size_t n, n_limit;
	struct spec **spec;
	struct standard_limit *limit;
};

struct standards *standards_read_built_in(void);
void standards_free(struct standards *standards);

/* Marks in match [n] the envelopes that the words name, and returns their
 * number.  A name matches if each of the words begins a word of it, ignoring
 * case.  If some names contain all the words in full, only those match.  If
 * several match, and one is the beginning of all others, only that one does,
 * provided the words contain a number or all of its name. */
size_t standards_mark_envelopes_named(
    const struct standards *standards, const char *words, bool *match);

/* Returns the envelope that the words name, or NULL with an error that lists
 * the candidates. */
const struct spec *standards_find_envelope(
    const struct standards *standards, const char *words, struct error *error);

/* True if a word is a path rather than the name of an envelope: the file
 * exists, or the word begins or ends like a path. */
bool standards_is_file_path(const char *word);

#endif
