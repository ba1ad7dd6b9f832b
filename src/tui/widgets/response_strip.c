/* Some speeds at a time are worked out between two keys; a step of the slider
 * moves the mark only.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/response_strip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "tui/acts.h"
#include "tui/widgets/goal.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"

/* Speeds worked out in one go, and how long the slider stands still before
 * that, s. */
enum { POINTS = 41, IN_ONE_GO = 8 };
static const double PAUSE = 0.05;

/* What answers at all speeds follow from: while it is the same, so are they.
 * origin: a share in it. */
struct basis {
	const struct site *site;
	struct origin *origin;
	struct params params;
	struct choices set;
};

/* value [n]: as people see it, with the ends of its band, NAN without one. */
struct strip {
	struct basis basis;
	struct quantity of;
	size_t feed, n;
	double value[POINTS][3];
};

struct strip *
strip_new(void)
{
	return xcalloc(1, sizeof(struct strip));
}

void
strip_free(struct strip *a)
{
	origin_drop(a->basis.origin);
	free(a);
}

void
strip_look(struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	const struct choices *set = &t->session->set;
	struct basis *b = &t->strip->basis;
	if (entry != NULL && entry == session_fitting(t->session))
		t->wish = NULL;
	if (entry != NULL && b->site == entry->site &&
	    b->origin == entry->origin &&
	    memcmp(&b->params, &entry->params, sizeof b->params) == 0 &&
	    settings_same(&b->set, set))
		return;
	origin_drop(b->origin);
	*b = (struct basis){.set = *set};
	if (entry != NULL) {
		b->site = entry->site;
		b->origin = entry->origin;
		b->params = entry->params;
	}
	if (b->origin != NULL)
		b->origin->holders++;
	t->strip->n = 0;
	goals_clear(&t->goal);
	t->wish = NULL;
}

static struct quantity
usual(enum quantity_kind kind, double x, double coarse)
{
	return (struct quantity){.kind = kind,
	    .x = x,
	    .fraction = {.coarse = coarse, .partition = {0, 1}}};
}

struct quantity
strip_usual(void)
{
	return usual(QUANTITY_SIZE, 0.8, 0);
}

static const struct psd *
feed_of(const struct tui *t)
{
	return site_feed(tui_entry(t)->site, tui_feed(t));
}

void
act_quantity(struct tui *t, const struct key *key)
{
	const struct quantity all[] = {strip_usual(),
	    usual(QUANTITY_SIZE, 0.5, 0), usual(QUANTITY_SIZE, 0.2, 0),
	    usual(QUANTITY_PASSING, 4e-3, 0), usual(QUANTITY_PASSING, 2e-3, 0),
	    usual(QUANTITY_PASSING, 0.063e-3, 0),
	    usual(QUANTITY_SHARE, 0, 2e-3), usual(QUANTITY_SHARE, 0, 4e-3)};
	const int n = ARRAY_LEN(all);
	struct error error = {0};
	int by = key->amount, at = by > 0 ? n - 1 : 0;
	if (tui_entry(t) == NULL)
		return;
	for (int i = 0; i < n; i++)
		if (quantity_same(&all[i], &t->ui.quantity))
			at = i;
	do
		at = (at + by + n) % n;
	while (!quantity_same(&all[at], &t->ui.quantity) && at != 0 &&
	       !quantities_covered(&all[at], feed_of(t), &error));
	t->ui.quantity = all[at];
}

/* What a search is still at would be another curve with each generation. */
static bool
has_curve(const struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_entry(t);
	return entry != NULL && entry->has_params &&
	       session_fitting(s) != entry;
}

static bool
is_fresh(const struct tui *t)
{
	const struct strip *a = t->strip;
	return a->n == POINTS && a->feed == tui_feed(t) &&
	       quantity_same(&a->of, &t->ui.quantity);
}

static double
speed_at(const struct tui *t, double share)
{
	struct slider_range range = tui_range(t);
	return (range.least + share * (range.most - range.least)) / 10;
}

/* The forecast is made anew for each part: what it is made of may be gone
 * between two of them. */
static void
work_out(struct tui *t)
{
	struct strip *a = t->strip;
	if (a->feed != tui_feed(t) || !quantity_same(&a->of, &t->ui.quantity))
		a->n = 0;
	a->feed = tui_feed(t);
	a->of = t->ui.quantity;
	const struct question q = {.entry = tui_entry(t), .feed = a->feed};
	struct forecast *f = forecast_open(t->session, &q, &a->of, 1);
	for (int i = 0; i < IN_ONE_GO && a->n < POINTS; i++, a->n++) {
		double *value = a->value[a->n];
		forecast_at(f, speed_at(t, (double)a->n / (POINTS - 1)));
		struct figure at = forecast_figure(f, 0);
		value[0] = quantities_shown(&a->of, at.value);
		value[1] = quantities_shown(&a->of, at.low);
		value[2] = quantities_shown(&a->of, at.high);
	}
	forecast_close(f);
}

