/* Plots of a session: every kind at every size, and what they are made from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "desk.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/plots.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "cmd/session/invocation.h"

static const char PARAMS_SET[] =
    "params set f_mat=2.18 e0_min=16.74 alpha=0.96";
static const char SEARCH[] =
    "calibrate seed=3 population=60 generations=30 tolerance=0 stall=0";
enum { KINDS = PLOT_SWEEP + 1 };

static int
open_with_site(void **state)
{
	desk_open(state);
	desk_expect(*state, "load data/sites/tierp.csv");
	return 0;
}

static struct chart *
chart_of(struct desk *desk, const struct plot_request *request)
{
	desk->error = (struct error){0};
	struct chart *chart =
	    plots_make_chart(desk->session, request, &desk->error);
	if (chart == NULL)
		fail_msg("%s", desk->error.text);
	return chart;
}

static void
every_kind_fits_every_size(void **state)
{
	static const int sizes[][2] = {{20, 5}, {80, 24}, {300, 100}, {1, 1}};
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	for (int kind = 0; kind < KINDS; kind++)
		for (size_t i = 0; i < 12; i++) {
			struct plot_request q =
			    plots_default_request((enum plot_kind)kind);
			const int *size = sizes[i % 4];
			q.charset = (enum charset)(i / 4);
			q.other_speed = 60;
			q.crosshair_mm = 3;
			q.band = true;
			struct canvas *c = plots_draw_canvas(
			    desk->session, &q, size[0], size[1], &desk->error);
			assert_non_null(c);
			assert_int_equal(c->columns, size[0]);
			assert_int_equal(c->rows, size[1]);
			canvas_free(c);
		}
}

static bool
is_of_a_run(enum series series)
{
	return series >= SERIES_MEASURED_1 && series <= SERIES_MEASURED_4;
}

/* Without colour: by mark, or by line where there are none; in ASCII a line has
 * its character.  Predicted runs are told by the marks that they run along. */
static bool
look_alike(const struct chart_series *a, const struct chart_series *b)
{
	if (a->line == CHART_DASHED && is_of_a_run(a->series) &&
	    is_of_a_run(b->series))
		return a->ascii == b->ascii;
	if (a->mark != b->mark)
		return false;
	return a->mark != 0 || a->line == b->line || a->ascii == b->ascii;
}

static void
no_two_series_look_alike(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	for (int kind = 0; kind < KINDS; kind++) {
		struct plot_request q =
		    plots_default_request((enum plot_kind)kind);
		q.other_speed = 80;
		struct chart *c = chart_of(desk, &q);
		assert_true(c->n > 0);
		for (size_t i = 0; i < c->n; i++)
			for (size_t j = 0; j < i; j++)
				assert_false(
				    look_alike(c->series[i], c->series[j]));
		chart_free(c);
	}
}

/* Only what belongs to a measured run has a run's colour, and that its own. */
static void
colours_of_runs_are_of_runs_alone(void **state)
{
	static const enum plot_kind NO_RUN[] = {PLOT_PARITY, PLOT_CONVERGENCE,
	    PLOT_SPREAD, PLOT_SELECTION, PLOT_APPEARANCE, PLOT_MAP, PLOT_SWEEP,
	    PLOT_RESPONSE, PLOT_PROFILE, PLOT_CORRELATION};
	static const enum plot_kind RUNS[] = {
	    PLOT_PSD, PLOT_RUNS, PLOT_RESIDUALS, PLOT_SEARCH};
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	for (size_t k = 0; k < ARRAY_LEN(NO_RUN); k++) {
		struct plot_request q = plots_default_request(NO_RUN[k]);
		struct chart *c = chart_of(desk, &q);
		for (size_t i = 0; i < c->n; i++)
			assert_false(is_of_a_run(c->series[i]->series));
		chart_free(c);
	}
	for (size_t k = 0; k < ARRAY_LEN(RUNS); k++) {
		struct plot_request q = plots_default_request(RUNS[k]);
		struct chart *c = chart_of(desk, &q);
		size_t n = 0;
		for (size_t i = 0; i < c->n; i++) {
			static const struct {
				const char *speed;
				enum series series;
			} OF[] = {{"69 m/s", SERIES_MEASURED_1},
			    {"74 m/s", SERIES_MEASURED_2},
			    {"79 m/s", SERIES_MEASURED_3}};
			const struct chart_series *s = c->series[i];
			for (size_t r = 0; r < ARRAY_LEN(OF); r++)
				if (is_of_a_run(s->series) &&
				    strstr(s->name, OF[r].speed) != NULL) {
					assert_int_equal(
					    s->series, OF[r].series);
					n++;
				}
		}
		assert_true(n >= 2);
		chart_free(c);
	}
}

