/* Conditions and quantities that are typed without quotes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CONDITION_WORDS_H
#define TIPSPEED_CMD_ASK_CONDITION_WORDS_H

#include "cmd/lang/parse.h"

/* If the command takes conditions, joins the words of each into one: "window
 * P80 < 8.5 passing 2 = 30..38" has two.  A condition ends before an option,
 * before a word that was quoted because it contains spaces, and, once it has
 * its limit, before a word that is a quantity.  If the command takes
 * quantities, "predict 70 passing 2 P80" becomes "predict 70 of='passing
 * 2,P80'". */
void conditions_join_words(struct words *words);

#endif
