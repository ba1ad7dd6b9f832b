/* Sheets and workbooks that are large, and what comes of reading them.  All are
 * made up here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_LARGE_H
#define TIPSPEED_TESTS_LARGE_H

#include <math.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "books.h"

/* A file as a whole, or a part of a workbook that is made of it.  n: how much
 * of what print repeats, cells: how many cells that makes, of which each is to
 * be looked at; 0: it may be refused before.  wanted: words of the fault; "":
 * it is a site. */
struct large {
	const char *what;
	void (*print)(FILE *out, size_t n);
	size_t n, cells;
	const char *part, *wanted;
};

/* Materials as in Table 3, which has no sieves. */
static inline void
print_table3(FILE *out, size_t n)
{
	fputs("rock,site,top_size_mm,f_mat,feed_source,e0_min,alpha\n", out);
	for (size_t i = 0; i < n; i++)
		fprintf(out, "Granite,Quarry %zu,11.2,0.0%zu,Default,%zu,1.1\n",
		    i, 12 + i % 70, 100 + i);
}

/* A feed and cuts at one speed, a line for each of their sieves. */
static inline void
print_long(FILE *out, size_t n, size_t sieves)
{
	fputs("sample;speed m/s;sieve mm;passing %\n", out);
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < sieves; k++) {
			if (i == 0)
				fputs("feed;", out);
			else
				fprintf(out, "cut %zu;69", i);
			fprintf(out, ";%g;%g\n", 22.4 / (double)(k + 1),
			    (k == 0 ? 100 : 60.0 / (double)k) -
				(i == 0 ? 5.0 * (k > 0) : 0));
		}
}

static inline void
print_long_2(FILE *out, size_t n)
{
	print_long(out, n, 2);
}

static inline void
print_long_5(FILE *out, size_t n)
{
	print_long(out, n, 5);
}

/* Each sample has a number, which falls, so that the last is the first. */
static inline void
print_long_falling(FILE *out, size_t n)
{
	fputs("sample;no;sieve mm;passing %\n", out);
	for (size_t i = 0; i < n; i++)
		fprintf(out, "s%zu;%zu;22.4;100\ns%zu;%zu;2;40\n", i, n - i, i,
		    n - i);
}

/* Two samples of n sieves each, and no two alike. */
static inline void
print_long_sieves(FILE *out, size_t n)
{
	fputs("sample;speed m/s;sieve mm;passing %\n", out);
	for (size_t i = 0; i < n; i++) {
		double mm = 22.4 * (double)(n - i) / (double)n;
		fprintf(out, "feed;;%.8g;%.8g\n", mm,
		    i == 0 ? 100 : 90 * mm / 22.4);
		fprintf(out, "cut 1;69;%.8g;%.8g\n", mm, 100 * mm / 22.4);
	}
}

/* Samples with 248 numbers each, as a table of 248 columns a sample. */
static inline void
print_wide_samples(FILE *out, size_t n)
{
	fputs("sample;sieve mm", out);
	for (int i = 0; i < 248; i++)
		fprintf(out, ";passing %% %d", i);
	for (size_t r = 0; r < 2 * n; r++) {
		fprintf(out, "\ns%zu;%g", r / 2, r % 2 == 0 ? 22.4 : 2);
		for (int i = 0; i < 248; i++)
			fputs(";50", out);
	}
	fputs("\n", out);
}

static inline void
print_runs(FILE *out, size_t n)
{
	fputs("size_mm,feed", out);
	for (int k = 0; k < 100; k++)
		fprintf(out, ",product@%g", 60 + 0.3 * k);
	for (size_t i = 0; i < n; i++) {
		double x = 22.4 * exp(-(double)i * log(355) / (double)(n - 1));
		fprintf(out, "\n%.6g,%.5g", x, 100 * pow(x / 22.4, 0.8));
		for (int k = 0; k < 100; k++)
			fprintf(
			    out, ",%.5g", 100 * pow(x / 22.4, 0.5 - 0.001 * k));
	}
	fputs("\n", out);
}