static void
every_sieve_of_the_sheet_is_a_tick(void **state)
{
	struct desk *desk = *state;
	const struct site *site =
	    session_current_site_entry(desk->session)->site;
	struct plot_request q = plots_default_request(PLOT_PSD);
	struct chart *c = chart_of(desk, &q);
	const struct psd *psd = &site->run[0].product;
	assert_int_equal(c->x.n, psd->n);
	for (size_t i = 0; i < psd->n; i++)
		assert_true(fabs(c->x.tick[psd->n - 1 - i].at -
				 1000 * psd->size[i]) < 1e-9);
	chart_free(c);
}

static void
a_running_search_shows_its_best_so_far(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	size_t next = 0;
	desk_expect(desk, PARAMS_SET);
	assert_true(
	    session_run_line(s, SEARCH, 0, "t", 1, &next, &desk->error));
	for (int i = 0; i < 5; i++)
		session_step_job(s);
	struct plot_request q = plots_default_request(PLOT_CONVERGENCE);
	struct chart *c = chart_of(desk, &q);
	assert_int_equal(c->series[0]->n, 5);
	chart_free(c);
	struct params p, best = calibration_status(s->job.calibration).params;
	q = plots_default_request(PLOT_PSD);
	q.asked.entry = session_current_site_entry(s);
	assert_true(find_param_values_for_plot(s, &q, &p, &desk->error));
	assert_memory_equal(&p, &best, sizeof p);
	while (session_is_calibrating(s))
		session_step_job(s);
	assert_true(session_end_finished_commands(s, true, &desk->error));
	assert_true(find_param_values_for_plot(s, &q, &p, &desk->error));
	assert_memory_equal(
	    &p, &session_current_site_entry(s)->params, sizeof p);
}

static void
a_generation_shows_its_own_best(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	const struct history *h =
	    session_current_site_entry(desk->session)->history;
	struct plot_request q = plots_default_request(PLOT_PSD);
	struct params p = {0};
	q.asked.entry = session_current_site_entry(desk->session);
	q.generation = 7;
	assert_true(
	    find_param_values_for_plot(desk->session, &q, &p, &desk->error));
	assert_memory_equal(&p, &h->generation[6].params, sizeof p);
	q.kind = PLOT_CONVERGENCE;
	struct chart *c = chart_of(desk, &q);
	assert_int_equal(c->series[0]->n, h->n);
	assert_true(c->n_rule == 1 && c->rule[0].x == 7);
	chart_free(c);
	q.generation = h->n + 1;
	static const enum plot_kind KNOWING[] = {
	    PLOT_PSD, PLOT_CONVERGENCE, PLOT_SPREAD, PLOT_SEARCH};
	for (size_t i = 0; i < ARRAY_LEN(KNOWING); i++) {
		q.kind = KNOWING[i];
		assert_null(plots_make_chart(desk->session, &q, &desk->error));
	}
}

static void
what_is_extrapolated_is_dashed(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, PARAMS_SET);
	struct plot_request q = plots_default_request(PLOT_PSD);
	for (int k = 0; k < 2; k++) {
		q.asked.speed = k == 0 ? 74 : 84;
		struct chart *c = chart_of(desk, &q);
		size_t lines = 0;
		for (size_t i = 0; i < c->n; i++) {
			if (c->series[i]->series != SERIES_PREDICTED)
				continue;
			lines++;
			assert_int_equal(c->series[i]->line,
			    k == 0 ? CHART_SOLID : CHART_LONG);
		}
		assert_int_equal(lines, 1);
		chart_free(c);
	}
}

/* Only the runs that are fitted; the axis ends not far beyond the candidates,
 * and that of the convergence is one for all generations. */
