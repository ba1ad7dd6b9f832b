/* Writes answers as a workbook with libxlsxwriter, to an unnamed temporary
 * file, because that library can write only files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/book.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <xlsxwriter.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/number.h"
#include "io/cells/xml.h"

/* Numbers with up to DECIMALS - 1 decimals have a format of their own. */
enum { DECIMALS = 5 };

struct book {
	lxw_workbook *workbook;
	int fd; /* the file that it is written to */
	lxw_format *title, *head, *remark, *warning, *light[3];
	lxw_format *number[DECIMALS];
	size_t sheets;
	bool has_site;
	size_t n_about;
	char **about; /* [2 n_about] keys and values in turn */
};

/* Opens a temporary file without a name.  Returns -1 on failure. */
static int
open_temporary_file(const char *folder)
{
	FREED char *path = xasprintf("%s/tipspeed-XXXXXX", folder);
	int fd = mkstemp(path);
	if (fd >= 0)
		unlink(path);
	return fd;
}

static lxw_format *
add_cell_format(struct book *b, bool bold, int colour, int fill)
{
	lxw_format *f = workbook_add_format(b->workbook);
	if (bold)
		format_set_bold(f);
	if (colour != 0)
		format_set_font_color(f, (lxw_color_t)colour);
	if (fill != 0)
		format_set_bg_color(f, (lxw_color_t)fill);
	return f;
}

static void
add_all_cell_formats(struct book *b)
{
	b->title = add_cell_format(b, true, 0, 0);
	format_set_font_size(b->title, 13);
	b->head = add_cell_format(b, true, 0, 0xE8E8E8);
	format_set_bottom(b->head, LXW_BORDER_THIN);
	format_set_text_wrap(b->head);
	format_set_align(b->head, LXW_ALIGN_VERTICAL_TOP);
	b->remark = add_cell_format(b, false, 0x606060, 0);
	b->warning = add_cell_format(b, true, 0xB00000, 0);
	b->light[0] = add_cell_format(b, true, 0, 0xC6EFCE);
	b->light[1] = add_cell_format(b, true, 0, 0xFFEB9C);
	b->light[2] = add_cell_format(b, true, 0, 0xFFC7CE);
	for (int i = 0; i < DECIMALS; i++) {
		char code[16];
		b->number[i] = add_cell_format(b, false, 0, 0);
		snprintf(code, sizeof code, "0%s%.*s", i > 0 ? "." : "", i,
		    "00000000");
		format_set_num_format(b->number[i], code);
	}
}

struct book *
book_new(struct error *error)
{
	const char *set = getenv("TMPDIR");
	FREED char *folder =
	    xstrdup(set != NULL && set[0] != '\0' ? set : "/tmp");
	int fd = open_temporary_file(folder);
	if (fd < 0) {
		error_set(error, ERROR_SYSTEM,
		    "cannot make a temporary file: %s\n"
		    "set TMPDIR to a folder with free space",
		    strerror(errno));
		return NULL;
	}
	struct book *b = xcalloc(1, sizeof *b);
	FREED char *path = xasprintf("/dev/fd/%d", fd);
	lxw_workbook_options options = {.tmpdir = folder};
	/* 2000-01-01 instead of now, so that the same results give the same
	 * bytes. */
	lxw_doc_properties properties = {.created = 946684800};
	b->fd = fd;
	b->workbook = workbook_new_opt(path, &options);
	workbook_set_properties(b->workbook, &properties);
	add_all_cell_formats(b);
	return b;
}

static void
close_and_free_book(struct book *b)
{
	for (size_t i = 0; i < 2 * b->n_about; i++)
		free(b->about[i]);
	free(b->about);
	close(b->fd);
	free(b);
}

void
book_free(struct book *b)
{
	if (b == NULL)
		return;
	lxw_workbook_free(b->workbook);
	close_and_free_book(b);
}

/* A sheet on which rows are written from the top. */
struct page {
	lxw_worksheet *sheet;
	const char *name;
	lxw_row_t row;
};

static struct page
book_add_worksheet(struct book *b, const char *name)
{
	char tab[32];
	snprintf(tab, sizeof tab, "%.20s", name);
	if (b->sheets++ > 0)
		snprintf(tab, sizeof tab, "%.20s %zu", name, b->sheets);
	struct page page = {.sheet = workbook_add_worksheet(b->workbook, tab)};
	page.name = page.sheet->name;
	return page;
}

