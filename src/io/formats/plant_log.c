/* Reads a plant's log: finds the column of times first, then the other columns
 * by their headings.  Skips cells that are not numbers, which are common in
 * logs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/plant_log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"
#include "io/cells/number.h"
#include "io/cells/source.h"
#include "io/sitefile/lexicon.h"

const char *const LOG_UNITS[LOG_COLUMNS] = {"rpm", "m/s", "kW", "t/h"};

/* LOOKED_AT: how many rows are searched for dates and times. */
enum { MOST_COLUMNS = 256, MOST_HEADS = 4, LOOKED_AT = 2000 };

/* Words of headings, folded by text_fold_case_and_accents. */
static const char
    POWER[] = "kw power effekt motoreffekt leistung motorleistung "
	      "antriebsleistung wirkleistung puissance potencia potenza teho "
	      "moottoriteho effekten",
    RATE[] = "feedrate throughput tonnage kapacitet produktion durchsatz "
	     "durchsatzleistung aufgabeleistung debit caudal vazao "
	     "kapasiteetti kapasitet",
    SHORT[] = "us stph",
    /* Words for quantities that are not wanted, and for other machines. */
    OTHER[] = "kwh mwh kva kvar factor faktor % hz percent set setpoint sp "
	      "borvarde sollwert limit alarm kwh/t kw/t w/t kwh/ton kw/ton "
	      "water vatten wasser dust damm staub fuel",
    MACHINE[] =
	"feeder matare syotin alimentador alimentateur aufgeber belt band "
	"conveyor transportor forderband fan flakt screen sikt pump a amp",
    TIMES[] = "time tid zeit datum date timestamp datetime zeitstempel "
	      "tidpunkt uhrzeit fecha hora heure data aika pvm klockan";

/* Units of power and rate, and the factors to those of LOG_UNITS. */
static const struct {
	enum log_column kind;
	const char *words;
	double scale;
} UNITS[] = {{LOG_POWER, "kw", 1}, {LOG_POWER, "mw", 1e3},
    {LOG_POWER, "w watt", 1e-3}, {LOG_POWER, "hp bhp", 0.7457},
    {LOG_POWER, "ps hk cv", 0.7355}, {LOG_RATE, "kg/s", 3.6},
    {LOG_RATE, "kg/h", 1e-3}, {LOG_RATE, "t/min", 60},
    {LOG_RATE, "t/d t/day t/dygn tpd", 1. / 24},
    {LOG_RATE, "lb/h lbs/h", 0.00045359237},
    {LOG_RATE,
	"stph t/h tph mtph ton/h tons/h t/tim t/std ton/tim t/hr tn/h mt/h "
	"ton/hr tons/hr tonne/h tonnes/h tonnes/hr ton/hour tons/hour "
	"tonnes/hour ton/timme t/timme t/stunde t/heure t/uur mg/h",
	1}};

/* What a column of a log contains: an enum log_column, or one of these.
 * LEFT_OUT: a power or rate that is not wanted. */
enum kind { NO_KIND = LOG_COLUMNS, LEFT_OUT, TIME };

/* A log being read.  first: the first row of data.  date, clock: the columns of
 * dates and times of day, which may be the same.  kind, head [n_column]: what
 * each column contains, and its heading; scale: the factor of its numbers to
 * the unit of LOG_UNITS.  zone: some times have a time zone. */
struct reading {
	const struct log_request *request;
	struct error_list *errors;
	struct sheet *sheet;
	struct plant_log *log;
	size_t n_column, first, date, clock;
	unsigned kind[MOST_COLUMNS];
	struct head head[MOST_COLUMNS];
	double scale[MOST_COLUMNS];
	enum datetime_order order;
	bool zone;
};

static bool
plant_log_text_has_word(const char *text, const char *words)
{
	static const char BREAKS[] = " ()[],;:_-.\t\n";
	FREED char *folded = text_fold_case_and_accents(text);
	bool found = (words == RATE && strstr(folded, "feed rate") != NULL) ||
		     (words == SHORT && strstr(folded, "short t") != NULL);
	char *next = NULL;
	size_t which;
	for (char *word = strtok_r(folded, BREAKS, &next);
	     word != NULL && !found; word = strtok_r(NULL, BREAKS, &next))
		found = text_find_word_in_list(words, word, &which);
	return found;
}

