/* The loaded sites of a session, and their keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/sites.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "io/fs/file.h"
#include "io/sitefile/site_request.h"
#include "io/sitefile/units.h"

static uint64_t
digest_of_text(const char *text)
{
	return text_fnv1a_digest(TEXT_DIGEST_START, text, strlen(text));
}

/* True if the key is in use.  Only sites with that name can have it. */
static bool
is_site_key_taken(const struct session *s, uint64_t name, const char *key)
{
	for (size_t i = 0; i < s->n_entry; i++)
		if (s->entry[i].lookup.name == name &&
		    strcmp(s->entry[i].key, key) == 0)
			return true;
	return false;
}

static char *
site_key_with_top_size(const char *slug, const struct site *site)
{
	return xasprintf("%s/%g", slug, units_m_to_mm(site->top_size));
}

/* Returns a name in the form that keys have.  The caller frees it. */
static char *
name_slug(const char *name)
{
	char *slug = text_slug(name);
	if (slug[0] == '\0')
		xfree_and_set(&slug, xstrdup("unnamed"));
	return slug;
}

/* Returns a new key: "tierp"; with the size, "gavle/11.2", if other sites have
 * the name; and with a number, "gavle/11.2/2", if one of them also has the
 * size.  The caller frees it. */
static char *
make_unique_site_key(struct session *s, const struct site *site)
{
	char *slug = name_slug(site->name), *key = xstrdup(slug);
	bool shared = false;
	uint64_t name = digest_of_text(slug);
	size_t n = strlen(slug);
	for (size_t i = 0; i < s->n_entry; i++) {
		struct entry *other = &s->entry[i];
		/* A key is the name, alone or before a slash. */
		if (other->lookup.name != name ||
		    strncmp(other->key, slug, n) != 0 ||
		    (other->key[n] != '\0' && other->key[n] != '/'))
			continue;
		shared = true;
		if (strcmp(other->key, slug) == 0 && other->site->top_size > 0)
			xfree_and_set(&other->key,
			    site_key_with_top_size(slug, other->site));
	}
	if (shared && site->top_size > 0)
		xfree_and_set(&key, site_key_with_top_size(slug, site));
	FREED char *stem = xstrdup(key);
	for (int i = 2; is_site_key_taken(s, name, key); i++)
		xfree_and_set(&key, xasprintf("%s/%d", stem, i));
	free(slug);
	return key;
}

void
session_take_ownership_of_site(struct session *s, struct site *site)
{
	s->site = xgrow_by_one(s->site, s->n_site, sizeof *s->site);
	s->site[s->n_site++] = site;
	session_remove_answers(s);
}

static uint64_t
digest_of_file_identity(const struct stat *file)
{
	uint64_t digest = text_fnv1a_digest(
	    TEXT_DIGEST_START, &file->st_dev, sizeof file->st_dev);
	return text_fnv1a_digest(digest, &file->st_ino, sizeof file->st_ino);
}

static struct lookup_keys
lookup_keys_of_site(const struct site *site)
{
	struct stat file;
	FREED char *slug = name_slug(site->name);
	struct lookup_keys lookup = {
	    digest_of_text(slug), digest_of_text(site->path), 0};
	if (stat(site->path, &file) == 0)
		lookup.file = digest_of_file_identity(&file);
	return lookup;
}

static void
insert_site_into_session(struct session *s, struct site *site, size_t place)
{
	struct entry entry = {.lookup = lookup_keys_of_site(site),
	    .site = site,
	    .key = make_unique_site_key(s, site)};
	entry.train = xcalloc(site->n_run, sizeof *entry.train);
	misfit_mark_default_training(site, entry.train);
	s->entry = xrealloc(s->entry, s->n_entry + 1, sizeof *s->entry);
	memmove(&s->entry[place + 1], &s->entry[place],
	    (s->n_entry++ - place) * sizeof entry);
	s->entry[place] = entry;
	if (s->job.type != NULL && s->job.entry >= place)
		s->job.entry++;
	s->current = place;
	s->last_asked = (struct last_asked){0};
	session_take_ownership_of_site(s, site);
}

