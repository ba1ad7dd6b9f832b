/* How a spreadsheet shows a number: as one, as per cent, as a date.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_CELL_FORMAT_H
#define TIPSPEED_IO_CELLS_CELL_FORMAT_H

#include <stdbool.h>

/* unit of a number: "%", or text that its format adds, "m/s", or "".
 * SHOWN_SPAN: hours beyond 24 count on. */
enum shown_kind { SHOWN_NUMBER, SHOWN_DATE, SHOWN_TIME, SHOWN_SPAN };
struct shown {
	enum shown_kind kind;
	char unit[16];
};

/* The meaning of a format's code, as files have it in any language: "0.0%",
 * "yyyy\-mm\-dd", "0\" m/s\"".  Only the part before the first ; counts. */
struct shown shown_code(const char *code);

/* The same of a format that has a number only.  Source: ECMA-376 part 1,
 * 18.8.30, numFmt; 27 to 36 and 50 to 58 are dates of East Asian languages. */
struct shown shown_builtin(unsigned id);

/* Writes "2026-05-03", "2026-05-03T10:15" or, for a time, "10:15", with seconds
 * where there are any.  serial: days since 1899-12-30, or 1904-01-01.  False
 * before the first of those and from the year 10000 on. */
bool shown_date(
    double serial, bool from_1904, enum shown_kind kind, char text[static 32]);

#endif
