/* Writes and reads the basis of a calibration as text: a line
 * "name=number,number name=.. " for the fit, a line for each thing that was
 * assumed about the sheet, an empty line, and the sheets, separated by an empty
 * line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/basis.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/search/misfit.h"
#include "io/sitefile/site_read.h"
#include "io/sitefile/site_write.h"

enum kind { REAL, COUNT, FLAG };

/* The numbers of a basis, n under each name. */
static const struct item {
	const char *name;
	enum kind kind;
	size_t offset, n;
} ITEMS[] = {{"rmse", REAL, offsetof(struct fit_record, fit.rmse), 1},
    {"feed_misfit", REAL, offsetof(struct fit_record, fit.feed_misfit), 1},
    {"passings", COUNT, offsetof(struct fit_record, fit.n_residual), 1},
    {"cells", COUNT, offsetof(struct fit_record, fit.cells), 1},
    {"searched", COUNT, offsetof(struct fit_record, fit.parameters), 1},
    {"on_bound", FLAG, offsetof(struct fit_record, fit.on_bound), PARAMS_MOST},
    {"flat", REAL, offsetof(struct fit_record, fit.flat.part), PARAMS_MOST},
    {"reach", REAL, offsetof(struct fit_record, fit.flat.reach), 1},
    {"converged", FLAG, offsetof(struct fit_record, fit.converged), 1},
    {"plain", FLAG, offsetof(struct fit_record, fit.plain), 1},
    {"lowest", REAL, offsetof(struct fit_record, fit.lowest), 1},
    {"evaluations", COUNT, offsetof(struct fit_record, fit.evaluations), 1},
    {"perturbations", COUNT, offsetof(struct fit_record, fit.perturbations), 1},
    {"edits", COUNT, offsetof(struct fit_record, fit.edits), 1},
    {"edited_at", COUNT, offsetof(struct fit_record, fit.edited_at), 1},
    {"population", COUNT, offsetof(struct fit_record, fit.population), 1},
    {"lower", REAL, offsetof(struct fit_record, bounds.lower), PARAMS_MOST},
    {"upper", REAL, offsetof(struct fit_record, bounds.upper), PARAMS_MOST},
    {"weight", REAL, offsetof(struct fit_record, weight), 1}};

/* How a sheet was read, which the sheet that site_write prints does not say. */
static const struct taken {
	const char *name;
	size_t offset;
} TAKEN[] = {{"read_as", offsetof(struct site, read_as)},
    {"assumed", offsetof(struct site, assumed)},
    {"remark", offsetof(struct site, remark)},
    {"named", offsetof(struct site, named)}};

static char **
field_on_how_site_was_read(struct site *site, const struct taken *taken)
{
	return (char **)(void *)((char *)site + taken->offset);
}

static double
fit_record_value_as_double(
    const struct fit_record *b, const struct item *item, size_t i)
{
	const char *at = (const char *)b + item->offset;
	return item->kind == REAL ? ((const double *)(const void *)at)[i]
	       : item->kind == COUNT
		   ? (double)((const size_t *)(const void *)at)[i]
		   : ((const bool *)(const void *)at)[i];
}

static bool
fit_record_set_item_number(
    struct fit_record *b, const struct item *item, size_t i, double value)
{
	char *at = (char *)b + item->offset;
	bool count = value >= 0 && value <= 1e15 && value == floor(value);
	if (item->kind == REAL)
		((double *)(void *)at)[i] = value;
	else if (item->kind == COUNT && count)
		((size_t *)(void *)at)[i] = (size_t)value;
	else if (item->kind == FLAG && count && value <= 1)
		((bool *)(void *)at)[i] = value > 0;
	else
		return false;
	return true;
}

