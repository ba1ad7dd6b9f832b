/* The open page, and drawing functions for pages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/pane.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/site_chart.h"
#include "tui/screen.h"
#include "tui/widgets/response_strip.h"

#define PAGE_ADDRESS(NUMBER, name, heading, key) &page_##name,
#define PAGE_HEADING(NUMBER, name, heading, key) heading,

const char *const PAGE_HEADINGS[PAGES] = {SCREEN_PAGES(PAGE_HEADING)};

const struct page_ops *
pages_current(const struct tui *t)
{
	static const struct page_ops *const OF[PAGES] = {
	    SCREEN_PAGES(PAGE_ADDRESS)};
	return OF[t->ui.page];
}

void
pages_go_to(struct tui *t, enum page page)
{
	if (t->ui.page != page) {
		t->filter = (struct edit){0};
		t->ui.cell.on = false;
		tui_clear_click_areas(t);
	}
	t->ui.page = page;
}

void
pages_update(struct tui *t)
{
	if (t->picker.on)
		t->picker.rows->update(t);
	response_strip_update(t);
	t->view.rows_left = false;
	if (pages_current(t)->update != NULL)
		pages_current(t)->update(t);
}

struct area
pane_list_area(const struct tui *t)
{
	struct area area = t->layout.body;
	area.rows += t->layout.legend.rows;
	return area;
}

/* Handles a click on a plot: says what is drawn there, and lets the page
 * act. */
static void
on_click_plot(struct tui *t, const struct mouse_event *touched)
{
	struct plots_found found;
	if (touched->item >= t->n_drawn)
		return;
	struct plot_request *request = &t->drawn[touched->item];
	request->asked.entry = tui_site_entry_for_prediction(t);
	if (!plots_find_mark_at_cell(t->session, request, touched->area.columns,
		touched->area.rows, touched->column, touched->row, &found))
		return;
	void (*point)(struct tui *, enum plot_kind, double, double) =
	    pages_current(t)->point;
	if (point != NULL)
		point(t, request->kind, found.x, found.y);
	if (found.words != NULL)
		tui_set_message(t, false, "%s", found.words);
	free(found.words);
}

void
pane_draw_plot(
    struct tui *t, const struct plot_request *request, const struct area *area)
{
	struct error error = {0};
	struct plot_request r = *request;
	if (area->rows < 1 || area->columns < 1)
		return;
	r.charset = screen_charset();
	if (r.asked.entry == NULL)
		r.asked.entry = tui_site_entry_for_prediction(t);
	struct canvas *canvas = plots_draw_canvas(
	    t->session, &r, area->columns, area->rows, &error);
	if (canvas != NULL) {
		screen_draw_canvas(area, canvas);
		canvas_free(canvas);
		if (request->asked.entry != NULL || t->n_drawn == PLOTS_DRAWN)
			return;
		t->drawn[t->n_drawn] = r;
		hits_add_mouse_handler(
		    &t->hits, HIT_SLIDE, *area, on_click_plot, t->n_drawn++);
		return;
	}
	int row =
	    screen_draw_wrapped(area, area->rows / 3, LOOK_BOLD, error.text);
	screen_draw_wrapped(area, row, 0, error.hint);
}

/* Draws the name of a curve after those to its left, if all of it fits.
 * Returns the column after it. */
static int
draw_legend_curve_name(const struct tui *t, int column, enum series series,
    unsigned look, const char *text)
{
	const struct area *area = &t->layout.legend;
	int from = column > 0 ? column + 2 : 0;
	if (from + text_width_in_columns(text) > area->columns)
		return column;
	return screen_draw_text_in_series_colour(
	    area, 0, from, series, look, text);
}

/* Names the limits of the envelope in use and its fraction. */
static void
draw_legend_envelope_limits(const struct tui *t, int column, bool ascii)
{
	char text[40], *words = session_envelope_size_fraction_text(t->session);
	snprintf(text, sizeof text, "%s %s", ascii ? "@" : "\u2501", words);
	if (t->session->spec != NULL)
		column = draw_legend_curve_name(
		    t, column, SERIES_TEXT, 0, tr("T L limits"));
	if (words[0] != '\0')
		draw_legend_curve_name(t, column, SERIES_PREDICTED, 0, text);
	free(words);
}

/* Says how many speeds are not drawn, and names the mark of each run.  Sets
 * *moved if any product was moved to the feed. */
