/* The session and the running of lines.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/command.h"
#include "cmd/files.h"
#include "cmd/keep.h"
#include "cmd/parse.h"
#include "cmd/script.h"
#include "cmd/settings.h"
#include "cmd/turn.h"
#include "cmd/origin.h"
#include "cmd/undo.h"
#include "io/units.h"

struct session *
session_new(FILE *out, FILE *notes)
{
	struct session *s = xcalloc(1, sizeof *s);
	s->set = settings_default();
	s->isa = ISA_BEST;
	session_forget(s);
	s->out = out;
	s->notes = notes;
	s->journal = journal_new();
	s->undo = undo_new();
	s->store = store_new(":memory:");
	return s;
}

void
session_free(struct session *s)
{
	if (s == NULL)
		return;
	session_stop(s);
	script_close(s, 0);
	struct error stopped = {0};
	session_settle(s, false, &stopped);
	keep_end(s);
	entries_free(s->entry, s->n_entry);
	for (size_t i = 0; i < s->n_site; i++)
		site_free(s->site[i]);
	free(s->site);
	free(s->first);
	files_free(s->files);
	prediction_free(&s->last);
	undo_free(s->undo);
	journal_free(s->journal);
	store_free(s->store);
	free(s);
}

struct entry *
session_entry(struct session *s)
{
	assert(s->current < s->n_entry);
	return &s->entry[s->current];
}

const char *
session_origin(const struct entry *entry)
{
	if (entry->has_fit)
		return "found by calibration";
	if (!entry->has_params)
		return "not known yet";
	return entry->origin->words;
}

void
session_forget(struct session *s)
{
	for (size_t i = 0; i < ANSWERS; i++)
		s->answer[i] = NAN;
	prediction_free(&s->last);
	s->last = (struct prediction){0};
}

bool
session_tell_faults(const struct session *s, const char *path,
    const struct error_list *errors, struct error *error)
{
	for (size_t i = 0; i + 1 < errors->n && s->notes != NULL; i++)
		error_print(&errors->item[i], s->notes);
	*error = errors->item[errors->n - 1];
	if (errors->more > 0)
		session_note(
		    s, "%s: %zu more faults are not shown", path, errors->more);
	return false;
}

/* Exact results keep every byte where a program may read them, and are shown as
 * text where they go to a terminal. */
static void
show_exact(struct session *s, struct report *report)
{
	char *text = NULL, *save = NULL;
	size_t n = 0;
	FILE *memory = text_memory(&text, &n);
	report_print(report, s->set.format, s->set.semicolon, memory);
	fclose(memory);
	for (char *line = strtok_r(text, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save)) {
		text_put(line, s->out);
		fputc('\n', s->out);
	}
	free(text);
}

bool
session_report(struct session *s, struct report *report)
{
	bool exact =
	    s->set.format == REPORT_CSV || s->set.format == REPORT_JSON;
	if (exact && s->screen.columns > 0)
		show_exact(s, report);
	else
		report_print(report, s->set.format, s->set.semicolon, s->out);
	fflush(s->out);
	s->rows += report_rows(report);
	report_free(report);
	return true;
}

void
session_note(const struct session *s, const char *format, ...)
{
	if (s->notes == NULL)
		return;
	char text[1024];
	va_list ap;
	va_start(ap, format);
	vsnprintf(text, sizeof text, format, ap);
	va_end(ap);
	if (s->tidy != NULL)
		s->tidy();
	text_wrap(text, 0, 78, s->notes);
}

bool
session_need_site(
    const struct session *s, const char *what, struct error *error)
{
	if (s->n_entry > 0)
		return true;
	return error_set(error, ERROR_USAGE,
	    "%s needs a site, and none is loaded\n"
	    "load its sieve sheet first: load FILE",
	    what);
}

static bool
run_words(struct session *s, const struct words *words, struct place place,
    struct error *error)
{
	struct args args;
	const struct command *command = parse_call(words, place, &args, error);
	bool ok = command != NULL &&
		  (!(command->flags & COMMAND_AT_SITE) ||
		      session_need_site(s, command->name, error)) &&
		  turn_begin(s, &args, words, place, error);
	if (ok) {
		ok = command->run(s, &args, error);
		turn_ran(s);
		if (!ok || turn_over(s))
			ok = turn_end(s, ok, error);
	}
	args_free(&args);
	if (!ok && error->line == 0 && strcmp(error->file, place.file) != 0)
		error_told_at(error, place.file, place.line, words->column[0]);
	return ok;
}

bool
session_line(struct session *s, const char *line, size_t from, const char *file,
    int number, size_t *next, struct error *error)
{
	struct place place = {.file = file,
	    .line = number,
	    .prompt = s->prompt && script_depth(s) <= s->typed_at};
	size_t end = strlen(line), depth = script_depth(s);
	*next = 0;
	if (!session_settle(s, true, error))
		return false;
	while (from < end && !s->quit) {
		struct words words;
		bool ok = words_split(line, from, place, &words, error);
		if (ok && words.n > 0)
			ok = run_words(s, &words, place, error);
		from = words.next;
		place.column = words.reached_column;
		words_free(&words);
		if (!ok)
			return false;
		if (session_busy(s) || s->wants_tui ||
		    script_depth(s) > depth) {
			*next = from;
			return true;
		}
	}
	return true;
}

double
session_clock(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

char *
session_label(const struct site *site)
{
	char *size = site->top_size > 0
			 ? xasprintf(", %g mm", units_mm(site->top_size))
			 : xstrdup("");
	char *label = xasprintf("%s%s%s%s", site->name,
	    site->rock[0] != '\0' ? ", " : "", site->rock, size);
	free(size);
	return label;
}
