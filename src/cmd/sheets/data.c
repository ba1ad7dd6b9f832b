/* sites, use, synth, write: list, choose, make and write sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/sites.h"
#include "cmd/session/files.h"
#include "cmd/lang/table.h"
#include "core/model/synth.h"
#include "io/formats/plant_log.h"
#include "io/fs/file.h"
#include "io/store/material.h"
#include "io/sitefile/units.h"

/* Adds the speeds of the runs: for programs in m/s, for people in the unit of
 * the sheet.  unit: name the unit, because sheets differ. */
static void
add_cell_of_run_speeds(struct answer *r, const struct site *site, bool unit)
{
	FREED char *speeds = session_speeds_of_runs_text(site, " ", NULL, true);
	FREED char *rpm = session_rpm_of_runs_text(site, " ", NULL, true);
	FREED char *shown =
	    xasprintf("%s%s%s", answers_is_sheet_in_rpm(site) ? rpm : speeds,
		unit ? " " : "", unit ? answers_speed_unit(site) : "");
	answer_add_keyed_cell(r, speeds, shown);
}

bool
cmd_sites(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct answer *r = answer_new("sites");
	bool unit = false;
	for (size_t i = 0; i < s->n_entry; i++)
		unit = unit || answers_is_sheet_in_rpm(s->entry[i].site);
	answer_add_columns(r, "key: site, name, rock, top_size_mm: top mm");
	answer_add_columns(
	    r, unit ? N_("speeds: speeds") : N_("speeds: speeds m/s"));
	answer_add_columns(r, "calibrated, data");
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		FREED char *marked =
		    xasprintf("%s%s", i == s->current ? "*" : "", entry->key);
		answer_add_keyed_cell(r, entry->key, marked);
		answer_add_cells(r, "%s %s %g", entry->site->name,
		    entry->site->rock,
		    entry->site->top_size > 0
			? units_m_to_mm(entry->site->top_size)
			: NAN);
		add_cell_of_run_speeds(r, entry->site, unit);
		answer_add_cells(r, "%s %s",
		    entry->has_fit       ? tr("yes")
		    : !entry->has_params ? tr("no")
		    : origin_is_from_store(entry->origin)
			? tr("from store")
			: origin_of_params_text(entry),
		    tr(site_data_kind(entry->site->provenance)));
	}
	answer_add_rows_as_json_objects(r, "rows");
	if (s->n_entry > 0)
		fields_put_values(answer_json_fields(r), "in_use %s",
		    session_current_site_entry(s)->key);
	answer_note(r, s->n_entry > 0
			   ? N_("* is the site in use")
			   : N_("no site is loaded: run 'load FILE', or "
				"'template > my.csv' for an empty sheet"));
	if (s->log != NULL)
		answer_note(r, "log: %s ('show log')", s->log->path);
	return session_show_answer(s, r);
}

bool
cmd_use(struct session *s, const struct args *args, struct error *error)
{
	size_t before = s->current;
	if (!session_find_site(s, args->operand[0], &s->current, error))
		return false;
	if (s->current != before) {
		session_remove_answers(s);
		s->last_asked = (struct last_asked){0};
	}
	return true;
}

/* Fills in the names and the provenance, which states that nothing was measured
 * and that the middle speed is an assumption (D8). */
static void
set_synthetic_site_provenance(struct site *site, const struct material *m,
    const struct synth *synth, const char *source)
{
	xfree_and_set(&site->name, xstrdup(m->site));
	xfree_and_set(&site->rock, xstrdup(m->rock));
	xfree_and_set(&site->machine, xstrdup("Metso Barmac 5100 SE"));
	free(site->provenance);
	site->provenance = xasprintf(
	    "reconstructed from %s, not measured; f_mat %g, E0_min %g, alpha "
	    "%g, default beta; %s; feed 100 %% at twice the top size, 90 %% "
	    "at it, below 90 (d/D)^n, n=%g%s; noise sd %g points at 50 %% "
	    "passing; seed %llu; middle speed assumed",
	    source, m->params.f_mat, m->params.e0_min, m->params.alpha,
	    m->feed_source, synth->n,
	    synth->individual_feeds ? " varied by 5 % from feed to feed" : "",
	    100 * synth->noise, (unsigned long long)synth->seed);
}

