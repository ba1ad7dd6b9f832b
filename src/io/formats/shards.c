/* Reads the parts of a divided run and checks that they belong together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/shards.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* What commands write, and the second text of their rows; keys of the numbers,
 * or NULL for a list. */
static const struct kind {
	const char *command, *text, *number[PART_NUMBERS];
} KINDS[] = {
    {"calibrate", "remark",
	{"f_mat", "e0_min", "alpha", "misfit", "rmse_pct", "holdout_pct"}},
    {"validate", "source", {NULL}}};

static bool
refuse_parts_file(const char *path, struct error *error)
{
	return error_at(error, ERROR_DATA, path, 0, 0,
	    "expected what 'calibrate all part=I/N' or 'validate all part=I/N' "
	    "wrote as JSON\n"
	    "write parts with: calibrate all part=I/N > FILE.json");
}

/* Returns number i of a row, from its list of numbers or by key.  *there: it
 * must be present. */
static const json_t *
shards_number_in_row(
    const json_t *row, const struct kind *kind, size_t i, bool *there)
{
	const char *key = kind->number[i];
	*there = kind->number[0] == NULL || key != NULL;
	return kind->number[0] == NULL
		   ? json_array_get(json_object_get(row, "numbers"), i)
	       : key != NULL ? json_object_get(row, key)
			     : NULL;
}

static bool
read_site_of_shard_row(json_t *row, const json_t *index,
    const struct kind *kind, struct part_site *site)
{
	const char *name, *text;
	if (!json_is_integer(index) || json_unpack(row, "{s:s, s:s}", "site",
					   &name, kind->text, &text) != 0)
		return false;
	bool good = true, there;
	site->index = (size_t)json_integer_value(index);
	site->text[0] = xstrdup(name);
	site->text[1] = xstrdup(text);
	for (size_t i = 0; i < PART_NUMBERS; i++) {
		const json_t *value =
		    shards_number_in_row(row, kind, i, &there);
		site->number[i] =
		    json_is_number(value) ? json_number_value(value) : NAN;
		good = good &&
		       (!there || json_is_number(value) || json_is_null(value));
	}
	return good;
}

static const struct kind *
shards_kind_of_command(const char *command)
{
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++)
		if (strcmp(KINDS[i].command, command) == 0)
			return &KINDS[i];
	return NULL;
}

static bool
read_part_from_json(json_t *o, const char *path, struct part_file *part)
{
	const char *command, *sites, *version, *options;
	json_int_t number, of, loaded, left_out = 0, each = 0;
	json_t *index, *rows;
	*part = (struct part_file){.path = xstrdup(path)};
	if (json_unpack(o,
		"{s:s, s:{s:s, s:s, s:s, s:I, s:I, s:I, s:o}, s:o,"
		"s?I, s?I}",
		"command", &command, "part", "sites", &sites, "version",
		&version, "options", &options, "number", &number, "of", &of,
		"loaded", &loaded, "index", &index, "rows", &rows, "left_out",
		&left_out, "each", &each) != 0)
		return false;
	const struct kind *kind = shards_kind_of_command(command);
	if (kind == NULL || number < 0 || of < 1 || loaded < 0 ||
	    json_array_size(index) != json_array_size(rows))
		return false;
	part->command = xstrdup(command);
	part->sites = xstrdup(sites);
	part->version = xstrdup(version);
	part->options = xstrdup(options);
	part->number = (size_t)number;
	part->of = (size_t)of;
	part->loaded = (size_t)loaded;
	part->left_out = (size_t)left_out;
	part->each = (size_t)each;
	part->site = xcalloc(json_array_size(rows) + 1, sizeof *part->site);
	for (size_t i = 0; i < json_array_size(rows); i++) {
		struct part_site *site = &part->site[part->n++];
		if (!read_site_of_shard_row(json_array_get(rows, i),
			json_array_get(index, i), kind, site) ||
		    site->index >= part->loaded ||
		    site->index % part->of != part->number - 1)
			return false;
	}
	return true;
}

bool
parts_read_file(const char *path, struct parts *parts, struct error *error)
{
	FILE *in = fopen(path, "r");
	if (in == NULL)
		return error_at(error, ERROR_SYSTEM, path, 0, 0,
		    "cannot be read: %s\ncheck the name", strerror(errno));
	size_t before = parts->n;
	bool good = true;
	json_t *o;
	json_error_t about = {.line = 0};
	while (good &&
	       (o = json_loadf(in, JSON_DISABLE_EOF_CHECK, &about)) != NULL) {
		parts->part =
		    xrealloc(parts->part, parts->n + 1, sizeof *parts->part);
		good = read_part_from_json(o, path, &parts->part[parts->n++]);
		json_decref(o);
	}
	/* After the last there is nothing but its end of line. */
	good = good && parts->n > before &&
	       json_error_code(&about) == json_error_premature_end_of_input;
	bool read = !ferror(in);
	fclose(in);
	return (good && read) || refuse_parts_file(path, error);
}

void
parts_free(struct parts *parts)
{
	for (size_t k = 0; k < parts->n; k++) {
		struct part_file *part = &parts->part[k];
		for (size_t i = 0; i < part->n; i++) {
			free(part->site[i].text[0]);
			free(part->site[i].text[1]);
		}
		free(part->site);
		free(part->path);
		free(part->command);
		free(part->sites);
		free(part->version);
		free(part->options);
	}
	free(parts->part);
}

static bool
check_part_texts_same(const struct part_file *a, const struct part_file *b,
    const char *what, const char *in_a, const char *in_b, struct error *error)
{
	return strcmp(in_a, in_b) == 0 ||
	       error_at(error, ERROR_DATA, b->path, 0, 0,
		   "expected the %s of %s (%s), got %s\n"
		   "make this part again as the others were made",
		   what, a->path, in_a, in_b);
}

static bool
check_options_same(
    const struct part_file *a, const struct part_file *b, struct error *error)
{
	if (!check_part_texts_same(
		a, b, "command", a->command, b->command, error) ||
	    !check_part_texts_same(
		a, b, "version", a->version, b->version, error) ||
	    !check_part_texts_same(
		a, b, "options", a->options, b->options, error) ||
	    !check_part_texts_same(a, b, "sites", a->sites, b->sites, error))
		return false;
	return (a->of == b->of && a->loaded == b->loaded) ||
	       error_at(error, ERROR_DATA, b->path, 0, 0,
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
			return error_at(error, ERROR_DATA, part->path, 0, 0,
			    "part %zu of %zu is in %s already\nleave one out",
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

bool
parts_check_agree(const struct parts *parts, struct error *error)
{
	for (size_t k = 0; k < parts->n; k++) {
		const struct part_file *part = &parts->part[k];
		if (part->number < 1 || part->number > part->of)
			return refuse_parts_file(part->path, error);
		if (!check_options_same(&parts->part[0], part, error))
			return false;
	}
	return check_each_part_once(parts, error);
}
