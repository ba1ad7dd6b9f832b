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

/* Rows [n] in order of time, see datetime_seconds_since_1970.  value [n]: NAN
 * if the log has no number there; NULL: no such column.  apart: usual interval
 * between rows, s.  gap: longest interval, s; gap_from: its start.  passed:
 * number of rows skipped because their time could not be read.  read_as: "time
 * in column 1, rpm in 3"; assumed: the parts of read_as that the log does not
 * state, or
 * "". */
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
 * decimal sign, or '\0'. */
struct log_request {
	size_t n;
	const char *const *path;
	const char *columns, *sheet;
	char decimal;
	enum datetime_order order;
};

/* Reads a log.  Returns NULL and faults if that fails; *open is set if only the
 * order of day and month is open. */
struct plant_log *plant_log_read(
    const struct log_request *request, struct error_list *errors, bool *open);
void plant_log_free(struct plant_log *log);

/* Medians and ranges of the rows from one time to another, inclusive; NAN if
 * there are no numbers. */
struct log_window {
	size_t n;
	double median[LOG_COLUMNS], least[LOG_COLUMNS], most[LOG_COLUMNS];
};
struct log_window plant_log_summarise_window(
    const struct plant_log *log, double from, double to);

/* Returns the row nearest to a time. */
size_t plant_log_row_nearest_time(const struct plant_log *log, double time);

#endif
