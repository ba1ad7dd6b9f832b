/* guess: an estimate of the product of an uncalibrated site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "core/answer/guess.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/fit.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "cmd/ask/question.h"
#include "core/search/misfit.h"
#include "core/check/validate.h"
#include "io/sitefile/units.h"

/* At most this many of the user's own materials are used, the nearest.  A band
 * over 100,000 would hardly differ, and would take seconds. */
enum { MOST_OWN = 200 };

/* The materials for a guess.  own: number of the user's materials, of which the
 * list has at most MOST_OWN.  list: all materials, with Table 3 from index
 * `table3` on.  m [list.n]: the same materials, as core takes them.  pick [n]:
 * indices of those used.  error: the error of guesses from as many
 * materials. */
struct guess_sources {
	struct material_list list;
	struct guess_material *m, wanted;
	bool *leave_out;
	size_t n, *pick, table3, own;
	struct guess_choice choice;
	struct guess_error error;
};

static void
guess_sources_free(struct guess_sources *b)
{
	material_list_free(&b->list);
	free(b->m);
	free(b->leave_out);
	free(b->pick);
}

static bool
load_materials_for_guess(
    struct guess_sources *b, struct store *store, struct error *error)
{
	struct store_query query = {0};
	if (!store_count_materials(store, &b->own, error))
		return false;
	if (b->own > MOST_OWN)
		query = (struct store_query){.rock = b->wanted.rock,
		    .top = units_m_to_mm(b->wanted.top_size),
		    .most = MOST_OWN};
	if (!store_find_materials(store, &query, &b->list, error))
		return false;
	material_add_table3_to_list(&b->list);
	return true;
}

static void
prepare_guess_materials(struct guess_sources *b)
{
	size_t n = b->list.n;
	b->m = xcalloc(n, sizeof *b->m);
	b->leave_out = xcalloc(n, sizeof *b->leave_out);
	b->pick = xcalloc(n, sizeof *b->pick);
	for (size_t i = 0; i < n; i++) {
		const struct material *m = &b->list.item[i];
		double top_mm = m->top_size_mm;
		b->m[i] = (struct guess_material){m->site, m->rock,
		    isfinite(top_mm) ? top_mm / 1000 : 0, m->params,
		    material_model_settings(m), material_is_table3(m)};
		b->leave_out[i] = text_is_same_folded(m->site, b->wanted.site);
	}
	while (!material_is_table3(&b->list.item[b->table3]))
		b->table3++;
}

/* Picks the nearest materials: as many as the user says, or else the number
 * with the smallest leave-one-site-out error.  That number is found from Table
 * 3 alone, so it is the same for everyone. */
static void
pick_nearest_materials(struct guess_sources *b, uint64_t nearest, double speed)
{
	size_t n = b->list.n, n_table = n - b->table3, most = n;
	const struct guess_material *table = b->m + b->table3;
	if (nearest > 0) {
		most = nearest < n ? (size_t)nearest : n;
		b->error =
		    guess_leave_one_out_error(table, n_table, most, speed);
	} else {
		b->choice = guess_choose_neighbour_count(table, n_table, speed);
		b->error = b->choice.helps ? b->choice.few : b->choice.all;
		most = b->choice.helps ? b->error.nearest : n;
	}
	b->n = guess_find_nearest_materials(
	    b->m, n, &b->wanted, b->leave_out, most, b->pick);
}

/* Takes the rock type and top size from the call, or else from the site
 * file. */
static bool
parse_wanted_material(const struct site *site, const struct args *args,
    struct guess_material *wanted, struct error *error)
{
	*wanted = (struct guess_material){.site = site->name,
	    .rock = args->rock != NULL ? args->rock : site->rock,
	    .top_size = args->top > 0 ? args->top / 1000 : site->top_size};
	if (args->nearest == 0 || wanted->rock[0] != '\0' ||
	    wanted->top_size > 0)
		return true;
	return error_set(error, ERROR_USAGE,
	    "guess: expected a rock type or a top size; the site file of %s "
	    "states neither\n"
	    "write: guess rock=granite top=11.2, or leave out nearest=",
	    site->name);
}

