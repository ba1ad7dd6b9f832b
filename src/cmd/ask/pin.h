/* A prediction pinned for comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_PIN_H
#define TIPSPEED_CMD_ASK_PIN_H

#include "cmd/session/session.h"

/* A pinned prediction, with the site that it is for and its key.  The site may
 * have been unloaded since, or have another key. */
struct pin {
	const struct site *site;
	char *key;
	struct prediction p;
};

void pin_free(struct pin *pin);

#endif