/* Returns the length of the sheet's name in a part, "Berga A1:E12". */
static size_t
length_of_sheet_name(const char *part)
{
	const char *blank = strrchr(part, ' ');
	return blank != NULL ? (size_t)(blank - part) : 0;
}

/* True if both are ranges of one sheet, and overlap: then the second is the
 * first, corrected. */
static bool
do_ranges_overlap(const char *a, const char *b)
{
	struct cell_range one, two;
	size_t n = length_of_sheet_name(a);
	if (n != length_of_sheet_name(b) || strncmp(a, b, n) != 0)
		return false;
	n += n > 0;
	return cell_range_parse(a + n, &one) && cell_range_parse(b + n, &two) &&
	       one.top <= two.bottom && two.top <= one.bottom &&
	       one.left <= two.right && two.left <= one.right;
}

/* True if two sites of a file are of different sheets or ranges of it.  One
 * that was read from all of it may be the same as any other. */
static bool
is_other_part(const struct site *a, const struct site *b)
{
	return a->part[0] != '\0' && b->part[0] != '\0' &&
	       strcmp(a->part, b->part) != 0 &&
	       !do_ranges_overlap(a->part, b->part);
}

/* Finds the site that was read from the same file, or part of it, by its path
 * or by another name of the file; n_entry if there is none.  Compares digests
 * first: if there are many sites, stat on each would take longer than reading
 * the files. */
static size_t
find_site_of_same_file(const struct session *s, const struct site *site)
{
	struct stat file, other;
	if (stat(site->path, &file) != 0)
		return s->n_entry;
	struct lookup_keys own = {
	    0, digest_of_text(site->path), digest_of_file_identity(&file)};
	for (size_t i = 0; i < s->n_entry; i++)
		if ((s->entry[i].lookup.path == own.path ||
			s->entry[i].lookup.file == own.file) &&
		    !is_other_part(s->entry[i].site, site) &&
		    stat(s->entry[i].site->path, &other) == 0 &&
		    file.st_dev == other.st_dev && file.st_ino == other.st_ino)
			return i;
	return s->n_entry;
}

void
session_add_site(struct session *s, struct site *site)
{
	size_t place = find_site_of_same_file(s, site);
	if (place < s->n_entry) {
		session_print_note(
		    s, "replaced %s, loaded earlier", s->entry[place].key);
		session_remove_site(s, place);
	}
	insert_site_into_session(s, site, place);
}

void
session_remove_site(struct session *s, size_t index)
{
	if (s->job.type != NULL && s->job.entry == index)
		session_discard_paused_job(s);
	else if (s->job.type != NULL && s->job.entry > index)
		s->job.entry--;
	entry_clear(&s->entry[index]);
	memmove(&s->entry[index], &s->entry[index + 1],
	    (--s->n_entry - index) * sizeof *s->entry);
	if (s->current == index)
		session_remove_answers(s);
	bool last = s->current == index && index == s->n_entry;
	if (s->current > index || (last && index > 0))
		s->current--;
}

bool
session_replace_site_by_mended(struct session *s, struct site *site)
{
	struct entry *entry = &s->entry[s->current];
	bool own =
	    entry->has_fit || (entry->origin != NULL && entry->origin->found &&
				  entry->origin->from[0] == '\0');
	if (s->job.type != NULL && s->job.entry == s->current)
		session_discard_paused_job(s);
	if (site->n_run != entry->site->n_run) {
		free(entry->train);
		entry->train = xcalloc(site->n_run, sizeof *entry->train);
		misfit_mark_default_training(site, entry->train);
	}
	entry->site = site;
	history_release(entry->history);
	entry->history = NULL;
	entry->has_fit = false;
	entry->fit = (struct fit){.misfit = 0};
	entry->options[0] = '\0';
	if (own) {
		origin_release(entry->origin);
		entry->origin = NULL;
		entry->has_params = false;
		entry->params = (struct params){.breakage = 0};
	}
	session_take_ownership_of_site(s, site);
	return own;
}

