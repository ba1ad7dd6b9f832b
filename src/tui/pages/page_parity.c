/* Page Parity: predicted against measured sizes, at the held-out speeds of all
 * sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "tui/pane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/fit/trials.h"
#include "tui/frame.h"
#include "cli/signals.h"
#include "tui/screen.h"
#include "tui/widgets/list.h"

/* ---- The runs compared ---- */

static struct trials
validate_heldout_runs_of_site(const struct session *s, size_t index)
{
	const struct entry *entry = &s->entry[index];
	struct trials found = {.n = 0};
	if (entry->has_params && answers_require_params(s, entry, NULL))
		trials_add_held_out_runs_of_site(&found, s, index,
		    posterior_of_calibration(s, entry, CORRECTION_TRAIN));
	return found;
}

/* Moves the marks of the chosen run, which are drawn over all others, to its
 * sizes. */
static void
move_marks_to_chosen_run(struct tui *t)
{
	struct parity *y = &t->view.parity;
	const struct validation *v =
	    &y->runs.item[t->ui.list[PAGE_PARITY].at].v;
	struct chart_series **of = y->chart->series + y->chart->n - PSD_SIZES;
	for (size_t i = 0; i < PSD_SIZES && y->runs.n > 1; i++) {
		of[i]->x[0] = 1000 * v->measured[i];
		of[i]->y[0] = isnan(v->measured[i])
				  ? NAN
				  : 1000 * v->size[VALIDATE_MODEL][i];
	}
}

/* Adds marks for the chosen run, in reverse like its row beside the plot.  They
 * are not needed for a single run. */
static void
add_marks_of_chosen_run(struct chart *chart)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct chart_series look = *chart->series[chart->n - PSD_SIZES];
		look.lifted = true;
		chart_append_series(chart, look, 1, "%s", "");
	}
}

static void
make_parity_chart(struct tui *t)
{
	struct parity *y = &t->view.parity;
	struct plot_request request = plots_default_request(PLOT_PARITY);
	y->chart = plots_make_chart(t->session, &request, &y->error);
	if (y->chart == NULL || y->runs.n == 0)
		return;
	if (y->runs.n > 1)
		add_marks_of_chosen_run(y->chart);
	move_marks_to_chosen_run(t);
}

/* Compares site by site, because a first comparison samples the posterior of
 * each site's training runs.  A key interrupts it. */
static void
parity_update(struct tui *t)
{
	const struct session *s = t->session;
	struct parity *y = &t->view.parity;
	if (session_is_calibrating(s) || y->chart != NULL ||
	    y->error.text[0] != '\0')
		return;
	while (y->next < s->n_entry) {
		if (!t->aside && y->next > 0)
			frame_draw(t);
		struct trials found = validate_heldout_runs_of_site(s, y->next);
		if (!t->aside && signals_is_stop_wanted()) {
			trials_clear(&found);
			return;
		}
		trials_append_all(&y->runs, &found);
		y->next++;
	}
	if (t->ui.list[PAGE_PARITY].at >= y->runs.n)
		t->ui.list[PAGE_PARITY].at = 0;
	make_parity_chart(t);
}

/* Returns the newest answer of validate with each speed held out in turn, or
 * NULL. */
static const struct answer *
find_leave_one_out_answer(const struct session *s)
{
	for (size_t i = s->n_answer; i-- > 0;)
		if (strcmp(answer_command_name(s->answer[i]), "validate") ==
			0 &&
		    answer_find_json_number(s->answer[i], "holdout_each") ==
			1 &&
		    !isnan(answer_find_json_number(s->answer[i], "p50.r2")))
			return s->answer[i];
	return NULL;
}

/* ---- On the screen ---- */

static void
draw_bias_and_rms_row(const struct area *area, int row, const char *size,
    double n, double bias, double rms, double r2)
{
	char last[16] = "-";
	if (!isnan(r2))
		snprintf(last, sizeof last, "%.4f", r2);
	if (n > 0)
		screen_draw_text(area, row, 0, 0, "%-5s%6.0f %+8.2f %7.2f %8s",
		    size, n, 100 * bias, 100 * rms, last);
	else
		screen_draw_text(area, row, 0, 0, "%-5s%6s %8s %7s %8s", size,
		    "-", "-", "-", last);
}

