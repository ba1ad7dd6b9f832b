/* Dates and times of day in the forms found in sheets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_DATETIME_H
#define TIPSPEED_IO_CELLS_DATETIME_H

#include <stdbool.h>

/* Which of two numbers in a date is the day.  DATETIME_OPEN: the text does not
 * show it. */
enum datetime_order { DATETIME_OPEN, DATETIME_DAY_FIRST, DATETIME_MONTH_FIRST };

/* A date, a time of day, or both.  order: DATETIME_OPEN if day and month could
 * be swapped, as in 5/3/2026; another value if the date has this form but is
 * valid in only one order (25/3/2026).  plain: the form allows only one order.
 * seconds: since midnight. */
struct datetime {
	bool has_date, has_time, has_zone, plain;
	enum datetime_order order;
	int year, month, day;
	double seconds;
};

/* Reads a whole text, such as "2026-05-03T10:15", "03.05.2026 10:15:00",
 * "5/3/2026 10:15 AM", "3 May 2026", "10:15".  Returns false for any other form
 * and for an invalid date (31.4.2026, two-digit years). */
bool datetime_parse(const char *text, struct datetime *m);

/* Returns the seconds since the beginning of 1970, in local time without time
 * zones, or NAN if the date is invalid.  A moment whose order is open is read
 * in the given order. */
double datetime_seconds_since_1970(
    const struct datetime *m, enum datetime_order order);

/* Returns the midnight at which the day of a moment begins. */
double datetime_start_of_day(double seconds);

/* datetime_to_text returns "2026-05-03 10:15", datetime_time_of_day_text
 * "10:15"; both add the seconds if not zero.  The caller frees the result. */
char *datetime_to_text(double seconds);
char *datetime_time_of_day_text(double seconds);

/* True if a text is a date of the form "2026-05-03". */
bool datetime_is_iso_date(const char *text);

/* Returns the date that many days after 1970-01-01, "2026-05-03", up to the
 * year 9999. */
char *datetime_date_from_days(long days);

/* Returns today's date in local time, "2026-05-03", or the date of
 * SOURCE_DATE_EPOCH if that is set, for reproducible output.  The caller frees
 * it. */
char *datetime_today(void);

/* True for a day in words, as sheets are called: "4 May", "Mai 4, 2026". */
bool datetime_is_day_in_words(const char *text);

#endif
