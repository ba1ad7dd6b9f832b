/* Dates and times of day as sheets and people write them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_DATETIME_H
#define TIPSPEED_IO_CELLS_DATETIME_H

#include <stdbool.h>

/* Which of two numbers of a date is the day; MOMENT_OPEN: the text does not
 * show it. */
enum moment_order { MOMENT_OPEN, MOMENT_DAY_FIRST, MOMENT_MONTH_FIRST };

/* A date, a time of day, or both.  order: MOMENT_OPEN if day and month could be
 * swapped, as in 5/3/2026; another value if the date is written in this form
 * but is valid in one order only (25/3/2026).  plain: the form allows one order
 * only.  seconds: since midnight. */
struct moment {
	bool has_date, has_time, has_zone, plain;
	enum moment_order order;
	int year, month, day;
	double seconds;
};

/* Reads a whole text, such as "2026-05-03T10:15", "03.05.2026 10:15:00",
 * "5/3/2026 10:15 AM", "3 May 2026", "10:15".  False if it is none of these, or
 * no valid date (31.4.2026, years of two digits). */
bool moment_read(const char *text, struct moment *m);

/* Returns the seconds since the beginning of 1970 in local time without zones.
 * A moment whose order is open is read in the order given.  NAN if the result
 * is no date. */
double moment_seconds(const struct moment *m, enum moment_order order);

/* moment_text returns "2026-05-03 10:15", moment_clock "10:15" without the day;
 * both add the seconds if they are not zero.  The caller frees. */
char *moment_text(double seconds);
char *moment_clock(double seconds);

/* True if a text is a day of any year in the form "2026-05-03", and no
 * other. */
bool moment_is_day(const char *text);

/* Returns the day that many days after 1970-01-01, "2026-05-03", up to the year
 * 9999. */
char *moment_day(long days);

/* Returns today, "2026-05-03", in local time; or the day of SOURCE_DATE_EPOCH
 * if that is set, so that output is reproducible.  The caller frees. */
char *moment_today(void);

#endif
