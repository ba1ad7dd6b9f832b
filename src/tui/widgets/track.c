/* Draws the track, with the speeds that meet the goal (its window, see
 * speed_search.h), and a heading shortened to fit; handles the keys that go to
 * the ends of the window.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/track.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/quantity_words.h"
#include "core/model/breakage.h"
#include "core/psd/rotor_speed.h"
#include "tui/acts.h"
#include "tui/widgets/goal.h"
#include "tui/screen.h"

enum { MOST_MARKS = 300 };

struct track_signs
track_signs(void)
{
	static const struct track_signs ASCII = {"*", "o", "."},
					UTF8 = {"\u25C6", "\u25C7", "\u254C"};
	return screen_charset() == CHARSET_ASCII ? ASCII : UTF8;
}

bool
track_is_training_run(const struct entry *entry, size_t run)
{
	const struct origin *o = entry->origin;
	if (!origin_has_training_speeds(entry))
		return entry->train[run];
	for (size_t i = 0; i < o->n_speed; i++)
		if (o->speed[i] == entry->site->run[run].speed)
			return true;
	return false;
}

/* Lists the measured speeds, and the speeds at which the parameters were
 * trained, even on another site.  Returns their number. */
static size_t
list_slider_speed_marks(const struct entry *entry, struct slider_range range,
    struct slider_mark mark[static MOST_MARKS])
{
	const struct origin *o = entry->origin;
	bool trained = origin_has_training_speeds(entry);
	size_t n = 0;
	for (size_t i = 0; trained && i < o->n_speed && n < MOST_MARKS; i++)
		mark[n++] = (struct slider_mark){
		    slider_position_of_speed(range, o->speed[i]), true};
	for (size_t r = 0; r < entry->site->n_run && n < MOST_MARKS; r++) {
		const struct run *run = &entry->site->run[r];
		bool known = track_is_training_run(entry, r);
		if (run->product.n > 0 && (!trained || !known))
			mark[n++] = (struct slider_mark){
			    slider_position_of_speed(range, run->speed), known};
	}
	return n;
}

void
track_on_mouse(struct tui *t, const struct mouse_event *touched)
{
	struct area track = layout_track_area(&t->layout);
	int column = touched->area.column + touched->column - track.column;
	tui_set_slider_position(
	    t, slider_position_at_column(
		   tui_slider_range(t), column, track.columns));
}

/* Returns true if the goal is met somewhere in a cell of the track.  Sets
 * *certain to whether it is so with the probability of bands. */
static bool
is_goal_met_in_cell(
    const struct tui *t, const struct area *track, int column, bool *certain)
{
	struct slider_range range = tui_slider_range(t);
	double cells = fmax(1, track->columns - 1),
	       half = (range.most - range.least) / 2.0 / cells;
	double middle = range.least + 2 * half * column;
	return goal_is_met_between(t,
	    slider_speed_of_position(range, middle - half),
	    slider_speed_of_position(range, middle + half), certain);
}

/* Returns an array that marks the cells in which a window, or its certain part,
 * begins or ends.  The caller frees it. */
static bool *
find_window_end_cells(const struct tui *t, const struct area *track)
{
	size_t n = (size_t)track->columns;
	bool *end = xcalloc(n + 1, sizeof *end);
	int was = 0;
	for (size_t c = 0; c <= n; c++) {
		bool certain = false;
		int is =
		    c < n && is_goal_met_in_cell(t, track, (int)c, &certain)
			? 1 + certain
			: 0;
		if (is > was)
			end[c] = true;
		else if (is < was)
			end[c - 1] = true;
		was = is;
	}
	return end;
}

/* Draws a cell: a heavy line where the goal is met, with gaps if that is not
 * certain. */
static void
track_draw_cell(const struct tui *t, const struct area *track, int column,
    const struct slider_cell *cell)
{
	struct track_signs signs = track_signs();
	bool ascii = screen_charset() == CHARSET_ASCII, certain = false;
	char sign = cell->text ? '\0' : cell->sign;
	bool free = sign == '-' || (sign == 'x' && column % 2 == 0);
	bool met = free && is_goal_met_in_cell(t, track, column, &certain);
	const char letter[2] = {cell->sign};
	const char *text = met && certain          ? (ascii ? "#" : "\u2501")
			   : met                   ? (ascii ? "=" : "\u254D")
			   : sign == '|'           ? signs.trained
			   : sign == 'o'           ? signs.held_out
			   : sign == 'x'           ? signs.beyond
			   : sign == '-' && !ascii ? "\u2500"
						   : letter;
	screen_draw_text_in_series_colour(track, 0, column,
	    met ? SERIES_OTHER : SERIES_TEXT,
	    met && certain ? LOOK_BOLD
	    : sign == 'x'  ? LOOK_DIM
			   : LOOK_PLAIN,
	    text);
}

