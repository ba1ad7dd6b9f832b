/* Allocation that cannot fail from the caller's point of view.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/xalloc.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void
xalloc_fail(void)
{
	static const char say[] = "tipspeed: out of memory\n";
	ssize_t written = write(STDERR_FILENO, say, sizeof say - 1);
	(void)written;
	exit(XALLOC_STATUS);
}

void *
xcalloc(size_t n, size_t size)
{
	void *p = calloc(n > 0 ? n : 1, size > 0 ? size : 1);
	if (p == NULL)
		xalloc_fail();
	return p;
}

void *
xrealloc(void *p, size_t n, size_t size)
{
	if (size > 0 && n > SIZE_MAX / size)
		xalloc_fail();
	void *q = realloc(p, n * size > 0 ? n * size : 1);
	if (q == NULL)
		xalloc_fail();
	return q;
}

void *
xgrow_by_one(void *p, size_t n, size_t size)
{
	return (n & (n - 1)) == 0 ? xrealloc(p, n > 0 ? 2 * n : 1, size) : p;
}

/* The pointer may be of any type, so memcpy is used. */
void
xfree_at(void *pointer)
{
	void *held;
	memcpy(&held, pointer, sizeof held);
	free(held);
}

char *
xstrndup(const char *s, size_t n)
{
	char *copy = xcalloc(n + 1, 1);
	memcpy(copy, s, n);
	return copy;
}

char *
xstrdup(const char *s)
{
	return xstrndup(s, strlen(s));
}

char *
xvasprintf(const char *format, va_list ap)
{
	char text[256]; /* long enough for most, which are then formatted only
			 * once */
	va_list again;
	va_copy(again, ap);
	int length = vsnprintf(text, sizeof text, format, again);
	va_end(again);
	size_t n = length < 0 ? 0 : (size_t)length;
	char *s = xcalloc(n + 1, 1);
	if (n < sizeof text)
		memcpy(s, text, n);
	else
		vsnprintf(s, n + 1, format, ap);
	return s;
}

char *
xasprintf(const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *s = xvasprintf(format, ap);
	va_end(ap);
	return s;
}

void
xfree_and_set(char **text, char *value)
{
	free(*text);
	*text = value;
}

/* Takes ownership of more. */
static void
append_after_separator(char **text, const char *separator, char *more)
{
	size_t n = strlen(*text), gap = strlen(separator), m = strlen(more);
	*text = xrealloc(*text, n + gap + m + 1, 1);
	memcpy(*text + n, separator, gap);
	memcpy(*text + n + gap, more, m + 1);
	free(more);
}

void
xappend(char **text, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	append_after_separator(text, "", xvasprintf(format, ap));
	va_end(ap);
}

void
xappend_to_list(char **list, const char *separator, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	append_after_separator(
	    list, *list[0] != '\0' ? separator : "", xvasprintf(format, ap));
	va_end(ap);
}

void
xend_list_with(char **list, const char *word)
{
	char *last = strrchr(*list, ',');
	if (last == NULL)
		return;
	*last = '\0';
	xfree_and_set(list, xasprintf("%s%s%s", *list, word, last + 2));
}

double *
xcalloc_doubles(size_t n)
{
	enum { LINE = 64 };
	if (n > SIZE_MAX / sizeof(double) - LINE)
		xalloc_fail();
	size_t bytes = (n * sizeof(double) + LINE) / LINE * LINE;
	void *p = aligned_alloc(LINE, bytes);
	if (p == NULL)
		xalloc_fail();
	memset(p, 0, bytes);
	return p;
}
