/* Loads a log, describes it, and takes the median of its rows around a time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/log.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/sheets/ask_user.h"
#include "cmd/session/journal.h"
#include "cmd/lang/table.h"
#include "io/sitefile/column_header.h"

/* Returns "1180 to 1420". */
static char *
number_range_text(double least, double most)
{
	return most > least ? xasprintf(tr("%.4g to %.4g"), least, most)
			    : xasprintf("%.4g", least);
}

static char *
time_range_text(double from, double to)
{
	FREED char *a = datetime_to_text(from);
	FREED char *b = datetime_start_of_day(from) == datetime_start_of_day(to)
			    ? datetime_time_of_day_text(to)
			    : datetime_to_text(to);
	return xasprintf(tr("%s to %s"), a, b);
}

/* Returns "rpm 1180 to 1420, kW 150 to 210". */
static char *
plant_log_value_ranges_text(const struct plant_log *log)
{
	struct log_window all = plant_log_summarise_window(
	    log, log->time[0], log->time[log->n - 1]);
	char *text = xstrdup("");
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		if (log->value[k] == NULL)
			continue;
		FREED char *range =
		    number_range_text(all.least[k], all.most[k]);
		xappend_to_list(&text, ", ", "%s %s", LOG_UNITS[k], range);
	}
	return text;
}

/* Returns the longest gap, or NULL unless it is worth reporting: longer than
 * ten rows and longer than five minutes. */
static char *
long_gap_text(const struct plant_log *log)
{
	return log->gap > 10 * log->apart && log->gap > 300
		   ? time_range_text(log->gap_from, log->gap_from + log->gap)
		   : NULL;
}

static void
note_plant_log_contents(struct session *s, const struct plant_log *log)
{
	size_t n = log->n;
	FREED char *rows =
	    n < 1000 ? xasprintf(tr_n("%zu row", "%zu rows", n), n)
		     : xasprintf(tr("%zu,%03zu rows"), n / 1000, n % 1000);
	FREED char *all = plant_log_value_ranges_text(log);
	FREED char *span = time_range_text(log->time[0], log->time[log->n - 1]);
	session_print_note(s, "log: %s from %s, %s", rows, span, all);
	session_print_note(s, "  read: %s", log->read_as);
	if (log->assumed[0] != '\0')
		session_print_note(s, "  likely, not stated: %s", log->assumed);
	if (log->passed > 0)
		session_print_note(
		    s, "  not read: %zu rows without a time", log->passed);
	FREED char *gap = long_gap_text(log);
	if (gap != NULL)
		session_print_note(s, "  the longest gap: %s", gap);
}

static void
add_plant_log_load_to_journal(
    struct session *s, const struct log_request *q, const struct plant_log *log)
{
	const struct site_request of = {.n = q->n,
	    .path = q->path,
	    .columns = q->columns,
	    .sheet = q->sheet,
	    .decimal = q->decimal};
	FREED char *line = journal_load_command_text(log->digest, &of);
	FREED char *options = site_request_options_text(&of);
	journal_add_line(s, NULL, "%s as=log%s%s", line, options,
	    q->order == DATETIME_OPEN        ? ""
	    : q->order == DATETIME_DAY_FIRST ? " dates=day-first"
					     : " dates=month-first");
}

static struct plant_log *
read_log_or_ask_user(
    struct session *s, struct log_request *q, struct error *error)
{
	for (;;) {
		struct error_list errors = {.stop = s->hooks.stop};
		bool open, month;
		struct plant_log *log = plant_log_read(q, &errors, &open);
		if (log != NULL)
			return log;
		if (!open || q->order != DATETIME_OPEN ||
		    !ask_date_order(s, &errors.item[0], &month)) {
			session_report_file_faults(
			    s, q->path[0], &errors, error);
			return NULL;
		}
		q->order = month ? DATETIME_MONTH_FIRST : DATETIME_DAY_FIRST;
	}
}

static bool
check_log_digest(
    const struct plant_log *log, const char *digest, struct error *e)
{
	FREED char *found = xasprintf("%016" PRIx64, log->digest);
	bool good = digest == NULL || strcmp(digest, found) == 0;
	if (!good)
		error_set_at(e, ERROR_DATA, log->path, 0, 0,
		    "expected a log with digest %s, got %s: its numbers have "
		    "changed\n"
		    "leave out digest= to load it anyway; results will change",
		    digest, found);
	return good;
}

bool
log_load_plant_log(
    struct session *s, const struct args *args, struct error *error)
{
	struct log_request q = {.n = args->n_operand,
	    .path = args->operand,
	    .columns = args->columns,
	    .sheet = args->sheet};
	if (args_is_given(args, &args->decimal))
		q.decimal = args->decimal == 1 ? ',' : '.';
	if (args_is_given(args, &args->dates))
		q.order = args->dates == 0 ? DATETIME_DAY_FIRST
					   : DATETIME_MONTH_FIRST;
	for (size_t i = 0; i < q.n; i++)
		files_record_read(s, q.path[i]);
	struct plant_log *log = read_log_or_ask_user(s, &q, error);
	if (log == NULL)
		return false;
	s->logs = xrealloc(s->logs, s->n_log + 1, sizeof(*s->logs));
	s->logs[s->n_log++] = log;
	if (!check_log_digest(log, args->digest, error))
		return false;
	if (s->log != NULL)
		session_print_note(s, "replaced the log loaded earlier");
	s->log = log;
	note_plant_log_contents(s, log);
	add_plant_log_load_to_journal(s, &q, log);
	return true;
}

/* Returns the median tip speed of a window, m/s to a tenth, computed from rpm
 * if the log has no tip speeds. */
