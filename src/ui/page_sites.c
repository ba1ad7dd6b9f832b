/* The page Sites: what each loaded site is and how far it is calibrated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "cmd/outlook.h"
#include "io/units.h"
#include "ui/control.h"
#include "ui/screen.h"

/* The P50 at a speed: of the site in use as on its page, of the others on the
 * feed that serves for all speeds. */
static void
row_at(struct site_row *row, const struct tui *t, const struct entry *e)
{
	const struct session *s = t->session;
	double speed = t->tenths / 10.0;
	struct error error = {0};
	*row = (struct site_row){.p50 = NAN, .holdout = row->holdout};
	if (!answers_known(s, e, &error))
		return;
	size_t feed = e == tui_entry(t)
			  ? tui_feed(t)
			  : site_run_nearest(e->site, answers_middle(e->site));
	struct prediction p = outlook_predict(s, e, speed, feed);
	row->p50 = 1000 * p.p50;
	row->beyond = answers_extrapolates(e, speed);
	prediction_free(&p);
}

/* What does not depend on the speed is worked out when the session has changed
 * only (rows_at 0). */
static void
update(struct tui *t)
{
	const struct session *s = t->session;
	if (t->rows_at == t->tenths)
		return;
	if (t->rows_at == 0) {
		free(t->row);
		t->n_row = s->n_entry;
		t->row = xcalloc(t->n_row + 1, sizeof *t->row);
		for (size_t i = 0; i < t->n_row; i++)
			t->row[i].holdout =
			    s->entry[i].has_fit
				? 100 * fit_holdout_rmse(&s->entry[i])
				: NAN;
	}
	for (size_t i = 0; i < t->n_row; i++)
		row_at(&t->row[i], t, &s->entry[i]);
	t->rows_at = t->tenths;
}