static void
a_search_is_shown_on_a_scale_that_it_fills(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	const struct entry *entry = session_current_site_entry(desk->session);
	const struct history *h = entry->history;
	struct plot_request q = plots_default_request(PLOT_SEARCH),
			    r = plots_default_request(PLOT_CONVERGENCE);
	size_t trained = 0;
	for (size_t i = 0; i < entry->site->n_run; i++)
		trained += entry->train[i];
	struct chart *end = chart_of(desk, &q), *all = chart_of(desk, &r);
	assert_int_equal(end->n, 1 + 2 * trained);
	for (q.generation = 1; q.generation <= h->n; q.generation += 7) {
		r.generation = q.generation;
		struct chart *c = chart_of(desk, &q), *d = chart_of(desk, &r);
		double most = 0;
		for (size_t i = 1; i < c->n; i++)
			for (size_t j = 0; j < c->series[i]->n; j++)
				most =
				    fmax(most, c->series[i]->low != NULL
						   ? fmax(-c->series[i]->low[j],
							 c->series[i]->high[j])
						   : fabs(c->series[i]->y[j]));
		assert_true(c->y.high >= most || c->y.high == 100);
		assert_true(c->y.high <= 3.4 * most || c->y.high == 1);
		assert_true(c->y.low == -c->y.high);
		assert_true(end->y.high < 100);
		assert_true(d->y.low == all->y.low && d->y.high == all->y.high);
		for (size_t i = 1; i < c->n; i += 2)
			for (size_t j = 0; j < c->series[i]->n; j++)
				assert_true(c->series[i]->low[j] <=
						c->series[i]->y[j] &&
					    c->series[i]->y[j] <=
						c->series[i]->high[j]);
		chart_free(c);
		chart_free(d);
	}
	/* What is told in points is what the fit says of itself. */
	const struct chart_series *last = all->series[all->n - 1];
	assert_true(fabs(last->y[last->n - 1] - 100 * entry->fit.rmse) < 1e-6);
	chart_free(end);
	chart_free(all);
}

static void
a_band_holds_the_prediction_of_a_fit(void **state)
{
	struct desk *desk = *state;
	struct plot_request q = plots_default_request(PLOT_PSD);
	q.band = true;
	desk_expect(desk, PARAMS_SET);
	struct chart *c = chart_of(desk, &q);
	assert_null(c->series[c->n - 1]->low);
	chart_free(c);
	desk_expect(desk, SEARCH);
	c = chart_of(desk, &q);
	const struct chart_series *s = c->series[c->n - 1];
	assert_non_null(s->low);
	for (size_t i = 0; i < s->n; i++)
		assert_true(s->low[i] <= s->y[i] && s->y[i] <= s->high[i]);
	chart_free(c);
}

/* Of another site beside, made now or kept from before. */
static void
a_second_site_has_a_curve_of_its_own(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	struct plot_request q = plots_default_request(PLOT_PSD);
	q.asked.speed = 74;
	q.other_speed = 70;
	q.beside = "tierp";
	desk_expect(desk, PARAMS_SET);
	const struct entry *entry = session_current_site_entry(s);
	struct prediction kept =
	    forecast_whole_product(s, entry, 70, SITE_MEAN_FEED);
	desk_expect(desk, "load data/sites/bro.csv");
	for (int way = 0; way < 2; way++) {
		struct chart *c = chart_of(desk, &q);
		size_t last = c->n - 1; /* bro has no parameters yet */
		assert_string_equal(
		    c->series[last]->name, "predicted tierp 70 m/s");
		assert_int_equal(c->series[last]->n, kept.product.n);
		for (size_t i = 0; i < kept.product.n; i++)
			assert_true(fabs(c->series[last]->y[i] -
					 100 * kept.product.passing[i]) < 1e-9);
		assert_int_equal(c->n_rule, 1);
		assert_memory_equal(c->rule[0].name, "tierp: break size ", 18);
		chart_free(c);
		q.kept = &kept;
	}
	/* What is kept outlives its site. */
	desk_expect(desk, "drop tierp");
	chart_free(chart_of(desk, &q));
	q.kept = NULL;
	assert_null(plots_make_chart(s, &q, &desk->error));
	prediction_free(&kept);
}

