/* On which days the cuts of a sheet were taken, where its dates leave open
 * which number is the day.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_CUT_DAY_H
#define TIPSPEED_CMD_SHEETS_CUT_DAY_H

#include "core/psd/site.h"
#include "io/cells/datetime.h"

/* order: how dates are read that leave it open; why: how that is known, for
 * people, or NULL.  now: it follows from today's date. */
struct cut_day {
	enum datetime_order order;
	const char *why;
	bool now;
};

/* Finds the order of day and month in the dates of cuts: as their other dates
 * show it, else those of the site that they are added to, else today, which no
 * cut is taken after. */
struct cut_day cut_day_find_date_order(
    const struct site *cuts, const struct site *site);

/* Returns a moment as "2026-05-03" or "2026-05-03 10:15", or NULL if the order
 * leaves it open.  The caller frees it. */
char *cut_day_text(const struct datetime *m, enum datetime_order order);

#endif
