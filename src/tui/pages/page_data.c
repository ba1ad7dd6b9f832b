/* Page Data: the sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "tui/pane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/sheets/mend.h"
#include "io/sitefile/units.h"
#include "tui/acts.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/screen.h"
#include "tui/watch.h"

/* Columns for the sieves, which do not scroll, and for the prediction. */
enum { SIEVES = 9, PREDICTED = 9 };

/* ---- The sheet ---- */

/* Lists the columns.  A feed shared by all runs is one column; otherwise each
 * feed stands before its product. */
static void
list_sheet_columns(struct sheet *h, const struct site *site)
{
	h->column = xcalloc(2 * site->n_run, sizeof *h->column);
	for (size_t r = 0; r < site->n_run; r++) {
		if (site_run_has_feed_sample(site, r))
			h->column[h->n_column++] =
			    (struct sheet_column){true, r};
		if (site->run[r].product.n > 0)
			h->column[h->n_column++] =
			    (struct sheet_column){false, r};
	}
}

static const struct psd *
curve_of_column(const struct sheet *h, size_t column)
{
	const struct run *run = &h->site->run[h->column[column].run];
	return h->column[column].feed ? &run->feed : &run->product;
}

/* Returns the passing in a cell as the sheet states it, %; NAN if there is
 * none. */
static double
cell_passing_percent(const struct sheet *h, size_t column, size_t row)
{
	const struct psd *psd = curve_of_column(h, column);
	for (size_t i = 0; i < psd->n; i++)
		if (psd->size[i] == h->sieve[row])
			return units_fraction_to_pct(psd->passing[i]);
	return NAN;
}

/* Writes the heading of a column: "74 (2)*" for a training run, "feed@74" if
 * there are several feeds. */
static void
column_heading_text(const struct tui *t, size_t column, char text[static 48])
{
	const struct sheet *h = &t->view.sheet;
	const struct run *run = &h->site->run[h->column[column].run];
	bool feed = h->column[column].feed;
	if (feed && !h->site->individual_feeds)
		snprintf(text, 48, tr("feed %%"));
	else
		snprintf(text, 48, "%s%g%s%s", feed ? tr("feed@") : "",
		    answers_speed_in_sheet_unit(h->site, run->speed),
		    run->repeat,
		    !feed && tui_current_site_entry(t)
				 ->train[h->column[column].run]
			? "*"
			: "");
}

/* Returns how many decimals the cells need. */
static int
count_decimals_of_cells(const struct sheet *h)
{
	enum { MOST = 3 };
	int digits = 1;
	for (size_t c = 0; c < h->n_column; c++) {
		const struct psd *psd = curve_of_column(h, c);
		for (size_t i = 0; i < psd->n && digits < MOST; i++) {
			double x = units_fraction_to_pct(psd->passing[i]) *
				   pow(10, digits);
			digits += fabs(x - round(x)) > 1e-6;
		}
	}
	return digits;
}

static void
make_sheet_of_site(struct tui *t, const struct site *site)
{
	enum { LEAST = 9, GAP = 3 };
	struct sheet *h = &t->view.sheet;
	tui_free_sheet(h);
	h->site = site;
	h->sieve = site_all_sieves(site, &h->n);
	list_sheet_columns(h, site);
	h->digits = count_decimals_of_cells(h);
	h->width = LEAST;
	for (size_t c = 0; c < h->n_column; c++) {
		char text[48];
		column_heading_text(t, c, text);
		int width = (int)strlen(text) + GAP;
		h->width = width > h->width ? width : h->width;
	}
	t->ui.cell.row = t->ui.cell.row < h->n ? t->ui.cell.row : 0;
	t->ui.cell.at = t->ui.cell.at < h->n_column ? t->ui.cell.at : 0;
}

/* Returns true if the page has cells; if they are of another sheet than the one
 * in use, makes them anew. */