bool
strip_point(
    const struct tui *t, size_t i, double *speed, double value[static 3])
{
	if (!is_fresh(t) || i >= POINTS)
		return false;
	*speed = speed_at(t, (double)i / (POINTS - 1));
	memcpy(value, t->strip->value[i], 3 * sizeof *value);
	return true;
}

double
strip_wait(const struct tui *t)
{
	if (!has_curve(t))
		return INFINITY;
	if (is_fresh(t) && !goal_pending(t))
		return t->wish != NULL ? 0 : INFINITY;
	return fmax(0, t->moved + PAUSE - session_clock());
}

/* What the heading has no room for on a narrow screen. */
static void
step_goal(struct tui *t)
{
	bool pending = goal_pending(t);
	goal_step(t);
	if (!pending || goal_pending(t) || t->goal.missed == NULL ||
	    t->message[0] != '\0')
		return;
	char *words = goal_words(t, GOALS_FULL);
	tui_say(t, false, "%s", words);
	free(words);
}

void
strip_update(struct tui *t)
{
	if (!has_curve(t))
		return;
	bool now = t->aside || strip_wait(t) <= 0;
	do
		if (now && !is_fresh(t))
			work_out(t);
		else if (now)
			step_goal(t);
	while (t->aside && (!is_fresh(t) || goal_pending(t)));
}

/* Where it is drawn: cells of the area, with dots [across x down] in each, and
 * the values of its foot and its top. */
struct cells {
	struct area area;
	int across, down;
	enum charset charset;
	double low, high;
	unsigned char *dots, *series; /* [rows * columns] */
};

/* How many dots above the foot. */
static int
level_of(const struct cells *p, double value)
{
	double share = (value - p->low) / (p->high - p->low);
	return (int)lround(share * (p->area.rows * p->down - 1));
}

static bool
has_level(const struct cells *p, double value)
{
	return value >= p->low && value <= p->high;
}

/* The row of the area. */
static int
row_of(const struct cells *p, double value)
{
	return p->area.rows - 1 - level_of(p, value) / p->down;
}

static void
put_dot(struct cells *p, int x, int level, enum series series)
{
	int column = x / p->across, row = p->area.rows - 1 - level / p->down;
	if (column < 0 || column >= p->area.columns || row < 0 ||
	    row >= p->area.rows)
		return;
	int down = p->down - 1 - level % p->down;
	size_t at = (size_t)(row * p->area.columns + column);
	/* Of a curve that falls steeply through a cell the last is shown. */
	if (p->charset == CHARSET_ASCII)
		p->dots[at] = 0;
	p->dots[at] |=
	    (unsigned char)(1U << (p->across * down + x % p->across));
	p->series[at] = (unsigned char)series;
}

/* Its dots, or a character that stands as high. */
static uint32_t
code_of(const struct cells *p, unsigned dots)
{
	if (p->charset != CHARSET_ASCII)
		return canvas_dots_code(p->charset, dots);
	return dots & 1 ? '\'' : dots & 2 ? '-' : '.';
}

/* Where in the track a column of dots is, 0 to 1: the middle of a cell is where
 * the slider stands in it. */
static double
share_of(const struct cells *p, int x)
{
	double column = (x + 0.5) / p->across - 0.5;
	double share = column / fmax(1, p->area.columns - 1);
	return fmin(1, fmax(0, share));
}

static double
value_at(const struct strip *a, double share, size_t which)
{
	double at = share * (POINTS - 1);
	size_t i = at < POINTS - 2 ? (size_t)at : POINTS - 2;
	double part = at - (double)i;
	return (1 - part) * a->value[i][which] + part * a->value[i + 1][which];
}

/* The edges are drawn where they are apart from the curve. */
static void
draw_edges(struct cells *p, const struct strip *a)
{
	for (int x = 0; x < p->area.columns * p->across; x += p->across)
		for (size_t k = 1; k < 3; k++) {
			double share = share_of(p, x);
			double edge = value_at(a, share, k);
			double value = value_at(a, share, 0);
			if (isfinite(edge) && isfinite(value) &&
			    abs(level_of(p, edge) - level_of(p, value)) > 1)
				put_dot(p, x, level_of(p, edge), SERIES_BAND);
		}
}

