/* The pages of the full screen, in the order in which the heading names them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SCREEN_PAGES_H
#define TIPSPEED_CMD_SESSION_SCREEN_PAGES_H

#include "base/tr.h"

/* A row is a page: PAGE_FIT is its number, page_fit its operations, defined in
 * tui/pages/page_fit.c, and fit its name as a value of `set page`; its name in
 * the heading and its key follow.  Digits after 5 begin speeds, so that the key
 * of a further page is a letter which has no row in tui/keys.c. */
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
