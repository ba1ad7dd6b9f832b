/* The terminal and its abilities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_TERMINAL_H
#define TIPSPEED_CLI_TERMINAL_H

#include <stdbool.h>

#include "cmd/session/session.h"

enum colour { COLOUR_AUTO, COLOUR_ALWAYS, COLOUR_NEVER };

/* Reads "auto", "always" or "never". */
bool terminal_colour_word(const char *word, enum colour *colour);

/* Sets the value of --color. */
void terminal_set_colour(enum colour asked);

/* Whether to use colour, by the first of --color, TIPSPEED_COLOR and NO_COLOR
 * that decides; else whether standard output is a terminal with colour. */
bool terminal_has_colour(void);

/* Whether standard input and output are terminals, so that a user is there. */
bool terminal_is_interactive(void);

/* True if the terminal has no escape sequences, or no known type. */
bool terminal_is_dumb(void);

/* Whether the locale's text is UTF-8; whether the terminal has braille and
 * box-drawing characters. */
bool terminal_is_utf8(void);
bool terminal_can_draw(void);

/* The size of the terminal of standard error; 24 by 80 where it is not
 * known. */
void terminal_size(int *rows, int *columns);

/* Describes the terminal that standard output is; all zero where it is none. */
struct screen terminal_describe(void);

#endif
