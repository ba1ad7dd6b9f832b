/* Workbooks come to the cells that people see in them, or are refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "books.h"
#include "sheets.h"

#include "io/cells/cell_format.h"
#include "io/cells/source.h"
#include "io/cells/number.h"

static const char BOOK[] = "book.xlsx";

/* In the folder of the test. */
static void
put_parts(const struct part *part)
{
	put_sheet("", 0);
	assert_true(put_book(BOOK, part));
}

/* Cells as "B2=text", a number after #, a date after @; with a space between,
 * and a bar before the next sheet. */
static char *
said(const struct source *source)
{
	static const char MARK[] = {
	    [CELL_TEXT] = '=', [CELL_NUMBER] = '#', [CELL_DATE] = '@'};
	char *all = xstrdup("");
	for (size_t i = 0; i < source->n; i++) {
		const struct sheet *sheet = source->sheet[i];
		xappend(&all, "%s%s:", i > 0 ? "|" : "", sheet->name);
		for (size_t r = 0; r < sheet->n_row; r++)
			for (size_t c = 0; c < sheet->row[r].n; c++) {
				const struct cell *cell =
				    &sheet->row[r].cell[c];
				assert_int_equal(
				    cell->line, sheet->row[r].line);
				assert_int_equal(cell->column, c + 1);
				if (cell->text[0] != '\0')
					xappend(&all, " %c%d%c%s",
					    (int)('A' + c), cell->line,
					    MARK[cell->kind], cell->text);
			}
		for (size_t c = 0; c < sheet->n_comment; c++)
			xappend(&all, " %d%s", sheet->comment[c].line,
			    sheet->comment[c].text);
	}
	return all;
}

static void
expect(const struct part *part, const char *cells, const char *note)
{
	struct error_list errors = {0};
	struct source source;
	put_parts(part);
	bool good = source_read_sheets(BOOK, &errors, &source);
	for (size_t i = 0; i < errors.n; i++)
		error_print(&errors.item[i], stderr);
	assert_true(good);
	assert_int_equal(errors.n, 0);
	char *found = said(&source);
	assert_string_equal(found, cells);
	assert_string_equal(source.note, note);
	free(found);
	source_free(&source);
}

static void
refuse(const struct part *part, const char *wrong)
{
	struct error_list errors = {0};
	struct source source;
	put_parts(part);
	assert_false(source_read_sheets(BOOK, &errors, &source));
	source_free(&source);
	assert_int_equal(errors.n, 1);
	const struct error *e = &errors.item[0];
	assert_int_equal(e->kind, ERROR_DATA);
	assert_string_equal(e->file, BOOK);
	assert_true(e->hint[0] != '\0');
	if (strstr(e->text, wrong) == NULL)
		fail_msg("'%s' is not in '%s'", wrong, e->text);
}

#define CELL(place, more) "<c r='" place "'" more "</c>"
#define PARTS(...) ((const struct part[]){__VA_ARGS__, {NULL, NULL, 0}})
#define SHEET(rows) \
	PARTS(XLSX_WORKBOOK(""), XLSX_RELATIONS(""), XLSX_SHEET(rows))

static void
cells_of_excel_are_read(void **state)
{
	(void)state;
	static const struct part STRINGS = {"xl/sharedStrings.xml",
	    "<sst xmlns='" XLSX_MAIN "'><si><t>Sikt</t></si><si><r><t "
	    "xml:space='preserve'>Pro</t></r><r><rPr><b/></rPr><t>v 1</t></r>"
	    "<rPh sb='0' eb='1'><t>purofu</t></rPh></si><si><t>a\n"
	    "b_x000D_\tc_x005F_x</t></si></sst>",
	    0};
	expect(PARTS(XLSX_WORKBOOK(""), XLSX_RELATIONS(""), STRINGS,
		   XLSX_SHEET("<row r='2'>" CELL("A2", " t='s'><v>0</v>")
			   CELL("C2", " t='s'><v>1</v>")
			       CELL("D2", " t='s'><v>2</v>") "</row>")),
	    "May: A2=Sikt C2=Prov 1 D2=a b c_x", "");
	expect(SHEET("<row r='1'>" CELL("A1",
		   " t='inlineStr'><is><t> A\xCC\x8A </t></is>") CELL("B1",
		   " t='str'><f>A1</f><v>x</v>") CELL("C1", " t='b'><v>1</v>")
		       CELL("D1", " t='e'><v>#DIV/0!</v>") CELL(
			   "E1", " t='d'><v>2026-05-03T00:00:00</v>") CELL("F1",
			   " t='d'><v>2026-05-03T10:15:30</v>") CELL("G1",
			   " t='d'><v>2026-05-03T10:15:00</v>") CELL("H1",
			   " t='d'><v>2026-05-03 10:15 UT</v>") "</row>"),
	    "May: A1=\xC3\x85 B1=x C1=TRUE D1=#DIV/0! E1@2026-05-03 "
	    "F1@2026-05-03T10:15:30 G1@2026-05-03T10:15 H1@2026-05-03 10:15 UT",
	    "");
	/* Without places, as some programs write. */
	expect(SHEET("<row><c><v>1</v></c><c/><c><v>2.5</v></c></row><row/>"
		     "<row><c><v>97.799999999999997</v></c></row>"),
	    "May: A1#1 C1#2.5 A3#97.8", "");
	expect(SHEET("<row r='3'>" CELL("AB3", "><v>1e-3</v>")
		       CELL("B3", "><v>2</v>") "</row><row r='1'>" CELL(
			   "A1", "><v>3</v>") "</row>"),
	    "May: A1#3 B3#2 \\3#0.001", "");
}

