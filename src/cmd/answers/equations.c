/* show equations: Eqs 1 to 5 as printed and as used, and for each departure the
 * result of the printed form at the current site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/lang/table.h"
#include "core/answer/predict.h"
#include "core/model/breakage.h"
#include "core/search/misfit.h"
#include "io/sitefile/units.h"

static const struct {
	const char *equation, *printed, *used;
} EQUATIONS[] = {
    {"Eq 1", "a_ij = beta1 + beta2 x_i + beta3 x_i^2 + beta4 x_i^3",
	"p(u) = max(0, beta1 + beta2 u + beta3 u^2 + beta4 u^3) over ln u, "
	"u = progeny / parent, its sum 1 (D3, D4)"},
    {"Eq 2", "P = [B S f + (I - S) f]",
	"P(s) = F(s) + integral over x > s of S(x) B(s/x) dF(x); 'set method "
	"classes' has the matrices"},
    {"Eq 3", "S = [1 - exp(f_mat x_i^alpha k (E_CS - E0_min / x_i^alpha))]",
	"S(x) = 1 - exp(-f_mat k (x^alpha E - e0_min)), 0 where x^alpha E < "
	"e0_min, x in m (D1, D2)"},
    {"Eq 4", "E_CS = v_rotor^2 / 2", "E = v^2 / 2"},
    {"Eq 5",
	"E = sum of ((P_exp,high - P_sim,high)^2 - (P_exp,low - P_sim,low)^2)",
	"E = sum of ((measured - simulated)^2 at both speeds) (D6)"}};

/* The basis of the examples: the site, its parameters, and its slowest and
 * fastest run, which stand for the two speeds of Eq 5. */
struct equation_example {
	const struct site *site;
	const struct params *p;
	struct model_settings settings;
	size_t low, high;
};

/* Returns the exponent t in S = 1 - exp(-t) of Eq 3, without the floor at 0.
 * x: in m as used, or in mm to show the effect (D2). */
static double
exponent_of_eq3(const struct equation_example *w, double x, double speed)
{
	const struct params *p = w->p;
	return p->f_mat * w->settings.k *
	       (pow(x, p->alpha) * speed * speed / 2 - p->e0_min);
}

/* Returns the middle, in log size, of the coarsest size class that breaks or,
 * unless `breaks`, of the coarsest that does not, m; NAN if there is none. */
static double
midpoint_of_coarsest_broken_class(
    const struct equation_example *w, double speed, bool breaks)
{
	const struct psd *feed = site_feed_of_run(w->site, SITE_MEAN_FEED);
	for (size_t i = 0; i + 1 < feed->n; i++) {
		double x = sqrt(feed->size[i] * feed->size[i + 1]);
		if ((exponent_of_eq3(w, x, speed) > 0) == breaks)
			return x;
	}
	return NAN;
}

/* Returns a share, %, as text; of one too large for a double, its bound.  The
 * caller frees it. */
static char *
share_text(double pct)
{
	return isfinite(pct) ? xasprintf("%.3g %%", pct)
			     : xstrdup(tr("below -1e+308 %"));
}

static void
note_effect_of_misprinted_sign(
    struct answer *r, const struct equation_example *w, double speed)
{
	double coarse = midpoint_of_coarsest_broken_class(w, speed, true),
	       fine = midpoint_of_coarsest_broken_class(w, speed, false);
	struct fields *o = fields_add_object(answer_json_fields(r), "d1");
	if (!isnan(coarse)) {
		double t = exponent_of_eq3(w, coarse, speed);
		fields_put_values(o, "coarse_mm %g used_pct %g printed_pct %g",
		    units_m_to_mm(coarse), -100 * expm1(-t), -100 * expm1(t));
		FREED char *share = share_text(-100 * expm1(t));
		answer_note(r,
		    "D1, the sign: at %g m/s S of %.3g mm is %.1f %%; as "
		    "printed it is %s",
		    speed, units_m_to_mm(coarse), -100 * expm1(-t), share);
	}
	if (!isnan(fine)) {
		double t = exponent_of_eq3(w, fine, speed);
		fields_put_values(o, "fine_mm %g no_floor_pct %g",
		    units_m_to_mm(fine), -100 * expm1(-t));
		FREED char *share = share_text(-100 * expm1(-t));
		answer_note(r,
		    "D1, the floor: %.3g mm is below the break size and does "
		    "not break; without the floor its S is %s",
		    units_m_to_mm(fine), share);
	}
}

/* Returns the share of the feed that would break if x were in millimetres. */
static double
broken_share_with_x_in_mm(const struct equation_example *w, double speed)
{
	const struct psd *feed = site_feed_of_run(w->site, SITE_MEAN_FEED);
	double sum = 0;
	for (size_t i = 0; i + 1 < feed->n; i++) {
		double mm =
		    units_m_to_mm(sqrt(feed->size[i] * feed->size[i + 1]));
		double t = exponent_of_eq3(w, mm, speed);
		sum += (feed->passing[i] - feed->passing[i + 1]) *
		       (t > 0 ? -expm1(-t) : 0);
	}
	return sum;
}

