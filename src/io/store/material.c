/* Describes a material's fields in one table, which the store, its CSV form and
 * the commands use; reads Table 3.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/material.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/datetime.h"
#include "io/cells/number.h"
#include "io/cells/textfile.h"
#include "io/sitefile/units.h"

/* The rows of data/table3.csv, without remarks, made at build time. */
extern const char *const TABLE3_TEXT[];

#define AT(member) offsetof(struct material, member)
#define BEYOND 1e300

const struct field FIELDS[FIELD_COUNT] = {
    {"name", FIELD_TEXT, AT(name), true, NULL, 0, 0},
    {"site", FIELD_TEXT, AT(site), true, NULL, 0, 0},
    {"rock", FIELD_TEXT, AT(rock), false, NULL, 0, 0},
    {"top_size_mm", FIELD_NUMBER, AT(top_size_mm), false, NULL, SIZE_LEAST_MM,
	SIZE_MOST_MM},
    {"machine", FIELD_TEXT, AT(machine), false, NULL, 0, 0},
    {"provenance", FIELD_TEXT, AT(provenance), false, NULL, 0, 0},
    {"site_digest", FIELD_TEXT, AT(site_digest), false, NULL, 0, 0},
    {"origin", FIELD_TEXT, AT(origin), true, "fit hand", 0, 0},
    {"model", FIELD_MODEL, AT(params), true, NULL, 0, 0},
    {"params", FIELD_PARAMS, AT(params), true, NULL, 0, 0},
    {"method", FIELD_TEXT, AT(method), true, "continuous classes", 0, 0},
    {"appearance", FIELD_TEXT, AT(appearance), true,
	"ratio progeny_mm parent_mm", 0, 0},
    {"k", FIELD_NUMBER, AT(k), true, NULL, 1e-3, 1e3},
    {"misfit", FIELD_NUMBER, AT(misfit), false, NULL, 0, BEYOND},
    {"rmse_pct", FIELD_NUMBER, AT(rmse_pct), false, NULL, 0, 100},
    {"holdout_pct", FIELD_NUMBER, AT(holdout_pct), false, NULL, 0, 100},
    {"seed", FIELD_WHOLE, AT(seed), false, NULL, 0, 0},
    {"options", FIELD_TEXT, AT(options), false, NULL, 0, 0},
    {"generations", FIELD_WHOLE, AT(generations), false, NULL, 0, 0},
    {"stop", FIELD_TEXT, AT(stop), false, "tolerance stall generations stopped",
	0, 0},
    {"train_mps", FIELD_TEXT, AT(train_mps), false, NULL, 0, 0},
    {"date", FIELD_TEXT, AT(date), false, NULL, 0, 0},
    {"note", FIELD_TEXT, AT(note), false, NULL, 0, 0},
    {"version", FIELD_TEXT, AT(version), false, NULL, 0, 0},
    {"basis", FIELD_TEXT, AT(basis), false, NULL, 0, 0},
};

static void *
material_field_pointer(
    const struct material *m, const struct field *f, enum field_kind kind)
{
	assert(f->kind == kind);
	(void)kind;
	return (void *)((uintptr_t)m + f->offset);
}

char **
material_text_field_pointer(const struct material *m, const struct field *f)
{
	return material_field_pointer(m, f, FIELD_TEXT);
}

double *
material_number_field_pointer(const struct material *m, const struct field *f)
{
	return material_field_pointer(m, f, FIELD_NUMBER);
}

int64_t *
material_integer_field_pointer(const struct material *m, const struct field *f)
{
	return material_field_pointer(m, f, FIELD_WHOLE);
}

struct material
material_make_empty(void)
{
	struct material m = {0};
	for (size_t i = 0; i < FIELD_COUNT; i++)
		material_set_field(&m, &FIELDS[i], "");
	return m;
}