static int
draw_score_rows(const struct area *area, int row, const char *who,
    const struct trials *runs, enum validate_way way)
{
	screen_draw_text(area, row++, 0, LOOK_BOLD, "%s", who);
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct validate_score score =
		    trials_score_at_size(runs, way, i);
		draw_bias_and_rms_row(area, row++, PSD_NAME[i], (double)score.n,
		    score.bias, score.rms, score.r2);
	}
	return row;
}

static int
draw_leave_one_out_scores(const struct tui *t, const struct area *area, int row)
{
	const struct answer *r = find_leave_one_out_answer(t->session);
	if (r == NULL)
		return screen_draw_wrapped(area, row, LOOK_DIM,
		    tr("leave-one-out: :validate all holdout=each"));
	screen_draw_text(
	    area, row++, 0, LOOK_BOLD, "model, each speed held out");
	for (size_t i = 0; i < PSD_SIZES; i++) {
		double x[4];
		static const char *const WHAT[] = {
		    "n", "bias_pct", "rms_pct", "r2"};
		for (size_t k = 0; k < 4; k++) {
			char path[32];
			snprintf(
			    path, sizeof path, "%s.%s", PSD_KEY[i], WHAT[k]);
			x[k] = answer_find_json_number(r, path);
		}
		draw_bias_and_rms_row(area, row++, PSD_NAME[i], x[0],
		    x[1] / 100, x[2] / 100, x[3]);
	}
	return row;
}

/* ---- The list of points ---- */

enum column {
	SITE,
	SPEED,
	MEASURED,
	MODEL,
	OFF_P50,
	OFF_P20,
	OFF_P80,
	COLUMNS
};

static const struct list_column COLUMN[COLUMNS] = {[SITE] = {N_("site"), 1, 0},
    [SPEED] = {"m/s", 5, 1, .right = true},
    [MEASURED] = {N_("P50 mm"), 8, 3, .right = true},
    [MODEL] = {N_("model"), 7, 4, .right = true},
    [OFF_P50] = {N_("P50 off"), 9, 2, .right = true},
    [OFF_P20] = {N_("P20 off"), 9, 5, .right = true},
    [OFF_P80] = {N_("P80 off"), 9, 6, .right = true}};

static char *
parity_cell_text(const struct tui *t, size_t i, int column)
{
	static const size_t SIZE[COLUMNS] = {
	    [OFF_P50] = 1, [OFF_P20] = 0, [OFF_P80] = 2};
	const struct trial *p = &t->view.parity.runs.item[i];
	const struct site *site = t->session->entry[p->entry].site;
	if (column == SPEED && answers_is_sheet_in_rpm(site))
		return answers_speed_text(site, p->v.speed, -1);
	if (column == SITE || column == SPEED)
		return xstrdup(column == SITE ? p->key : p->name);
	if (column == MEASURED)
		return xasprintf("%.2f", 1000 * p->v.measured[1]);
	if (column == MODEL)
		return xasprintf("%.2f", 1000 * p->v.size[VALIDATE_MODEL][1]);
	size_t size = SIZE[column];
	return xasprintf("%+.1f%%",
	    100 * (p->v.size[VALIDATE_MODEL][size] / p->v.measured[size] - 1));
}

static const struct list_table TABLE = {
    .column = COLUMN, .n = COLUMNS, .cell = parity_cell_text};

static size_t
parity_count_runs(const struct tui *t)
{
	return t->view.parity.chart != NULL ? t->view.parity.runs.n : 0;
}

static const struct page_list POINTS = {.n = parity_count_runs,
    .chosen = move_marks_to_chosen_run,
    .update = parity_update,
    .table = &TABLE};

