/* Reads questions from calls.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_QUESTION_H
#define TIPSPEED_CMD_ASK_QUESTION_H

#include "cmd/ask/asked.h"
#include "cmd/ask/blended.h"
#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* Reads the question from the options of SHARED_... (table_shared.c) that the
 * command has.  No other function chooses a feed or a machine for a command.
 * Always free with question_free. */
bool question_from_args(struct session *s, const struct entry *loaded,
    const struct args *args, struct question *q, struct error *error);

/* As question_from_args, but for another loaded site, and without reading the
 * files of `like` again. */
bool question_repeat_for_site(struct session *s, const struct entry *loaded,
    const struct args *args, const struct question *like, struct question *q,
    struct error *error);

/* Reads the question of a call, passes it to `answer`, and frees it. */
bool question_read_and_answer(struct session *s, const struct args *args,
    command_answer *answer, struct error *error);

/* Makes the question about a loaded site with the changes of the scenario and,
 * unless they include a feed, with the mean of the site's feeds. */
void question_set_from_scenario(const struct session *s,
    const struct entry *loaded, const struct scenario *scenario,
    struct question *q);

/* Returns the current site as a question without options sees it: with the feed
 * in `set feed`, if that can be read.  NULL if no site is loaded.  Valid until
 * the session changes.  question_free_cached_site frees it. */
const struct entry *question_site_with_feed_setting(struct session *s);
void question_free_cached_site(struct session *s);

/* If the call names no speeds, sets the question to the usual ones, 65 to 85
 * m/s, extended or moved to cover the runs: steps of 1 m/s and the speed last
 * asked about if `each` is true, otherwise at most seven. */
void question_use_default_speeds(
    const struct session *s, struct question *q, bool each);

/* If the speeds of the call have equal steps, as those of a range have, adds
 * the measured speeds between the first and the last. */
void question_add_measured_speeds_to_range(struct question *q);

/* Returns the speed last asked about, by a command or on the screen, or `usual`
 * if there is none.  It is saved with the call. */
double question_last_speed_or_usual(struct session *s, double usual);

/* If the call names no speed, sets the question to
 * question_last_speed_or_usual. */
void question_use_last_speed(struct session *s, struct question *q);

/* As question_use_last_speed, without saving the speed; also sets the feed of
 * the last prediction for the current site, if there is one. */
void question_use_last_speed_and_feed(
    const struct session *s, const struct args *args, struct question *q);

void question_free(struct session *s, struct question *q);

/* Returns the feed of the question. */
const struct psd *question_feed(const struct question *q);

#endif