static void
numbers_are_what_their_formats_show(void **state)
{
	(void)state;
	static const struct part STYLES = {"xl/styles.xml",
	    "<styleSheet xmlns='" XLSX_MAIN "'><numFmts>"
	    "<numFmt numFmtId='164' formatCode='0.0\\ %'/>"
	    "<numFmt numFmtId='165' formatCode='yyyy\\-mm\\-dd\\ hh:mm'/>"
	    "<numFmt numFmtId='166' formatCode='0&quot; m/s&quot;'/>"
	    "</numFmts><cellStyleXfs><xf numFmtId='14'/></cellStyleXfs>"
	    "<cellXfs><xf numFmtId='0'/><xf numFmtId='10'/>"
	    "<xf numFmtId='164'/><xf numFmtId='14'/><xf numFmtId='165'/>"
	    "<xf numFmtId='166'/><xf numFmtId='20'/></cellXfs></styleSheet>",
	    0};
#define ROW                                                                    \
	"<row r='1'>" CELL("A1", " s='1'><v>0.975</v>")                        \
	    CELL("B1", " s='2'><v>0.57</v>") CELL("C1", " s='3'><v>46145</v>") \
		CELL("D1", " s='4'><v>46145.427083333336</v>")                 \
		    CELL("E1", " s='5'><v>69</v>")                             \
			CELL("F1", " s='6'><v>0.4375</v>")                     \
			    CELL("G1", " s='77'><v>1</v>") "</row>"
	expect(PARTS(XLSX_WORKBOOK(""), XLSX_RELATIONS(""), STYLES,
		   XLSX_SHEET(ROW)),
	    "May: A1#97.5 % B1#57 % C1@2026-05-03 D1@2026-05-03T10:15 "
	    "E1#69 m/s F1@10:30 G1#1",
	    "");
	expect(
	    PARTS(XLSX_WORKBOOK("<workbookPr date1904='1'/>"),
		XLSX_RELATIONS(""), STYLES,
		XLSX_SHEET("<row>" CELL("A1", " s='3'><v>44683</v>") "</row>")),
	    "May: A1@2026-05-03", "");
	struct error_list errors = {0};
	struct source source;
	put_parts(PARTS(
	    XLSX_WORKBOOK(""), XLSX_RELATIONS(""), STYLES, XLSX_SHEET(ROW)));
	assert_true(source_read_sheets(BOOK, &errors, &source));
	double v = 0;
	struct sheet *sheet = source.sheet[0];
	assert_true(number_value_of_cell(sheet->row[0].cell[0], &v));
	assert_true(v == 97.5);
	assert_true(number_value_of_cell(sheet->row[0].cell[4], &v));
	assert_true(v == 69);
	assert_false(number_value_of_cell(sheet->row[0].cell[2], &v));
	source_free(&source);
}

