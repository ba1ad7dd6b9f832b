/* remember, recall, forget, export, import, materials: commands for the store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/sites.h"
#include "cmd/session/files.h"
#include "cmd/session/journal.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/outlook.h"
#include "cmd/fit/params.h"
#include "cmd/lang/table.h"
#include "cmd/session/invocation.h"
#include "cmd/fit/job.h"
#include "config.h"
#include "core/psd/rotor_speed.h"
#include "io/cells/datetime.h"
#include "io/store/store_csv.h"
#include "io/sitefile/units.h"
#include "io/store/basis.h"

/* Returns the fit with its runs, as a material stores them.  Draws are not
 * stored, because they follow from runs, fit and seed.  The caller frees it. */
static char *
fit_record_text(const struct entry *entry)
{
	const struct history *h = entry->history;
	const struct site *site = entry->site;
	bool grown = h->site->digest != site->digest;
	struct fit_record basis = {.fit = entry->fit,
	    .bounds = h->bounds,
	    .weight = h->weight,
	    .train = h->train,
	    .then = site_copy(h->site),
	    .now = grown ? site_copy(site) : NULL};
	char *text = fit_record_to_line(&basis);
	basis.train = NULL;
	fit_record_clear(&basis);
	return text;
}

static bool
are_curves_equal(const struct psd *a, const struct psd *b)
{
	return psd_is_same(a, b) || (a->n == 0 && b->n == 0);
}

/* Returns the index of an identical run in a site, or n_run. */
static size_t
find_identical_run(const struct site *site, const struct run *run)
{
	size_t r = 0;
	while (r < site->n_run &&
	       (site->run[r].speed != run->speed ||
		   !are_curves_equal(&site->run[r].feed, &run->feed) ||
		   !are_curves_equal(&site->run[r].product, &run->product)))
		r++;
	return r;
}

static bool
has_all_runs_of(const struct site *site, const struct site *of)
{
	for (size_t r = 0; r < of->n_run; r++)
		if (find_identical_run(site, &of->run[r]) == site->n_run)
			return false;
	return true;
}

static bool
does_digest_match_material(const struct site *site, const struct material *m)
{
	return strtoull(m->site_digest, NULL, 16) == site->digest;
}

/* Returns "3 runs at 69 to 79 m/s" or "a feed, no product". */
static char *
runs_and_speeds_text(const struct site *site)
{
	size_t n = site_count_products(site);
	double low = INFINITY, high = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (site->run[r].product.n == 0)
			continue;
		low = fmin(low, site->run[r].speed);
		high = fmax(high, site->run[r].speed);
	}
	if (n == 0)
		return xstrdup(tr("a feed, no product"));
	FREED char *rpm = rotor_speed_rpm_text(site_run_rotor_diameter(site),
	    low, low < high ? high : (double)NAN);
	return low < high ? xasprintf(tr_n("%zu run at %g to %g m/s%s",
					  "%zu runs at %g to %g m/s%s", n),
				n, low, high, rpm)
			  : xasprintf(tr_n("%zu run at %g m/s%s",
					  "%zu runs at %g m/s%s", n),
				n, low, rpm);
}

static char *
material_runs_or_params_text(const struct material *m)
{
	struct fit_record b;
	bool runs = fit_record_from_material(m, &b, NULL);
	char *words = runs
			  ? runs_and_speeds_text(b.now != NULL ? b.now : b.then)
			  : xstrdup(tr("parameters"));
	fit_record_clear(&b);
	return words;
}

static void
set_calibration_from_record(struct entry *entry, const struct fit_record *b,
    const struct material *m, struct history *h)
{
	entry->fit = b->fit;
	entry->params = m->params;
	entry->has_fit = entry->has_params = true;
	free(entry->train);
	entry->train = xcalloc(entry->site->n_run, sizeof *entry->train);
	for (size_t r = 0; r < h->site->n_run; r++)
		if (h->train[r])
			entry->train[find_identical_run(
			    entry->site, &h->site->run[r])] = true;
	snprintf(entry->options, sizeof entry->options, "%s", m->options);
	history_release(entry->history);
	entry->history = h;
	origin_release(entry->origin);
	entry->origin = origin_new_of_remembered_fit(entry, m);
}

static void
set_params_from_material(
    struct entry *entry, const struct material *m, struct history *h)
{
	entry->params = m->params;
	entry->has_params = true;
	entry->has_fit = false;
	origin_release(entry->origin);
	entry->origin = origin_new_from_store(m);
	entry->origin->history = h;
}

/* The result of recalling a material. */
enum remembered {
	RECALL_FAILED,       /* with an error */
	RECALL_WITHOUT_RUNS, /* the material has no runs */
	RECALL_OWN,          /* the site has its own calibration again */
	RECALL_OTHER         /* the site has the parameters and draws of another
			    * site */
};

/* Takes the calibration of a material into the session.  If the loaded site at
 * *index has all of its runs, the calibration becomes the site's own.  If no
 * site is loaded, loads the material's site and sets *index to it.  Runs that
 * were added to either since are kept. */
