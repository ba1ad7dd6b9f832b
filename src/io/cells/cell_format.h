/* How a spreadsheet shows a number: as a number, a percentage or a date.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_CELL_FORMAT_H
#define TIPSPEED_IO_CELLS_CELL_FORMAT_H

#include <stdbool.h>

/* kind: FORMAT_SPAN is a duration, which may exceed 24 hours.  unit: "%", or
 * the text that the format of a number adds ("m/s"); else "". */
enum cell_format_kind { FORMAT_NUMBER, FORMAT_DATE, FORMAT_TIME, FORMAT_SPAN };
struct cell_format {
	enum cell_format_kind kind;
	char unit[16];
};

/* Returns what a format code means: "0.0%", "yyyy\-mm\-dd", "0\" m/s\"".  The
 * codes are the same in files of all languages.  Only the part before the first
 * ";" counts. */
struct cell_format cell_format_of_code(const char *code);

/* As cell_format_of_code, but for a built-in format, which a file gives only by
 * its number.  Numbers 27 to 36 and 50 to 58 are East Asian date formats.
 * Source: ECMA-376 part 1, 18.8.30, numFmt. */
struct cell_format cell_format_of_builtin_id(unsigned id);

/* Writes "2026-05-03", "2026-05-03T10:15" or, for a time, "10:15", with seconds
 * if they are not zero.  serial: days since 1899-12-30, or since 1904-01-01 if
 * from_1904.  Returns false if serial is negative, or from the year 10000
 * on. */
bool cell_format_serial_to_text(double serial, bool from_1904,
    enum cell_format_kind kind, char text[static 32]);

#endif
