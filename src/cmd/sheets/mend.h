/* Mends of the site in use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_MEND_H
#define TIPSPEED_CMD_SHEETS_MEND_H

#include "cmd/session/session.h"
#include "core/check/outliers.h"

/* Looks for faults of an entry's sheet: with the posterior of its own
 * calibration if there is one, else with its curves alone; free with
 * outliers_free. */
struct doctor mend_look(const struct session *s, const struct entry *entry);

/* True if the entry's faults are found with a calibration. */
bool mend_is_calibrated(const struct session *s, const struct entry *entry);

/* Puts the mends into an answer, numbered: as sentences, and as a list "mends"
 * among its fields, with a mark to recognise them by. */
void mend_put(
    struct answer *r, const struct entry *entry, const struct doctor *d);

/* mend_finding_words returns a finding as a sentence, for a cell the sentence
 * of check; mend_command_line the call that applies its mend in any session,
 * "mend product@79 sieve=2 value=61.9".  The caller frees. */
char *mend_finding_words(
    const struct site *site, const struct finding *finding);
char *mend_command_line(const struct site *site, const struct mend *mend);

#endif