void
material_free(struct material *m)
{
	for (size_t i = 0; i < FIELD_COUNT; i++)
		if (FIELDS[i].kind == FIELD_TEXT)
			free(*material_text_field_pointer(m, &FIELDS[i]));
	free(m->feed_source);
}

void
material_list_free(struct material_list *list)
{
	for (size_t i = 0; i < list->n; i++)
		material_free(&list->item[i]);
	free(list->item);
	*list = (struct material_list){0};
}

void
material_list_add(struct material_list *list, struct material m)
{
	list->item = xgrow_by_one(list->item, list->n, sizeof m);
	list->item[list->n++] = m;
}

const struct material *
material_find(const struct material_list *list, const char *name)
{
	for (size_t i = 0; i < list->n; i++)
		if (text_is_same_folded(list->item[i].name, name))
			return &list->item[i];
	return NULL;
}

/* Returns the number of the model's parameters; 0 if the model is unknown. */
static size_t
count_model_params(const struct params *p)
{
	return p->breakage < breakage_count_models()
		   ? breakage_model_of_params(p)->n
		   : 0;
}

static char *
params_to_text(const struct params *p)
{
	char *text = xstrdup(""), number[32];
	for (size_t j = 0; j < count_model_params(p); j++)
		xappend_to_list(&text, " ", "%s=%s",
		    breakage_model_of_params(p)->parameter[j].name,
		    text_shortest_exact_number(p->at[j], number));
	return text;
}

/* Returns the number after "name=" in a text of several such pairs, or NAN. */
static double
parse_param_in_text(const char *text, const char *name)
{
	size_t n = strlen(name);
	while (*text != '\0') {
		size_t word = strcspn(text, " ");
		if (word > n && text[n] == '=' && strncmp(text, name, n) == 0) {
			double value = NAN;
			FREED char *number =
			    xstrndup(text + n + 1, word - n - 1);
			return text_parse_number(number, &value) ? value : NAN;
		}
		text += word + (text[word] == ' ');
	}
	return NAN;
}

void
material_set_field(struct material *m, const struct field *f, const char *text)
{
	uint64_t whole;
	double number;
	switch (f->kind) {
	case FIELD_TEXT:
		xfree_and_set(material_text_field_pointer(m, f), xstrdup(text));
		break;
	case FIELD_NUMBER:
		*material_number_field_pointer(m, f) =
		    text_parse_number(text, &number) ? number : (double)NAN;
		break;
	case FIELD_WHOLE:
		*material_integer_field_pointer(m, f) =
		    text_parse_whole_number(text, &whole) && whole <= INT64_MAX
			? (int64_t)whole
			: -1;
		break;
	case FIELD_MODEL:
		m->params.breakage = breakage_find_by_name(text);
		break;
	case FIELD_PARAMS:
		memset(m->params.at, 0, sizeof m->params.at);
		for (size_t j = 0; j < count_model_params(&m->params); j++)
			m->params.at[j] = parse_param_in_text(
			    text, breakage_model_of_params(&m->params)
				      ->parameter[j]
				      .name);
		break;
	}
}

char *
material_field_to_text(const struct material *m, const struct field *f)
{
	char number[32];
	const struct params *params = &m->params;
	if (f->kind == FIELD_MODEL)
		return xstrdup(count_model_params(params) > 0
				   ? breakage_model_of_params(params)->name
				   : "");
	if (f->kind == FIELD_PARAMS)
		return params_to_text(params);
	if (f->kind == FIELD_TEXT)
		return xstrdup(*material_text_field_pointer(m, f));
	if (f->kind == FIELD_NUMBER)
		return xstrdup(
		    isfinite(*material_number_field_pointer(m, f))
			? text_shortest_exact_number(
			      *material_number_field_pointer(m, f), number)
			: "");
	int64_t whole = *material_integer_field_pointer(m, f);
	return whole < 0 ? xstrdup("") : xasprintf("%" PRId64, whole);
}

