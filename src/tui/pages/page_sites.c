/* Page Sites: each loaded site and the state of its calibration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "tui/pane.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/fit.h"
#include "cmd/fit/job.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/forecast.h"
#include "io/sitefile/units.h"
#include "tui/widgets/file_picker.h"
#include "tui/acts.h"
#include "tui/control.h"
#include "tui/widgets/list.h"
#include "tui/screen.h"
#include "tui/watch.h"

enum column {
	LIGHT,
	NAME,
	ROCK,
	TOP,
	RUNS,
	PARAMETERS,
	RMS,
	HOLDOUT,
	P50,
	MISFIT,
	GENERATIONS,
	MACHINE,
	COLUMNS
};

/* The column of the light has a fixed width, because it also shows the progress
 * of a calibration. */
static const struct list_column COLUMN[COLUMNS] = {
    [LIGHT] = {N_("light"), 7, 1, .fixed = true},
    [NAME] = {N_("site"), 1, 0, .indent = 2},
    [ROCK] = {N_("rock"), 8, 6},
    [TOP] = {N_("top mm"), 7, 7, .right = true},
    [RUNS] = {N_("runs m/s"), 20, 8},
    [PARAMETERS] = {N_("parameters"), 18, 5},
    [RMS] = {"RMSE", 7, 3, .right = true},
    [HOLDOUT] = {N_("hold-out"), 9, 4, .right = true},
    [P50] = {N_("P50 mm"), 8, 2, .right = true},
    [MISFIT] = {N_("misfit"), 10, 9, .right = true},
    [GENERATIONS] = {N_("generations"), 12, 10, .right = true},
    [MACHINE] = {N_("machine"), 12, 11}};

/* ---- The rows ---- */

/* Computes the P50 at the slider's speed: for the site in use with the feed of
 * page Predict, for others with their mean feed. */
static void
compute_site_row_p50(struct site_row *row, const struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *e = &s->entry[row->entry];
	double speed = tui_slider_speed(t);
	row->speed = speed;
	row->p50 = NAN;
	row->beyond = false;
	if (!answers_require_params(s, e, NULL))
		return;
	bool here = e == tui_current_site_entry(t);
	struct prediction p = forecast_whole_product(s,
	    here ? tui_site_entry_for_prediction(t) : e, speed,
	    here ? tui_run_index_of_feed(t) : SITE_MEAN_FEED);
	row->p50 = 1000 * p.p50;
	row->beyond = answers_is_speed_extrapolated(e, speed);
	prediction_free(&p);
}

/* Finds the light of a site.  That of a site that is being calibrated is not
 * known yet. */
static void
judge_site_of_row(struct site_row *row, const struct session *s)
{
	const struct entry *e = &s->entry[row->entry];
	row->judged = true;
	row->has_light = e->has_params && session_entry_being_fitted(s) != e;
	if (!row->has_light)
		return;
	row->light = light_of_answer_or_fit(s, e, NULL);
	row->verdict = e->has_fit ? verdict_on_fit(e, row->light) : NULL;
}

static bool
is_row_computed(const struct tui *t, const struct site_row *row)
{
	return row->judged && row->speed == tui_slider_speed(t);
}

/* Returns "69 o74 79", with o for held-out speeds, like the signs of the track;
 * for a sheet in rpm, "1380 1500 rpm"; if there are many, "8 runs". */
static char *
run_speeds_text(const struct entry *e)
{
	enum { MOST = 16, ROOM = 20 };
	char *text = xstrdup("");
	for (size_t r = 0; r < e->site->n_run; r++)
		if (e->site->run[r].product.n > 0)
			xappend_to_list(&text, " ", "%s%g",
			    e->train[r] ? "" : "o",
			    answers_speed_in_sheet_unit(
				e->site, e->site->run[r].speed));
	if (text[0] != '\0' && strlen(text) <= MOST) {
		const char *unit =
		    answers_is_sheet_in_rpm(e->site) ? tr("rpm") : "";
		if (strlen(text) + strlen(unit) < ROOM)
			xappend(&text, unit[0] != '\0' ? " %s" : "%s", unit);
		return text;
	}
	bool none = text[0] == '\0';
	free(text);
	return none ? xstrdup(tr("feed only"))
		    : xasprintf(tr("%zu runs"), site_count_products(e->site));
}

