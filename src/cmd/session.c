/* The session and the running of lines.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/command.h"
#include "cmd/parse.h"
#include "io/site_read.h"
#include "io/units.h"

static unsigned
processors(void)
{
	long n = sysconf(_SC_NPROCESSORS_ONLN);
	return n < 1 ? 1 : n > 64 ? 64 : (unsigned)n;
}

struct session *
session_new(FILE *out, FILE *notes)
{
	struct session *s = xcalloc(1, sizeof *s);
	s->settings = model_settings_default();
	s->bounds = bounds_default();
	s->seed = 1;
	s->threads = processors();
	s->isa = ISA_BEST;
	session_forget(s);
	s->out = out;
	s->notes = notes;
	s->store = store_new(":memory:");
	return s;
}

static void
entry_free(struct entry *entry)
{
	site_free(entry->site);
	free(entry->key);
	free(entry->train);
}

void
session_free(struct session *s)
{
	if (s == NULL)
		return;
	session_stop(s, false);
	for (size_t i = 0; i < s->n_entry; i++)
		entry_free(&s->entry[i]);
	free(s->entry);
	store_free(s->store);
	free(s);
}

struct entry *
session_entry(struct session *s)
{
	assert(s->current < s->n_entry);
	return &s->entry[s->current];
}

void
session_forget(struct session *s)
{
	for (size_t i = 0; i < ANSWERS; i++)
		s->answer[i] = NAN;
}

static bool
key_taken(const struct session *s, const char *key)
{
	for (size_t i = 0; i < s->n_entry; i++)
		if (strcmp(s->entry[i].key, key) == 0)
			return true;
	return false;
}

static char *
sized_key(const char *slug, const struct site *site)
{
	return xasprintf("%s/%g", slug, units_mm(site->top_size));
}

/* "tierp"; of several sites with one name each has its size, "gavle/11.2"; of
 * several with one size the later ones have a number, "gavle/11.2/2". */
static char *
new_key(struct session *s, const struct site *site)
{
	char *slug = text_slug(site->name), *key = xstrdup(slug);
	bool shared = false;
	for (size_t i = 0; i < s->n_entry; i++) {
		struct entry *other = &s->entry[i];
		char *name = text_slug(other->site->name);
		shared = shared || strcmp(name, slug) == 0;
		if (strcmp(other->key, slug) == 0 &&
		    other->site->top_size > 0) {
			free(other->key);
			other->key = sized_key(slug, other->site);
		}
		free(name);
	}
	if (shared && site->top_size > 0) {
		free(key);
		key = sized_key(slug, site);
	}
	char *stem = xstrdup(key);
	for (int i = 2; key_taken(s, key); i++) {
		free(key);
		key = xasprintf("%s/%d", stem, i);
	}
	free(stem);
	free(slug);
	return key;
}

void
session_add(struct session *s, struct site *site)
{
	struct entry entry = {.site = site, .key = new_key(s, site)};
	entry.train = xcalloc(site->n_run, sizeof *entry.train);
	misfit_default_train(site, entry.train);
	s->entry = xrealloc(s->entry, s->n_entry + 1, sizeof *s->entry);
	s->current = s->n_entry++;
	s->entry[s->current] = entry;
	session_forget(s);
}

/* How well a loaded site answers to a name: 0 not, 1 by its name, 2 by name and
 * top size, 3 by its key. */
static int
answers(const struct entry *entry, const char *wanted)
{
	char *name = text_slug(entry->site->name);
	char *sized = xasprintf("%s/%g", name, units_mm(entry->site->top_size));
	char *folded = text_fold(wanted), *slug = text_slug(wanted);
	int match = 0;
	if (strcmp(entry->key, folded) == 0)
		match = 3;
	else if (strcmp(sized, folded) == 0)
		match = 2;
	else if (strcmp(name, slug) == 0)
		match = 1;
	free(name);
	free(sized);
	free(folded);
	free(slug);
	return match;
}

/* "gavle/4, gavle/11.2"; of those that answer, or of all. */
static char *
list_keys(const struct session *s, const char *wanted)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < s->n_entry; i++) {
		if (wanted != NULL && answers(&s->entry[i], wanted) == 0)
			continue;
		char *longer = xasprintf("%s%s%s", list,
		    list[0] != '\0' ? ", " : "", s->entry[i].key);
		free(list);
		list = longer;
	}
	return list;
}

bool
session_find(
    struct session *s, const char *name, size_t *index, struct error *error)
{
	int best = 0;
	size_t found = 0, last = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		int match = answers(&s->entry[i], name);
		if (match == 0 || match < best)
			continue;
		found = match > best ? 1 : found + 1;
		best = match;
		last = i;
	}
	if (found == 1) {
		*index = last;
		return true;
	}
	char *keys = list_keys(s, best > 0 ? name : NULL);
	if (best > 0) {
		error_set(
		    error, ERROR_USAGE, "several sites are called '%s'", name);
		error_hint(error, "use one of: %s", keys);
	} else {
		error_set(error, ERROR_USAGE, "no site '%s' is loaded", name);
		error_hint(error,
		    keys[0] != '\0' ? "loaded: %s" : "load its file first%s",
		    keys);
	}
	free(keys);
	return false;
}

bool
session_load(struct session *s, const char *path, struct error *error)
{
	struct error_list *errors = xcalloc(1, sizeof *errors);
	struct site *site = site_read(path, errors);
	if (site == NULL) {
		/* The last is returned, so that they are shown in order. */
		for (size_t i = 0; i + 1 < errors->n && s->notes != NULL; i++)
			error_print(&errors->item[i], s->notes);
		*error = errors->item[errors->n - 1];
		if (errors->more > 0)
			session_note(s, "%s: %zu more faults are not shown",
			    path, errors->more);
	} else {
		session_add(s, site);
	}
	free(errors);
	return site != NULL;
}

void
session_report(struct session *s, struct report *report)
{
	report_print(report, s->format, s->out);
	fflush(s->out);
	report_free(report);
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
	text_wrap(text, 0, 78, s->notes);
}

static bool
check_need(
    struct session *s, const struct command *command, struct error *error)
{
	if (command->need == NEED_NOTHING || s->n_entry > 0)
		return true;
	error_set(error, ERROR_USAGE, "%s needs a site, and none is loaded",
	    command->name);
	return error_hint(error, "load its sieve sheet first: load FILE");
}

static bool
run_words(struct session *s, const struct words *words, struct place place,
    struct error *error)
{
	struct args args;
	const struct command *command = parse_call(words, place, &args, error);
	bool ok = command != NULL && check_need(s, command, error) &&
		  command->run(s, &args, error);
	args_free(&args);
	if (ok || error->line > 0 || error->file[0] != '\0')
		return ok;
	snprintf(error->file, sizeof error->file, "%s", place.file);
	error->line = place.line;
	error->column = words->column[0];
	return false;
}

bool
session_line(struct session *s, const char *line, size_t from, const char *file,
    int number, size_t *next, struct error *error)
{
	struct place place = {file, number};
	size_t end = strlen(line);
	*next = 0;
	while (from < end && !s->quit) {
		struct words words;
		bool ok = words_split(line, from, place, &words, error);
		if (ok && words.n > 0)
			ok = run_words(s, &words, place, error);
		from = words.next;
		words_free(&words);
		if (!ok)
			return false;
		if (session_busy(s)) {
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
