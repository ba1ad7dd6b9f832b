/* Page Predict: the curves, and the numbers at the slider's speed; without a
 * site, ways to open one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/pane.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/pin.h"
#include "io/sitefile/units.h"
#include "tui/acts.h"
#include "tui/screen.h"
#include "tui/widgets/file_picker.h"
#include "tui/widgets/list.h"
#include "cmd/ask/quantity_words.h"
#include "tui/widgets/envelope_check.h"
#include "tui/widgets/goal.h"
#include "tui/widgets/goal_view.h"
#include "tui/captured.h"
#include "tui/control.h"
#include "tui/widgets/panel.h"

/* ---- Without a site ---- */

/* Ways to open a site, each with the list of files that it opens. */
static const struct {
	const char *name, *what;
	enum picker_list list;
} WAYS[] = {{N_("Open a sheet"),
		N_("Sieve analyses of the feed and of the product at two "
		   "speeds or more, from Excel, LibreOffice or CSV. The list "
		   "shows how each file would be read. The key o opens it "
		   "later."),
		PICK_FILES},
    {N_("Go on with a saved session"),
	N_("Brings back what the key w saved in a file that ends in .tip: "
	   "sites with their fits, the goal and the pinned prediction."),
	PICK_SESSIONS},
    {N_("Try a site that comes with tipspeed"),
	N_("Quarries of the paper with their rock and tip speeds; their curves "
	   "are reconstructed from it."),
	PICK_SHIPPED},
    {N_("Estimate from rock type and top size"),
	N_("If only the feed was sampled: uses materials of other quarries, "
	   "with a wide band. Choose the sheet with the feed, then complete "
	   "the command."),
	PICK_FEEDS}};

static void
draw_way_to_start(struct tui *t, const struct area *line, size_t i,
    unsigned look, const void *of)
{
	(void)t, (void)of;
	screen_draw_text(line, 0, 1, look, "%s", tr(WAYS[i].name));
}

/* Draws the ways in the middle of the page, with a description of the chosen
 * one if there is room. */
static void
draw_ways_to_start(struct tui *t)
{
	enum { WIDEST = 64, GAPS = 3, WHAT = 4 };
	struct area area = pane_list_area(t);
	int n = ARRAY_LEN(WAYS);
	if (area.columns > WIDEST) {
		area.column += (area.columns - WIDEST) / 2;
		area.columns = WIDEST;
	}
	bool title = area.rows >= n + 2, what = area.rows >= n + GAPS + WHAT;
	int spare = area.rows - n - (title ? 2 : 0) - (what ? 1 + WHAT : 0);
	int row = spare > 0 ? spare / 3 : 0;
	if (title)
		screen_draw_text(
		    &area, row, 0, LOOK_BOLD, "No site is loaded yet:");
	area_cut_off_edge(&area, EDGE_TOP, row + (title ? 2 : 0));
	row = list_draw_rows(t, &area, draw_way_to_start, NULL);
	if (what)
		screen_draw_wrapped(&area, row + 1, 0,
		    tr(WAYS[t->ui.list[PAGE_PREDICT].at].what));
}

/* ---- The curves ---- */

static void
predict_page_draw_measured_curves(struct tui *t)
{
	struct plot_request request = plots_default_request(PLOT_RUNS);
	request.words = 0;
	pane_draw_curves(t, &request, t->layout.side.rows == 0);
}

static void
predict_page_draw(struct tui *t)
{
	const struct prediction *p = &t->view.shown;
	struct plot_request request = plots_default_request(PLOT_PSD);
	if (tui_current_site_entry(t) == NULL) {
		draw_ways_to_start(t);
		return;
	}
	if (goal_is_viewed(t)) {
		goal_view_draw(t);
		return;
	}
	if (t->ui.runs) {
		predict_page_draw_measured_curves(t);
		panel_draw(t);
		return;
	}
	request.words = 0;
	request.asked.speed = tui_slider_speed(t);
	request.asked.feed = tui_run_index_of_feed(t);
	request.band = t->ui.band;
	if (p->product.n > 0 && t->view.of.speed == request.asked.speed)
		request.made = p;
	request.level = t->ui.crosshair_passing;
	if (t->view.pinned.site[0] != '\0') {
		request.beside = t->view.pinned.site;
		request.kept = &t->session->pin->p;
	}
	if (t->ui.crosshair && t->ui.crosshair_sieve < p->product.n)
		request.crosshair_mm =
		    units_m_to_mm(p->product.size[t->ui.crosshair_sieve]);
	pane_draw_curves(t, &request, t->layout.side.rows == 0);
	panel_draw(t);
}