static bool
data_prepare_cells(struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	bool has = entry != NULL && entry->site->n_run > 0;
	if (has && t->view.sheet.site != entry->site)
		make_sheet_of_site(t, entry->site);
	return has;
}

/* Looks for doubtful cells, once for each sheet and calibration.  This may take
 * a while, so the page is drawn first. */
static void
update_doubtful_cells(struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	struct sheet *h = &t->view.sheet;
	if (!data_prepare_cells(t))
		return;
	bool calibrated = mend_can_use_calibration(s, entry);
	double misfit = calibrated ? entry->fit.misfit : 0;
	bool same = h->calibrated == calibrated && h->misfit == misfit;
	if (session_is_calibrating(s) || (h->looked && same))
		return;
	h->looked = false;
	if (!t->aside)
		frame_draw(t);
	outliers_free(&h->doctor);
	h->doctor = mend_find_faults(s, entry);
	h->looked = true;
	h->calibrated = calibrated;
	h->misfit = misfit;
}

/* ---- Doubtful cells ---- */

static bool
is_correction_of_one_cell(const struct mend *m)
{
	return m->kind == MEND_READ || m->kind == MEND_OUT;
}

static bool
is_finding_about_column(const struct mend *m, const struct sheet_column *column)
{
	return (m->run == column->run && m->feed == column->feed) ||
	       (m->kind == MEND_SWAP_RUNS && m->other == column->run &&
		   !column->feed);
}

/* Returns the finding about a cell or its whole column, or NULL if there is
 * none. */
static const struct finding *
finding_of_cell(const struct sheet *h, size_t column, size_t row)
{
	for (size_t i = 0; h->looked && i < h->doctor.n; i++) {
		const struct mend *m = &h->doctor.finding[i].mend;
		if (is_finding_about_column(m, &h->column[column]) &&
		    (!is_correction_of_one_cell(m) || m->size == h->sieve[row]))
			return &h->doctor.finding[i];
	}
	return NULL;
}

/* Moves the cursor to the next finding, column by column. */
static void
move_to_next_doubtful_cell(struct tui *t)
{
	struct sheet *h = &t->view.sheet;
	size_t cells = h->n * h->n_column;
	for (size_t i = 1; i <= cells; i++) {
		size_t k = (t->ui.cell.at * h->n + t->ui.cell.row + i) % cells;
		const struct finding *f =
		    finding_of_cell(h, k / h->n, k % h->n);
		/* A finding about a column is visited at its first cell. */
		if (f == NULL ||
		    (!is_correction_of_one_cell(&f->mend) && k % h->n > 0))
			continue;
		t->ui.cell.at = k / h->n;
		t->ui.cell.row = k % h->n;
		return;
	}
	tui_set_message(t, false,
	    h->looked ? N_("no cell is doubtful")
		      : N_("the cells are not checked yet"));
}

static void
correct_cell_at_cursor(struct tui *t)
{
	const struct sheet *h = &t->view.sheet;
	const struct finding *f =
	    h->n > 0 ? finding_of_cell(h, t->ui.cell.at, t->ui.cell.row) : NULL;
	if (f == NULL) {
		tui_set_message(t, false,
		    "this cell is not doubtful: ! goes to one that is; for "
		    "others see help mend");
		return;
	}
	FREED char *line = mend_to_command_text(h->site, &f->mend);
	FREED char *words = mend_description(h->site, &f->mend);
	tui_stop_fit(t);
	if (control_run_command_captured(t, line))
		tui_set_message(t, false,
		    "mended: %s; u undoes it, f calibrates, :write FILE "
		    "saves the sheet",
		    words);
}

/* ---- On the screen ---- */

/* The number of rows and columns of cells that fit. */
struct room {
	size_t rows, columns;
};

/* Returns true if there is a prediction, and room for it beside at least one
 * column of the sheet. */
