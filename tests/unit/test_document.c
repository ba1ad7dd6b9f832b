/* Documents: HTML that any reader of XML takes, whatever the words, and pages
 * that hold all of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "base/text.h"
#include "cmd/document/html.h"
#include "cmd/document/pdf.h"
#include "cmd/session/journal.h"
#include "cmd/session/undo.h"
#include "desk.h"
#include "io/cells/xml.h"
#include "plot/picture.h"

static const char HOSTILE[] =
    "</title><script>alert(1)</script>\x1b[31m\xff &amp; ]]> --> \"'";

/* What a reader of XML found. */
struct found {
	size_t tables, rows, heads, images, scripts;
	char *words;
};

static void
begin(void *data, const char *name, const char *const *attribute)
{
	struct found *f = data;
	(void)attribute;
	f->tables += strcmp(name, "table") == 0;
	f->rows += strcmp(name, "tr") == 0;
	f->heads += strcmp(name, "th") == 0;
	f->images += strcmp(name, "svg") == 0;
	f->scripts += strcmp(name, "script") == 0 || strcmp(name, "a") == 0 ||
		      strcmp(name, "link") == 0 || strcmp(name, "img") == 0;
}

static void
end(void *data, const char *name)
{
	(void)data;
	(void)name;
}

static void
text(void *data, const char *words, size_t n)
{
	struct found *f = data;
	xappend(&f->words, "%.*s", (int)n, words);
}

/* Reads a page; the document is ended. */
static struct found
read_page(struct document *d)
{
	static const char TYPE[] = "<!DOCTYPE html>\n";
	static const struct xml_events events = {begin, end, text};
	struct found f = {.words = xstrdup("")};
	size_t n;
	struct error_list errors = {0};
	assert_true(document_finish(d));
	char *page = document_to_html(d, &n);
	assert_int_equal(strncmp(page, TYPE, strlen(TYPE)), 0);
	char *wrong = xml_parse_document(
	    page + strlen(TYPE), n - strlen(TYPE), &events, &f, &errors);
	if (wrong != NULL)
		fail_msg("%s", wrong);
	assert_null(strstr(page, "url("));
	assert_null(strstr(page, "src="));
	free(page);
	return f;
}

/* Rows of numbers, the last column of words. */
static struct answer *
table(size_t rows, size_t columns, const char *words)
{
	struct answer *a = answer_new("sweep");
	answer_set_title(a, "%s", words);
	answer_set_site(a, words, words);
	for (size_t c = 0; c + 1 < columns; c++)
		answer_add_columns(a, "column%zu", c);
	answer_add_column(a, "words", words);
	for (size_t i = 0; i < rows * (columns - 1); i++) {
		answer_add_cells(a, "%.2f", (double)i);
		if (i % (columns - 1) == columns - 2)
			answer_add_cells(a, "%s", words);
	}
	answer_add_sentence(a, ANSWER_WARNING, "%s", words);
	answer_note(a, "%s", words);
	return a;
}

static struct document *
with_table(size_t rows, size_t columns, const char *words)
{
	struct document *d = document_new("tipspeed: test");
	struct answer *a = table(rows, columns, words);
	assert_int_equal(document_add_answer(d, a), rows);
	answer_free(a);
	return d;
}

static struct chart *
chart(const char *words)
{
	struct axis x = axis_new_linear("x", 0, 1),
		    y = axis_new_linear("y", 0, 1);
	struct chart *c = chart_new(words, words, x, y);
	chart_append_series(
	    c, (struct chart_series){.line = CHART_SOLID}, 2, "%s", words);
	return c;
}

static void
words_of_others_are_words(void **state)
{
	(void)state;
	struct document *d = with_table(3, 4, HOSTILE);
	document_add_paragraph(d, DOCUMENT_HEADING, "%s", HOSTILE);
	document_add_paragraph(d, DOCUMENT_WORDS, "%s", HOSTILE);
	document_add_paragraph(d, DOCUMENT_WARNING, "%s", HOSTILE);
	document_add_trust_light(d, LIGHT_RED, HOSTILE);
	document_add_chart(d, chart(HOSTILE));
	fprintf(d->out, "%s\n", HOSTILE);
	struct found f = read_page(d);
	assert_int_equal(f.tables, 1);
	assert_int_equal(f.rows, 4);
	assert_int_equal(f.images, 1);
	assert_int_equal(f.scripts, 0);
	assert_non_null(strstr(f.words, "<script>alert(1)</script>\\x1b[31m"));
	free(f.words);
	document_free(d);
}

