/* Findings of check that are also reported elsewhere.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_CHECK_H
#define TIPSPEED_CMD_SHEETS_CHECK_H

#include "cmd/session/session.h"

/* Notes which run's product is coarser than its feed.  It changes no
 * numbers. */
void check_warn_coarser_product(struct session *s, const struct site *site);

#endif
