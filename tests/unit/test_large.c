/* What is large is read in a time that grows with its cells, or refused before
 * it is looked at; and whoever waits can have it stopped.  Sheets and workbooks
 * are made up here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "books.h"
#include "sheets.h"

#include <math.h>
#include <time.h>

/* How much longer everything takes where each access to memory is checked. */
#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if defined __SANITIZE_ADDRESS__ || __has_feature(address_sanitizer)
static const double SLOWER = 10;
#else
static const double SLOWER = 1;
#endif

/* Processor time, s, that reading may take between two questions whether to
 * stop. */
static const double SOON = 0.2;

/* A file as a whole, or a part of a workbook that is made of it.  wanted: words
 * of the fault; "": it is a site.  most: processor time, s. */
struct large {
	const char *what;
	void (*print)(FILE *out);
	const char *part, *wanted;
	double most;
};

/* Materials as in Table 3, which has no sieves. */
static void
print_table3(FILE *out, int lines)
{
	fputs("rock,site,top_size_mm,f_mat,feed_source,e0_min,alpha\n", out);
	for (int i = 0; i < lines; i++)
		fprintf(out, "Granite,Quarry %d,11.2,0.0%d,Default,%d,1.1\n", i,
		    12 + i % 70, 100 + i);
}

static void
print_1900(FILE *out)
{
	print_table3(out, 1900);
}

static void
print_5000(FILE *out)
{
	print_table3(out, 5000);
}

/* A feed and cuts at one speed, a line for each of two sieves. */
static void
print_long(FILE *out)
{
	fputs("sample;speed m/s;sieve mm;passing %\n", out);
	fputs("feed;;22.4;100\nfeed;;2;30\n", out);
	for (int i = 1; i < 999; i++)
		fprintf(out, "cut %d;69;22.4;100\ncut %d;69;2;40\n", i, i);
}

/* 990 samples with 248 numbers each, as a table of 245,520 columns. */
static void
print_wide_samples(FILE *out)
{
	fputs("sample;sieve mm", out);
	for (int i = 0; i < 248; i++)
		fprintf(out, ";passing %% %d", i);
	for (int r = 0; r < 1980; r++) {
		fprintf(out, "\ns%d;%g", r / 2, r % 2 == 0 ? 22.4 : 2);
		for (int i = 0; i < 248; i++)
			fputs(";50", out);
	}
	fputs("\n", out);
}

static void
print_runs(FILE *out)
{
	fputs("size_mm,feed", out);
	for (int k = 0; k < 100; k++)
		fprintf(out, ",product@%g", 60 + 0.3 * k);
	for (int i = 0; i < 1000; i++) {
		double x = 22.4 * exp(-i * log(355) / 999);
		fprintf(out, "\n%.6g,%.5g", x, 100 * pow(x / 22.4, 0.8));
		for (int k = 0; k < 100; k++)
			fprintf(
			    out, ",%.5g", 100 * pow(x / 22.4, 0.5 - 0.001 * k));
	}
	fputs("\n", out);
}

static void
print_letter(FILE *out, char letter, size_t n)
{
	while (n-- > 0)
		fputc(letter, out);
}

static void
print_letters(FILE *out)
{
	for (int i = 0; i < 500; i++) {
		print_letter(out, 'a', 19000);
		fputs(",1,2\n", out);
	}
}

static void
print_words(FILE *out)
{
	for (int r = 0; r < 1990; r++)
		for (int c = 0; c < 250; c++)
			fprintf(out, "sieve size%s", c < 249 ? "," : "\n");
}

/* A comma in each line, and no digit to the end of the file. */
static void
print_commas(FILE *out)
{
	for (int i = 0; i < 3000000; i++)
		fputs("a,\n", out);
}