void
act_move_crosshair_passing(struct tui *t, const struct key *key)
{
	enum { LEAST = 5, MOST = 95 };
	int to = t->ui.crosshair_passing + key->amount;
	t->ui.crosshair_passing = to < LEAST ? LEAST : to > MOST ? MOST : to;
}

/* Shows all numbers or, before a calibration, starts one. */
void
act_show_numbers_or_calibrate(struct tui *t, const struct key *key)
{
	if (tui_current_site_entry(t) == NULL) {
		act_open_row(t, key);
		return;
	}
	if (!tui_current_site_entry(t)->has_params &&
	    site_count_products(tui_current_site_entry(t)->site) > 0 &&
	    !session_is_calibrating(t->session)) {
		act_calibrate(t, key);
		return;
	}
	FREED char *line = tui_command_at_slider(t);
	if (t->view.shown.product.n == 0)
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
	else if (control_run_command_captured(t, line))
		captured_show_output(t);
}

void
act_toggle_all_runs_view(struct tui *t, const struct key *key)
{
	(void)key;
	t->ui.runs = tui_current_site_entry(t) != NULL && !t->ui.runs;
	t->ui.goal_view = false;
}

/* Moves the crosshair by Up and Down.  The first of these turns it on, and the
 * panel then reads the curves at its sieve. */
static bool
move_crosshair_by_key(struct tui *t, const struct key *key)
{
	/* Both the sieves and the key go from coarse to fine. */
	size_t n = t->view.shown.product.n;
	if (goal_is_viewed(t) || key->act != act_move_in_list || n == 0)
		return false;
	if (!t->ui.crosshair) {
		act_toggle_crosshair(t, key);
		return true;
	}
	t->ui.crosshair_sieve =
	    pane_move_index_clamped(t->ui.crosshair_sieve, key->amount, n);
	return true;
}

/* Turns the crosshair off, or on, which also opens the page. */
void
act_toggle_crosshair(struct tui *t, const struct key *key)
{
	(void)key;
	t->ui.crosshair = !t->ui.crosshair && t->view.shown.product.n > 0;
	t->ui.runs = t->ui.runs && !t->ui.crosshair;
	t->ui.goal_view = t->ui.goal_view && !t->ui.crosshair;
	if (t->ui.crosshair && t->ui.crosshair_sieve == 0)
		t->ui.crosshair_sieve = t->view.shown.product.n / 3;
	if (t->ui.crosshair)
		pages_go_to(t, PAGE_PREDICT);
	if (t->view.shown.product.n == 0)
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
	else if (t->ui.crosshair)
		tui_set_message(t, false, "sieve: Up, Down; passing: < and >");
}

/* Moves the crosshair to the sieve nearest to a size, m, by ratio, as on the
 * axis. */
static void
move_crosshair_to_size(struct tui *t, double size)
{
	const struct psd *psd = &t->view.shown.product;
	size_t best = 0;
	for (size_t i = 1; i < psd->n; i++)
		if (fabs(log(psd->size[i] / size)) <
		    fabs(log(psd->size[best] / size)))
			best = i;
	t->ui.crosshair_sieve = best;
}

static void
move_crosshair_to_click(struct tui *t, enum plot_kind kind, double x, double y)
{
	(void)y;
	if (kind != PLOT_PSD)
		return;
	if (!t->ui.crosshair)
		act_toggle_crosshair(t, NULL);
	if (!t->ui.crosshair)
		return;
	pages_go_to(t, PAGE_PREDICT);
	move_crosshair_to_size(t, x / 1000);
}