static enum remembered
recall_calibration(struct session *s, const struct material *m, size_t *index,
    struct error *error)
{
	struct fit_record b;
	error->kind = ERROR_NONE;
	if (!fit_record_from_material(m, &b, error)) {
		fit_record_clear(&b);
		return error->kind == ERROR_NONE ? RECALL_WITHOUT_RUNS
						 : RECALL_FAILED;
	}
	struct site *now = b.now != NULL ? b.now : b.then;
	if (s->n_entry == 0) {
		session_add_site(s, now);
		*index = s->current;
	} else {
		session_take_ownership_of_site(s, now);
	}
	if (now != b.then)
		session_take_ownership_of_site(s, b.then);
	struct entry *entry = &s->entry[*index];
	/* A site made by synth has more digits than its sheet. */
	bool made = b.now == NULL && entry->site->n_run == b.then->n_run &&
		    does_digest_match_material(entry->site, m);
	struct history *h = history_new(
	    &b.fit, &b.bounds, b.weight, made ? entry->site : b.then, b.train);
	bool own = has_all_runs_of(entry->site, h->site);
	if (s->job.type != NULL && s->job.entry == *index)
		session_discard_paused_job(s);
	if (own && b.now != NULL && !has_all_runs_of(entry->site, b.now))
		entry->site = b.now;
	if (own)
		set_calibration_from_record(entry, &b, m, h);
	else
		set_params_from_material(entry, m, h);
	session_remove_answers(s);
	free(b.train);
	return own ? RECALL_OWN : RECALL_OTHER;
}

/* Returns "fit", "set by hand" or "Table 3". */
static const char *
material_params_origin_text(const struct material *m)
{
	return material_is_table3(m)           ? "Table 3"
	       : strcmp(m->origin, "fit") == 0 ? "fit"
					       : tr("set by hand");
}

/* The material name closest to the one typed. */
struct spelling {
	const char *typed;
	char *best;
	size_t least;
};

static void
update_nearest_material_name(void *data, const char *name)
{
	struct spelling *s = data;
	bool paper = material_is_table3_name(name);
	size_t d = text_edit_distance(name + (paper ? 7 : 0), s->typed);
	if (d >= s->least)
		return;
	xfree_and_set(&s->best, xstrdup(name));
	s->least = d;
}

static bool
suggest_material_in_error(struct store *store,
    const struct material_list *paper, const char *name, struct error *error)
{
	struct spelling s = {name, xstrdup(""), 3};
	bool ok = store_visit_names_or_rocks(
	    store, STORE_NAMES, update_nearest_material_name, &s, error);
	for (size_t i = 0; i < paper->n; i++)
		update_nearest_material_name(&s, paper->item[i].name);
	if (ok)
		error_set(error, ERROR_USAGE,
		    s.least < 3 ? "the store has no material '%s'\n"
				  "did you mean '%s'?"
				: N_("the store has no material '%s'\n"
				     "run 'materials' to list them%.0s"),
		    name, s.best);
	free(s.best);
	return false;
}

/* Finds a material by name, "tierp" of the user's own or else "table3/tierp",
 * and adds it to the list, into which *found points.  If there is none, the
 * error suggests the closest name. */
static bool
find_material_by_name(struct store *store, const char *name,
    struct material_list *list, const struct material **found,
    struct error *error)
{
	const struct store_query query = {.name = name};
	if (!store_find_materials(store, &query, list, error))
		return false;
	material_add_table3_to_list(list);
	*found = material_find(list, name);
	if (*found == NULL) {
		FREED char *paper = xasprintf("table3/%s", name);
		*found = material_find(list, paper);
	}
	return *found != NULL ||
	       suggest_material_in_error(store, list, name, error);
}

static void
replace_text_by_trimmed_value(char **text, char *value)
{
	xfree_and_set(text, xstrdup(text_trim(value)));
	free(value);
}

static void
set_trimmed_copy(char **text, const char *value)
{
	replace_text_by_trimmed_value(text, xstrdup(value));
}

static void
set_material_fit_fields(struct material *m, const struct entry *entry)
{
	const struct fit *fit = &entry->fit;
	replace_text_by_trimmed_value(&m->basis, fit_record_text(entry));
	set_trimmed_copy(&m->options, entry->options);
	set_trimmed_copy(&m->stop, calibrate_state_name(fit->stop));
	m->misfit = fit->misfit;
	m->rmse_pct = 100 * fit->rmse;
	m->holdout_pct = 100 * fit_largest_holdout_rmse(entry);
	m->seed = (int64_t)fit->seed;
	m->generations = (int64_t)fit->generations;
}

/* Parameters from another site keep its speeds and provenance: synthetic data
 * do not become measured by being used. */
static void
set_material_origin_fields(struct material *m, const struct entry *entry)
{
	const struct origin *o = entry->origin;
	bool own = o->from[0] == '\0';
	char *speeds = xstrdup(""), number[32];
	for (size_t i = 0; i < o->n_speed; i++)
		xappend_to_list(&speeds, ",", "%s",
		    text_shortest_exact_number(o->speed[i], number));
	replace_text_by_trimmed_value(&m->train_mps, speeds);
	set_trimmed_copy(
	    &m->provenance, own ? entry->site->provenance : o->provenance);
	replace_text_by_trimmed_value(&m->site_digest,
	    xasprintf("%016" PRIx64, own ? entry->site->digest : o->digest));
	set_trimmed_copy(&m->note, own ? "" : o->words);
	if (own && site_assumed_top_size(entry->site) > 0)
		replace_text_by_trimmed_value(
		    &m->note, xasprintf(SITE_ASSUMED_TOP " %g",
				  site_assumed_top_size(entry->site)));
}

