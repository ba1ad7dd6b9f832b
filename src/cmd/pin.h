/* A prediction that is kept beside the one shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PIN_H
#define TIPSPEED_CMD_PIN_H

#include "cmd/session.h"

/* key: of its site, which may no longer be loaded. */
struct pin {
	char *key;
	struct prediction p;
};

void pin_free(struct pin *pin);

#endif
