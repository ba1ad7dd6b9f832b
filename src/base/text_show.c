/* Text as a terminal shows it: made safe, measured and wrapped.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* wcwidth */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

#include "base/text.h"
#include "base/xalloc.h"

int
text_columns(uint32_t code)
{
	int columns = code < 0x80 ? 1 : wcwidth((wchar_t)code);
	return columns < 0 ? 1 : columns;
}

int
text_show(const char **text, char shown[static TEXT_SHOWN])
{
	const char *from = *text;
	uint32_t code = text_next(text);
	int n = (int)(*text - from);
	if (n == 1 && (code >= 0x80 || text_is_hidden(code)))
		return snprintf(shown, TEXT_SHOWN, "\\x%02x",
		    (unsigned)(unsigned char)*from);
	if (text_is_hidden(code))
		return snprintf(shown, TEXT_SHOWN,
		    code > 0xFFFF ? "\\U%08x" : "\\u%04x", (unsigned)code);
	memcpy(shown, from, (size_t)n);
	shown[n] = '\0';
	return text_columns(code);
}

char *
text_shown(const char *s)
{
	/* No byte takes more than the four of \x1b. */
	char *whole = xcalloc(4 * strlen(s) + 1, 1), *end = whole;
	char shown[TEXT_SHOWN];
	while (*s != '\0') {
		text_show(&s, shown);
		end = stpcpy(end, shown);
	}
	return whole;
}

void
text_put(const char *s, FILE *out)
{
	char shown[TEXT_SHOWN];
	while (*s != '\0') {
		text_show(&s, shown);
		fputs(shown, out);
	}
}

int
text_width(const char *s)
{
	int width = 0;
	char shown[TEXT_SHOWN];
	while (*s != '\0')
		width += text_show(&s, shown);
	return width;
}

bool
text_is_plain(const char *s)
{
	char *shown = text_shown(s);
	bool plain = strcmp(shown, s) == 0;
	free(shown);
	return plain;
}

void
text_hang(const char *text, int first, int margin, int width, FILE *out)
{
	int column = 0;
	char *copy = text_shown(text), *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save)) {
		int wide = text_width(word);
		if (column > 0 && column + 1 + wide > width) {
			fputc('\n', out);
			column = 0;
			first = margin;
		}
		if (column == 0)
			column = fprintf(out, "%*s", first, "");
		else
			column += fprintf(out, " ");
		fputs(word, out);
		column += wide;
	}
	fputc('\n', out);
	free(copy);
}

void
text_wrap(const char *text, int margin, int width, FILE *out)
{
	margin += (int)strspn(text, " ");
	text_hang(text, margin, margin, width, out);
}

char *
text_wrapped(const char *text, int width)
{
	char *lines = NULL;
	size_t n = 0;
	FILE *out = text_memory(&lines, &n);
	text_wrap(text, 0, width, out);
	fclose(out);
	return lines;
}