static int
make_slider_track_cells(const struct tui *t, const struct area *track,
    struct slider_cell *cell, const bool *kept)
{
	const struct entry *entry = tui_current_site_entry(t);
	struct slider_range range = tui_slider_range(t);
	struct slider_mark mark[MOST_MARKS];
	size_t n = list_slider_speed_marks(entry, range, mark);
	return slider_fill_cells(cell, track->columns, range,
	    tui_slider_position(t), mark, n, kept, tr("extrapolated"));
}

void
track_draw(struct tui *t)
{
	hits_add_mouse_handler(
	    &t->hits, HIT_SLIDE, t->layout.track, track_on_mouse, 0);
	struct area track = layout_track_area(&t->layout);
	const bool acts = t->ui.page == PAGE_PREDICT;
	struct slider_range range = tui_slider_range(t);
	FREED struct slider_cell *cell =
	    xcalloc((size_t)track.columns + 1, sizeof *cell);
	FREED bool *kept = find_window_end_cells(t, &track);
	int at = make_slider_track_cells(t, &track, cell, kept), end = at + 1;
	while (end < track.columns && cell[end - 1].sign != ']' &&
	       cell[at].sign == '[')
		end++;
	for (int c = 0; c < track.columns; c++)
		if (c < at || c >= end)
			track_draw_cell(t, &track, c, &cell[c]);
	for (int c = at; c < end; c++)
		screen_draw_text(&track, 0, c, acts ? LOOK_REVERSE : LOOK_BOLD,
		    "%c", cell[c].sign);
	if (track.column > 0) {
		const int per_unit = range.rotor > 0 ? 1 : 10,
			  digits = t->layout.end_columns - 1;
		const struct area *row = &t->layout.track;
		screen_draw_text(
		    row, 0, 0, 0, "%*d", digits, range.least / per_unit);
		screen_draw_text(row, 0, row->columns - digits, 0, "%d",
		    range.most / per_unit);
	}
	/* On the bracket, because a cursor on the number would hide a digit. */
	t->cursor.column = track.column + at;
}

/* A part of the heading.  text: in several lengths, the longest first.  at: the
 * one shown.  column: where it is shown. */
enum { QUANTITY, GOAL, SPEED, SIGNS, PARTS };
enum { LENGTHS = 6 };
struct part {
	size_t n, at;
	char *text[LENGTHS];
	unsigned look;
	int column;
};

static void
add_shorter_heading_text(struct part *part, char *text)
{
	part->text[part->n++] = text;
}

static void
add_quantity_heading_variants(const struct tui *t, struct part *part)
{
	const char *unit = quantities_unit(&t->ui.quantity);
	FREED char *words = quantities_name(&t->ui.quantity);
	xappend(&words, "%s%s", unit[0] != '\0' ? ", " : "", unit);
	if (t->layout.strip.rows > 0 && !goals_is_set(t->session))
		add_shorter_heading_text(
		    part, xasprintf(tr("%s at all speeds"), words));
	if (t->layout.strip.rows > 0)
		add_shorter_heading_text(part, xstrdup(words));
	add_shorter_heading_text(part, xstrdup(""));
}

static void
add_goal_heading_variants(const struct tui *t, struct part *part)
{
	for (int length = 0; length < GOALS_LENGTHS; length++)
		add_shorter_heading_text(
		    part, goal_result_text(t, (enum goals_length)length));
	add_shorter_heading_text(part, xstrdup(""));
	part->look = LOOK_BOLD;
}

/* Returns the chance that the goal is met at the slider's speed, "  here 85 %
 * sure"; "" if it is not known, or the view of the goal shows it. */
static char *
goal_chance_text(const struct tui *t)
{
	double certain = goal_probability_at_slider(t);
	if (isnan(certain) || goal_is_viewed(t))
		return xstrdup("");
	FREED char *percent = conditions_probability_text(certain);
	return xasprintf(tr("  here %s sure"), percent);
}

/* Adds the rotor tip speed, with the energy and the rotor's rpm; in brief only
 * in the unit of the sheet.  With a goal, adds its chance. */
static void
add_speed_heading_variants(const struct tui *t, struct part *part)
{
	double v = tui_slider_speed(t);
	double rotor = tui_rotor_diameter(t);
	FREED char *words = xasprintf(
	    tr("%.1f m/s  %.0f J/kg"), v, specific_energy_at_speed(v));
	FREED char *turns = rotor > 0 ? xasprintf(tr("  %.0f rpm"),
					    rotor_speed_to_rpm(v, rotor))
				      : xstrdup("");
	FREED char *brief = answers_speed_text(tui_current_site(t), v, 1);
	FREED char *sure = goal_chance_text(t);
	add_shorter_heading_text(
	    part, xasprintf(tr("rotor tip speed %s%s%s"), words, turns, sure));
	add_shorter_heading_text(part, xasprintf("%s%s%s", words, turns, sure));
	if (rotor > 0 || sure[0] != '\0')
		add_shorter_heading_text(
		    part, xasprintf(tr("%.1f m/s%s%s"), v, turns, sure));
	else
		add_shorter_heading_text(part, xstrdup(words));
	add_shorter_heading_text(part, xasprintf("%s%s", brief, sure));
	add_shorter_heading_text(part, xstrdup(brief));
	add_shorter_heading_text(part, xstrndup(brief, strcspn(brief, " ")));
}

