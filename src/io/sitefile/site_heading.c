/* Reads the lines above the tables: keys and values, in the languages of
 * lexicon.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_heading.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/rotor_size.h"
#include "io/sitefile/site_sieve.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/datetime.h"
#include "io/cells/number.h"

static const char *const NAMES[N_KEY] = {
    "site", "rock", "machine", "provenance", "top_size_mm"};

/* True if two names of sites, rocks or machines differ in their first words, or
 * contain different names. */
static bool
do_names_differ(const char *a, const char *b)
{
	FREED char *one = xstrndup(a, strcspn(a, " ,;")),
		   *other = xstrndup(b, strcspn(b, " ,;"));
	return !text_is_same_folded(one, other) || heading_names_differ(a, b);
}

/* Returns true if the key had another value in an earlier sheet. */
static bool
site_heading_set_site_field(struct site *site, enum lexicon_key key,
    struct sheet *sheet, struct cell cell)
{
	char **text[] = {
	    &site->name, &site->rock, &site->machine, &site->provenance};
	if (key != KEY_TOP_SIZE) {
		const char *before = *text[key]; /* of another sheet or file */
		bool other = key != KEY_PROVENANCE && before[0] != '\0' &&
			     do_names_differ(before, cell.text);
		if (other)
			xappend_to_list(&site->remark, "; ",
			    tr("read as one site, though its sheets state "
			       "'%.*s' and '%.*s'"),
			    sheet_truncated_text_length(before), before,
			    sheet_truncated_text_length(cell.text), cell.text);
		xfree_and_set(text[key], xstrdup(cell.text));
		return other;
	}
	double mm = site_sieve_read_mm(sheet, cell, 1, "a positive size in mm");
	if (mm <= 0)
		sheet_report_expected(sheet, cell, "a positive size in mm",
		    "write the size, or remove the line");
	site->top_size = mm / 1000;
	return false;
}

/* Reads the first number of a text, such as 900 in "900 mm". */
static bool
read_first_number_of_cell(
    const struct sheet *sheet, struct cell cell, double *value)
{
	char copy[40];
	size_t n = strspn(cell.text, "0123456789.,' ");
	while (n > 0 && cell.text[n - 1] == ' ')
		n--;
	if (cell.kind == CELL_NUMBER || n == 0 || n >= sizeof copy)
		return number_value_of_cell(cell, value);
	memcpy(copy, cell.text, n);
	copy[n] = '\0';
	return number_value_of_cell(
	    number_reparse_cell_with_text(sheet, cell, copy), value);
}

/* Returns the rotor's diameter, mm, that a key and value state, or 0 if they
 * are about something else of the rotor, such as its type, hours, radius or
 * mass, or in feet.  A number below 10 is in m. */
static double
rotor_mm_of_key(const struct sheet *sheet, struct cell key, struct cell value)
{
	const uint64_t units = WORD_MM | WORD_INCH | WORD_M;
	const uint64_t fit =
	    units | WORD_ROTOR | WORD_SIZE | WORD_FILLER | WORD_MACHINE;
	size_t unknown = 0, odd = 0;
	uint64_t means = lexicon_text_meanings(key.text, &unknown);
	if ((means & ~fit) != 0 || (means & WORD_ROTOR) == 0 ||
	    (unknown > 0 && (means & WORD_SIZE) == 0))
		return (means & WORD_SPEED) != 0
			   ? 0
			   : fmax(rotor_diameter_mm_in_text(value.text, true),
				 0);
	means |= lexicon_text_meanings(value.text, &odd);
	double number;
	if ((odd > 0 && (means & units) == 0) ||
	    (means & (WORD_SPEED | WORD_RPM)) != 0 ||
	    !read_first_number_of_cell(sheet, value, &number))
		return 0;
	double mm = number * (number < 10 ? 1000 : 1);
	if ((means & WORD_INCH) != 0)
		mm = 25.4 * number;
	if (strstr(value.text, "cm") != NULL || strstr(key.text, "cm") != NULL)
		mm = 10 * number;
	return mm < 100 || mm > 5000 ? 0 : mm;
}

void
site_heading_record_speed(struct heading_speed *speed, double mps, double rpm)
{
	speed->differ =
	    speed->differ ||
	    (speed->mps > 0 && mps > 0 && fabs(speed->mps - mps) > 1e-3) ||
	    (speed->rpm > 0 && rpm > 0 && fabs(speed->rpm - rpm) > 1e-3);
	speed->mps = speed->differ ? 0 : mps > 0 ? mps : speed->mps;
	speed->rpm = speed->differ ? 0 : rpm > 0 ? rpm : speed->rpm;
}

