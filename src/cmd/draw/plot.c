/* plot: a plot as text, as numbers, or as an image file; describe: a plot in
 * sentences, from the same data; screen: a picture of the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plot.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/document/document.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/question.h"
#include "cmd/ask/screened.h"
#include "cmd/run/line.h"
#include "cmd/ask/pin.h"
#include "cmd/session/sites.h"
#include "cmd/lang/table.h"
#include "config.h"
#include "core/psd/rotor_speed.h"
#include "plot/picture.h"
#include "io/sitefile/units.h"

/* Reads site= and beside=: the site or pinned prediction to plot, and the one
 * to show beside it. */
static bool
parse_plotted_sites(const struct session *s, const struct args *args,
    struct plot_request *request, struct error *error)
{
	static const char PINNED[] = "pinned";
	const char *of = args->site, *beside = args->beside;
	bool own = of != NULL && strcmp(of, PINNED) == 0,
	     second = beside != NULL && strcmp(beside, PINNED) == 0;
	if ((own || second) && s->pin == NULL)
		return error_set(error, ERROR_USAGE,
		    "no prediction is pinned\n"
		    "keep one first: pin speed=74");
	request->site = own ? s->pin->key : of;
	request->made = own ? &s->pin->p : NULL;
	request->beside = second ? s->pin->key : beside;
	request->kept = second ? &s->pin->p : NULL;
	return true;
}

#define KIND(kind) (1u << PLOT_##kind)
#define ADDED (1u << 31) /* the speeds that speeds= adds to runs */
#define MACHINE (KIND(PSD) | ADDED | KIND(SWEEP) | KIND(RESPONSE))

/* The kinds of plots that use an option, for those that not all do: its offset
 * in struct args, and a bit for each kind. */
static const struct {
	size_t option;
	unsigned kinds;
} OPTION_KINDS[] = {
    {offsetof(struct args, speed),
	KIND(PSD) | KIND(SELECTION) | KIND(APPEARANCE)},
    {offsetof(struct args, rpm),
	KIND(PSD) | KIND(SELECTION) | KIND(APPEARANCE)},
    {offsetof(struct args, other), KIND(PSD) | KIND(SELECTION)},
    {offsetof(struct args, other_feed), KIND(PSD)},
    {offsetof(struct args, beside), KIND(PSD)},
    {offsetof(struct args, site), ~(KIND(PARITY) | KIND(MAP))},
    {offsetof(struct args, speeds), KIND(RUNS) | KIND(SWEEP) | KIND(RESPONSE)},
    {offsetof(struct args, band), KIND(PSD)},
    {offsetof(struct args, of), KIND(RESPONSE)},
    {offsetof(struct args, limits), KIND(RESPONSE)},
    {offsetof(struct args, generation),
	~(KIND(PARITY) | KIND(MAP) | KIND(RESPONSE) | KIND(PROFILE) |
	    KIND(CORRELATION) | KIND(DRIFT) | KIND(ENERGY))},
    {offsetof(struct args, param), KIND(PROFILE)},
    {offsetof(struct args, at), KIND(PSD)},
    {offsetof(struct args, level), KIND(PSD)},
    {offsetof(struct args, feed),
	KIND(PSD) | ADDED | KIND(SELECTION) | KIND(SWEEP) | KIND(RESPONSE)},
    {offsetof(struct args, rotor_mm),
	MACHINE | KIND(SELECTION) | KIND(APPEARANCE)},
    {offsetof(struct args, cascade), MACHINE},
    {offsetof(struct args, k), MACHINE | KIND(SELECTION)},
    {offsetof(struct args, correction), KIND(PSD) | KIND(SWEEP) |
					    KIND(RESPONSE) | KIND(PROFILE) |
					    KIND(CORRELATION)},
    {offsetof(struct args, cut), KIND(PSD) | KIND(SWEEP) | KIND(RESPONSE)},
};

