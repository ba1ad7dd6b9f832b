/* Reads logs of a plant's control system: speed, power and feed rate over time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_PLANT_LOG_H
#define TIPSPEED_IO_FORMATS_PLANT_LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "io/cells/datetime.h"

/* The columns of a log: rpm, tip speed in m/s, kW, t/h. */
enum log_column { LOG_RPM, LOG_SPEED, LOG_POWER, LOG_RATE, LOG_COLUMNS };

extern const char *const LOG_UNITS[LOG_COLUMNS];

/* A log.  time [n]: the time of each row, in order, as
 * datetime_seconds_since_1970 returns it.  value [n]: NAN if the log has no
 * number there; NULL if there is no such column.  apart: the usual interval
 * between rows, s.  gap: the longest interval, s; gap_from: its start.  passed:
 * the number of rows skipped because their time could not be read.  read_as:
 * "time in column 1, rpm in 3"; assumed: the parts of it that the log does not
 * state, or "". */
struct plant_log {
	char *path;
	size_t n, passed;
	double *time, *value[LOG_COLUMNS];
	double apart, gap, gap_from;
	char *read_as, *assumed;
	uint64_t digest;
};

/* The files [n] to read as one log, and options.  columns: "1=time, 3=rpm,
 * 4=kW", or NULL.  sheet: the sheet of a workbook, or NULL.  decimal: the
 * decimal sign, or '\0'.  order: how to read dates such as 5/3/2026, or
 * DATETIME_OPEN. */
struct log_request {
	size_t n;
	const char *const *path;
	const char *columns, *sheet;
	char decimal;
	enum datetime_order order;
};

/* Reads a log.  On failure, returns NULL and adds faults to errors; *open
 * becomes true if only the order of day and month is unclear. */
struct plant_log *plant_log_read(
    const struct log_request *request, struct error_list *errors, bool *open);
void plant_log_free(struct plant_log *log);

/* The median and range of each column, and the number of rows, from one time to
 * another, inclusive; NAN if there are no numbers. */
struct log_window {
	size_t n;
	double median[LOG_COLUMNS], least[LOG_COLUMNS], most[LOG_COLUMNS];
};
struct log_window plant_log_summarise_window(
    const struct plant_log *log, double from, double to);

#endif
