/* collect: joins the parts of many sites into the answer of one run, and the
 * stores that they wrote into one store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/fit/part.h"
#include "cmd/fit/scores.h"
#include "cmd/lang/table.h"
#include "io/formats/shards.h"

static struct answer *
merge_validation_of_parts(const struct parts *parts, struct error *error)
{
	struct trials c = {.each = parts->part[0].each > 0};
	struct answer *r = NULL;
	for (size_t k = 0; k < parts->n; k++)
		c.left_out += parts->part[k].left_out;
	for (size_t i = 0; i < parts->n_row; i++)
		scores_add_run_of_part(&c, &parts->row[i]);
	if (parts->n_row > 0)
		r = scores_build_answer_of_all_sites(&c);
	else
		error_set(error, ERROR_DATA,
		    "no part has a run that was held out\n"
		    "load sites with three speeds");
	trials_clear(&c);
	return r;
}

/* The contents of all stores.  path: the store of each material; at: index in
 * the list of each material that no site has taken yet, by its name without
 * case and accents. */
struct stores_read {
	struct material_list list;
	const char **path;
	json_t *at;
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
	for (; ok && n < shelf->list.n; n++) {
		const char *name = shelf->list.item[n].name;
		FREED char *fold = text_fold_case_and_accents(name);
		const json_t *same = json_object_get(shelf->at, fold);
		if (same != NULL)
			ok = error_set_at(error, ERROR_DATA, path, 0, 0,
			    "material '%s' is already in %s\nleave one out",
			    name, shelf->path[json_integer_value(same)]);
		shelf->path[n] = path;
		json_object_set_new_nocheck(
		    shelf->at, fold, json_integer((json_int_t)n));
	}
	return ok;
}

/* Takes the material of a site out of `at`. It must be from the same
 * calibration as the part: its misfit must agree to the last bit. */
static bool
extract_material_of_part(const struct stores_read *shelf,
    const struct part_row *row, const char *version, struct material *item,
    struct error *error)
{
	enum { MISFIT = 3 };
	FREED char *fold = text_fold_case_and_accents(row->site);
	const json_t *found = json_object_get(shelf->at, fold);
	if (found == NULL)
		return error_set(error, ERROR_DATA,
		    "%s was calibrated by a part, but is in none of the "
		    "stores\n"
		    "name the stores of all parts, each filled by 'remember "
		    "all'",
		    row->site);
	size_t at = (size_t)json_integer_value(found);
	*item = shelf->list.item[at];
	json_object_del(shelf->at, fold);
	return (item->misfit == row->number[MISFIT] &&
		   strcmp(item->version, version) == 0) ||
	       error_set_at(error, ERROR_DATA, shelf->path[at], 0, 0,
		   "expected the calibration of '%s' that is in its part "
		   "(misfit %.6g, version %s), got another (misfit %.6g, "
		   "version %s)\nmake the part and the store again, in one run",
		   item->name, row->number[MISFIT], version, item->misfit,
		   item->version);
}

/* Stores the materials of the sites, in the order of the sites.  Fails if a
 * material belongs to no site. */
static bool
store_collected_materials(struct session *s, const struct stores_read *shelf,
    const struct parts *parts, bool replace, struct error *error)
{
	size_t n = parts->n_row;
	FREED struct material *item = xcalloc(n + 1, sizeof *item);
	for (size_t i = 0; i < n; i++)
		if (!extract_material_of_part(shelf, &parts->row[i],
			parts->part[0].version, &item[i], error))
			return false;
	const json_t *left =
	    json_object_iter_value(json_object_iter(shelf->at));
	if (left != NULL) {
		json_int_t at = json_integer_value(left);
		return error_set_at(error, ERROR_DATA, shelf->path[at], 0, 0,
		    "material '%s' belongs to none of the parts\n"
		    "let each part begin with an empty store",
		    shelf->list.item[at].name);
	}
	if (!store_save_materials(s->store, item, n, replace, error))
		return false;
	session_print_note(
	    s, "remembered %zu materials in %s", n, store_path(s->store));
	return true;
}

static bool
merge_stores_of_parts(struct session *s, const struct parts *parts,
    const char *const *path, size_t n, bool replace, struct error *error)
{
	if (n == 0)
		return true;
	if (strcmp(parts->part[0].command, "calibrate") != 0)
		return error_set_at(error, ERROR_DATA, path[0], 0, 0,
		    "expected the parts of 'calibrate all' with a store, got "
		    "those of '%s all'\n"
		    "leave out the store, or collect the parts of the "
		    "programs that filled it",
		    parts->part[0].command);
	struct stores_read shelf = {.at = json_object()};
	bool ok = true;
	for (size_t k = 0; ok && k < n; k++)
		ok = read_store_materials(path[k], &shelf, error);
	ok = ok && store_collected_materials(s, &shelf, parts, replace, error);
	material_list_free(&shelf.list);
	free(shelf.path);
	json_decref(shelf.at);
	return ok;
}

bool
cmd_collect(struct session *s, const struct args *args, struct error *error)
{
	struct parts parts = {0};
	struct answer *r = NULL;
	bool ok = true;
	const char *store[OPERANDS];
	size_t n_store = 0;
	for (size_t i = 0; ok && i < args->n_operand; i++) {
		const char *path = args->operand[i];
		files_record_read(s, path);
		if (store_is_sqlite_file(path))
			store[n_store++] = path;
		else
			ok = parts_read_result_file(path, &parts, error);
	}
	if (ok && parts.n == 0)
		ok = error_set_at(error, ERROR_DATA, store[0], 0, 0,
		    "expected the parts that this store belongs to as well\n"
		    "write them with: calibrate all part=I/N > FILE.json");
	if (ok && parts_check_and_sort(&parts, error) &&
	    merge_stores_of_parts(
		s, &parts, store, n_store, args->replace, error))
		r = strcmp(parts.part[0].command, "validate") == 0
			? merge_validation_of_parts(&parts, error)
			: part_build_calibrate_all_answer(
			      parts.row, parts.n_row);
	parts_free(&parts);
	return r != NULL && session_show_answer(s, r);
}