static struct material
make_material_of_loaded_site(const struct session *s, const struct entry *entry)
{
	const struct site *site = entry->site;
	const struct model_settings *settings =
	    entry->has_fit ? &entry->fit.settings : &s->set.model;
	struct material m = material_make_empty();
	set_trimmed_copy(&m.site, site->name);
	set_trimmed_copy(&m.rock, site->rock);
	set_trimmed_copy(&m.machine, site->machine);
	set_material_origin_fields(&m, entry);
	set_trimmed_copy(&m.origin, entry->has_fit ? "fit" : "hand");
	set_trimmed_copy(&m.method, answers_method_name(settings->method));
	set_trimmed_copy(&m.appearance, APPEARANCE_NAMES[settings->appearance]);
	set_trimmed_copy(&m.version, PACKAGE_VERSION);
	m.top_size_mm =
	    site->top_size > 0 ? units_m_to_mm(site->top_size) : NAN;
	m.k = settings->k;
	m.params = entry->params;
	if (entry->has_fit)
		set_material_fit_fields(&m, entry);
	return m;
}

static bool
check_can_remember(
    const struct entry *entry, const struct args *args, struct error *error)
{
	if (entry->has_fit && entry->fit.settings.impacts.n > 0)
		return error_set(error, ERROR_USAGE,
		    "expected parameters of Eq 3 with one impact at v^2/2, got "
		    "those with collision energies, which the store does not "
		    "keep\nrun 'set energy off' and calibrate, or 'save' the "
		    "session");
	if (!entry->has_params)
		return error_set(error, ERROR_USAGE,
		    "%s has no parameters to remember yet\n"
		    "run 'calibrate', or supply them with 'params set'",
		    entry->site->name);
	if (!entry->has_fit && origin_is_from_store(entry->origin))
		return error_set(error, ERROR_USAGE,
		    "%s has the parameters of %s, which are already in the "
		    "store\n"
		    "run 'calibrate' for the site's own parameters",
		    entry->site->name, entry->origin->from);
	if (args->date != NULL && !datetime_is_iso_date(args->date))
		return error_set(error, ERROR_USAGE,
		    "expected a date such as 2026-11-21, got '%s'", args->date);
	return args->note == NULL || material_is_text_printable(args->note) ||
	       error_set(error, ERROR_USAGE,
		   "note: expected one line without control characters");
}

static bool
can_ask_to_confirm(const struct session *s)
{
	return s->hooks.confirm != NULL && s->scripts <= s->typed_depth;
}

/* Notes other materials with the same runs, as a renamed sheet leaves
 * behind. */
static void
note_materials_with_same_runs(
    struct session *s, struct answer *r, const struct material *m)
{
	struct material_list list = {0};
	store_list_materials(s->store, &list, NULL);
	for (size_t i = 0; i < list.n && m->site_digest[0] != '\0'; i++) {
		const struct material *other = &list.item[i];
		if (strcmp(other->name, m->name) == 0 ||
		    strcmp(other->site_digest, m->site_digest) != 0)
			continue;
		FREED char *line = xstrdup("forget");
		journal_append_quoted_word(&line, other->name);
		answer_note(r,
		    "the store also has these runs as %s, remembered on %s: "
		    "'%s' removes that",
		    other->name, other->date, line);
	}
	material_list_free(&list);
}

/* Shows what was stored, once it is on the disk. */
static void
show_remembered_materials(
    struct session *s, const struct material *item, size_t n)
{
	struct answer *r = answer_new("remember");
	FREED char *about = xstrdup("");
	if (n == 1)
		answer_set_title(r, "remembered %s", item->name);
	else
		answer_set_title(r, "remembered %zu materials", n);
	answer_add_columns(r,
	    "name, origin, data, rmse_pct: RMSE, holdout_pct: "
	    "hold-out RMSE, date");
	for (size_t i = 0; i < n; i++) {
		const struct material *m = &item[i];
		if (strstr(about, m->provenance) == NULL)
			xappend_to_list(&about, "; ", "%s", m->provenance);
		answer_add_cells(r, "%s %s %s %.2f %.2f %s", m->name,
		    material_params_origin_text(m),
		    tr(site_data_kind(m->provenance)), m->rmse_pct,
		    m->holdout_pct, m->date);
	}
	if (n == 1)
		answer_set_site(r, item->site, item->provenance);
	else
		answer_set_site_names(r, "all", about);
	answer_note(r, "in %s", store_path(s->store));
	if (n == 1) {
		FREED char *line = xstrdup("recall");
		journal_append_quoted_word(&line, item->name);
		answer_note(r, "'%s' brings it back at any time", line);
		if (can_ask_to_confirm(s))
			note_materials_with_same_runs(s, r, item);
	}
	if (s->set.goal[0] != '\0')
		answer_note(r,
		    "the goal is not kept with it; type it again then: set "
		    "goal \"%s\"",
		    s->set.goal);
	session_show_answer(s, r);
}