static double
tip_speed_of_log_window(
    const struct plant_log *log, const struct log_window *w, double rotor)
{
	double v =
	    log->value[LOG_SPEED] != NULL
		? w->median[LOG_SPEED]
		: speed_in_unit_to_mps(w->median[LOG_RPM], SPEED_RPM, rotor);
	return round(10 * v) / 10;
}

/* Reports how the speed was found, and warns if it was not steady. */
static void
note_speed_from_plant_log(struct session *s, const struct plant_log *log,
    double time, double within, double rotor, const struct log_window *w)
{
	const double steady = 0.02;
	enum log_column k = log->value[LOG_SPEED] != NULL ? LOG_SPEED : LOG_RPM;
	FREED char *at = datetime_to_text(time);
	FREED char *span = time_range_text(time - within, time + within);
	FREED char *range = number_range_text(w->least[k], w->most[k]),
		   *more = xstrdup("");
	if (k == LOG_RPM)
		xappend(&more, tr(" = %.1f m/s with a rotor of %g mm"),
		    tip_speed_of_log_window(log, w, rotor), 1000 * rotor);
	for (size_t c = LOG_POWER; c < LOG_COLUMNS; c++)
		if (!isnan(w->median[c]))
			xappend(&more, ", %s %.4g", LOG_UNITS[c], w->median[c]);
	session_print_note(
	    s, "log at %s: %s %.4g%s", at, LOG_UNITS[k], w->median[k], more);
	session_print_note(s,
	    tr_n("  median of %zu row, %s: %s %s",
		"  median of %zu rows, %s: %s %s", w->n),
	    w->n, span, LOG_UNITS[k], range);
	if (w->most[k] - w->least[k] > steady * w->median[k])
		session_print_note(s,
		    "  warning: %s changed from %.4g to %.4g within the "
		    "window: was the rotor steady at the cut?",
		    LOG_UNITS[k], w->least[k], w->most[k]);
}

static bool
set_no_near_log_row_error(const struct plant_log *log, double time,
    double within, struct error *error)
{
	double near = log->time[0];
	for (size_t i = 1; i < log->n; i++)
		if (fabs(log->time[i] - time) < fabs(near - time))
			near = log->time[i];
	FREED char *at = datetime_to_text(time),
		   *nearest = datetime_to_text(near);
	FREED char *span = time_range_text(log->time[0], log->time[log->n - 1]);
	return error_set(error, ERROR_USAGE,
	    "the log has no row within %g minutes of %s; the nearest is at "
	    "%s\nthe log has %s; window= looks further, or give the speed",
	    within / 60, at, nearest, span);
}

bool
log_find_speed_at_time(struct session *s, double time, double within,
    double rotor, struct logged *found, struct error *error)
{
	const struct plant_log *log = s->log;
	if (log == NULL)
		return error_set(error, ERROR_USAGE,
		    "expected a log to look the time up in, got none\n"
		    "load it first: load log.csv as=log; or give the speed: "
		    "add FILE@SPEED");
	bool rpm = log->value[LOG_SPEED] == NULL;
	if (rpm && log->value[LOG_RPM] == NULL)
		return error_set(error, ERROR_USAGE,
		    "expected a log with rpm or m/s, got one without\n"
		    "give the speed: add FILE@SPEED");
	if (rpm && !(rotor > 0))
		return error_set(error, ERROR_USAGE,
		    "the log has rpm: expected the rotor's diameter, got none\n"
		    "write: rotor_mm=DIAMETER, or a line rotor_mm in the site "
		    "file");
	struct log_window w =
	    plant_log_summarise_window(log, time - within, time + within);
	if (w.n == 0)
		return set_no_near_log_row_error(log, time, within, error);
	double v = tip_speed_of_log_window(log, &w, rotor);
	if (!(v >= 1 && v <= SITE_FASTEST)) {
		FREED char *at = datetime_to_text(time);
		return error_set(error, ERROR_USAGE,
		    "expected a running rotor at %s, got %s %.4g\n"
		    "check the time, or give the speed: add FILE@SPEED",
		    at, rpm ? tr("rpm") : "m/s",
		    w.median[rpm ? LOG_RPM : LOG_SPEED]);
	}
	note_speed_from_plant_log(s, log, time, within, rotor, &w);
	*found = (struct logged){v, w.median[LOG_POWER], w.median[LOG_RATE]};
	return true;
}

bool
show_plant_log(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	const struct plant_log *log = s->log;
	if (log == NULL)
		return error_set(error, ERROR_USAGE,
		    "no log is loaded\n"
		    "load one: load log.csv as=log");
	struct answer *r = answer_new("show");
	struct log_window all = plant_log_summarise_window(
	    log, log->time[0], log->time[log->n - 1]);
	FREED char *from = datetime_to_text(log->time[0]);
	FREED char *to = datetime_to_text(log->time[log->n - 1]);
	answer_set_title(r, "the plant's log");
	answer_add_columns(r, "what, value");
	answer_add_name_value_row(r, "file", "%s", log->path);
	answer_add_name_value_row(r, "rows", "%zu", log->n);
	answer_add_name_value_row(r, "from", "%s", from);
	answer_add_name_value_row(r, "to", "%s", to);
	answer_add_name_value_row(r, "seconds between rows", "%g", log->apart);
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		if (log->value[k] == NULL)
			continue;
		FREED char *range =
		    number_range_text(all.least[k], all.most[k]);
		answer_add_name_value_row(
		    r, LOG_UNITS[k], "%s, median %.4g", range, all.median[k]);
	}
	answer_add_name_value_row(r, "read", "%s", log->read_as);
	FREED char *gap = long_gap_text(log);
	if (gap != NULL)
		answer_add_name_value_row(r, "longest gap", "%s", gap);
	return session_show_answer(s, r);
}