/* Draws statistics and runs beside the plot. */
static void
draw_parity_side_panel(struct tui *t, const struct area *area)
{
	const struct parity *y = &t->view.parity;
	size_t sites;
	free(trials_data_sources_text(&y->runs, &sites));
	screen_draw_text(area, 0, 0, LOOK_BOLD,
	    tr_n("held-out runs: %zu of %zu site",
		"held-out runs: %zu of %zu sites", sites),
	    y->runs.n, sites);
	screen_draw_text(area, 1, 0, LOOK_DIM, "%-5s%6s %8s %7s %8s", "",
	    tr("runs"), tr("bias %"), tr("rms %"), "R2");
	int row =
	    draw_score_rows(area, 2, tr("model"), &y->runs, VALIDATE_MODEL);
	row = draw_score_rows(area, row, tr("corrected by the training runs"),
	    &y->runs, VALIDATE_CORRECTED);
	row = draw_leave_one_out_scores(t, area, row);
	row += row + 1 < area->rows - 4;
	struct area points = *area;
	area_cut_off_edge(&points, EDGE_TOP, row);
	int wanted[LIST_COLUMNS];
	table_measure_columns(t, &TABLE, y->runs.n, wanted);
	table_draw(t, &points, &TABLE, wanted);
}

/* Draws one line of statistics, where there is no room for the panel. */
static void
draw_parity_statistics_line(const struct tui *t, const struct area *area)
{
	struct validate_score score =
	    trials_score_at_size(&t->view.parity.runs, VALIDATE_MODEL, 1);
	char r2[16] = "-";
	if (!isnan(score.r2))
		snprintf(r2, sizeof r2, "%.3f", score.r2);
	screen_draw_text(area, 0, 0, 0, "P50: bias %+.1f %% rms %.1f %% R2 %s",
	    100 * score.bias, 100 * score.rms, r2);
}

static void
draw_parity_chart(const struct tui *t, const struct area *area)
{
	unsigned words = t->layout.legend.rows > 0 ? CHART_TITLE | CHART_LEGEND
						   : CHART_TITLE;
	if (area->rows < 1 || area->columns < 1)
		return;
	struct canvas *canvas = chart_draw(t->view.parity.chart, area->columns,
	    area->rows, screen_charset(), words);
	screen_draw_canvas(area, canvas);
	canvas_free(canvas);
}

/* Says why there is no plot, or that it is being made. */
static void
draw_why_no_parity(const struct tui *t, const struct area *area)
{
	const struct session *s = t->session;
	const struct parity *y = &t->view.parity;
	FREED char *words =
	    session_is_calibrating(s)
		? xstrdup(tr("compared when the calibration ends"))
	    : y->error.text[0] != '\0'
		? xstrdup(y->error.text)
		: xasprintf(tr("comparing site %zu of %zu .."), y->next + 1,
		      s->n_entry);
	int row = screen_draw_wrapped(area, area->rows / 3, LOOK_BOLD, words);
	screen_draw_wrapped(area, row, 0, y->error.hint);
}

static void
parity_page_draw(struct tui *t)
{
	enum { NARROW = 70, WIDE = 120, PANEL = 37, WIDE_PANEL = 62, GAP = 2 };
	struct area plot = pane_list_area(t), side;
	if (t->view.parity.chart == NULL || t->view.parity.runs.n == 0) {
		draw_why_no_parity(t, &plot);
		return;
	}
	if (plot.columns >= NARROW) {
		side = area_cut_off_edge(&plot, EDGE_RIGHT,
		    plot.columns >= WIDE ? WIDE_PANEL : PANEL);
		area_cut_off_edge(&plot, EDGE_RIGHT, GAP);
		draw_parity_side_panel(t, &side);
	} else if (plot.rows > 3) {
		side = area_cut_off_edge(&plot, EDGE_TOP, 1);
		draw_parity_statistics_line(t, &side);
	}
	draw_parity_chart(t, &plot);
}

static char *
parity_page_plot_arguments(const struct tui *t)
{
	(void)t;
	return xstrdup("parity");
}

const struct page_ops page_parity = {
    .hints = N_("Up/Down run  ?  q  1-5 pages  :"),
    .update = parity_update,
    .draw = parity_page_draw,
    .list = &POINTS,
    .words = parity_page_plot_arguments};