/* One sieve a line, and a number. */
static inline void
print_sieves(FILE *out, size_t n)
{
	fputs("size_mm,feed\n", out);
	for (size_t i = 0; i < n; i++)
		fprintf(out, "%.8g,%.8g\n", 22.4 * (double)(n - i) / (double)n,
		    100 * (double)(n - i) / (double)n);
}

static inline void
print_letter(FILE *out, char letter, size_t n)
{
	while (n-- > 0)
		fputc(letter, out);
}

static inline void
print_letters(FILE *out, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		print_letter(out, 'a', 19000);
		fputs(",1,2\n", out);
	}
}

static inline void
print_heads(FILE *out, size_t n, int columns)
{
	for (size_t r = 0; r < n; r++)
		for (int c = 0; c < columns; c++)
			fprintf(
			    out, "sieve size%s", c < columns - 1 ? "," : "\n");
}

static inline void
print_heads_250(FILE *out, size_t n)
{
	print_heads(out, n, 250);
}

static inline void
print_heads_4000(FILE *out, size_t n)
{
	print_heads(out, n, 4000);
}

static inline void
print_heads_25(FILE *out, size_t n)
{
	print_heads(out, n, 25);
}

/* A comma in each line, and no digit to the end of the file. */
static inline void
print_commas(FILE *out, size_t n)
{
	for (size_t i = 0; i < n; i++)
		fputs("a,\n", out);
}

/* content.xml with these between its heads and the end, n times. */
static inline void
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

/* With so many of a letter in the one cell, which stands n times n times. */
static inline void
print_cell(FILE *out, size_t n, char letter, size_t letters)
{
	char *text = xcalloc(letters + 1, 1);
	memset(text, letter, letters);
	char *tables =
	    xasprintf("<table:table table:name='May'><table:table-row "
		      "table:number-rows-repeated='%zu'><table:table-cell "
		      "office:value-type='string' "
		      "table:number-columns-repeated='%zu'><text:p>%s</text:p>"
		      "</table:table-cell></table:table-row></table:table>",
		n, n, text);
	print_ods(out, "", tables, 1);
	free(tables);
	free(text);
}

static inline void
print_empty_cells(FILE *out, size_t n)
{
	print_cell(out, n, ' ', 0);
}

static inline void
print_blanks(FILE *out, size_t n)
{
	print_cell(out, 5000, ' ', n);
}

static inline void
print_long_cell(FILE *out, size_t n)
{
	print_cell(out, 1, 'a', n);
}

static inline void
print_hidden_tables(FILE *out, size_t n)
{
	print_ods(out,
	    "<style:style style:name='h' style:family='table'>"
	    "<style:table-properties table:display='false'/></style:style>",
	    "<table:table table:name='A' table:style-name='h'/>", n);
}

static inline void
print_empty_tables(FILE *out, size_t n)
{
	print_ods(out, "", "<table:table table:name='A'/>", n);
}

/* A namespace of a million letters, and n names that are in it. */
static inline void
print_long_namespace(FILE *out, size_t n)
{
	fputs("<x:worksheet xmlns:x='", out);
	print_letter(out, 'u', 1000000);
	fputs("'><sheetData>", out);
	while (n-- > 0)
		fputs("<x:row x:a='1'/>", out);
	fputs("</sheetData></x:worksheet>", out);
}

/* Rows from the last to the first, then one cell as often again as fits. */
static inline void
print_backward_rows(FILE *out, size_t n)
{
	fputs("<worksheet xmlns='" XLSX_MAIN "'><sheetData>", out);
	for (size_t i = n; i > 1; i--)
		fprintf(out, "<row r='%zu'><c><v>1</v></c></row>", i);
	fputs("<row r='1'>", out);
	for (size_t i = 0; i < 20 * n; i++)
		fputs("<c r='A1'><v>1</v></c>", out);
	fputs("</row></sheetData></worksheet>", out);
}