/* Notes each option of the call that the kind of plot does not use. */
static void
note_unused_options(
    const struct session *s, const struct args *args, enum plot_kind kind)
{
	unsigned kinds = 1u << kind;
	if (kind == PLOT_RUNS && args->speeds.n > 0)
		kinds |= ADDED;
	for (size_t i = 0; i < ARRAY_LEN(OPTION_KINDS); i++) {
		const void *member =
		    (const char *)args + OPTION_KINDS[i].option;
		if ((OPTION_KINDS[i].kinds & kinds) == 0 &&
		    args_is_given(args, member))
			session_print_note(s,
			    "plot %s does not use %s=", args->operand[0],
			    args_option_name(args, member));
	}
}

static bool
parse_plot_request(const struct session *s, const struct args *args,
    struct plot_request *request, struct error *error)
{
	size_t kind;
	if (!text_find_word_in_list(PLOT_KINDS, args->operand[0], &kind))
		return error_set(error, ERROR_USAGE,
		    "there is no plot '%s'\nthe plots are: %s",
		    args->operand[0], PLOT_KINDS);
	note_unused_options(s, args, (enum plot_kind)kind);
	*request = plots_default_request((enum plot_kind)kind);
	request->other_speed = args->other > 0 ? args->other : NAN;
	request->other_feed = args->other_feed;
	request->crosshair_mm = args->at > 0 ? args->at : NAN;
	request->param = args->param;
	request->of = args->of;
	request->limits = args->limits;
	request->level = args->level;
	request->band = args->band;
	request->generation = (size_t)args->generation;
	return parse_plotted_sites(s, args, request, error);
}

/* Reads the question about the site and, into `second`, the same about the site
 * beside.  A speed as feed= names a feed of the first site only.  If a site is
 * not loaded, plots_make_chart sets the error. */
static bool
parse_speed_and_feed_of_plot(struct session *s, const struct args *args,
    struct plot_request *r, struct question *second, struct error *error)
{
	size_t at = s->current, beside;
	if (s->n_entry == 0 ||
	    (r->site != NULL && !session_find_site(s, r->site, &at, NULL)))
		return true;
	struct question *q = &r->asked;
	if (!question_from_args(s, &s->entry[at], args, q, error) ||
	    !screened_check_feed_covers(q, error))
		return false;
	bool one_speed = r->kind == PLOT_PSD || r->kind == PLOT_SELECTION ||
			 r->kind == PLOT_APPEARANCE;
	if (one_speed && r->made == NULL)
		question_use_last_speed(s, q);
	if (r->made != NULL)
		q->speed = r->made->speed;
	else if (!one_speed && !q->speed_given)
		q->speed = NAN;
	if (r->beside == NULL ||
	    !session_find_site(s, r->beside, &beside, NULL))
		return true;
	question_repeat_for_site(s, &s->entry[beside], args, q, second, NULL);
	r->second = second->entry;
	return true;
}

/* Makes the chart of a call of plot or describe; see plots_make_chart.  The
 * caller frees both questions, even if the chart is NULL. */
static struct chart *
make_requested_chart(struct session *s, const struct args *args,
    struct plot_request *request, struct question *second, struct error *error)
{
	*second = (struct question){0};
	*request = (struct plot_request){0};
	return parse_plot_request(s, args, request, error) &&
		       parse_speed_and_feed_of_plot(
			   s, args, request, second, error)
		   ? plots_make_chart(s, request, error)
		   : NULL;
}

/* Returns "passing_pct" for "passing, %".  The caller frees it. */
static char *
json_key_of_axis(const struct axis *axis)
{
	size_t n = strlen(axis->title);
	bool share = n > 0 && axis->title[n - 1] == '%';
	FREED char *words = share
				? xasprintf("%.*spct", (int)n - 1, axis->title)
				: xstrdup(axis->title);
	char *key = text_slug(words);
	for (char *c = key; *c != '\0'; c++)
		*c = *c == '-' ? '_' : *c;
	return key;
}

