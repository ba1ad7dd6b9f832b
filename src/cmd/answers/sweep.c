/* sweep: products over a range of speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/table.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/question.h"
#include "cmd/ask/screened.h"
#include "core/answer/predict.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

/* Adds a row for each end of the band of a size: P20, P50 or P80. */
static void
add_p_size_band_rows(
    struct answer *r, const struct prediction *p, size_t n, size_t size)
{
	static const char *const ENDS[] = {N_("  low"), N_("  high")};
	for (size_t end = 0; end < 2; end++) {
		answer_add_cells(r, "%s", tr(ENDS[end]));
		answer_set_missing_text(r, "");
		answer_add_cells(r, "%.0f", NAN);
		for (size_t i = 0; i < n; i++)
			answer_add_cells(
			    r, "%.2f", 1000 * p[i].range[size][end]);
	}
}

/* Adds a row with the speeds in the other unit: in m/s if the headings are in
 * rpm, otherwise in rpm. */
static void
add_row_of_other_speed_unit(struct answer *r, const struct site *site,
    const struct prediction *p, size_t n)
{
	bool in_rpm = answers_is_sheet_in_rpm(site);
	answer_add_text_cell(r, in_rpm ? "m/s" : N_("rpm"));
	answer_set_missing_text(r, "");
	answer_add_cells(r, "%.0f", NAN);
	for (size_t i = 0; i < n; i++)
		if (in_rpm)
			answer_add_cells(r, "%g", p[i].speed);
		else
			answer_add_cells(r, "%.0f",
			    rotor_speed_to_rpm(p[i].speed, site->rotor));
}

/* Puts sieves down and speeds across, for as many speeds as fit a screen. */
static void
add_sieve_rows_with_speed_columns(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n)
{
	FREED double *feed = screened_feed_passings(&p[0]);
	answer_add_columns(r, "sieve_mm: sieve mm, feed_pct: feed %%");
	for (size_t i = 0; i < n; i++) {
		bool outside = answers_is_speed_extrapolated(entry, p[i].speed);
		FREED char *head =
		    answers_speed_text(entry->site, p[i].speed, -1);
		answer_add_columns(r, "passing_pct@%g: %s%s", p[i].speed, head,
		    outside ? "*" : "");
	}
	if (entry->site->rotor > 0)
		add_row_of_other_speed_unit(r, entry->site, p, n);
	for (size_t row = 0; row < p[0].product.n; row++) {
		answer_add_text_cell(
		    r, "%g", units_m_to_mm(p[0].product.size[row]));
		answer_add_cells(r, "%.1f", units_fraction_to_pct(feed[row]));
		for (size_t i = 0; i < n; i++)
			answer_add_cells(r, "%.1f",
			    units_fraction_to_pct(p[i].product.passing[row]));
	}
	if (fraction_is_screened(&p[0].fraction)) {
		answer_add_cells(r, "%s", tr("share %"));
		answer_set_missing_text(r, "");
		answer_add_cells(r, "%.0f", NAN);
		for (size_t i = 0; i < n; i++)
			answer_add_cells(
			    r, "%.1f", units_fraction_to_pct(p[i].share));
	}
	for (size_t size = 0; size < ANSWERS_SIZES; size++) {
		answer_add_cells(r, "%s", tr(ANSWERS_SIZE[size].head));
		answer_set_missing_text(r, "");
		answer_add_cells(r, "%.0f", NAN);
		for (size_t i = 0; i < n; i++)
			answers_add_size_cell(r, &p[i], size);
		if (p[0].low != NULL && size != ANSWERS_BREAK)
			add_p_size_band_rows(r, p, n, size);
	}
}

static void
add_sweep_row(struct answer *r, const struct prediction *p, const double *feed,
    size_t j, bool outside)
{
	bool band = p->low != NULL;
	answer_add_cells(r, "%g %s %g %.1f %.1f %.1f %.1f %.1f", p->speed,
	    outside ? tr("yes") : tr("no"), units_m_to_mm(p->product.size[j]),
	    units_fraction_to_pct(feed[j]),
	    units_fraction_to_pct(p->product.passing[j]),
	    band ? units_fraction_to_pct(p->low[j]) : NAN,
	    band ? units_fraction_to_pct(p->high[j]) : NAN,
	    units_fraction_to_pct(p->model[j]));
	if (fraction_is_screened(&p->fraction))
		answer_add_cells(r, "%.1f", units_fraction_to_pct(p->share));
}

/* Adds a row for each speed and sieve, for spreadsheets and programs. */
static void
add_sweep_rows_by_speed_and_sieve(struct answer *r, const struct entry *entry,
    const struct prediction *p, size_t n)
{
	answer_add_columns(r, "speed: m/s, extrapolated, sieve_mm: sieve mm, "
			      "feed_pct: feed %%, passing_pct: product %%, "
			      "low_pct: low %%, high_pct: high %%, "
			      "model_pct: model alone %%");
	if (fraction_is_screened(&p[0].fraction))
		answer_add_columns(r, "share_pct: share %%");
	for (size_t i = 0; i < n; i++) {
		bool outside = answers_is_speed_extrapolated(entry, p[i].speed);
		FREED double *feed = screened_feed_passings(&p[i]);
		for (size_t j = 0; j < p[i].product.n; j++)
			add_sweep_row(r, &p[i], feed, j, outside);
	}
}

/* Builds the answer.  outside: at least one speed is outside the training
 * speeds. */
static struct answer *
build_sweep_answer(const struct session *s, const struct question *q,
    const struct prediction *p, size_t n, bool outside)
{
	const struct entry *entry = q->entry;
	enum { ACROSS = 7 };
	bool band = p[0].low != NULL, across = n <= ACROSS;
	FREED char *fraction = screened_fraction_title_suffix(&p[0].fraction);
	struct answer *r = answer_new_about_site(entry->site, "sweep",
	    "products, %% passing%s%s%s", fraction, band ? ", " : "",
	    band ? correction_in_words(s, entry) : "");
	(across ? add_sieve_rows_with_speed_columns
		: answers_add_row_per_prediction)(r, entry, p, n);
	answer_begin_table_for_programs(r);
	add_sweep_rows_by_speed_and_sieve(r, entry, p, n);
	if (outside && across)
		answer_add_sentence(r, ANSWER_WARNING,
		    "speeds marked * are outside the training speeds");
	answers_note_basis_and_trust(s, r, q, 0, band && across,
	    trust_worst_of_predictions(s, entry, p, n));
	answers_put_products(s, answer_json_fields(r), entry, p, n);
	return r;
}

bool
cmd_sweep(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct entry *entry = q->entry;
	(void)args;
	question_use_default_speeds(s, q, false);
	size_t n = q->n_at;
	FREED struct prediction *p = xcalloc(n, sizeof *p);
	bool outside = false, ok = screened_check_feed_covers(q, error);
	for (size_t i = 0; i < n && ok; i++) {
		p[i] = forecast_product(s, q, q->at[i]);
		outside =
		    outside || answers_is_speed_extrapolated(entry, q->at[i]);
		n = session_is_interrupted(s) ? i + 1 : n;
	}
	if (ok)
		session_show_answer(s, build_sweep_answer(s, q, p, n, outside));
	for (size_t i = 0; i < n; i++)
		prediction_free(&p[i]);
	return ok;
}