static void
draw_curve(const struct tui *t, struct cells *p)
{
	const struct strip *a = t->strip;
	const struct entry *entry = tui_entry(t);
	int last = -1;
	for (int x = 0; x < p->area.columns * p->across; x++) {
		double share = share_of(p, x), value = value_at(a, share, 0);
		if (!isfinite(value)) {
			last = -1;
			continue;
		}
		int to = level_of(p, value), from = last < 0 ? to : last;
		last = to;
		bool beyond = answers_extrapolates(entry, speed_at(t, share));
		if (beyond && x / p->across % 2 == 1)
			continue;
		int step = to < from ? -1 : 1;
		from += from != to ? step : 0;
		for (int level = from; level != to + step; level += step)
			put_dot(p, x, level, SERIES_PREDICTED);
	}
}

/* The limits of the goal on the quantity shown, as people see them: what each
 * is called.  Returns how many. */
struct limit {
	double value;
	const char *name;
};
enum { MOST_LIMITS = 8 };

static size_t
take_limits(const struct tui *t, struct limit limit[static MOST_LIMITS])
{
	const struct condition_list *list = &t->goal.list;
	size_t n = 0;
	for (size_t i = 0; i < list->n && n + 2 <= MOST_LIMITS; i++) {
		const struct condition *c = &list->at[i];
		bool value = c->least == c->most;
		if (!quantity_same(&c->quantity, &t->ui.quantity))
			continue;
		if (!isnan(c->least))
			limit[n++] = (struct limit){
			    quantities_shown(&t->ui.quantity, c->least),
			    value ? "goal" : "min"};
		if (!isnan(c->most) && !value)
			limit[n++] = (struct limit){
			    quantities_shown(&t->ui.quantity, c->most), "max"};
	}
	return n;
}

static double
measured_at(const struct tui *t, size_t run)
{
	const struct psd *product = tui_measured(t, run);
	return product->n > 0 ? quantities_shown(&t->ui.quantity,
				    screened_value(product, &t->ui.quantity))
			      : NAN;
}

static void
hold(struct cells *p, double value)
{
	if (!isfinite(value))
		return;
	p->low = fmin(p->low, value);
	p->high = fmax(p->high, value);
}

/* From the least to the most of all that is drawn; of limits those that are not
 * farther off than the curve is high.  False where there is nothing. */
static bool
scale(const struct tui *t, struct cells *p)
{
	struct limit limit[MOST_LIMITS];
	size_t n = take_limits(t, limit);
	p->low = INFINITY;
	p->high = -INFINITY;
	for (size_t i = 0; i < POINTS; i++)
		for (size_t k = 0; k < 3; k++)
			hold(p, t->strip->value[i][k]);
	for (size_t r = 0; r < tui_entry(t)->site->n_run; r++)
		hold(p, measured_at(t, r));
	if (!(p->low <= p->high))
		return false;
	double low = p->low, high = p->high, more = high - low;
	for (size_t i = 0; i < n; i++)
		if (limit[i].value >= low - more &&
		    limit[i].value <= high + more)
			hold(p, limit[i].value);
	if (p->high - p->low < 1e-6 * fabs(p->high) + 1e-9) {
		p->low -= 0.5;
		p->high += 0.5;
	}
	return true;
}

/* In four columns, or not at all: a number cut at its end would be another. */
static void
draw_label(const struct tui *t, int row, unsigned look, double value)
{
	char text[32];
	const struct area *area = &t->layout.strip;
	snprintf(text, sizeof text, "%.6g", value);
	int width = (int)strlen(text);
	if (width <= 4)
		screen_text(
		    area, row, width < 4 ? 3 - width : 0, look, "%s", text);
}

static void
draw_limits(struct tui *t, struct cells *p)
{
	struct limit limit[MOST_LIMITS];
	const struct area *area = &t->layout.strip;
	size_t n = take_limits(t, limit);
	for (size_t i = 0; i < n; i++) {
		if (!has_level(p, limit[i].value))
			continue;
		int level = level_of(p, limit[i].value);
		for (int x = 0; x < p->area.columns * p->across;
		     x += 2 * p->across)
			put_dot(p, x, level, SERIES_OTHER);
	}
	for (size_t i = 0; i < n && p->area.column > 0; i++) {
		if (!has_level(p, limit[i].value))
			continue;
		int row = row_of(p, limit[i].value);
		screen_series(area, row, area->columns - 4, SERIES_OTHER,
		    LOOK_BOLD, limit[i].name);
		hits_add_key(&t->hits,
		    (struct area){area->row + row, area->columns - 4, 1, 4},
		    't', false);
	}
}