/* Adds the site of a point and the source of its data; both empty for a line
 * that belongs to no site. */
static void
add_site_cells_of_point(
    struct answer *r, const struct chart_series *series, size_t i)
{
	const struct chart_whose *whose = series->whose;
	bool site = whose != NULL && whose[i].site != NULL;
	answer_add_cells(r, "%s %s", site ? whose[i].site : "",
	    whose != NULL ? whose[i].about : "");
}

static const char *
tick_label_at(const struct axis *axis, double at)
{
	size_t i = 0;
	while (axis->tick[i].at != at)
		i++;
	return axis->tick[i].label;
}

/* Adds a row for each cell of a matrix: the names of its row and column, and
 * its value. */
static void
add_correlation_matrix_rows(struct answer *r, const struct chart *chart)
{
	answer_add_columns(r, "parameter, with, correlation");
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i]->n; j++) {
			const struct chart_series *p = chart->series[i];
			if (!isnan(p->field[j].value))
				answer_add_cells(r, "%s %s %g",
				    tick_label_at(&chart->y, p->y[j]),
				    tick_label_at(&chart->x, p->x[j]),
				    p->field[j].value);
		}
}

/* Adds a row for each point.  several: with its site.  of: title of the
 * vertical axis, for a column of its own, or NULL. */
static void
add_chart_series_rows(struct answer *r, const struct chart_series *p,
    bool several, const char *of)
{
	for (size_t j = 0; j < p->n; j++) {
		if (isnan(p->y[j]))
			continue;
		if (several)
			add_site_cells_of_point(r, p, j);
		answer_add_cells(r, "%s %g", p->name, p->x[j]);
		if (of != NULL)
			answer_add_text_cell(r, "%s", of);
		answer_add_cells(r, "%g %g %g", p->y[j],
		    p->low != NULL ? p->low[j] : NAN,
		    p->low != NULL ? p->high[j] : NAN);
	}
}

/* Returns the next chart below this one, or NULL.  A strip does not count,
 * because its numbers follow from the others. */
static const struct chart *
next_chart_below(const struct chart *chart)
{
	const struct chart *below = chart->below;
	return below != NULL && below->strip > 0 ? NULL : below;
}

/* Returns the numbers of a chart, one row for each point. */
static struct answer *
build_chart_answer(const struct session *s, const struct chart *chart)
{
	struct answer *r = answer_new("plot");
	bool several =
	    chart->n > 0 && chart->series[chart->n - 1]->whose != NULL;
	answer_set_title(r, "%s", chart->title);
	if (several)
		answer_add_columns(r, "site, provenance");
	else
		answer_set_site(r,
		    s->n_entry > 0 ? s->entry[s->current].site->name : "",
		    chart->about);
	if (chart->n > 0 && chart->series[0]->field != NULL) {
		add_correlation_matrix_rows(r, chart);
		return r;
	}
	FREED char *x = json_key_of_axis(&chart->x),
		   *y = json_key_of_axis(&chart->y);
	answer_add_columns(r, "series: series");
	answer_add_column(r, x, chart->x.title);
	if (next_chart_below(chart) == NULL)
		answer_add_column(r, y, chart->y.title);
	else
		answer_add_columns(r, "of, value");
	answer_add_columns(r, "low, high");
	for (const struct chart *c = chart; c != NULL; c = next_chart_below(c))
		for (size_t i = 0; i < c->n; i++)
			add_chart_series_rows(r, c->series[i], several,
			    next_chart_below(chart) != NULL ? c->y.title
							    : NULL);
	return r;
}

/* Returns the number of columns or rows: as asked; else those of the screen,
 * but no more than `most`; else, if there is no screen, `elsewhere`. */
static int
canvas_size_asked_or_fitting(double asked, int screen, int most, int elsewhere)
{
	if (asked > 0)
		return (int)asked;
	return screen <= 0 ? elsewhere : screen < most ? screen : most;
}

