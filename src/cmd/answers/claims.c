/* show claims: the paper's conclusions, compared with the loaded and calibrated
 * sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/fit/trials.h"
#include "cmd/lang/table.h"
#include "core/answer/predict.h"
#include "core/model/breakage.h"

/* The loaded sites [n] with a fit of the paper's model, their held-out runs,
 * and the rows of Table 3. */
struct claim_evidence {
	size_t n;
	const struct entry **fit;
	struct trials runs;
	struct model_settings settings;
	struct material_list paper;
};

static void
collect_fitted_sites(struct claim_evidence *c, const struct session *s)
{
	c->settings = s->set.model;
	material_add_table3_to_list(&c->paper);
	c->fit = xcalloc(s->n_entry + 1, sizeof(*c->fit));
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *e = &s->entry[i];
		if (!e->has_fit || e->params.breakage != 0)
			continue;
		c->fit[c->n++] = e;
		trials_add_held_out_runs_of_site(&c->runs, s, i, NULL);
	}
}

/* Adds a claim, whether these data bear it out, and the figures that show it,
 * as a paragraph for people and as a row for programs.  Frees the figures. */
static void
add_claim_verdict(
    struct answer *r, const char *words, bool borne_out, char *figures)
{
	answer_note(r,
	    borne_out ? N_("borne out: %s. %s") : N_("NOT borne out: %s. %s"),
	    tr(words), figures);
	answer_add_cells(
	    r, "%s %s %s", words, borne_out ? "yes" : "no", figures);
	free(figures);
}

/* Returns how many rows of Table 3 have a property at a bound of Table 2. */
static size_t
count_table3_rows_at_bound(const struct material_list *paper)
{
	const struct bounds b = bounds_default(0);
	size_t n = 0;
	for (size_t i = 0; i < paper->n; i++) {
		bool any = false;
		for (size_t j = 4; j < 7; j++) {
			double x = paper->item[i].params.at[j];
			any = any || x <= b.lower[j] || x >= b.upper[j];
		}
		n += any;
	}
	return n;
}

static void
check_claim_params_within_bounds(
    struct answer *r, const struct claim_evidence *c)
{
	size_t bound = 0;
	double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {0};
	for (size_t i = 0; i < c->n; i++) {
		bool any = false;
		for (size_t j = 0; j < 3; j++) {
			double x = c->fit[i]->fit.params.at[4 + j];
			low[j] = fmin(low[j], x);
			high[j] = fmax(high[j], x);
			any = any || c->fit[i]->fit.on_bound[4 + j];
		}
		bound += any;
	}
	add_claim_verdict(r, N_("properties converge within the range of rock"),
	    bound == 0,
	    xasprintf(tr("f_mat %.2f to %.2f, e0_min %.1f to %.1f, alpha %.2f "
			 "to %.2f; at %zu of %zu sites one ends at a bound of "
			 "Table 2, in %zu of %zu rows of Table 3: such fits do "
			 "not determine the properties, whatever these are"),
		low[0], high[0], low[1], high[1], low[2], high[2], bound, c->n,
		count_table3_rows_at_bound(&c->paper), c->paper.n));
}

static void
check_claim_p50_differs_least(struct answer *r, const struct claim_evidence *c)
{
	double rms[PSD_SIZES];
	for (size_t i = 0; i < PSD_SIZES; i++)
		rms[i] =
		    100 * trials_score_at_size(&c->runs, VALIDATE_MODEL, i).rms;
	add_claim_verdict(r, N_("P50 differs least"),
	    rms[1] < rms[0] && rms[1] < rms[2],
	    xasprintf(tr("relative RMS of P20 %.2f %%, P50 %.2f %%, P80 %.2f "
			 "%% over %zu held-out runs"),
		rms[0], rms[1], rms[2], c->runs.n));
	add_claim_verdict(r, N_("the tails are predicted less well"),
	    rms[0] > rms[1] && rms[2] > rms[1],
	    xasprintf(rms[0] > rms[1]
			  ? (rms[2] > rms[1] ? tr("both, P20 and P80")
					     : tr("P20 does, P80 does not"))
			  : (rms[2] > rms[1] ? tr("P80 does, P20 does not")
					     : tr("neither P20 nor P80"))));
}