/* content.xml with these between its heads and the end, n times. */
static void
print_ods(FILE *out, const char *styles, const char *tables, size_t n)
{
	fprintf(out,
	    "<office:document-content " ODS_NAMES
	    "><office:automatic-styles>%s</office:automatic-styles>"
	    "<office:body><office:spreadsheet>",
	    styles);
	while (n-- > 0)
		fputs(tables, out);
	fputs("</office:spreadsheet></office:body>"
	      "</office:document-content>",
	    out);
}

#define REPEATED                                               \
	"<table:table-row "                                    \
	"table:number-rows-repeated='5000'><table:table-cell " \
	"office:value-type='string' "                          \
	"table:number-columns-repeated='5000'"

static void
print_empty_cells(FILE *out)
{
	print_ods(out, "", ODS_TABLE(REPEATED "/></table:table-row>"), 1);
}

/* With so many of a letter in the one cell. */
static void
print_cell(FILE *out, const char *row, char letter, size_t n)
{
	char *text = xcalloc(n + 1, 1);
	memset(text, letter, n);
	char *tables = xasprintf("<table:table table:name='May'>%s><text:p>%s"
				 "</text:p></table:table-cell>"
				 "</table:table-row></table:table>",
	    row, text);
	print_ods(out, "", tables, 1);
	free(tables);
	free(text);
}

static void
print_blanks(FILE *out)
{
	print_cell(out, REPEATED, ' ', 2000000);
}

static void
print_9_MB(FILE *out)
{
	print_cell(out, "<table:table-row><table:table-cell", 'a', 9000000);
}

static void
print_hidden_tables(FILE *out)
{
	print_ods(out,
	    "<style:style style:name='h' style:family='table'>"
	    "<style:table-properties table:display='false'/></style:style>",
	    "<table:table table:name='A' table:style-name='h'/>", 600000);
}

static void
print_empty_tables(FILE *out)
{
	print_ods(out, "", "<table:table table:name='A'/>", 600000);
}

/* A namespace of a million letters, and many names that are in it. */
static void
print_long_namespace(FILE *out)
{
	fputs("<x:worksheet xmlns:x='", out);
	print_letter(out, 'u', 1000000);
	fputs("'><sheetData>", out);
	for (int i = 0; i < 20000; i++)
		fputs("<x:row x:a='1'/>", out);
	fputs("</sheetData></x:worksheet>", out);
}

/* 2,000 rows from the last to the first, then one cell again and again. */
static void
print_backward_rows(FILE *out)
{
	fputs("<worksheet xmlns='" XLSX_MAIN "'><sheetData>", out);
	for (int i = 1999; i > 0; i--)
		fprintf(out, "<row r='%d'><c><v>1</v></c></row>", i);
	fputs("<row r='1'>", out);
	for (int i = 0; i < 400000; i++)
		fputs("<c r='A1'><v>1</v></c>", out);
	fputs("</row></sheetData></worksheet>", out);
}

static const char ODS[] = "content.xml", XLSX[] = "xl/worksheets/sheet1.xml";
static const char TOO_LONG[] = "more than 2000 lines, or 20000 bytes in a line";
static const char NO_TABLE[] = "expected a table of sieves";
static const char NO_SIEVES[] = "expected a sheet with sieves, got none";

static const struct large LARGE[] = {
    {"1,900 lines like Table 3", print_1900, NULL, NO_TABLE, 1},
    {"5,000 lines like Table 3", print_5000, NULL, TOO_LONG, 0.5},
    {"999 samples in a long table", print_long, NULL, "", 2},
    {"990 samples of 248 numbers", print_wide_samples, NULL,
	"expected a long table of at most 16 samples, got 990", 5},
    {"1,000 sieves, 100 runs", print_runs, NULL, "", 3},
    {"500 lines of 19,000 letters", print_letters, NULL, NO_TABLE, 5},
    {"1,990 lines of 250 heads", print_words, NULL, NO_TABLE, 5},
    {"3,000,000 lines of a comma", print_commas, NULL, TOO_LONG, 5},
    {"empty cells 5000 x 5000", print_empty_cells, ODS,
	"expected a site file, got an empty workbook", 0.5},
    {"2 MB of blanks 5000 x 5000", print_blanks, ODS, NO_SIEVES, 1},
    {"a cell of 9 MB", print_9_MB, ODS, NO_SIEVES, 1},
    {"600,000 hidden sheets", print_hidden_tables, ODS, NO_SIEVES, 5},
    {"600,000 empty sheets", print_empty_tables, ODS, NO_SIEVES, 5},
    {"a namespace of 1 MB", print_long_namespace, XLSX,
	"more names than a spreadsheet program writes", 1},
    {"rows from the last to the first", print_backward_rows, XLSX, NO_TABLE,
	2}};