static void
formats_are_told_apart(void **state)
{
	(void)state;
	static const struct {
		const char *code;
		enum cell_format_kind kind;
		const char *unit;
	} codes[] = {{"General", FORMAT_NUMBER, ""},
	    {"Standard", FORMAT_NUMBER, ""}, {"0.00E+00", FORMAT_NUMBER, ""},
	    {"#,##0.0;[Red]\\-d", FORMAT_NUMBER, ""},
	    {"#\\ ##0", FORMAT_NUMBER, ""}, {"0%", FORMAT_NUMBER, "%"},
	    {"0.0\" mm\"", FORMAT_NUMBER, "mm"},
	    {"0.0\\ \\m\\m", FORMAT_NUMBER, "mm"},
	    {"[Red]0.0", FORMAT_NUMBER, ""}, {"_-* #,##0_d", FORMAT_NUMBER, ""},
	    {"0\" of a long remark\"", FORMAT_NUMBER, ""},
	    {"d/m/yyyy", FORMAT_DATE, ""}, {"mmm-yy", FORMAT_DATE, ""},
	    {"[$-41D]d mmmm yyyy;@", FORMAT_DATE, ""},
	    {"h:mm", FORMAT_TIME, ""}, {"mm:ss", FORMAT_TIME, ""},
	    {"[h]:mm:ss", FORMAT_SPAN, ""},
	    {"\"day\" 0", FORMAT_NUMBER, "day"}};
	for (size_t i = 0; i < ARRAY_LEN(codes); i++) {
		struct cell_format shown = cell_format_of_code(codes[i].code);
		if (shown.kind != codes[i].kind ||
		    strcmp(shown.unit, codes[i].unit) != 0)
			fail_msg("%s: %d '%s'", codes[i].code, shown.kind,
			    shown.unit);
	}
}

static void
serials_become_dates(void **state)
{
	(void)state;
	static const struct {
		double serial;
		bool from_1904;
		enum cell_format_kind kind;
		const char *text;
	} dates[] = {{1, false, FORMAT_DATE, "1900-01-01"},
	    {59, false, FORMAT_DATE, "1900-02-28"},
	    {61, false, FORMAT_DATE, "1900-03-01"},
	    {0, true, FORMAT_DATE, "1904-01-01"},
	    {36585, false, FORMAT_DATE, "2000-02-29"},
	    {2958465, false, FORMAT_DATE, "9999-12-31"},
	    {46145.99999999, false, FORMAT_DATE, "2026-05-04"},
	    {46145.5004, false, FORMAT_DATE, "2026-05-03T12:00:35"},
	    {0.25, false, FORMAT_TIME, "06:00"},
	    {1.5, false, FORMAT_SPAN, "36:00"}};
	char text[32];
	for (size_t i = 0; i < ARRAY_LEN(dates); i++) {
		assert_true(cell_format_serial_to_text(
		    dates[i].serial, dates[i].from_1904, dates[i].kind, text));
		assert_string_equal(text, dates[i].text);
	}
	assert_false(cell_format_serial_to_text(-1, false, FORMAT_DATE, text));
	assert_false(
	    cell_format_serial_to_text(2958466, false, FORMAT_DATE, text));
}

static void
hidden_and_unsolved_things_are_told(void **state)
{
	(void)state;
	static const struct part TWO = {"xl/workbook.xml",
	    "<workbook xmlns='" XLSX_MAIN "' xmlns:r='" OFFICE
	    "relationships'><sheets><sheet name='Old' state='hidden' "
	    "r:id='r1'/><sheet name='B' r:id='r2'/><sheet name='C' r:id='r3'/>"
	    "</sheets></workbook>",
	    0};
	static const struct part B = {"xl/worksheets/b.xml",
	    "<worksheet xmlns='" XLSX_MAIN "'><sheetData><row hidden='1'><c>"
	    "<f>1+1</f></c><c><f>2*3</f><v></v></c><c t='str'><f>\"\"</f><v>"
	    "</v></c></row></sheetData></worksheet>",
	    0};
	expect(PARTS(TWO, XLSX_RELATIONS(""), B, XLSX_SHEET("<row/>")),
	    "B: A1==1+1 B1==2*3",
	    "sheet Old is hidden and not read; hidden rows and columns of "
	    "sheet B are also read; sheet B has formulas without results: "
	    "open and save the workbook in a spreadsheet program");
}

#define ODS_CELL(more) "<table:table-cell " more "</table:table-cell>"
#define VALUE(type, value) \
	"office:value-type='" type "' office:value='" value "'>"

