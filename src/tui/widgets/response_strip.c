/* Computes the curve at a few speeds at a time, between keys.  A step of the
 * slider only moves its mark.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/response_strip.h"

#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/screened.h"
#include "plot/draw.h"
#include "tui/acts.h"
#include "tui/widgets/goal.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"

/* The number of speeds computed in one go, and how long, s, the slider must
 * stand still before that. */
enum { IN_ONE_GO = 8 };
static const double PAUSE = 0.05;

static struct quantity
make_response_strip_quantity(enum quantity_kind kind, double x, double coarse)
{
	return (struct quantity){.kind = kind,
	    .x = x,
	    .fraction = {.coarse = coarse, .partition = PARTITION_IDEAL}};
}

struct quantity
response_strip_default_quantity(void)
{
	return make_response_strip_quantity(QUANTITY_SIZE, 0.8, 0);
}

void
act_next_quantity(struct tui *t, const struct key *key)
{
	const struct quantity all[] = {response_strip_default_quantity(),
	    make_response_strip_quantity(QUANTITY_SIZE, 0.5, 0),
	    make_response_strip_quantity(QUANTITY_SIZE, 0.2, 0),
	    make_response_strip_quantity(QUANTITY_PASSING, 4e-3, 0),
	    make_response_strip_quantity(QUANTITY_PASSING, 2e-3, 0),
	    make_response_strip_quantity(QUANTITY_PASSING, 0.063e-3, 0),
	    make_response_strip_quantity(QUANTITY_SHARE, 0, 2e-3),
	    make_response_strip_quantity(QUANTITY_SHARE, 0, 4e-3)};
	const int n = ARRAY_LEN(all);
	int by = key->amount, at = by > 0 ? n - 1 : 0;
	if (tui_current_site_entry(t) == NULL)
		return;
	for (int i = 0; i < n; i++)
		if (quantity_is_same(&all[i], &t->ui.quantity))
			at = i;
	do
		at = (at + by + n) % n;
	while (
	    !quantity_is_same(&all[at], &t->ui.quantity) && at != 0 &&
	    !quantities_check_feed_covers(&all[at], tui_feed_curve(t), NULL));
	t->ui.quantity = all[at];
	t->ui.quantity_of_goal = false;
}

/* Returns true if there is a curve to compute.  A running search has none,
 * because it would change with each generation. */
static bool
can_compute_response_curve(const struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	return entry != NULL && entry->has_params &&
	       session_entry_being_fitted(s) != entry;
}

/* Returns true if the points are of the quantity, feed and basis to show. */
static bool
is_strip_of_shown_quantity(const struct tui *t)
{
	const struct strip *a = &t->view.strip;
	return a->basis == t->view.n_basis &&
	       a->feed == tui_run_index_of_feed(t) &&
	       quantity_is_same(&a->of, &t->ui.quantity);
}

static bool
is_strip_up_to_date(const struct tui *t)
{
	const struct strip *a = &t->view.strip;
	return a->n == STRIP_POINTS && is_strip_of_shown_quantity(t);
}

/* Computes some points.  Opens a forecast each time, because what a forecast
 * borrows may be gone before the next. */
static void
compute_response_strip_points(struct tui *t)
{
	struct strip *a = &t->view.strip;
	const struct slider_range range = tui_slider_range(t);
	if (!is_strip_of_shown_quantity(t))
		a->n = 0;
	a->basis = t->view.n_basis;
	a->feed = tui_run_index_of_feed(t);
	a->of = t->ui.quantity;
	const struct question q = question_of_whole_product(
	    t->session, tui_site_entry_for_prediction(t), a->feed);
	struct forecast *f = forecast_open(t->session, &q, &a->of, 1);
	for (int i = 0; i < IN_ONE_GO && a->n < STRIP_POINTS; i++, a->n++) {
		double *value = a->value[a->n];
		double share = (double)a->n / (STRIP_POINTS - 1);
		a->speed[a->n] = slider_speed_of_position(
		    range, range.least + share * (range.most - range.least));
		forecast_set_speed(f, a->speed[a->n]);
		struct figure at = forecast_value_in_shown_unit(f, 0);
		value[0] = at.value;
		value[1] = at.low;
		value[2] = at.high;
	}
	forecast_close(f);
}

