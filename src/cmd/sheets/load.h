/* Loads the sheets of a site from one or several files, and asks the user what
 * they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_LOAD_H
#define TIPSPEED_CMD_SHEETS_LOAD_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* Loads files, each "FILE" or "FILE@SPEED", and says so.  They are one site if
 * a speed is given or none of them is complete, otherwise a site each.  args:
 * the call of load with its options, or NULL. */
bool load_files(struct session *s, size_t n, const char *const *word,
    const struct args *args, struct error *error);

/* Reads the files of a call, word [n_operand], each "FILE" or "FILE@SPEED", as
 * samples to add to a site.  Adds the user's answers to the line in the
 * journal.  rotor: diameter, m, if the call gives none.  On failure, returns
 * NULL with an error. */
struct site *load_cuts(struct session *s, const struct args *args,
    const char *const *word, double rotor, struct error *error);

/* Reads a sheet for a feed to use in questions, and sets *run to the run with
 * the feed.  word: "FILE" or "FILE@SPEED", where the speed selects one of
 * several feeds.  The caller frees the site.  On failure, returns NULL with an
 * error. */
struct site *load_feed(
    struct session *s, const char *word, size_t *run, struct error *error);

/* Notes how a site's files were read, as load does. */
void load_print_how_site_was_read(
    const struct session *s, const struct site *site);

#endif
