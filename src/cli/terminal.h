/* What the terminal is and can do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_TERMINAL_H
#define TIPSPEED_CLI_TERMINAL_H

#include <stdbool.h>

#include "cmd/session/session.h"

enum colour { COLOUR_AUTO, COLOUR_ALWAYS, COLOUR_NEVER };

/* Reads "auto", "always" or "never". */
bool terminal_colour_word(const char *word, enum colour *colour);

/* What --color said. */
void terminal_choose(enum colour asked);

/* Whether to use colour: as the first of --color, TIPSPEED_COLOR and NO_COLOR
 * says; else whether standard output is a terminal that has it. */
bool terminal_colour(void);

/* Standard input and output are terminals: somebody sits there. */
bool terminal_attended(void);

/* One that knows no escapes, or does not say what it is. */
bool terminal_is_dumb(void);

/* The locale's text is UTF-8; and the terminal has characters to draw with, of
 * braille and boxes. */
bool terminal_is_utf8(void);
bool terminal_draws(void);

/* Of standard error; 24 by 80 where it does not say. */
void terminal_size(int *rows, int *columns);

/* The terminal that standard output is; all zero where it is none. */
struct screen terminal_screen(void);

#endif