void
material_visit_fields(
    const struct material *m, material_take_field *take, void *data)
{
	char number[32];
	for (size_t i = 0; i < FIELD_COUNT; i++) {
		const struct params *p = &m->params;
		if (FIELDS[i].kind != FIELD_PARAMS) {
			FREED char *text =
			    material_field_to_text(m, &FIELDS[i]);
			take(data, FIELDS[i].name, text);
			continue;
		}
		for (size_t j = 0; j < count_model_params(p); j++)
			take(data,
			    breakage_model_of_params(p)->parameter[j].name,
			    isfinite(p->at[j])
				? text_shortest_exact_number(p->at[j], number)
				: "");
	}
}

/* Adds a field to the digest.  Omits empty fields and the name of the paper's
 * model, so that a row keeps its digest when a later schema adds a column. */
static void
add_field_to_digest(void *data, const char *name, const char *text)
{
	uint64_t *h = data;
	if (text[0] == '\0' || strcmp(text, BREAKAGES[0]->name) == 0)
		return;
	*h = text_fnv1a_digest(*h, name, strlen(name) + 1);
	*h = text_fnv1a_digest(*h, text, strlen(text) + 1);
}

uint64_t
material_compute_digest(const struct material *m)
{
	uint64_t h = TEXT_DIGEST_START;
	material_visit_fields(m, add_field_to_digest, &h);
	return h;
}

struct model_settings
material_model_settings(const struct material *m)
{
	struct model_settings s = model_settings_default();
	if (strcmp(m->method, "classes") == 0)
		s.method = METHOD_CLASSES;
	if (strcmp(m->appearance, "progeny_mm") == 0)
		s.appearance = APPEARANCE_PROGENY_MM;
	else if (strcmp(m->appearance, "parent_mm") == 0)
		s.appearance = APPEARANCE_PARENT_MM;
	s.k = m->k;
	return s;
}

static const char TABLE3[] = "table3/";

bool
material_is_table3_name(const char *name)
{
	FREED char *folded = text_fold_case_and_accents(name);
	return strncmp(folded, TABLE3, strlen(TABLE3)) == 0;
}

enum { MOST_NAME = 60 };

/* Returns the index of the first parameter outside its limits, or the number of
 * parameters. */
static size_t
index_of_impossible_param(const struct params *p)
{
	size_t j = 0;
	while (j < count_model_params(p) &&
	       p->at[j] >= breakage_model_of_params(p)->parameter[j].least &&
	       p->at[j] <= breakage_model_of_params(p)->parameter[j].most)
		j++;
	return j;
}

char *
material_valid_values_text(const struct material *m, const struct field *f)
{
	const struct params *p = &m->params;
	if (f->kind == FIELD_MODEL) {
		char *names = xstrdup(tr("one of:"));
		for (size_t i = 0; i < breakage_count_models(); i++)
			xappend(&names, " %s", BREAKAGES[i]->name);
		return names;
	}
	if (f->kind == FIELD_PARAMS &&
	    index_of_impossible_param(p) < count_model_params(p)) {
		const struct param_info *info =
		    &breakage_model_of_params(p)
			 ->parameter[index_of_impossible_param(p)];
		return xasprintf(tr("a number from %g to %g for %s"),
		    info->least, info->most, info->name);
	}
	if (f->choices != NULL)
		return xasprintf(tr("one of: %s"), f->choices);
	if (f == &FIELDS[FIELD_OF_NAME])
		return xasprintf(
		    tr("a name of 1 to %d bytes on one line, without quotes "
		       "and not beginning with # or %s"),
		    (int)MOST_NAME, TABLE3);
	if (f->kind == FIELD_NUMBER)
		return xasprintf(tr("a number from %g to %g for %s"), f->least,
		    f->most, f->name);
	return xstrdup(f->kind == FIELD_WHOLE ? tr("a whole number below 2^63")
		       : strcmp(f->name, "date") == 0
			   ? tr("a date such as 2026-11-21")
			   : tr("text without control characters"));
}