double
strip_seconds_to_wait(const struct tui *t)
{
	if (!can_compute_response_curve(t))
		return INFINITY;
	if (is_strip_up_to_date(t) && !goal_is_search_needed(t))
		return t->pending_key != NULL ? 0 : INFINITY;
	return fmax(0, t->view.moved + PAUSE - session_clock_seconds());
}

/* Computes a part of the goal.  When it is complete and missed, the message
 * explains that, because a narrow heading has no room for it. */
static void
run_goal_step_and_report_miss(struct tui *t)
{
	bool pending = goal_is_search_needed(t);
	goal_run_search_step(t);
	if (!pending || goal_is_search_needed(t) ||
	    t->view.goal.missed == NULL || t->message[0] != '\0')
		return;
	FREED char *words = goal_result_text(t, GOALS_FULL);
	tui_set_message(t, false, "%s", words);
}

void
response_strip_update(struct tui *t)
{
	if (!can_compute_response_curve(t))
		return;
	bool now = t->aside || strip_seconds_to_wait(t) <= 0;
	do {
		goal_show_condition_quantity(t);
		if (now && !is_strip_up_to_date(t))
			compute_response_strip_points(t);
		else if (now)
			run_goal_step_and_report_miss(t);
	} while (
	    t->aside && (!is_strip_up_to_date(t) || goal_is_search_needed(t)));
}

static double
response_strip_value_at_share(const struct strip *a, double share)
{
	double at = share * (STRIP_POINTS - 1);
	size_t i = at < STRIP_POINTS - 2 ? (size_t)at : STRIP_POINTS - 2;
	double part = at - (double)i;
	return (1 - part) * a->value[i][0] + part * a->value[i + 1][0];
}

/* A limit of the goal on the quantity above the track, in the unit shown. */
struct limit {
	double value;
	const char *name;
};
enum { MOST_LIMITS = 8 };

static size_t
list_goal_limits_of_quantity(
    const struct tui *t, struct limit limit[static MOST_LIMITS])
{
	const struct condition_list *list = &t->view.goal.list;
	size_t n = 0;
	for (size_t i = 0; i < list->n && n + 2 <= MOST_LIMITS; i++) {
		const struct condition *c = &list->at[i];
		bool value = c->least == c->most;
		if (!quantity_is_same(&c->quantity, &t->ui.quantity))
			continue;
		if (!isnan(c->least))
			limit[n++] =
			    (struct limit){quantities_value_in_shown_unit(
					       &t->ui.quantity, c->least),
				value ? tr("goal") : tr("min")};
		if (!isnan(c->most) && !value)
			limit[n++] =
			    (struct limit){quantities_value_in_shown_unit(
					       &t->ui.quantity, c->most),
				tr("max")};
	}
	return n;
}

static double
measured_quantity_of_run(const struct tui *t, size_t run)
{
	const struct psd *product = tui_product_adjusted_to_feed(t, run);
	return product->n > 0 && tui_other_feed(t)[0] == '\0'
		   ? quantities_value_in_shown_unit(&t->ui.quantity,
			 screened_quantity_of_product(product, &t->ui.quantity))
		   : NAN;
}

/* Moves the ends of an axis outward by half of one of n parts, so that the old
 * ends are in the middle of the first and the last part, as on the track. */
static void
widen_axis_by_half_cell(struct axis *axis, int n)
{
	double more = (axis->high - axis->low) / (2 * fmax(1, n - 1));
	axis->low -= more;
	axis->high += more;
}

static void
extend_axis_to_value(struct axis *axis, double value)
{
	if (!isfinite(value))
		return;
	axis->low = fmin(axis->low, value);
	axis->high = fmax(axis->high, value);
}

/* Fits an axis to the range of all values drawn, and to those limits that are
 * outside it by no more than its width.  Returns false if there are no
 * values. */
