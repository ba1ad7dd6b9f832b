/* A prediction pinned for comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_PIN_H
#define TIPSPEED_CMD_ASK_PIN_H

#include "cmd/session/session.h"

/* site, key: those of the prediction; the site may no longer be loaded or may
 * now have another key. */
struct pin {
	const struct site *site;
	char *key;
	struct prediction p;
};

void pin_free(struct pin *pin);

#endif