/* One line to each thing that a reader has to know. */
static const struct part CALC[] = {
    ODS_CONTENT("<style:style style:family='table' style:name='ta2'>"
		"<style:table-properties table:display='false'/></style:style>",
	"<table:table table:name='Old' table:style-name='ta2'>"
	"<table:table-row><table:table-cell office:value-type='float' "
	"office:value='1'/></table:table-row></table:table>"
	"<table:table table:name='May'>"
	"<table:table-column table:number-columns-repeated='9'/>"
	"<table:table-row table:number-rows-repeated='2'>"
	"<table:table-cell table:number-columns-repeated='9'/>"
	"</table:table-row><table:table-row>"
	"<table:table-cell office:value-type='string'><office:annotation>"
	"<text:p>no</text:p></office:annotation><text:p>a<text:s text:c='2'/>"
	"<text:span>b</text:span></text:p><text:p>c</text:p></table:table-cell>"
	"<table:covered-table-cell table:number-columns-repeated='2'/>"
	"<table:table-cell table:number-columns-repeated='2' "
	"office:value-type='percentage' office:value='0.975'/>"
	"<table:table-cell office:value-type='date' "
	"office:date-value='2026-05-03T10:15:00'/>"
	"<table:table-cell office:value-type='time' "
	"office:time-value='PT10H15M00S'/>"
	"<table:table-cell office:value-type='string' office:string-value='' "
	"calcext:value-type='error'><text:p>#N/A</text:p></table:table-cell>"
	"<table:table-cell table:formula='of:=1+1'/></table:table-row>"
	"<table:table-row table:number-rows-repeated='1048570' "
	"table:visibility='collapse'>"
	"<table:table-cell table:number-columns-repeated='16384'/>"
	"</table:table-row></table:table>"),
    {NULL, NULL, 0}};

static void
cells_of_libreoffice_are_read(void **state)
{
	(void)state;
	expect(CALC,
	    "May: A3=a  b c D3#97.5 % E3#97.5 % F3@2026-05-03T10:15 G3@10:15 "
	    "H3=#N/A I3==1+1",
	    "sheet Old is hidden and not read; hidden rows and columns of "
	    "sheet May are also read; sheet May has formulas without results: "
	    "open and save the workbook in a spreadsheet program");
	expect(PARTS(ODS_CONTENT("",
		   ODS_TABLE("<table:table-row table:number-rows-repeated='2'>"
			     "<table:table-cell office:value-type='float' "
			     "office:value='2'/></table:table-row>"))),
	    "May: A1#2 A2#2", "");
	/* What a format adds stands in what is shown only. */
	expect(PARTS(ODS_CONTENT("",
		   ODS_TABLE("<table:table-row>"
			     "<table:table-cell office:value-type='float' "
			     "office:value='69.5'><text:p>69,5 m/s</text:p>"
			     "</table:table-cell><table:table-cell "
			     "office:value-type='float' office:value='1500'>"
			     "<text:p>1.50E+03</text:p></table:table-cell>"
			     "</table:table-row>"))),
	    "May: A1#69.5 m/s B1#1500", "");
}

static void
remarks_are_rows_that_begin_with_a_cross(void **state)
{
	(void)state;
#define SAY(place, text) CELL(place, " t='str'><v>" text "</v>")
	expect(SHEET("<row>" SAY("A1", "# wet, see log!")
		       SAY("B1", "x") "</row><row>" SAY("A2", "#N/A") SAY(
			   "B2", "#x") "</row><row>" SAY("A3", "#4") "</row>"),
	    "May: A2=#N/A B2=#x 1# wet, see log! 3#4", "");
	struct error_list errors = {0};
	struct source source;
	assert_true(source_read_sheets(BOOK, &errors, &source));
	struct sheet *sheet = source.sheet[0];
	sheet_turn_comment_into_row(sheet, 1);
	sheet_turn_comment_into_row(sheet, 0);
	char *found = said(&source);
	assert_string_equal(
	    found, "May: A1=# wet, see log! B1=x A2=#N/A B2=#x A3=#4");
	free(found);
	source_free(&source);
}

