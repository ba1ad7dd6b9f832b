/* Reads the parts of a divided run, and checks that they belong together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/shards.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "config.h"
#include "io/cells/textfile.h"

/* What commands write: the keys of their rows' source and remark, if they have
 * one, and of the n numbers; without keys these are the list "numbers". */
static const struct kind {
	const char *command, *source, *remark;
	size_t n;
	const char *key[PART_NUMBERS];
} KINDS[] = {
    {"calibrate", "provenance", "remark", 6,
	{"f_mat", "e0_min", "alpha", "misfit", "rmse_pct", "holdout_pct"}},
    {"validate", "source", NULL, PART_NUMBERS, {NULL}}};

static bool
refuse_non_parts_file(const char *path, struct error *error)
{
	return error_set_at(error, ERROR_DATA, path, 0, 0,
	    "expected what 'calibrate all part=I/N' or 'validate all part=I/N' "
	    "wrote as JSON\n"
	    "write parts with: calibrate all part=I/N > FILE.json");
}

static bool
read_part_row_from_json(json_t *o, const json_t *index, const struct kind *kind,
    struct part_row *row)
{
	const json_t *list = json_object_get(o, "numbers");
	if (!json_is_integer(index) ||
	    json_unpack(o, "{s:s, s:s}", "site", &row->site, kind->source,
		&row->source) != 0)
		return false;
	row->remark = NULL;
	if (kind->remark != NULL &&
	    json_unpack(o, "{s:s}", kind->remark, &row->remark) != 0)
		return false;
	row->index = (size_t)json_integer_value(index);
	for (size_t i = 0; i < kind->n; i++) {
		const json_t *value = kind->key[i] != NULL
					  ? json_object_get(o, kind->key[i])
					  : json_array_get(list, i);
		if (!json_is_number(value) && !json_is_null(value))
			return false;
		row->number[i] = json_is_null(value) ? (double)NAN
						     : json_number_value(value);
	}
	return true;
}

/* Refuses a part that a build with another format wrote, before its numbers are
 * read.  Parts had no format at first, which counts as 0. */
static bool
check_part_format(const struct part_file *part, struct error *error)
{
	const json_t *o = json_object_get(part->json, "part");
	json_int_t format = json_integer_value(json_object_get(o, "format"));
	const char *version = json_string_value(json_object_get(o, "version"));
	return version == NULL || format == PART_FORMAT ||
	       error_set_at(error, ERROR_DATA, part->path, 0, 0,
		   "tipspeed %s wrote this part in format %lld, but this build "
		   "(%s) reads format %d\n"
		   "make all parts, and collect them, with the same build",
		   version, (long long)format, PACKAGE_VERSION, PART_FORMAT);
}

static bool
read_part_from_json(struct part_file *part, struct parts *parts)
{
	json_int_t number, of, loaded, left_out = 0, each = 0;
	json_t *index, *rows;
	const struct kind *kind = KINDS;
	if (json_unpack(part->json,
		"{s:s, s:{s:s, s:s, s:s, s:I, s:I, s:I, s:o}, s:o,s?I, s?I}",
		"command", &part->command, "part", "sites", &part->sites,
		"version", &part->version, "options", &part->options, "number",
		&number, "of", &of, "loaded", &loaded, "index", &index, "rows",
		&rows, "left_out", &left_out, "each", &each) != 0)
		return false;
	size_t n = json_array_size(rows), all = parts->n_row;
	while (kind < KINDS + ARRAY_LEN(KINDS) &&
	       strcmp(kind->command, part->command) != 0)
		kind++;
	if (kind == KINDS + ARRAY_LEN(KINDS) || number < 1 || of < number ||
	    loaded < 0 || json_array_size(index) != n)
		return false;
	part->number = (size_t)number;
	part->of = (size_t)of;
	part->loaded = (size_t)loaded;
	part->left_out = (size_t)left_out;
	part->each = (size_t)each;
	parts->row = xrealloc(parts->row, all + n + 1, sizeof *parts->row);
	for (size_t i = 0; i < n; i++) {
		struct part_row *row = &parts->row[all + i];
		row->order = parts->n_row++;
		if (!read_part_row_from_json(json_array_get(rows, i),
			json_array_get(index, i), kind, row) ||
		    row->index >= part->loaded ||
		    row->index % part->of != part->number - 1)
			return false;
	}
	return true;
}