/* Sets *scale to the factor from the unit of a kind in a heading to that of
 * LOG_UNITS.  Returns false if there is none. */
static bool
plant_log_find_unit(const char *text, enum log_column kind, double *scale)
{
	size_t i = 0;
	while (i < ARRAY_LEN(UNITS) &&
	       (UNITS[i].kind != kind ||
		   !plant_log_text_has_word(text, UNITS[i].words)))
		i++;
	*scale = i < ARRAY_LEN(UNITS) ? UNITS[i].scale : 1;
	if (kind == LOG_RATE && *scale == 1 &&
	    plant_log_text_has_word(text, SHORT))
		*scale = 0.90718474;
	return i < ARRAY_LEN(UNITS);
}

/* Returns what a column contains according to its heading; *scale gets the
 * factor to the unit of LOG_UNITS. */
static unsigned
plant_log_kind_of_heading(
    const char *text, const struct head *head, double *scale)
{
	bool unit = plant_log_find_unit(text, LOG_RATE, scale);
	bool rate = unit || plant_log_text_has_word(text, RATE);
	bool power = plant_log_text_has_word(text, POWER);
	const char *per = strchr(text, '/');
	bool other = !unit && per > text && per[-1] != ' ' &&
		     strcspn(per + 1, " 0123456789") > 0;
	if (plant_log_text_has_word(text, OTHER) || (rate && other) ||
	    (!rate && plant_log_text_has_word(text, MACHINE)))
		return rate || power ? LEFT_OUT : NO_KIND;
	if (rate)
		return LOG_RATE;
	if (power) {
		plant_log_find_unit(text, LOG_POWER, scale);
		return LOG_POWER;
	}
	*scale = 1;
	if (head->unit == SPEED_RPM || (head->means & WORD_RPM) != 0)
		return LOG_RPM;
	if (head->unit != SPEED_NO_UNIT || (head->means & WORD_SPEED) != 0)
		return LOG_SPEED;
	return plant_log_text_has_word(text, TIMES) ? TIME : NO_KIND;
}

static bool
parse_date_or_time_cell(
    const struct reading *r, size_t row, size_t column, struct datetime *m)
{
	struct cell cell = row_cell_at(&r->sheet->row[row], column);
	return cell.text[0] != '\0' && datetime_parse(cell.text, m);
}

/* Finds the column with the most dates, the one with the most times of day
 * without a date, and the first row of data.  Returns false with a fault if
 * there are none. */
static bool
find_time_columns(struct reading *r)
{
	size_t dates[MOST_COLUMNS] = {0}, clocks[MOST_COLUMNS] = {0}, full = 0;
	size_t n = r->sheet->n_row < LOOKED_AT ? r->sheet->n_row : LOOKED_AT;
	struct datetime m;
	for (size_t i = 0; i < n; i++)
		for (size_t c = 0; c < r->sheet->row[i].n; c++)
			if (parse_date_or_time_cell(r, i, c, &m)) {
				if (r->sheet->row[i].n > r->n_column)
					r->n_column = r->sheet->row[i].n;
				dates[c] += m.has_date;
				clocks[c] += !m.has_date;
			}
	for (size_t c = 0; c < r->n_column; c++) {
		r->date = dates[c] > dates[r->date] ? c : r->date;
		r->clock = clocks[c] > clocks[r->clock] ? c : r->clock;
	}
	for (r->first = 0; r->first < n; r->first++)
		if (parse_date_or_time_cell(r, r->first, r->date, &m) &&
		    m.has_date)
			break;
	for (size_t i = r->first; i < n; i++)
		full +=
		    parse_date_or_time_cell(r, i, r->date, &m) && m.has_time;
	if (full > 0)
		r->clock = r->date;
	struct cell top = {.line = 1, .column = 1, .text = NULL};
	if (dates[r->date] == 0)
		return sheet_report_fault(r->sheet, top,
		    "expected a log with a column of dates and times, got "
		    "none\n"
		    "write times as 2026-05-03 10:15; a sieve sheet is loaded "
		    "without as=log");
	if (full == 0 && clocks[r->clock] == 0)
		return sheet_report_fault(r->sheet,
		    row_cell_at(&r->sheet->row[r->first], r->date),
		    "expected times of day with the dates, got none\n"
		    "a log needs the time of each row: 2026-05-03 10:15");
	return true;
}

