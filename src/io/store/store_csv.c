/* Writes materials as CSV and reads them back.  sheet.c handles quotes, line
 * numbers and decimal signs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/store_csv.h"

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/cells/sheet.h"
#include "io/cells/textfile.h"
#include "io/cells/number.h"

/* A column: a field of FIELDS, or a parameter of some model. */
struct column {
	const struct field *field; /* NULL for a parameter */
	const struct param_info *param;
	size_t at; /* counted from 0; SIZE_MAX if missing */
};

enum { COLUMNS = 64 };

static bool
has_column_of_param(const struct column *column, size_t n, const char *name)
{
	for (size_t i = 0; i < n; i++)
		if (column[i].param != NULL &&
		    strcmp(column[i].param->name, name) == 0)
			return true;
	return false;
}

/* Lists the columns: one for each field, and one for each parameter of the
 * paper's model and of the models marked in model.  Returns their number. */
static size_t
list_store_csv_columns(const bool *model, struct column column[static COLUMNS])
{
	size_t n = 0;
	for (size_t f = 0; f < FIELD_COUNT; f++) {
		if (FIELDS[f].kind != FIELD_PARAMS) {
			column[n++] =
			    (struct column){&FIELDS[f], NULL, SIZE_MAX};
			continue;
		}
		for (size_t m = 0; m < breakage_count_models(); m++)
			for (size_t j = 0; j < BREAKAGES[m]->n; j++) {
				const struct param_info *p =
				    &BREAKAGES[m]->parameter[j];
				if ((m == 0 || model[m]) &&
				    !has_column_of_param(column, n, p->name))
					column[n++] =
					    (struct column){NULL, p, SIZE_MAX};
			}
	}
	return n;
}

static const char *
store_csv_column_name(const struct column *c)
{
	return c->field != NULL ? c->field->name : c->param->name;
}

static char *
material_csv_column_text(const struct column *c, const struct material *m)
{
	char number[32];
	if (c->field != NULL)
		return material_field_to_text(m, c->field);
	double value = params_value_by_name(&m->params, c->param->name);
	return xstrdup(
	    isfinite(value) ? text_shortest_exact_number(value, number) : "");
}

static void
write_materials_csv(const void *data, FILE *out)
{
	const struct material_list *list = data;
	struct column column[COLUMNS];
	FREED bool *model = xcalloc(breakage_count_models(), sizeof *model);
	for (size_t i = 0; i < list->n; i++)
		model[list->item[i].params.breakage] = true;
	size_t n = list_store_csv_columns(model, column);
	for (size_t c = 0; c < n; c++)
		fprintf(out, "%s%s", c > 0 ? "," : "",
		    store_csv_column_name(&column[c]));
	fputc('\n', out);
	for (size_t i = 0; i < list->n; i++) {
		for (size_t c = 0; c < n; c++) {
			FREED char *text = material_csv_column_text(
			    &column[c], &list->item[i]);
			if (c > 0)
				fputc(',', out);
			text_write_csv_cell(text, ',', out);
		}
		fputc('\n', out);
	}
}

bool
store_csv_write_file(
    const struct material_list *list, const char *path, struct error *error)
{
	return file_replace_using_writer(
	    path, FILE_SHARED, write_materials_csv, list, error);
}

/* True if a file must have the column.  Old exports have neither model nor
 * basis, and each model has its own parameters. */
static bool
is_required_csv_column(const struct column *c)
{
	if (c->field != NULL)
		return c->field->kind != FIELD_MODEL &&
		       strcmp(c->field->name, "basis") != 0;
	return breakage_parameter_index(BREAKAGES[0], c->param->name) <
	       BREAKAGES[0]->n;
}

static void
find_export_columns_in_heading(
    struct sheet *sheet, struct column *column, size_t n)
{
	const struct row *head = &sheet->row[0];
	bool other_model = false;
	for (size_t i = 0; i < head->n; i++) {
		struct cell cell = head->cell[i];
		size_t c = 0;
		while (c < n && !text_is_same_folded(cell.text,
				    store_csv_column_name(&column[c])))
			c++;
		if (c == n)
			sheet_report_expected(sheet, cell,
			    "the name of a column of 'export'",
			    "use the columns that 'export' writes; load reads "
			    "site files");
		else if (column[c].at != SIZE_MAX)
			sheet_report_fault(sheet, cell,
			    "duplicate column: %s\n"
			    "remove one of the two",
			    cell.text);
		else
			column[c].at = i;
		other_model =
		    other_model || (c < n && column[c].field != NULL &&
				       column[c].field->kind == FIELD_MODEL);
	}
	/* A file of another kind lacks most columns; report only the name. */
	bool other = column[0].at == SIZE_MAX;
	for (size_t c = 0; c < (other ? 1 : n); c++)
		if (column[c].at == SIZE_MAX &&
		    is_required_csv_column(&column[c]) &&
		    (column[c].field != NULL || !other_model))
			sheet_report_fault(sheet, row_cell_at(head, head->n),
			    "expected a column %s, got none\n"
			    "use the columns that 'export' writes",
			    store_csv_column_name(&column[c]));
}

static const char EMPTY[] = N_("expected %s, got an empty cell\n"
			       "fill it, or remove the row");

