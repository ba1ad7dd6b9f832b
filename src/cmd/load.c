/* load: from files to sites, by way of questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/load.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/check.h"
#include "cmd/entries.h"
#include "cmd/files.h"
#include "cmd/inquiry.h"
#include "cmd/invocation.h"
#include "cmd/journal.h"
#include "cmd/log.h"
#include "cmd/table.h"
#include "io/head.h"
#include "io/site_read.h"

enum { MOST_ROUNDS = 5 };

/* A request whose texts are its own. */
struct load {
	struct site_request request;
	char **path;
	double *speed;
	char *columns, *sheet, *range;
	const char *digest;
};

/* "cut1.csv@70" as file and speed; a file of that whole name comes first. */
static bool
split_speed(const char *word, char **path, double *speed, struct error *error)
{
	const char *at = strrchr(word, '@');
	*speed = 0;
	*path = xstrdup(word);
	if (at == NULL || at == word || access(word, F_OK) == 0 ||
	    strchr(at, '/') != NULL)
		return true;
	struct head head = head_read(at);
	char **copy = path;
	(*copy)[at - word] = '\0';
	*speed = head.speed;
	if (head.speed > 0 && head.speed <= 200)
		return true;
	return error_set(error, ERROR_USAGE,
	    "expected a tip speed in m/s after @, got '%s'\n"
	    "for instance: load feed.csv cut1.csv@70 cut2.csv@75",
	    word);
}

static void
load_clear(struct load *l)
{
	for (size_t i = 0; i < l->request.n; i++)
		free(l->path[i]);
	free(l->path);
	free(l->speed);
	free(l->columns);
	free(l->sheet);
	free(l->range);
}

static bool
load_init(
    struct load *l, size_t n, const char *const *word, struct error *error)
{
	bool good = true;
	l->path = xcalloc(n, sizeof(*l->path));
	l->speed = xdoubles(n);
	for (size_t i = 0; i < n && good; i++) {
		good = split_speed(word[i], &l->path[i], &l->speed[i], error);
		l->request.n = i + 1;
		if (good && text_ends(l->path[i], ".tip"))
			good = error_set(error, ERROR_USAGE,
			    "expected a site file, got a script (%s)\n"
			    "run it with: source %s",
			    l->path[i], l->path[i]);
	}
	l->request.path = (const char *const *)l->path;
	l->request.speed = l->speed;
	return good;
}

void
load_note_reading(const struct session *s, const struct site *site)
{
	enum { MOST = 4 };
	size_t more = site->n_left_out;
	if (site->read_as[0] != '\0')
		session_note(s, "  read: %s", site->read_as);
	if (site->assumed[0] != '\0')
		session_note(s, "  likely, not stated: %s", site->assumed);
	else if (site->read_as[0] != '\0')
		session_note(s, "  sure: all of it is stated");
	if (site->remark[0] != '\0')
		session_note(s, "  %s", site->remark);
	for (size_t i = 0; i < site->n_left_out && i < MOST; i++, more--)
		session_note(s, "  not read: %s, %s", site->left_out[i].key,
		    site->left_out[i].value);
	if (more > 0)
		session_note(s, "  and %zu more: run 'check'", more);
}

/* What was loaded in a line, what it was taken for in two, and more only where
 * something was passed over. */
static void
note_loaded(struct session *s, const struct site *site)
{
	size_t n, products = site_products(site);
	char *label = session_label(site);
	free(site_sieves(site, &n));
	if (products > 0)
		session_note(s, "loaded %s: %zu run%s, %zu sieves", label,
		    site->n_run, site->n_run == 1 ? "" : "s", n);
	else
		session_note(s,
		    "loaded %s: a feed on %zu sieves, no product; run 'guess' "
		    "for an estimate",
		    label, n);
	load_note_reading(s, site);
	if (products == 1)
		session_note(s,
		    "  one product: it cannot show what the speed does; "
		    "'guess' and 'recall' take that from other quarries, 'add' "
		    "adds a cut at another speed");
	free(label);
}