/* Runs that a fit was trained on remain training runs.  Without a fit, the
 * training runs are chosen anew. */
void
session_replace_site_by_extended(
    struct session *s, struct site *site, const size_t *from)
{
	struct entry *entry = session_current_site_entry(s);
	if (s->job.type != NULL && s->job.entry == s->current)
		session_discard_paused_job(s);
	bool *train = xcalloc(site->n_run, sizeof *train);
	if (!entry->has_fit)
		misfit_mark_default_training(site, train);
	for (size_t r = 0; r < site->n_run && entry->has_fit; r++)
		train[r] =
		    from[r] < entry->site->n_run && entry->train[from[r]];
	free(entry->train);
	entry->train = train;
	entry->site = site;
	session_take_ownership_of_site(s, site);
}

/* As name_slug, with '-' for '_': the name as typed from memory.  The caller
 * frees it. */
static char *
slug_of_typed_name(const char *name)
{
	char *slug = name_slug(name);
	for (char *p = slug; *p != '\0'; p++)
		*p = *p == '_' ? '-' : *p;
	return slug;
}

/* Returns how well a site matches a name: 0 not at all, 1 by its name, 2 by
 * name and top size, 3 by its key. */
static int
site_name_match_grade(const struct entry *entry, const char *wanted)
{
	FREED char *name = name_slug(entry->site->name);
	FREED char *sized = site_key_with_top_size(name, entry->site);
	FREED char *folded = text_fold_case_and_accents(wanted),
		   *slug = slug_of_typed_name(wanted);
	FREED char *loose = slug_of_typed_name(entry->site->name);
	return strcmp(entry->key, folded) == 0 ? 3
	       : strcmp(sized, folded) == 0    ? 2
	       : strcmp(loose, slug) == 0      ? 1
					       : 0;
}

/* Returns "gavle/4, gavle/11.2": the keys of the sites that match, or of all if
 * `wanted` is NULL.  The caller frees it. */
static char *
matching_site_keys_text(const struct session *s, const char *wanted)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < s->n_entry; i++)
		if (wanted == NULL ||
		    site_name_match_grade(&s->entry[i], wanted) > 0)
			xappend_to_list(&list, ", ", "%s", s->entry[i].key);
	return list;
}

bool
session_find_site(
    struct session *s, const char *name, size_t *index, struct error *error)
{
	int best = 0;
	size_t found = 0, last = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		int match = site_name_match_grade(&s->entry[i], name);
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
	bool file = best == 0 && file_exists(name);
	FREED char *keys = matching_site_keys_text(s, best > 0 ? name : NULL);
	return error_set(error, ERROR_USAGE,
	    best > 0 ? N_("several sites are called '%s'\nuse one of: %s")
	    : file   ? N_("no site '%s' is loaded\nit is a file: load %s")
	    : keys[0] != '\0'
		? N_("no site '%s' is loaded\nloaded: %s")
		: N_("no site '%s' is loaded\nload its file first%s"),
	    name, file ? name : keys);
}

bool
session_add_site_if_same_digest(struct session *s, struct site *site,
    const char *digest, struct error *error)
{
	char found[17];
	snprintf(found, sizeof found, "%016" PRIx64, site->digest);
	if (digest == NULL || strcmp(digest, found) == 0) {
		session_add_site(s, site);
		return true;
	}
	error_set_at(error, ERROR_DATA, site->path, 0, 0,
	    "expected a site file with digest %s, got %s: its numbers have "
	    "changed\n"
	    "leave out digest= to load it anyway; results will change",
	    digest, found);
	site_free(site);
	return false;
}