/* The second one of the same site takes the feed it is told to, the first one's
 * without. */
static void
a_second_prediction_has_its_own_feed(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	static const double FEEDS[] = {0, 69};
	desk_expect(desk, PARAMS_SET);
	struct plot_request q = plots_default_request(PLOT_PSD);
	q.asked.speed = 79;
	q.other_speed = 74;
	for (size_t i = 0; i < 2; i++) {
		const struct entry *entry = session_current_site_entry(s);
		size_t feed = feed_run_at_speed_or_mean(entry->site, FEEDS[i]);
		struct prediction want =
		    forecast_whole_product(s, entry, 74, feed);
		q.other_feed = FEEDS[i];
		struct chart *c = chart_of(desk, &q);
		const struct chart_series *second = c->series[c->n - 2];
		assert_int_equal(second->series, SERIES_OTHER);
		for (size_t j = 0; j < want.product.n; j++)
			assert_true(fabs(second->y[j] -
					 100 * want.product.passing[j]) < 1e-9);
		chart_free(c);
		prediction_free(&want);
	}
	desk_expect(desk, "plot psd speed=79 other=74 other_feed=69");
	assert_false(
	    desk_say(desk, "plot psd speed=79 other=74 other_feed=70"));
	assert_non_null(strstr(desk->error.text, "no feed sampled at 70"));
}

/* Prediction less the other one, the nearest run less the prediction. */
static void
differences_have_a_strip(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, PARAMS_SET);
	struct plot_request q = plots_default_request(PLOT_PSD);
	q.asked.speed = 74.3;
	struct chart *c = chart_of(desk, &q);
	assert_non_null(c->below);
	assert_int_equal(c->below->n, 1);
	assert_string_equal(c->below->title,
	    "points; marks: measured 74 m/s less predicted 74.3 m/s");
	chart_free(c);
	q.other_speed = 70;
	c = chart_of(desk, &q);
	const struct chart *strip = c->below;
	assert_int_equal(strip->n, 2);
	assert_int_equal(strip->strip, q.strip);
	assert_true(strip->y.high == -strip->y.low);
	double most = 0;
	for (size_t i = 0; i < 2; i++) {
		const struct chart_series *d = strip->series[i];
		const struct chart_series *one = c->series[c->n - 1];
		const struct chart_series *two = c->series[c->n - 2];
		for (size_t j = 0; j < d->n; j++)
			most = fmax(most, fabs(d->y[j]));
		for (size_t j = 0; j < d->n && d->line != CHART_MARKS; j++)
			assert_true(
			    fabs(d->y[j] - (one->y[j] - two->y[j])) < 1e-9);
	}
	assert_true(most > 0 && most <= strip->y.high);
	chart_free(c);
	q.strip = 0;
	c = chart_of(desk, &q);
	assert_null(c->below);
	chart_free(c);
}

/* Runs keep their colour and mark wherever the slider stands, and are hollow
 * where held out; of more than can be told apart it is said. */
static void
all_runs_are_drawn(void **state)
{
	enum { RUNS = 14 };
	struct desk *desk = *state;
	char path[] = "/tmp/plots-XXXXXX";
	int fd = mkstemp(path);
	assert_true(fd >= 0);
	dprintf(fd, "size_mm,feed");
	for (int i = 0; i < RUNS; i++)
		dprintf(fd, ",product@%d", 60 + 2 * i);
	static const double FEED[] = {100, 60, 30, 10};
	for (int row = 0; row < 4; row++) {
		dprintf(fd, "\n%d,%g", 16 >> row, FEED[row]);
		for (int i = 0; i < RUNS; i++)
			dprintf(fd, ",%g", row == 0 ? 100 : FEED[row] + 5 + i);
	}
	dprintf(fd, "\n");
	close(fd);
	char *load = xasprintf("load %s", path);
	desk_expect(desk, load);
	free(load);
	unlink(path);
	desk_expect(desk, PARAMS_SET);
	struct plot_request q = plots_default_request(PLOT_PSD);
	q.asked.speed = 61;
	struct chart *c = chart_of(desk, &q);
	size_t marks = 0;
	for (size_t i = 0; i < c->n; i++)
		marks += c->series[i]->line == CHART_MARKS;
	assert_int_equal(marks, SITE_CHART_SPEEDS);
	bool said = false;
	for (size_t i = 0; i < c->n_note; i++)
		said = said ||
		       strcmp(c->note[i], "2 measured speeds not drawn") == 0;
	assert_true(said);
	chart_free(c);
}

