/* Decides which number of a date such as 5/11/2026 is the day.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/cut_day.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/cut.h"

char *
cut_day_text(const struct datetime *m, enum datetime_order order)
{
	double time = datetime_seconds_since_1970(m, order);
	if (isnan(time))
		return NULL;
	char *text = datetime_to_text(time);
	if (!m->has_time)
		text[strcspn(text, " ")] = '\0';
	return text;
}

/* Returns the order in which none of the open dates is after today, if there
 * are any after today in the other. */
static enum datetime_order
date_order_by_today(const struct site *cuts)
{
	FREED char *today = datetime_today();
	struct datetime m, now;
	bool after[2] = {false, false};
	datetime_parse(today, &now);
	double end =
	    datetime_seconds_since_1970(&now, DATETIME_OPEN) + 24 * 3600;
	for (size_t i = 0; i < cuts->n_note; i++) {
		if (!cut_parse_date(&cuts->note[i], &m) || m.plain)
			continue;
		after[0] = after[0] || datetime_seconds_since_1970(
					   &m, DATETIME_DAY_FIRST) >= end;
		after[1] = after[1] || datetime_seconds_since_1970(
					   &m, DATETIME_MONTH_FIRST) >= end;
	}
	if (after[0] == after[1])
		return DATETIME_OPEN;
	return after[0] ? DATETIME_MONTH_FIRST : DATETIME_DAY_FIRST;
}

struct cut_day
cut_day_find_date_order(const struct site *cuts, const struct site *site)
{
	enum datetime_order order = cut_day_month_order(cuts);
	if (order != DATETIME_OPEN)
		return (struct cut_day){
		    order, tr("as its other dates show"), false};
	order = cut_day_month_order(site);
	if (order != DATETIME_OPEN)
		return (struct cut_day){
		    order, tr("as the dates of earlier cuts show"), false};
	order = date_order_by_today(cuts);
	return (struct cut_day){order,
	    order != DATETIME_OPEN
		? tr("as the other way round it is still to come")
		: NULL,
	    order != DATETIME_OPEN};
}