/* Adds an entry's calibration to the list as a material with that name.
 * Returns false with an error if it cannot be remembered. */
static bool
add_loaded_site_as_material(struct session *s, const struct entry *entry,
    const char *name, const struct args *args, struct material_list *list,
    struct error *error)
{
	if (!check_can_remember(entry, args, error) ||
	    !material_check_name(name, error))
		return false;
	struct material m = make_material_of_loaded_site(s, entry);
	set_trimmed_copy(&m.name, name);
	replace_text_by_trimmed_value(&m.date,
	    args->date != NULL ? xstrdup(args->date) : datetime_today_text());
	if (args->note != NULL)
		set_trimmed_copy(&m.note, args->note);
	material_list_add(list, m);
	return true;
}

static bool
add_calibrated_sites_as_materials(struct session *s, const struct args *args,
    struct material_list *list, struct error *error)
{
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		if (entry->has_fit && !add_loaded_site_as_material(s, entry,
					  entry->key, args, list, error))
			return false;
	}
	return list->n > 0 ||
	       error_set(error, ERROR_USAGE,
		   "no loaded site is calibrated\nrun 'calibrate all'");
}

/* Describes what would replace a material.  old: the site with the material's
 * runs, or NULL if it has only parameters. */
static char *
material_replacement_text(const struct entry *entry, const struct site *old)
{
	FREED char *runs = runs_and_speeds_text(entry->site);
	if (!entry->has_fit)
		return xstrdup(tr("these parameters"));
	if (old == NULL)
		return xstrdup(runs);
	bool grown = has_all_runs_of(entry->site, old);
	bool same = text_is_same_folded(entry->site->name, old->name);
	size_t more = grown ? entry->site->n_run - old->n_run : 0;
	return more > 0 ? xasprintf(tr_n("these runs and %zu more",
					"these runs and %zu more", more),
			      more)
	       : grown  ? xstrdup(tr("the same runs, calibrated again"))
	       : same   ? xasprintf(tr("other numbers, %s"), runs)
			: xasprintf("%s, %s", entry->site->name, runs);
}

/* Asks whether to replace a material.  If it is an earlier state of the entry,
 * with the same settings and no run that the entry lacks, nothing would be
 * lost, and Return means yes. */
static bool
ask_to_replace_material(struct session *s, const struct entry *entry,
    const struct material *m, struct error *error)
{
	struct fit_record b;
	bool runs = fit_record_from_material(m, &b, NULL);
	const struct site *site = b.now != NULL ? b.now : b.then;
	bool earlier =
	    runs && entry->has_fit && has_all_runs_of(entry->site, site) &&
	    model_settings_are_same(&b.fit.settings, &entry->fit.settings);
	FREED char *old = material_runs_or_params_text(m);
	FREED char *new = material_replacement_text(entry, runs ? site : NULL);
	FREED char *question =
	    xasprintf(tr("the store has %s: %s, remembered on %s; replace it "
			 "by %s?"),
		m->name, old, m->date, new);
	fit_record_clear(&b);
	if (s->hooks.confirm(s, question, earlier))
		return true;
	FREED char *free_name = xasprintf("%s-2", m->name);
	for (size_t i = 3; store_has_material(s->store, free_name); i++)
		xfree_and_set(&free_name, xasprintf("%s-%zu", m->name, i));
	FREED char *line = xstrdup("remember");
	journal_append_quoted_word(&line, free_name);
	return error_set(error, ERROR_USAGE,
	    "nothing was stored: the store still has %s, %s, remembered on %s\n"
	    "to keep both: %s",
	    m->name, old, m->date, line);
}

/* Asks the user whether to replace materials that the store has already, and
 * sets *replace.  In scripts it does not ask, and store_save_materials
 * refuses. */
static bool
ask_to_replace_materials(struct session *s, const struct material_list *list,
    bool *replace, struct error *error)
{
	bool asks = can_ask_to_confirm(s);
	struct material_list own = {0};
	for (size_t i = 0; asks && i < list->n && own.n == 0; i++) {
		const struct store_query query = {.name = list->item[i].name};
		store_find_materials(s->store, &query, &own, NULL);
	}
	bool wanted = asks && !*replace && own.n > 0;
	if (wanted && list->n == 1) {
		*replace = ask_to_replace_material(
		    s, session_current_site_entry(s), &own.item[0], error);
	} else if (wanted) {
		FREED char *question = xasprintf(
		    tr("the store has %s and maybe others of these: replace "
		       "them?"),
		    own.item[0].name);
		*replace = s->hooks.confirm(s, question, false) ||
			   error_set(error, ERROR_USAGE,
			       "nothing was stored: the store is as it was\n"
			       "to replace what it has: remember all "
			       "replace=on");
	}
	material_list_free(&own);
	return !wanted || *replace;
}

