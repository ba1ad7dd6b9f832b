/* export and import: materials as CSV.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "cmd/store.h"
#include "cmd/table.h"
#include "io/store_csv.h"

bool
cmd_export(struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[0];
	struct stored_list list = {0};
	if (args_value(args, "replace")->choice == 0 &&
	    access(path, F_OK) == 0) {
		error_set(error, ERROR_USAGE, "%s is there already", path);
		return error_hint(error, "replace=on writes over it");
	}
	bool ok = store_list(s->store, &list, error) &&
		  store_csv_save(&list, path, error);
	if (ok)
		session_note(s, "wrote %zu material%s of your own to %s",
		    list.n, list.n == 1 ? "" : "s", path);
	stored_list_free(&list);
	return ok;
}

/* All faults but the last are printed; that one is the error. */
static bool
tell_faults(
    struct session *s, const struct error_list *errors, struct error *error)
{
	for (size_t i = 0; i + 1 < errors->n && s->notes != NULL; i++)
		error_print(&errors->item[i], s->notes);
	*error = errors->item[errors->n - 1];
	if (errors->more > 0)
		session_note(s, "%zu more faults are not shown", errors->more);
	return false;
}

bool
cmd_import(struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[0];
	bool replace = args_value(args, "replace")->choice == 1;
	struct error_list *errors = xcalloc(1, sizeof *errors);
	struct stored_list there = {0}, list = {0};
	bool ok = store_list(s->store, &there, error);
	if (ok && !store_csv_read(path, replace ? NULL : &there, &list, errors))
		ok = tell_faults(s, errors, error);
	ok = ok && store_put(s->store, list.item, list.n, replace, error);
	if (ok)
		session_note(s, "took %zu material%s from %s", list.n,
		    list.n == 1 ? "" : "s", path);
	stored_list_free(&there);
	stored_list_free(&list);
	free(errors);
	return ok;
}