/* Returns the words above a column.  Lines with a single cell are left out, as
 * they are titles, except the line above the data, which may be of units. */
static char *
plant_log_column_heading(const struct reading *r, size_t c)
{
	char *text = xstrdup("");
	size_t from = r->first > MOST_HEADS ? r->first - MOST_HEADS : 0;
	for (size_t i = from; i < r->first; i++) {
		const struct row *row = &r->sheet->row[i];
		const char *cell = row_cell_at(row, c).text;
		size_t filled = 0;
		for (size_t k = 0; k < row->n; k++)
			filled += row->cell[k].text[0] != '\0';
		bool title = filled < 2 && i + 1 < r->first;
		if (!title && cell[0] != '\0')
			xappend_to_list(&text, " ", "%s", cell);
	}
	return text;
}

/* Takes the kinds of columns from columns=, "1=time, 3=rpm, 4=kW". */
static bool
parse_columns_option(struct reading *r, const char *columns)
{
	bool good = true;
	FREED char *copy = xstrdup(columns);
	char *save = NULL;
	for (size_t c = 0; c < r->n_column; c++)
		r->kind[c] = NO_KIND;
	for (char *part = strtok_r(copy, ",", &save); part != NULL && good;
	     part = strtok_r(NULL, ",", &save)) {
		char *end;
		unsigned long number = strtoul(part, &end, 10);
		size_t c = number - 1;
		good = c < r->n_column && *end == '=';
		if (!good)
			break;
		r->head[c] = heading_parse(end + 1);
		r->kind[c] = plant_log_kind_of_heading(
		    end + 1, &r->head[c], &r->scale[c]);
		good = r->kind[c] < LOG_COLUMNS || r->kind[c] == TIME;
	}
	if (!good)
		error_set(error_list_add_item(r->errors), ERROR_USAGE,
		    "expected NUMBER=WHAT in columns, got '%s'\n"
		    "for instance: columns=\"1=time, 2=rpm, 3=kW, 4=t/h\"",
		    columns);
	return good;
}

/* If there are several columns of a kind, keeps the only one that names the
 * rotor; without such a one, reports them. */
static bool
choose_rotor_column_of_kind(struct reading *r, unsigned kind)
{
	size_t n = 0, rotors = 0, last = 0;
	for (size_t c = 0; c < r->n_column; c++) {
		if (r->kind[c] != kind)
			continue;
		n++;
		last = c;
		rotors += (r->head[c].means & WORD_ROTOR) != 0;
	}
	bool told = r->request->columns != NULL;
	for (size_t c = 0; c < r->n_column && rotors == 1 && !told; c++)
		if (r->kind[c] == kind && (r->head[c].means & WORD_ROTOR) == 0)
			r->kind[c] = NO_KIND;
	if (n < 2 || told || rotors == 1)
		return true;
	size_t head = r->first > 0 ? r->first - 1 : 0;
	return sheet_report_fault(r->sheet,
	    row_cell_at(&r->sheet->row[head], last),
	    "expected one column of %s, got %zu\n"
	    "name the columns to read: load %s as=log columns=\"%zu=time, "
	    "%zu=%s, ..\"; two of kW are added up",
	    LOG_UNITS[kind], n, r->sheet->path, r->date + 1, last + 1,
	    LOG_UNITS[kind]);
}

/* Takes a speed without a unit for rpm if it is 400 or more on average, which
 * no tip speed is, in m/s; otherwise reports it. */
static bool
guess_speed_unit_by_magnitude(struct reading *r, size_t c)
{
	double sum = 0, v;
	size_t n = 0;
	if (r->kind[c] != LOG_SPEED || r->head[c].unit != SPEED_NO_UNIT)
		return true;
	for (size_t i = r->first; i < r->sheet->n_row; i++)
		if (number_value_of_cell(
			row_cell_at(&r->sheet->row[i], c), &v) &&
		    v > 0) {
			sum += v;
			n++;
		}
	if (n == 0 || sum / (double)n < 400)
		return sheet_report_fault(r->sheet,
		    row_cell_at(&r->sheet->row[r->first], c),
		    "expected a speed in rpm or m/s, got numbers without a "
		    "unit\n"
		    "say which: load %s as=log columns=\"%zu=time, %zu=m/s, "
		    "..\"",
		    r->sheet->path, r->date + 1, c + 1);
	r->kind[c] = LOG_RPM;
	xappend_to_list(&r->log->assumed, "; ", tr("column %zu in rpm"), c + 1);
	return true;
}

