/* Tables in plain text, as instruments print them and wikis keep them, with
 * columns aligned by spaces or separated by |.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_FIXED_WIDTH_H
#define TIPSPEED_IO_CELLS_FIXED_WIDTH_H

#include <stdbool.h>

/* Puts tabs between the cells of a text whose columns are aligned by spaces or
 * separated by |.  The tabs replace spaces or |, so that cells keep their
 * positions; an empty cell gets a tab too.  Lines that are only rules become
 * comments.  Returns false, and leaves the text unchanged, if it has no such
 * columns. */
bool fixed_width_convert_to_tabs(char *text);

#endif
