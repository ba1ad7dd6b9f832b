/* Queries the terminal: its size, colours and characters, and whether a user is
 * there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/terminal.h"

#include <langinfo.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"

static enum colour chosen = COLOUR_AUTO;

bool
terminal_parse_colour_mode(const char *word, enum colour *colour)
{
	size_t i;
	bool known = text_find_word_in_list("auto always never", word, &i);
	if (known)
		*colour = (enum colour)i;
	return known;
}

bool
terminal_is_dumb(void)
{
	const char *term = getenv("TERM");
	return term == NULL || term[0] == '\0' || strcmp(term, "dumb") == 0;
}

void
terminal_set_colour_mode(enum colour asked)
{
	chosen = asked;
}

bool
terminal_has_colour(void)
{
	const char *own = getenv("TIPSPEED_COLOR"), *no = getenv("NO_COLOR");
	enum colour asked = chosen;
	if (asked == COLOUR_AUTO && own != NULL)
		terminal_parse_colour_mode(own, &asked);
	if (asked != COLOUR_AUTO)
		return asked == COLOUR_ALWAYS;
	if (no != NULL && no[0] != '\0')
		return false;
	return isatty(STDOUT_FILENO) && !terminal_is_dumb();
}

bool
terminal_is_interactive(void)
{
	return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
}

void
terminal_size(int *rows, int *columns)
{
	struct winsize size = {0};
	bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ||
		     ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0;
	*rows = known && size.ws_row > 0 ? size.ws_row : 24;
	*columns = known && size.ws_col > 0 ? size.ws_col : 80;
}

static int
terminal_colour_count(const char *term)
{
	const char *more = getenv("COLORTERM");
	bool many = more != NULL && (strcmp(more, "truecolor") == 0 ||
					strcmp(more, "24bit") == 0);
	return many || strstr(term, "256color") != NULL ? 256
	       : strstr(term, "16color") != NULL        ? 16
							: 8;
}

bool
terminal_is_utf8(void)
{
	return strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

/* The Linux console has fonts of at most 512 characters, without braille or
 * quadrants; a serial terminal has only ASCII. */
bool
terminal_has_line_drawing(void)
{
	static const char *const PLAIN[] = {"linux", "vt", "ansi", "cons"};
	if (terminal_is_dumb())
		return false;
	for (size_t i = 0; i < ARRAY_LEN(PLAIN); i++)
		if (strncmp(getenv("TERM"), PLAIN[i], strlen(PLAIN[i])) == 0)
			return false;
	return terminal_is_utf8();
}

struct screen
terminal_get_size_and_colours(void)
{
	struct screen screen = {0};
	const char *term = getenv("TERM");
	if (!isatty(STDOUT_FILENO))
		return screen;
	terminal_size(&screen.rows, &screen.columns);
	screen.colours = terminal_has_colour() && term != NULL
			     ? terminal_colour_count(term)
			     : 0;
	screen.drawing = terminal_has_line_drawing();
	return screen;
}