static bool
has_screen_room_for_prediction(const struct tui *t, const struct area *area)
{
	return t->view.shown.product.n > 0 &&
	       area->columns >= SIEVES + t->view.sheet.width + PREDICTED;
}

/* Rows below the cells, for the text about the cell under the cursor. */
enum { SAID = 3 };

static struct room
count_cells_that_fit(const struct tui *t, const struct area *area)
{
	const struct sheet *h = &t->view.sheet;
	int rows = area->rows - 1 - (area->rows > 2 * SAID ? SAID : 0);
	int columns = area->columns - SIEVES -
		      (has_screen_room_for_prediction(t, area) ? PREDICTED : 0);
	columns = columns / h->width;
	return (struct room){
	    rows < 1 ? 1 : (size_t)rows, columns < 1 ? 1 : (size_t)columns};
}

/* Returns the first of n items to show, so that `at` is among the `room` that
 * fit. */
static size_t
first_index_to_show(size_t first, size_t at, size_t n, size_t room)
{
	if (first + room <= at)
		first = at + 1 - room;
	first = first > at ? at : first;
	return n <= room ? 0 : first > n - room ? n - room : first;
}

static void
on_mouse_in_sheet_cells(struct tui *t, const struct mouse_event *touched)
{
	struct sheet *h = &t->view.sheet;
	t->ui.cell.on = true;
	if (touched->kind != HIT_PRESS) {
		t->ui.cell.row =
		    pane_move_index_clamped(t->ui.cell.row, touched->by, h->n);
		return;
	}
	t->ui.cell.at = pane_move_index_clamped(
	    t->ui.cell.left, touched->column / h->width, h->n_column);
	t->ui.cell.row =
	    pane_move_index_clamped(t->ui.cell.top, touched->row, h->n);
}

static void
data_page_draw_cell(
    struct tui *t, const struct area *line, int from, size_t column, size_t i)
{
	const struct sheet *h = &t->view.sheet;
	bool here =
	    t->ui.cell.on && t->ui.cell.at == column && t->ui.cell.row == i;
	bool doubtful = finding_of_cell(h, column, i) != NULL;
	double x = cell_passing_percent(h, column, i);
	char text[48] = "-";
	if (!isnan(x))
		snprintf(text, sizeof text, "%.*f", h->digits, x);
	FREED char *cell = xasprintf("%*s", h->width - 2, text);
	if (doubtful)
		screen_draw_text_in_series_colour(line, 0, from + h->width - 1,
		    SERIES_PREDICTED, LOOK_BOLD, "!");
	screen_draw_text_in_series_colour(line, 0, from + 1,
	    doubtful ? SERIES_PREDICTED : SERIES_TEXT,
	    (here ? LOOK_REVERSE : 0) | (doubtful ? LOOK_BOLD : 0), cell);
	if (here)
		t->cursor = (struct cursor){
		    line->row, line->column + from + h->width - 2};
}

/* Draws the cells of sieve i and the prediction or, if i is SIZE_MAX, the
 * headings. */
static void
data_page_draw_row(
    struct tui *t, const struct area *line, size_t i, size_t columns)
{
	const struct sheet *h = &t->view.sheet;
	const struct psd *psd = &t->view.shown.product;
	bool heads = i == SIZE_MAX;
	int from = SIEVES;
	char text[48];
	if (heads)
		screen_draw_text(
		    line, 0, 0, LOOK_BOLD, "%*s", SIEVES - 1, tr("sieve mm"));
	else
		screen_draw_text(line, 0, 0, 0, "%*g", SIEVES - 1,
		    units_m_to_mm(h->sieve[i]));
	for (size_t c = t->ui.cell.left;
	     c < h->n_column && c < t->ui.cell.left + columns;
	     c++, from += h->width) {
		column_heading_text(t, c, text);
		bool trained = text[strlen(text) - 1] == '*';
		if (heads)
			screen_draw_text(line, 0, from, LOOK_BOLD, "%*s",
			    h->width - (trained ? 0 : 1), text);
		else
			data_page_draw_cell(t, line, from, c, i);
	}
	if (!has_screen_room_for_prediction(t, line))
		return;
	snprintf(text, sizeof text, "%s", heads ? tr("PRED") : "-");
	if (!heads && psd_covers_size(psd, h->sieve[i]))
		snprintf(text, sizeof text, "%.*f", h->digits,
		    100 * psd_passing(psd, h->sieve[i]));
	screen_draw_text(line, 0, from, LOOK_BOLD, "%*s", PREDICTED - 1, text);
}