bool
cmd_remember(struct session *s, const struct args *args, struct error *error)
{
	struct entry *entry = session_current_site_entry(s);
	const char *name = args->n_operand > 0 ? args->operand[0] : entry->key;
	bool all = strcmp(name, "all") == 0 && args->n_operand > 0;
	bool replace = args->replace;
	struct material_list list = {0};
	bool ok = all ? add_calibrated_sites_as_materials(s, args, &list, error)
		      : add_loaded_site_as_material(
			    s, entry, name, args, &list, error);
	ok = ok && ask_to_replace_materials(s, &list, &replace, error) &&
	     store_save_materials(s->store, list.item, list.n, replace, error);
	for (size_t i = 0; ok && i < s->n_entry; i++)
		if (all || &s->entry[i] == entry) {
			xfree_and_set(&s->entry[i].remembered,
			    xstrdup(all ? s->entry[i].key : name));
			s->entry[i].new_cuts = 0;
		}
	if (ok)
		show_remembered_materials(s, list.item, list.n);
	material_list_free(&list);
	return ok;
}

/* Notes whose parameters were recalled, and what they were calibrated on. */
static void
note_recalled_params(
    struct session *s, const struct entry *entry, const struct material *m)
{
	session_print_note(s, "%s: parameters from store: %s (%s, %s; %s)",
	    entry->site->name, m->name, m->site,
	    m->rock[0] != '\0' ? m->rock : tr("rock not stated"),
	    material_params_origin_text(m));
	const struct origin *o = entry->origin;
	FREED char *details = origin_training_speeds_text(o);
	bool same = o->found && o->digest == entry->site->digest;
	bool place = !same && m->basis[0] != '\0' &&
		     text_is_same_folded(m->site, entry->site->name);
	session_print_note(s,
	    same    ? N_("  calibrated on the same data as this site (%s)")
	    : place ? N_("  not calibrated on the runs of this sheet (%s)")
		    : N_("  not calibrated on this site (%s)"),
	    details);
	if (!place || entry->site->path[0] == '\0')
		return;
	FREED char *line = xasprintf("drop %s; recall", entry->key);
	journal_append_quoted_word(&line, m->name);
	xappend(&line, "; add");
	journal_append_quoted_word(&line, entry->site->path);
	session_print_note(s,
	    "  'calibrate' fits this sheet alone; to compare it with what was "
	    "remembered: %s",
	    line);
}

/* Lists what came back with a site besides its products: feeds, training runs,
 * cuts added, and what was assumed.  Does not say how the sheet's columns were
 * read, because that would not mention added runs. */
static void
note_recalled_site_data(struct session *s, const struct entry *entry)
{
	const struct site *site = entry->site;
	const char *last = "";
	size_t sieves, cuts = 0;
	free(site_all_sieves(site, &sieves));
	FREED char *train =
	    session_speeds_of_runs_text(site, ", ", entry->train, true);
	FREED char *rpm =
	    session_rpm_of_runs_in_brackets(site, entry->train, true);
	session_print_note(s,
	    site->individual_feeds
		? N_("  a feed for each run, %zu sieves; calibrated on %s "
		     "m/s%s")
		: N_("  one feed for all runs, %zu sieves; calibrated on %s "
		     "m/s%s"),
	    sieves, train, rpm);
	for (size_t i = 0; i < site->n_note; i++)
		if (strcmp(site->note[i].key, "cut") == 0) {
			last = site->note[i].value;
			cuts++;
		}
	/* The calibration included all runs, and all of them correct it. */
	if (cuts > 0)
		session_print_note(s,
		    entry->history != NULL &&
			    entry->history->site->digest == site->digest &&
			    correction_in_use(s, entry) == CORRECTION_ALL
			? tr_n(
			      "  %zu cut added and included in the answers: %s",
			      "  %zu cuts added and included in the answers; "
			      "the last: %s",
			      cuts)
			: tr_n("  %zu cut added since: %s",
			      "  %zu cuts added since, the last: %s", cuts),
		    cuts, last);
	if (site->assumed[0] != '\0')
		session_print_note(
		    s, "  likely, not stated: %s", site->assumed);
}

static void
note_recalled_site(struct session *s, const struct entry *entry)
{
	const struct site *site = entry->site;
	FREED char *label = session_site_label(site);
	FREED char *speeds =
	    session_speeds_of_runs_text(site, ", ", NULL, false);
	FREED char *rpm = session_rpm_of_runs_in_brackets(site, NULL, false);
	if (site_count_products(site) > 0)
		session_print_note(s,
		    tr_n("%s: %zu run at %s m/s%s, %s",
			"%s: %zu runs at %s m/s%s, %s", site->n_run),
		    label, site->n_run, speeds, rpm,
		    origin_of_params_text(entry));
	else
		session_print_note(s, "%s: a feed, no product, %s", label,
		    origin_of_params_text(entry));
	note_recalled_site_data(s, entry);
}

/* Notes what was recalled, and whether its calibration had other settings. */
static void
note_recalled_material(
    struct session *s, const struct entry *entry, const struct material *m)
{
	struct model_settings set_to = material_model_settings(m);
	if (entry->has_fit)
		note_recalled_site(s, entry);
	else
		note_recalled_params(s, entry, m);
	if (!model_settings_are_same(&set_to, &s->set.model))
		session_print_note(s,
		    "  the parameters were calibrated with other settings: run "
		    "set method=%s appearance=%s k=%g",
		    m->method, m->appearance, m->k);
	if (material_is_table3(m))
		session_print_note(
		    s, "  Table 3 has no beta: the default is used");
}

