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
#include "cmd/ask/fit.h"
#include "cmd/sheets/check.h"
#include "cmd/session/call_paths.h"
#include "cmd/session/sites.h"
#include "cmd/session/files.h"
#include "cmd/sheets/ask_user.h"
#include "cmd/session/invocation.h"
#include "cmd/session/journal.h"
#include "cmd/sheets/log.h"
#include "cmd/lang/table.h"
#include "io/fs/file.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/results.h"
#include "io/fs/shipped.h"
#include "io/sitefile/site_read.h"

enum { MOST_ROUNDS = 5 };

/* A request to read files, with the files and the user's answers, which it
 * owns. */
struct load {
	struct site_request request;
	char **path;
	double *speed;
	struct user_answers said;
	const char *digest;
};

/* Splits "cut1.csv@70", "cut1.csv@70m/s" or "cut1.csv@1650rpm" into file and
 * speed, below 0 if in rpm, unless there is a file with that whole name. */
static bool
split_file_and_speed(
    const char *word, char **path, double *speed, struct error *error)
{
	const char *at = call_path_at_sign(word);
	*speed = 0;
	*path = xstrdup(word);
	if (at == NULL)
		return true;
	struct head head = heading_parse(at);
	(*path)[at - word] = '\0';
	*speed = head.rpm > 0 ? -head.rpm : head.speed;
	if (*speed != 0 && *speed <= SITE_FASTEST && !head.several)
		return true;
	return error_set(error, ERROR_USAGE,
	    "expected a tip speed in m/s, or rpm, after @, got '%s'\n"
	    "write the speed of the sample there: cut1.csv@70, or "
	    "cut1.csv@1650rpm",
	    word);
}

static void
free_user_answers(struct user_answers *said)
{
	free(said->columns);
	free(said->samples);
	free(said->sheet);
	free(said->range);
}

static void
free_load_request(struct load *l)
{
	for (size_t i = 0; i < l->request.n; i++)
		free(l->path[i]);
	free(l->path);
	free(l->speed);
	free_user_answers(&l->said);
}

/* Adds a file and takes ownership of the path.  speed: see struct
 * site_request. */
static void
load_add_path(struct load *l, char *path, double speed)
{
	size_t n = l->request.n++;
	l->path = xgrow_by_one(l->path, n, sizeof(*l->path));
	l->speed = xgrow_by_one(l->speed, n, sizeof *l->speed);
	l->path[n] = path;
	l->speed[n] = speed;
	l->request.path = (const char *const *)l->path;
	l->request.speed = l->speed;
}

static bool
load_add_file(struct load *l, const char *word, struct error *error)
{
	char *path;
	double speed;
	bool good = split_file_and_speed(word, &path, &speed, error);
	load_add_path(l, path, speed);
	if (!good || !text_ends_with(path, ".tip"))
		return good;
	return error_set(error, ERROR_USAGE,
	    "expected a site file, got a script (%s)\n"
	    "run it with: source %s",
	    path, path);
}

void
load_print_how_site_was_read(const struct session *s, const struct site *site)
{
	enum { MOST = 4 };
	size_t more = site->n_left_out;
	if (site->read_as[0] != '\0')
		session_print_note(s, "  read: %s", site->read_as);
	if (site->assumed[0] != '\0')
		session_print_note(
		    s, "  likely, not stated: %s", site->assumed);
	else if (site->read_as[0] != '\0')
		session_print_note(s,
		    site->told ? N_("  certain: the file states it, or you did")
			       : N_("  certain: the file states all of it"));
	if (site->remark[0] != '\0')
		session_print_note(s, "  %s", site->remark);
	for (size_t i = 0; i < site->n_left_out && i < MOST; i++, more--)
		session_print_note(s, "  not read: %s, %s",
		    site->left_out[i].key, site->left_out[i].value);
	if (more > 0)
		session_print_note(s, "  and %zu more: run 'check'", more);
}

/* Says in one line what was loaded, in two how it was read, and more only if
 * something was left out. */
static void
note_loaded_site(struct session *s, const struct site *site)
{
	size_t n, products = site_count_products(site);
	FREED char *label = session_site_label(site);
	free(site_all_sieves(site, &n));
	if (products > 0)
		session_print_note(s,
		    tr_n("loaded %s: %zu run, %zu sieves",
			"loaded %s: %zu runs, %zu sieves", site->n_run),
		    label, site->n_run, n);
	else
		session_print_note(s,
		    "loaded %s: a feed on %zu sieves, no product; run 'guess' "
		    "for an estimate",
		    label, n);
	if (trust_are_products_like_feed(site))
		session_print_note(s, "  %s", tr(FIT_NOTHING_BREAKS));
	load_print_how_site_was_read(s, site);
	if (products == 1)
		session_print_note(s,
		    "  one product: it cannot show what the speed does; "
		    "'guess' and 'recall' take that from other quarries, 'add' "
		    "adds a cut at another speed");
}