static void
check_claim_f_mat_opposes_e0_min(
    struct answer *r, const struct claim_evidence *c)
{
	size_t most = c->n > c->paper.n ? c->n : c->paper.n;
	FREED double *x = xcalloc_doubles(most), *y = xcalloc_doubles(most);
	for (size_t i = 0; i < c->paper.n; i++) {
		x[i] = params_value_by_name(&c->paper.item[i].params, "f_mat");
		y[i] = params_value_by_name(&c->paper.item[i].params, "e0_min");
	}
	double printed = gsl_stats_correlation(x, 1, y, 1, c->paper.n);
	for (size_t i = 0; i < c->n; i++) {
		x[i] = params_value_by_name(&c->fit[i]->params, "f_mat");
		y[i] = params_value_by_name(&c->fit[i]->params, "e0_min");
	}
	double fitted = gsl_stats_correlation(x, 1, y, 1, c->n);
	FREED char *fits =
	    c->n > 2 ? xasprintf(tr(", %+.2f over the %zu fits"), fitted, c->n)
		     : xstrdup("");
	/* Chance alone goes that far from 0 once in 20: t is about 2. */
	const double beyond = 2.1 / sqrt(2.1 * 2.1 + (double)c->paper.n - 2);
	add_claim_verdict(r,
	    N_("high f_mat goes with low e0_min, and the reverse"),
	    c->paper.n > 2 && printed < -beyond,
	    xasprintf(tr("correlation %+.2f over the %zu rows of Table 3%s; "
			 "chance alone goes beyond %.2f once in 20"),
		printed, c->paper.n, fits, beyond));
}

/* For a reconstructed site the true product is known at any speed: its row of
 * Table 3 gives it. */
static void
check_claim_of_extrapolation(struct answer *r, const struct claim_evidence *c)
{
	static const double SPEED[] = {65, 85};
	const double far = 1;
	FREED double *off = xcalloc_doubles(2 * c->n + 1);
	size_t n = 0, well = 0;
	for (size_t i = 0; i < c->n; i++) {
		const struct site *site = c->fit[i]->site;
		FREED char *name = xasprintf("table3/%s", c->fit[i]->key);
		const struct material *m = material_find(&c->paper, name);
		for (size_t k = 0; m != NULL && k < ARRAY_LEN(SPEED); k++) {
			struct prediction p = predict_with_model_alone(site,
					      &c->fit[i]->params, c->settings,
					      SPEED[k], SITE_MEAN_FEED),
					  q = predict_with_model_alone(site,
					      &m->params, c->settings, SPEED[k],
					      SITE_MEAN_FEED);
			off[n] =
			    100 * psd_rms_difference(p.product.passing,
				      q.product.passing, p.product.n, NULL);
			well += off[n++] < far;
			prediction_free(&p);
			prediction_free(&q);
		}
	}
	gsl_sort(off, 1, n);
	if (n > 0)
		add_claim_verdict(r,
		    N_("65 and 85 m/s can be predicted from 69 and 79"),
		    well == n,
		    xasprintf(
			tr("against the product that the row's own parameters "
			   "give: RMSE %.2f points (median of %zu), %.2f at "
			   "worst (none should exceed 1); energies %+.1f and "
			   "%+.1f %% (the text has -12 and 15)"),
			off[n / 2], n, off[n - 1],
			100 * (65 * 65 / (69. * 69) - 1),
			100 * (85 * 85 / (79. * 79) - 1)));
}