static const char *
params_status_text(const struct session *s, const struct site_row *row)
{
	const struct entry *e = &s->entry[row->entry];
	return row->verdict != NULL              ? row->verdict
	       : e->has_fit                      ? tr("calibrating")
	       : !e->has_params                  ? tr("not calibrated")
	       : origin_is_from_store(e->origin) ? tr("from the store")
						 : origin_of_params_text(e);
}

/* Returns the progress of a site's calibration, which may be one of several in
 * turn; NULL if the site is not calibrated or is done. */
static char *
calibration_progress_text(const struct tui *t, size_t i)
{
	const struct session *s = t->session;
	const struct job *job = &s->job;
	if (session_entry_being_fitted(s) == NULL || i < job->entry ||
	    (i > job->entry && (job->type->alone ||
				   site_count_products(s->entry[i].site) == 0)))
		return NULL;
	struct calibrate_status st = calibration_status(job->calibration);
	if (i == job->entry && !t->held && st.state < CALIBRATE_POLISHING)
		return xasprintf(tr("gen %zu"), st.generation);
	return xstrdup(i > job->entry                    ? tr("waiting")
		       : t->held                         ? tr("paused")
		       : st.state == CALIBRATE_POLISHING ? tr("polish")
							 : tr("draws"));
}

/* Returns the number in a column; NAN if it has none, or words. */
static double
site_row_column_value(
    const struct session *s, const struct site_row *row, enum column column)
{
	const struct entry *e = &s->entry[row->entry];
	switch (column) {
	case LIGHT:
		return row->has_light ? (double)row->light : NAN;
	case TOP:
		return e->site->top_size > 0 ? units_m_to_mm(e->site->top_size)
					     : NAN;
	case RUNS:
		return (double)site_count_products(e->site);
	case RMS:
		return e->has_fit ? 100 * e->fit.rmse : NAN;
	case HOLDOUT:
		return row->holdout;
	case P50:
		return row->p50;
	case MISFIT:
		return e->has_fit ? e->fit.misfit : NAN;
	case GENERATIONS:
		return e->has_fit ? (double)e->fit.generations : NAN;
	default:
		return NAN;
	}
}

static char *
number_cell_text(
    const struct tui *t, const struct site_row *row, enum column column)
{
	double x = site_row_column_value(t->session, row, column);
	if (isnan(x))
		return xstrdup("-");
	if (column == TOP || column == GENERATIONS)
		return xasprintf("%g", x);
	if (column == MISFIT)
		return xasprintf("%.3g", x);
	return xasprintf("%.2f%s", x, column == P50 && row->beyond ? "?" : "");
}

static char *
site_list_cell_text(const struct tui *t, size_t i, int column)
{
	const struct session *s = t->session;
	const struct site_row *row = &t->view.row[i];
	const struct entry *e = &s->entry[row->entry];
	char *progress;
	if (column == P50 ? !is_row_computed(t, row)
			  : !row->judged && column == PARAMETERS)
		return xstrdup("..");
	switch ((enum column)column) {
	case LIGHT:
		progress = calibration_progress_text(t, row->entry);
		if (progress == NULL && !row->judged)
			return xstrdup("..");
		return progress != NULL ? progress
		       : row->has_light ? xstrdup(tr(LIGHT_NAME[row->light]))
					: xstrdup("-");
	case NAME:
		return xasprintf(
		    "%c %s", row->entry == s->current ? '*' : ' ', e->key);
	case ROCK:
		return xstrdup(e->site->rock);
	case RUNS:
		return run_speeds_text(e);
	case PARAMETERS:
		return xstrdup(params_status_text(s, row));
	case MACHINE:
		return xstrdup(e->site->machine);
	default:
		return number_cell_text(t, row, (enum column)column);
	}
}

