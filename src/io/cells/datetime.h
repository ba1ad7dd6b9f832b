/* Dates and times of day as sheets and people write them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_DATETIME_H
#define TIPSPEED_IO_CELLS_DATETIME_H

#include <stdbool.h>

/* Which of two numbers of a date is the day, where the text leaves it open. */
enum moment_order { MOMENT_OPEN, MOMENT_DAY_FIRST, MOMENT_MONTH_FIRST };

/* A date, a time of day, or both.  order: MOMENT_OPEN where day and month may
 * be the other way round, as in 5/3/2026; another one where it has this form
 * and only that order is a date (25/3/2026).  plain: the form has one order.
 * seconds: since midnight. */
struct moment {
	bool has_date, has_time, has_zone, plain;
	enum moment_order order;
	int year, month, day;
	double seconds;
};

/* Reads all of a text, such as "2026-05-03T10:15", "03.05.2026 10:15:00",
 * "5/3/2026 10:15 AM", "3 May 2026", "10:15".  False where it is none of these,
 * or no valid date (31.4.2026, years of two digits). */
bool moment_read(const char *text, struct moment *m);

/* Seconds since the beginning of 1970 in local time without zones; a moment
 * whose order is open is read in the order given.  NAN where that is no
 * date. */
double moment_seconds(const struct moment *m, enum moment_order order);

/* "2026-05-03 10:15", with the seconds where there are some; "10:15" without
 * the day.  The caller frees. */
char *moment_text(double seconds);
char *moment_clock(double seconds);

/* Whether a text is a day in this one form, "2026-05-03", of any year. */
bool moment_is_day(const char *text);

/* The day so many days after 1970-01-01, "2026-05-03", to the year 9999. */
char *moment_day(long days);

/* Today, "2026-05-03", in local time; or the day of SOURCE_DATE_EPOCH, where
 * that is set, so that output is reproducible.  The caller frees. */
char *moment_today(void);

#endif