/* Puts one answer instead of another. */
static void
take_text(char **slot, const char **request, char *text)
{
	if (text == NULL)
		return;
	free(*slot);
	*request = *slot = text;
}

/* Asks whoever sits there; false where nobody does, or has given up. */
static bool
ask_somebody(struct session *s, struct load *l, const struct site_ask *ask,
    const struct error_list *errors)
{
	struct inquired said = {0};
	if (ask->settle == NULL || errors->n == 0)
		return false;
	bool good = inquire(s, ask, &errors->item[0], &said);
	take_text(&l->columns, &l->request.columns, said.columns);
	take_text(&l->sheet, &l->request.sheet, said.sheet);
	take_text(&l->range, &l->request.range, said.range);
	if (said.decimal != '\0')
		l->request.decimal = said.decimal;
	if (said.rotor > 0)
		l->request.rotor = said.rotor;
	return good;
}

/* Everything of a request as a line that reads the same sheets again. */
static void
write_journal(struct session *s, const struct load *l, const struct site *site)
{
	char *line =
	    journal_load(site, l->request.n, l->request.path, l->request.speed);
	if (l->columns != NULL)
		xappend(&line, " columns=\"%s\"", l->columns);
	if (l->sheet != NULL)
		xappend(&line, " sheet=\"%s\"", l->sheet);
	if (l->range != NULL)
		xappend(&line, " range=%s", l->range);
	if (l->request.decimal != '\0')
		xappend(&line, " decimal=%s",
		    l->request.decimal == ',' ? "comma" : "point");
	if (l->request.rotor > 0)
		xappend(&line, " rotor_mm=%g", 1000 * l->request.rotor);
	journal_add(s, NULL, "%s", line);
	free(line);
}

/* Reads the request as one site, asking where somebody can be asked.  NULL:
 * with the error. */
static struct site *
read_site(struct session *s, struct load *l, struct error *error)
{
	for (int round = 0;; round++) {
		struct error_list errors = {0};
		struct site_ask ask = {0};
		struct site *site = site_read_as(&l->request, &errors, &ask);
		bool again = site == NULL && round < MOST_ROUNDS &&
			     ask_somebody(s, l, &ask, &errors);
		site_ask_clear(&ask);
		if (site != NULL)
			return site;
		if (again)
			continue;
		session_tell_faults(s, l->path[0], &errors, error);
		return NULL;
	}
}

static bool
take_site(
    struct session *s, struct load *l, struct site *site, struct error *error)
{
	if (!session_take(s, site, l->digest, error))
		return false;
	const struct entry *entry = session_entry(s);
	note_loaded(s, entry->site);
	check_warn_coarser(s, entry->site);
	write_journal(s, l, entry->site);
	return true;
}

static bool
load_as_one(struct session *s, struct load *l, struct error *error)
{
	for (size_t i = 0; i < l->request.n; i++)
		files_reads(s, l->path[i]);
	struct site *site = read_site(s, l, error);
	return site != NULL && take_site(s, l, site, error);
}

/* Whether files are parts of one site: none of them is complete, and one feed
 * serves the others' products. */
static bool
are_parts(struct load *l)
{
	size_t feeds = 0, products = 0;
	for (size_t i = 0; i < l->request.n; i++) {
		struct site_request one = l->request;
		struct error_list errors = {0};
		struct site_ask ask = {0};
		one.n = 1;
		one.path = &l->request.path[i];
		one.speed = &l->request.speed[i];
		site_free(site_read_as(&one, &errors, &ask));
		if (l->speed[i] > 0)
			feeds = l->request.n; /* it was said so */
		products += ask.no_feed && !ask.no_product;
		feeds += ask.no_product && !ask.no_feed;
		site_ask_clear(&ask);
	}
	return feeds >= l->request.n ||
	       (products > 0 && feeds == 1 && feeds + products == l->request.n);
}

