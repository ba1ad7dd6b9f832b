/* materials, show store: what the store has, and all about one of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/data.h"
#include "cmd/store.h"
#include "cmd/table.h"

const char *
store_origin_words(const struct stored *m)
{
	return stored_is_table3(m)             ? "Table 3"
	       : strcmp(m->origin, "fit") == 0 ? "fit"
					       : "set by hand";
}

/* Sizes are nominal: within 5 % they are the same, so that 11 finds 11.2. */
static bool
has_size(const struct stored *m, double top_mm)
{
	return fabs(m->top_size_mm - top_mm) <= 0.05 * top_mm;
}

static bool
is_wanted(const struct stored *m, const struct args *args)
{
	const struct value *rock = args_value(args, "rock");
	const struct value *top = args_value(args, "top");
	enum { ALL, TABLE3, OWN };
	size_t origin = args_value(args, "origin")->choice;
	return (!rock->given || text_same(m->rock, rock->text)) &&
	       (!top->given || has_size(m, top->number)) &&
	       (origin == ALL || (origin == TABLE3) == stored_is_table3(m));
}

static void
add_row(struct answer *r, const struct stored *m)
{
	answer_cells(r, "%s %s %g %.2f %.2f %.2f %s %s", m->name, m->rock,
	    m->top_size_mm, params_value(&m->params, "f_mat"),
	    params_value(&m->params, "e0_min"),
	    params_value(&m->params, "alpha"), store_origin_words(m),
	    site_data_kind(m->provenance));
}

/* "Diabase, Granite, ...", each once, where none was of the rock asked for. */
static void
note_rocks(struct answer *r, const struct stored_list *list)
{
	char *rocks = xstrdup("");
	for (size_t i = 0; i < list->n; i++) {
		bool before = list->item[i].rock[0] == '\0';
		for (size_t j = 0; j < i; j++)
			before = before || text_same(list->item[j].rock,
					       list->item[i].rock);
		if (!before)
			xlist(&rocks, ", ", "%s", list->item[i].rock);
	}
	answer_note(r, "rocks: %s", rocks);
	free(rocks);
}

static void
show_list(
    struct session *s, const struct args *args, const struct stored_list *list)
{
	struct answer *r = answer_new("materials");
	size_t n = 0, own = 0;
	answer_columns(r,
	    "name, rock, top_size_mm: top mm, f_mat, e0_min: E0_min, alpha, "
	    "origin, data");
	for (size_t i = 0; i < list->n; i++) {
		own += !stored_is_table3(&list->item[i]);
		if (!is_wanted(&list->item[i], args))
			continue;
		add_row(r, &list->item[i]);
		n++;
	}
	answer_note(r, "%zu of %zu materials, %zu of them your own, in %s", n,
	    list->n, own, store_path(s->store));
	answer_note(r, "Table 3 is the paper's, and read only");
	if (n == 0 && args_value(args, "rock")->given)
		note_rocks(r, list);
	session_answer(s, r);
}

static void
add_field(void *data, const char *name, const char *text)
{
	answer_cells(data, "%s %s", name, text);
}

static void
show_one(struct session *s, const struct stored *m)
{
	struct answer *r = answer_new("materials");
	answer_title(r, "%s: %s", m->name, store_origin_words(m));
	answer_site(r, m->site, m->provenance);
	answer_columns(r, "field, value");
	stored_each(m, add_field, r);
	session_answer(s, r);
}

bool
show_store(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	struct stored_list own = {0}, all = {0};
	if (!store_list(s->store, &own, error)) {
		stored_list_free(&own);
		return false;
	}
	stored_table3(&all);
	const char *path = store_path(s->store);
	int64_t bytes = store_bytes(s->store);
	struct answer *r = answer_new("show");
	answer_title(r, "the store of materials");
	answer_columns(r, "what, value");
	answer_pair(r, "place", "%s", path);
	if (strcmp(path, ":memory:") == 0)
		answer_pair(r, "file", "none: kept until the session ends");
	else if (bytes < 0)
		answer_pair(
		    r, "file", "none yet: the first 'remember' creates it");
	else
		answer_pair(r, "file", "%" PRId64 " bytes", bytes);
	answer_pair(r, "schema", "%d", STORE_SCHEMA);
	answer_pair(r, "own materials", "%zu", own.n);
	answer_pair(r, "of Table 3", "%zu, read only", all.n);
	answer_note(r, "run 'materials' to list them");
	stored_list_free(&own);
	stored_list_free(&all);
	return session_answer(s, r);
}

bool
cmd_materials(struct session *s, const struct args *args, struct error *error)
{
	struct stored_list list = {0};
	bool ok = store_list_all(s->store, &list, error);
	const struct stored *m = NULL;
	if (ok && args->n_operand > 0) {
		ok = store_find_material(&list, args->operand[0], &m, error);
		if (ok)
			show_one(s, m);
	} else if (ok) {
		show_list(s, args, &list);
	}
	stored_list_free(&list);
	return ok;
}