static void
what_is_missing_is_said(void **state)
{
	struct desk *desk = *state;
	for (int kind = PLOT_PARITY; kind < KINDS; kind++) {
		struct plot_request q =
		    plots_default_request((enum plot_kind)kind);
		desk->error = (struct error){0};
		struct chart *c =
		    plots_make_chart(desk->session, &q, &desk->error);
		assert_int_equal(c != NULL, kind == PLOT_MAP);
		if (c == NULL)
			assert_true(desk->error.text[0] != '\0' &&
				    desk->error.hint[0] != '\0');
		chart_free(c);
	}
}

/* An axis of one sieve, a feed that is all fines, a speed that breaks nothing. */
static void
odd_sheets_are_drawn(void **state)
{
	static const char *const products[] = {"8,100,100,100\n4,100,100,100\n",
	    "8,100,100,100\n", "8,100,100,100\n4,0,0,0\n"};
	struct desk *desk = *state;
	for (size_t i = 0; i < 3; i++) {
		char path[] = "/tmp/plots-XXXXXX";
		int fd = mkstemp(path);
		assert_true(fd >= 0);
		dprintf(
		    fd, "size_mm,feed,product@69,product@79\n%s", products[i]);
		close(fd);
		char *load = xasprintf("load %s", path);
		bool loaded = desk_say(desk, load);
		free(load);
		unlink(path);
		if (!loaded)
			continue;
		desk_expect(desk, PARAMS_SET);
		desk_expect(desk, "plot psd speed=1 other=200 width=50");
		desk_expect(desk, "plot residuals");
		desk_expect(desk, "plot selection speed=1");
		desk_expect(desk, "describe psd; describe selection speed=1");
	}
}

static bool
stop_at_once(void)
{
	return true;
}

static const struct chart_series *
series_of(const struct chart *c, const char *name)
{
	for (size_t i = 0; i < c->n; i++)
		if (strcmp(c->series[i]->name, name) == 0)
			return c->series[i];
	fail_msg("no series %s", name);
	return NULL;
}

/* Measured as the sheet has it, predicted by the model alone from the run's own
 * feed: nothing is moved, and no run corrects what it is compared with. */
static void
runs_are_drawn_with_their_own_feeds(void **state)
{
	static const char *const NAMES[][2] = {
	    {"measured 69 m/s", "predicted 69 m/s"},
	    {"measured 74 m/s (held out)", "predicted 74 m/s"},
	    {"measured 79 m/s", "predicted 79 m/s"}};
	static const double FURTHER[] = {65, 85};
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	const struct entry *entry = session_current_site_entry(desk->session);
	const struct site *site = entry->site;
	struct plot_request q = plots_default_request(PLOT_RUNS);
	q.asked.n_at = ARRAY_LEN(FURTHER);
	q.asked.at = FURTHER;
	struct chart *c = chart_of(desk, &q);
	for (size_t r = 0; r < ARRAY_LEN(NAMES); r++) {
		const struct chart_series *m = series_of(c, NAMES[r][0]);
		const struct chart_series *p = series_of(c, NAMES[r][1]);
		const struct run *run = &site->run[r];
		struct prediction of = predict_with_model_alone(site,
		    &entry->params, desk->session->set.model, run->speed, r);
		assert_int_equal(m->line, CHART_SOLID);
		assert_int_equal(p->line, CHART_DASHED);
		for (size_t i = 0; i < m->n; i++)
			assert_true(fabs(m->y[i] -
					 100 * run->product.passing[i]) < 1e-9);
		for (size_t i = 0; i < p->n; i++)
			assert_true(
			    fabs(p->y[i] - 100 * of.product.passing[i]) < 1e-9);
		prediction_free(&of);
	}
	assert_int_equal(series_of(c, "feed 74 m/s")->line, CHART_LONG);
	double slow =
		   chart_series_y_at_x(c, series_of(c, "predicted 65 m/s"), 2),
	       fast =
		   chart_series_y_at_x(c, series_of(c, "predicted 85 m/s"), 2),
	       at = chart_series_y_at_x(c, series_of(c, "predicted 74 m/s"), 2);
	assert_true(slow < at && at < fast);
	chart_free(c);
}