static void
write_fit_line(const struct fit_record *b, FILE *out)
{
	char number[32];
	for (size_t k = 0; k < ARRAY_LEN(ITEMS); k++) {
		fprintf(out, "%s=", ITEMS[k].name);
		for (size_t i = 0; i < ITEMS[k].n; i++)
			fprintf(out, "%s%s", i > 0 ? "," : "",
			    text_shortest_exact_number(
				fit_record_value_as_double(b, &ITEMS[k], i),
				number));
		fputc(' ', out);
	}
	fputs("train=", out);
	for (size_t r = 0; r < b->then->n_run; r++)
		fprintf(out, "%s%d", r > 0 ? "," : "", b->train[r]);
	fputc('\n', out);
}

/* Replaces line ends with \n, because texts in the store have one line. */
static char *
escape_line_ends(const char *text)
{
	char *line = xcalloc(2 * strlen(text) + 1, 1), *to = line;
	for (; *text != '\0'; text++) {
		if (*text == '\n' || *text == '\\')
			*to++ = '\\';
		*to++ = *text == '\n' ? 'n' : *text;
	}
	return line;
}

static char *
unescape_line_ends(const char *line)
{
	char *text = xstrdup(line), *to = text;
	for (const char *p = line; *p != '\0'; p++) {
		bool sign = *p == '\\' && p[1] != '\0';
		p += sign;
		*to++ = sign && *p == 'n' ? '\n' : *p;
	}
	*to = '\0';
	return text;
}

char *
fit_record_to_line(const struct fit_record *b)
{
	FREED char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	write_fit_line(b, out);
	for (size_t k = 0; k < ARRAY_LEN(TAKEN); k++) {
		const char *said =
		    *field_on_how_site_was_read(b->then, &TAKEN[k]);
		if (said[0] != '\0')
			fprintf(out, "%s=%s\n", TAKEN[k].name, said);
	}
	fputc('\n', out);
	site_write(b->then, out);
	if (b->now != NULL) {
		fputc('\n', out);
		site_write(b->now, out);
	}
	fclose(out);
	return escape_line_ends(text);
}

/* Reads the numbers of "name=1,2,3".  Names from a later version are
 * ignored. */
static bool
parse_fit_record_numbers(struct fit_record *b, const char *name, char *list)
{
	size_t k = 0, i = 0;
	while (k < ARRAY_LEN(ITEMS) && strcmp(ITEMS[k].name, name) != 0)
		k++;
	char *next = NULL, *word = strtok_r(list, ",", &next);
	for (; k < ARRAY_LEN(ITEMS) && word != NULL; i++) {
		double value;
		if (i == ITEMS[k].n || !text_parse_number(word, &value) ||
		    !fit_record_set_item_number(b, &ITEMS[k], i, value))
			return false;
		word = strtok_r(NULL, ",", &next);
	}
	return true;
}

/* Reads the line of the fit.  *train gets the text after train=, within the
 * line. */
static bool
parse_stored_fit_line(struct fit_record *b, char *line, const char **train)
{
	char *next = NULL;
	for (char *word = strtok_r(line, " ", &next); word != NULL;
	     word = strtok_r(NULL, " ", &next)) {
		char *value = strchr(word, '=');
		if (value == NULL)
			return false;
		*value++ = '\0';
		if (strcmp(word, "train") == 0)
			*train = value;
		else if (!parse_fit_record_numbers(b, word, value))
			return false;
	}
	return *train != NULL;
}

static struct site *
fit_record_parse_site(const char *text)
{
	const char *path = "";
	const struct site_request request = {
	    .n = 1, .path = &path, .text = text};
	struct error_list faults = {0};
	return site_read_with_options(&request, &faults, NULL);
}

/* Ends the text at the next empty line.  Returns the text after that, or
 * NULL. */
static char *
split_at_empty_line(char *text)
{
	char *end = strstr(text, "\n\n");
	if (end == NULL)
		return NULL;
	end[1] = '\0';
	return end + 2;
}