char *
material_faulty_value_text(const struct material *m, const struct field *f)
{
	const struct params *p = &m->params;
	if (f->kind == FIELD_NUMBER)
		return xasprintf("%g", *material_number_field_pointer(m, f));
	if (f->kind == FIELD_PARAMS &&
	    index_of_impossible_param(p) < count_model_params(p))
		return xasprintf("%g", p->at[index_of_impossible_param(p)]);
	return material_field_to_text(m, f);
}

bool
material_is_field_valid(const struct material *m, const struct field *f)
{
	size_t choice;
	if (f->kind == FIELD_MODEL)
		return m->params.breakage < breakage_count_models();
	if (f->kind == FIELD_PARAMS)
		return index_of_impossible_param(&m->params) ==
		       count_model_params(&m->params);
	if (f->kind == FIELD_WHOLE)
		return *material_integer_field_pointer(m, f) >= -1;
	if (f->kind == FIELD_NUMBER) {
		double value = *material_number_field_pointer(m, f);
		return isnan(value) ? !f->needed
				    : value >= f->least && value <= f->most;
	}
	const char *text = *material_text_field_pointer(m, f);
	if (text[0] == '\0')
		return !f->needed;
	if (f->choices != NULL)
		return text_find_word_in_list(f->choices, text, &choice);
	if (f == &FIELDS[FIELD_OF_NAME])
		return material_check_name(text, NULL);
	return material_is_text_printable(text) &&
	       (strcmp(f->name, "date") != 0 || datetime_is_iso_date(text));
}

bool
material_check_name(const char *name, struct error *error)
{
	FREED char *copy = xstrdup(name);
	bool trimmed = strlen(text_trim(copy)) == strlen(name);
	if (material_is_table3_name(name))
		return error_set(error, ERROR_USAGE,
		    "names that begin with %s are those of the paper's Table "
		    "3, which does not change\nchoose another name",
		    TABLE3);
	if (name[0] != '\0' && name[0] != '#' && strlen(name) <= MOST_NAME &&
	    trimmed && material_is_text_printable(name) &&
	    strchr(name, '"') == NULL)
		return true;
	return error_set(error, ERROR_USAGE,
	    "expected a name of 1 to %d bytes on one line, without quotes and "
	    "not beginning with #, got '%.60s'",
	    (int)MOST_NAME, name);
}

bool
material_is_table3(const struct material *m)
{
	return strcmp(m->origin, "table3") == 0;
}

bool
material_is_text_printable(const char *text)
{
	const char *p = text;
	while ((unsigned char)*p >= ' ' && *p != 0x7F)
		p++;
	return *p == '\0' && text_is_utf8(text, (size_t)(p - text));
}

/* Reads a row of a table such as data/table3.csv.  Returns false if the row
 * shows that the file is of another kind. */
static bool
material_read_table3_row(
    struct sheet *sheet, const struct row *row, struct material_list *list)
{
	enum { ROCK, SITE, TOP, F_MAT, FEED_SOURCE, E0_MIN, ALPHA, CELLS };
	if (row->n != CELLS)
		return sheet_report_fault(sheet, row->cell[0],
		    "expected %d cells, got %zu\n"
		    "use the columns of data/table3.csv; read a site file with "
		    "load",
		    (int)CELLS, row->n);
	struct material m = material_make_empty();
	/* for beta, which is not in the table */
	m.params = params_start_values(0);
	const struct {
		double *number, most;
	} column[CELLS] = {[TOP] = {&m.top_size_mm, SIZE_MOST_MM},
	    [F_MAT] = {&m.params.f_mat, F_MAT_MOST},
	    [E0_MIN] = {&m.params.e0_min, E0_MIN_MOST},
	    [ALPHA] = {&m.params.alpha, ALPHA_MOST}};
	for (size_t i = 0; i < CELLS; i++) {
		double *number = column[i].number;
		if (number == NULL)
			continue;
		FREED char *wanted =
		    xasprintf(tr("a number above 0, up to %g"), column[i].most);
		if (number_read_cell(sheet, row->cell[i], wanted, number) &&
		    !(*number > 0 && *number <= column[i].most))
			sheet_report_expected(
			    sheet, row->cell[i], wanted, NULL);
	}
	xfree_and_set(&m.rock, xstrdup(row->cell[ROCK].text));
	xfree_and_set(&m.site, xstrdup(row->cell[SITE].text));
	m.feed_source = xstrdup(row->cell[FEED_SOURCE].text);
	material_list_add(list, m);
	return true;
}