/* Returns the character set that charset= chooses; 0 is auto. */
static enum charset
charset_asked(const struct args *args, bool drawing)
{
	return args->charset > 0 ? (enum charset)(args->charset - 1)
	       : drawing         ? CHARSET_BRAILLE
				 : CHARSET_ASCII;
}

static void
print_chart(struct session *s, const struct args *args,
    const struct chart *chart, enum charset charset)
{
	enum { WIDTH = 78, WIDEST = 100, HEIGHT = 24 };
	const struct screen *screen = &s->screen;
	int columns = canvas_size_asked_or_fitting(
	    args->width, screen->columns, WIDEST, WIDTH);
	int strip = chart->below != NULL ? chart->below->strip : 0;
	int most = HEIGHT + strip;
	int rows = canvas_size_asked_or_fitting(
	    args->height, screen->rows - 2, most, most);
	/* Each further chart is as high as a single one. */
	for (const struct chart *c = next_chart_below(chart); c != NULL;
	     c = next_chart_below(c))
		rows += args->height > 0
			    ? 0
			    : canvas_size_asked_or_fitting(
				  0, screen->rows - 2, HEIGHT, HEIGHT);
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, charset, CHART_ALL);
	canvas_print(canvas, screen->colours, s->out);
	canvas_free(canvas);
}

static bool
error_cannot_draw_image(const struct session *s, struct error *error)
{
	return error_set(error, ERROR_SYSTEM,
	    "cannot draw the image %s\n"
	    "try a smaller one, or .svg",
	    s->file);
}

bool
plot_is_image_wanted(const struct session *s)
{
	enum picture_form form;
	return s->document != NULL ||
	       (s->file != NULL && picture_format_of_file_name(s->file, &form));
}

bool
plot_write_image(struct session *s, struct chart *chart, struct error *error)
{
	enum picture_form form;
	if (s->document != NULL) {
		document_add_chart(s->document, chart);
		return true;
	}
	/* Whole points; the usual width comes to PICTURE_WIDTH. */
	double width = round(s->set.figure_mm / 25.4 * 72);
	bool ok = (picture_format_of_file_name(s->file, &form) &&
		      picture_write_chart(chart, form, width,
			  "tipspeed " PACKAGE_VERSION, s->out)) ||
		  error_cannot_draw_image(s, error);
	chart_free(chart);
	return ok;
}

static struct screen_request
build_screen_request(
    const struct session *s, const struct args *args, bool picture)
{
	static const int DEPTHS[] = {0, 256, 16, 8, 0};
	bool drawing = picture || s->screen.drawing;
	return (struct screen_request){.columns = (int)args->width,
	    .rows = (int)args->height,
	    .page = args_is_given(args, &args->page) ? (int)args->page + 1 : 0,
	    .keys = args->keys != NULL ? args->keys : "",
	    .charset_asked = args->charset > 0,
	    .charset = charset_asked(args, drawing),
	    .colours_asked = args->colours > 0,
	    .colours = args->colours > 0 ? DEPTHS[args->colours]
		       : picture         ? 256
					 : s->screen.colours};
}

/* Builds an answer for programs, with a row for each row of the screen. */
static struct answer *
build_screen_answer(const struct canvas *canvas)
{
	FREED char *text = NULL;
	size_t n = 0;
	struct answer *r = answer_new("screen");
	FILE *memory = text_open_memory(&text, &n);
	canvas_print(canvas, 0, memory);
	fclose(memory);
	answer_add_columns(r, "text");
	for (char *line = text; *line != '\0'; line += strlen(line) + 1) {
		line[strcspn(line, "\n")] = '\0';
		answer_add_cells(r, "%s", line);
	}
	return r;
}