static void
parts_keep_their_order(void **state)
{
	(void)state;
	struct document *d = document_new("tipspeed: test");
	fputs("\n\none\n", d->out);
	document_add_paragraph(d, DOCUMENT_HEADING, "%s", "two");
	fputs("three\n", d->out);
	fputs("four\n\n", d->out);
	document_add_paragraph(d, DOCUMENT_WORDS, "five");
	assert_true(document_finish(d));
	assert_int_equal(d->n, 4);
	assert_string_equal(d->part[0].text, "one");
	assert_string_equal(d->part[2].text, "three\nfour");
	assert_string_equal(d->title, "tipspeed: test");
	document_free(d);
	d = document_new("tipspeed: test");
	assert_false(document_finish(d));
	document_free(d);
}

/* Every column is there, the first one in each block. */
static void
a_wide_table_goes_on_below(void **state)
{
	(void)state;
	enum { COLUMNS = 40 };
	struct document *d = with_table(2, COLUMNS, "rock");
	struct found f = read_page(d);
	assert_true(f.tables > 1);
	assert_int_equal(f.heads, COLUMNS + f.tables - 1);
	assert_int_equal(f.rows, 3 * f.tables);
	free(f.words);
	document_free(d);
}

static size_t
pages_of(struct document *d)
{
	size_t n, pages, m, again;
	assert_true(document_finish(d));
	char *file = document_to_pdf(d, &n, &pages);
	char *other = document_to_pdf(d, &m, &again);
	assert_non_null(file);
	assert_int_equal(strncmp(file, "%PDF-", 5), 0);
	assert_int_equal(n, m);
	assert_memory_equal(file, other, n);
	free(file);
	free(other);
	document_free(d);
	return pages;
}

static void
paper_has_room(void **state)
{
	(void)state;
	char *word = xcalloc(6001, 1);
	if (!picture_can_draw_format(PICTURE_PDF))
		skip();
	memset(word, 'm', 6000);
	assert_int_equal(pages_of(with_table(12, 5, "rock")), 1);
	assert_in_range(pages_of(with_table(200, 5, HOSTILE)), 3, 30);
	assert_in_range(pages_of(with_table(1, 2, word)), 2, 30);
	struct document *d = with_table(60, 12, "rock");
	d->one_page = true;
	assert_int_equal(pages_of(d), 1);
	free(word);
}

static void
a_report_leaves_the_session_alone(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/tierp.csv");
	desk_expect(desk, "params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	desk_expect(desk, "predict 70");
	size_t depth = undo_count_steps(s), lines = journal_current_place(s).n;
	char folder[] = "/tmp/tipspeed-XXXXXX";
	assert_non_null(mkdtemp(folder));
	char *file = xasprintf("%s/a.html", folder);
	char *line = xasprintf("report speed=85 > %s", file);
	desk_expect(desk, line);
	assert_int_equal(unlink(file) + rmdir(folder), 0);
	free(line);
	free(file);
	assert_null(s->document);
	assert_null(s->file);
	assert_int_equal(undo_count_steps(s), depth);
	assert_int_equal(journal_current_place(s).n, lines);
	assert_true(session_number_in_last_answer(s, "predict", "speed") == 70);
	assert_false(desk_say(desk, "report"));
	assert_non_null(strstr(desk->error.hint, "report > report.html"));
}

/* Under sanitizers: fontconfig keeps what it found to the end of the program.
 * Symbols are compiled hidden, which the sanitizer would not see. */
__attribute__((visibility("default"))) const char *__lsan_default_suppressions(
    void);
const char *
__lsan_default_suppressions(void)
{
	return "leak:libfontconfig";
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(words_of_others_are_words),
	    cmocka_unit_test(parts_keep_their_order),
	    cmocka_unit_test(a_wide_table_goes_on_below),
	    cmocka_unit_test(paper_has_room),
	    cmocka_unit_test_setup_teardown(
		a_report_leaves_the_session_alone, desk_open, desk_close),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
