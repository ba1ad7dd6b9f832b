/* The ledger of mass from one speed to another, as why shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_LEDGER_H
#define TIPSPEED_CMD_ANSWERS_LEDGER_H

#include "cmd/ask/question.h"
#include "cmd/session/session.h"

/* Answers `why 69 79`: the second speed is the operand. */
bool balance_answer(struct session *s, const struct args *args,
    const struct question *q, struct error *error);

#endif