static void
copy_user_answers_to_request(
    const struct user_answers *said, struct site_request *q)
{
	q->columns = said->columns != NULL ? said->columns : q->columns;
	q->samples = said->samples != NULL ? said->samples : q->samples;
	q->sheet = said->sheet != NULL ? said->sheet : q->sheet;
	q->range = said->range != NULL ? said->range : q->range;
	q->decimal = said->decimal != '\0' ? said->decimal : q->decimal;
	q->rotor = said->rotor > 0 ? said->rotor : q->rotor;
	q->top = said->top > 0 ? said->top : q->top;
}

/* For products without a feed, hints at the line that adds them as cuts to the
 * site in use or, if no site is loaded, to a remembered one. */
static void
hint_how_to_add_products(
    const struct session *s, const struct load *l, struct error *error)
{
	size_t own = 0;
	const char *site = s->n_entry > 0 ? s->entry[s->current].key : NULL;
	FREED char *line = xstrdup("add"),
		   *options = site_request_options_text(&l->request);
	for (size_t i = 0; i < l->request.n; i++) {
		FREED char *word = site_request_file_text(&l->request, i);
		journal_append_quoted_word(&line, word);
	}
	if (site != NULL)
		error_set_hint(error, "add it to %s, which has a feed: %s%s",
		    site, line, options);
	else if (store_count_materials(s->store, &own, NULL) && own > 0)
		error_set_hint(error,
		    "bring back the site that it belongs to, and add it: "
		    "recall NAME; %s%s",
		    line, options);
}

/* Reads the request as one site, asking the user if possible.  On failure,
 * returns NULL with an error. */
static struct site *
read_site_or_ask_user(struct session *s, struct load *l, struct error *error)
{
	for (int round = 0;; round++) {
		struct error_list errors = {.stop = s->hooks.stop};
		struct site_ask ask = {0};
		struct site *site =
		    site_read_with_options(&l->request, &errors, &ask);
		/* For feed= nothing is asked, because answers could not be
		 * saved. */
		bool again =
		    site == NULL && round < MOST_ROUNDS && !l->request.feed &&
		    errors.n > 0 &&
		    ask_open_questions(s, &ask, &errors.item[0], &l->said);
		copy_user_answers_to_request(&l->said, &l->request);
		bool cuts =
		    ask.settle == NULL && ask.no_feed && !ask.no_product;
		site_ask_clear(&ask);
		if (site != NULL)
			return site;
		if (again)
			continue;
		session_report_file_faults(s, l->path[0], &errors, error);
		if (cuts && !l->request.parts && !l->request.feed)
			hint_how_to_add_products(s, l, error);
		return NULL;
	}
}

static bool
add_loaded_site_to_session(
    struct session *s, struct load *l, struct site *site, struct error *error)
{
	if (!session_add_site_if_same_digest(s, site, l->digest, error))
		return false;
	const struct entry *entry = session_current_site_entry(s);
	note_loaded_site(s, entry->site);
	check_warn_coarser_product(s, entry->site);
	FREED char *line =
	    journal_load_command_text(entry->site->digest, &l->request);
	FREED char *options = site_request_options_text(&l->request);
	journal_add_line(s, NULL, "%s%s", line, options);
	return true;
}

static bool
load_files_as_one_site(struct session *s, struct load *l, struct error *error)
{
	for (size_t i = 0; i < l->request.n; i++)
		files_record_read(s, l->path[i]);
	struct site *site = read_site_or_ask_user(s, l, error);
	return site != NULL && add_loaded_site_to_session(s, l, site, error);
}

static void
classify_file_as_feed_or_product(const struct session *s, struct load *l,
    size_t i, bool *feed, bool *product)
{
	struct site_request one = l->request;
	struct error_list errors = {.stop = s->hooks.stop};
	struct site_ask ask = {0};
	one.n = 1;
	one.path = &l->request.path[i];
	one.speed = &l->request.speed[i];
	site_free(site_read_with_options(&one, &errors, &ask));
	*feed = ask.no_product && !ask.no_feed;
	*product = ask.no_feed && !ask.no_product;
	site_ask_clear(&ask);
}