static bool
scale_response_strip_axis(const struct tui *t, struct axis *axis)
{
	struct limit limit[MOST_LIMITS];
	size_t n = list_goal_limits_of_quantity(t, limit);
	axis->low = INFINITY;
	axis->high = -INFINITY;
	for (size_t i = 0; i < STRIP_POINTS; i++)
		for (size_t k = 0; k < 3; k++)
			extend_axis_to_value(axis, t->view.strip.value[i][k]);
	for (size_t r = 0; r < tui_current_site_entry(t)->site->n_run; r++)
		extend_axis_to_value(axis, measured_quantity_of_run(t, r));
	if (!(axis->low <= axis->high))
		return false;
	double low = axis->low, high = axis->high, more = high - low;
	for (size_t i = 0; i < n; i++)
		if (limit[i].value >= low - more &&
		    limit[i].value <= high + more)
			extend_axis_to_value(axis, limit[i].value);
	if (axis->high - axis->low < 1e-6 * fabs(axis->high) + 1e-9) {
		axis->low -= 0.5;
		axis->high += 0.5;
	}
	return true;
}

/* Adds a series at the speeds of the curve, without values. */
static struct chart_series *
add_strip_series(const struct tui *t, struct chart *chart, enum chart_line line)
{
	const struct chart_series look = {
	    .series = SERIES_PREDICTED, .line = line, .ascii = '#'};
	struct chart_series *s =
	    chart_append_series(chart, look, STRIP_POINTS, "%s", "");
	for (size_t i = 0; i < STRIP_POINTS; i++) {
		s->x[i] = t->view.strip.speed[i];
		s->y[i] = NAN;
	}
	return s;
}

/* Adds the band where it is thicker than the line of the curve. */
static void
add_response_strip_band(const struct tui *t, struct chart *chart, int dots)
{
	enum { THICK = 4 };
	double least = THICK * (chart->y.high - chart->y.low) / dots;
	struct chart_series *s = add_strip_series(t, chart, CHART_MARKS);
	series_allocate_band(s);
	for (size_t i = 0; i < STRIP_POINTS; i++) {
		const double *value = t->view.strip.value[i];
		bool thick = value[2] - value[1] > least;
		s->low[i] = thick ? value[1] : NAN;
		s->high[i] = thick ? value[2] : NAN;
	}
}

/* Adds the curve: solid within the training speeds, dashed beyond. */
static void
response_strip_add_curve(const struct tui *t, struct chart *chart)
{
	struct chart_series *beyond = add_strip_series(t, chart, CHART_DASHED),
			    *within = add_strip_series(t, chart, CHART_SOLID);
	bool was = false;
	for (size_t i = 0; i < STRIP_POINTS; i++) {
		double value = t->view.strip.value[i][0];
		bool is = answers_is_speed_extrapolated(
		    tui_current_site_entry(t), within->x[i]);
		if (!is)
			within->y[i] = value;
		if (is || was)
			beyond->y[i] = value;
		if (is && i > 0)
			beyond->y[i - 1] = t->view.strip.value[i - 1][0];
		was = is;
	}
}

static bool
is_value_on_axis(const struct axis *axis, double value)
{
	return value >= axis->low && value <= axis->high;
}

static void
response_strip_add_goal_limits(const struct tui *t, struct chart *chart)
{
	static const struct chart_series LOOK = {
	    .series = SERIES_OTHER, .line = CHART_DOTTED, .ascii = '.'};
	struct limit limit[MOST_LIMITS];
	size_t n = list_goal_limits_of_quantity(t, limit);
	for (size_t i = 0; i < n; i++) {
		if (!is_value_on_axis(&chart->y, limit[i].value))
			continue;
		struct chart_series *s =
		    chart_append_series(chart, LOOK, 2, "%s", "");
		s->x[0] = chart->x.low;
		s->x[1] = chart->x.high;
		s->y[0] = s->y[1] = limit[i].value;
	}
}

static int
response_strip_row_of_value(
    const struct axis *axis, const struct area *area, double value)
{
	return axis_cell_at_position(
	    1 - axis_relative_position(axis, value), area->rows);
}

/* Returns the step between labels, 1, 2 or 5 times a power of ten: the smallest
 * at which each label has a row, or two if there are many rows. */
static double
choose_round_label_step(const struct axis *axis, int rows)
{
	enum { MANY = 8 };
	static const double ROUND[] = {1, 2, 5, 10, 20, 50};
	rows = rows < MANY ? rows : rows / 2;
	double span = axis->high - axis->low;
	double ten = pow(10, floor(log10(span / rows)));
	size_t i = 0;
	while (span / (ROUND[i] * ten) > rows + 0.5)
		i++;
	return ROUND[i] * ten;
}