static void
put_guess_source_fields(struct fields *o, const struct guess_sources *b)
{
	struct fields *list = fields_add_list(o, "materials");
	for (size_t i = 0; i < b->n; i++) {
		const struct material *m = &b->list.item[b->pick[i]];
		struct fields *one = fields_add_object(list, NULL);
		fields_put_values(one,
		    "name %s site %s rock %s top_size_mm %g origin %s "
		    "provenance %s train_mps %s",
		    m->name, m->site, m->rock, m->top_size_mm, m->origin,
		    m->provenance, m->train_mps);
		fit_put_params_in_json(one, &m->params);
	}
}

static const char *
worst_guessed_material_name(const struct guess_sources *b)
{
	return b->list.item[b->table3 + b->error.worst_at].name;
}

static void
put_guessed_product_fields(
    struct answer *r, const struct guess_sources *b, const struct guess *guess)
{
	struct fields *o = answer_json_fields(r);
	const struct guess_error *e = &b->error;
	double top = b->wanted.top_size;
	fields_put_values(o, "calibrated %d rock %s top_size_mm %g speed %g",
	    false, b->wanted.rock, top > 0 ? units_m_to_mm(top) : NAN,
	    guess->speed);
	answer_add_columns_to_json_fields(
	    r, "sieve_mm passing_pct low_pct high_pct");
	for (size_t i = 0; i < ANSWERS_SIZES; i++) {
		const struct guess_range *range = &guess->size[i];
		fields_put_number(o, ANSWERS_SIZE[i].key, 1000 * range->middle);
		answers_put_low_high_field(o, ANSWERS_SIZE[i].range_key,
		    1000 * range->low, 1000 * range->high);
	}
	put_guess_source_fields(o, b);
	fields_put_values(fields_add_object(o, "leave_one_site_out"),
	    "data %s sites %zu median_rmse_pct %g worst_rmse_pct %g worst %s "
	    "feed_rmse_pct %g held_pct %g",
	    "reconstructed from Table 3", e->n, 100 * e->median, 100 * e->worst,
	    worst_guessed_material_name(b), 100 * e->feed, 100 * e->held);
}

static struct answer *
build_guessed_product_answer(const struct site *site, const struct guess *guess)
{
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, guess->speed, NAN);
	struct answer *r = answer_new_about_site(site, "guess",
	    "estimated product at %.*f m/s%s, not calibrated",
	    units_speed_decimals(guess->speed), guess->speed, rpm);
	answer_add_columns(r,
	    "sieve_mm: sieve mm, feed_pct: feed %%, passing_pct: "
	    "guess %%, low_pct: low %%, high_pct: high %%");
	for (size_t i = 0; i < guess->median.n; i++)
		answer_add_cells(r, "%g %.1f %.1f %.1f %.1f",
		    units_m_to_mm(guess->median.size[i]),
		    units_fraction_to_pct(guess->feed.passing[i]),
		    units_fraction_to_pct(guess->median.passing[i]),
		    units_fraction_to_pct(guess->low.passing[i]),
		    units_fraction_to_pct(guess->high.passing[i]));
	return r;
}

/* Returns "2.81 (2.52..3.10)", in mm. */
static char *
size_range_text(const struct guess_range *range, const char *none)
{
	static const char *const AFTER[3] = {" (", "..", ")"};
	const double v[3] = {range->middle, range->low, range->high};
	char *words = xstrdup("");
	for (size_t i = 0; i < 3; i++)
		if (isfinite(v[i]))
			xappend(&words, "%.2f%s", 1000 * v[i], AFTER[i]);
		else
			xappend(&words, "%s%s", none, AFTER[i]);
	return words;
}

static void
note_guessed_product_sizes(struct answer *r, const struct guess *guess)
{
	const struct psd *psd = &guess->median;
	FREED char *none =
	    xasprintf("<%g", units_m_to_mm(psd->size[psd->n - 1]));
	FREED char *sizes = xstrdup("");
	for (size_t i = 0; i < PSD_SIZES; i++) {
		FREED char *words = size_range_text(&guess->size[i], none);
		xappend_to_list(&sizes, ", ", "%s %s", PSD_NAME[i], words);
	}
	FREED char *breaks =
	    size_range_text(&guess->size[ANSWERS_BREAK], tr("none"));
	answer_note(r, "%s mm", sizes);
	answer_note(r, "break size %s mm", breaks);
}

/* Lists the names of the materials that were picked or, if `left`, left out. */
static char *
list_picked_material_names(const struct guess_sources *b, bool left)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < (left ? b->list.n : b->n); i++) {
		size_t at = left ? i : b->pick[i];
		if (!left || b->leave_out[i])
			xappend_to_list(
			    &list, ", ", "%s", b->list.item[at].name);
	}
	return list;
}