static bool
write_screen_image(struct session *s, const struct canvas *canvas, int colours,
    struct error *error)
{
	enum picture_form form;
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	FREED char *label = entry != NULL ? session_site_label(entry->site)
					  : xstrdup(tr("no site loaded"));
	double speed = session_number_in_last_answer(s, "predict", "speed");
	FREED char *rpm = rotor_speed_rpm_text(
	    entry != NULL ? entry->site->rotor : 0, speed, NAN);
	FREED char *title =
	    isfinite(speed)
		? xasprintf(tr("tipspeed, full-screen mode: %s at %.*f m/s%s"),
		      label, units_speed_decimals(speed), speed, rpm)
		: xasprintf(tr("tipspeed, full-screen mode: %s"), label);
	FREED char *from = entry != NULL
			       ? site_provenance_first_clause(entry->site, "")
			       : xstrdup("");
	FREED char *about = xasprintf(
	    from[0] ? tr("A text screen of %d columns and %d rows. Data: %s")
		    : tr("A text screen of %d columns and %d rows.%s"),
	    canvas->columns, canvas->rows, from);
	return (picture_format_of_file_name(s->file, &form) &&
		   picture_write_screen(
		       canvas, colours, form, title, about, s->out)) ||
	       error_cannot_draw_image(s, error);
}

/* Prints one row for a screen reader.  Leaves out characters that repeat three
 * times or more, which only draw lines (but not digits), and rows that contain
 * nothing else. */
static void
print_row_for_screen_reader(
    const struct canvas_cell *cell, int columns, FILE *out)
{
	char *text = xstrdup(""), code[5];
	for (int c = 0, n; c < columns; c += n) {
		uint32_t sign = cell[c].code;
		for (n = 1; c + n < columns && cell[c + n].code == sign; n++)
			;
		bool drawn = n >= 3 && !(sign >= '0' && sign <= '9');
		for (int i = 0; i < n && !drawn && sign != 0; i++)
			xappend(
			    &text, "%s", canvas_encode_code_point(sign, code));
		if (drawn)
			xappend(&text, "  ");
	}
	const char *from = text + strspn(text, " ");
	size_t end = strlen(from);
	while (end > 0 && from[end - 1] == ' ')
		end--;
	if (end > 0)
		fprintf(out, "%.*s\n", (int)end, from);
	free(text);
}

/* Prints the text of the screen row by row, and then describes its plot. */
static bool
print_screen_for_screen_reader(struct session *s, const struct canvas *canvas,
    const char *picture, struct error *error)
{
	for (int row = 0; row < canvas->rows; row++)
		print_row_for_screen_reader(
		    canvas->cell + row * canvas->columns, canvas->columns,
		    s->out);
	if (picture == NULL)
		return true;
	size_t next;
	FREED char *line = xasprintf("describe %s", picture);
	return session_run_line(s, line, 0, "screen", 1, &next, error);
}

bool
cmd_screen(struct session *s, const struct args *args, struct error *error)
{
	bool picture = plot_is_image_wanted(s) && s->document == NULL;
	struct screen_request r = build_screen_request(s, args, picture);
	r.words = s->linear && !picture && s->set.format == ANSWER_TABLE;
	struct canvas *canvas = s->hooks.draw_screen(s, &r, error);
	if (canvas == NULL)
		return false;
	bool ok = true;
	if (picture)
		ok = write_screen_image(s, canvas, r.colours, error);
	else if (r.words)
		ok =
		    print_screen_for_screen_reader(s, canvas, r.picture, error);
	else if (s->set.format == ANSWER_TABLE)
		canvas_print(canvas, r.colours, s->out);
	else
		session_show_answer(s, build_screen_answer(canvas));
	canvas_free(canvas);
	free(r.picture);
	return ok;
}

