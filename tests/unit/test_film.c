/* A recording plays what was recorded: the SVG is read by a parser, and at each
 * frame's time what it shows is compared with the frame.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <expat.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "plot/film.h"

enum { COLUMNS = 30, ROWS = 5, FRAMES = 12 };

/* Frames that change here and there, from a generator of their own. */
static struct film
some_film(void)
{
	struct film film = {0};
	uint32_t seed = 7;
	struct canvas *c = canvas_new(COLUMNS, ROWS);
	for (int f = 0; f < FRAMES; f++) {
		for (int i = 0; i < 40; i++) {
			seed = seed * 1664525U + 1013904223U;
			uint32_t cell = (seed >> 8) % (COLUMNS * ROWS);
			uint32_t code = (seed >> 20) % 12;
			c->cell[cell].code = code < 10 ? '0' + code : ' ';
			c->cell[cell].series = (unsigned char)(seed >> 30);
		}
		film_add(&film, c, 100);
	}
	canvas_free(c);
	return film;
}

static char *
written(const struct film *film)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_memory(&text, &n);
	assert_true(film_write(film, 256, "a <film>", "of cells", out));
	fclose(out);
	return text;
}

/* A reader of what film_write writes.  At `percent` of a round the letters
 * shown stand in cell; times: what its style says of each group. */
struct reader {
	double percent;
	char cell[ROWS][COLUMNS + 1];
	bool in_text, shown, still;
	const char *style;
	char letters[400];
	size_t n;
	double x[400];
	int n_x;
	double y;
};

static const char *
attribute(const char **list, const char *name)
{
	for (; *list != NULL; list += 2)
		if (strcmp(*list, name) == 0)
			return list[1];
	return NULL;
}

/* Whether the style shows a group at that time: keyframes hold until the
 * next. */
static bool
is_shown(const struct reader *r, const char *id)
{
	char name[40], rule[200] = "";
	double a = 0, b = 0;
	snprintf(name, sizeof name, "@keyframes %s{", id);
	const char *at = strstr(r->style, name);
	assert_non_null(at);
	snprintf(rule, sizeof rule, "%.*s", (int)strcspn(at, "\n"),
	    at + strlen(name));
	if (sscanf(rule, "0%%,%lf%%{visibility:hidden}%lf%%", &a, &b) == 2)
		return r->percent >= b && r->percent < a;
	if (sscanf(rule, "0%%{visibility:visible}%lf%%", &a) == 1)
		return r->percent < a;
	assert_int_equal(sscanf(rule, "0%%{visibility:hidden}%lf%%", &a), 1);
	return r->percent >= a;
}

static void
begin(void *of, const char *name, const char **list)
{
	struct reader *r = of;
	if (strcmp(name, "g") == 0) {
		const char *id = attribute(list, "id");
		bool hidden = attribute(list, "visibility") != NULL;
		r->shown = id == NULL ? true
			   : r->still ? !hidden
				      : is_shown(r, id);
	}
	if (strcmp(name, "text") != 0)
		return;
	r->in_text = true;
	r->n = 0;
	r->n_x = 0;
	r->y = atof(attribute(list, "y"));
	const char *x = attribute(list, "x"), *length;
	for (char *end; *x != '\0'; x = end)
		r->x[r->n_x++] = strtod(x, &end);
	length = attribute(list, "textLength");
	for (int i = 1; length != NULL && i < atoi(length) / 8; i++)
		r->x[r->n_x++] = r->x[0] + 8 * i;
}

static void
take(void *of, const char *text, int n)
{
	struct reader *r = of;
	if (!r->in_text)
		return;
	memcpy(r->letters + r->n, text, (size_t)n);
	r->n += (size_t)n;
}

static void
end(void *of, const char *name)
{
	struct reader *r = of;
	if (strcmp(name, "text") != 0)
		return;
	r->in_text = false;
	assert_int_equal(r->n, r->n_x);
	for (size_t i = 0; i < r->n && r->shown; i++) {
		int column = (int)((r->x[i] - 9) / 8);
		int row = (int)((r->y - 20) / 16);
		if (r->letters[i] == ' ')
			continue; /* between two words */
		assert_in_range(column, 0, COLUMNS - 1);
		assert_in_range(row, 0, ROWS - 1);
		/* Nothing is painted over. */
		assert_int_equal(r->cell[row][column], ' ');
		r->cell[row][column] = r->letters[i];
	}
}

static void
read_at(struct reader *r, const char *svg, double percent, bool still)
{
	XML_Parser parser = XML_ParserCreate(NULL);
	*r = (struct reader){.percent = percent, .still = still, .style = svg};
	memset(r->cell, ' ', sizeof r->cell);
	XML_SetUserData(parser, r);
	XML_SetElementHandler(parser, begin, end);
	XML_SetCharacterDataHandler(parser, take);
	assert_int_equal(
	    XML_Parse(parser, svg, (int)strlen(svg), 1), XML_STATUS_OK);
	XML_ParserFree(parser);
}

static void
expect(const struct reader *r, const struct canvas *frame)
{
	for (int row = 0; row < ROWS; row++)
		for (int c = 0; c < COLUMNS; c++)
			assert_int_equal(r->cell[row][c],
			    frame->cell[row * COLUMNS + c].code);
}

static void
each_frame_is_shown_at_its_time(void **state)
{
	(void)state;
	struct film film = some_film();
	char *svg = written(&film);
	struct reader *r = xcalloc(1, sizeof *r);
	assert_int_equal(film.n, FRAMES);
	for (size_t f = 0; f < film.n; f++) {
		read_at(r, svg, 100.0 * ((double)f + 0.5) / FRAMES, false);
		expect(r, film.canvas[f]);
	}
	/* Without motion the last one. */
	read_at(r, svg, 0, true);
	expect(r, film.canvas[film.n - 1]);
	assert_non_null(strstr(svg, "prefers-reduced-motion:no-preference"));
	free(r);
	free(svg);
	film_free(&film);
}

static void
the_same_frames_are_the_same_bytes(void **state)
{
	(void)state;
	struct film film = some_film();
	char *a = written(&film), *b = written(&film);
	assert_string_equal(a, b);
	free(a);
	free(b);
	film_free(&film);
}

static void
a_frame_like_the_last_makes_it_longer(void **state)
{
	(void)state;
	struct film film = {0};
	struct canvas *c = canvas_new(4, 2);
	film_add(&film, c, 100);
	film_add(&film, c, 250);
	assert_int_equal(film.n, 1);
	assert_int_equal(film.ms[0], 350);
	char *svg = written(&film);
	assert_null(strstr(svg, "@keyframes"));
	free(svg);
	canvas_free(c);
	film_free(&film);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_frame_is_shown_at_its_time),
	    cmocka_unit_test(the_same_frames_are_the_same_bytes),
	    cmocka_unit_test(a_frame_like_the_last_makes_it_longer),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