static int
draw_legend_runs(const struct tui *t, int column, bool *moved)
{
	const struct entry *entry = tui_current_site_entry(t);
	const struct site *site = entry->site;
	char text[64];
	if (site_chart_count_speeds_left_out(site) > 0) {
		snprintf(text, sizeof text, tr("runs not drawn: %zu"),
		    site_chart_count_speeds_left_out(site));
		column =
		    draw_legend_curve_name(t, column, SERIES_TEXT, 0, text);
	}
	for (size_t r = 0; r < site->n_run; r++) {
		bool held_out = !entry->train[r];
		if (site_run_repeats_speed(site, r) ||
		    !site_run_is_among_nearest(
			site, r, tui_slider_speed(t), SITE_CHART_SPEEDS))
			continue;
		struct chart_series look =
		    site_chart_run_style(site, r, held_out);
		FREED char *sample =
		    chart_legend_sample(&look, screen_charset());
		snprintf(text, sizeof text, "%s %g%s", sample,
		    answers_speed_in_sheet_unit(site, site->run[r].speed),
		    held_out ? tr(" held out") : "");
		column = draw_legend_curve_name(
		    t, column, look.series, LOOK_BOLD, text);
		*moved = *moved || tui_is_product_moved_to_feed(t, r);
	}
	return column;
}

/* Returns the name of the feed drawn.  runs: it is that of the runs, not of the
 * prediction. */
static char *
legend_feed_name(const struct tui *t, bool runs)
{
	const struct site *site = tui_current_site(t);
	const char *other = tui_other_feed(t);
	if (other[0] != '\0')
		return xstrdup(runs ? tr("feed of the sheet") : other);
	if (runs || !site->individual_feeds || !(t->ui.feed > 0))
		return xstrdup(tr("feed"));
	return xasprintf(
	    "%s %g", tr("feed"), answers_speed_in_sheet_unit(site, t->ui.feed));
}

/* Names the feed and, if there is room, says that measured products are moved
 * to it. */
static int
draw_legend_feed(
    const struct tui *t, int column, const char *line, bool runs, bool moved)
{
	FREED char *name = legend_feed_name(t, runs);
	FREED char *feed = xasprintf("%s %s", line, name);
	FREED char *words = xasprintf(tr("%s, runs moved"), feed);
	int after = column;
	if (moved)
		after =
		    draw_legend_curve_name(t, column, SERIES_FEED, 0, words);
	return after > column
		   ? after
		   : draw_legend_curve_name(t, column, SERIES_FEED, 0, feed);
}

/* Draws a legend of one row, because the plot's own legend would leave it
 * little room.  The runs are those that plots_psd draws. */
static void
pane_draw_legend(const struct tui *t, const struct plot_request *request)
{
	const struct entry *entry = tui_current_site_entry(t);
	bool ascii = screen_charset() == CHARSET_ASCII;
	char text[40], sample[16];
	int column = 0;
	if (entry == NULL)
		return;
	bool runs = request->kind == PLOT_RUNS;
	if (runs && entry->has_params)
		column = draw_legend_curve_name(t, column, SERIES_TEXT, 0,
		    ascii ? tr("=~_ predicted") : tr("\u254C predicted"));
	else if (!runs && t->view.current.site[0] != '\0') {
		bool dashed =
		    answers_is_speed_extrapolated(entry, tui_slider_speed(t));
		const char *line = ascii ? "#" : "\u2500";
		snprintf(sample, sizeof sample, "%s%s%s", line,
		    dashed ? " " : line, line);
		snprintf(text, sizeof text, tr("%s predicted%s"), sample,
		    correction_legend_text(t->session,
			tui_site_entry_for_prediction(t), &t->view.shown));
		column = draw_legend_curve_name(
		    t, column, SERIES_PREDICTED, LOOK_BOLD, text);
	}
	if (request->kept != NULL)
		column = draw_legend_curve_name(t, column, SERIES_OTHER, 0,
		    ascii ? tr("% pinned") : tr("\u254C pinned"));
	bool moved = false;
	if (runs || tui_other_feed(t)[0] == '\0')
		column = draw_legend_runs(t, column, &moved);
	column = draw_legend_feed(t, column,
	    ascii  ? "."
	    : runs ? "\u2500"
		   : "\u2508",
	    runs, moved && !runs);
	if (runs || t->view.current.site[0] == '\0')
		return;
	int after = draw_legend_curve_name(t, column, SERIES_BREAK, 0,
	    ascii ? tr(": break size") : tr("\u250A break size"));
	if (after == column)
		after = draw_legend_curve_name(t, column, SERIES_BREAK, 0,
		    ascii ? tr(": break") : tr("\u250A break"));
	draw_legend_envelope_limits(t, after, ascii);
}

void
pane_draw_curves(struct tui *t, struct plot_request *request, bool notes)
{
	enum { TALL = 20 };
	struct area plot = t->layout.plot;
	bool psd = request->kind == PLOT_PSD, runs = request->kind == PLOT_RUNS;
	bool below = !psd && !runs && t->layout.legend.rows > 0;
	request->strip = psd ? t->layout.differences.rows : 0;
	plot.rows += t->layout.differences.rows;
	if (request->strip == 0 && (plot.rows >= TALL || below)) {
		request->words |= CHART_LEGEND | (notes ? CHART_NOTES : 0);
		plot.rows += t->layout.legend.rows;
	} else if (t->layout.legend.rows > 0)
		pane_draw_legend(t, request);
	pane_draw_plot(t, request, &plot);
}

