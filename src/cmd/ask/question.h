/* Reads questions from calls.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_QUESTION_H
#define TIPSPEED_CMD_ASK_QUESTION_H

#include "cmd/ask/asked.h"
#include "cmd/ask/blended.h"
#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* Reads the options of SHARED_... (table_shared.c) that the command has.  No
 * other function chooses a feed or a machine for a command.  Always free with
 * question_free. */
bool question_from_args(struct session *s, const struct entry *loaded,
    const struct args *args, struct question *q, struct error *error);

/* As question_from_args, but repeats a question for another loaded
 * site without reading files again. */
bool question_repeat_for_site(struct session *s, const struct entry *loaded,
    const struct args *args, const struct question *like, struct question *q,
    struct error *error);

/* Reads the question of a call, lets the command answer it, and frees it. */
bool question_read_and_answer(struct session *s, const struct args *args,
    command_answer *answer, struct error *error);

/* Makes the question about a loaded site, with the mean of its feeds or the
 * changes of the scenario. */
void question_from_scenario(const struct session *s, const struct entry *loaded,
    const struct scenario *scenario, struct question *q);

/* Returns the current site as in a question without options, with the feed from
 * the sheet in `set feed`, if that can be read; NULL if no site is loaded.
 * Valid until the session changes.  question_free_cached frees it. */
const struct entry *question_site_with_feed_setting(struct session *s);
void question_free_cached(struct session *s);

/* If the call names no speeds, sets the question to the usual ones, 65 to 85
 * m/s, extended or moved to cover the runs: in steps of 1 m/s with the speed
 * last asked about if `each` is true, otherwise seven at most. */
void question_use_default_speeds(
    const struct session *s, struct question *q, bool each);

/* If the speeds of the call have equal steps, as those of a range have, adds
 * the measured ones between the first and the last. */
void question_add_measured_speeds_to_range(struct question *q);

/* Returns the speed last asked about by any command or on the screen, which it
 * saves with the call; if there is none, the usual one. */
double question_last_speed(struct session *s, double usual);

/* If the call names no speed, sets the question to that one. */
void question_use_last_speed(struct session *s, struct question *q);

/* The same without saving it, and the feed of the last prediction for the
 * current site, if any. */
void question_use_last_speed_and_feed(
    const struct session *s, const struct args *args, struct question *q);

void question_free(struct session *s, struct question *q);

/* Returns the feed of the question. */
const struct psd *question_feed(const struct question *q);

#endif
