/* The pages of the full screen, in the order in which the heading names them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SCREEN_PAGES_H
#define TIPSPEED_CMD_SESSION_SCREEN_PAGES_H

#include "base/tr.h"

/* Each row is a page: FIT as in PAGE_FIT; fit as in `set page fit` and
 * page_fit, its operations in tui/pages/page_fit.c; its name in the heading;
 * and its key.  Digits above 5 begin a speed, so the key of a further page must
 * be a letter without a row in tui/keys.c. */
#define SCREEN_PAGES(PAGE)                         \
	PAGE(PREDICT, predict, N_("Predict"), '1') \
	PAGE(FIT, fit, N_("Fit"), '2')             \
	PAGE(DATA, data, N_("Data"), '3')          \
	PAGE(PARITY, parity, N_("Parity"), '4')    \
	PAGE(SITES, sites, N_("Sites"), '5')

/* The values of `set page`, separated by spaces. */
#define SCREEN_PAGE_WORD(NUMBER, name, heading, key) " " #name
#define SCREEN_PAGE_WORDS (SCREEN_PAGES(SCREEN_PAGE_WORD) + 1)

#endif