static bool
plant_log_find_column_kinds(struct reading *r)
{
	for (size_t c = 0; c < r->n_column; c++) {
		FREED char *text = plant_log_column_heading(r, c);
		r->head[c] = heading_parse(text);
		r->kind[c] =
		    plant_log_kind_of_heading(text, &r->head[c], &r->scale[c]);
		if (c == r->date || c == r->clock)
			r->kind[c] = TIME;
	}
	const char *columns = r->request->columns;
	if (columns != NULL && !parse_columns_option(r, columns))
		return false;
	bool good = true, any = false;
	for (size_t c = 0; c < r->n_column && good; c++) {
		good = guess_speed_unit_by_magnitude(r, c);
		any = any || r->kind[c] < LOG_COLUMNS;
	}
	for (unsigned k = 0; k < LOG_COLUMNS && good; k++)
		good = choose_rotor_column_of_kind(r, k);
	if (!any && good)
		return sheet_report_fault(r->sheet,
		    row_cell_at(&r->sheet->row[r->first > 0 ? r->first - 1 : 0],
			r->date),
		    "expected headings that name rpm, m/s, kW or t/h, got none "
		    "that does\nname the columns: load %s as=log "
		    "columns=\"%zu=time, 2=rpm, ..\"",
		    r->sheet->path, r->date + 1);
	return good;
}

/* Decides whether 5/3/2026 is in May or in March, by other dates that are valid
 * in one order only. */
static bool
find_day_month_order(struct reading *r, bool *open)
{
	struct datetime m;
	struct cell other = {.text = NULL}, undecided = {.text = NULL};
	r->order = r->request->order;
	for (size_t i = r->first;
	     i < r->sheet->n_row && !error_is_stop_requested(r->errors); i++) {
		if (!parse_date_or_time_cell(r, i, r->date, &m) || m.plain)
			continue;
		if (m.order == DATETIME_OPEN)
			undecided = row_cell_at(&r->sheet->row[i], r->date);
		else if (r->order == DATETIME_OPEN)
			r->order = m.order;
		else if (m.order != r->order)
			other = row_cell_at(&r->sheet->row[i], r->date);
	}
	if (other.text != NULL)
		return sheet_report_fault(r->sheet, other,
		    "expected dates with the %s first, got %s\n"
		    "write dates as 2026-05-03",
		    r->order == DATETIME_DAY_FIRST ? tr("day") : tr("month"),
		    other.text);
	if (undecided.text == NULL || r->order != DATETIME_OPEN)
		return true;
	*open = true;
	return sheet_report_fault(r->sheet, undecided,
	    "expected dates that can be read in one way, got %s: day or month "
	    "first?\n"
	    "say which: load %s as=log dates=day-first, or month-first",
	    undecided.text, r->sheet->path);
}

/* Adds a row, with the sum of several columns of one kind. */
static void
add_plant_log_row(struct reading *r, double time, const struct row *row)
{
	struct plant_log *log = r->log;
	log->time = xgrow_by_one(log->time, log->n, sizeof *log->time);
	log->time[log->n] = time;
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		log->value[k] =
		    xgrow_by_one(log->value[k], log->n, sizeof *log->value[k]);
		log->value[k][log->n] = NAN;
	}
	for (size_t c = 0; c < r->n_column; c++) {
		unsigned k = r->kind[c];
		double v;
		if (k >= LOG_COLUMNS ||
		    !number_value_of_cell(row_cell_at(row, c), &v) || v < 0)
			continue;
		if (k == LOG_SPEED)
			v = speed_in_unit_to_mps(v, r->head[c].unit, 0);
		v *= r->scale[c];
		double *slot = &log->value[k][log->n];
		*slot = isnan(*slot) ? v : *slot + v;
	}
	log->n++;
}