/* Draws a number with the decimals of the step, or with more if it has them.
 * Draws it only if it has at most four characters, because a number that is cut
 * would be another number.  Returns true if it was drawn. */
static bool
draw_strip_axis_number(
    const struct tui *t, int row, unsigned look, double value, double step)
{
	char text[32];
	int decimals = step < 1 ? (int)ceil(-log10(step)) : 0;
	int width = snprintf(text, sizeof text, "%.*f", decimals, value);
	if (fabs(value - atof(text)) > 1e-6 * fabs(value))
		width = snprintf(text, sizeof text, "%.6g", value);
	if (width <= 4)
		screen_draw_text(&t->layout.strip, row,
		    width < 4 ? 3 - width : 0, look, "%s", text);
	return width <= 4;
}

/* Draws the name of a limit.  A limit off the scale is named at the nearer
 * edge, with its value. */
static void
response_strip_draw_limit(struct tui *t, const struct axis *axis,
    const struct limit *limit, double step)
{
	static const char *const ARROWS[][2] = {
	    {"v", "^"}, {"\u25BC", "\u25B2"}};
	const struct area *area = &t->layout.strip;
	bool ascii = screen_charset() == CHARSET_ASCII;
	int row = response_strip_row_of_value(axis, area, limit->value);
	bool on = is_value_on_axis(axis, limit->value);
	FREED char *name = on ? xstrdup(limit->name)
			      : xasprintf("%s%s %.6g",
				    ARROWS[!ascii][limit->value > axis->high],
				    limit->name, limit->value);
	int wide =
	    text_width_in_columns(name) < 4 ? 4 : text_width_in_columns(name);
	if (on)
		draw_strip_axis_number(t, row, LOOK_BOLD, limit->value, step);
	screen_draw_text_in_series_colour(
	    area, row, area->columns - wide, SERIES_OTHER, LOOK_BOLD, name);
	hits_add_key_area(&t->hits,
	    area_of_columns_in_row(area, row, area->columns - wide, wide), 't');
}

/* Labels limits, then round values, each in a row of its own.  Of the limits
 * off the scale, labels the nearest on either side, if its row is free. */
static void
response_strip_draw_labels(struct tui *t, const struct axis *axis)
{
	struct limit limit[MOST_LIMITS];
	const struct area *area = &t->layout.strip;
	size_t n = list_goal_limits_of_quantity(t, limit);
	FREED bool *taken = xcalloc((size_t)area->rows, sizeof *taken);
	const struct limit *below = NULL, *above = NULL;
	double step = choose_round_label_step(axis, area->rows);
	for (size_t i = 0; i < n; i++) {
		const struct limit *l = &limit[i];
		int row = response_strip_row_of_value(axis, area, l->value);
		if (l->value < axis->low) {
			below = below == NULL || l->value > below->value
				    ? l
				    : below;
		} else if (l->value > axis->high) {
			above = above == NULL || l->value < above->value
				    ? l
				    : above;
		} else if (!taken[row]) {
			response_strip_draw_limit(t, axis, l, step);
			taken[row] = true;
		}
	}
	if (below != NULL && !taken[area->rows - 1])
		response_strip_draw_limit(t, axis, below, step);
	if (above != NULL && !taken[0])
		response_strip_draw_limit(t, axis, above, step);
	for (double v = ceil(axis->low / step) * step; v <= axis->high;
	     v += step) {
		int row = response_strip_row_of_value(axis, area, v);
		if (!taken[row])
			taken[row] = draw_strip_axis_number(t, row, LOOK_PLAIN,
			    fabs(v) < step / 2 ? 0 : v, step);
	}
}

static void
response_strip_draw_marks(
    const struct tui *t, const struct area *area, const struct axis *axis)
{
	struct track_signs signs = track_signs();
	struct slider_range range = tui_slider_range(t);
	const struct entry *entry = tui_current_site_entry(t);
	int position = tui_slider_position(t);
	double share =
	    (double)(position - range.least) / (range.most - range.least);
	for (size_t r = 0; r < entry->site->n_run; r++) {
		double value = measured_quantity_of_run(t, r);
		if (isnan(value))
			continue;
		screen_draw_text_in_series_colour(area,
		    response_strip_row_of_value(axis, area, value),
		    slider_column_of_position(range,
			slider_position_of_speed(
			    range, entry->site->run[r].speed),
			area->columns),
		    SERIES_TEXT, LOOK_BOLD,
		    track_is_training_run(entry, r) ? signs.trained
						    : signs.held_out);
	}
	double value = response_strip_value_at_share(&t->view.strip, share);
	if (isfinite(value))
		screen_draw_text_in_series_colour(area,
		    response_strip_row_of_value(axis, area, value),
		    slider_column_of_position(range, position, area->columns),
		    SERIES_PREDICTED, LOOK_BOLD,
		    screen_charset() == CHARSET_ASCII ? "@" : "\u25CE");
}

