/* blend: mixes feeds by mass, and predicts the site's product from the mixture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/files.h"
#include "cmd/ask/forecast.h"
#include "cmd/lang/parse.h"
#include "cmd/lang/table.h"
#include "cmd/ask/blended.h"
#include "cmd/ask/question.h"
#include "core/psd/rotor_speed.h"
#include "io/fs/file.h"
#include "io/sitefile/units.h"

/* Reads "a.csv=60" or "a.csv=60%". */
static bool
read_blend_component(
    struct session *s, const char *word, struct blended *b, struct error *error)
{
	const char *equals = strrchr(word, '=');
	double share;
	if (equals == NULL || equals == word ||
	    !value_parse_number(equals + 1, "%", &share) || !(share > 0) ||
	    share > 1e9)
		return error_set(error, ERROR_USAGE,
		    "blend: expected FILE=PART, a part by mass above 0; got "
		    "'%s'\n"
		    "for instance: blend a.csv=60 b.csv=40",
		    word);
	FREED char *file = xstrndup(word, (size_t)(equals - word));
	return blended_add_feed(s, file, share, b, error);
}

/* Adds a row for each sieve: the feeds, the blend and its product, if any. */
static void
add_blend_rows(struct answer *r, const struct blended *b,
    const struct psd *sieves, const struct prediction *p)
{
	answer_add_columns(r, "sieve_mm: sieve mm");
	for (size_t i = 0; i < b->n; i++) {
		FREED char *key = xasprintf("feed_%zu_pct", i + 1);
		FREED char *head = xasprintf(
		    "%s %%", file_name_without_folders(b->part[i].file));
		answer_add_column(r, key, head);
	}
	answer_add_columns(r, "feed_pct: blend %%");
	if (p != NULL)
		answer_add_columns(r, "passing_pct: product %%");
	if (p != NULL && p->low != NULL)
		answer_add_columns(r, "low_pct: low %%, high_pct: high %%");
	for (size_t k = 0; k < sieves->n; k++) {
		double x = sieves->size[k];
		answer_add_cells(r, "%g", units_m_to_mm(x));
		for (size_t i = 0; i < b->n; i++)
			answer_add_cells(r, "%.1f",
			    units_fraction_to_pct(
				psd_passing(b->part[i].feed, x)));
		answer_add_cells(
		    r, "%.1f", units_fraction_to_pct(psd_passing(&b->feed, x)));
		if (p != NULL)
			answer_add_cells(r, "%.1f",
			    units_fraction_to_pct(p->product.passing[k]));
		if (p != NULL && p->low != NULL)
			answer_add_cells(r, "%.1f %.1f",
			    units_fraction_to_pct(p->low[k]),
			    units_fraction_to_pct(p->high[k]));
	}
}

static void
put_blend_part_fields(struct fields *o, const struct blended *b)
{
	struct fields *list = fields_add_list(o, "parts");
	for (size_t i = 0; i < b->n; i++)
		fields_put_values(fields_add_object(list, NULL),
		    "file %s part %g share_pct %g rock %s provenance %s",
		    b->part[i].file, b->part[i].share,
		    100 * b->part[i].share / b->sum, b->part[i].sheet->rock,
		    b->part[i].sheet->provenance);
	fields_put_numbers(
	    o, "feed_sieve_mm", b->feed.size, b->feed.n, units_m_to_mm);
	fields_put_numbers(
	    o, "feed_pct", b->feed.passing, b->feed.n, units_fraction_to_pct);
}

static void
note_sum_of_blend_parts(struct answer *r, const struct blended *b)
{
	if (fabs(b->sum - 100) > 1e-9 && fabs(b->sum - 1) > 1e-9)
		answer_note(r,
		    "the parts sum to %g, not to 100: taken in proportion",
		    b->sum);
}