/* Writes a text as a text, even if it begins with =. */
static void
book_put_text(const struct page *p, lxw_col_t column, const char *text,
    lxw_format *format)
{
	enum { MOST = 32000 }; /* bytes; Excel allows 32,767 characters */
	FREED char *shown = text_with_control_escaped(text);
	shown[text_bytes_up_to_limit(shown, MOST)] = '\0';
	if (shown[0] != '\0')
		worksheet_write_string(p->sheet, p->row, column, shown, format);
}

/* Returns the number in a cell, or the size if it is a sieve in a column of
 * them, where there are also rows such as "P80 mm"; NAN if it is neither. */
static double
book_number_of_cell(const char *head, const struct answer_cell *cell)
{
	double value = cell->number;
	if (cell->is_text && strncmp(head, "sieve", 5) == 0)
		text_parse_number(cell->text, &value);
	return value;
}

static void
book_put_cell(struct book *b, const struct page *p, lxw_col_t column,
    const char *head, const struct answer_cell *cell)
{
	double value = book_number_of_cell(head, cell);
	char text[32];
	bool fixed = cell->decimals >= 0 && cell->decimals < DECIMALS;
	/* As in csv: 93.6, not 93.59999999999999. */
	if (!cell->is_text && isfinite(value))
		text_parse_number(
		    text_shortest_exact_number(value, text), &value);
	if (isfinite(value))
		worksheet_write_number(p->sheet, p->row, column, value,
		    fixed ? b->number[cell->decimals] : NULL);
	else if (strcmp(cell->text, "-") != 0)
		book_put_text(p, column, cell->text, NULL);
}

/* Makes a column as wide as its longest cell or heading, within limits. */
static void
set_column_width_to_text(
    const struct page *p, const struct answer_view *v, lxw_col_t column)
{
	enum { LEAST = 9, MOST = 60 };
	int width = text_width_in_columns(v->head[column]);
	for (size_t i = 0; i < v->n_row; i++) {
		int w = text_width_in_columns(
		    v->cell[i * v->n_column + column].text);
		width = w > width ? w : width;
	}
	width = width < LEAST ? LEAST : width > MOST ? MOST : width;
	worksheet_set_column(p->sheet, column, column, (double)width + 2, NULL);
}

static size_t
count_sieve_rows(const struct answer_view *v)
{
	size_t n = 0;
	if (v->n_column < 2 || strncmp(v->head[0], "sieve", 5) != 0)
		return 0;
	for (; n < v->n_row; n++) {
		const struct answer_cell *cell = &v->cell[n * v->n_column];
		double mm = book_number_of_cell(v->head[0], cell);
		if (isnan(mm) || (!cell->is_text && !(mm > 0)))
			break;
	}
	return n;
}

/* True if a column is a curve: its numbers are from 0 to 100, and its heading
 * does not say that they are differences or the like. */
static bool
is_answer_column_a_curve(
    const struct answer_view *v, size_t rows, size_t column)
{
	static const char *const OTHERS[] = {
	    "differ", "error", "outside", "points", "sd", "share"};
	size_t n = 0;
	for (size_t i = 0; i < ARRAY_LEN(OTHERS); i++)
		if (strstr(v->head[column], OTHERS[i]) != NULL)
			return false;
	for (size_t i = 0; i < rows; i++) {
		double y = v->cell[i * v->n_column + column].number;
		if (y < 0 || y > 100)
			return false;
		n += isfinite(y) ? 1 : 0;
	}
	return n > 1;
}

/* Sets the axis of sizes to the powers of ten around the sieves. */
static void
set_size_axis(lxw_chart *chart, const struct answer_view *v, size_t rows)
{
	double least = INFINITY, most = 0;
	for (size_t i = 0; i < rows; i++) {
		double mm =
		    book_number_of_cell(v->head[0], &v->cell[i * v->n_column]);
		least = fmin(least, mm);
		most = fmax(most, mm);
	}
	if (!(least > 0 && most > 0))
		return;
	double from = pow(10, floor(log10(least)));
	chart_axis_set_log_base(chart->x_axis, 10);
	chart_axis_set_min(chart->x_axis, from);
	chart_axis_set_max(chart->x_axis, pow(10, ceil(log10(most))));
	chart_axis_set_crossing(chart->x_axis, from);
}

/* Draws passing over sieve size beside the table that begins at the page's
 * row. */