/* ---- The order of the rows ---- */

static const char *
sort_text_of_site_row(
    const struct session *s, const struct site_row *row, enum column column)
{
	const struct entry *e = &s->entry[row->entry];
	return column == ROCK         ? e->site->rock
	       : column == PARAMETERS ? params_status_text(s, row)
	       : column == MACHINE    ? e->site->machine
				      : e->key;
}

/* Returns true if row a is sorted after b.  Rows without a number or word are
 * last in either direction. */
static bool
is_site_row_sorted_after(
    const struct tui *t, const struct site_row *a, const struct site_row *b)
{
	if (t->ui.sort == 0)
		return t->ui.sort_down ? a->entry < b->entry
				       : a->entry > b->entry;
	enum column column = (enum column)(t->ui.sort - 1);
	double x = site_row_column_value(t->session, a, column),
	       y = site_row_column_value(t->session, b, column);
	double by = x - y;
	if (isnan(x) != isnan(y))
		return isnan(x);
	if (isnan(by)) {
		const char *v = sort_text_of_site_row(t->session, a, column);
		const char *w = sort_text_of_site_row(t->session, b, column);
		if ((v[0] == '\0') != (w[0] == '\0'))
			return v[0] == '\0';
		by = strcmp(v, w);
	}
	return t->ui.sort_down ? by < 0 : by > 0;
}

/* Sorts by insertion, because few rows are out of order. */
static void
sites_sort_rows(struct tui *t)
{
	for (size_t i = 1; i < t->view.n_row; i++) {
		struct site_row row = t->view.row[i];
		size_t k = i;
		for (; k > 0 &&
		       is_site_row_sorted_after(t, &t->view.row[k - 1], &row);
		     k--)
			t->view.row[k] = t->view.row[k - 1];
		t->view.row[k] = row;
	}
}

/* Sorts by a column: ascending at first, then in the other direction.  column
 * -1: the order in which sites were loaded. */
static void
sort_sites_by_column(struct tui *t, int column)
{
	int by = column + 1;
	t->ui.sort_down = by == t->ui.sort && !t->ui.sort_down;
	t->ui.sort = by;
	sites_sort_rows(t);
}

static bool
colour_of_light_cell(const struct tui *t, size_t i, int column,
    const char *text, enum series *series)
{
	static const enum series LIGHT_LOOK[] = {[LIGHT_GREEN] = SERIES_GREEN,
	    [LIGHT_AMBER] = SERIES_AMBER,
	    [LIGHT_RED] = SERIES_RED};
	const struct site_row *row = &t->view.row[i];
	*series = LIGHT_LOOK[row->light];
	return column == LIGHT && row->has_light &&
	       strcmp(text, LIGHT_NAME[row->light]) == 0;
}

static const struct list_table TABLE = {COLUMN, COLUMNS, site_list_cell_text,
    colour_of_light_cell, sort_sites_by_column};

/* Makes the rows if the session has changed, without what takes time. */
static void
make_rows_of_page_sites(struct tui *t)
{
	const struct session *s = t->session;
	if (t->view.n_row == s->n_entry)
		return;
	free(t->view.row);
	t->view.n_row = s->n_entry;
	t->view.row = xcalloc(t->view.n_row + 1, sizeof *t->view.row);
	for (size_t i = 0; i < t->view.n_row; i++) {
		const struct entry *e = &s->entry[i];
		t->view.row[i] = (struct site_row){.entry = i,
		    .p50 = NAN,
		    .holdout =
			e->has_fit ? 100 * fit_largest_holdout_rmse(e) : NAN};
	}
	table_measure_columns(t, &TABLE, t->view.n_row, t->view.site_width);
	sites_sort_rows(t);
}