/* True if the files are parts of one site: one has a speed, or none is complete
 * and one has the feed of all others (or all have only feeds).  Stops at the
 * first complete file. */
static bool
are_files_parts_of_site(const struct session *s, struct load *l)
{
	size_t feeds = 0, n = l->request.n;
	for (size_t i = 0; i < n; i++)
		if (l->speed[i] != 0)
			return true; /* the user says so */
	for (size_t i = 0; i < n; i++) {
		bool feed, product;
		classify_file_as_feed_or_product(s, l, i, &feed, &product);
		if (!feed && !product)
			return false;
		feeds += feed;
	}
	return feeds == n || feeds == 1;
}

/* Files that could not be read, to be reported at the end. */
struct unread {
	size_t n;
	struct error *fault;
};

/* Reports the unread files in order, except one, which becomes the error: the
 * last that does not exist, if any, because the others may lack only what it
 * has; otherwise the last.  skip: reports all, and sets no error. */
static bool
report_unread_files(struct session *s, const struct unread *u, size_t n,
    bool skip, struct error *error)
{
	if (u->n == 0)
		return true;
	session_print_note(
	    s, "%zu of %zu files are loaded, not these:", n - u->n, n);
	size_t last = u->n - 1;
	while (last > 0 && u->fault[last].kind != ERROR_SYSTEM)
		last--;
	if (u->fault[last].kind != ERROR_SYSTEM)
		last = u->n - 1;
	for (size_t i = 0; i < u->n; i++)
		if (skip || i != last)
			error_print(&u->fault[i], s->notes);
	if (skip)
		return true;
	*error = u->fault[last];
	return false;
}

/* Loads each file as a site of its own, and continues after one that cannot be
 * read. */
static bool
load_each_file_as_site(
    struct session *s, struct load *l, bool skip, struct error *error)
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
		bool loaded = load_files_as_one_site(s, &one, &fault);
		stopped = fault.kind == ERROR_STOPPED;
		if (!loaded) {
			unread.fault = xrealloc(
			    unread.fault, unread.n + 1, sizeof *unread.fault);
			unread.fault[unread.n++] = fault;
		}
		free_user_answers(&one.said);
	}
	bool good = false;
	if (stopped) /* the files before it stay loaded */
		*error = unread.fault[unread.n - 1];
	else
		good =
		    report_unread_files(s, &unread, l->request.n, skip, error);
	free(unread.fault);
	return good;
}

static bool
load_requested_files(
    struct session *s, struct load *l, bool skip, struct error *error)
{
	size_t n = l->request.n;
	if (n == 1 ? !skip : n > 1 && are_files_parts_of_site(s, l))
		return load_files_as_one_site(s, l, error);
	if (l->digest != NULL)
		return error_set(error, ERROR_USAGE,
		    "expected one file with digest=, got %zu", n);
	return load_each_file_as_site(s, l, skip, error);
}

/* A name with a quote can be neither typed nor saved. */
static bool
is_name_of_sheet_file(const char *name)
{
	return file_has_sheet_ending(name) && name[0] != '.' &&
	       strchr(name, '"') == NULL;
}

static int
compare_file_names(const void *a, const void *b)
{
	return strcmp(*(char *const *)a, *(char *const *)b);
}

static void
skip_result_files(const struct session *s, struct load *l, size_t from)
{
	size_t n = from;
	for (size_t i = from; i < l->request.n; i++) {
		FREED char *command = command_that_made_file(l->path[i]);
		if (command == NULL) {
			l->path[n++] = l->path[i];
			continue;
		}
		session_print_note(s,
		    "left out %s: tipspeed's own results (%s)", l->path[i],
		    command);
		free(l->path[i]);
	}
	l->request.n = n;
}

/* Adds the sheets in a folder, in the order of their names, without those in
 * its subfolders. */
static bool
load_add_folder(const struct session *s, struct load *l, DIR *dir,
    const char *path, struct error *error)
{
	size_t before = l->request.n, end = strlen(path);
	while (end > 1 && path[end - 1] == '/')
		end--;
	for (struct dirent *e; (e = readdir(dir)) != NULL;)
		if (is_name_of_sheet_file(e->d_name))
			load_add_path(l,
			    xasprintf("%.*s/%s", (int)end, path, e->d_name), 0);
	if (l->request.n > before)
		qsort(&l->path[before], l->request.n - before, sizeof(*l->path),
		    compare_file_names);
	skip_result_files(s, l, before);
	return l->request.n > before ||
	       error_set_at(error, ERROR_DATA, path, 0, 0,
		   "expected sheets in this folder (%s), got none\n"
		   "name the folder that has them",
		   FILE_SHEET_ENDINGS);
}