static void
book_add_chart(
    struct book *b, const struct page *p, const struct answer_view *v)
{
	size_t rows = count_sieve_rows(v), curves = 0;
	lxw_row_t from = p->row + 1, to = p->row + (lxw_row_t)rows;
	for (size_t c = 1; rows > 1 && c < v->n_column; c++)
		curves += is_answer_column_a_curve(v, rows, c);
	if (curves == 0)
		return;
	lxw_chart *chart = workbook_add_chart(
	    b->workbook, LXW_CHART_SCATTER_STRAIGHT_WITH_MARKERS);
	for (size_t c = 1; c < v->n_column; c++) {
		if (!is_answer_column_a_curve(v, rows, c))
			continue;
		lxw_chart_series *series = chart_add_series(chart, NULL, NULL);
		FREED char *name = text_with_control_escaped(v->head[c]);
		chart_series_set_categories(series, p->name, from, 0, to, 0);
		chart_series_set_values(
		    series, p->name, from, (lxw_col_t)c, to, (lxw_col_t)c);
		chart_series_set_name(series, name);
	}
	chart_axis_set_name(chart->x_axis, "sieve, mm");
	chart_axis_set_name(chart->y_axis, "passing, %");
	chart_axis_set_min(chart->y_axis, 0);
	chart_axis_set_max(chart->y_axis, 100);
	chart_axis_major_gridlines_set_visible(chart->x_axis, LXW_TRUE);
	set_size_axis(chart, v, rows);
	lxw_chart_options options = {.x_scale = 1.4, .y_scale = 1.3};
	worksheet_insert_chart_opt(
	    p->sheet, p->row, (lxw_col_t)(v->n_column + 1), chart, &options);
}

static void
book_put_table(struct book *b, struct page *p, const struct answer_view *v)
{
	for (size_t c = 0; c < v->n_column; c++) {
		book_put_text(p, (lxw_col_t)c, v->head[c], b->head);
		set_column_width_to_text(p, v, (lxw_col_t)c);
	}
	worksheet_freeze_panes(p->sheet, p->row + 1, 1);
	book_add_chart(b, p, v);
	p->row++;
	for (size_t i = 0; i < v->n_row; i++, p->row++)
		for (size_t c = 0; c < v->n_column; c++)
			book_put_cell(b, p, (lxw_col_t)c, v->head[c],
			    &v->cell[i * v->n_column + c]);
	p->row++;
}

static void
book_put_sentences(
    struct book *b, struct page *p, const struct answer_view *v, bool warnings)
{
	static const char *const LIGHTS[] = {
	    "trust: green", "trust: amber", "trust: red"};
	for (size_t i = 0; i < v->n_sentence; i++) {
		const struct answer_sentence *said = &v->sentence[i];
		bool warning = said->grade == ANSWER_WARNING;
		if (warning != warnings)
			continue;
		FREED char *text =
		    xasprintf("%s%s", warning ? "warning: " : "", said->text);
		lxw_format *format = warning ? b->warning : NULL;
		for (size_t k = 0; k < ARRAY_LEN(LIGHTS); k++)
			if (strncmp(said->text, LIGHTS[k], strlen(LIGHTS[k])) ==
			    0)
				format = b->light[k]; /* in its colour */
		book_put_text(p, 0, text, format);
		p->row++;
	}
}

size_t
book_add_answer_worksheet(struct book *b, const struct answer *answer)
{
	struct answer_view v = answer_view(answer);
	struct page p = book_add_worksheet(b, answer_command_name(answer));
	if (v.title != NULL) {
		book_put_text(&p, 0, v.title, b->title);
		p.row++;
	}
	if (v.provenance != NULL && v.provenance[0] != '\0') {
		FREED char *data = xasprintf("data: %.*s",
		    (int)strcspn(v.provenance, ";"), v.provenance);
		book_put_text(&p, 0, data, b->remark);
		p.row++;
	}
	p.row += p.row > 0;
	if (v.n_column > 0)
		book_put_table(b, &p, &v);
	book_put_sentences(b, &p, &v, true);
	book_put_sentences(b, &p, &v, false);
	if (v.names_sites)
		book_add_about_line(b, "provenance", v.provenance);
	else
		b->has_site = b->has_site || v.site != NULL;
	return v.n_column > 0 ? v.n_row : v.n_sentence;
}

/* Writes a row of a text.  A row of three or more cells that does not begin
 * with a number has headings, which are bold. */
static void
book_put_text_row(struct book *b, struct page *p, const struct row *row)
{
	double value;
	bool head = row->n > 2 && !number_value_of_cell(row->cell[0], &value);
	p->row = (lxw_row_t)row->line - 1;
	for (size_t c = 0; c < row->n; c++) {
		lxw_col_t column = (lxw_col_t)c;
		if (!head && number_value_of_cell(row->cell[c], &value))
			worksheet_write_number(
			    p->sheet, p->row, column, value, NULL);
		else
			book_put_text(p, column, row->cell[c].text,
			    head ? b->head : NULL);
	}
	if (head)
		worksheet_set_column(
		    p->sheet, 0, (lxw_col_t)(row->n - 1), 14, NULL);
}