static void
note_effect_of_millimetres(struct answer *r, const struct equation_example *w)
{
	double speed[2] = {w->site->run[w->low].speed,
	    w->site->run[w->high].speed},
	       metres[2], mm[2];
	for (size_t i = 0; i < 2; i++) {
		struct prediction p = predict_with_model_alone(
		    w->site, w->p, w->settings, speed[i], SITE_MEAN_FEED);
		metres[i] = 100 * p.selected;
		mm[i] = 100 * broken_share_with_x_in_mm(w, speed[i]);
		prediction_free(&p);
	}
	fields_put_values(fields_add_object(answer_json_fields(r), "d2"),
	    "low_pct %g high_pct %g mm_low_pct %g mm_high_pct %g", metres[0],
	    metres[1], mm[0], mm[1]);
	answer_note(r,
	    "D2, metres: %.1f %% of the feed breaks at %g m/s and %.1f %% at "
	    "%g m/s; with x in millimetres it would be %.1f %% and %.1f %%, "
	    "whatever the speed",
	    metres[0], speed[0], metres[1], speed[1], mm[0], mm[1]);
}

/* Returns the RMSE of the parameters, points, at the two runs. */
static double
rmse_of_params_at_runs(
    const struct equation_example *w, struct model_settings settings)
{
	FREED bool *train = xcalloc(w->site->n_run, sizeof *train);
	train[w->low] = train[w->high] = true;
	struct misfit *m = misfit_new(w->site, train, NULL, false, settings);
	double rmse = 100 * misfit_rmse(m, w->p);
	misfit_free(m);
	return rmse;
}

/* Says what the literal reading gives: each progeny class has the same share,
 * whatever beta is, unless p of a parent's size is negative, which is clipped
 * (D4). */
static void
note_effect_of_literal_appearance(
    struct answer *r, const struct equation_example *w)
{
	struct model_settings literal = w->settings;
	struct params other = *w->p;
	double speed = w->site->run[w->high].speed, most = 0;
	literal.method = METHOD_CLASSES;
	literal.appearance = APPEARANCE_PARENT_MM;
	for (size_t i = 0; i < 4; i++)
		other.beta[i] = i == 0;
	struct prediction a = predict_with_model_alone(
			      w->site, w->p, literal, speed, SITE_MEAN_FEED),
			  b = predict_with_model_alone(
			      w->site, &other, literal, speed, SITE_MEAN_FEED);
	for (size_t i = 0; i < a.product.n; i++)
		most = fmax(most,
		    100 * fabs(a.product.passing[i] - b.product.passing[i]));
	prediction_free(&a);
	prediction_free(&b);
	double off = rmse_of_params_at_runs(w, literal),
	       used = rmse_of_params_at_runs(w, w->settings);
	fields_put_values(fields_add_object(answer_json_fields(r), "d3"),
	    "beta_moves_pct %g literal_rmse_pct %g used_rmse_pct %g", most, off,
	    used);
	bool clipped = most >= 1e-9;
	answer_note(r,
	    clipped ? N_("D3, the progeny: with x_i the parent's size all "
			 "progeny classes get the same share, except where p "
			 "of that size in mm is negative: there it is clipped "
			 "to 0 (D4) and the parent keeps its size; beta 1, 0, "
			 "0, 0, which is never clipped, moves the product by "
			 "%.2g points; it misses the two runs by %.2f points "
			 "(RMSE), u = progeny / parent by %.2f")
		    : N_("D3, the progeny: with x_i the parent's size all "
			 "progeny classes get the same share, and beta 1, 0, "
			 "0, 0 moves the product by %.2g points; it misses the "
			 "two runs by %.2f points (RMSE), u = progeny / parent "
			 "by %.2f"),
	    clipped ? most : 0, off, used);
}

/* Searches a grid over the bounds of Table 2 for parameters with a smaller Eq 5
 * as printed than *best, and sets *best to the best of them.  Returns the
 * smallest value. */
static double
minimise_printed_eq5(const struct equation_example *w, struct misfit *low,
    struct misfit *high, struct params *best)
{
	enum { STEPS = 8 };
	const struct bounds b = bounds_default(0);
	double least =
	    misfit_of_params(high, best) - misfit_of_params(low, best);
	struct params p = *w->p;
	for (size_t i = 0; i < STEPS * STEPS * STEPS; i++) {
		size_t at[] = {i % STEPS, i / STEPS % STEPS, i / STEPS / STEPS};
		for (size_t j = 0; j < 3; j++)
			p.at[4 + j] =
			    b.lower[4 + j] + (b.upper[4 + j] - b.lower[4 + j]) *
						 (double)at[j] / (STEPS - 1);
		double printed =
		    misfit_of_params(high, &p) - misfit_of_params(low, &p);
		if (printed < least) {
			least = printed;
			*best = p;
		}
	}
	return least;
}