enum column {
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

/* As many as there is room for, those of low rank first; right: numbers. */
static const struct {
	const char *head;
	int width, rank;
	bool right;
} TABLE[COLUMNS] = {[NAME] = {"site", 14, 0, false},
    [ROCK] = {"rock", 11, 5, false},
    [TOP] = {"top mm", 6, 6, true},
    [RUNS] = {"runs m/s", 10, 7, false},
    [PARAMETERS] = {"parameters", 15, 4, false},
    [RMS] = {"RMSE", 7, 3, true},
    [HOLDOUT] = {"hold-out", 9, 2, true},
    [P50] = {"P50 mm", 8, 1, true},
    [MISFIT] = {"misfit", 10, 8, true},
    [GENERATIONS] = {"generations", 12, 9, true},
    [MACHINE] = {"machine", 26, 10, false}};

static bool
has_room(enum column column, int columns)
{
	int taken = 0;
	for (int i = 0; i < COLUMNS; i++)
		if (TABLE[i].rank <= TABLE[column].rank)
			taken += TABLE[i].width;
	return taken <= columns;
}

/* "69 o74 79": o is held out, as on the slider's track; "8 runs" where there is
 * no room for all. */
static void
runs_text(const struct entry *e, char *text, size_t n)
{
	size_t at = 0;
	text[0] = '\0';
	for (size_t r = 0; r < e->site->n_run && at + 1 < n; r++) {
		const struct run *run = &e->site->run[r];
		if (run->product.n == 0)
			continue;
		int more = snprintf(text + at, n - at, "%s%s%g",
		    at > 0 ? " " : "", e->train[r] ? "" : "o", run->speed);
		at += more > 0 ? (size_t)more : 0;
	}
	if (at >= (size_t)TABLE[RUNS].width)
		snprintf(text, n, "%zu runs", site_products(e->site));
	if (text[0] == '\0')
		snprintf(text, n, "feed only");
}

static const char *
origin_text(const struct session *s, const struct entry *e)
{
	return e->has_fit          ? light_verdict(s, e, NULL)
	       : !e->has_params    ? "not calibrated"
	       : e->origin->stored ? "from the store"
				   : origin_words(e);
}

/* "-" where there is no such number. */
static void
number_text(double x, int digits, const char *behind, char *text, size_t n)
{
	if (isfinite(x))
		snprintf(text, n, "%.*f%s", digits, x, behind);
	else
		snprintf(text, n, "-");
}

static void
cell_text(
    const struct tui *t, size_t i, enum column column, char *text, size_t n)
{
	const struct entry *e = &t->session->entry[i];
	const struct site_row *row = i < t->n_row ? &t->row[i] : NULL;
	text[0] = '\0';
	switch (column) {
	case NAME:
		snprintf(text, n, "%c %s", i == t->session->current ? '*' : ' ',
		    e->key);
		break;
	case ROCK:
		snprintf(text, n, "%s", e->site->rock);
		break;
	case TOP:
		if (e->site->top_size > 0)
			snprintf(text, n, "%g", units_mm(e->site->top_size));
		break;
	case RUNS:
		runs_text(e, text, n);
		break;
	case PARAMETERS:
		snprintf(text, n, "%s", origin_text(t->session, e));
		break;
	case RMS:
		number_text(
		    e->has_fit ? 100 * e->fit.rmse : NAN, 2, "", text, n);
		break;
	case HOLDOUT:
		number_text(row != NULL ? row->holdout : NAN, 2, "", text, n);
		break;
	case P50:
		number_text(row != NULL ? row->p50 : NAN, 2,
		    row != NULL && row->beyond ? "x" : "", text, n);
		break;
	case MISFIT:
		if (e->has_fit)
			snprintf(text, n, "%.3g", e->fit.misfit);
		break;
	case GENERATIONS:
		if (e->has_fit)
			snprintf(text, n, "%zu", e->fit.generations);
		break;
	default:
		snprintf(text, n, "%s", e->site->machine);
	}
}

/* Row 0: the heads; cells are set one by one, as names may have wide
 * letters. */
static void
draw_row(const struct tui *t, const struct area *area, int row, size_t i)
{
	int at = 0;
	unsigned look = row == 0          ? LOOK_BOLD
			: i == t->site_at ? LOOK_REVERSE
					  : LOOK_PLAIN;
	if (row > 0)
		screen_text(area, row, 0, look, "%*s", area->columns, "");
	for (int c = 0; c < COLUMNS; c++) {
		char text[64];
		if (!has_room((enum column)c, area->columns))
			continue;
		if (row == 0)
			snprintf(text, sizeof text, "%s%s",
			    c == NAME ? "  " : "", TABLE[c].head);
		else
			cell_text(t, i, (enum column)c, text, sizeof text);
		int gap = TABLE[c].right || c == NAME ? 0 : 1;
		struct area cell = *area;
		cell.column += at + gap;
		cell.columns = TABLE[c].width - gap;
		if (cell.columns > area->columns - at - gap)
			cell.columns = area->columns - at - gap;
		if (TABLE[c].right)
			screen_text(
			    &cell, row, 0, look, "%*s", cell.columns, text);
		else
			screen_text(&cell, row, 0, look, "%s", text);
		at += TABLE[c].width;
	}
}

/* The first site shown: that of the cursor is always. */
static size_t
first_shown(const struct tui *t)
{
	int rows = pane_list_area(t).rows;
	size_t room = rows > 2 ? (size_t)rows - 1 : 1;
	return t->site_at >= room ? t->site_at - room + 1 : 0;
}

/* More of the site under the cursor, at the foot of the page. */
static void
draw_site(const struct tui *t, const struct area *area)
{
	const struct entry *e = &t->session->entry[t->site_at];
	char *label = session_label(e->site);
	int row = area->rows - 3;
	screen_text(area, row++, 0, LOOK_BOLD, "%s%s%s", label,
	    e->site->machine[0] != '\0' ? "; " : "", e->site->machine);
	free(label);
	screen_text(area, row++, 0, 0, "data: %s",
	    e->site->provenance[0] != '\0' ? e->site->provenance
					   : "provenance not stated");
	if (!e->has_params)
		return;
	int at = 0;
	const struct breakage *of = breakage_of(&e->params);
	for (size_t j = 0; j < of->n; j++)
		at = screen_text(area, row, at, 0, "%s%s %.4g",
		    at > 0 ? "  " : "", of->parameter[j].name, e->params.at[j]);
}

static void
draw(struct tui *t)
{
	enum { HEAD = 1, DETAIL = 4 };
	const struct area area = pane_list_area(t);
	const struct session *s = t->session;
	const struct area *body = &t->places.body;
	size_t top = first_shown(t);
	if (t->focus == &page_sites && body->rows > 1)
		t->cursor = (struct cursor){
		    body->row + HEAD + (int)(t->site_at - top), 0};
	if (s->n_entry == 0) {
		screen_text(&area, 0, 2, 0, "none is loaded: type :load FILE");
		return;
	}
	draw_row(t, &area, 0, 0);
	for (size_t i = top; i < s->n_entry; i++)
		draw_row(t, &area, (int)(i - top) + HEAD, i);
	if ((int)s->n_entry + HEAD + DETAIL <= area.rows)
		draw_site(t, &area);
}

static void
choose(struct tui *t)
{
	const struct session *s = t->session;
	char *line = xasprintf(
	    "use %s", t->site_at < s->n_entry ? s->entry[t->site_at].key : "");
	control_keep(t);
	control_run(t, line);
	free(line);
}

static bool
act(struct tui *t, const struct key *key)
{
	if (key->act == ACT_CHOOSE) {
		choose(t);
		return true;
	}
	if (key->act == ACT_LIST)
		t->focus = &page_sites;
	else if (key->act != ACT_MOVE || t->focus != &page_sites)
		return false;
	t->site_at = (size_t)pane_moved(
	    (int)t->site_at, key->amount, t->session->n_entry);
	return true;
}

const struct page_ops page_sites = {.name = "Sites",
    .hints = "Up/Down site  Enter use it  ? keys  q quit  x pin  : command",
    .update = update,
    .draw = draw,
    .takes_focus = true,
    .key = act};