void
book_add_text_worksheet(struct book *b, const char *name, const char *text)
{
	enum { MOST_ROWS = 2000 };
	struct error_list errors = {0};
	FREED char *copy = xstrdup(text);
	const struct sheet_limits most = {.rows = MOST_ROWS};
	struct sheet *sheet = sheet_new_from_text("", copy, most, &errors);
	number_parse_all_cells(sheet);
	struct page p = book_add_worksheet(b, name);
	for (size_t i = 0; i < sheet->n_row; i++)
		book_put_text_row(b, &p, &sheet->row[i]);
	for (size_t i = 0; i < sheet->n_comment; i++) {
		const char *said = sheet->comment[i].text;
		FREED char *plain = text_without_quotes(said, strlen(said));
		p.row = (lxw_row_t)sheet->comment[i].line - 1;
		book_put_text(&p, 0, plain, b->remark);
	}
	sheet_free(sheet);
}

void
book_add_about_line(struct book *b, const char *key, const char *value)
{
	b->about = xrealloc(b->about, 2 * b->n_about + 2, sizeof *b->about);
	b->about[2 * b->n_about] = xstrdup(key);
	b->about[2 * b->n_about++ + 1] = xstrdup(value);
}

size_t
book_count_sheets(const struct book *b)
{
	return b->sheets;
}

bool
book_has_site(const struct book *b)
{
	return b->has_site;
}

static void
book_add_about_worksheet(struct book *b)
{
	struct page p = {.sheet = workbook_add_worksheet(b->workbook, "About")};
	lxw_format *left = add_cell_format(b, false, 0, 0);
	format_set_align(left, LXW_ALIGN_LEFT);
	for (size_t i = 0; i < b->n_about; i++, p.row++) {
		book_put_text(&p, 0, b->about[2 * i], b->head);
		const char *value = b->about[2 * i + 1];
		double number;
		if (text_parse_number(value, &number))
			worksheet_write_number(p.sheet, p.row, 1, number, left);
		else
			book_put_text(&p, 1, value, NULL);
	}
	worksheet_set_column(p.sheet, 0, 0, 16, NULL);
	worksheet_set_column(p.sheet, 1, 1, 80, NULL);
}

static char *
read_whole_file(int fd, size_t *n)
{
	off_t end = lseek(fd, 0, SEEK_END);
	char *bytes = end > 0 ? xcalloc((size_t)end, 1) : NULL;
	*n = 0;
	while (bytes != NULL && *n < (size_t)end) {
		ssize_t got =
		    pread(fd, bytes + *n, (size_t)end - *n, (off_t)*n);
		if (got > 0) {
			*n += (size_t)got;
		} else if (got == 0 || errno != EINTR) {
			xfree_and_set(&bytes, NULL);
		}
	}
	return bytes;
}

/* Returns what is wrong with a part of a workbook, or NULL.  libxlsxwriter
 * writes each part to a temporary file, and takes no notice if that fails. */
static char *
find_damaged_part(const char *bytes, size_t n)
{
	static const struct xml_events NONE = {NULL, NULL, NULL};
	struct error_list errors = {0};
	char *wrong = NULL;
	const char *name;
	struct archive *archive = archive_open(bytes, n, SIZE_MAX, &wrong);
	for (size_t i = 0;
	     wrong == NULL && (name = archive_entry_name(archive, i)) != NULL;
	     i++)
		wrong =
		    xml_parse_archive_part(archive, name, &NONE, NULL, &errors);
	archive_close(archive);
	return wrong;
}

char *
book_finish_to_bytes(struct book *b, size_t *n, struct error *error)
{
	book_add_about_worksheet(b);
	errno = 0;
	lxw_error code = workbook_close(b->workbook);
	char *bytes = code == LXW_NO_ERROR ? read_whole_file(b->fd, n) : NULL;
	const char *why = errno != 0 ? strerror(errno) : lxw_strerror(code);
	FREED char *wrong = bytes != NULL ? find_damaged_part(bytes, *n) : NULL;
	if (bytes == NULL || wrong != NULL) {
		error_set(error, ERROR_SYSTEM,
		    "cannot make the workbook: %s\nset TMPDIR to a folder with "
		    "free space",
		    wrong != NULL ? wrong : why);
		xfree_and_set(&bytes, NULL);
	}
	close_and_free_book(b);
	return bytes;
}