/* What reading asks: how often it did, at which one it is told to stop (0:
 * never), and the longest it went on without. */
static size_t asked, stop_at;
static double last, longest;

static double
processor(void)
{
	return (double)clock() / CLOCKS_PER_SEC;
}

static bool
stop(void)
{
	double now = processor();
	longest = fmax(longest, now - last);
	last = now;
	return ++asked == stop_at;
}

static const char *
put_large(const struct large *large)
{
	static const char BOOK[] = "book";
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_memory(&text, &n);
	large->print(out);
	fclose(out);
	const struct part none = {NULL, NULL, 0};
	const struct part of_ods[] = {{ODS, text, 0}, none};
	const struct part of_xlsx[] = {
	    XLSX_WORKBOOK(""), XLSX_RELATIONS(""), {XLSX, text, 0}, none};
	const char *path = put_sheet(text, n);
	if (large->part != NULL) {
		path = BOOK;
		assert_true(
		    put_book(path, large->part == ODS ? of_ods : of_xlsx));
	}
	free(text);
	return path;
}

static struct site *
read_large(const char *path, struct error_list *errors, size_t at)
{
	*errors = (struct error_list){.stop = stop};
	asked = 0;
	stop_at = at;
	longest = 0;
	last = processor();
	struct site *site = site_read(path, errors);
	longest = fmax(longest, processor() - last);
	return site;
}

static void
the_time_of_reading_grows_with_the_cells(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(LARGE); i++) {
		const struct large *large = &LARGE[i];
		struct error_list errors;
		const char *path = put_large(large);
		double began = processor();
		struct site *site = read_large(path, &errors, 0);
		double took = processor() - began;
		print_message("# %-34s %.2f s, asked each %.2f s\n",
		    large->what, took, longest);
		if (took > SLOWER * large->most)
			fail_msg("%s: %g s", large->what, took);
		if (longest > SLOWER * SOON)
			fail_msg("%s: %g s without asking whether to stop",
			    large->what, longest);
		if ((site != NULL) != (large->wanted[0] == '\0') ||
		    (site == NULL &&
			strstr(errors.item[0].text, large->wanted) == NULL))
			fail_msg("%s: %s", large->what, errors.item[0].text);
		site_free(site);
	}
}

/* At each of the first questions, and at ever later ones. */
static void
reading_stops_when_it_is_told_to(void **state)
{
	(void)state;
	static const size_t SOME[] = {2, 4, 8, 9, 14}; /* of LARGE */
	for (size_t i = 0; i < ARRAY_LEN(SOME); i++) {
		const struct large *large = &LARGE[SOME[i]];
		const char *path = put_large(large);
		struct error_list errors;
		site_free(read_large(path, &errors, 0));
		size_t all = asked;
		for (size_t at = 1; at <= all; at += 1 + at / 2) {
			struct site *site = read_large(path, &errors, at);
			assert_null(site);
			assert_true(errors.stopped);
			assert_int_equal(asked, at); /* and no more */
			bool told = false;
			for (size_t k = 0; k < errors.n; k++)
				told = told ||
				       errors.item[k].kind == ERROR_STOPPED;
			assert_true(told || errors.more > 0);
		}
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_time_of_reading_grows_with_the_cells),
	    cmocka_unit_test(reading_stops_when_it_is_told_to)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