static void
describe_axes(struct answer *r, const struct chart *c)
{
	const struct axis *axes[] = {&c->x, &c->y};
	static const char *const ways[] = {N_("Across"), N_("Up")};
	for (size_t i = 0; i < ARRAY_LEN(axes); i++) {
		if (axes[i]->names)
			continue;
		answer_note(r,
		    axes[i]->log ? N_("%s: %s, from %.4g to %.4g on a log "
				      "scale")
		    : axes[i]->straight > 0
			? N_("%s: %s, from %.4g to %.4g on a symmetric log "
			     "scale")
			: N_("%s: %s, from %.4g to %.4g"),
		    tr(ways[i]), axes[i]->title, axes[i]->low, axes[i]->high);
	}
}

/* Returns "; P20 1.08 mm, P50 2.81 mm, P80 5.28 mm" for a size distribution,
 * otherwise "". */
static char *
curve_p_sizes_text(const struct chart *c, const struct chart_series *s)
{
	static const double PASSING[] = {20, 50, 80};
	char *text = xstrdup("");
	for (size_t i = 0; s->psd && i < ARRAY_LEN(PASSING); i++) {
		double x = chart_series_x_at_y(c, s, PASSING[i]);
		xappend(&text, "%s P%g ", i > 0 ? "," : ";", PASSING[i]);
		if (isnan(x))
			xappend(&text, tr("outside the sieves"));
		else
			xappend(&text, "%.2f mm", x);
	}
	return text;
}

/* Says where a curve begins and ends, from left to right, without flat parts at
 * its ends. */
static void
describe_curve(
    struct answer *r, const struct chart *c, const struct chart_series *s)
{
	size_t n = s->n;
	bool falls = n > 1 && s->x[0] > s->x[n - 1];
	size_t first = falls ? n - 1 : 0, last = falls ? 0 : n - 1;
	size_t step = falls ? SIZE_MAX : 1;
	while (first != last &&
	       (isnan(s->y[first]) || s->y[first] == s->y[first + step]))
		first += step;
	while (first != last &&
	       (isnan(s->y[last]) || s->y[last] == s->y[last - step]))
		last -= step;
	const char *x = axis_unit_suffix(&c->x), *y = axis_unit_suffix(&c->y);
	FREED char *sizes = curve_p_sizes_text(c, s);
	if (first == last)
		answer_note(
		    r, "%s: %.4g%s throughout", s->name, s->y[first], y);
	else
		answer_note(r,
		    "%s: from %.3g%s at %.3g%s to %.3g%s at %.3g%s%s", s->name,
		    s->y[first], y, s->x[first], x, s->y[last], y, s->x[last],
		    x, sizes);
}

/* Gives the coordinates of the points of a series: of all, or of the first
 * FEW. */
static void
describe_series_points(struct answer *r, const struct chart_series *s)
{
	enum { FEW = 6 };
	size_t shown = 0;
	FREED char *text = xstrdup("");
	for (size_t i = 0; i < s->n && shown < FEW; i++) {
		if (isnan(s->y[i]))
			continue;
		xappend_to_list(
		    &text, ";", tr(" %.3g and %.3g"), s->x[i], s->y[i]);
		shown++;
	}
	answer_note(r,
	    s->n > FEW ? N_("%s, %zu points, across and up:%s and more")
		       : tr_n("%s, %zu point, across and up:%s",
			     "%s, %zu points, across and up:%s", s->n),
	    s->name, s->n, text);
}

/* Says for each parameter where the candidates and the best one lie within its
 * bounds. */
static void
describe_parameter_spread(struct answer *r, const struct chart *c)
{
	const struct chart_series *s = c->series[0];
	const struct chart_series *best = c->series[1];
	for (size_t j = 0; j < best->n; j++) {
		const char *name = c->y.tick[j].label;
		if (isnan(best->x[j]))
			answer_note(r, "%s is held fixed", name);
		else
			answer_note(r,
			    "%s: the middle 80 %% of the candidates from %.0f "
			    "to %.0f %% of its bounds, the best at %.0f %%",
			    name, s->x[3 * j], s->x[3 * j + 1], best->x[j]);
	}
}

