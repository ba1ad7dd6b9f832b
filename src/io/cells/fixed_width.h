/* Tables in plain text, as instruments print them and wikis keep them: columns
 * that blanks align, or that | separates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_FIXED_WIDTH_H
#define TIPSPEED_IO_CELLS_FIXED_WIDTH_H

#include <stdbool.h>

/* Puts tabs between the cells of a text whose columns are aligned by blanks or
 * separated by |, in place of these, so that cells keep their positions; an
 * empty cell has a tab of its own.  Lines that only rule off others become
 * comments.  Returns false, and leaves the text, if it has no such columns. */
bool fixed_width_put_tabs(char *text);

#endif
