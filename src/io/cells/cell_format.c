/* Finds how a workbook's format code shows a number, and converts serial days
 * to dates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/cell_format.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/datetime.h"

/* What has been found in a format code so far. */
struct said {
	bool percent, day, time, span;
	size_t n; /* length of unit */
	char unit[16];
};

static void
append_char_to_unit_of_format(struct said *said, char c)
{
	if (said->n + 1 < sizeof said->unit)
		said->unit[said->n++] = c;
}

/* Reads "text", [Red] or [h].  Returns the text after it. */
static const char *
parse_format_quote_or_bracket(const char *p, struct said *said)
{
	char close = *p == '[' ? ']' : '"';
	const char *from = ++p;
	while (*p != '\0' && *p != close) {
		if (close == '"')
			append_char_to_unit_of_format(said, *p);
		p++;
	}
	/* [h] or [mm]: elapsed time. */
	size_t n = (size_t)(p - from);
	if (close == ']' && n > 0 && n <= 2 &&
	    strchr("hHmMsS", *from) != NULL && from[n - 1] == from[0])
		said->span = true;
	return *p != '\0' ? p + 1 : p;
}

/* Reads a character outside quotes and brackets.  Returns the text after it. */
static const char *
parse_cell_format_char(const char *p, struct said *said)
{
	switch (tolower((unsigned char)*p)) {
	case '\\':
		if (p[1] != '\0')
			append_char_to_unit_of_format(said, *++p);
		break;
	case '_':
	case '*':
		p += p[1] != '\0';
		break;
	case '%':
		said->percent = true;
		break;
	case 'd':
	case 'y':
		said->day = true;
		break;
	case 'h':
	case 's':
		said->time = true;
		break;
	case 'm': /* a month, or minutes beside hours or seconds */
		said->day = said->day || !said->time;
		break;
	default:
		break;
	}
	return p + 1;
}

struct cell_format
cell_format_of_code(const char *code)
{
	/* m means minutes, as in m:ss */
	struct said said = {.time = text_is_same_but_case(code, "m:s", 3) ||
				    text_is_same_but_case(code, "mm:s", 4)};
	for (const char *p = code; *p != '\0' && *p != ';';) {
		if (text_is_same_but_case(p, "General", 7))
			p += 7;
		else if (text_is_same_but_case(p, "Standard", 8))
			p += 8;
		else if (*p == '"' || *p == '[')
			p = parse_format_quote_or_bracket(p, &said);
		else
			p = parse_cell_format_char(p, &said);
	}
	struct cell_format shown = {.kind = said.span   ? FORMAT_SPAN
					    : said.day  ? FORMAT_DATE
					    : said.time ? FORMAT_TIME
							: FORMAT_NUMBER};
	if (shown.kind != FORMAT_NUMBER)
		return shown;
	const char *unit = said.unit + strspn(said.unit, " ");
	size_t n = strlen(unit);
	while (n > 0 && unit[n - 1] == ' ')
		n--;
	/* Only a word is a unit.  One that was cut short is dropped, as it may
	 * end within a character. */
	if (said.n + 1 == sizeof said.unit ||
	    !(isalpha((unsigned char)*unit) || (*unit & 0x80) != 0))
		n = 0;
	snprintf(shown.unit, sizeof shown.unit, "%.*s",
	    said.percent ? 1 : (int)n, said.percent ? "%" : unit);
	return shown;
}

struct cell_format
cell_format_of_builtin_id(unsigned id)
{
	bool day = (id >= 14 && id <= 17) || id == 22 ||
		   (id >= 27 && id <= 36) || (id >= 50 && id <= 58);
	bool time = (id >= 18 && id <= 21) || id == 45 || id == 47;
	struct cell_format shown = {.kind = day        ? FORMAT_DATE
					    : time     ? FORMAT_TIME
					    : id == 46 ? FORMAT_SPAN
						       : FORMAT_NUMBER};
	if (id == 9 || id == 10)
		shown.unit[0] = '%';
	return shown;
}

bool
cell_format_serial_to_text(double serial, bool from_1904,
    enum cell_format_kind kind, char text[static 32])
{
	enum { DAY = 86400, TO_1899 = -25569, TO_1904 = -24107 };
	if (!(serial >= 0 && serial < 2958466))
		return false;
	double seconds = round(serial * DAY);
	long day = (long)floor(seconds / DAY);
	bool midnight = seconds == datetime_start_of_day(seconds);
	FREED char *clock = datetime_time_of_day_text(seconds);
	if (kind == FORMAT_SPAN) {
		snprintf(text, 32, "%02ld%s", (long)seconds / 3600, clock + 2);
		return true;
	}
	/* Spreadsheets take 1900 for a leap year, so before 1900-03-01 their
	 * day numbers are one less. */
	long epoch = from_1904 ? TO_1904 : TO_1899 + (day < 60);
	FREED char *date = kind == FORMAT_DATE || day > 0
			       ? datetime_date_text_from_days(day + epoch)
			       : xstrdup("");
	bool both = date[0] != '\0' && !midnight;
	snprintf(text, 32, "%s%s%s", date, both ? "T" : "",
	    date[0] != '\0' && midnight ? "" : clock);
	return true;
}