/* Draws the table, with marks where it continues.  Returns the column after the
 * table. */
static int
data_page_draw_cells(struct tui *t, const struct area *area, struct room room)
{
	const struct sheet *h = &t->view.sheet;
	const size_t top = t->ui.cell.top, left = t->ui.cell.left;
	size_t rows = h->n - top < room.rows ? h->n - top : room.rows,
	       columns = h->n_column - left < room.columns ? h->n_column - left
							   : room.columns;
	int end = SIEVES + (int)columns * h->width;
	hits_add_mouse_handler(&t->hits, HIT_PRESS | HIT_WHEEL,
	    (struct area){
		area->row + 1, area->column + SIEVES, (int)rows, end - SIEVES},
	    on_mouse_in_sheet_cells, 0);
	for (size_t r = 0; r <= rows && (int)r < area->rows; r++) {
		const struct area line = area_of_row(area, (int)r);
		data_page_draw_row(
		    t, &line, r == 0 ? SIZE_MAX : top + r - 1, columns);
	}
	if (left + columns < h->n_column)
		screen_draw_text(area, 0, end - 1, LOOK_BOLD, ">");
	if (top > 0)
		screen_draw_text(area, 1, 0, LOOK_BOLD, "^");
	if (top + rows < h->n)
		screen_draw_text(area, (int)rows, 0, LOOK_BOLD, "v");
	if (left > 0)
		screen_draw_text(area, 0, SIEVES, LOOK_BOLD, "<");
	return end + (has_screen_room_for_prediction(t, area) ? PREDICTED : 0);
}

/* Returns the state of the sheet as a whole, in words. */
static char *
sheet_check_result_text(const struct tui *t)
{
	const struct sheet *h = &t->view.sheet;
	if (session_is_calibrating(t->session))
		return xstrdup(
		    tr("the cells are checked when the calibration ends"));
	if (!h->looked)
		return xstrdup(tr("checking .."));
	if (h->doctor.n == 0)
		return xasprintf(
		    tr("no doubtful cell (%s); :check has the rest"),
		    h->calibrated
			? tr("judged by all passings and the fit")
			: tr("judged by the curves alone: not calibrated"));
	return xasprintf(
	    tr("%zu doubtful, marked !: the key ! goes to the next, "
	       "Enter mends it, u undoes that"),
	    h->doctor.n);
}

/* Returns a text about the cell under the cursor. */
static char *
sheet_cell_description_text(const struct tui *t)
{
	const struct sheet *h = &t->view.sheet;
	const struct sheet_column *c = &h->column[t->ui.cell.at];
	const struct finding *f =
	    finding_of_cell(h, t->ui.cell.at, t->ui.cell.row);
	double x = cell_passing_percent(h, t->ui.cell.at, t->ui.cell.row);
	char *name = mend_name_of_column(h->site, c->feed, c->run), *words;
	if (f != NULL) {
		FREED char *why = mend_finding_text(h->site, f),
			   *call = mend_to_command_text(h->site, &f->mend);
		words = xasprintf(tr("! %s; Enter: %s"), why, call);
	} else if (isnan(x))
		words = xasprintf(tr("%s: not sieved at %g mm"), name,
		    units_m_to_mm(h->sieve[t->ui.cell.row]));
	else
		words = xasprintf(tr("%s: %.7g %% passes %g mm"), name, x,
		    units_m_to_mm(h->sieve[t->ui.cell.row]));
	free(name);
	return words;
}