/* Names each pair of strongly correlated parameters once. */
static void
describe_strong_correlations(struct answer *r, const struct chart *c)
{
	const double worth_saying = 0.5;
	for (size_t i = 0; i < c->n; i++) {
		const struct chart_series *s = c->series[i];
		FREED char *list = xstrdup("");
		for (size_t j = 0; j < s->n; j++)
			if (fabs(s->field[j].value) >= worth_saying &&
			    s->x[j] + s->y[j] < (double)c->y.n + 1)
				xappend_to_list(&list, ", ", tr("%s and %s %s"),
				    tick_label_at(&c->x, s->x[j]),
				    tick_label_at(&c->y, s->y[j]),
				    s->field[j].label);
		if (list[0] != '\0')
			answer_note(r, "%s: %s", s->name, list);
	}
	answer_note(r, "All other pairs of the %zu parameters are below %g",
	    c->x.n, worth_saying);
}

/* Says where another curve is furthest from the last one, which is drawn on
 * top. */
static void
describe_difference_of_curves(
    struct answer *r, const struct chart *c, const struct chart_series *other)
{
	const struct chart_series *top = c->series[c->n - 1];
	double most = 0, here = 0, there = 0, x = NAN;
	for (size_t i = 0; i < other->n; i++) {
		double y = chart_series_y_at_x(c, top, other->x[i]);
		if (!(fabs(y - other->y[i]) > most))
			continue;
		most = fabs(y - other->y[i]);
		x = other->x[i];
		here = y;
		there = other->y[i];
	}
	if (!isnan(x))
		answer_note(r,
		    "%s and %s differ most at %.3g%s: %.3g and %.3g%s",
		    top->name, other->name, x, axis_unit_suffix(&c->x), here,
		    there, axis_unit_suffix(&c->y));
}

static void
describe_chart_series(struct answer *r, const struct chart *c)
{
	for (size_t i = 0; i < c->n; i++) {
		const struct chart_series *s = c->series[i];
		if (s->line == CHART_MARKS && !s->psd)
			describe_series_points(r, s);
		else if (s->series != SERIES_TEXT)
			describe_curve(r, c, s);
	}
	for (size_t i = 0; i + 1 < c->n && !c->mixed; i++)
		if (c->series[c->n - 1]->line != CHART_MARKS &&
		    c->series[i]->series != SERIES_TEXT)
			describe_difference_of_curves(r, c, c->series[i]);
}

static void
note_largest_differences_in_strip(struct answer *r, const struct chart *c)
{
	for (size_t i = 0; i < c->n; i++) {
		const struct chart_series *s = c->series[i];
		size_t most = 0;
		for (size_t j = 0; j < s->n; j++)
			if (!(fabs(s->y[j]) <= fabs(s->y[most])))
				most = isnan(s->y[j]) ? most : j;
		if (!isnan(s->y[most]))
			answer_note(r, "%s: at most %+.2f points, at %.3g mm",
			    s->name, s->y[most], s->x[most]);
	}
}

/* Names for each run the sieve at which the candidates are furthest apart, and
 * the sieve at which the best candidate errs most. */
static void
describe_search_candidate_bars(struct answer *r, const struct chart *c)
{
	for (size_t i = 0; i + 1 < c->n; i++) {
		const struct chart_series *s = c->series[i];
		const struct chart_series *best = c->series[i + 1];
		size_t wide = 0, off = 0;
		for (size_t j = 0; j < s->n && s->bars; j++) {
			if (s->high[j] - s->low[j] >
			    s->high[wide] - s->low[wide])
				wide = j;
			if (fabs(best->y[j]) > fabs(best->y[off]))
				off = j;
		}
		if (s->bars && s->n > 0)
			answer_note(r,
			    "%s is widest at %.3g mm: from %+.2f to %+.2f "
			    "points; %s is furthest off at %.3g mm: %+.2f "
			    "points",
			    s->name, s->x[wide], s->low[wide], s->high[wide],
			    best->name, best->x[off], best->y[off]);
	}
}