/* Returns the number of bytes of the keys with which a hint begins: "n p",
 * "Up/Down". */
static int
length_of_hint_keys(const char *hint)
{
	size_t n = strcspn(hint, " ");
	while (hint[n] == ' ') {
		size_t next = strcspn(hint + n + 1, " ");
		FREED char *name = xstrndup(hint + n + 1, next);
		int code;
		if (!keys_code_of_name(name, &code))
			break;
		n += 1 + next;
	}
	return (int)n;
}

/* Makes the keys at the beginning of a hint react to the mouse: a click on a
 * key presses it; if there is only one, so does a click on its words. */
static void
add_key_hint_click_areas(struct tui *t, int row, int column, const char *hint)
{
	int keys = length_of_hint_keys(hint);
	for (int from = 0, end; from < keys; from = end + 1) {
		end = from + (int)keys_first_name_length(hint + from);
		FREED char *name = xstrndup(hint + from, (size_t)(end - from));
		bool only = from == 0 && end == keys;
		int code, width = only ? (int)strlen(hint) : end - from;
		if (keys_code_of_name(name, &code))
			hits_add_key_area(&t->hits,
			    (struct area){row, column + from, 1, width}, code);
	}
}

void
pane_make_hints_clickable(struct tui *t, int row, int column, const char *hints)
{
	while (*hints != '\0') {
		FREED char *hint = keys_next_hint(&hints);
		add_key_hint_click_areas(t, row, column, hint);
		column += text_width_in_columns(hint) + 2;
	}
}

void
pane_draw_key_hints(struct tui *t, const char *hints)
{
	const struct area *area = &t->layout.hints;
	int column = 0;
	if (area->rows == 0)
		return;
	for (hints = tr(hints); *hints != '\0'; column += 2) {
		FREED char *hint = keys_next_hint(&hints);
		int end = column + text_width_in_columns(hint);
		if (column > 0 && end > area->columns)
			return;
		screen_draw_text(area, 0, column, LOOK_DIM, "%s", hint);
		screen_draw_text(area, 0, column, LOOK_BOLD, "%.*s",
		    length_of_hint_keys(hint), hint);
		add_key_hint_click_areas(
		    t, area->row, area->column + column, hint);
		column = end;
	}
}

int
pane_draw_typed_line(const struct area *area, const char *prompt,
    const struct edit *typing, size_t *from)
{
	char *till = xstrndup(typing->text, typing->at), left[TEXT_SHOWN];
	int before = text_width_in_columns(till),
	    width = text_width_in_columns(prompt);
	const char *shown = typing->text;
	free(till);
	while (before > area->columns - width - 1 && *shown != '\0')
		before -= text_escape_next_character(&shown, left);
	screen_draw_text(area, 0, 0, LOOK_BOLD, "%s", prompt);
	screen_draw_clipped_text(area, 0, width, SERIES_TEXT, LOOK_BOLD, shown);
	*from = (size_t)(shown - typing->text);
	return width + before;
}

int
pane_draw_search_word(struct tui *t, const struct area *area, const char *word,
    const char *found, const char *keys)
{
	int at = screen_draw_text(area, 0, 0, LOOK_BOLD, "/%s", word);
	if (found == NULL)
		return at;
	int column = screen_draw_text(area, 0, at + 2, 0, "%s", found) + 2;
	if (column + text_width_in_columns(keys) <= area->columns) {
		screen_draw_text(area, 0, column, LOOK_DIM, "%s", keys);
		pane_make_hints_clickable(
		    t, area->row, area->column + column, keys);
	}
	return at;
}

char *
pane_curves_plot_arguments(const struct tui *t)
{
	char *where = tui_speed_and_feed_options(t),
	     *words = xasprintf("psd %s", where);
	free(where);
	return words;
}

void
pane_draw_text_lines(const struct area *area, int row, const char *text)
{
	for (unsigned look = LOOK_BOLD; *text != '\0' && row < area->rows;
	     look = LOOK_PLAIN) {
		size_t n = strcspn(text, "\n");
		FREED char *line = xstrndup(text, n);
		row = screen_draw_wrapped(area, row, look, line);
		text += n + (text[n] == '\n');
	}
}

size_t
pane_move_index_clamped(size_t at, int by, size_t n)
{
	long to = (long)at + by;
	return n == 0 || to < 0 ? 0 : to >= (long)n ? n - 1 : (size_t)to;
}
