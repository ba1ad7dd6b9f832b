/* collect: joins the parts of many sites into the answer of one run, and the
 * stores that they wrote into one store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/fit/part.h"
#include "cmd/fit/scores.h"
#include "cmd/lang/table.h"
#include "io/formats/shards.h"

/* Orders rows as all sites are ordered, and those of one site as they were
 * written. */
static int
compare_sites_by_index(const void *a, const void *b)
{
	const struct part_site *p = *(const struct part_site *const *)a;
	const struct part_site *q = *(const struct part_site *const *)b;
	if (p->index != q->index)
		return p->index > q->index ? 1 : -1;
	return (p > q) - (p < q);
}

/* Returns the rows of all parts, [n], in order.  The caller frees them. */
static const struct part_site **
sort_sites_of_parts(const struct parts *parts, size_t *n)
{
	size_t at = 0;
	*n = 0;
	for (size_t k = 0; k < parts->n; k++)
		*n += parts->part[k].n;
	const struct part_site **site = xcalloc(*n + 1, sizeof(*site));
	for (size_t k = 0; k < parts->n; k++)
		for (size_t i = 0; i < parts->part[k].n; i++)
			site[at++] = &parts->part[k].site[i];
	qsort(site, *n, sizeof(*site), compare_sites_by_index);
	return site;
}

static struct answer *
join_calibrated_sites(const struct part_site *const *site, size_t n)
{
	struct answer *r = part_new_calibrate_answer();
	for (size_t i = 0; i < n; i++)
		part_add_site_row(
		    r, site[i]->text[0], site[i]->number, site[i]->text[1]);
	return r;
}

static struct answer *
join_validated_sites(const struct parts *parts,
    const struct part_site *const *site, size_t n, struct error *error)
{
	struct trials c = {.each = parts->part[0].each > 0};
	struct answer *r = NULL;
	for (size_t k = 0; k < parts->n; k++)
		c.left_out += parts->part[k].left_out;
	for (size_t i = 0; i < n; i++)
		scores_add_runs_of_part(&c, site[i]);
	if (n > 0)
		r = scores_all_sites_answer(&c);
	else
		error_set(error, ERROR_DATA,
		    "no part has a run that was held out\n"
		    "load sites with three speeds");
	trials_clear(&c);
	return r;
}

/* The contents of all stores.  path, used: one for each material. */
struct stores_read {
	struct material_list list;
	struct material_index index;
	const char **path;
	bool *used;
};

static bool
read_store_materials(
    const char *path, struct stores_read *shelf, struct error *error)
{
	size_t n = shelf->list.n;
	struct store *store = store_new(path);
	bool ok = store_list_materials(store, &shelf->list, error);
	store_free(store);
	shelf->path =
	    xrealloc(shelf->path, shelf->list.n + 1, sizeof(*shelf->path));
	for (; n < shelf->list.n; n++)
		shelf->path[n] = path;
	return ok;
}

/* Reads all stores and checks that no name is in two of them. */
static bool
read_stores_of_parts(struct stores_read *shelf, const char *const *path,
    size_t n, struct error *error)
{
	for (size_t k = 0; k < n; k++)
		if (!read_store_materials(path[k], shelf, error))
			return false;
	shelf->used = xcalloc(shelf->list.n + 1, sizeof *shelf->used);
	shelf->index = material_make_index(&shelf->list);
	for (size_t i = 1; i < shelf->index.n; i++) {
		const struct material_index_name *a = &shelf->index.name[i - 1],
						 *b = a + 1;
		if (strcmp(a->fold, b->fold) == 0)
			return error_at(error, ERROR_DATA, shelf->path[b->at],
			    0, 0,
			    "material '%s' is in %s already\nleave one out",
			    shelf->list.item[b->at].name, shelf->path[a->at]);
	}
	return true;
}

static void
free_stores_of_parts(struct stores_read *shelf)
{
	material_index_clear(&shelf->index);
	material_list_free(&shelf->list);
	free(shelf->path);
	free(shelf->used);
}

/* Returns the material of a site.  It must come from the very same calibration,
 * which its misfit shows to the last bit. */
