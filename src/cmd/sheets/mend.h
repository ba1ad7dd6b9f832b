/* Mends of the current site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_MEND_H
#define TIPSPEED_CMD_SHEETS_MEND_H

#include "cmd/session/session.h"
#include "core/check/outliers.h"

/* Looks for faults in an entry's sheet, with the posterior of its own
 * calibration if there is one, or else with its curves alone.  Free with
 * outliers_free. */
struct outlier_findings mend_find_faults(
    const struct session *s, const struct entry *entry);

/* True if there is a calibration with which to find the entry's faults. */
bool mend_can_use_calibration(
    const struct session *s, const struct entry *entry);

/* Adds the mends to an answer, numbered, as sentences and as the list "mends"
 * in its fields, each with a mark that identifies it. */
void mend_put_numbered_list(struct answer *r, const struct entry *entry,
    const struct outlier_findings *d);

/* mend_finding_text returns a finding as a sentence, which for a cell is that
 * of check; mend_command_line returns the call that applies its mend in any
 * session, "mend product@79 sieve=2 value=61.9".  The caller frees it. */
char *mend_finding_text(const struct site *site, const struct finding *finding);
char *mend_command_line(const struct site *site, const struct mend *mend);

#endif