static void
parse_material_param_cell(struct sheet *sheet, struct cell cell,
    const struct param_info *info, struct material *m)
{
	double value;
	FREED char *wanted = xasprintf(tr("a number from %g to %g for %s"),
	    info->least, info->most, info->name);
	size_t j = breakage_parameter_index(
	    breakage_model_of_params(&m->params), info->name);
	if (cell.text[0] == '\0')
		sheet_report_fault(sheet, cell, EMPTY, info->name);
	else if (number_read_cell(sheet, cell, wanted, &value)) {
		m->params.at[j] = value;
		if (value < info->least || value > info->most)
			sheet_report_expected(sheet, cell, wanted, NULL);
	}
}

static void
parse_material_field_cell(struct sheet *sheet, struct cell cell,
    const struct field *f, struct material *m)
{
	double number;
	if (cell.text[0] == '\0') {
		if (f->needed)
			sheet_report_fault(sheet, cell, EMPTY, f->name);
		return;
	}
	FREED char *wanted = material_valid_values_text(m, f);
	if (f->kind != FIELD_NUMBER)
		material_set_field(m, f, cell.text);
	else if (number_read_cell(sheet, cell, wanted, &number))
		*material_number_field_pointer(m, f) = number;
	else
		return;
	bool whole = f->kind != FIELD_WHOLE ||
		     *material_integer_field_pointer(m, f) >= 0;
	if (!whole || !material_is_field_valid(m, f))
		sheet_report_expected(sheet, cell, wanted, NULL);
}

/* Reports names that occur twice, or are in the store already (there).  list:
 * the materials of the rows after the heading; column: that of their names. */
static void
check_material_names_unique(struct sheet *sheet, size_t column,
    const struct material_list *there, const struct material_list *list)
{
	/* Folded names; true means in the store. */
	json_t *known = json_object();
	for (size_t i = 0; there != NULL && i < there->n; i++) {
		FREED char *fold =
		    text_fold_case_and_accents(there->item[i].name);
		json_object_set_new_nocheck(known, fold, json_true());
	}
	for (size_t i = 0; i < list->n; i++) {
		FREED char *fold =
		    text_fold_case_and_accents(list->item[i].name);
		const json_t *same = json_object_get(known, fold);
		struct cell cell = row_cell_at(&sheet->row[1 + i], column);
		if (json_is_false(same))
			sheet_report_fault(sheet, cell,
			    "duplicate name: %.60s\n"
			    "leave out one of the rows, or rename it",
			    cell.text);
		else if (json_is_true(same))
			sheet_report_fault(sheet, cell,
			    "expected a new name, but the store already has "
			    "'%.60s'\n"
			    "use replace=on to replace it",
			    cell.text);
		json_object_set_new_nocheck(known, fold, json_false());
	}
	json_decref(known);
}

/* Reads a row.  FIELDS has the model before its parameters, which depend on
 * it. */
static void
store_csv_read_row(struct sheet *sheet, const struct row *row,
    const struct column *column, size_t n, struct material_list *list)
{
	struct material m = material_make_empty();
	if (row->n > sheet->row[0].n)
		sheet_report_fault(sheet, row->cell[sheet->row[0].n],
		    "expected %zu cells, got more\n"
		    "quote text that contains the separator",
		    sheet->row[0].n);
	m.params = (struct params){0};
	for (size_t c = 0; c < n; c++) {
		struct cell cell = row_cell_at(row, column[c].at);
		const struct param_info *param = column[c].param;
		if (column[c].at == SIZE_MAX && column[c].field != NULL)
			continue;
		if (column[c].field != NULL)
			parse_material_field_cell(
			    sheet, cell, column[c].field, &m);
		else if (m.params.breakage < breakage_count_models() &&
			 !isnan(params_value_by_name(&m.params, param->name)))
			parse_material_param_cell(sheet, cell, param, &m);
	}
	material_list_add(list, m);
}

bool
store_csv_read_file(const char *path, const struct material_list *there,
    struct material_list *list, struct error_list *errors)
{
	FREED char *text = textfile_read(path, TEXTFILE_OWN, errors);
	if (text == NULL)
		return false;
	/* The program itself may have written lines of any length. */
	size_t room = strlen(text) + 1;
	const struct sheet_limits most = {.rows = room, .bytes = room};
	struct sheet *sheet = sheet_new_from_text(path, text, most, errors);
	number_detect_decimal_sign(sheet);
	struct column column[COLUMNS];
	FREED bool *all = xcalloc(breakage_count_models(), sizeof *all);
	memset(all, true, breakage_count_models() * sizeof *all);
	size_t n = list_store_csv_columns(all, column);
	if (sheet->n_row > 0)
		find_export_columns_in_heading(sheet, column, n);
	const struct cell start = {.line = 1, .column = 1};
	if (sheet->n_row < 2 && sheet->n_fault == 0)
		sheet_report_fault(sheet, start,
		    tr_n("expected a line of column names and a line for each "
			 "material, got %zu line",
			"expected a line of column names and a line for each "
			"material, got %zu lines",
			sheet->n_row),
		    sheet->n_row);
	bool head = sheet->n_fault == 0;
	for (size_t i = 1;
	     head && i < sheet->n_row && !error_is_stop_requested(errors); i++)
		store_csv_read_row(sheet, &sheet->row[i], column, n, list);
	if (head && !errors->stopped)
		check_material_names_unique(sheet, column[0].at, there, list);
	bool ok = sheet->n_fault == 0 && !errors->stopped;
	sheet_free(sheet);
	return ok;
}