static void
workbooks_are_sites(void **state)
{
	(void)state;
#define THREE(line, a, b, c)                                                \
	"<row r='" line "'>" CELL("A" line, "><v>" a "</v>")                \
	    CELL("B" line, "><v>" b "</v>") CELL("C" line, "><v>" c "</v>") \
		CELL("D" line, "><v>" c "</v>") "</row>"
#define HEADS                                                \
	"<row r='2'>" SAY("A2", "size_mm") SAY("B2", "feed") \
	    SAY("C2", "product@69") SAY("D2", "product@79") "</row>"
	put_parts(SHEET(HEADS THREE("4", "8", "100", "100")
		THREE("5", "4", "60", "80") THREE("6", "1", "10", "20")));
	struct error_list errors = {0};
	struct site *site = site_read(BOOK, &errors);
	assert_non_null(site);
	assert_string_equal(site->name, "book");
	assert_string_equal(site->path, BOOK);
	assert_true(site->run[1].product.passing[1] == 0.8);
	site_free(site);
	/* Rows of sieves that are called by a number and # are no comments. */
#define NAMED(line, name, v)                                                \
	"<row r='" line "'>" SAY("A" line, name)                            \
	    CELL("B" line, "><v>" v "</v>") CELL("C" line, "><v>" v "</v>") \
		CELL("D" line, "><v>" v "</v>") "</row>"
	put_parts(SHEET(HEADS THREE("4", "8", "100", "100") NAMED(
	    "5", "#4", "9") NAMED("6", "# 8", "5") NAMED("7", "#16", "2")));
	site = site_read(BOOK, &errors);
	assert_non_null(site);
	assert_int_equal(site->run[1].product.n, 4);
	assert_true(site->run[1].product.size[3] == 1.18 / 1000);
	site_free(site);
	/* Faults are told where people of spreadsheets look. */
	put_parts(SHEET(HEADS THREE("4", "8", "100", "100") "<row r='5'>" CELL(
	    "A5", "><v>4</v>") SAY("B5", "x1")
		CELL("C5", "><v>80</v>") "</row>" THREE("6", "1", "10", "20")));
	assert_null(site_read(BOOK, &errors));
	assert_int_equal(errors.n, 1);
	char *shown = NULL;
	size_t n;
	FILE *out = open_memstream(&shown, &n);
	error_print(&errors.item[0], out);
	fclose(out);
	const char *place = "book.xlsx, sheet May, B5: expected a number";
	assert_int_equal(strncmp(shown, place, strlen(place)), 0);
	free(shown);
}

static void
sheets_beyond_the_limits_are_left_out(void **state)
{
	(void)state;
	char *rows = xstrdup("");
	for (int i = 0; i < 20001; i++)
		xappend(&rows, "<row><c><v>%d</v></c></row>", i);
	char *text = xasprintf("<worksheet xmlns='" XLSX_MAIN
			       "'><sheetData>%s</sheetData></worksheet>",
	    rows);
	struct part large = {"xl/worksheets/sheet1.xml", text, 0};
	refuse(PARTS(XLSX_WORKBOOK(""), XLSX_RELATIONS(""), large),
	    "expected a sheet with sieves, got none");
	free(text);
	free(rows);
	static const struct part TWO = {"xl/workbook.xml",
	    "<workbook xmlns='" XLSX_MAIN "' xmlns:r='" OFFICE
	    "relationships'><sheets><sheet name='Log' r:id='r1'/>"
	    "<sheet name='B' r:id='r2'/></sheets></workbook>",
	    0};
	static const struct part B = {"xl/worksheets/b.xml",
	    "<worksheet xmlns='" XLSX_MAIN "'><sheetData><row><c><v>1</v></c>"
	    "</row></sheetData></worksheet>",
	    0};
	expect(PARTS(TWO, XLSX_RELATIONS(""), B,
		   XLSX_SHEET("<row>" CELL("EWW1", "><v>1</v>") "</row>")),
	    "B: A1#1", "sheet Log is not read: too many columns");
	expect(
	    PARTS(ODS_CONTENT("",
		ODS_TABLE(
		    "<table:table-row "
		    "table:number-rows-repeated='1048576'>" ODS_CELL(
			"table:number-columns-repeated='16384' " VALUE("float",
			    "2")) "</table:table-row>") "<table:table "
							"table:name='B'><"
							"table:table-"
							"row>" ODS_CELL(VALUE(
							    "float",
							    "2")) "</"
								  "table:"
								  "table-"
								  "row></"
								  "table:"
								  "table>")),
	    "B: A1#2", "sheet May is not read: too many columns");
}

