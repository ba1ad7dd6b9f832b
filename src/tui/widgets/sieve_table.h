/* A table of the product at the slider's speed, sieve by sieve, with its
 * difference from the product it is compared with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H
#define TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H

#include "tui/tui_state.h"

/* Returns the number of rows for all sieves and the heading. */
int sieve_table_count_rows(const struct tui *t);

/* Draws the table.  In fewer rows, it shows sieves spread evenly from the
 * coarsest to the finest. */
void sieve_table_draw(struct tui *t, const struct area *area);

#endif
