/* The terminal and its abilities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_TERMINAL_H
#define TIPSPEED_CLI_TERMINAL_H

#include <stdbool.h>

#include "cmd/session/session.h"

enum colour { COLOUR_AUTO, COLOUR_ALWAYS, COLOUR_NEVER };

/* Parses "auto", "always" or "never". */
bool terminal_parse_colour_mode(const char *word, enum colour *colour);

/* Sets the value of --color. */
void terminal_set_colour_mode(enum colour asked);

/* True if colour is to be used.  The first of --color, TIPSPEED_COLOR and
 * NO_COLOR that is set decides; if none is, standard output must be a terminal
 * with colour. */
bool terminal_has_colour(void);

/* True if standard input and output are terminals, so that there is a user. */
bool terminal_is_interactive(void);

/* True if the terminal has no escape sequences or no known type. */
bool terminal_is_dumb(void);

/* terminal_is_utf8 returns true if the locale uses UTF-8;
 * terminal_has_line_drawing returns true if the terminal has braille and
 * box-drawing characters. */
bool terminal_is_utf8(void);
bool terminal_has_line_drawing(void);

/* Returns the size of the terminal on standard error or else on standard
 * output; 24 by 80 if it is unknown. */
void terminal_size(int *rows, int *columns);

/* Describes the terminal on standard output; all zeros if it is not a
 * terminal. */
struct screen terminal_get_size_and_colours(void);

#endif
