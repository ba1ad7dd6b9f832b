/* Mends: corrections of the data of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_MEND_H
#define TIPSPEED_CMD_SHEETS_MEND_H

#include "cmd/session/session.h"
#include "core/check/outliers.h"

/* Looks for faults in an entry's sheet, with the draws of its own calibration
 * if there are any, or else by its curves alone.  Free with outliers_free. */
struct outlier_findings mend_find_faults(
    const struct session *s, const struct entry *entry);

/* True if mend_find_faults uses a calibration for the entry. */
bool mend_can_use_calibration(
    const struct session *s, const struct entry *entry);

/* Adds the mends to an answer, numbered, as sentences and as the list "mends"
 * in its fields, with a mark that identifies the list. */
void mend_add_numbered_list(struct answer *r, const struct entry *entry,
    const struct outlier_findings *d);

/* mend_finding_text returns a finding as a sentence, as check shows it.
 * mend_to_command_text returns the line that applies a mend in any session,
 * "mend product@79 sieve=2 value=61.9".  The caller frees them. */
char *mend_finding_text(const struct site *site, const struct finding *finding);
char *mend_to_command_text(const struct site *site, const struct mend *mend);

#endif