/* Round values in rows of their own, with those of the limits; the distance is
 * the least of 1, 2, 5 that leaves each a row. */
static void
draw_labels(const struct tui *t, const struct cells *p)
{
	struct limit limit[MOST_LIMITS];
	size_t n = take_limits(t, limit);
	if (p->area.column == 0)
		return;
	bool *taken = xcalloc((size_t)p->area.rows, sizeof *taken);
	for (size_t i = 0; i < n; i++)
		if (has_level(p, limit[i].value)) {
			int row = row_of(p, limit[i].value);
			draw_label(t, row, LOOK_BOLD, limit[i].value);
			taken[row] = true;
		}
	static const double ROUND[] = {1, 2, 5};
	double span = p->high - p->low, step = 0;
	double ten = pow(10, floor(log10(span / p->area.rows)));
	for (size_t i = 0; i < 6 && (step == 0 || span / step > p->area.rows);
	     i++)
		step = ROUND[i % 3] * ten * (i < 3 ? 1 : 10);
	for (double v = ceil(p->low / step) * step; v <= p->high; v += step) {
		int row = row_of(p, v);
		if (row < 0 || row >= p->area.rows || taken[row])
			continue;
		draw_label(t, row, LOOK_PLAIN, fabs(v) < step / 2 ? 0 : v);
		taken[row] = true;
	}
	free(taken);
}

static void
draw_cells(const struct cells *p)
{
	for (int row = 0; row < p->area.rows; row++)
		for (int c = 0; c < p->area.columns; c++) {
			char text[5];
			size_t at = (size_t)(row * p->area.columns + c);
			if (p->dots[at] == 0)
				continue;
			canvas_utf8(code_of(p, p->dots[at]), text);
			screen_series(&p->area, row, c,
			    (enum series)p->series[at], LOOK_PLAIN, text);
		}
}

static void
draw_marks(const struct tui *t, const struct cells *p)
{
	struct track_signs signs = track_signs();
	struct slider_range range = tui_range(t);
	const struct entry *entry = tui_entry(t);
	double share =
	    (double)(t->ui.tenths - range.least) / (range.most - range.least);
	for (size_t r = 0; r < entry->site->n_run; r++) {
		double value = measured_at(t, r);
		if (isnan(value))
			continue;
		screen_series(&p->area, row_of(p, value),
		    slider_column(range,
			slider_tenths(range, entry->site->run[r].speed),
			p->area.columns),
		    SERIES_TEXT, LOOK_BOLD,
		    track_trained(entry, r) ? signs.trained : signs.held_out);
	}
	double value = value_at(t->strip, share, 0);
	if (isfinite(value))
		screen_series(&p->area, row_of(p, value),
		    slider_column(range, t->ui.tenths, p->area.columns),
		    SERIES_PREDICTED, LOOK_BOLD,
		    p->charset == CHARSET_ASCII ? "O" : "\u25CE");
}

/* In words why there is no curve; nothing while it is being worked out. */
static void
draw_none(const struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	const struct area *area = &t->layout.strip;
	const char *why = "";
	if (entry == NULL)
		return;
	if (session_busy(t->session))
		why = tr("known when the calibration ends");
	else if (!has_curve(t))
		why = tr("known after a calibration");
	else if (is_fresh(t))
		why = tr("the feed's sieves do not tell it: y goes to another");
	screen_text(area, area->rows / 2, 4, LOOK_DIM, "%s", why);
}

void
strip_draw(struct tui *t)
{
	struct area area = t->layout.strip, track = layout_track(&t->layout);
	enum { ASCII_DOWN = 3 };
	enum charset charset = screen_charset();
	struct cells p = {.area = area,
	    .charset = charset,
	    .across = canvas_dots_across(charset),
	    .down = charset == CHARSET_ASCII ? ASCII_DOWN
					     : canvas_dots_down(charset)};
	if (area.rows == 0)
		return;
	p.area.column = track.column;
	p.area.columns = track.columns;
	hits_add(&t->hits, area, track_touch, 0);
	if (!has_curve(t) || !is_fresh(t) || !scale(t, &p)) {
		draw_none(t);
		return;
	}
	size_t cells = (size_t)(p.area.rows * p.area.columns);
	p.dots = xcalloc(cells, 1);
	p.series = xcalloc(cells, 1);
	draw_edges(&p, t->strip);
	draw_limits(t, &p);
	draw_curve(t, &p);
	draw_cells(&p);
	draw_labels(t, &p);
	draw_marks(t, &p);
	free(p.dots);
	free(p.series);
}