bool
parts_read_result_file(
    const char *path, struct parts *parts, struct error *error)
{
	const char *why;
	FILE *in = textfile_open(path, &why);
	if (in == NULL)
		return error_set_at(error, ERROR_SYSTEM, path, 0, 0,
		    "cannot be read: %s\nname the file of each part: collect "
		    "part1.json part2.json",
		    why);
	size_t before = parts->n;
	bool good = true;
	json_t *o;
	json_error_t about = {.line = 0};
	while (good &&
	       (o = json_loadf(in, JSON_DISABLE_EOF_CHECK, &about)) != NULL) {
		parts->part =
		    xrealloc(parts->part, parts->n + 1, sizeof *parts->part);
		struct part_file *part = &parts->part[parts->n++];
		*part = (struct part_file){.json = o, .path = path};
		if (!check_part_format(part, error)) {
			fclose(in);
			return false;
		}
		good = read_part_from_json(part, parts);
	}
	/* Only a line end may follow the last part. */
	good = good && parts->n > before &&
	       json_error_code(&about) == json_error_premature_end_of_input;
	bool read = !ferror(in);
	fclose(in);
	return (good && read) || refuse_non_parts_file(path, error);
}

void
parts_free(struct parts *parts)
{
	for (size_t k = 0; k < parts->n; k++)
		json_decref(parts->part[k].json);
	free(parts->part);
	free(parts->row);
}

static bool
check_parts_alike(
    const struct part_file *a, const struct part_file *b, struct error *error)
{
	const struct {
		const char *what, *in_a, *in_b;
	} same[] = {{"command", a->command, b->command},
	    {"version", a->version, b->version},
	    {"options", a->options, b->options}, {"sites", a->sites, b->sites}};
	for (size_t i = 0; i < ARRAY_LEN(same); i++)
		if (strcmp(same[i].in_a, same[i].in_b) != 0)
			return error_set_at(error, ERROR_DATA, b->path, 0, 0,
			    "expected the %s of %s (%s), got %s\n"
			    "make this part again as the others were made",
			    same[i].what, a->path, same[i].in_a, same[i].in_b);
	return (a->of == b->of && a->loaded == b->loaded) ||
	       error_set_at(error, ERROR_DATA, b->path, 0, 0,
		   "expected a part of %zu, as %s is, got one of %zu\n"
		   "make all parts with the same N in part=I/N",
		   a->of, a->path, b->of);
}

static bool
check_each_part_once(const struct parts *parts, struct error *error)
{
	size_t of = parts->part[0].of;
	FREED const char **path = xcalloc(of + 1, sizeof(*path));
	for (size_t k = 0; k < parts->n; k++) {
		const struct part_file *part = &parts->part[k];
		const char **at = &path[part->number];
		if (*at != NULL)
			return error_set_at(error, ERROR_DATA, part->path, 0, 0,
			    "part %zu of %zu is already in %s\nleave one out",
			    part->number, of, *at);
		*at = part->path;
	}
	for (size_t i = 1; i <= of; i++)
		if (path[i] == NULL)
			return error_set(error, ERROR_DATA,
			    "part %zu of %zu is missing\n"
			    "make it with: %s all part=%zu/%zu > FILE.json",
			    i, of, parts->part[0].command, i, of);
	return true;
}

static int
compare_part_rows(const void *a, const void *b)
{
	const struct part_row *p = a, *q = b;
	if (p->index != q->index)
		return p->index > q->index ? 1 : -1;
	return (p->order > q->order) - (p->order < q->order);
}

bool
parts_check_and_sort(struct parts *parts, struct error *error)
{
	for (size_t k = 0; k < parts->n; k++)
		if (!check_parts_alike(&parts->part[0], &parts->part[k], error))
			return false;
	if (parts->n_row > 1)
		qsort(parts->row, parts->n_row, sizeof *parts->row,
		    compare_part_rows);
	return check_each_part_once(parts, error);
}
