/* The answer of runs compared.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_COMPARISON_ANSWER_H
#define TIPSPEED_CMD_FIT_COMPARISON_ANSWER_H

#include "cmd/fit/comparison.h"

/* Fields, tables, and who predicts best, of runs of this site. */
struct answer *comparison_answer(
    const struct comparison *c, const struct site *site);

#endif