/* Adds the files named by words, and the sheets of folders.  A file takes
 * precedence over a shipped site of the same name. */
static bool
load_add_files_or_folders(const struct session *s, struct load *l, size_t n,
    const char *const *word, struct error *error)
{
	bool good = true;
	for (size_t i = 0; i < n && good; i++) {
		DIR *dir = opendir(word[i]);
		if (dir != NULL) {
			good = load_add_folder(s, l, dir, word[i], error);
			closedir(dir);
			continue;
		}
		FREED char *shipped = access(word[i], F_OK) != 0
					  ? shipped_site_path(word[i])
					  : NULL;
		good = load_add_file(
		    l, shipped != NULL ? shipped : word[i], error);
	}
	return good;
}

/* Returns the edit distance of two file names, ignoring case and, if a has no
 * ending, that of b; 0 if only the endings differ. */
static size_t
file_name_edit_distance(const char *a, const char *b)
{
	FREED char *one = text_fold_case_and_accents(a),
		   *two = text_fold_case_and_accents(b);
	size_t n = strcspn(one, "."), m = strcspn(two, ".");
	bool same = n == m && strncmp(one, two, n) == 0;
	if (one[n] == '\0')
		two[m] = '\0';
	return same ? 0 : text_edit_distance(one, two);
}

/* Returns the path of the sheet in the same folder whose name is closest to
 * that of `path`, or NULL if none is close.  The caller frees it. */
static char *
closest_sheet_file_path(const char *path)
{
	const char *name = file_name_without_folders(path);
	int head = (int)(name - path);
	FREED char *folder = xasprintf("%.*s.", head, path);
	size_t least = (strcspn(name, ".") + 2) / 4;
	char *nearest = NULL;
	DIR *dir = opendir(folder);
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		size_t apart = file_name_edit_distance(name, e->d_name);
		bool first =
		    nearest == NULL || strcmp(e->d_name, nearest + head) < 0;
		if (!is_name_of_sheet_file(e->d_name) || apart > least ||
		    (apart == least && !first))
			continue;
		least = apart;
		xfree_and_set(
		    &nearest, xasprintf("%.*s%s", head, path, e->d_name));
	}
	if (dir != NULL)
		closedir(dir);
	return nearest;
}

/* If a file does not exist, suggests the line with the closest file name.
 * args: the call with its options, or NULL. */
static void
hint_closest_file_name(size_t n, const char *const *word,
    const struct args *args, struct error *error)
{
	FREED char *line = xstrdup("load");
	const struct command_option *o;
	bool found = false;
	for (size_t i = 0; i < n; i++) {
		FREED char *near = access(word[i], F_OK) != 0
				       ? closest_sheet_file_path(word[i])
				       : NULL;
		journal_append_quoted_word(
		    &line, near != NULL ? near : word[i]);
		found = found || near != NULL;
	}
	for (size_t i = 0;
	     args != NULL && (o = command_option_at(args->command, i)) != NULL;
	     i++) {
		if (!args->value[i].given)
			continue;
		FREED char *option =
		    xasprintf("%s=%s", o->name, args->value[i].text);
		journal_append_quoted_word(&line, option);
	}
	if (found && error->kind == ERROR_SYSTEM)
		error_set_hint(error, "did you mean '%s'?", line);
}

static void
parse_load_options(struct load *l, const struct args *args)
{
	l->digest = args->digest;
	l->request.columns = args->columns;
	l->request.samples = args->samples;
	l->request.sheet = args->sheet;
	l->request.range = args->range;
	if (args_is_given(args, &args->decimal))
		l->request.decimal = args->decimal == 1 ? ',' : '.';
	if (args->rotor_mm > 0)
		l->request.rotor = args->rotor_mm / 1000;
	l->request.top = args->top;
}

bool
load_files(struct session *s, size_t n, const char *const *word,
    const struct args *args, struct error *error)
{
	struct load l = {0};
	if (args != NULL)
		parse_load_options(&l, args);
	bool good =
	    load_add_files_or_folders(s, &l, n, word, error) &&
	    load_requested_files(s, &l, args != NULL && args->skip, error);
	if (!good)
		hint_closest_file_name(n, word, args, error);
	free_load_request(&l);
	return good;
}