static struct site *
make_synthetic_site(const struct material *m, const struct args *args)
{
	struct synth synth = {.top_size = m->top_size_mm / 1000,
	    .params = m->params,
	    .individual_feeds = strncmp(m->feed_source, "Default", 7) != 0,
	    .n = args->exponent,
	    .noise = args->noise / 100,
	    .seed = args->seed,
	    .n_speed = args->speeds.n,
	    .speed = args->speeds.at};
	struct site *site = synth_make_site(&synth);
	const char *file = file_name_without_folders(args->operand[0]);
	set_synthetic_site_provenance(site, m, &synth,
	    strcmp(file, "table3.csv") == 0 || strcmp(file, "table3") == 0
		? "Table 3"
		: file);
	return site;
}

bool
cmd_synth(struct session *s, const struct args *args, struct error *error)
{
	const char *wanted = args->site;
	const double *speed = args->speeds.at;
	for (size_t i = 1; i < args->speeds.n; i++)
		if (speed[i] <= speed[i - 1])
			return error_set(error, ERROR_USAGE,
			    "expected speeds from slow to fast, each once, "
			    "got %g after %g\n"
			    "write: speeds=69,74,79",
			    speed[i], speed[i - 1]);
	struct error_list errors = {.stop = s->hooks.stop};
	struct material_list rows = {0};
	bool read = true;
	if (strcmp(args->operand[0], "table3") == 0) {
		material_add_table3_to_list(&rows);
	} else {
		files_record_read(s, args->operand[0]);
		read =
		    material_read_table3_file(args->operand[0], &rows, &errors);
	}
	size_t made = 0;
	for (size_t i = 0; i < rows.n && read; i++) {
		const struct material *row = &rows.item[i];
		if (wanted != NULL && !text_is_same_folded(wanted, row->site))
			continue;
		session_add_site(s, make_synthetic_site(row, args));
		made++;
	}
	material_list_free(&rows);
	if (!read)
		return session_report_file_faults(
		    s, args->operand[0], &errors, error);
	if (made == 0)
		return error_set(error, ERROR_USAGE,
		    "%s has no site '%s'\n"
		    "use a name of its column site",
		    args->operand[0], wanted);
	session_print_note(s,
	    tr_n("made %zu synthetic site: not measured",
		"made %zu synthetic sites: not measured", made),
	    made);
	return true;
}

bool
cmd_write(struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[0];
	struct stat info;
	if (stat(path, &info) != 0 || !S_ISDIR(info.st_mode)) {
		const struct site *site = session_current_site_entry(s)->site;
		bool kept = file_exists(path) && !args->replace &&
			    file_check_csv_name(path, error);
		bool ok = files_write_site(s, args, site, path, error);
		if (ok && s->n_entry > 1)
			session_print_note(s,
			    "this is the site in use; write FOLDER, one that "
			    "exists, writes all %zu",
			    s->n_entry);
		return ok || (kept && error->kind == ERROR_USAGE &&
				 error_set_hint(error,
				     "use replace=on to overwrite it; write "
				     "saves a site file, use > FILE for "
				     "results"));
	}
	for (size_t i = 0; i < s->n_entry; i++) {
		/* gavle-11.2-2 for the key gavle/11.2/2 */
		FREED char *stem = text_slug(s->entry[i].key);
		FREED char *file = xasprintf("%s/%s.csv", path, stem);
		if (!files_write_site(s, args, s->entry[i].site, file, error))
			return false;
	}
	return true;
}
