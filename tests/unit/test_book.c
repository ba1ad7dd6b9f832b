/* Workbooks of results hold what people see, and are read back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "books.h"
#include "sheets.h"

#include <math.h>

#include "io/formats/book.h"
#include "io/cells/source.h"

static struct answer *
new_answer(void)
{
	struct answer *a = answer_new("predict");
	answer_set_site(a, "Tierp", "made up; in a test");
	answer_set_title(a, "=Tierp, %s", "74 m/s");
	answer_add_columns(
	    a, "sieve_mm: sieve mm, passing_pct: product %%, note");
	answer_add_cells(a, "%g %.1f %s", 22.4, 100.0, "=1+1");
	answer_add_cells(a, "%g %.1f %s", 4.0, 65.72341, "-");
	answer_add_cells(a, "%g %.1f %s", 0.063, (double)NAN, "b");
	answer_note(a, "plain");
	answer_add_sentence(a, ANSWER_WARNING, "do not");
	return a;
}

static char *
new_bytes(size_t *n)
{
	struct error error = {0};
	struct answer *a = new_answer();
	struct book *b = book_new(&error);
	assert_non_null(b);
	assert_int_equal(book_count_sheets(b), 0);
	assert_int_equal(book_add_answer_worksheet(b, a), 3);
	assert_int_equal(book_add_answer_worksheet(b, a), 3);
	assert_int_equal(book_count_sheets(b), 2);
	assert_true(book_has_site(b));
	book_add_about_line(b, "command", "predict 74");
	answer_free(a);
	char *bytes = book_finish_to_bytes(b, n, &error);
	assert_non_null(bytes);
	return bytes;
}

static const char *
text_at(const struct sheet *sheet, int line, size_t column)
{
	for (size_t i = 0; i < sheet->n_row; i++)
		if (sheet->row[i].line == line)
			return row_cell_at(&sheet->row[i], column).text;
	return "";
}

static void
results_are_read_back(void **state)
{
	(void)state;
	size_t n;
	struct source source;
	struct error_list errors = {0};
	char *bytes = new_bytes(&n);
	assert_true(source_read_sheets(put_sheet(bytes, n), &errors, &source));
	free(bytes);
	assert_int_equal(source.n, 3);
	const struct sheet *sheet = source.sheet[0];
	assert_string_equal(sheet->name, "predict");
	assert_string_equal(source.sheet[1]->name, "predict 2");
	assert_string_equal(text_at(sheet, 1, 0), "=Tierp, 74 m/s");
	assert_string_equal(text_at(sheet, 2, 0), "data: made up");
	assert_string_equal(text_at(sheet, 4, 1), "product %");
	assert_string_equal(text_at(sheet, 5, 0), "22.4");
	assert_string_equal(text_at(sheet, 5, 2), "=1+1");
	assert_string_equal(text_at(sheet, 6, 1), "65.72341");
	assert_string_equal(text_at(sheet, 6, 2), "");
	assert_string_equal(text_at(sheet, 7, 1), "");
	assert_string_equal(text_at(sheet, 9, 0), "warning: do not");
	assert_string_equal(text_at(sheet, 10, 0), "plain");
	assert_string_equal(source.note, "");
	assert_string_equal(source.sheet[2]->name, "About");
	assert_string_equal(text_at(source.sheet[2], 1, 1), "predict 74");
	source_free(&source);
}

static void
the_same_results_are_the_same_bytes(void **state)
{
	(void)state;
	size_t n, m;
	char *a = new_bytes(&n), *b = new_bytes(&m);
	assert_int_equal(n, m);
	assert_memory_equal(a, b, n);
	free(a);
	free(b);
}

/* The parts of the archive say what no reader of cells does. */
static bool
part_has_site(const char *path, const char *name, const char *text)
{
	int code;
	static char bytes[100000];
	zip_t *zip = zip_open(path, ZIP_RDONLY, &code);
	zip_file_t *file = zip != NULL ? zip_fopen(zip, name, 0) : NULL;
	zip_int64_t n =
	    file != NULL ? zip_fread(file, bytes, sizeof bytes - 1) : 0;
	bytes[n > 0 ? n : 0] = '\0';
	if (file != NULL)
		zip_fclose(file);
	zip_discard(zip);
	return strstr(bytes, text) != NULL;
}

static void
there_are_formats_a_chart_and_no_formulas(void **state)
{
	(void)state;
	size_t n;
	char *bytes = new_bytes(&n);
	const char *path = put_sheet(bytes, n);
	free(bytes);
	assert_true(part_has_site(path, "xl/styles.xml", "formatCode=\"0.0\""));
	assert_true(part_has_site(
	    path, "xl/charts/chart1.xml", "<c:logBase val=\"10\"/>"));
	assert_true(part_has_site(path, "xl/charts/chart1.xml", "product %"));
	assert_true(part_has_site(
	    path, "xl/worksheets/sheet1.xml", "state=\"frozen\""));
	assert_false(part_has_site(path, "xl/worksheets/sheet1.xml", "<f>"));
}

static void
text_becomes_cells(void **state)
{
	(void)state;
	struct error error = {0};
	struct book *b = book_new(&error);
	size_t n;
	book_add_text_worksheet(b, "template",
	    "\"# a, b\"\nsite,\nsize_mm,feed,product@69\n8,100,\n");
	char *bytes = book_finish_to_bytes(b, &n, &error);
	assert_non_null(bytes);
	struct source source;
	struct error_list errors = {0};
	assert_true(source_read_sheets(put_sheet(bytes, n), &errors, &source));
	free(bytes);
	const struct sheet *sheet = source.sheet[0];
	assert_int_equal(sheet->n_comment, 1);
	assert_string_equal(sheet->comment[0].text, "# a, b");
	assert_string_equal(text_at(sheet, 3, 2), "product@69");
	assert_int_equal(sheet->row[2].cell[1].kind, CELL_NUMBER);
	source_free(&source);
	/* Given up on the way. */
	b = book_new(&error);
	book_add_text_worksheet(b, "template", "a\n");
	book_free(b);
	book_free(NULL);
}

static void
without_room_for_it_that_is_told(void **state)
{
	(void)state;
	struct error error = {0};
	setenv("TMPDIR", "/nowhere", 1);
	assert_null(book_new(&error));
	unsetenv("TMPDIR");
	assert_int_equal(error.kind, ERROR_SYSTEM);
	assert_non_null(strstr(error.hint, "TMPDIR"));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(results_are_read_back),
	    cmocka_unit_test(the_same_results_are_the_same_bytes),
	    cmocka_unit_test(there_are_formats_a_chart_and_no_formulas),
	    cmocka_unit_test(text_becomes_cells),
	    cmocka_unit_test(without_room_for_it_that_is_told)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