static const struct material *
find_calibrated_material(const struct stores_read *shelf,
    const struct part_site *site, const char *version, struct error *error)
{
	enum { MISFIT = 3 };
	FREED char *fold = text_fold_case_and_accents(site->text[0]);
	const struct material_index_name *found =
	    material_index_find(&shelf->index, fold);
	if (found == NULL) {
		error_set(error, ERROR_DATA,
		    "%s was calibrated by a part, but is in none of the "
		    "stores\n"
		    "name the stores of all parts, each filled by 'remember "
		    "all'",
		    site->text[0]);
		return NULL;
	}
	const struct material *m = &shelf->list.item[found->at];
	shelf->used[found->at] = true;
	if (m->misfit == site->number[MISFIT] &&
	    strcmp(m->version, version) == 0)
		return m;
	error_at(error, ERROR_DATA, shelf->path[found->at], 0, 0,
	    "expected the calibration of '%s' that is in its part (misfit "
	    "%.6g, version %s), got another (misfit %.6g, version %s)\nmake "
	    "the part and the store again, in one run",
	    m->name, site->number[MISFIT], version, m->misfit, m->version);
	return NULL;
}

/* Stores the materials of the sites, in their order.  Fails if one belongs to
 * no site. */
static bool
store_collected_materials(struct session *s, const struct stores_read *shelf,
    const struct parts *parts, const struct part_site *const *site, size_t n,
    bool replace, struct error *error)
{
	FREED struct material *item = xcalloc(n + 1, sizeof *item);
	bool ok = true;
	for (size_t i = 0; ok && i < n; i++) {
		const struct material *m = find_calibrated_material(
		    shelf, site[i], parts->part[0].version, error);
		ok = m != NULL;
		if (ok)
			item[i] = *m;
	}
	for (size_t i = 0; ok && i < shelf->index.n; i++) {
		size_t at = shelf->index.name[i].at;
		if (!shelf->used[at])
			ok = error_at(error, ERROR_DATA, shelf->path[at], 0, 0,
			    "material '%s' belongs to none of the parts\n"
			    "let each part begin with an empty store",
			    shelf->list.item[at].name);
	}
	ok = ok && store_put_materials(s->store, item, n, replace, error);
	if (ok)
		session_note(s, "remembered %zu materials in %s", n,
		    store_path(s->store));
	return ok;
}

static bool
merge_stores_of_parts(struct session *s, const struct parts *parts,
    const struct part_site *const *site, size_t n, const char *const *path,
    size_t n_path, bool replace, struct error *error)
{
	struct stores_read shelf = {0};
	if (n_path == 0)
		return true;
	if (strcmp(parts->part[0].command, "calibrate") != 0)
		return error_at(error, ERROR_DATA, path[0], 0, 0,
		    "expected the parts of 'calibrate all' with a store, got "
		    "those of '%s all'\n"
		    "leave out the store, or collect the parts of the "
		    "programs that filled it",
		    parts->part[0].command);
	bool ok = read_stores_of_parts(&shelf, path, n_path, error) &&
		  store_collected_materials(
		      s, &shelf, parts, site, n, replace, error);
	free_stores_of_parts(&shelf);
	return ok;
}

static bool
show_collected_results(struct session *s, const struct parts *parts,
    const char *const *store, size_t n_store, bool replace, struct error *error)
{
	size_t n;
	FREED const struct part_site **site = sort_sites_of_parts(parts, &n);
	bool scores = strcmp(parts->part[0].command, "validate") == 0;
	struct answer *r = NULL;
	if (merge_stores_of_parts(
		s, parts, site, n, store, n_store, replace, error))
		r = scores ? join_validated_sites(parts, site, n, error)
			   : join_calibrated_sites(site, n);
	return r != NULL && session_show_answer(s, r);
}

bool
cmd_collect(struct session *s, const struct args *args, struct error *error)
{
	struct parts parts = {0};
	bool ok = true;
	const char *store[OPERANDS];
	size_t n_store = 0;
	for (size_t i = 0; ok && i < args->n_operand; i++) {
		const char *path = args->operand[i];
		files_note_read(s, path);
		if (store_is_store_file(path))
			store[n_store++] = path;
		else
			ok = parts_read_file(path, &parts, error);
	}
	if (ok && parts.n == 0)
		ok = error_at(error, ERROR_DATA, store[0], 0, 0,
		    "expected the parts that this store belongs to as "
		    "well\nwrite them with: calibrate all part=I/N > "
		    "FILE.json");
	ok = ok && parts_check_agree(&parts, error) &&
	     show_collected_results(
		 s, &parts, store, n_store, args->replace, error);
	parts_free(&parts);
	return ok;
}