static void
note_picked_materials(struct answer *r, const struct guess_sources *b)
{
	size_t same = 0;
	for (size_t i = 0; i < b->n; i++)
		same += text_is_same_folded(
		    b->list.item[b->pick[i]].rock, b->wanted.rock);
	FREED char *picked = list_picked_material_names(b, false);
	if (b->wanted.rock[0] == '\0')
		answer_note(
		    r, "nearest by top size (no rock type stated): %s", picked);
	else
		answer_note(r,
		    b->wanted.top_size > 0
			? N_("nearest by rock (%s, %zu of %zu) and top size: "
			     "%s")
			: N_("nearest by rock (%s, %zu of %zu; no top size "
			     "stated): %s"),
		    b->wanted.rock, same, b->n, picked);
}

/* Says if no material has the rock type: it may be new, or misspelt. */
static void
note_unknown_rock(struct answer *r, const struct guess_sources *b)
{
	bool known = b->wanted.rock[0] == '\0';
	for (size_t i = 0; i < b->list.n && !known; i++)
		known =
		    text_is_same_folded(b->list.item[i].rock, b->wanted.rock);
	if (!known)
		answer_add_sentence(r, ANSWER_REMARK,
		    "no material is of the rock type '%s': 'materials' lists "
		    "all types",
		    b->wanted.rock);
}

static void
note_choice_of_materials(struct answer *r, const struct guess_sources *b)
{
	const struct guess_choice *c = &b->choice;
	if (c->all.n > 0 && !c->helps)
		answer_add_sentence(r, ANSWER_REMARK,
		    "rock type and top size carry no information here: by the "
		    "error below no number of nearest materials does clearly "
		    "better (the best, %zu: %.1f points) than all (%.1f)",
		    c->few.nearest, 100 * c->few.median, 100 * c->all.median);
	else
		note_picked_materials(r, b);
}

static void
note_basis_of_guess(struct answer *r, const struct guess_sources *b)
{
	bool measured = true, open = false;
	for (size_t i = 0; i < b->n; i++) {
		open = open || b->m[b->pick[i]].law_open;
		measured =
		    measured &&
		    strcmp(site_data_kind(b->list.item[b->pick[i]].provenance),
			"measured") == 0;
	}
	if (b->n > 1)
		answer_add_sentence(r, ANSWER_REMARK,
		    "estimated from other quarries, not calibrated: median "
		    "and 80 %% band of the products with %zu materials",
		    b->n);
	else
		answer_add_sentence(r, ANSWER_REMARK,
		    open ? N_("estimated from one material of another quarry, "
			      "not calibrated: the band does not cover rock of "
			      "another strength")
			 : N_("estimated from one material of another quarry, "
			      "not calibrated: there is no band"));
	if (open)
		answer_add_sentence(r, ANSWER_REMARK,
		    "Table 3 prints no beta, and rocks differ in the sizes of "
		    "their progeny: each of its materials is taken with %d "
		    "beta from coarse to fine",
		    GUESS_LAWS);
	note_unknown_rock(r, b);
	note_choice_of_materials(r, b);
	if (b->table3 < b->own)
		answer_add_sentence(r, ANSWER_REMARK,
		    "of your own %zu materials the %zu nearest in rock and top "
		    "size were used",
		    b->own, b->table3);
	if (!measured)
		answer_add_sentence(r, ANSWER_WARNING,
		    "some of these materials were not calibrated on measured "
		    "data");
	FREED char *left = list_picked_material_names(b, true);
	if (left[0] != '\0')
		answer_add_sentence(r, ANSWER_REMARK,
		    "left out because they are this site's own: %s", left);
}

/* Warns if the speed is outside the training speeds of one of the materials.
 * Materials that do not state them do not count. */
