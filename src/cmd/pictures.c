/* plot: a picture as text, its numbers, or a file for a paper.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/pictures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/table.h"
#include "config.h"
#include "plot/picture.h"

static bool
read_request(const struct session *s, const struct args *args,
    struct plot_request *request, struct error *error)
{
	size_t kind;
	if (!text_choice(PLOT_KINDS, args->operand[0], &kind))
		return error_set(error, ERROR_USAGE,
		    "there is no plot '%s'\nthe plots are: %s",
		    args->operand[0], PLOT_KINDS);
	*request = plots_request((enum plot_kind)kind);
	const struct value *speed = args_value(args, "speed");
	const struct value *other = args_value(args, "other");
	const struct value *at = args_value(args, "at");
	const struct value *beside = args_value(args, "beside");
	const struct value *speeds = args_value(args, "speeds");
	if (speed->given)
		request->speed = speed->number;
	if (other->given)
		request->other_speed = other->number;
	if (at->given)
		request->crosshair_mm = at->number;
	if (beside->given)
		request->beside = beside->text;
	if (args_value(args, "feed")->given && s->n_entry > 0) {
		const struct site *site = s->entry[s->current].site;
		size_t run;
		if (!answers_feed(site, args, 0, &run, error))
			return false;
		request->feed_speed = site->run[run].speed;
	}
	request->level = args_value(args, "level")->number;
	request->band = args_value(args, "band")->choice == 1;
	request->n_speed = speeds->n;
	request->speeds = speeds->list;
	return true;
}

struct chart *
pictures_chart(struct session *s, const struct args *args,
    struct plot_request *request, struct error *error)
{
	return read_request(s, args, request, error)
		   ? plots_chart(s, request, error)
		   : NULL;
}

/* "passing_pct" of "passing, %".  The caller frees. */
static char *
key_of(const struct axis *axis)
{
	size_t n = strlen(axis->title);
	bool share = n > 0 && axis->title[n - 1] == '%';
	char *words = share ? xasprintf("%.*spct", (int)n - 1, axis->title)
			    : xstrdup(axis->title);
	char *key = text_slug(words);
	free(words);
	for (n = strlen(key); n > 0 && key[n - 1] == '-'; n--)
		key[n - 1] = '\0';
	for (char *c = key; *c != '\0'; c++)
		*c = *c == '-' ? '_' : *c;
	return key;
}

/* The numbers of a chart: one row a point. */
static struct answer *
chart_answer(const struct session *s, const struct chart *chart)
{
	struct answer *r = answer_new("plot");
	answer_title(r, "%s", chart->title);
	answer_site(r, s->n_entry > 0 ? s->entry[s->current].site->name : "",
	    chart->about);
	char *x = key_of(&chart->x), *y = key_of(&chart->y);
	answer_columns(r, "series");
	answer_column(r, x, chart->x.title);
	answer_column(r, y, chart->y.title);
	answer_columns(r, "low, high");
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i].n; j++) {
			const struct chart_series *p = &chart->series[i];
			if (isnan(p->y[j]))
				continue;
			answer_cells(r, "%s %g %g %g %g", p->name, p->x[j],
			    p->y[j], p->low != NULL ? p->low[j] : NAN,
			    p->low != NULL ? p->high[j] : NAN);
		}
	free(x);
	free(y);
	return r;
}

/* The size asked for, or one that fits the screen with the prompt. */
static int
size_of(const struct value *asked, int screen, int most, int elsewhere)
{
	if (asked->given)
		return (int)asked->number;
	return screen <= 0 ? elsewhere : screen < most ? screen : most;
}

static void
print_chart(struct session *s, const struct args *args,
    const struct chart *chart, enum charset charset)
{
	enum { WIDTH = 78, WIDEST = 100, HEIGHT = 24 };
	const struct screen *screen = &s->screen;
	int columns =
	    size_of(args_value(args, "width"), screen->columns, WIDEST, WIDTH);
	int rows = size_of(
	    args_value(args, "height"), screen->rows - 2, HEIGHT, HEIGHT);
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, charset, CHART_ALL);
	canvas_print(canvas, screen->colours, s->out);
	canvas_free(canvas);
}

static bool
cannot_draw(const struct session *s, struct error *error)
{
	return error_set(error, ERROR_SYSTEM,
	    "cannot draw the image %s\n"
	    "try a smaller one, or .svg",
	    s->file);
}

bool
pictures_wanted(const struct session *s)
{
	enum picture_form form;
	return s->file != NULL && picture_form_of(s->file, &form);
}