static const char LARGE_ODS[] = "content.xml",
		  LARGE_XLSX[] = "xl/worksheets/sheet1.xml";
static const char NO_TABLE[] = "expected a table of sieves";
static const char NO_SIEVES[] = "expected a sheet with sieves, got none";
static const char TOO_LONG[] =
    "more than 20000 lines, or 200000 bytes in a line";

static const struct large LARGE[] = {
    {"lines like Table 3", print_table3, 19000, 7 * 19000, NULL, NO_TABLE},
    {"more lines like Table 3", print_table3, 25000, 0, NULL, TOO_LONG},
    {"samples of 2 rows in a long table", print_long_2, 1000, 8000, NULL, ""},
    {"samples of 5 rows in a long table", print_long_5, 1000, 20000, NULL, ""},
    {"samples from the last to the first", print_long_falling, 9000, 72000,
	NULL, "expected a long table of at most 4000 samples, got 9000"},
    {"sieves of two samples in a long table", print_long_sieves, 9900, 79200,
	NULL, ""},
    {"samples of 248 numbers", print_wide_samples, 990, 1980 * 250, NULL,
	"expected a long table of at most 16 samples, got 990"},
    {"more samples of 248 numbers", print_wide_samples, 1200, 0, NULL,
	"expected at most 512000 cells, got 2049 lines of up to 250"},
    {"sieves of 100 runs", print_runs, 1000, 102000, NULL, ""},
    {"sieves of a feed", print_sieves, 19000, 38000, NULL, ""},
    {"lines of 19,000 letters", print_letters, 500, 1500, NULL, NO_TABLE},
    {"lines of 250 heads", print_heads_250, 1990, 1990 * 250, NULL, NO_TABLE},
    {"lines of 4000 heads", print_heads_4000, 127, 127 * 4000, NULL, NO_TABLE},
    {"lines of 25 heads", print_heads_25, 19900, 19900 * 25, NULL, NO_TABLE},
    {"lines of a comma", print_commas, 3000000, 0, NULL, TOO_LONG},
    {"empty cells, squared", print_empty_cells, 5000, 0, LARGE_ODS,
	"expected cells with values, got an empty workbook"},
    {"blanks in each of 5000 x 5000 cells", print_blanks, 2000000, 0, LARGE_ODS,
	NO_SIEVES},
    {"letters in a cell", print_long_cell, 9000000, 0, LARGE_ODS, NO_SIEVES},
    {"hidden sheets", print_hidden_tables, 600000, 0, LARGE_ODS, NO_SIEVES},
    {"empty sheets", print_empty_tables, 600000, 0, LARGE_ODS, NO_SIEVES},
    {"names in a namespace of 1 MB", print_long_namespace, 20000, 0, LARGE_XLSX,
	"more names than a spreadsheet program writes"},
    {"rows from the last to the first", print_backward_rows, 19900, 21 * 19900,
	LARGE_XLSX, NO_TABLE}};

/* Writes n of what the large one repeats to a file; false where it cannot be
 * written. */
static inline bool
put_large(const struct large *large, size_t n, const char *path)
{
	char *text = NULL;
	size_t length = 0;
	FILE *out = text_open_memory(&text, &length);
	large->print(out, n);
	fclose(out);
	const struct part none = {NULL, NULL, 0};
	const struct part of_ods[] = {{LARGE_ODS, text, 0}, none};
	const struct part of_xlsx[] = {
	    XLSX_WORKBOOK(""), XLSX_RELATIONS(""), {LARGE_XLSX, text, 0}, none};
	bool good;
	if (large->part != NULL) {
		good =
		    put_book(path, large->part == LARGE_ODS ? of_ods : of_xlsx);
	} else {
		FILE *file = fopen(path, "wb");
		good = file != NULL && fwrite(text, 1, length, file) == length;
		good = file != NULL && fclose(file) == 0 && good;
	}
	free(text);
	return good;
}

#endif
