/* The product at the slider's speed, sieve by sieve, beside the one it is
 * compared with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H
#define TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H

#include "tui/tui_state.h"

/* Returns the rows that all sieves need, with the heading. */
int sieve_table_rows(const struct tui *t);

/* Draws the table; in fewer rows, with sieves spread evenly from the coarsest
 * to the finest. */
void sieve_table_draw(struct tui *t, const struct area *area);

#endif