static void
warn_if_beyond_material_speeds(
    struct answer *r, const struct guess_sources *b, double speed)
{
	double slowest = 0, fastest = INFINITY;
	for (size_t i = 0; i < b->n; i++) {
		struct origin *o =
		    origin_new_from_store(&b->list.item[b->pick[i]]);
		double slow = INFINITY, fast = 0;
		for (size_t k = 0; k < o->n_speed; k++) {
			slow = fmin(slow, o->speed[k]);
			fast = fmax(fast, o->speed[k]);
		}
		if (o->n_speed > 0) {
			slowest = fmax(slowest, slow);
			fastest = fmin(fastest, fast);
		}
		origin_release(o);
	}
	bool beyond = speed < slowest - 1e-9 || speed > fastest + 1e-9;
	fields_put_values(answer_json_fields(r), "extrapolated %d", beyond);
	if (beyond)
		answer_add_sentence(r, ANSWER_WARNING,
		    "%.*f m/s is outside the training speeds common to these "
		    "materials, %g to %g m/s",
		    units_speed_decimals(speed), speed, slowest, fastest);
}

/* Notes the error of such guesses.  The band of a few materials is
 * systematically too narrow: see struct guess. */
static void
note_leave_one_out_error(struct answer *r, const struct guess_sources *b)
{
	const struct guess_error *e = &b->error;
	if (b->n > 1 && e->held < 0.7)
		answer_add_sentence(r, ANSWER_WARNING,
		    "the band of so few materials is too narrow: with one beta "
		    "for all, it held %.0f %% of the passings of sites left "
		    "out, instead of 80",
		    100 * e->held);
	answer_add_sentence(r, ANSWER_REMARK,
	    "leave-one-site-out RMSE (%zu materials of Table 3, one beta for "
	    "all): median %.1f points, worst %.1f (%s); feed unchanged %.1f. "
	    "These are reconstructed data on synthetic feeds without sampling "
	    "error: with another beta expect 5 to 12 points",
	    e->n, 100 * e->median, 100 * e->worst,
	    worst_guessed_material_name(b), 100 * e->feed);
	if (b->n > 1 && isfinite(e->held))
		answer_add_sentence(r, ANSWER_REMARK,
		    "with one beta for all, the band held %.0f %% of the "
		    "passings of sites left out",
		    100 * e->held);
}

/* If the site has a single product, names the material that matches it best.
 * 'recall' can use that material's parameters; the guess, a median of products,
 * has none. */
static void
note_material_nearest_to_product(
    struct answer *r, const struct site *site, const struct guess_sources *b)
{
	if (site_count_products(site) != 1)
		return;
	size_t run = 0, best = b->list.n;
	double least = INFINITY;
	while (misfit_count_covered_sieves(&site->run[run]) == 0)
		if (++run == site->n_run)
			return;
	double top = site_finest_sieve_all_pass(site);
	for (size_t i = 0; i < b->list.n; i++) {
		const struct guess_material *m = &b->m[i];
		if (b->leave_out[i])
			continue;
		double rmse = validate_rmse_of_model(
		    &site->run[run], top, &m->params, m->settings);
		if (rmse < least) {
			least = rmse;
			best = i;
		}
	}
	if (best == b->list.n)
		return;
	const char *name = b->list.item[best].name;
	answer_note(r,
	    "of the materials, %s matches the cut at %g m/s best (RMSE %.1f "
	    "points): 'recall %s' predicts with it",
	    name, site->run[run].speed, 100 * least, name);
}

static void
show_guessed_product(struct session *s, const struct question *q,
    const struct guess_sources *b, const struct guess *guess)
{
	const struct site *site = q->entry->site;
	struct answer *r = build_guessed_product_answer(site, guess);
	note_guessed_product_sizes(r, guess);
	note_basis_of_guess(r, b);
	note_material_nearest_to_product(r, site, b);
	warn_if_beyond_material_speeds(r, b, guess->speed);
	note_leave_one_out_error(r, b);
	feed_add_note_to_answer(r, site, q->feed, NULL, 0);
	feed_note_assumed_top_size(r, site, NULL);
	put_guessed_product_fields(r, b, guess);
	session_show_answer(s, r);
}

bool
cmd_guess(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct site *site = q->entry->site;
	struct guess_sources b = {.n = 0};
	question_use_last_speed(s, q);
	bool ok = parse_wanted_material(site, args, &b.wanted, error) &&
		  load_materials_for_guess(&b, s->store, error);
	if (ok) {
		prepare_guess_materials(&b);
		pick_nearest_materials(&b, args->nearest, q->speed);
		struct guess guess = guess_psd_from_materials(
		    site, q->feed, b.m, b.pick, b.n, q->speed);
		show_guessed_product(s, q, &b, &guess);
		guess_free(&guess);
	}
	guess_sources_free(&b);
	return ok;
}