/* Computes rows until the time for a frame is over; the rest is left to the
 * next rounds, between which keys are read. */
static void
update_rows_of_page_sites(struct tui *t)
{
	static const double FRAME = 0.05; /* s */
	const double began = session_clock_seconds();
	size_t i = 0, n = 0;
	make_rows_of_page_sites(t);
	for (; i < t->view.n_row; i++) {
		struct site_row *row = &t->view.row[i];
		if (is_row_computed(t, row))
			continue;
		if (n++ > 0 && !t->aside &&
		    session_clock_seconds() - began >= FRAME)
			break;
		if (!row->judged)
			judge_site_of_row(row, t->session);
		compute_site_row_p50(row, t);
	}
	t->view.rows_left = i < t->view.n_row;
	if (n > 0) {
		table_measure_columns(
		    t, &TABLE, t->view.n_row, t->view.site_width);
		sites_sort_rows(t);
	}
}

/* ---- On the screen ---- */

/* Describes the site under the cursor: what the mark of its P50 means, its
 * parameters, what it is, and the source of its data.  If room is short, the
 * last is left out first. */
enum { ABOUT = 4 };
static void
write_selected_site_texts(const struct tui *t, char *text[static ABOUT])
{
	const struct entry *e = &t->session->entry[t->ui.list[PAGE_SITES].at];
	const struct breakage *of = breakage_model_of_params(&e->params);
	bool beyond = e->has_params &&
		      answers_is_speed_extrapolated(e, tui_slider_speed(t));
	FREED char *speed = answers_speed_text(
	    tui_current_site_entry(t)->site, tui_slider_speed(t), 1);
	text[0] = beyond ? xasprintf(tr("? extrapolated: %s is outside the "
					"speeds measured"),
			       speed)
			 : xstrdup("");
	text[1] = xstrdup("");
	for (size_t j = 0; e->has_params && j < of->n; j++)
		xappend(&text[1], "%s%s=%.4g", j > 0 ? "  " : "",
		    of->parameter[j].name, e->params.at[j]);
	FREED char *label = session_site_label(e->site);
	text[2] = xasprintf("%s%s%s", label,
	    e->site->machine[0] != '\0' ? "; " : "", e->site->machine);
	FREED char *data = site_translate_provenance(e->site->provenance);
	text[3] = xasprintf(tr("data: %s"),
	    data[0] != '\0' ? data : tr("provenance not stated"));
}

/* Draws the curves of the site under the cursor, between the list and the text
 * about it. */
static void
draw_curves_of_site(struct tui *t, struct area area)
{
	enum { LEAST = 7, NAMES = 16, MOST = 30 };
	const size_t at = t->ui.list[PAGE_SITES].at;
	struct plot_request request = plots_default_request(PLOT_PSD);
	if (area.rows < LEAST)
		return;
	area.rows = area.rows > MOST ? MOST : area.rows;
	request.asked.entry = at == t->session->current
				  ? tui_site_entry_for_prediction(t)
				  : &t->session->entry[at];
	request.words = area.rows < NAMES ? 0 : CHART_TITLE | CHART_LEGEND;
	request.strip = 0;
	request.asked.speed = tui_slider_speed(t);
	pane_draw_plot(t, &request, &area);
}

/* Draws this description at the foot of the page, below row `first`.  Returns
 * how many rows are left between. */
static int
draw_selected_site_at_foot(
    const struct tui *t, const struct area *area, int first)
{
	enum { LABEL = 2 };
	static const size_t ORDER[ABOUT] = {LABEL, 3, 1, 0};
	char *text[ABOUT];
	int rows[ABOUT], left = area->rows - first;
	write_selected_site_texts(t, text);
	for (size_t i = 0; i < ABOUT; i++) {
		rows[i] = text_count_rows(text[i], area->columns);
		rows[i] = rows[i] < left ? rows[i] : left;
		left -= rows[i];
	}
	int row = first + left;
	for (size_t i = 0; i < ABOUT; i++) {
		size_t k = ORDER[i];
		row = screen_draw_wrapped_rows(area, row, rows[k],
		    k == LABEL ? LOOK_BOLD : LOOK_PLAIN, text[k], " ..");
		free(text[k]);
	}
	return left;
}

