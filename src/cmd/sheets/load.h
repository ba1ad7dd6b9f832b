/* Sheets in: of one site in one file or several, with what is asked about
 * them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_LOAD_H
#define TIPSPEED_CMD_SHEETS_LOAD_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* Loads files, each "FILE" or "FILE@SPEED", and says so beside the results: as
 * one site where a speed is given or none of them is complete, else a site
 * each. */
bool load_files(
    struct session *s, size_t n, const char *const *word, struct error *error);

/* Reads the operands of a call, each as word [n_operand] "FILE" or
 * "FILE@SPEED", as samples to be added to a site; what was answered on the way
 * is saved with the call.  rotor: diameter where the call tells none, m.  NULL:
 * with the error. */
struct site *load_parts(struct session *s, const struct args *args,
    const char *const *word, double rotor, struct error *error);

/* Reads a sheet whose feed answers are asked with, as word "FILE" or
 * "FILE@SPEED", which says which of several, and finds the run that has it.
 * The caller frees the site.  NULL: with the error. */
struct site *load_feed(
    struct session *s, const char *word, size_t *run, struct error *error);

/* Says what a site was read from, as load does. */
void load_note_reading(const struct session *s, const struct site *site);

#endif
