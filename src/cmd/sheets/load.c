/* load: reads files into sites and asks what they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/load.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/sheets/check.h"
#include "cmd/session/sites.h"
#include "cmd/session/files.h"
#include "cmd/sheets/ask_user.h"
#include "cmd/session/turn.h"
#include "cmd/session/journal.h"
#include "cmd/sheets/log.h"
#include "cmd/lang/table.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/results.h"
#include "io/fs/shipped.h"
#include "io/sitefile/site_read.h"

enum { MOST_ROUNDS = 5 };

/* A request whose texts are its own. */
struct load {
	struct site_request request;
	char **path;
	double *speed;
	char *columns, *samples, *sheet, *range;
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
	if (head.speed > 0 && head.speed <= SITE_FASTEST && !head.several)
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
	free(l->samples);
	free(l->sheet);
	free(l->range);
}

static bool
load_read_operands(
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
		session_note(s, "  certain: the file states all of it");
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
	FREED char *label = session_site_label(site);
	free(site_sieves(site, &n));
	if (products > 0)
		session_note(s,
		    tr_n("loaded %s: %zu run, %zu sieves",
			"loaded %s: %zu runs, %zu sieves", site->n_run),
		    label, site->n_run, n);
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
}

/* Puts one answer instead of another. */
static void
load_take_text(char **slot, const char **request, char *text)
{
	if (text == NULL)
		return;
	free(*slot);
	*request = *slot = text;
}

/* Asks whoever sits there; false where nobody does, or has given up. */
static bool
ask_user_about_load(struct session *s, struct load *l,
    const struct site_ask *ask, const struct error_list *errors)
{
	struct inquired said = {0};
	if (ask->settle == NULL || errors->n == 0)
		return false;
	bool good = ask_open_question(s, ask, &errors->item[0], &said);
	load_take_text(&l->columns, &l->request.columns, said.columns);
	load_take_text(&l->samples, &l->request.samples, said.samples);
	load_take_text(&l->sheet, &l->request.sheet, said.sheet);
	load_take_text(&l->range, &l->request.range, said.range);
	if (said.decimal != '\0')
		l->request.decimal = said.decimal;
	if (said.rotor > 0)
		l->request.rotor = said.rotor;
	if (said.top > 0)
		l->request.top = said.top;
	return good;
}

/* Everything of a request as a line that reads the same sheets again. */
static void
load_write_journal(
    struct session *s, const struct load *l, const struct site *site)
{
	char number[32];
	FREED char *line =
	    journal_load(site, l->request.n, l->request.path, l->request.speed);
	if (l->columns != NULL)
		xappend(&line, " columns=\"%s\"", l->columns);
	if (l->samples != NULL)
		xappend(&line, " samples=\"%s\"", l->samples);
	if (l->sheet != NULL)
		xappend(&line, " sheet=\"%s\"", l->sheet);
	if (l->range != NULL)
		xappend(&line, " range=%s", l->range);
	if (l->request.decimal != '\0')
		xappend(&line, " decimal=%s",
		    l->request.decimal == ',' ? "comma" : "point");
	if (l->request.rotor > 0)
		xappend(&line, " rotor_mm=%g", 1000 * l->request.rotor);
	if (l->request.top > 0)
		xappend(&line, " top=%s", text_exact(l->request.top, number));
	journal_add(s, NULL, "%s", line);
}

/* Reads the request as one site, asking where somebody can be asked.  NULL:
 * with the error. */