struct site *
load_cuts(struct session *s, const struct args *args, const char *const *word,
    double rotor, struct error *error)
{
	struct load l = {.request = {.parts = true, .site_rotor = rotor}};
	struct site_request answers = {0};
	bool good = true;
	parse_load_options(&l, args);
	for (size_t i = 0; i < args->n_operand && good; i++)
		good = load_add_file(&l, word[i], error);
	for (size_t i = 0; i < l.request.n && good; i++)
		files_record_read(s, l.path[i]);
	struct site *site = good ? read_site_or_ask_user(s, &l, error) : NULL;
	copy_user_answers_to_request(&l.said, &answers);
	FREED char *options = site_request_options_text(&answers);
	invocation_add_journal_options(s, "%s", options);
	free_load_request(&l);
	return site;
}

/* Finds the run whose feed `word` means.  speed: in the word, m/s, or 0. */
static bool
find_run_with_feed(const struct site *site, const char *word, double speed,
    size_t *run, struct error *error)
{
	bool several = site->individual_feeds && site->n_run > 1;
	*run = several || speed > 0 ? site_run_at_speed(site, speed) : 0;
	if (*run < site->n_run)
		return true;
	FREED char *speeds = xstrdup("");
	for (size_t r = 0; r < site->n_run; r++)
		if (!site_run_repeats_speed(site, r))
			xappend_to_list(
			    &speeds, ", ", "%g", site->run[r].speed);
	if (speed > 0 && !(site->run[site->n_run - 1].speed > 0))
		error_set(error, ERROR_DATA,
		    "%s: expected no speed, got %g m/s: its feed belongs to no "
		    "speed\n"
		    "leave out @%g",
		    site->path, speed, speed);
	else if (speed > 0 && !several)
		error_set(error, ERROR_DATA,
		    "%s: expected the speed of one of its samples, got %g m/s\n"
		    "it has %s m/s, all with one feed: leave out @%g",
		    site->path, speed, speeds, speed);
	else if (speed > 0)
		error_set(error, ERROR_DATA,
		    "%s: expected the speed of one of its samples, got %g m/s\n"
		    "it has %s m/s",
		    site->path, speed, speeds);
	else
		error_set(error, ERROR_DATA,
		    "%s: expected one feed, got one for each speed\n"
		    "say which, as in %s@%g; they were sampled at %s m/s",
		    site->path, word, site->run[0].speed, speeds);
	return false;
}

/* Converts the speed of a feed from rpm (below 0), with the rotor of its
 * sheet. */
static bool
convert_feed_speed_from_rpm(const struct site *site, const char *word,
    double *speed, struct error *error)
{
	if (*speed < 0 && !(site->rotor > 0))
		return error_set(error, ERROR_USAGE,
		    "expected a tip speed in m/s after @, got '%s', whose "
		    "rotor is not known\n"
		    "write m/s, or a line rotor_mm,DIAMETER in the sheet",
		    word);
	if (*speed < 0)
		*speed = site_speed_from_rpm(site, -*speed, site->rotor);
	return true;
}

struct site *
load_feed(struct session *s, const char *word, size_t *run, struct error *error)
{
	struct load l = {.request.feed = true};
	struct site *site = NULL;
	bool good = load_add_file(&l, word, error);
	double speed = good ? l.speed[0] : 0;
	if (good) {
		l.speed[0] = 0;
		files_record_read(s, l.path[0]);
		site = read_site_or_ask_user(s, &l, error);
	}
	if (site != NULL &&
	    (!convert_feed_speed_from_rpm(site, word, &speed, error) ||
		!find_run_with_feed(site, word, speed, run, error))) {
		site_free(site);
		site = NULL;
	}
	if (site != NULL)
		load_print_how_site_was_read(s, site);
	free_load_request(&l);
	return site;
}

bool
cmd_load(struct session *s, const struct args *args, struct error *error)
{
	enum { AS_SITE, AS_LOG };
	if (args->as == AS_LOG)
		return log_load_plant_log(s, args, error);
	if (args_is_given(args, &args->dates))
		return error_set(error, ERROR_USAGE,
		    "load: expected no dates=, which is for a log\n"
		    "write: load FILE as=log dates=day-first");
	const char *word = args->operand[0];
	bool good = load_files(s, args->n_operand, args->operand, args, error);
	if (!good && args->n_operand == 1 && access(word, F_OK) != 0 &&
	    store_has_material(s->store, word))
		error_set_hint(error, "it is in the store: recall %s", word);
	return good;
}