/* Returns false with an error if digest= is given and differs.  If it is not
 * given, adds it to the line in the journal. */
static bool
check_recalled_digest(struct session *s, const struct args *args,
    const struct material *m, struct error *error)
{
	const char *wanted = args->digest;
	char found[17];
	snprintf(
	    found, sizeof found, "%016" PRIx64, material_compute_digest(m));
	if (wanted == NULL)
		invocation_add_journal_options(s, " digest=%s", found);
	if (wanted == NULL || strcmp(wanted, found) == 0)
		return true;
	return error_set(error, ERROR_DATA,
	    "expected the material with digest %s, but %s has %s: it has "
	    "changed\n"
	    "leave out digest= to use it anyway; results will change",
	    wanted, m->name, found);
}

/* Takes the parameters and, if the store has them, the runs on which they were
 * found.  Answers on the same site are then those of that day; answers on
 * another site take the runs into account. */
static bool
recall_params_and_runs(struct session *s, const struct material *m,
    size_t index, struct error *error)
{
	enum remembered how = recall_calibration(s, m, &index, error);
	if (how == RECALL_WITHOUT_RUNS && s->n_entry == 0)
		return error_set(error, ERROR_USAGE,
		    "%s has parameters only, and no site is loaded\n"
		    "load the site that they are for first: load FILE",
		    m->name);
	if (how == RECALL_FAILED)
		return false;
	struct entry *entry = &s->entry[index];
	if (how == RECALL_WITHOUT_RUNS)
		set_site_params(s, entry, &m->params, origin_new_from_store(m));
	note_recalled_material(s, entry, m);
	return true;
}

/* Returns the materials for an error: "pit (3 runs at 69 to 79 m/s,
 * 2026-11-24); ..". */
static char *
materials_list_text(const struct material_list *list)
{
	enum { MOST = 6 };
	char *words = xstrdup("");
	for (size_t i = 0; i < list->n && i < MOST; i++) {
		FREED char *runs = material_runs_or_params_text(&list->item[i]);
		xappend_to_list(&words, "; ", "%s (%s, %s)", list->item[i].name,
		    runs, list->item[i].date);
	}
	if (list->n > MOST)
		xappend_to_list(&words, "; ", tr("%zu more"), list->n - MOST);
	return words;
}

/* Returns the material with the runs of the site in use, whatever its name,
 * else the one with the site's name, else NULL. */
static const struct material *
find_material_of_site(const struct session *s, const struct material_list *list)
{
	const struct material *named = NULL, *same = NULL;
	if (s->n_entry == 0)
		return NULL;
	const struct entry *entry = &s->entry[s->current];
	for (size_t i = 0; i < list->n; i++) {
		const struct material *m = &list->item[i];
		bool is_named = text_is_same_folded(m->name, entry->key);
		if (does_digest_match_material(entry->site, m) &&
		    (same == NULL || is_named))
			same = m;
		named = is_named ? m : named;
	}
	return same != NULL ? same : named;
}

/* Returns the name that recall without a name means: that of the only material
 * stored, or of the one for the site in use.  The caller frees it.  On failure,
 * returns NULL with an error that lists what there is. */
static char *
choose_name_to_recall(struct session *s, struct error *error)
{
	struct material_list list = {0};
	char *name = NULL;
	if (!store_list_materials(s->store, &list, error))
		return NULL;
	const struct material *m =
	    list.n == 1 ? &list.item[0] : find_material_of_site(s, &list);
	if (m != NULL) {
		name = xstrdup(m->name);
	} else if (list.n > 0) {
		FREED char *words = materials_list_text(&list);
		error_set(error, ERROR_USAGE,
		    "recall: expected the name of what was remembered: %s\n"
		    "for instance: recall %s",
		    words, list.item[0].name);
	} else {
		error_set(error, ERROR_USAGE,
		    "recall: expected a name, and nothing was remembered yet\n"
		    "'store list' has the materials of Table 3");
	}
	material_list_free(&list);
	return name;
}

bool
cmd_recall(struct session *s, const struct args *args, struct error *error)
{
	size_t index = s->current;
	if (args->n_operand > 1 &&
	    !session_find_site(s, args->operand[1], &index, error))
		return false;
	FREED char *name = args->n_operand > 0
			       ? xstrdup(args->operand[0])
			       : choose_name_to_recall(s, error);
	struct material_list list = {0};
	const struct material *m;
	bool ok = name != NULL &&
		  find_material_by_name(s->store, name, &list, &m, error) &&
		  check_recalled_digest(s, args, m, error) &&
		  recall_params_and_runs(s, m, index, error);
	material_list_free(&list);
	return ok;
}

/* Returns commands that would store the parameters again, without their origin:
 * "params set beta1=.. ..; remember NAME". */
static char *
commands_to_store_params(const struct material *m)
{
	const struct breakage *of = breakage_model_of_params(&m->params);
	char *line = m->params.breakage > 0
			 ? xasprintf("set model %s; params set", of->name)
			 : xstrdup("params set");
	char number[32];
	for (size_t j = 0; j < of->n; j++)
		xappend(&line, " %s=%s", of->parameter[j].name,
		    text_shortest_exact_number(m->params.at[j], number));
	xappend(&line, "; remember \"%s\"", m->name);
	return line;
}