static void
sites_page_draw(struct tui *t)
{
	enum { HEAD = 1, GAPS = 2 };
	const struct area area = pane_list_area(t);
	make_rows_of_page_sites(t);
	if (t->session->n_entry == 0) {
		screen_draw_text(
		    &area, 0, 2, 0, "none is loaded: o opens a sheet");
		return;
	}
	table_draw(t, &area, &TABLE, t->view.site_width);
	int first = (int)list_count_matching_rows(t) + HEAD;
	if (first == HEAD)
		screen_draw_text(
		    &area, HEAD, 2, 0, "no site has this word: Esc");
	if (first == HEAD || first + 1 >= area.rows)
		return;
	struct area preview = area;
	preview.row += first + 1;
	preview.rows = draw_selected_site_at_foot(t, &area, first) - GAPS;
	draw_curves_of_site(t, preview);
}

static size_t
sites_count_rows(const struct tui *t)
{
	return t->view.n_row;
}

static size_t
sites_entry_of_row(const struct tui *t, size_t i)
{
	return t->view.row[i].entry;
}

static char *
sites_name_of_row(const struct tui *t, size_t i)
{
	return xstrdup(t->session->entry[t->view.row[i].entry].site->name);
}

static void
open_chosen_site(struct tui *t)
{
	const struct session *s = t->session;
	if (session_entry_being_fitted(s) != NULL && !s->job.type->alone) {
		tui_set_message(t, false,
		    "calibrating all sites: s stops, then Enter opens one");
		return;
	}
	/* If it is the site in use, it is only shown, without stopping a
	 * job. */
	if (session_is_calibrating(s) &&
	    t->ui.list[PAGE_SITES].at == s->current) {
		pages_go_to(t, PAGE_PREDICT);
		return;
	}
	FREED char *line =
	    xasprintf("use %s", t->ui.list[PAGE_SITES].at < s->n_entry
				    ? s->entry[t->ui.list[PAGE_SITES].at].key
				    : "");
	const char *stopped = tui_stop_fit(t);
	if (control_run_command_captured(t, line))
		pages_go_to(t, PAGE_PREDICT);
	tui_append_to_message(t, stopped);
}

/* Sorts by the next column that is drawn. */
static void
sort_sites_by_next_column(struct tui *t)
{
	int width[LIST_COLUMNS], by = t->ui.sort;
	table_fit_columns(
	    &TABLE, pane_list_area(t).columns, t->view.site_width, width);
	do
		by = (by + 1) % (COLUMNS + 1);
	while (by > 0 && width[by - 1] == 0);
	t->ui.sort_down = false;
	t->ui.sort = by;
	sites_sort_rows(t);
}

void
act_sort_sites(struct tui *t, const struct key *key)
{
	if (t->session->n_entry == 0)
		file_picker_open(t, PICK_FILES);
	else if (key->amount > 0)
		sort_sites_by_next_column(t);
	else
		sort_sites_by_column(t, t->ui.sort - 1);
}

static const struct page_list LIST = {.n = sites_count_rows,
    .id = sites_entry_of_row,
    .text = sites_name_of_row,
    .open = open_chosen_site,
    .update = update_rows_of_page_sites,
    .table = &TABLE};

static const char *
sites_page_hints(const struct tui *t)
{
	return t->session->n_entry == 0
		   ? N_("o open a sheet  ?  q  :")
		   : N_("Up/Down site  Enter  o  /  ?  q  x  :");
}

const struct page_ops page_sites = {.hints_now = sites_page_hints,
    .update = update_rows_of_page_sites,
    .draw = sites_page_draw,
    .list = &LIST};