static void
plant_log_read_rows(struct reading *r)
{
	for (size_t i = r->first;
	     i < r->sheet->n_row && !error_is_stop_requested(r->errors); i++) {
		struct datetime day, clock = {.has_time = false};
		bool good = parse_date_or_time_cell(r, i, r->date, &day) &&
			    day.has_date;
		double time = good ? datetime_seconds_since_1970(&day, r->order)
				   : (double)NAN;
		if (good && r->clock != r->date) {
			good = parse_date_or_time_cell(r, i, r->clock, &clock);
			time += clock.seconds;
		} else {
			good = good && day.has_time;
		}
		if (!good || isnan(time)) {
			r->log->passed++;
			continue;
		}
		r->zone = r->zone || day.has_zone || clock.has_zone;
		add_plant_log_row(r, time, &r->sheet->row[i]);
	}
}

/* Reports numbers such as 1,250, if the sheet does not show whether the comma
 * is decimal. */
static bool
refuse_ambiguous_numbers(struct reading *r)
{
	for (size_t i = r->first;
	     i < r->sheet->n_row && !error_is_stop_requested(r->errors); i++)
		for (size_t c = 0; c < r->n_column; c++) {
			struct cell cell = row_cell_at(&r->sheet->row[i], c);
			if (r->kind[c] < LOG_COLUMNS &&
			    number_is_ambiguous(r->sheet, cell))
				return sheet_report_fault(r->sheet, cell,
				    "expected a number that can be read in one "
				    "way, got %s: a decimal sign, or "
				    "thousands?\n"
				    "say which: load %s as=log decimal=point, "
				    "or decimal=comma",
				    cell.text, r->sheet->path);
		}
	return true;
}

static void
describe_plant_log_columns(struct reading *r)
{
	char **text = &r->log->read_as;
	if (*text[0] != '\0')
		return;
	xappend(text, tr("time in column %zu"), r->date + 1);
	if (r->clock != r->date)
		xappend(text, tr(" and %zu"), r->clock + 1);
	for (size_t k = 0; k < LOG_COLUMNS; k++)
		for (size_t c = 0; c < r->n_column; c++)
			if (r->kind[c] == k) {
				xappend_to_list(text, ", ", tr("%s in %zu"),
				    LOG_UNITS[k], c + 1);
				if (r->scale[c] != 1)
					xappend(text, " (* %.4g)", r->scale[c]);
			}
	for (size_t c = 0; c < r->n_column; c++)
		if (r->kind[c] == LEFT_OUT)
			xappend(text, tr(", not column %zu"), c + 1);
}

/* Reads a sheet.  Returns false with a fault, also if it has no times. */
static bool
plant_log_read_sheet(struct reading *r, struct sheet *sheet, bool *open)
{
	r->sheet = sheet;
	r->n_column = r->first = r->date = r->clock = 0;
	if (r->request->decimal != '\0')
		number_set_decimal_sign(sheet, r->request->decimal);
	if (!find_time_columns(r) || !plant_log_find_column_kinds(r) ||
	    !find_day_month_order(r, open) || !refuse_ambiguous_numbers(r))
		return false;
	plant_log_read_rows(r);
	describe_plant_log_columns(r);
	return true;
}

static bool
plant_log_read_file(struct reading *r, const char *path, bool *open)
{
	struct source source;
	bool good = source_read_plant_log_sheets(path, r->errors, &source);
	size_t taken = 0;
	for (size_t i = 0; i < source.n && good; i++) {
		const char *wanted = r->request->sheet;
		if (wanted == NULL
			? source.n > 1 && source.sheet[i]->n_row < 2
			: !text_is_same_folded(source.sheet[i]->name, wanted))
			continue;
		good = plant_log_read_sheet(r, source.sheet[i], open);
		taken++;
	}
	if (good && taken == 0)
		good = error_set_at(error_list_add_item(r->errors), ERROR_DATA,
		    path, 0, 0,
		    "expected a sheet with a log, got none\n"
		    "name one of its sheets: sheet=NAME");
	if (good && source.note[0] != '\0')
		xappend_to_list(&r->log->assumed, "; ", "%s", source.note);
	source_free(&source);
	return good;
}

struct stamp {
	double time;
	size_t row;
};

static int
compare_by_time(const void *a, const void *b)
{
	const struct stamp *s = a, *t = b;
	if (s->time != t->time)
		return s->time < t->time ? -1 : 1;
	return (s->row > t->row) - (s->row < t->row);
}