static void
show_forgotten_material(struct session *s, const struct material *m)
{
	struct answer *r = answer_new("forget");
	FREED char *line = commands_to_store_params(m);
	answer_set_title(r, "forgot %s: %s of %s", m->name,
	    material_params_origin_text(m), m->site);
	answer_set_site(r, m->site, m->provenance);
	answer_add_columns(r, "again: to bring its parameters back");
	answer_add_cells(r, "%s", line);
	session_show_answer(s, r);
}

bool
cmd_forget(struct session *s, const struct args *args, struct error *error)
{
	const char *name = args->operand[0];
	struct material_list list = {0};
	const struct store_query query = {.name = name};
	/* A damaged row cannot be read, but it can be deleted. */
	bool listed = store_find_materials(s->store, &query, &list, NULL);
	const struct material *m = listed ? material_find(&list, name) : NULL;
	bool ok = store_remove_material(s->store, name, error);
	if (ok && m != NULL)
		show_forgotten_material(s, m);
	else if (ok)
		session_print_note(
		    s, "forgot %s, which could not be read", name);
	material_list_free(&list);
	if (!ok && material_is_table3_name(name))
		error_set(error, ERROR_USAGE,
		    "%s is part of the program and cannot be forgotten\n"
		    "run 'materials origin=own' for your own",
		    name);
	return ok;
}

bool
cmd_export(struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[0];
	struct material_list list = {0};
	bool ok = files_may_overwrite(s, args, path, error) &&
		  store_list_materials(s->store, &list, error) &&
		  store_csv_write_file(&list, path, error);
	if (ok) {
		files_record_written(s, path);
		session_print_note(s,
		    tr_n("wrote %s: %zu material of your own",
			"wrote %s: %zu materials of your own", list.n),
		    path, list.n);
	}
	material_list_free(&list);
	return ok;
}

bool
cmd_import(struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[0];
	struct error_list errors = {.stop = s->hooks.stop};
	struct material_list there = {0}, list = {0};
	bool ok =
	    args->replace || store_list_materials(s->store, &there, error);
	files_record_read(s, path);
	if (ok && !store_csv_read_file(path, &there, &list, &errors))
		ok = session_report_file_faults(s, path, &errors, error);
	ok = ok && store_save_materials(
		       s->store, list.item, list.n, args->replace, error);
	if (ok)
		session_print_note(s,
		    tr_n("imported %zu material from %s",
			"imported %zu materials from %s", list.n),
		    list.n, path);
	material_list_free(&there);
	material_list_free(&list);
	return ok;
}

enum { ALL, TABLE3, OWN };

/* Top sizes are nominal: they match within 5 %, so that 11 finds 11.2. */
static bool
does_material_match_options(const struct material *m, const struct args *args)
{
	return (args->rock == NULL ||
		   text_is_same_folded(m->rock, args->rock)) &&
	       (!(args->top > 0) ||
		   fabs(m->top_size_mm - args->top) <= 0.05 * args->top) &&
	       (args->origin == ALL ||
		   (args->origin == TABLE3) == material_is_table3(m));
}

static void
add_material_row(struct answer *r, const struct material *m)
{
	answer_add_cells(r, "%s %s %g %.2f %.2f %.2f %s %s", m->name, m->rock,
	    m->top_size_mm, params_value_by_name(&m->params, "f_mat"),
	    params_value_by_name(&m->params, "e0_min"),
	    params_value_by_name(&m->params, "alpha"),
	    material_params_origin_text(m), tr(site_data_kind(m->provenance)));
}

static void
add_rock_unless_listed(void *data, const char *rock)
{
	char **rocks = data;
	FREED char *all = xasprintf(", %s,", *rocks);
	FREED char *one = xasprintf(", %s,", rock);
	if (rock[0] != '\0' && !text_contains_folded(all, one))
		xappend_to_list(rocks, ", ", "%s", rock);
}

/* Lists the rock types of all materials, if none is of the type asked for. */
static bool
note_available_rocks(struct answer *r, struct store *store,
    const struct material_list *paper, struct error *error)
{
	FREED char *rocks = xstrdup("");
	bool ok = store_visit_names_or_rocks(
	    store, STORE_ROCKS, add_rock_unless_listed, &rocks, error);
	for (size_t i = 0; i < paper->n; i++)
		add_rock_unless_listed(&rocks, paper->item[i].rock);
	answer_note(r, "rocks: %s", rocks);
	return ok;
}

static struct answer *
build_materials_answer(
    const struct args *args, const struct material_list *list, size_t *n)
{
	struct answer *r = answer_new("materials");
	bool models = false;
	*n = 0;
	for (size_t i = 0; i < list->n; i++)
		models = models || list->item[i].params.breakage > 0;
	answer_add_columns(r, "name, rock, top_size_mm: top mm, f_mat, e0_min, "
			      "alpha, origin, data");
	if (models)
		answer_add_columns(r, "model: model");
	for (size_t i = 0; i < list->n; i++) {
		if (!does_material_match_options(&list->item[i], args))
			continue;
		add_material_row(r, &list->item[i]);
		if (models)
			answer_add_cells(r, "%s",
			    breakage_model_of_params(&list->item[i].params)
				->name);
		++*n;
	}
	return r;
}