static void
check_claim_middle_speed_verifies(
    struct answer *r, const struct claim_evidence *c)
{
	size_t wins = 0, n = 0;
	double sum[2] = {0};
	for (size_t i = 0; i < c->runs.n; i++) {
		double own = c->runs.item[i].v.rmse[VALIDATE_MODEL],
		       line = c->runs.item[i].v.rmse[VALIDATE_INTERPOLATION];
		if (isnan(line))
			continue;
		n++;
		wins += own < line;
		sum[0] += own * own;
		sum[1] += line * line;
	}
	if (n > 0)
		add_claim_verdict(r, N_("the middle speed verifies the model"),
		    sum[0] < sum[1],
		    xasprintf(tr("RMSE %.2f points at held-out speeds, "
				 "straight interpolation of the two training "
				 "products %.2f; the model is nearer in %zu of "
				 "%zu runs"),
			100 * sqrt(sum[0] / (double)n),
			100 * sqrt(sum[1] / (double)n), wins, n));
}

/* D11. */
static void
check_claim_f_mat_is_resistance(
    struct answer *r, const struct claim_evidence *c)
{
	size_t more = 0;
	double sum = 0;
	for (size_t i = 0; i < c->n; i++) {
		struct params p = c->fit[i]->params;
		double speed = site_middle_speed(c->fit[i]->site), share[2];
		for (size_t k = 0; k < 2; k++) {
			struct prediction of =
			    predict_with_model_alone(c->fit[i]->site, &p,
				c->settings, speed, SITE_MEAN_FEED);
			share[k] = 100 * of.selected;
			prediction_free(&of);
			p.f_mat *= 1.1;
		}
		more += share[1] > share[0];
		sum += (share[1] - share[0]) / (double)c->n;
	}
	add_claim_verdict(r,
	    N_("f_mat is a resistance: the lower it is, the more breaks"),
	    more == 0,
	    xasprintf(tr("by Eq 3 10 %% more f_mat breaks more of the feed at "
			 "%zu of %zu sites, by %+.2f points on average"),
		more, c->n, sum));
}

bool
show_claims(struct session *s, const struct args *args, struct error *error)
{
	struct claim_evidence c = {0};
	struct sources all = {0};
	(void)args;
	collect_fitted_sites(&c, s);
	bool any = c.n > 0 && c.runs.n > 0;
	struct answer *r = answer_new("show");
	answer_begin_table_for_programs(r);
	answer_add_columns(r, "claim, borne_out, figures");
	for (size_t i = 0; i < c.n; i++)
		sources_add_site(&all, c.fit[i]->key, c.fit[i]->site);
	FREED char *about = sources_text_and_clear(&all);
	answer_set_title(r,
	    "claims of Grunditz et al. (2021), at %zu calibrated sites", c.n);
	answer_set_site_names(r, "", about);
	if (any) {
		check_claim_params_within_bounds(r, &c);
		check_claim_middle_speed_verifies(r, &c);
		check_claim_p50_differs_least(r, &c);
		check_claim_of_extrapolation(r, &c);
		check_claim_f_mat_opposes_e0_min(r, &c);
		check_claim_f_mat_is_resistance(r, &c);
	}
	answer_add_rows_as_json_objects(r, "claims");
	fields_put_values(
	    answer_json_fields(r), "what %s sites %zu", "claims", c.n);
	if (strstr(about, "reconstructed") != NULL)
		answer_add_sentence(r, ANSWER_REMARK,
		    "reconstructed data are made by the model itself: they can "
		    "show that its calibration works, not that rock breaks "
		    "this way");
	free(c.fit);
	trials_clear(&c.runs);
	material_list_free(&c.paper);
	if (any)
		return session_show_answer(s, r);
	answer_free(r);
	return error_set(error, ERROR_USAGE,
	    "no loaded site has a fit of the paper's model and a held-out run\n"
	    "load sites with three speeds, then run 'calibrate all'");
}