static bool
load_each(struct session *s, struct load *l, struct error *error)
{
	for (size_t i = 0; i < l->request.n; i++) {
		struct load one = *l;
		one.request.n = 1;
		one.path = &l->path[i];
		one.request.path = &l->request.path[i];
		one.request.speed = &l->request.speed[i];
		one.columns = l->columns != NULL ? xstrdup(l->columns) : NULL;
		one.sheet = l->sheet != NULL ? xstrdup(l->sheet) : NULL;
		one.range = l->range != NULL ? xstrdup(l->range) : NULL;
		bool good = load_as_one(s, &one, error);
		free(one.columns);
		free(one.sheet);
		free(one.range);
		if (!good)
			return false;
	}
	return true;
}

static bool
run(struct session *s, struct load *l, struct error *error)
{
	if (l->request.n == 1)
		return load_as_one(s, l, error);
	if (are_parts(l))
		return load_as_one(s, l, error);
	if (l->digest != NULL)
		return error_set(error, ERROR_USAGE,
		    "expected one file with digest=, got %zu", l->request.n);
	return load_each(s, l, error);
}

bool
load_files(
    struct session *s, size_t n, const char *const *word, struct error *error)
{
	struct load l = {0};
	bool good = load_init(&l, n, word, error) && run(s, &l, error);
	load_clear(&l);
	return good;
}

static char *
given_text(const struct args *args, const char *name)
{
	const struct value *value = args_value(args, name);
	return value->given ? xstrdup(value->text) : NULL;
}

/* What the options say of the files. */
static void
take_options(struct load *l, const struct args *args)
{
	const struct value *decimal = args_value(args, "decimal");
	const struct value *rotor = args_value(args, "rotor_mm");
	l->request.columns = l->columns = given_text(args, "columns");
	l->request.sheet = l->sheet = given_text(args, "sheet");
	l->request.range = l->range = given_text(args, "range");
	if (decimal->given)
		l->request.decimal = decimal->choice == 1 ? ',' : '.';
	if (rotor->given)
		l->request.rotor = rotor->number / 1000;
}

/* What somebody answered, as an option of the line that is saved. */
static void
save_answer(struct session *s, const struct args *args, const char *option,
    const char *text)
{
	if (text == NULL || args_value(args, option)->given)
		return;
	char *value = xasprintf("\"%s\"", text);
	invocation_adds(s, option, value);
	free(value);
}

static void
save_answers(struct session *s, const struct args *args, const struct load *l,
    double rotor)
{
	const struct site_request *q = &l->request;
	char number[32];
	save_answer(s, args, "columns", l->columns);
	save_answer(s, args, "sheet", l->sheet);
	save_answer(s, args, "range", l->range);
	if (q->decimal != '\0')
		save_answer(
		    s, args, "decimal", q->decimal == ',' ? "comma" : "point");
	if (q->rotor != rotor)
		save_answer(
		    s, args, "rotor_mm", text_exact(1000 * q->rotor, number));
}

struct site *
load_parts(struct session *s, const struct args *args, const char *const *word,
    double rotor, struct error *error)
{
	struct load l = {.request.parts = true};
	bool good = load_init(&l, args->n_operand, word, error);
	take_options(&l, args);
	if (!(l.request.rotor > 0))
		l.request.rotor = rotor;
	for (size_t i = 0; i < l.request.n && good; i++)
		files_reads(s, l.path[i]);
	struct site *site = good ? read_site(s, &l, error) : NULL;
	if (site != NULL)
		save_answers(s, args, &l, rotor);
	load_clear(&l);
	return site;
}

bool
cmd_load(struct session *s, const struct args *args, struct error *error)
{
	struct load l = {0};
	const struct value *digest = args_value(args, "digest");
	if (args_value(args, "as")->choice == 1)
		return log_load(s, args, error);
	if (args_value(args, "dates")->given)
		return error_set(error, ERROR_USAGE,
		    "load: expected no dates=, which is for a log\n"
		    "write: load FILE as=log dates=day-first");
	bool good = load_init(&l, args->n_operand, args->operand, error);
	l.digest = digest->given ? digest->text : NULL;
	take_options(&l, args);
	good = good && run(s, &l, error);
	load_clear(&l);
	return good;
}
