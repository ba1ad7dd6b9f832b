/* Looks the end of a name up in a table of forms, and says why a form cannot be
 * written.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/output.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/journal.h"
#include "io/formats/answer.h"
#include "plot/picture.h"

static const struct output OUTPUTS[] = {
    {".csv", OUTPUT_ANSWERS, false, ANSWER_CSV},
    {".json", OUTPUT_ANSWERS, false, ANSWER_JSON},
    {".md", OUTPUT_ANSWERS, false, ANSWER_MARKDOWN},
    {".xlsx", OUTPUT_BOOK, false, 0}, {".html", OUTPUT_HTML, false, 0},
    {".svg", OUTPUT_PICTURE, true, 0}, {".png", OUTPUT_PICTURE, true, 0},
    {".pdf", OUTPUT_PICTURE, true, 0}, {".pdf", OUTPUT_PDF, false, 0},
    {NULL, OUTPUT_ANSWERS, false, -1}};

/* Workbooks that a spreadsheet would call broken if they held text. */
static const char *const OTHER_BOOKS[] = {".xls", ".xlsm", ".xlsb", ".ods"};

const struct output *
output_of(const struct command *command, const struct words *words)
{
	bool draws = (command->flags & COMMAND_DRAWS) != 0;
	const struct output *o = OUTPUTS;
	for (; o->end != NULL; o++)
		if (words->to != TO_PIPE && text_ends(words->target, o->end) &&
		    (o->kind != OUTPUT_PICTURE || draws))
			break;
	return o;
}

/* A kind of workbook that is not written: the same line with one that is. */
static bool
no_book(const struct command *command, const struct words *words,
    struct error *error)
{
	const char *target = words->target, *end = strrchr(target, '.');
	char *line = xstrdup(command->name);
	for (size_t i = 1; i < words->n; i++)
		journal_word(&line, words->text[i]);
	char *file = xasprintf("%.*s.xlsx", (int)(end - target), target);
	xappend(&line, " >");
	journal_word(&line, file);
	error_set(error, ERROR_USAGE,
	    "cannot write %s workbooks, only .xlsx (%s)\nwrite: %s", end,
	    target, line);
	free(file);
	free(line);
	return false;
}

/* An image wants a command that draws. */
static bool
draws_none(
    const struct command *command, const char *target, struct error *error)
{
	size_t kind;
	if (text_choice(
		command_find("plot")->operands.expect[0], command->name, &kind))
		return error_set(error, ERROR_USAGE,
		    "%s makes no image for %s\n"
		    "use plot %s > %s",
		    command->name, target, command->name, target);
	return error_set(error, ERROR_USAGE,
	    "%s makes no image for %s\n"
	    "use predict or plot KIND",
	    command->name, target);
}

/* What is one whole has no end that more could be added to. */
static bool
no_end(enum output_kind kind, const char *target, struct error *error)
{
	if (kind == OUTPUT_PICTURE)
		return error_set(error, ERROR_USAGE,
		    "an image cannot be appended to %s\n"
		    "use > instead of >>",
		    target);
	return error_set(error, ERROR_USAGE,
	    "results cannot be appended to a %s (%s)\n"
	    "use > with a file for each command, or >> FILE.csv",
	    kind == OUTPUT_BOOK ? tr("workbook") : tr("document"), target);
}

bool
output_allowed(const struct command *command, const struct words *words,
    struct error *error)
{
	enum picture_form form;
	const char *target = words->target;
	if (words->to == TO_PIPE)
		return true;
	for (size_t i = 0; i < ARRAY_LEN(OTHER_BOOKS); i++)
		if (text_ends(target, OTHER_BOOKS[i]))
			return no_book(command, words, error);
	bool image = picture_form_of(target, &form);
	enum output_kind kind = output_of(command, words)->kind;
	if (image && !picture_can(form))
		return error_set(error, ERROR_USAGE,
		    "this program draws %s, not %s\n> FILE.%s works",
		    picture_forms(), strrchr(target, '.') + 1,
		    kind == OUTPUT_PDF ? tr("html") : "svg");
	if (image && kind == OUTPUT_ANSWERS)
		return draws_none(command, target, error);
	return words->to != TO_END || kind == OUTPUT_ANSWERS ||
	       no_end(kind, target, error);
}
