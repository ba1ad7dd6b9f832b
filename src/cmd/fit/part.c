/* Reads "2/5" or the task number that a batch system sets, chooses the sites,
 * and adds all options and a digest (FNV-1a) of the loaded data to an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/part.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/lang/parse.h"
#include "config.h"
#include "core/psd/site.h"

/* Environment variables that tell a task its number and the number of tasks.
 * first: the number of the first task; NULL: it is always 0.  step: from one
 * number to the next; NULL: it is always 1. */
static const struct engine {
	const char *number, *of, *first, *step;
} SCHEDULERS[] = {{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT",
		      "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP"},
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", NULL, NULL}};

static bool
parse_env_integer(const char *name, uint64_t fallback, uint64_t *value)
{
	const char *text = name != NULL ? getenv(name) : NULL;
	*value = fallback;
	return text == NULL || text_parse_whole_number(text, value);
}

static bool
check_part_number(const struct part *part, struct error *error)
{
	return (part->number >= 1 && part->number <= part->of) ||
	       error_set(error, ERROR_USAGE,
		   "expected a part from 1 to the number of parts, got %zu/%zu "
		   "(%s)\nthe third of eight: part=3/8; all sites: part=1/1",
		   part->number, part->of, part->from);
}

static bool
parse_part_from_scheduler(
    const struct engine *engine, struct part *part, struct error *error)
{
	uint64_t number, of, first, step;
	bool good = parse_env_integer(engine->number, 0, &number) &&
		    parse_env_integer(engine->of, 0, &of) &&
		    parse_env_integer(engine->first, 0, &first) &&
		    parse_env_integer(engine->step, 1, &step);
	if (!good || step == 0 || number < first)
		return error_set(error, ERROR_USAGE,
		    "expected whole numbers in %s and %s\n"
		    "say which part it is: part=3/8",
		    engine->number, engine->of);
	*part = (struct part){
	    (size_t)((number - first) / step) + 1, (size_t)of, engine->number};
	return check_part_number(part, error);
}

static bool
parse_part_or_environment(
    const char *text, struct part *part, struct error *error)
{
	*part = (struct part){0};
	for (size_t i = 0; text == NULL && i < ARRAY_LEN(SCHEDULERS); i++)
		if (getenv(SCHEDULERS[i].number) != NULL &&
		    getenv(SCHEDULERS[i].of) != NULL)
			return parse_part_from_scheduler(
			    &SCHEDULERS[i], part, error);
	if (text == NULL)
		return true;
	uint64_t number = 0, of = 0;
	const char *slash = strchr(text, '/');
	FREED char *before =
	    xstrndup(text, slash != NULL ? (size_t)(slash - text) : 0);
	bool good = slash != NULL && text_parse_whole_number(before, &number) &&
		    text_parse_whole_number(slash + 1, &of);
	*part = (struct part){(size_t)number, (size_t)of, "part"};
	if (good)
		return check_part_number(part, error);
	return error_set(error, ERROR_USAGE,
	    "expected part=I/N, got '%s'\nthe third of eight: part=3/8", text);
}

bool
part_from_args(
    const struct args *args, bool all, struct part *part, struct error *error)
{
	const char *name = args->command->name;
	const char *word = all ? args->operand[0] : "all";
	bool train = value_is_speed(word) &&
		     command_option_index(args->command, "train") < OPTIONS;
	if (strcmp(word, "all") != 0)
		return error_set(error, ERROR_USAGE,
		    train ? N_("%s: expected options or all, got '%s'\n"
			       "write: %s train=%s")
			  : N_("%s: expected options or all, got '%s'\n"
			       "write: %s, or %s all"),
		    name, word, name, train ? word : name);
	if (all)
		return parse_part_or_environment(args->part, part, error);
	return args->part == NULL ||
	       error_set(error, ERROR_USAGE,
		   "part: expected '%s all', which part= divides\nwrite: %s "
		   "all part=%s",
		   name, name, args->part);
}

bool
part_has_site(const struct part *part, size_t index)
{
	return part->of == 0 || index % part->of == part->number - 1;
}

/* Adds the table for people, or that for programs, whose rows have the source
 * of their own data. */
static void
add_calibrated_site_rows(
    struct answer *r, const struct part_row *row, size_t n, bool programs)
{
	answer_add_column(r, "site", "site");
	if (programs)
		answer_add_column(r, "provenance", "provenance");
	answer_add_columns(r, "f_mat, e0_min, alpha, misfit, rmse_pct: RMSE, "
			      "holdout_pct: hold-out RMSE, remark");
	for (size_t i = 0; i < n; i++) {
		const double *number = row[i].number;
		answer_add_cells(r, "%s", row[i].site);
		if (programs)
			answer_add_cells(r, "%s", row[i].source);
		answer_add_cells(r, "%.3f %.2f %.3f %g %.2f %.2f %s", number[0],
		    number[1], number[2], number[3], number[4], number[5],
		    row[i].remark);
	}
}

struct answer *
part_build_calibrate_all_answer(const struct part_row *row, size_t n)
{
	struct answer *r = answer_new("calibrate");
	struct sources all = {0};
	for (size_t i = 0; i < n; i++)
		sources_add(&all, row[i].site, row[i].source);
	FREED char *about = sources_text_and_clear(&all);
	answer_set_title(r, "all sites, calibrated");
	answer_set_site_names(r, "all", about);
	add_calibrated_site_rows(r, row, n, false);
	answer_begin_table_for_programs(r);
	add_calibrated_site_rows(r, row, n, true);
	return r;
}

/* Appends a digest of the collision energies, because they are too many numbers
 * to list. */
static void
append_digest_of_impacts(char **words, const struct impacts *impacts)
{
	uint64_t digest = text_fnv1a_digest(
	    TEXT_DIGEST_START, &impacts->number, sizeof(double));
	size_t size = impacts->n * sizeof(double);
	if (impacts->n == 0)
		return;
	digest = text_fnv1a_digest(digest, impacts->share, size);
	digest = text_fnv1a_digest(digest, impacts->ratio, size);
	xappend(words, " energy=%zu/%016" PRIx64, impacts->n, digest);
}

char *
part_common_options_text(const struct session *s,
    const struct calibrate_options *o, const char *more)
{
	const struct breakage *of = BREAKAGES[o->settings.breakage];
	const struct model_settings *m = &o->settings;
	char *words = xasprintf(
	    "seed=%llu population=%zu generations=%zu tolerance=%.17g "
	    "stall=%zu polish=%d plain=%d train=%s model=%s method=%d "
	    "appearance=%d k=%.17g bypass=%.17g noise=%.17g speed_sd=%.17g "
	    "correction=%d",
	    (unsigned long long)o->seed, o->population, o->generations,
	    o->tolerance, o->stall, o->polish, o->plain, more, of->name,
	    (int)m->method, (int)m->appearance, m->k, m->bypass, s->set.noise,
	    s->set.speed_sd, (int)s->set.correction);
	append_digest_of_impacts(&words, &m->impacts);
	for (size_t j = 0; j < of->n; j++)
		xappend(&words, " %s=%.17g..%.17g", of->parameter[j].name,
		    o->bounds.lower[j], o->bounds.upper[j]);
	return words;
}

/* Returns a digest of the names and the data of all loaded sites, in their
 * order. */
static uint64_t
digest_of_loaded_sites(const struct session *s)
{
	uint64_t digest = TEXT_DIGEST_START;
	for (size_t i = 0; i < s->n_entry; i++) {
		FREED char *text = xasprintf("%s %016" PRIx64 "\n",
		    s->entry[i].key, s->entry[i].site->digest);
		digest = text_fnv1a_digest(digest, text, strlen(text));
	}
	return digest;
}

void
part_put_fields_for_collect(struct answer *answer, const struct session *s,
    const struct part *part, const size_t *index, size_t n, const char *options)
{
	char digest[17];
	struct fields *o =
	    fields_add_object(answer_json_fields(answer), "part");
	snprintf(
	    digest, sizeof digest, "%016" PRIx64, digest_of_loaded_sites(s));
	fields_put_values(o,
	    "number %zu of %zu loaded %zu sites %s version %s "
	    "format %zu options %s",
	    part->number, part->of, s->n_entry, digest, PACKAGE_VERSION,
	    (size_t)PART_FORMAT, options);
	struct fields *list = fields_add_list(o, "index");
	for (size_t i = 0; i < n; i++)
		fields_put_values(list, "%zu", index[i]);
}