static void
plant_log_sort_rows(struct plant_log *log)
{
	FREED struct stamp *stamp = xcalloc(log->n, sizeof *stamp);
	FREED double *old = xcalloc_doubles(log->n);
	for (size_t i = 0; i < log->n; i++)
		stamp[i] = (struct stamp){log->time[i], i};
	qsort(stamp, log->n, sizeof *stamp, compare_by_time);
	for (size_t i = 0; i < log->n; i++)
		log->time[i] = stamp[i].time;
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		memcpy(old, log->value[k], log->n * sizeof *old);
		for (size_t i = 0; i < log->n; i++)
			log->value[k][i] = old[stamp[i].row];
	}
}

/* Returns the median, or NAN if n is 0.  Sorts the values. */
static double
plant_log_median(double *value, size_t n)
{
	gsl_sort(value, 1, n);
	return n > 0 ? (value[(n - 1) / 2] + value[n / 2]) / 2 : NAN;
}

/* Sorts the rows, computes what concerns all of them, and drops columns without
 * numbers. */
static void
sort_and_trim_plant_log(struct reading *r)
{
	struct plant_log *log = r->log;
	plant_log_sort_rows(log);
	FREED double *apart = xcalloc_doubles(log->n);
	for (size_t i = 1; i < log->n; i++) {
		apart[i - 1] = log->time[i] - log->time[i - 1];
		if (apart[i - 1] > log->gap) {
			log->gap = apart[i - 1];
			log->gap_from = log->time[i - 1];
		}
	}
	log->apart = log->n > 1 ? plant_log_median(apart, log->n - 1) : 0;
	log->digest = text_fnv1a_digest(
	    TEXT_DIGEST_START, log->time, log->n * sizeof *log->time);
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		bool any = false;
		for (size_t i = 0; i < log->n; i++)
			any = any || !isnan(log->value[k][i]);
		for (size_t i = 0; i < log->n && any; i++)
			if (!isnan(log->value[k][i]))
				log->digest = text_fnv1a_digest(log->digest,
				    &log->value[k][i], sizeof(double));
		if (any)
			continue;
		free(log->value[k]);
		log->value[k] = NULL;
	}
	if (r->zone)
		xappend_to_list(&log->assumed, "; ",
		    tr("times as they are written, whatever their zone"));
}

struct plant_log *
plant_log_read(
    const struct log_request *request, struct error_list *errors, bool *open)
{
	struct reading r = {.request = request, .errors = errors};
	bool good = true;
	r.log = xcalloc(1, sizeof *r.log);
	r.log->path = xstrdup(request->path[0]);
	r.log->read_as = xstrdup("");
	r.log->assumed = xstrdup("");
	*open = false;
	for (size_t i = 0; i < request->n && good; i++)
		good = plant_log_read_file(&r, request->path[i], open) &&
		       errors->n == 0;
	if (good && r.log->passed >= r.log->n)
		good = error_set_at(error_list_add_item(errors), ERROR_DATA,
		    request->path[0], 0, 0,
		    "expected a time in each row of the log, got %zu rows "
		    "without one and %zu with\n"
		    "write times as 2026-05-03 10:15",
		    r.log->passed, r.log->n);
	if (good) {
		sort_and_trim_plant_log(&r);
		return r.log;
	}
	plant_log_free(r.log);
	return NULL;
}

void
plant_log_free(struct plant_log *log)
{
	if (log == NULL)
		return;
	for (size_t k = 0; k < LOG_COLUMNS; k++)
		free(log->value[k]);
	free(log->time);
	free(log->path);
	free(log->read_as);
	free(log->assumed);
	free(log);
}

struct log_window
plant_log_summarise_window(const struct plant_log *log, double from, double to)
{
	struct log_window w = {.n = 0};
	size_t first = 0, end;
	while (first < log->n && log->time[first] < from)
		first++;
	for (end = first; end < log->n && log->time[end] <= to;)
		end++;
	w.n = end - first;
	for (size_t k = 0; k < LOG_COLUMNS; k++) {
		FREED double *value = xcalloc_doubles(w.n);
		size_t n = 0;
		for (size_t i = first; i < end && log->value[k] != NULL; i++)
			if (!isnan(log->value[k][i]))
				value[n++] = log->value[k][i];
		w.median[k] = plant_log_median(value, n);
		w.least[k] = n > 0 ? value[0] : NAN;
		w.most[k] = n > 0 ? value[n - 1] : NAN;
	}
	return w;
}