/* Adds what the signs mean.  Beyond the measured speeds, the word
 * "extrapolated" is never left out. */
static void
add_heading_legend_texts(const struct tui *t, struct part *part)
{
	struct track_signs signs = track_signs();
	enum { REASONS = 34 };
	/* On a wide panel, the light says so. */
	bool beyond = t->layout.side.columns < REASONS &&
		      t->view.shown.product.n > 0 &&
		      answers_is_speed_extrapolated(
			  tui_current_site_entry(t), t->view.shown.speed);
	FREED char *word = xasprintf("%s %s", signs.beyond,
	    beyond ? tr("EXTRAPOLATED") : tr("extrapolated"));
	FREED char *marks = xasprintf(
	    tr("%s trained  %s held out"), signs.trained, signs.held_out);
	add_shorter_heading_text(part, xasprintf("%s  %s", word, marks));
	add_shorter_heading_text(part, xstrdup(beyond ? word : marks));
	if (!beyond)
		add_shorter_heading_text(part, xstrdup(""));
	part->look = beyond ? LOOK_BOLD : LOOK_DIM;
}

/* Returns the width of a part, with the rule before it. */
static int
width_of_slider_heading_part(const struct part *part)
{
	int width = text_width_in_columns(part->text[part->at]);
	return width > 0 ? width + 4 : 0;
}

/* Gives each part its shortest text, then lengthens the parts in turn while
 * there is room. */
static void
shorten_heading_parts_to_fit(struct part part[static PARTS], int columns)
{
	static const size_t TURNS[] = {SPEED, QUANTITY, GOAL, SPEED, GOAL, GOAL,
	    GOAL, SPEED, GOAL, SPEED, SIGNS, SIGNS, QUANTITY, SPEED};
	int width = 2;
	for (size_t i = 0; i < PARTS; i++) {
		part[i].at = part[i].n - 1;
		width += width_of_slider_heading_part(&part[i]);
	}
	for (size_t k = 0; k < ARRAY_LEN(TURNS); k++) {
		struct part *p = &part[TURNS[k]];
		int was = width_of_slider_heading_part(p);
		if (p->at == 0)
			continue;
		p->at--;
		if (width - was + width_of_slider_heading_part(p) > columns)
			p->at++;
		width += width_of_slider_heading_part(p) - was;
	}
	int left = 0, right = columns - 2;
	for (size_t i = 0; i < SPEED; i++) {
		part[i].column = left + 2;
		left += width_of_slider_heading_part(&part[i]);
	}
	for (size_t i = PARTS; i-- > SPEED;) {
		right -= width_of_slider_heading_part(&part[i]);
		part[i].column = right + 2;
	}
}

void
track_draw_heading(struct tui *t)
{
	static const int KEY[PARTS] = {[QUANTITY] = 'y', [GOAL] = 't'};
	const struct area *area = &t->layout.caption;
	struct part part[PARTS] = {0};
	add_quantity_heading_variants(t, &part[QUANTITY]);
	add_goal_heading_variants(t, &part[GOAL]);
	add_speed_heading_variants(t, &part[SPEED]);
	add_heading_legend_texts(t, &part[SIGNS]);
	shorten_heading_parts_to_fit(part, area->columns);
	screen_draw_horizontal_rule(area);
	for (size_t i = 0; i < PARTS; i++) {
		const char *text = part[i].text[part[i].at];
		int column = part[i].column > 0 ? part[i].column : 0;
		if (text[0] != '\0')
			screen_draw_text(
			    area, 0, column, part[i].look, " %s ", text);
		if (KEY[i] != 0)
			hits_add_key_area(&t->hits,
			    area_of_columns_in_row(
				area, 0, column, text_width_in_columns(text)),
			    KEY[i]);
		for (size_t k = 0; k < part[i].n; k++)
			free(part[i].text[k]);
	}
}

/* Lists, in no order, the speeds to which n and p move the slider: the limits
 * of the goal, or else the measured speeds.  Returns their number. */