static struct site *
read_site(struct session *s, struct load *l, struct error *error)
{
	for (int round = 0;; round++) {
		struct error_list errors = {.stop = s->hooks.stop};
		struct site_ask ask = {0};
		struct site *site = site_read_as(&l->request, &errors, &ask);
		/* What is answered about a feed would not be saved. */
		bool again = site == NULL && round < MOST_ROUNDS &&
			     !l->request.feed &&
			     ask_user_about_load(s, l, &ask, &errors);
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
load_take_site(
    struct session *s, struct load *l, struct site *site, struct error *error)
{
	if (!session_add_loaded(s, site, l->digest, error))
		return false;
	const struct entry *entry = session_entry(s);
	note_loaded(s, entry->site);
	check_warn_coarser(s, entry->site);
	load_write_journal(s, l, entry->site);
	return true;
}

static bool
load_as_one(struct session *s, struct load *l, struct error *error)
{
	for (size_t i = 0; i < l->request.n; i++)
		files_note_read(s, l->path[i]);
	struct site *site = read_site(s, l, error);
	return site != NULL && load_take_site(s, l, site, error);
}

/* What a file alone lacks of a site. */
static void
find_what_file_has(const struct session *s, struct load *l, size_t i,
    bool *feed, bool *product)
{
	struct site_request one = l->request;
	struct error_list errors = {.stop = s->hooks.stop};
	struct site_ask ask = {0};
	one.n = 1;
	one.path = &l->request.path[i];
	one.speed = &l->request.speed[i];
	site_free(site_read_as(&one, &errors, &ask));
	*feed = ask.no_product && !ask.no_feed;
	*product = ask.no_feed && !ask.no_product;
	site_ask_clear(&ask);
}

/* Whether files are parts of one site: none of them is complete, and one feed
 * serves the others' products.  The first that is complete tells. */
static bool
are_parts(const struct session *s, struct load *l)
{
	size_t feeds = 0, n = l->request.n;
	for (size_t i = 0; i < n; i++)
		if (l->speed[i] > 0)
			return true; /* it was said so */
	for (size_t i = 0; i < n; i++) {
		bool feed, product;
		find_what_file_has(s, l, i, &feed, &product);
		if (!feed && !product)
			return false;
		feeds += feed;
	}
	return feeds == n || feeds == 1;
}

/* Files that could not be read, for the end. */
struct unread {
	size_t n;
	struct error *fault;
};

/* All of them in their order; the error, which is told last, is the last that
 * is not there, or else the last: the others may lack no more than what that
 * file has.  skip: none is an error. */
static bool
report_unread(struct session *s, const struct unread *u, size_t n, bool skip,
    struct error *error)
{
	if (u->n == 0)
		return true;
	session_note(s, "%zu of %zu files are loaded, not these:", n - u->n, n);
	size_t last = u->n - 1;
	while (last > 0 && u->fault[last].kind != ERROR_SYSTEM)
		last--;
	if (u->fault[last].kind != ERROR_SYSTEM)
		last = u->n - 1;
	for (size_t i = 0; i < u->n && s->notes != NULL; i++)
		if (skip || i != last)
			error_print(&u->fault[i], s->notes);
	if (skip)
		return true;
	*error = u->fault[last];
	return false;
}

/* Each file is a site: those that can be read are loaded. */
static bool
load_each(struct session *s, struct load *l, bool skip, struct error *error)
{
	struct unread unread = {0};
	bool stopped = false;
	for (size_t i = 0; i < l->request.n && !stopped; i++) {
		struct load one = *l;
		struct error fault = {0};
		one.request.n = 1;
		one.path = &l->path[i];
		one.request.path = &l->request.path[i];
		one.request.speed = &l->request.speed[i];
		one.columns = l->columns != NULL ? xstrdup(l->columns) : NULL;
		one.samples = l->samples != NULL ? xstrdup(l->samples) : NULL;
		one.sheet = l->sheet != NULL ? xstrdup(l->sheet) : NULL;
		one.range = l->range != NULL ? xstrdup(l->range) : NULL;
		bool loaded = load_as_one(s, &one, &fault);
		stopped = fault.kind == ERROR_STOPPED;
		if (!loaded) {
			unread.fault = xrealloc(
			    unread.fault, unread.n + 1, sizeof *unread.fault);
			unread.fault[unread.n++] = fault;
		}
		free(one.columns);
		free(one.samples);
		free(one.sheet);
		free(one.range);
	}
	bool good = false;
	if (stopped) /* those before stay, as the lines of a script do */
		*error = unread.fault[unread.n - 1];
	else
		good = report_unread(s, &unread, l->request.n, skip, error);
	free(unread.fault);
	return good;
}

static bool
load_run(struct session *s, struct load *l, bool skip, struct error *error)
{
	if (l->request.n == 1 && !skip)
		return load_as_one(s, l, error);
	if (l->request.n > 1 && are_parts(s, l))
		return load_as_one(s, l, error);
	if (l->digest != NULL)
		return error_set(error, ERROR_USAGE,
		    "expected one file with digest=, got %zu", l->request.n);
	return load_each(s, l, skip, error);
}

/* Files, with the sheets of folders in their places. */
struct listed {
	const struct session *session; /* told what is left out */
	size_t n;
	char **word;
};

static void
listed_add(struct listed *list, char *word)
{
	list->word = xrealloc(list->word, list->n + 1, sizeof(*list->word));
	list->word[list->n++] = word;
}

static void
listed_clear(struct listed *list)
{
	for (size_t i = 0; i < list->n; i++)
		free(list->word[i]);
	free(list->word);
}

/* A quote in a name could not be typed, nor saved. */
static bool
load_is_sheet(const char *name)
{
	static const char *const ENDS[] = {
	    ".csv", ".ods", ".tsv", ".txt", ".xlsx"};
	FREED char *folded = text_fold(name);
	bool sheet = false;
	for (size_t i = 0; i < ARRAY_LEN(ENDS); i++)
		sheet = sheet || text_ends(folded, ENDS[i]);
	return sheet && name[0] != '.' && strchr(name, '"') == NULL;
}

static int
load_by_name(const void *a, const void *b)
{
	return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Results that were saved beside the sheets, from this one on. */
static void
leave_out_results(struct listed *list, size_t from)
{
	size_t n = from;
	for (size_t i = from; i < list->n; i++) {
		FREED char *command = results_command_in(list->word[i]);
		if (command == NULL) {
			list->word[n++] = list->word[i];
			continue;
		}
		session_note(list->session,
		    "left out %s: results of tipspeed's own (%s)",
		    list->word[i], command);
		free(list->word[i]);
	}
	list->n = n;
}

/* The sheets of a folder by their names; those of folders in it are not its. */
static bool
list_folder(
    struct listed *list, DIR *dir, const char *path, struct error *error)
{
	size_t before = list->n, end = strlen(path);
	while (end > 1 && path[end - 1] == '/')
		end--;
	for (struct dirent *e; (e = readdir(dir)) != NULL;)
		if (load_is_sheet(e->d_name))
			listed_add(list,
			    xasprintf("%.*s/%s", (int)end, path, e->d_name));
	if (list->n > before)
		qsort(&list->word[before], list->n - before,
		    sizeof(*list->word), load_by_name);
	leave_out_results(list, before);
	return list->n > before ||
	       error_at(error, ERROR_DATA, path, 0, 0,
		   "expected sheets in this folder (.csv .tsv .txt .xlsx "
		   ".ods), got none\n"
		   "name the folder that has them");
}

/* A file that is there comes before a shipped site of its name. */
static bool
list_words(
    struct listed *list, size_t n, const char *const *word, struct error *error)
{
	bool good = true;
	for (size_t i = 0; i < n && good; i++) {
		DIR *dir = opendir(word[i]);
		if (dir == NULL) {
			char *path = access(word[i], F_OK) != 0
					 ? shipped_path(word[i])
					 : NULL;
			listed_add(
			    list, path != NULL ? path : xstrdup(word[i]));
			continue;
		}
		good = list_folder(list, dir, word[i], error);
		closedir(dir);
	}
	return good;
}

/* How unlike the names of two files are, without case, and without an ending
 * where the first has none; 0 where only the endings differ. */
static size_t
apart_in_name(const char *a, const char *b)
{
	FREED char *one = text_fold(a), *two = text_fold(b);
	size_t n = strcspn(one, "."), m = strcspn(two, ".");
	bool same = n == m && strncmp(one, two, n) == 0;
	if (one[n] == '\0')
		two[m] = '\0';
	return same ? 0 : text_distance(one, two);
}

/* The sheet in the folder of a path whose name is nearest to it, or NULL; the
 * caller frees. */
static char *
nearest_sheet(const char *path)
{
	const char *slash = strrchr(path, '/');
	int head = slash != NULL ? (int)(slash - path) + 1 : 0;
	const char *name = path + head;
	FREED char *folder = xasprintf("%.*s.", head, path);
	size_t least = (strcspn(name, ".") + 2) / 4;
	char *nearest = NULL;
	DIR *dir = opendir(folder);
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		size_t apart = apart_in_name(name, e->d_name);
		bool first =
		    nearest == NULL || strcmp(e->d_name, nearest + head) < 0;
		if (!load_is_sheet(e->d_name) || apart > least ||
		    (apart == least && !first))
			continue;
		least = apart;
		free(nearest);
		nearest = xasprintf("%.*s%s", head, path, e->d_name);
	}
	if (dir != NULL)
		closedir(dir);
	return nearest;
}

/* Of files one of which is not there: the line with its nearest name.  args:
 * the options that stand in the line, or NULL. */
static void
hint_nearest(size_t n, const char *const *word, const struct args *args,
    struct error *error)
{
	FREED char *line = xstrdup("load");
	const struct command_option *o;
	bool found = false;
	for (size_t i = 0; i < n; i++) {
		FREED char *near =
		    access(word[i], F_OK) != 0 ? nearest_sheet(word[i]) : NULL;
		journal_append_word(&line, near != NULL ? near : word[i]);
		found = found || near != NULL;
	}
	for (size_t i = 0;
	     args != NULL && (o = command_option_at(args->command, i)) != NULL;
	     i++) {
		if (!args->value[i].given)
			continue;
		FREED char *option =
		    xasprintf("%s=%s", o->name, args->value[i].text);
		journal_append_word(&line, option);
	}
	if (found && error->kind == ERROR_SYSTEM)
		error_hint(error, "did you mean '%s'?", line);
}

bool
load_files(
    struct session *s, size_t n, const char *const *word, struct error *error)
{
	struct load l = {0};
	struct listed list = {.session = s};
	bool good = list_words(&list, n, word, error) &&
		    load_read_operands(
			&l, list.n, (const char *const *)list.word, error) &&
		    load_run(s, &l, false, error);
	if (!good)
		hint_nearest(n, word, NULL, error);
	load_clear(&l);
	listed_clear(&list);
	return good;
}

static char *
copy_given_text(const char *text)
{
	return text != NULL ? xstrdup(text) : NULL;
}

/* What the options say of the files. */
static void
load_read_options(struct load *l, const struct args *args)
{
	l->request.columns = l->columns = copy_given_text(args->columns);
	l->request.samples = l->samples = copy_given_text(args->samples);
	l->request.sheet = l->sheet = copy_given_text(args->sheet);
	l->request.range = l->range = copy_given_text(args->range);
	if (args_given(args, &args->decimal))
		l->request.decimal = args->decimal == 1 ? ',' : '.';
	if (args->rotor_mm > 0)
		l->request.rotor = args->rotor_mm / 1000;
	l->request.top = args->top;
}

/* What somebody answered, as an option of the line that is saved. */
static void
save_answer(struct session *s, const struct args *args, const void *option,
    const char *text)
{
	if (text == NULL || args_given(args, option))
		return;
	FREED char *value = xasprintf("\"%s\"", text);
	invocation_add_option(s, args_name(args, option), value);
}

static void
save_answers(struct session *s, const struct args *args, const struct load *l)
{
	const struct site_request *q = &l->request;
	char number[32];
	save_answer(s, args, &args->columns, l->columns);
	save_answer(s, args, &args->samples, l->samples);
	save_answer(s, args, &args->sheet, l->sheet);
	save_answer(s, args, &args->range, l->range);
	if (q->decimal != '\0')
		save_answer(s, args, &args->decimal,
		    q->decimal == ',' ? "comma" : "point");
	if (q->rotor > 0)
		save_answer(s, args, &args->rotor_mm,
		    text_exact(1000 * q->rotor, number));
	if (q->top > 0)
		save_answer(s, args, &args->top, text_exact(q->top, number));
}

struct site *
load_parts(struct session *s, const struct args *args, const char *const *word,
    double rotor, struct error *error)
{
	struct load l = {.request.parts = true};
	bool good = load_read_operands(&l, args->n_operand, word, error);
	load_read_options(&l, args);
	l.request.site_rotor = rotor;
	for (size_t i = 0; i < l.request.n && good; i++)
		files_note_read(s, l.path[i]);
	struct site *site = good ? read_site(s, &l, error) : NULL;
	if (site != NULL)
		save_answers(s, args, &l);
	load_clear(&l);
	return site;
}

/* The run whose feed is meant; speed: 0 where none was said. */
static bool
find_feed(const struct site *site, const char *word, double speed, size_t *run,
    struct error *error)
{
	bool several = site->individual_feeds && site->n_run > 1;
	*run = several || speed > 0 ? site_run_at(site, speed) : 0;
	if (*run < site->n_run)
		return true;
	FREED char *speeds = xstrdup("");
	for (size_t r = 0; r < site->n_run; r++)
		if (!site_run_repeats(site, r))
			xlist(&speeds, ", ", "%g", site->run[r].speed);
	if (speed > 0 && !(site->run[site->n_run - 1].speed > 0))
		error_set(error, ERROR_DATA,
		    "%s: expected no speed, got %g m/s: its feed belongs to no "
		    "speed\n"
		    "leave out @%g",
		    site->path, speed, speed);
	else if (speed > 0 && !several)
		error_set(error, ERROR_DATA,
		    "%s: expected the speed of one of its samples, got %g "
		    "m/s\n"
		    "it has %s m/s, all with one feed: leave out @%g",
		    site->path, speed, speeds, speed);
	else if (speed > 0)
		error_set(error, ERROR_DATA,
		    "%s: expected the speed of one of its samples, got %g "
		    "m/s\n"
		    "it has %s m/s",
		    site->path, speed, speeds);
	else
		error_set(error, ERROR_DATA,
		    "%s: expected one feed, got one for each speed\n"
		    "say which, as in %s@%g; they were sampled at %s m/s",
		    site->path, word, site->run[0].speed, speeds);
	return false;
}

struct site *
load_feed(struct session *s, const char *word, size_t *run, struct error *error)
{
	struct load l = {.request.feed = true};
	struct site *site = NULL;
	bool good = load_read_operands(&l, 1, &word, error);
	double speed = good ? l.speed[0] : 0;
	if (good) {
		l.speed[0] = 0;
		files_note_read(s, l.path[0]);
		site = read_site(s, &l, error);
	}
	if (site != NULL && !find_feed(site, word, speed, run, error)) {
		site_free(site);
		site = NULL;
	}
	if (site != NULL)
		load_note_reading(s, site);
	load_clear(&l);
	return site;
}

/* A name that may be the file's, and whether it was. */
struct remembered_name {
	const char *name;
	bool found;
};

static void
compare_name(void *data, const char *name)
{
	struct remembered_name *r = data;
	r->found = r->found || text_same(name, r->name);
}

/* Of a file that is not there: whether something so named was remembered. */
static void
hint_remembered(const struct session *s, const char *word, struct error *error)
{
	struct remembered_name r = {.name = word};
	if (access(word, F_OK) != 0 &&
	    store_each_name(s->store, STORE_NAMES, compare_name, &r, NULL) &&
	    r.found)
		error_hint(error, "it is in the store: recall %s", word);
}

bool
cmd_load(struct session *s, const struct args *args, struct error *error)
{
	enum { AS_SITE, AS_LOG };
	struct load l = {0};
	if (args->as == AS_LOG)
		return log_load(s, args, error);
	if (args_given(args, &args->dates))
		return error_set(error, ERROR_USAGE,
		    "load: expected no dates=, which is for a log\n"
		    "write: load FILE as=log dates=day-first");
	struct listed list = {.session = s};
	bool good = list_words(&list, args->n_operand, args->operand, error) &&
		    load_read_operands(
			&l, list.n, (const char *const *)list.word, error);
	l.digest = args->digest;
	load_read_options(&l, args);
	good = good && load_run(s, &l, args->skip, error);
	if (!good)
		hint_nearest(args->n_operand, args->operand, args, error);
	if (!good && args->n_operand == 1)
		hint_remembered(s, args->operand[0], error);
	load_clear(&l);
	listed_clear(&list);
	return good;
}
