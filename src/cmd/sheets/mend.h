/* Mends of the site in use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_MEND_H
#define TIPSPEED_CMD_SHEETS_MEND_H

#include "cmd/session/session.h"
#include "core/check/outliers.h"

/* What is wrong with an entry's sheet: by the posterior of its own calibration
 * where there is one, else by its curves alone; doctor_free. */
struct doctor mend_look(const struct session *s, const struct entry *entry);

/* Whether doctor told of cells by a calibration. */
bool mend_is_calibrated(const struct session *s, const struct entry *entry);

/* Puts the mends into an answer, numbered: as sentences, and as a list "mends"
 * among its fields; and what they are known again by. */
void mend_put(
    struct answer *r, const struct entry *entry, const struct doctor *d);

/* A finding as a sentence, of a cell what check says of it; and the call that
 * takes its mend in any session, "mend product@79 sieve=2 value=61.9".  The
 * caller frees. */
char *mend_finding(const struct site *site, const struct finding *finding);
char *mend_call(const struct site *site, const struct mend *mend);

#endif