/* Shows Table 3 alone, in one table if the screen or file has room for it.
 * Programs get the columns of all lists first. */
static struct answer *
build_table3_answer(const struct session *s, const struct args *args,
    const struct material_list *paper, size_t *n)
{
	enum { WIDE = 100 };
	struct answer *r = answer_new("materials");
	*n = 0;
	if (s->screen.columns == 0 || s->screen.columns >= WIDE)
		answer_set_width(r, WIDE);
	answer_add_columns(r, "name, site, rock, top_size_mm: top mm, f_mat, "
			      "e0_min, alpha, feed_source: feeds");
	for (size_t i = 0; i < paper->n; i++)
		if (does_material_match_options(&paper->item[i], args)) {
			const struct material *m = &paper->item[i];
			answer_add_cells(r, "%s %s %s %g %.2f %.2f %.2f %s",
			    m->name, m->site, m->rock, m->top_size_mm,
			    m->params.f_mat, m->params.e0_min, m->params.alpha,
			    m->feed_source);
			++*n;
		}
	answer_begin_table_for_programs(r);
	answer_add_columns(r, "name, rock, top_size_mm, f_mat, e0_min, alpha, "
			      "origin, data, site, feed_source");
	for (size_t i = 0; i < paper->n; i++)
		if (does_material_match_options(&paper->item[i], args)) {
			add_material_row(r, &paper->item[i]);
			answer_add_cells(r, "%s %s", paper->item[i].site,
			    paper->item[i].feed_source);
		}
	return r;
}

static bool
show_materials_list(
    struct session *s, const struct args *args, struct error *error)
{
	struct material_list list = {0}, paper = {0};
	struct store_query query = {.rock = args->rock,
	    .top_least = 0.94 * args->top,
	    .top_most = 1.06 * args->top,
	    .first = (size_t)args->most};
	size_t n, own = 0;
	material_add_table3_to_list(&paper);
	bool ok = store_count_materials(s->store, &own, error) &&
		  store_find_materials(s->store, &query, &list, error);
	size_t listed = list.n;
	material_add_table3_to_list(&list);
	struct answer *r = args->origin == TABLE3
			       ? build_table3_answer(s, args, &paper, &n)
			       : build_materials_answer(args, &list, &n);
	answer_note(r, "%zu of %zu materials, %zu of them your own, in %s", n,
	    own + paper.n, own, store_path(s->store));
	answer_note(r, "Table 3 is the paper's, and read only");
	if (n > 0 && query.first > 0 && listed == query.first)
		answer_add_sentence(r, ANSWER_REMARK,
		    "only the first %zu of your own: 'materials most=0' lists "
		    "all",
		    listed);
	if (ok && n == 0 && query.rock != NULL)
		ok = note_available_rocks(r, s->store, &paper, error);
	material_list_free(&list);
	material_list_free(&paper);
	if (ok)
		return session_show_answer(s, r);
	answer_free(r);
	return false;
}

/* Adds a row for a field.  Of the stored runs it says only that there are
 * any. */
static void
add_stored_field_row(void *data, const char *name, const char *text)
{
	if (strcmp(name, "basis") == 0)
		text = text[0] != '\0' ? tr("kept, with its runs") : "";
	answer_add_cells(data, "%s %s", name, text);
}

static void
show_material_fields(struct session *s, const struct material *m)
{
	struct answer *r = answer_new("materials");
	answer_set_title(r, "%s: %s", m->name, material_params_origin_text(m));
	answer_set_site(r, m->site, m->provenance);
	answer_add_columns(r, "field, value");
	material_visit_fields(m, add_stored_field_row, r);
	session_show_answer(s, r);
}

bool
show_store_summary(
    struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	struct material_list all = {0};
	size_t own;
	if (!store_count_materials(s->store, &own, error))
		return false;
	material_add_table3_to_list(&all);
	const char *path = store_path(s->store);
	int64_t bytes = store_file_size(s->store);
	struct answer *r = answer_new("show");
	answer_set_title(r, "the store of materials");
	answer_add_columns(r, "what, value");
	answer_add_name_value_row(r, "place", "%s", path);
	if (strcmp(path, ":memory:") == 0)
		answer_add_name_value_row(
		    r, "file", "none: kept until the session ends");
	else if (bytes < 0)
		answer_add_name_value_row(
		    r, "file", "none yet: the first 'remember' creates it");
	else
		answer_add_name_value_row(
		    r, "file", "%" PRId64 " bytes", bytes);
	answer_add_name_value_row(r, "schema", "%d", STORE_SCHEMA);
	answer_add_name_value_row(r, "own materials", "%zu", own);
	answer_add_name_value_row(r, "of Table 3", "%zu, read only", all.n);
	answer_note(r, "run 'materials' to list them");
	material_list_free(&all);
	return session_show_answer(s, r);
}

bool
cmd_materials(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0)
		return show_materials_list(s, args, error);
	struct material_list list = {0};
	const struct material *m;
	bool ok =
	    find_material_by_name(s->store, args->operand[0], &list, &m, error);
	if (ok)
		show_material_fields(s, m);
	material_list_free(&list);
	return ok;
}