/* Draws a text about the cell under the cursor or, without a cursor, about the
 * sheet.  Returns the row after it. */
static int
draw_sheet_cell_description(
    const struct tui *t, const struct area *area, int row)
{
	bool here = t->ui.cell.on;
	FREED char *words =
	    here ? sheet_cell_description_text(t) : sheet_check_result_text(t);
	const struct sheet *h = &t->view.sheet;
	bool doubtful =
	    here && finding_of_cell(h, t->ui.cell.at, t->ui.cell.row) != NULL;
	return screen_draw_wrapped(
	    area, row, doubtful ? LOOK_BOLD : LOOK_PLAIN, words);
}

/* Draws how the sheet was read and the source of the data, as far as there is
 * room.  Returns the row after that. */
static int
draw_data_source(const struct tui *t, const struct area *area, int row)
{
	const struct site *site = t->view.sheet.site;
	FREED char *data = site_translate_provenance(site->provenance);
	const struct {
		const char *what, *text;
	} MORE[] = {{N_("machine"), site->machine},
	    {N_("read as"), site->read_as}, {N_("assumed"), site->assumed},
	    {N_("remark"), site->remark}, {N_("data"), data}};
	FREED char *columns =
	    xstrdup(answers_is_sheet_in_rpm(site)
			? tr("columns: feed and product at each speed, rpm, % "
			     "passing; * training")
			: tr("columns: feed and product at each speed, m/s, % "
			     "passing; * training"));
	if (has_screen_room_for_prediction(t, &t->layout.body))
		xappend(&columns, "%s", tr("; PRED: at the slider"));
	row = screen_draw_wrapped(area, row, LOOK_DIM, columns);
	for (size_t i = 0; i < ARRAY_LEN(MORE); i++) {
		if (MORE[i].text[0] == '\0' || row >= area->rows)
			continue;
		FREED char *line =
		    xasprintf("%s: %s", tr(MORE[i].what), MORE[i].text);
		row = screen_draw_wrapped(area, row, 0, line);
	}
	for (size_t i = 0; i < site->n_left_out && row < area->rows; i++)
		screen_draw_text(area, row++, 0, 0, "not read, %s: %s",
		    site->left_out[i].key, site->left_out[i].value);
	return row;
}

/* Draws the residuals or, before a calibration, the curves.  Returns false if
 * there is no room for them. */
static bool
draw_residuals_or_curves(struct tui *t, struct area area)
{
	enum { LEAST = 50, MOST = 120, LOW = 14, HIGH = 30 };
	const bool fitted = tui_current_site_entry(t)->has_params;
	struct plot_request request =
	    plots_default_request(fitted ? PLOT_RESIDUALS : PLOT_PSD);
	if (area.columns < LEAST || area.rows < LOW)
		return false;
	area.columns = area.columns > MOST ? MOST : area.columns;
	area.rows = !fitted && area.rows > HIGH ? HIGH : area.rows;
	request.words = fitted ? request.words : CHART_TITLE | CHART_LEGEND;
	request.strip = 0;
	pane_draw_plot(t, &request, &area);
	return true;
}