static void
note_effect_of_printed_eq5_minus(
    struct answer *r, const struct equation_example *w)
{
	struct misfit *m[2];
	for (size_t i = 0; i < 2; i++) {
		FREED bool *train = xcalloc(w->site->n_run, sizeof *train);
		train[i == 0 ? w->low : w->high] = true;
		m[i] = misfit_new(w->site, train, NULL, false, w->settings);
	}
	struct params best = *w->p;
	double own =
	    misfit_of_params(m[1], &best) - misfit_of_params(m[0], &best);
	double least = minimise_printed_eq5(w, m[0], m[1], &best);
	double off[2];
	for (size_t i = 0; i < 2; i++)
		off[i] = 100 * misfit_rmse(m[i], &best);
	fields_put_values(fields_add_object(answer_json_fields(r), "d6"),
	    "own %g least %g low_rmse_pct %g high_rmse_pct %g", own, least,
	    off[0], off[1]);
	answer_note(r,
	    "D6, the minus: Eq 5 as printed is %.3g for the site's parameters "
	    "and would prefer f_mat %.3g, e0_min %.3g, alpha %.3g with %.3g, "
	    "which miss %g m/s by %.1f points and %g m/s by %.1f",
	    own, best.f_mat, best.e0_min, best.alpha, least,
	    w->site->run[w->low].speed, off[0], w->site->run[w->high].speed,
	    off[1]);
	misfit_free(m[0]);
	misfit_free(m[1]);
}

/* Finds the slowest and the fastest run with a product.  Returns false unless
 * their speeds differ. */
static bool
find_slowest_and_fastest_run(struct equation_example *w)
{
	FREED bool *train = xcalloc(w->site->n_run, sizeof *train);
	size_t n = misfit_mark_default_training(w->site, train), found = 0;
	for (size_t i = 0; i < w->site->n_run && n > 0; i++) {
		if (!train[i])
			continue;
		w->low = found++ == 0 ? i : w->low;
		w->high = i;
	}
	return found > 1 &&
	       w->site->run[w->low].speed < w->site->run[w->high].speed;
}

/* Shows the effect of each departure at the site in use, if it has parameters
 * of the paper's model. */
static void
note_effects_of_paper_departures(struct answer *r, const struct session *s)
{
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	struct equation_example w = {.settings = s->set.model};
	if (entry == NULL || !entry->has_params) {
		answer_note(r, "load and calibrate a site to see what the "
			       "printed forms give there");
		return;
	}
	if (entry->params.breakage != 0 || s->set.model.impacts.n > 0) {
		answer_note(r, "what the printed forms give is worked out for "
			       "the paper's model with one impact: 'set model "
			       "grunditz', 'set energy off', then 'calibrate'");
		return;
	}
	w.site = entry->site;
	w.p = &entry->params;
	note_effect_of_misprinted_sign(r, &w, answers_default_speed(entry));
	if (!find_slowest_and_fastest_run(&w))
		return;
	note_effect_of_millimetres(r, &w);
	note_effect_of_literal_appearance(r, &w);
	note_effect_of_printed_eq5_minus(r, &w);
}

/* Returns equation i as the site's answers use it.  The caller frees it. */
static char *
equation_text_as_used(const struct session *s, size_t i)
{
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	bool other =
	    entry != NULL && entry->has_params && entry->params.breakage != 0;
	if (other && strcmp(EQUATIONS[i].equation, "Eq 1") == 0)
		return breakage_model_of_params(&entry->params)
		    ->appearance_text(&entry->params);
	if (s->set.model.impacts.n > 0 &&
	    strcmp(EQUATIONS[i].equation, "Eq 3") == 0)
		return xstrdup(
		    "S(x) = 1 - (sum of share_j exp(-f_mat k (x^alpha ratio_j "
		    "E - e0_min)))^n over groups j of n impacts, each bracket "
		    "0 where negative, x in m (D1, D2, D15)");
	return xstrdup(EQUATIONS[i].used);
}

bool
show_equations(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct answer *r =
	    s->n_entry > 0
		? answer_new_about_site(s->entry[s->current].site, "show",
		      "the equations, as printed and as used")
		: answer_new("show");
	answer_add_columns(r, "equation, as: , formula");
	for (size_t i = 0; i < ARRAY_LEN(EQUATIONS); i++) {
		answer_add_cells(r, "%s %s %s", EQUATIONS[i].equation,
		    tr("printed"), EQUATIONS[i].printed);
		FREED char *used = equation_text_as_used(s, i);
		answer_add_cells(r, "%s %s %s", "", tr("used"), used);
	}
	answer_begin_table_for_programs(r);
	answer_add_columns(r, "equation, printed, used");
	for (size_t i = 0; i < ARRAY_LEN(EQUATIONS); i++) {
		FREED char *used = equation_text_as_used(s, i);
		answer_add_cells(r, "%s %s %s", EQUATIONS[i].equation,
		    EQUATIONS[i].printed, used);
	}
	answer_add_rows_as_json_objects(r, "equations");
	fields_put_values(answer_json_fields(r), "what %s", "equations");
	note_effects_of_paper_departures(r, s);
	answer_note(r, "'man model' lists the departures D1, D2 ..");
	return session_show_answer(s, r);
}