/* Takes a speed from "tip speed; 70 m/s" or "varvtal; 1350", but not the
 * highest that a machine has.  Returns false if there is none. */
static bool
site_heading_parse_speed(const struct sheet *sheet, struct cell key,
    struct cell value, struct heading_speed *speed)
{
	struct head k = heading_parse(key.text), v = heading_parse(value.text);
	double number;
	enum speed_unit unit = heading_speed_unit(&k);
	bool about = (k.means & WORD_SPEED) != 0 || k.unit != SPEED_NO_UNIT;
	/* "Product 70 m/s" is the title of a table. */
	about = about && !heading_has_speed(&k) && (k.means & WORD_LIMIT) == 0;
	if (!about || (v.several && v.unit != SPEED_NO_UNIT))
		return false;
	if (heading_has_speed(&v)) {
		site_heading_record_speed(speed, v.speed, v.rpm);
		return true;
	}
	if (!read_first_number_of_cell(sheet, value, &number) || number <= 0)
		return false;
	if (unit == SPEED_RPM)
		site_heading_record_speed(speed, 0, number);
	else if (unit != SPEED_NO_UNIT || number < 150)
		site_heading_record_speed(
		    speed, speed_in_unit_to_mps(number, unit, 0), 0);
	else
		return false;
	return true;
}

/* As site_heading_parse_speed, for a line that may have more speeds, of which
 * the next is in *third (NULL: none).  If they differ, none is that of all. */
static bool
parse_speeds(const struct sheet *sheet, struct cell key, struct cell value,
    const struct cell *third, struct heading_speed *speed)
{
	bool found = site_heading_parse_speed(sheet, key, value, speed);
	if (found && third != NULL)
		site_heading_parse_speed(sheet, key, *third, speed);
	return found;
}

/* Splits a cell such as "Speed: 70 m/s" into key and value, whose texts are in
 * *copy, which the caller frees.  Returns false if there is no value. */
static bool
split_cell_at_colon(struct cell *key, struct cell *value, char **copy)
{
	*copy = xstrdup(key->text);
	char *colon = strchr(*copy, ':');
	if (colon == NULL || colon[1] == '\0' || colon == *copy)
		return false;
	*colon = '\0';
	*value = *key;
	key->text = text_trim(*copy);
	value->text = text_trim(colon + 1);
	value->kind = CELL_TEXT;
	return value->text[0] != '\0' && key->text[0] != '\0';
}

/* True if a cell has both a key and its value, "Stone: gabbro". */
static bool
is_key_colon_value_cell(struct cell cell)
{
	const char *colon = strchr(cell.text, ':');
	return colon != NULL && colon > cell.text && colon[1] == ' ' &&
	       strspn(colon + 1, " ") < strlen(colon + 1);
}

/* Finds the next key and value of a line, from cell *at on, and moves *at past
 * them.  They are the cells up to an empty one; or one cell that has both, if
 * another such cell follows it.  Returns the number of cells, of which the
 * third, or the first after it that is not like the value, is in *third.  One
 * cell that has both counts as two; their texts are in *copy, which the caller
 * frees. */
static size_t
next_key_and_value(const struct row *row, size_t *at, struct cell *key,
    struct cell *value, struct cell *third, char **copy)
{
	size_t n = 0, i = *at;
	*key = (struct cell){0};
	while (i < row->n && row->cell[i].text[0] == '\0')
		i++;
	*value = row_cell_at(row, row->n_all);
	for (; i < row->n && (row->cell[i].text[0] != '\0' || n == 1); i++) {
		if (row->cell[i].text[0] == '\0')
			continue;
		if (n == 1 && is_key_colon_value_cell(*key) &&
		    is_key_colon_value_cell(row->cell[i]))
			break;
		struct cell *slot[] = {key, value, third};
		if (n < 3 || strcmp(third->text, value->text) == 0)
			*slot[n < 2 ? n : 2] = row->cell[i];
		n++;
	}
	*at = i;
	return n == 1 && split_cell_at_colon(key, value, copy) ? 2 : n;
}

bool
site_heading_speed_of_line(const struct sheet *sheet, const struct row *row,
    struct heading_speed *speed)
{
	struct cell key, value, third;
	FREED char *copy = NULL;
	size_t at = 0,
	       n = next_key_and_value(row, &at, &key, &value, &third, &copy);
	return n > 1 && lexicon_site_key_of_text(key.text) == N_KEY &&
	       parse_speeds(sheet, key, value, n > 2 ? &third : NULL, speed);
}