static void
damaged_workbooks_are_refused(void **state)
{
	(void)state;
	refuse(SHEET("<row>" CELL("A1", " t='s'><v>7</v>") "</row>"),
	    "sheet1.xml: row 1 has a text that is not there");
	refuse(SHEET("<row><c><v>1</v></row>"), "sheet1.xml: mismatched tag");
	refuse(SHEET("<row/>"), "an empty workbook");
	refuse(PARTS(XLSX_WORKBOOK("")), "workbook.xml.rels is missing");
	refuse(PARTS(XLSX_WORKBOOK(""), XLSX_RELATIONS("")),
	    "xl/worksheets/sheet1.xml is missing");
	refuse(PARTS({"a.txt", "a", 0}), "got a zip archive");
	refuse(PARTS({"xl/workbook.bin", "a", 0}), "got .xlsb");
	refuse(PARTS({"content.xml", "garbage", 0}), "content.xml: ");
	refuse(PARTS({"content.xml", "garbage", 0},
		   {"META-INF/manifest.xml", "<a><encryption-data/></a>", 0}),
	    "without a password");
	refuse(PARTS({"encrypted-package", "x", 0}), "without a password");
	refuse(PARTS(XLSX_RELATIONS(""),
		   {"xl/workbook.xml",
		       "<!DOCTYPE a [<!ENTITY b 'bbbbbbbb'><!ENTITY c "
		       "'&b;&b;&b;&b;&b;&b;'>]><workbook>&c;</workbook>",
		       0}),
	    "it has a document type");
}

static void
bombs_are_refused(void **state)
{
	(void)state;
	enum { N = 60 * 1000 * 1000, DEPTH = 200000 };
	char *bytes = xcalloc(N + 1, 1);
	memset(bytes, ' ', N);
	struct part bomb = {"xl/workbook.xml", bytes, N};
	refuse(PARTS(bomb), "more than 50 MB unpacked");
	for (size_t i = 0; i < DEPTH; i++)
		memcpy(bytes + 3 * i, "<a>", 3);
	bomb.n = 3 * (size_t)DEPTH;
	refuse(PARTS(bomb), "too deep");
	/* One text for each of many cells. */
	char *cells = xstrdup("");
	for (int i = 1; i <= 1900; i++)
		xappend(&cells, "<row r='%d'><c t='s'><v>0</v></c></row>", i);
	char *sheet = xasprintf("<worksheet xmlns='" XLSX_MAIN
				"'><sheetData>%s</sheetData></worksheet>",
	    cells);
	memset(bytes, 'x', 32000);
	bytes[32000] = '\0';
	char *text = xasprintf("<sst><si><t>%s</t></si></sst>", bytes);
	struct part parts[] = {XLSX_WORKBOOK(""), XLSX_RELATIONS(""),
	    {"xl/worksheets/sheet1.xml", sheet, 0},
	    {"xl/sharedStrings.xml", text, 0}, {NULL, NULL, 0}};
	refuse(parts, "expected a sheet with sieves");
	free(text);
	free(sheet);
	free(cells);
	free(bytes);
}

/* Whatever is cut off or changed, there is a sheet or one fault. */
static void
every_prefix_and_change_is_read_or_refused(void **state)
{
	(void)state;
	put_parts(SHEET("<row>" SAY("A1", "size_mm") "</row>"));
	FILE *in = fopen(BOOK, "rb");
	char bytes[4096];
	size_t n = fread(bytes, 1, sizeof bytes, in);
	fclose(in);
	for (size_t i = 0; i < 3 * n; i++) {
		struct error_list errors = {0};
		struct source source;
		size_t at = i % n;
		char was = bytes[at];
		if (i >= n)
			bytes[at] = (char)(was ^ (i < 2 * n ? 1 : 0x80));
		FILE *out = fopen(BOOK, "wb");
		fwrite(bytes, 1, i < n ? i : n, out);
		fclose(out);
		bytes[at] = was;
		bool good = source_read_sheets(BOOK, &errors, &source);
		assert_int_equal(errors.n, good ? 0 : 1);
		assert_true(good || errors.item[0].kind == ERROR_DATA);
		source_free(&source);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(cells_of_excel_are_read),
	    cmocka_unit_test(numbers_are_what_their_formats_show),
	    cmocka_unit_test(formats_are_told_apart),
	    cmocka_unit_test(serials_become_dates),
	    cmocka_unit_test(hidden_and_unsolved_things_are_told),
	    cmocka_unit_test(cells_of_libreoffice_are_read),
	    cmocka_unit_test(remarks_are_rows_that_begin_with_a_cross),
	    cmocka_unit_test(workbooks_are_sites),
	    cmocka_unit_test(sheets_beyond_the_limits_are_left_out),
	    cmocka_unit_test(damaged_workbooks_are_refused),
	    cmocka_unit_test(bombs_are_refused),
	    cmocka_unit_test(every_prefix_and_change_is_read_or_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