static size_t
list_slider_stops(const struct tui *t, double speed[static MOST_MARKS])
{
	struct slider_mark mark[MOST_MARKS];
	struct slider_range range = tui_slider_range(t);
	size_t n = goal_list_limit_speeds(t, speed, MOST_MARKS);
	if (n > 0 || tui_current_site_entry(t) == NULL)
		return n;
	n = list_slider_speed_marks(tui_current_site_entry(t), range, mark);
	for (size_t i = 0; i < n; i++)
		speed[i] = slider_speed_of_position(range, mark[i].position);
	return n;
}

static void
move_slider_to_next_stop(struct tui *t, int by)
{
	double stop[MOST_MARKS];
	const struct slider_range range = tui_slider_range(t);
	const int from = tui_slider_position(t);
	int best = from;
	double speed = NAN;
	size_t n = list_slider_stops(t, stop);
	for (size_t i = 0; i < n; i++) {
		int at = slider_position_of_speed(range, stop[i]);
		if (by * (at - from) > 0 &&
		    (best == from || by * (best - at) > 0)) {
			best = at;
			speed = stop[i];
		}
	}
	if (tui_current_site_entry(t) == NULL)
		tui_set_message(t, true, TUI_NO_SITE);
	else if (best == from)
		tui_set_message(t, false,
		    goals_is_set(t->session)
			? (by > 0 ? N_("no faster limit: p goes to a slower "
				       "one, N to the best speed")
				  : N_("no slower limit: n goes to a faster "
				       "one, N to the best speed"))
		    : by > 0 ? N_("no faster run: t sets a goal")
			     : N_("no slower run: t sets a goal"));
	else if (range.rotor > 0)
		/* Not to the nearest rpm, where the goal may be missed. */
		tui_set_slider_speed(t, speed);
	else
		tui_set_slider_position(t, best);
}

/* Says that none of the speeds searched meets the goal, and which is
 * nearest. */
static void
report_nearest_goal_speed(struct tui *t, double best, const char *rpm)
{
	const struct speed_search *found = t->view.goal.found;
	FREED char *range =
	    answers_speed_range_words(tui_current_site_entry(t)->site,
		found->speed[0], found->speed[found->n - 1], false);
	tui_set_message(t, false,
	    "no speed from %s meets the goal, %.1f m/s%s is nearest: %s", range,
	    best, rpm, t->view.goal.missed);
}

/* Moves the slider to the best speed of the goal, and says how well the goal is
 * met there. */
static void
move_slider_to_best_speed(struct tui *t)
{
	const struct goal *g = &t->view.goal;
	double best = goal_best_speed(t);
	if (!isfinite(best)) {
		tui_set_message(t, false,
		    goals_is_set(t->session) ? N_("no best speed is known")
					     : N_("no goal yet: t sets one"));
		return;
	}
	const double from = tui_slider_speed(t);
	tui_set_slider_speed(t, best);
	t->keep_message = true;
	/* The next prediction shows its own command, and not the one before. */
	if (tui_slider_speed(t) != from)
		xfree_and_set(&t->command, NULL);
	FREED char *rpm =
	    rotor_speed_rpm_text(tui_rotor_diameter(t), best, NAN);
	if (g->missed != NULL)
		report_nearest_goal_speed(t, best, rpm);
	else if (g->n_value > 0)
		tui_set_message(
		    t, false, "the goal is met at %.1f m/s%s", best, rpm);
	else if (isnan(g->found->best_certain))
		tui_set_message(
		    t, false, "best speed of the goal: %.1f m/s%s", best, rpm);
	else {
		FREED char *percent =
		    conditions_probability_text(g->found->best_certain);
		tui_set_message(t, false,
		    "best speed of the goal: %.1f m/s%s (chance %s)", best, rpm,
		    percent);
	}
}

static bool
is_goal_search_pending(const struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	return entry != NULL && entry->has_params && goal_is_search_needed(t);
}

void
act_move_slider_to_goal_speed(struct tui *t, const struct key *key)
{
	if (is_goal_search_pending(t) &&
	    session_entry_being_fitted(t->session) ==
		tui_current_site_entry(t)) {
		tui_set_message(t, false,
		    "the goal's speeds are known when the calibration ends");
		return;
	}
	t->pending_key = key;
	t->pending_from = t->ui.speed;
	track_run_pending_key(t, t->aside);
	if (t->pending_key != NULL)
		tui_set_message(t, false,
		    "working out the goal's speeds: the slider will then go "
		    "there; Esc keeps it here");
}

void
track_run_pending_key(struct tui *t, bool now)
{
	const struct key *key = t->pending_key;
	if (key == NULL || t->ui.speed != t->pending_from) {
		t->pending_key = NULL;
		return;
	}
	while (now && is_goal_search_pending(t))
		goal_run_search_step(t);
	if (is_goal_search_pending(t))
		return;
	t->pending_key = NULL;
	t->message[0] = '\0';
	if (key->amount != 0)
		move_slider_to_next_stop(t, key->amount);
	else
		move_slider_to_best_speed(t);
}