char *
site_heading_date_of_line(const struct row *row)
{
	struct cell key, value, third;
	struct datetime m;
	for (size_t at = 0, n; at < row->n;) {
		FREED char *copy = NULL;
		n = next_key_and_value(row, &at, &key, &value, &third, &copy);
		if (n == 0)
			break;
		double seconds =
		    n > 1 && lexicon_is_date_label(key.text) &&
			    datetime_parse(value.text, &m) && m.has_date
			? datetime_seconds_since_1970(&m, DATETIME_OPEN)
			: (double)NAN;
		if (isnan(seconds))
			continue;
		char *day = datetime_to_text(seconds);
		day[strcspn(day, " ")] = '\0';
		return day;
	}
	return NULL;
}

/* True for "rock Granite", in which the separator is missing. */
static bool
begins_with_site_key(const char *text)
{
	for (size_t k = 0; k < N_KEY; k++)
		if (text_is_same_but_case(text, NAMES[k], strlen(NAMES[k])))
			return true;
	return false;
}

void
site_heading_leave_out(struct site *site, int line, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *what = xvasprintf(tr(format), ap);
	va_end(ap);
	FREED char *where = xasprintf(tr("line %d"), line);
	site_notes_append(&site->left_out, &site->n_left_out, where, what);
}

static void
report_key_without_value(struct sheet *sheet, struct cell key)
{
	if (sheet->separator == '\t') /* a workbook has no separator */
		sheet_report_expected(sheet, key, "a key and a value",
		    "write the value in the next cell, or begin a remark "
		    "with #");
	else
		sheet_report_expected(sheet, key, "a key and a value",
		    "write key%cvalue, or begin a remark with #",
		    sheet->separator);
}

/* Sets the field of a site that a key states; *seen: the line that stated it
 * before, or 0.  third: a cell after the value, or NULL. */
static void
set_site_field(struct site *site, struct sheet *sheet, enum lexicon_key k,
    struct cell key, struct cell value, const struct cell *third, int *seen,
    struct heading_speed *speed)
{
	const char *known[N_KEY] = {
	    site->name, site->rock, site->machine, site->provenance};
	double mm = 0;
	bool same = k == KEY_TOP_SIZE
			? number_value_of_cell(value, &mm) &&
			      mm / 1000 == site->top_size
			: text_is_same_folded(known[k], value.text);
	if (third != NULL)
		sheet_report_expected(sheet, *third,
		    "the end of the line after key and value",
		    "quote a value that contains the separator, begin a remark "
		    "with #, or put names of single products directly above "
		    "the headings; with decimal commas, separate the cells "
		    "with ;");
	else if (*seen > 0 && !same)
		sheet_report_fault(sheet, key,
		    "duplicate key: %s is already in line %d\n"
		    "remove one of the two lines",
		    key.text, *seen);
	else
		speed->other_site |=
		    site_heading_set_site_field(site, k, sheet, value);
	/* The name of a machine may state its rotor, too. */
	if (k == KEY_MACHINE && !(site->rotor > 0))
		site->rotor = rotor_mm_of_key(sheet, key, value) / 1000;
	*seen = key.line;
}

/* Takes the rotor and the speed that a key with its value states, if it has
 * one, and notes it.  third: a cell after the value, or NULL. */
static void
read_other_key(struct site *site, const struct sheet *sheet, struct cell key,
    const struct cell *value, const struct cell *third,
    struct heading_speed *speed)
{
	double mm = value != NULL ? rotor_mm_of_key(sheet, key, *value) : 0;
	double number;
	site->rotor = mm > 0 ? mm / 1000 : site->rotor;
	if (!(mm > 0) && value != NULL)
		parse_speeds(sheet, key, *value, third, speed);
	if (third != NULL && number_value_of_cell(*third, &number))
		site_heading_leave_out(site, key.line,
		    "%.*s: numbers above the table",
		    sheet_truncated_text_length(key.text), key.text);
	else if (!(mm > 0 && strcmp(key.text, "rotor_mm") == 0))
		site_notes_append(&site->note, &site->n_note, key.text,
		    value != NULL ? value->text : "");
}

/* Reads the next key and value of a line, or a key alone.  seen: the line of
 * each key read so far, or 0.  Returns false at the end of the line. */
