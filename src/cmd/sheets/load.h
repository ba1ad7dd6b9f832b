/* Loads sheets: of one site in one file or several, with the questions about
 * them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_LOAD_H
#define TIPSPEED_CMD_SHEETS_LOAD_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* Loads files, each "FILE" or "FILE@SPEED", and says so beside the results.
 * They are one site if a speed is given or none of the files is complete, else
 * a site each. */
bool load_files(
    struct session *s, size_t n, const char *const *word, struct error *error);

/* Reads the operands of a call, each as word [n_operand] "FILE" or
 * "FILE@SPEED", as samples to be added to a site; the answers given are saved
 * with the call.  rotor: diameter if the call gives none, m.  NULL with the
 * error. */
struct site *load_parts(struct session *s, const struct args *args,
    const char *const *word, double rotor, struct error *error);

/* Reads a sheet with a feed to answer questions with: word is "FILE" or
 * "FILE@SPEED", the speed to choose one of several feeds.  run: the run that
 * has the feed.  The caller frees the site.  NULL with the error. */
struct site *load_feed(
    struct session *s, const char *word, size_t *run, struct error *error);

/* Says from which files a site was read, as load does. */
void load_note_reading(const struct session *s, const struct site *site);

#endif
