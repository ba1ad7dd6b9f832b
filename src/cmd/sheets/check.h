/* A finding of check that is also reported elsewhere.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_CHECK_H
#define TIPSPEED_CMD_SHEETS_CHECK_H

#include "cmd/session/session.h"

/* Notes the runs whose product is coarser than their feed.  Changes no
 * numbers. */
void check_warn_coarser_product(struct session *s, const struct site *site);

#endif
