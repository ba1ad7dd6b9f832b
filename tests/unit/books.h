/* Workbooks made part by part.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_BOOKS_H
#define TIPSPEED_TESTS_BOOKS_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <zip.h>

/* A part of a workbook; ends a list with a name of NULL.  n 0: a string. */
struct part {
	const char *name, *bytes;
	size_t n;
};

#define XLSX_MAIN "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
#define OFFICE "http://schemas.openxmlformats.org/officeDocument/2006/"
#define XLSX_RELATIONS(more)                                                   \
	{                                                                      \
		"xl/_rels/workbook.xml.rels",                                  \
		    "<Relationships><Relationship Id='r1' Type='" OFFICE       \
		    "relationships/worksheet' "                                \
		    "Target='worksheets/sheet1.xml'/>"                         \
		    "<Relationship Id='r2' Type='" OFFICE                      \
		    "relationships/worksheet' Target='/xl/worksheets/b.xml'/>" \
		    "<Relationship Id='r3' Type='" OFFICE                      \
		    "relationships/chartsheet' "                               \
		    "Target='c.xml'/></Relationships>" more,                   \
		    0                                                          \
	}
#define XLSX_WORKBOOK(more)                                            \
	{                                                              \
		"xl/workbook.xml",                                     \
		    "<workbook xmlns='" XLSX_MAIN "' xmlns:r='" OFFICE \
		    "relationships'>" more                             \
		    "<sheets><sheet name='May' sheetId='1' "           \
		    "r:id='r1'/></sheets></workbook>",                 \
		    0                                                  \
	}
#define XLSX_SHEET(rows)                                                \
	{                                                               \
		"xl/worksheets/sheet1.xml",                             \
		    "<worksheet xmlns='" XLSX_MAIN "'><sheetData>" rows \
		    "</sheetData></worksheet>",                         \
		    0                                                   \
	}

#define ODS_NAMES                                                          \
	"xmlns:office='urn:oasis:names:tc:opendocument:xmlns:office:1.0' " \
	"xmlns:style='urn:oasis:names:tc:opendocument:xmlns:style:1.0' "   \
	"xmlns:text='urn:oasis:names:tc:opendocument:xmlns:text:1.0' "     \
	"xmlns:table='urn:oasis:names:tc:opendocument:xmlns:table:1.0' "   \
	"xmlns:calcext='urn:org:documentfoundation:names:experimental:"    \
	"calc:xmlns:calcext:1.0'"
#define ODS_CONTENT(styles, tables)                           \
	{                                                     \
		"content.xml",                                \
		    "<office:document-content " ODS_NAMES     \
		    "><office:automatic-styles>" styles       \
		    "</office:automatic-styles><office:body>" \
		    "<office:spreadsheet>" tables             \
		    "</office:spreadsheet></office:body>"     \
		    "</office:document-content>",             \
		    0                                         \
	}
#define ODS_TABLE(rows) "<table:table table:name='May'>" rows "</table:table>"

/* False where the file cannot be written. */
static inline bool
put_book(const char *path, const struct part *part)
{
	int code;
	zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, &code);
	bool good = zip != NULL;
	for (; good && part->name != NULL; part++) {
		size_t n = part->n > 0 ? part->n : strlen(part->bytes);
		zip_source_t *source =
		    zip_source_buffer(zip, part->bytes, n, 0);
		good = source != NULL && zip_file_add(zip, part->name, source,
					     ZIP_FL_OVERWRITE) >= 0;
	}
	return zip != NULL && zip_close(zip) == 0 && good;
}

#endif
