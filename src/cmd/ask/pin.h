/* A prediction kept beside the one shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_PIN_H
#define TIPSPEED_CMD_ASK_PIN_H

#include "cmd/session/session.h"

/* site, key: the site of the prediction, which may no longer be loaded, or have
 * another key. */
struct pin {
	const struct site *site;
	char *key;
	struct prediction p;
};

void pin_free(struct pin *pin);

#endif