static void
describe_chart(struct answer *r, const struct chart *c)
{
	if (c->strip > 0) {
		note_largest_differences_in_strip(r, c);
		return;
	}
	bool bars = false;
	for (size_t i = 0; i < c->n; i++)
		bars = bars || c->series[i]->bars;
	describe_axes(r, c);
	if (c->n > 0 && c->series[0]->field != NULL)
		describe_strong_correlations(r, c);
	else if (c->y.names)
		describe_parameter_spread(r, c);
	else if (bars)
		describe_search_candidate_bars(r, c);
	else
		describe_chart_series(r, c);
	for (size_t i = 0; i < c->n_rule; i++)
		answer_note(r, "A line from foot to top: %s", c->rule[i].name);
	for (size_t i = 0; i < c->n_note; i++)
		answer_note(r, "%s", c->note[i]);
}

/* For a psd, says at which speeds the session's goal is met with its feed. */
static void
describe_speeds_meeting_goal(
    struct answer *r, struct session *s, const struct plot_request *request)
{
	const struct entry *entry = request->asked.entry;
	struct goal goal = {.n_value = 0};
	if (request->kind != PLOT_PSD || !goals_is_set(s) ||
	    session_is_calibrating(s) || request->site != NULL ||
	    !entry->has_params)
		return;
	const struct site *site = entry->site;
	double speed = isnan(request->asked.speed) ? site_middle_speed(site)
						   : request->asked.speed;
	while (goals_is_search_needed(s, &goal, request->asked.feed) &&
	       !session_is_interrupted(s))
		goals_step_search(s, entry, &goal, request->asked.feed);
	FREED char *words =
	    goals_outcome_text(s, entry, &goal, speed, GOALS_FULL);
	answer_note(r, "%s", words);
	fields_put_values(answer_json_fields(r), "goal %s", words);
	goals_discard_results(&goal);
}

bool
cmd_describe(struct session *s, const struct args *args, struct error *error)
{
	struct plot_request request;
	struct question second;
	struct chart *chart =
	    make_requested_chart(s, args, &request, &second, error);
	bool ok = chart != NULL;
	if (ok) {
		struct answer *r = answer_new("describe");
		answer_set_title(r, "%s", chart->title);
		answer_set_site_names(r,
		    s->n_entry > 0 ? session_current_site_entry(s)->site->name
				   : "",
		    chart->about);
		fields_put_values(answer_json_fields(r),
		    "kind %s title %s data %s", args->operand[0], chart->title,
		    chart->about);
		for (const struct chart *c = chart; c != NULL; c = c->below)
			describe_chart(r, c);
		describe_speeds_meeting_goal(r, s, &request);
		ok = session_show_answer(s, r);
	}
	chart_free(chart);
	question_free(s, &request.asked);
	question_free(s, &second);
	return ok;
}

bool
cmd_plot(struct session *s, const struct args *args, struct error *error)
{
	struct plot_request request;
	struct question second;
	bool grid = s->file == NULL && s->set.format == ANSWER_TABLE;
	if (grid && s->linear && s->screen.columns > 0)
		return cmd_describe(s, args, error);
	struct chart *chart =
	    make_requested_chart(s, args, &request, &second, error);
	question_free(s, &request.asked);
	question_free(s, &second);
	if (chart == NULL)
		return false;
	enum charset charset = charset_asked(args, s->screen.drawing);
	bool image = plot_is_image_wanted(s);
	if (image && (args->width > 0 || args->height > 0))
		session_print_note(s,
		    "width= and height= are those of text; 'set figure_mm 85' "
		    "sets the width of images");
	if (image)
		return plot_write_image(s, chart, error);
	if (s->set.format == ANSWER_TABLE)
		print_chart(s, args, chart, charset);
	else
		session_show_answer(s, build_chart_answer(s, chart));
	chart_free(chart);
	return true;
}
