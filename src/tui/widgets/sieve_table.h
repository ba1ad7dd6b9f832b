/* The product at the slider's speed sieve by sieve, beside what it is compared
 * with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H
#define TIPSPEED_TUI_WIDGETS_SIEVE_TABLE_H

#include "tui/tui_state.h"

/* Rows of all its sieves, with the heading. */
int sieve_table_rows(const struct tui *t);

/* In fewer rows it has sieves from the coarsest to the finest, evenly. */
void sieve_table_draw(struct tui *t, const struct area *area);

#endif