bool
pictures_draw(struct session *s, const struct chart *chart, struct error *error)
{
	enum picture_form form;
	return (picture_form_of(s->file, &form) &&
		   picture_write(
		       chart, form, "tipspeed " PACKAGE_VERSION, s->out)) ||
	       cannot_draw(s, error);
}

static struct screen_request
screen_request(const struct session *s, const struct args *args, bool picture)
{
	static const int DEPTHS[] = {0, 256, 16, 8, 0};
	const struct value *page = args_value(args, "page");
	const struct value *keys = args_value(args, "keys");
	size_t charset = args_value(args, "charset")->choice;
	size_t colours = args_value(args, "colours")->choice;
	bool drawing = picture || s->screen.drawing;
	return (struct screen_request){
	    .columns = (int)args_value(args, "width")->number,
	    .rows = (int)args_value(args, "height")->number,
	    .page = page->given ? (int)page->choice + 1 : 0,
	    .keys = keys->given ? keys->text : "",
	    .charset_asked = charset > 0,
	    .charset = charset > 0 ? (enum charset)(charset - 1)
		       : drawing   ? CHARSET_BRAILLE
				   : CHARSET_ASCII,
	    .colours_asked = colours > 0,
	    .colours = colours > 0 ? DEPTHS[colours]
		       : picture   ? 256
				   : s->screen.colours};
}

/* The rows of a screen, for who reads them by a program. */
static struct answer *
screen_answer(const struct canvas *canvas)
{
	char *text = NULL;
	size_t n = 0;
	struct answer *r = answer_new("screen");
	FILE *memory = text_memory(&text, &n);
	canvas_print(canvas, 0, memory);
	fclose(memory);
	answer_columns(r, "text");
	for (char *line = text; *line != '\0'; line += strlen(line) + 1) {
		line[strcspn(line, "\n")] = '\0';
		answer_cells(r, "%s", line);
	}
	free(text);
	return r;
}

static bool
write_screen(struct session *s, const struct canvas *canvas, int colours,
    enum picture_form form, struct error *error)
{
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	char *label = entry != NULL ? session_label(entry->site)
				    : xstrdup("no site loaded");
	double speed = session_known(s, "predict", "speed");
	char *title =
	    isfinite(speed)
		? xasprintf("tipspeed, full-screen mode: %s at %.1f m/s", label,
		      speed)
		: xasprintf("tipspeed, full-screen mode: %s", label);
	char *from = entry != NULL ? site_source(entry->site, "") : xstrdup("");
	char *about = xasprintf("A text screen of %d columns and %d rows.%s%s",
	    canvas->columns, canvas->rows, from[0] ? " Data: " : "", from);
	bool ok = picture_cells(canvas, colours, form, title, about, s->out) ||
		  cannot_draw(s, error);
	free(about);
	free(from);
	free(title);
	free(label);
	return ok;
}

bool
cmd_screen(struct session *s, const struct args *args, struct error *error)
{
	enum picture_form form;
	bool picture = s->file != NULL && picture_form_of(s->file, &form);
	if (s->draw_screen == NULL)
		return error_set(error, ERROR_SYSTEM,
		    "full-screen mode is not available here");
	struct screen_request r = screen_request(s, args, picture);
	struct canvas *canvas = s->draw_screen(s, &r, error);
	if (canvas == NULL)
		return false;
	bool ok = true;
	if (picture)
		ok = write_screen(s, canvas, r.colours, form, error);
	else if (s->set.format == ANSWER_TABLE)
		canvas_print(canvas, r.colours, s->out);
	else
		session_answer(s, screen_answer(canvas));
	canvas_free(canvas);
	return ok;
}

bool
cmd_plot(struct session *s, const struct args *args, struct error *error)
{
	enum { AUTO };
	struct plot_request request;
	bool grid = s->file == NULL && s->set.format == ANSWER_TABLE;
	if (grid && s->linear && s->screen.columns > 0)
		return cmd_describe(s, args, error);
	struct chart *chart = pictures_chart(s, args, &request, error);
	if (chart == NULL)
		return false;
	size_t choice = args_value(args, "charset")->choice;
	enum charset charset = choice != AUTO      ? (enum charset)(choice - 1)
			       : s->screen.drawing ? CHARSET_BRAILLE
						   : CHARSET_ASCII;
	bool ok = true;
	if (pictures_wanted(s))
		ok = pictures_draw(s, chart, error);
	else if (s->set.format == ANSWER_TABLE)
		print_chart(s, args, chart, charset);
	else
		session_answer(s, chart_answer(s, chart));
	chart_free(chart);
	return ok;
}