static void
parse_lines_how_site_was_read(struct site *site, const char *lines)
{
	for (size_t k = 0; k < ARRAY_LEN(TAKEN); k++) {
		char **said = field_on_how_site_was_read(site, &TAKEN[k]);
		FREED char *begin = xasprintf("%s=", TAKEN[k].name);
		for (const char *line = lines; *line != '\0';) {
			size_t n = strcspn(line, "\n"), head = strlen(begin);
			if (strncmp(line, begin, head) == 0)
				xfree_and_set(
				    said, xstrndup(line + head, n - head));
			line += n + (line[n] == '\n');
		}
	}
}

/* Reads which runs were trained on, "1,0,1".  Returns false if none can have
 * been. */
static bool
parse_training_runs(struct fit_record *b, const char *train)
{
	const struct site *site = b->then;
	bool any = false;
	b->train = xcalloc(site->n_run + 1, sizeof *b->train);
	for (size_t r = 0; r < site->n_run; r++) {
		if (strlen(train) < 2 * (site->n_run - r) - 1)
			return false;
		b->train[r] = train[2 * r] == '1';
		any = any || (b->train[r] && misfit_count_covered_sieves(
						 &site->run[r]) > 0);
	}
	return any;
}

static void
fit_record_copy_from_material(struct fit_record *b, const struct material *m)
{
	struct fit *fit = &b->fit;
	fit->params = m->params;
	fit->misfit = m->misfit;
	fit->seed = (uint64_t)m->seed;
	fit->generations = (size_t)m->generations;
	fit->settings = material_model_settings(m);
	fit->settings.breakage = (unsigned)m->params.breakage;
	fit->stop = CALIBRATE_TOLERANCE;
	while (fit->stop < CALIBRATE_STOPPED &&
	       strcmp(calibrate_state_name(fit->stop), m->stop) != 0)
		fit->stop++;
}

/* True if the numbers can come from a calibration. */
static bool
fit_record_is_possible(const struct fit_record *b)
{
	const struct breakage *of = breakage_model_of_params(&b->fit.params);
	bool good = b->fit.misfit >= 0 && b->fit.rmse >= 0 && b->weight > 0;
	for (size_t j = 0; good && j < of->n; j++)
		good = b->bounds.lower[j] >= of->parameter[j].least &&
		       b->bounds.upper[j] <= of->parameter[j].most &&
		       b->bounds.lower[j] <= b->bounds.upper[j];
	return good;
}

static bool
fit_record_parse_text(struct fit_record *b, char *text)
{
	const char *train = NULL;
	char *sheet = split_at_empty_line(text), *said = strchr(text, '\n');
	char *later = sheet != NULL ? split_at_empty_line(sheet) : NULL;
	if (sheet == NULL || said == NULL)
		return false;
	*said++ = '\0';
	b->then = fit_record_parse_site(sheet);
	b->now = later != NULL ? fit_record_parse_site(later) : NULL;
	if (!parse_stored_fit_line(b, text, &train) || b->then == NULL ||
	    (later != NULL && b->now == NULL) || !parse_training_runs(b, train))
		return false;
	parse_lines_how_site_was_read(b->then, said);
	if (b->now != NULL)
		parse_lines_how_site_was_read(b->now, said);
	return true;
}

bool
fit_record_from_material(
    const struct material *m, struct fit_record *b, struct error *error)
{
	*b = (struct fit_record){.weight = 0};
	if (m->basis[0] == '\0')
		return false;
	FREED char *text = unescape_line_ends(m->basis);
	bool good = fit_record_parse_text(b, text);
	if (good)
		fit_record_copy_from_material(b, m);
	return (good && fit_record_is_possible(b)) ||
	       error_set(error, ERROR_DATA,
		   "the runs remembered with '%s' cannot be read\n"
		   "calibrate on its sheet and remember it again",
		   m->name);
}

void
fit_record_clear(struct fit_record *b)
{
	free(b->train);
	site_free(b->then);
	site_free(b->now);
}