static bool
set_site_field_from_next_key(struct site *site, struct sheet *sheet,
    const struct row *row, size_t *at, int seen[static N_KEY],
    struct heading_speed *speed)
{
	struct cell key, value, third;
	FREED char *copy = NULL;
	size_t n = next_key_and_value(row, at, &key, &value, &third, &copy);
	if (n == 0)
		return false;
	enum lexicon_key k = lexicon_site_key_of_text(key.text);
	const struct cell *more = n > 2 ? &third : NULL;
	if (n == 1 && k == N_KEY && begins_with_site_key(key.text))
		report_key_without_value(sheet, key);
	else if (k < N_KEY)
		set_site_field(
		    site, sheet, k, key, value, more, &seen[k], speed);
	else
		read_other_key(
		    site, sheet, key, n > 1 ? &value : NULL, more, speed);
	return true;
}

/* True if a line above a later table names another site, rock or machine. */
static bool
names_other_site(const struct site *site, const struct row *row)
{
	const char *own[] = {site->name, site->rock, site->machine};
	struct cell key, value, third;
	FREED char *copy = NULL;
	size_t at = 0;
	if (next_key_and_value(row, &at, &key, &value, &third, &copy) != 2)
		return false;
	enum lexicon_key k = lexicon_site_key_of_text(key.text);
	return k < ARRAY_LEN(own) && own[k][0] != '\0' &&
	       do_names_differ(own[k], value.text);
}

void
site_heading_read(const struct layout *layout, struct sheet *sheet,
    struct site *site, struct heading_speed *speed)
{
	int seen[N_KEY] = {0};
	int first = layout->n > 0 ? layout->table[0].row[0].line : 0;
	for (size_t i = 0; i < layout->n; i++)
		for (size_t r = 0; r < layout->table[i].n_row; r++)
			for (size_t c = 0; c < layout->table[i].n_col; c++) {
				int line = layout->table[i].row[r].cell[c].line;
				first = line < first ? line : first;
			}
	for (size_t i = 0; i < layout->n_heading; i++)
		if (layout->heading[i]->line < first)
			for (size_t at = 0; set_site_field_from_next_key(site,
				 sheet, layout->heading[i], &at, seen, speed);)
				;
	for (size_t i = 0; i < layout->n_heading; i++)
		if (layout->heading[i]->line > first)
			speed->other_site |=
			    names_other_site(site, layout->heading[i]);
}

/* Returns the rotor's diameter, mm, that a line states in words or, if it has
 * none, as the value of a key; 0 if it states none, -1 if two differ. */
static double
rotor_mm_of_line(const struct sheet *sheet, const struct row *row)
{
	FREED char *line = xstrdup(""), *copy = NULL;
	struct cell key, value, third;
	size_t at = 0;
	for (size_t c = 0; c < row->n; c++)
		xappend_to_list(&line, ", ", "%s", row->cell[c].text);
	double mm = rotor_diameter_mm_in_text(line, false);
	bool pair =
	    mm == 0 &&
	    next_key_and_value(row, &at, &key, &value, &third, &copy) == 2 &&
	    lexicon_site_key_of_text(key.text) == N_KEY;
	return pair ? rotor_mm_of_key(sheet, key, value) : mm;
}

void
site_heading_merge_rotor(const struct layout *layout, const struct sheet *sheet,
    struct heading_rotor *said)
{
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		double mm = rotor_mm_of_line(sheet, row);
		if (mm != 0 && said->line == 0) {
			said->mm = mm;
			said->line = row->line;
		}
		if (mm != 0 && said->other_line == 0 &&
		    (mm < 0 || fabs(mm - said->mm) > 0.5)) {
			said->other_mm = mm;
			said->other_line = row->line;
		}
	}
}

char *
site_heading_rotors_text(const struct heading_rotor *said)
{
	if (said->other_mm < 0)
		return xasprintf(tr("several in line %d"), said->other_line);
	return xasprintf(tr("%g mm in line %d and %g mm in line %d"), said->mm,
	    said->line, said->other_mm, said->other_line);
}

char *
site_heading_name_from_path(const char *path)
{
	const char *name = file_name_without_folders(path);
	const char *dot = strrchr(name, '.');
	bool extension = dot != NULL && dot > name;
	size_t n = extension ? (size_t)(dot - name) : strlen(name);
	bool good = text_is_utf8(name, n);
	char *copy = xstrndup(name, n);
	for (char *p = copy; *p != '\0'; p++) {
		unsigned char c = (unsigned char)*p;
		if (c < 0x20 || c == 0x7F || (c >= 0x80 && !good))
			*p = '_';
	}
	return copy;
}
