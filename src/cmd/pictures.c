/* plot: a picture as text, its numbers, or a file for a paper.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/pictures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "config.h"
#include "plot/picture.h"

/* Index of a word in a list with blanks between; false where it has none such.
 */
static bool
find_word(const char *list, const char *word, size_t *index)
{
	size_t n = strlen(word);
	*index = 0;
	while (*list != '\0') {
		size_t m = strcspn(list, " ");
		if (n == m && strncmp(list, word, n) == 0)
			return true;
		list += m;
		list += strspn(list, " ");
		(*index)++;
	}
	return false;
}

bool
pictures_request(const struct command *self, const struct args *args,
    struct plot_request *request, struct error *error)
{
	size_t kind;
	if (!find_word(PLOT_KINDS, args->operand[0], &kind)) {
		error_set(error, ERROR_USAGE, "there is no plot '%s'",
		    args->operand[0]);
		return error_hint(error, "the plots are: %s", PLOT_KINDS);
	}
	*request = plots_request((enum plot_kind)kind);
	const struct value *speed = args_value(self, args, "speed");
	const struct value *other = args_value(self, args, "other");
	const struct value *at = args_value(self, args, "at");
	const struct value *beside = args_value(self, args, "beside");
	const struct value *speeds = args_value(self, args, "speeds");
	if (speed->given)
		request->speed = speed->number;
	if (other->given)
		request->other_speed = other->number;
	if (at->given)
		request->crosshair_mm = at->number;
	if (beside->given)
		request->beside = beside->text;
	request->level = args_value(self, args, "level")->number;
	request->band = args_value(self, args, "band")->choice == 1;
	request->n_speed = speeds->n;
	request->speeds = speeds->list;
	return true;
}

struct report *
pictures_report(
    const struct session *s, const char *command, const struct chart *chart)
{
	struct report *r = report_new(command);
	const char *name = "";
	if (s->n_entry > 0)
		name = s->entry[s->current].site->name;
	report_title(r, "%s", chart->title);
	report_site(r, name, chart->about);
	return r;
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
static struct report *
chart_report(const struct session *s, const struct chart *chart)
{
	struct report *r = pictures_report(s, "plot", chart);
	char *x = key_of(&chart->x), *y = key_of(&chart->y);
	report_column(r, "series", "series");
	report_column(r, x, chart->x.title);
	report_column(r, y, chart->y.title);
	report_column(r, "low", "low");
	report_column(r, "high", "high");
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i].n; j++) {
			const struct chart_series *p = &chart->series[i];
			if (isnan(p->y[j]))
				continue;
			report_text(r, p->name);
			report_number(r, p->x[j], -1);
			report_number(r, p->y[j], -1);
			report_number(r, p->low != NULL ? p->low[j] : NAN, -1);
			report_number(r, p->low != NULL ? p->high[j] : NAN, -1);
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
	const struct command *self = command_find("plot");
	const struct screen *screen = &s->screen;
	int columns = size_of(
	    args_value(self, args, "width"), screen->columns, WIDEST, WIDTH);
	int rows = size_of(
	    args_value(self, args, "height"), screen->rows - 2, HEIGHT, HEIGHT);
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, charset, CHART_ALL);
	canvas_print(canvas, screen->colours, s->out);
	canvas_free(canvas);
}

static bool
write_picture(struct session *s, const struct chart *chart,
    enum picture_form form, struct error *error)
{
	if (picture_write(chart, form, "tipspeed " PACKAGE_VERSION, s->out))
		return true;
	return error_set(
	    error, ERROR_SYSTEM, "the picture %s cannot be drawn", s->file);
}

bool
cmd_plot(struct session *s, const struct args *args, struct error *error)
{
	enum { AUTO };
	const struct command *self = command_find("plot");
	struct plot_request request;
	if (!pictures_request(self, args, &request, error))
		return false;
	struct chart *chart = plots_chart(s, &request, error);
	if (chart == NULL)
		return false;
	size_t choice = args_value(self, args, "charset")->choice;
	enum charset charset = choice != AUTO      ? (enum charset)(choice - 1)
			       : s->screen.drawing ? CHARSET_BRAILLE
						   : CHARSET_ASCII;
	enum picture_form form;
	bool ok = true;
	if (s->file != NULL && picture_form_of(s->file, &form))
		ok = write_picture(s, chart, form, error);
	else if (s->format == REPORT_TABLE)
		print_chart(s, args, chart, charset);
	else
		session_report(s, chart_report(s, chart));
	chart_free(chart);
	return ok;
}
