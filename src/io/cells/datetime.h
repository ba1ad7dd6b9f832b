/* Dates and times of day in the forms found in sheets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_DATETIME_H
#define TIPSPEED_IO_CELLS_DATETIME_H

#include <stdbool.h>

/* Which of the first two numbers in a date is the day.  DATETIME_OPEN: the text
 * does not show it. */
enum datetime_order { DATETIME_OPEN, DATETIME_DAY_FIRST, DATETIME_MONTH_FIRST };

/* A date, a time of day, or both.  plain: the date's form allows only one
 * order, as 2026-05-03 does.  order: for other forms, DATETIME_OPEN if day and
 * month could be swapped, as in 5/3/2026, or else the only order in which the
 * date is valid (25/3/2026).  seconds: since midnight. */
struct datetime {
	bool has_date, has_time, has_zone, plain;
	enum datetime_order order;
	int year, month, day;
	double seconds;
};

/* Parses a whole text, such as "2026-05-03T10:15", "03.05.2026 10:15:00",
 * "5/3/2026 10:15 AM", "3 May 2026", "10:15".  Returns false for any other form
 * and for an invalid date (31.4.2026).  A year has four digits, but may have
 * two after the name of a month. */
bool datetime_parse(const char *text, struct datetime *m);

/* Returns the seconds since the beginning of 1970, ignoring time zones.  order:
 * how to read a date whose own order is open.  Returns NAN if there is no date,
 * or not a valid one in that order. */
double datetime_seconds_since_1970(
    const struct datetime *m, enum datetime_order order);

/* Returns the last midnight at or before a moment.  Both are in seconds since
 * some midnight, such as that of 1970. */
double datetime_start_of_day(double seconds);

/* Return a moment, in seconds since 1970, as "2026-05-03 10:15", or its time of
 * day as "10:15".  Both add the seconds if they are not zero.  The caller frees
 * the text. */
char *datetime_to_text(double seconds);
char *datetime_time_of_day_text(double seconds);

/* True if a text is a date of the form "2026-05-03". */
bool datetime_is_iso_date(const char *text);

/* Returns the date that many days after 1970-01-01, as "2026-05-03"; the year
 * is at most 9999.  The caller frees it. */
char *datetime_date_text_from_days(long days);

/* Returns today's date in local time, "2026-05-03", or the date of
 * SOURCE_DATE_EPOCH if that is set, for reproducible output.  The caller frees
 * it. */
char *datetime_today_text(void);

/* True for a date with its month in words, such as the name of a sheet: "4
 * May", "Mai 4, 2026". */
bool datetime_is_day_in_words(const char *text);

#endif
