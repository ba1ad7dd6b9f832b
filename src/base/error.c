/* Errors are values.  Drivers decide where to show them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

_Static_assert((int)ERROR_SYSTEM == XALLOC_STATUS, "no memory is a status");

void
error_set_place(struct error *e, const char *file, int line, int column)
{
	snprintf(e->file, sizeof e->file, "%s", file);
	e->line = line;
	e->column = column;
	e->in_grid = false;
}

void
error_prefix_file_name(struct error *e, const char *file, int line, int column)
{
	if (e->file[0] != '\0') {
		FREED char *text = xasprintf("%s: %s", e->file, e->text);
		snprintf(e->text, sizeof e->text, "%s", text);
	}
	error_set_place(e, file, line, column);
}

/* Returns a copy of the format's first line, also kept in *copy.  Because of
 * the attribute, the compiler checks calls as if they had the whole format. */
__attribute__((format_arg(1))) static const char *
copy_first_line(const char *format, char **copy)
{
	return *copy = xstrndup(format, strcspn(format, "\n"));
}

bool
error_set_formatted(struct error *e, enum error_kind kind, const char *file,
    int line, int column, const char *format, va_list ap)
{
	if (e == NULL)
		return false;
	va_list again;
	va_copy(again, ap);
	format = tr(format);
	FREED char *first = NULL,
		   *text = xvasprintf(copy_first_line(format, &first), ap);
	FREED char *all = xvasprintf(format, again);
	const char *rest = all + strlen(text);
	va_end(again);
	e->kind = kind;
	error_set_place(e, file, line, column);
	snprintf(e->text, sizeof e->text, "%s", text);
	snprintf(e->hint, sizeof e->hint, "%s", *rest == '\n' ? rest + 1 : "");
	return false;
}

bool
error_set(struct error *e, enum error_kind kind, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	error_set_formatted(e, kind, "", 0, 0, format, ap);
	va_end(ap);
	return false;
}

bool
error_set_at(struct error *e, enum error_kind kind, const char *file, int line,
    int column, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	error_set_formatted(e, kind, file, line, column, format, ap);
	va_end(ap);
	return false;
}

bool
error_set_hint(struct error *e, const char *format, ...)
{
	if (e == NULL)
		return false;
	va_list ap;
	va_start(ap, format);
	vsnprintf(e->hint, sizeof e->hint, tr(format), ap);
	va_end(ap);
	return false;
}

struct error *
error_list_add_item(struct error_list *list)
{
	size_t room = sizeof list->item / sizeof list->item[0];
	if (list->n < room)
		return &list->item[list->n++];
	/* Overwritten by each further fault; only their number is kept. */
	static _Thread_local struct error beyond;
	list->more++;
	return &beyond;
}

bool
error_is_stop_requested(struct error_list *list)
{
	if (list->stopped || list->stop == NULL || !list->stop())
		return list->stopped;
	list->stopped = true;
	error_set(error_list_add_item(list), ERROR_STOPPED, "interrupted");
	return true;
}

/* Prints a line and frees it.  A line that fits is not wrapped, and keeps its
 * spaces, because it may quote user text. */
static void
print_and_free_error_line(char *line, bool wrap, int margin, FILE *out)
{
	enum { SCREEN = 79 };
	if (!wrap || text_width_in_columns(line) <= SCREEN) {
		text_print_escaped(line, out);
		fputc('\n', out);
	} else {
		int blanks = (int)strspn(line, " ");
		fprintf(out, "%*s", blanks, "");
		text_print_hanging(line, blanks, margin, SCREEN, out);
	}
	free(line);
}

/* Writes the position that follows a file's name, "14:9:" or " B5:", if it is
 * known. */
static void
error_place_text(const struct error *e, char place[static 32])
{
	char letters[8];
	if (e->line > 0 && e->in_grid)
		snprintf(place, 32,
		    " %s%d:", text_column_letters(e->column, letters), e->line);
	else if (e->line > 0)
		snprintf(place, 32, "%d:%d:", e->line, e->column);
}

void
error_print(const struct error *e, FILE *out)
{
	char place[32] = "";
	if (strcmp(e->file, ERROR_TYPED) == 0) {
		print_and_free_error_line(
		    xstrdup(e->text), isatty(fileno(out)) != 0, 4, out);
		error_print_hint(e, out);
		return;
	}
	error_place_text(e, place);
	bool known = e->file[0] != '\0' || e->line > 0;
	const char *sign = e->file[0] == '\0'               ? ""
			   : e->in_grid && place[0] != '\0' ? ","
							    : ":";
	print_and_free_error_line(xasprintf("%s%s%s%s %s", e->file, sign, place,
				      known ? "" : "tipspeed:", e->text),
	    isatty(fileno(out)) != 0, 4, out);
	error_print_hint(e, out);
}

void
error_print_hint(const struct error *e, FILE *out)
{
	if (e->hint[0] != '\0')
		print_and_free_error_line(
		    xasprintf(tr("  hint: %s"), e->hint), true, 8, out);
}