/* Says why there is no curve, but not while it is being computed. */
static void
draw_why_no_curve(const struct tui *t)
{
	const struct area *area = &t->layout.strip;
	const char *why = "";
	if (session_is_calibrating(t->session))
		why = tr("known when the calibration ends");
	else if (!can_compute_response_curve(t))
		why = tr("known after a calibration");
	else if (is_strip_up_to_date(t))
		why = tr("the feed's sieves cannot show it: y chooses another");
	screen_draw_text(area, area->rows / 2, 4, LOOK_DIM, "%s", why);
}

/* Draws the probability of the goal at each speed: in eighths of a cell or,
 * without such characters, as a digit, 9 for 90 % or more. */
static void
draw_goal_chances_by_speed(struct tui *t, const struct area *track)
{
	static const char *const EIGHTH[] = {"\u2581", "\u2582", "\u2583",
	    "\u2584", "\u2585", "\u2586", "\u2587", "\u2588"};
	struct area area = t->layout.certainty;
	const struct slider_range range = tui_slider_range(t);
	const struct goal *g = &t->view.goal;
	if (area.rows == 0 || !goal_is_search_done(t) || g->n_value > 0 ||
	    isnan(g->found->best_certain))
		return;
	hits_add_mouse_handler(&t->hits, HIT_SLIDE, area, track_on_mouse, 0);
	screen_draw_text(&area, 0, 0, LOOK_DIM, "sure");
	area.column = track->column;
	area.columns = track->columns;
	for (int c = 0; c < area.columns; c++) {
		double speed = slider_speed_of_position(
		    range, slider_position_at_column(range, c, area.columns));
		double certain = goal_probability_at(t, speed);
		bool blocks = screen_charset() == CHARSET_BRAILLE;
		if (!(certain > 0))
			continue;
		int parts = blocks ? 8 : 10, part = (int)(certain * parts);
		char digit[2] = {(char)('0' + (part < 10 ? part : 9))};
		screen_draw_text_in_series_colour(&area, 0, c, SERIES_OTHER,
		    LOOK_PLAIN, blocks ? EIGHTH[part < 8 ? part : 7] : digit);
	}
}

void
response_strip_draw(struct tui *t)
{
	struct area area = t->layout.strip,
		    track = layout_track_area(&t->layout);
	const double *speed = t->view.strip.speed;
	struct axis x = {.low = speed[0], .high = speed[STRIP_POINTS - 1]},
		    y = x;
	if (area.rows == 0)
		return;
	area.column = track.column;
	area.columns = track.columns;
	hits_add_mouse_handler(
	    &t->hits, HIT_SLIDE, t->layout.strip, track_on_mouse, 0);
	if (!can_compute_response_curve(t) || !is_strip_up_to_date(t) ||
	    !scale_response_strip_axis(t, &y)) {
		draw_why_no_curve(t);
		return;
	}
	draw_goal_chances_by_speed(t, &track);
	int dots = area.rows * canvas_dot_rows_per_cell(screen_charset());
	widen_axis_by_half_cell(&x, area.columns);
	widen_axis_by_half_cell(&y, dots);
	x.title = xstrdup("");
	y.title = xstrdup("");
	struct chart *chart = chart_new("", "", x, y);
	add_response_strip_band(t, chart, dots);
	response_strip_add_goal_limits(t, chart);
	response_strip_add_curve(t, chart);
	struct canvas *canvas = chart_draw(
	    chart, area.columns, area.rows, screen_charset(), CHART_BARE);
	screen_draw_canvas(&area, canvas);
	response_strip_draw_marks(t, &area, &chart->y);
	if (area.column > 0)
		response_strip_draw_labels(t, &chart->y);
	canvas_free(canvas);
	chart_free(chart);
}