static void
data_page_draw(struct tui *t)
{
	struct area area = pane_list_area(t);
	struct sheet *h = &t->view.sheet;
	/* A running command may have changed the site. */
	if (!data_prepare_cells(t)) {
		screen_draw_text(&area, 0, 0, 0, TUI_NO_SITE);
		return;
	}
	struct room room = count_cells_that_fit(t, &area);
	struct area rest = area;
	t->ui.cell.top = first_index_to_show(
	    t->ui.cell.top, t->ui.cell.row, h->n, room.rows);
	t->ui.cell.left = first_index_to_show(
	    t->ui.cell.left, t->ui.cell.at, h->n_column, room.columns);
	enum { GAP = 2 };
	int behind = data_page_draw_cells(t, &area, room);
	size_t shown = h->n < room.rows ? h->n : room.rows;
	int row = (int)shown + 1;
	area_cut_off_edge(&rest, EDGE_LEFT, behind + GAP);
	bool beside = draw_residuals_or_curves(t, rest);
	if (beside)
		area.columns = behind;
	if (area.rows <= 2 * SAID)
		return;
	/* With a blank row, if there is room. */
	row = draw_sheet_cell_description(
	    t, &area, row + (row + SAID < area.rows));
	row = draw_data_source(t, &area, row + (row + SAID < area.rows));
	area_cut_off_edge(&area, EDGE_TOP, row + 1);
	if (!beside)
		draw_residuals_or_curves(t, area);
}

/* ---- Keys ---- */

/* Moves the cursor by one column, by COLUMNS or, for PgUp and PgDn, by a page
 * of rows. */
static void
move_cursor_by_columns_or_page(struct tui *t, int amount)
{
	enum { COLUMNS = 5 };
	struct sheet *h = &t->view.sheet;
	const struct area area = pane_list_area(t);
	int rows = (int)count_cells_that_fit(t, &area).rows;
	int columns = abs(amount) == STEP ? STEP : COLUMNS;
	if (abs(amount) == FAR)
		t->ui.cell.row = pane_move_index_clamped(
		    t->ui.cell.row, amount < 0 ? rows : -rows, h->n);
	else
		t->ui.cell.at = pane_move_index_clamped(t->ui.cell.at,
		    amount < 0 ? -columns : columns, h->n_column);
}

/* The first Enter shows the cursor; the next one mends the cell. */
void
act_correct_cell(struct tui *t, const struct key *key)
{
	(void)key;
	if (!data_prepare_cells(t))
		return;
	if (t->ui.cell.on)
		correct_cell_at_cursor(t);
	t->ui.cell.on = true;
}

void
act_next_doubtful_cell(struct tui *t, const struct key *key)
{
	(void)key;
	if (!data_prepare_cells(t))
		return;
	t->ui.cell.on = true;
	move_to_next_doubtful_cell(t);
}

static bool
data_page_move_cursor(struct tui *t, const struct key *key)
{
	struct sheet *h = &t->view.sheet;
	if (!data_prepare_cells(t))
		return false;
	/* The first key only shows the cursor. */
	bool here = t->ui.cell.on;
	t->ui.cell.on = true;
	if (!here)
		return true;
	if (key->act == act_move_to_end)
		t->ui.cell.row =
		    key->amount == TO_MOST && h->n > 0 ? h->n - 1 : 0;
	else if (key->act == act_move_in_list)
		t->ui.cell.row =
		    pane_move_index_clamped(t->ui.cell.row, key->amount, h->n);
	else
		move_cursor_by_columns_or_page(t, key->amount);
	return true;
}

static const char *
data_page_hints(const struct tui *t)
{
	const struct sheet *h = &t->view.sheet;
	const struct entry *entry = tui_current_site_entry(t);
	if (entry != NULL && !entry->has_params && h->looked &&
	    site_count_products(entry->site) > 0)
		return h->doctor.n == 0
			   ? N_("<-/-> column  Up/Down  f  ?  q  1-5 pages  :")
			   : N_("<-/-> column  Up/Down  !  Enter  f  ?  q  :");
	return h->looked && h->doctor.n == 0
		   ? N_("<-/-> column  Up/Down  ?  q  1-5 pages  :")
		   : N_("<-/-> column  Up/Down  !  Enter  ?  q  1-5 pages  :");
}

const struct page_ops page_data = {.hints_now = data_page_hints,
    .update = update_doubtful_cells,
    .draw = data_page_draw,
    .move = data_page_move_cursor};
