/* Unquoted conditions and quantities in a line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CONDITION_WORDS_H
#define TIPSPEED_CMD_ASK_CONDITION_WORDS_H

#include "cmd/lang/parse.h"

/* Makes one word of each condition if the command takes conditions: "window P80
 * < 8.5 passing 2 = 30..38" has two.  A condition ends before an option, before
 * a word that contains spaces because it was quoted, and, once it has its
 * limit, before the next word that is a quantity.  If the command takes
 * quantities, "predict 70 passing 2 P80" becomes "predict 70 of='passing
 * 2,P80'". */
void conditions_join_words(struct words *words);

#endif