/* Each material by its name, and all loaded sites that have parameters: a fit
 * at a bound stands out. */
static void
the_map_has_all_loaded_sites(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "load data/sites/umea.csv");
	desk_expect(desk, "params set f_mat=0.8 e0_min=18.61 alpha=0.92");
	desk_expect(desk, "use tierp");
	desk_expect(desk, "bounds f_mat 0.001..0.1");
	desk_expect(desk, SEARCH);
	struct plot_request q = plots_default_request(PLOT_MAP);
	struct chart *c = chart_of(desk, &q);
	const struct chart_series *gneiss = series_of(c, "Gneiss"),
				  *free = series_of(c, "loaded sites"),
				  *bound = series_of(
				      c, "loaded, a parameter at its bound");
	assert_string_equal(gneiss->whose[0].site, "table3/umea");
	assert_string_equal(gneiss->whose[0].label, "Ume\u00e5");
	assert_true(gneiss->named);
	assert_int_equal(free->n, 1);
	assert_string_equal(free->whose[0].site, "umea");
	assert_int_equal(bound->n, 1);
	assert_string_equal(bound->whose[0].site, "tierp");
	assert_true(bound->mark != free->mark);
	assert_non_null(strstr(c->about, "loaded sites: reconstructed"));
	chart_free(c);
}

/* The caption has what `validate all` says of the model. */
static void
parity_says_how_good_it_is(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "load data/sites/umea.csv");
	desk_expect(desk, "calibrate all seed=3 population=60 generations=30");
	struct plot_request q = plots_default_request(PLOT_PARITY);
	struct chart *c = chart_of(desk, &q);
	desk_expect(desk, "validate all");
	assert_int_equal(c->n_note, 3);
	static const char *const SIZES[] = {"p20", "p50", "p80"};
	for (size_t i = 0; i < ARRAY_LEN(SIZES); i++) {
		char name[32], wanted[80];
		double value[3];
		static const char *const OF[] = {"bias_pct", "rms_pct", "r2"};
		for (size_t k = 0; k < ARRAY_LEN(OF); k++) {
			snprintf(name, sizeof name, "%s.%s", SIZES[i], OF[k]);
			value[k] = session_number_in_last_answer(
			    desk->session, "validate", name);
		}
		snprintf(wanted, sizeof wanted,
		    "P%s: bias %+.2f %%, RMS %.2f %%, R2 %.4f; 2 runs",
		    SIZES[i] + 1, value[0], value[1], value[2]);
		assert_string_equal(c->note[i], wanted);
	}
	chart_free(c);
}

/* A signal is answered while the speeds of a goal are looked for. */
static void
a_description_is_stopped(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, PARAMS_SET);
	desk_expect(desk, "set goal p80=5..5.3");
	desk->session->hooks.stop = stop_at_once;
	assert_false(desk_say(desk, "describe psd"));
	assert_int_equal(desk->error.kind, ERROR_STOPPED);
	assert_null(strstr(desk->out, "being worked out"));
	desk->session->hooks.stop = NULL;
	desk_expect(desk, "describe psd");
	assert_non_null(strstr(desk->out, "p80=5..5.3: met"));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(
		a_description_is_stopped, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		every_kind_fits_every_size, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		no_two_series_look_alike, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		colours_of_runs_are_of_runs_alone, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		every_sieve_of_the_sheet_is_a_tick, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_running_search_shows_its_best_so_far, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_generation_shows_its_own_best, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		what_is_extrapolated_is_dashed, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_search_is_shown_on_a_scale_that_it_fills, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_band_holds_the_prediction_of_a_fit, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_second_site_has_a_curve_of_its_own, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_second_prediction_has_its_own_feed, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		differences_have_a_strip, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		the_map_has_all_loaded_sites, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		parity_says_how_good_it_is, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(runs_are_drawn_with_their_own_feeds,
		open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		all_runs_are_drawn, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		what_is_missing_is_said, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		odd_sheets_are_drawn, open_with_site, desk_close),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