/* Notes down to which size the blend is known, and which sheets limit it. */
static void
note_feeds_limiting_fines(struct answer *r, const struct blended *b)
{
	double finest = b->feed.size[b->feed.n - 1];
	FREED char *unknown = xstrdup("");
	for (size_t i = 0; i < b->n; i++) {
		const struct psd *feed = b->part[i].feed;
		double own = feed->size[feed->n - 1];
		if (own == finest && feed->passing[feed->n - 1] > 0)
			xappend_to_list(&unknown, ", ", "%s",
			    file_name_without_folders(b->part[i].file));
	}
	if (unknown[0] != '\0')
		answer_add_sentence(r, ANSWER_REMARK,
		    "the blend is known down to %g mm, the finest sieve of %s",
		    units_m_to_mm(finest), unknown);
}

/* Shows the blend without a product, because it cannot be predicted. */
static void
show_blended_feed(
    struct session *s, const struct blended *b, const char *why_not)
{
	struct answer *r = answer_new("blend");
	answer_set_title(r, "blend of %s", b->words);
	answer_set_site(r, "blend", b->of);
	add_blend_rows(r, b, &b->feed, NULL);
	note_sum_of_blend_parts(r, b);
	note_feeds_limiting_fines(r, b);
	answer_note(r, "no product is predicted: %s", why_not);
	fields_put_values(answer_json_fields(r), "feed %s", b->words);
	put_blend_part_fields(answer_json_fields(r), b);
	session_show_answer(s, r);
}

static void
show_product_of_blend(
    struct session *s, const struct question *q, const struct blended *b)
{
	const struct entry *entry = q->entry;
	double v = q->speed;
	struct prediction p = forecast_whole_product(s, entry, v, q->feed);
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, v, NAN);
	struct answer *r = answer_new_about_site(entry->site, "blend",
	    "product at %g m/s%s (%.0f J/kg)", v, rpm, p.energy);
	add_blend_rows(r, b, &p.product, &p);
	put_blend_part_fields(answer_json_fields(r), b);
	answers_put_prediction_fields(
	    s, answer_json_fields(r), entry, &entry->params, &p);
	note_sum_of_blend_parts(r, b);
	answers_note_p_sizes(r, &p);
	if (p.low != NULL) {
		answer_add_columns_to_json_fields(r, "low_pct high_pct");
		answers_put_p_size_bands(answer_json_fields(r), s, &p);
	}
	answers_note_basis_and_trust_at_speed(s, r, q, v, p.low != NULL);
	prediction_free(&p);
	session_show_answer(s, r);
}

static void
show_blend(struct session *s, const struct args *args, const struct blended *b)
{
	struct error none = {0};
	bool loaded = s->n_entry > 0;
	if (!loaded || !answers_require_params_current_site(s, &none)) {
		show_blended_feed(
		    s, b, loaded ? none.text : tr("no site is loaded"));
		return;
	}
	const struct scenario scenario = {
	    .feed = b, .correction = s->set.correction};
	struct question q;
	question_set_from_scenario(
	    s, session_current_site_entry(s), &scenario, &q);
	q.speed =
	    args->speed > 0
		? args->speed
		: question_last_speed_or_usual(
		      s, answers_default_speed(session_current_site_entry(s)));
	show_product_of_blend(s, &q, b);
	question_free(s, &q);
}

/* Writes the blend as a sheet for load and feed=, with the rock type and the
 * provenance that its parts state. */
static bool
write_blend_as_sheet(struct session *s, const struct args *args,
    const struct blended *b, struct error *error)
{
	struct site *site = site_new(1);
	xfree_and_set(&site->name, xasprintf(tr("blend of %s"), b->words));
	xfree_and_set(&site->rock, xstrdup(b->rock));
	xfree_and_set(&site->provenance, xstrdup(b->of));
	site->run[0].feed = psd_copy(&b->feed);
	bool good = files_write_site(s, args, site, args->out, error);
	site_free(site);
	return good;
}

bool
cmd_blend(struct session *s, const struct args *args, struct error *error)
{
	struct blended *b = xcalloc(1, sizeof *b);
	bool good = true;
	for (size_t i = 0; good && i < args->n_operand; i++)
		good = read_blend_component(s, args->operand[i], b, error);
	if (good) {
		blended_mix_feeds(b);
		good = args->out == NULL ||
		       write_blend_as_sheet(s, args, b, error);
		if (good)
			show_blend(s, args, b);
	}
	blended_free(b);
	return good;
}