static char *
predict_page_plot_arguments(const struct tui *t)
{
	const struct prediction *p = &t->view.shown;
	if (goal_is_viewed(t)) {
		FREED char *of = quantities_text_to_type(&t->ui.quantity);
		return xasprintf("response of=\"%s\"", of);
	}
	if (t->ui.runs)
		return xstrdup("runs");
	char *words = pane_curves_plot_arguments(t);
	if (t->view.pinned.site[0] != '\0')
		xappend(&words, " beside=pinned");
	if (t->ui.band)
		xappend(&words, " band=on");
	if (t->ui.crosshair && t->ui.crosshair_sieve < p->product.n)
		xappend(&words, " at=%g level=%d",
		    units_m_to_mm(p->product.size[t->ui.crosshair_sieve]),
		    t->ui.crosshair_passing);
	return words;
}

static const char *
predict_page_hints(const struct tui *t)
{
	bool undone =
	    t->command != NULL && !t->failed && strcmp(t->command, "undo") == 0;
	if (tui_current_site_entry(t) == NULL)
		return N_("Up/Down, Enter choose  ?  q  o open  :");
	if (goal_is_viewed(t))
		return N_("<-/->  n p  N  Up/Down condition  T back  t  ?  q  "
			  "e  :");
	if (t->ui.runs)
		return N_("r this speed  <-/->  ?  q  :  d");
	if (t->ui.crosshair)
		return N_("<-/->  Up/Down  < >  c no crosshair  ?  q  :");
	if (t->view.current.site[0] == '\0' &&
	    !session_is_calibrating(t->session))
		return site_count_products(tui_current_site(t)) == 0
			   ? N_(":  ?  q  o  1-5 pages")
		       : undone
			   ? N_("Enter calibrate  U  ?  q  :  o  1-5 pages")
			   : N_("Enter calibrate  ?  q  :  o  1-5 pages");
	if (undone)
		return "<-/->  U  ?  q  f  :  t  x  e  u";
	if (t->view.pinned.site[0] != '\0')
		return goals_is_set(t->session)
			   ? N_("<-/->  n p  N  T  x unpin  ?  Enter  q  e  :  "
				"t")
			   : N_("<-/->  t  ?  Enter  q  f  x unpin  e  :  c  "
				"u");
	return goals_is_set(t->session)
		   ? "<-/->  n p  N  T  x  ?  Enter  q  e  :  t"
	       : answers_is_sheet_in_rpm(tui_current_site_entry(t)->site)
		   ? "<-/->  =1450  t  ?  Enter  q  f  x  e  :  c  u"
		   : "<-/->  =72  t  ?  Enter  q  f  x  e  :  c  u";
}

/* Counts the rows of the page's list: the ways to open a site, or the
 * conditions of the goal. */
static size_t
predict_page_count_rows(const struct tui *t)
{
	return tui_current_site_entry(t) == NULL ? ARRAY_LEN(WAYS)
	       : goal_is_viewed(t)               ? t->view.goal.list.n
						 : 0;
}

static void
predict_page_open_picker(struct tui *t)
{
	size_t at = t->ui.list[PAGE_PREDICT].at;
	if (tui_current_site_entry(t) == NULL && at < ARRAY_LEN(WAYS))
		file_picker_open(t, WAYS[at].list);
}

static const struct page_list LIST = {.n = predict_page_count_rows,
    .chosen = goal_show_condition_quantity,
    .open = predict_page_open_picker};

const struct page_ops page_predict = {.hints_now = predict_page_hints,
    .side = 24,
    .middle_side = 34,
    .wide_side = 36,
    .differences = true,
    .strip = true,
    .update = envelope_check_update,
    .draw = predict_page_draw,
    .list = &LIST,
    .list_rows = goal_view_count_rows,
    .move = move_crosshair_by_key,
    .point = move_crosshair_to_click,
    .words = predict_page_plot_arguments};