/* Reads the rows of a text, and frees it.  Returns false after a fault. */
static bool
parse_table3_text(const char *path, char *text, struct material_list *list,
    struct error_list *errors)
{
	if (text == NULL)
		return false;
	const struct sheet_limits most = {.rows = 1000};
	struct sheet *sheet = sheet_new_from_text(path, text, most, errors);
	number_detect_decimal_sign(sheet);
	size_t i = 1; /* after the heading */
	while (i < sheet->n_row &&
	       material_read_table3_row(sheet, &sheet->row[i], list))
		i++;
	if (i == 1 && sheet->n_fault == 0)
		sheet_report_fault(sheet, (struct cell){0},
		    "expected rows of materials, got none\n"
		    "data/table3.csv shows their form");
	bool good = sheet->n_fault == 0;
	sheet_free(sheet);
	free(text);
	return good;
}

bool
material_read_table3_file(
    const char *path, struct material_list *list, struct error_list *errors)
{
	return parse_table3_text(
	    path, textfile_read(path, TEXTFILE_SHEET, errors), list, errors);
}

/* Returns the name of row i: that of its site; with the top size if several
 * sites have that name; and with a number if several also have that size. */
static char *
material_make_table3_name(const struct material_list *rows,
    const struct material_list *list, size_t i)
{
	const struct material *row = &rows->item[i];
	FREED char *slug = text_slug(row->site);
	bool shared = false;
	for (size_t j = 0; j < rows->n; j++)
		shared =
		    shared || (j != i && text_is_same_folded(
					     rows->item[j].site, row->site));
	FREED char *stem =
	    shared ? xasprintf("%s%s/%g", TABLE3, slug, row->top_size_mm)
		   : xasprintf("%s%s", TABLE3, slug);
	char *name = xstrdup(stem);
	for (int n = 2; material_find(list, name) != NULL; n++)
		xfree_and_set(&name, xasprintf("%s/%d", stem, n));
	return name;
}

void
material_add_table3_to_list(struct material_list *list)
{
	struct material_list rows = {0};
	struct error_list none = {0};
	bool good = parse_table3_text(
	    "Table 3", textfile_join_built_in_lines(TABLE3_TEXT), &rows, &none);
	/* The table is part of the program, and tests read all of it. */
	assert(good);
	(void)good;
	for (size_t i = 0; i < rows.n; i++) {
		struct material m = rows.item[i];
		xfree_and_set(
		    &m.name, material_make_table3_name(&rows, list, i));
		xfree_and_set(&m.machine, xstrdup("Metso Barmac 5100 SE"));
		xfree_and_set(&m.provenance,
		    xasprintf("measured by the paper's authors and not public; "
			      "Table 3 of Grunditz et al. (2021), %s; beta is "
			      "not printed: default",
			m.feed_source));
		xfree_and_set(&m.origin, xstrdup("table3"));
		xfree_and_set(&m.method, xstrdup("continuous"));
		xfree_and_set(&m.appearance, xstrdup("ratio"));
		xfree_and_set(&m.train_mps, xstrdup("69,79"));
		m.k = 1;
		material_list_add(list, m);
	}
	free(rows.item);
}
