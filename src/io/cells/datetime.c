/* Parses dates and times of day in the notations of several countries.  Ignores
 * time zones: crews write down the time on the clock.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/datetime.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "base/xalloc.h"

static const int DAY = 24 * 3600;

/* The first three letters of the months: English, Swedish, German, French,
 * Spanish, Portuguese, Norwegian and Dutch. */
static const char *const MONTHS[12] = {"jan ene", "feb fev", "mar mrt",
    "apr avr abr", "may mai maj mei", "jun", "jul", "aug ago", "sep set",
    "oct okt out", "nov", "dec dez des dic"};

static int
days_in_month(int year, int month)
{
	static const int DAYS[12] = {
	    31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
	bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
	return DAYS[month - 1] + (month == 2 && leap);
}

static bool
is_valid_date(int year, int month, int day)
{
	return year >= 1970 && year <= 2199 && month >= 1 && month <= 12 &&
	       day >= 1 && day <= days_in_month(year, month);
}

static int
days_since_1970(int year, int month, int day)
{
	int days = day - 1;
	for (int y = 1970; y < year; y++)
		days += 337 + days_in_month(y, 2);
	for (int m = 1; m < month; m++)
		days += days_in_month(year, m);
	return days;
}

/* Reads a number of at most `most` digits, *n of them, and moves *p past it.
 * Returns -1 if there is none, or more digits follow. */
static int
parse_digits(const char **p, size_t most, size_t *n)
{
	int value = 0;
	for (*n = 0; *n < most && isdigit((unsigned char)**p); (*n)++)
		value = 10 * value + *(*p)++ - '0';
	return *n > 0 && !isdigit((unsigned char)**p) ? value : -1;
}

static int
month_from_name(const char *word)
{
	for (int m = 0; m < 12; m++)
		for (const char *p = MONTHS[m]; *p != '\0';
		     p += strcspn(p, " "), p += strspn(p, " "))
			if (strncmp(p, word, 3) == 0)
				return m + 1;
	return 0;
}

/* Reads the "May-2026" that follows a day, or, if day is 0, "May 3, 2026". */
static bool
parse_month_name_and_year(const char **p, int day, struct datetime *m)
{
	size_t n;
	bool first = day == 0;
	m->month = month_from_name(*p);
	while (isalpha((unsigned char)**p))
		(*p)++;
	*p += strspn(*p, ".- ,");
	m->day = first ? parse_digits(p, 2, &n) : day;
	*p += first ? strspn(*p, " ,") : 0;
	m->year = parse_digits(p, 4, &n);
	/* If the day comes first, 26 in 03-May-26 is a year. */
	m->year += n == 2 && !first ? 2000 : 0;
	m->plain = true;
	return (n == 2 || n == 4) && is_valid_date(m->year, m->month, m->day);
}

/* Reads the last two numbers of a date.  The first, a day or month, and the
 * sign after it have been read. */
static bool
parse_rest_of_numeric_date(
    const char **p, int first, char sign, struct datetime *m)
{
	size_t n;
	int second = parse_digits(p, 2, &n);
	char next = *(*p)++;
	/* Only dates that begin with the day have two signs, 3/5-2026. */
	bool two = sign == '/' && (next == '-' || next == ' ');
	if (next != sign && !two)
		return false;
	m->year = parse_digits(p, 4, &n);
	m->day = first;
	m->month = second;
	m->plain = sign == '.' || first == second || two;
	bool day_first = is_valid_date(m->year, second, first);
	bool month_first = is_valid_date(m->year, first, second) && !m->plain;
	m->order = !day_first    ? DATETIME_MONTH_FIRST
		   : month_first ? DATETIME_OPEN
				 : DATETIME_DAY_FIRST;
	return n == 4 && (day_first || month_first);
}

/* Reads a date at *p and moves *p past it. */
static bool
datetime_parse_date(const char **p, struct datetime *m)
{
	size_t n;
	if (isalpha((unsigned char)**p))
		return parse_month_name_and_year(p, 0, m);
	int first = parse_digits(p, 4, &n);
	char sign = **p;
	if (first < 0 || strchr("-/. ", sign) == NULL || sign == '\0')
		return false;
	(*p)++;
	const char *word = *p + strspn(*p, " ");
	if (n <= 2 && isalpha((unsigned char)*word)) {
		*p = word;
		return parse_month_name_and_year(p, first, m);
	}
	if (sign == ' ')
		return false;
	if (n <= 2)
		return parse_rest_of_numeric_date(p, first, sign, m);
	m->year = first;
	m->month = parse_digits(p, 2, &n);
	if (*(*p)++ != sign)
		return false;
	m->day = parse_digits(p, 2, &n);
	m->plain = true;
	return is_valid_date(m->year, m->month, m->day);
}

/* Reads "AM" or "p.m.", if there, and corrects the hour. */
static bool
parse_am_pm(const char **p, int *hour)
{
	const char *q = *p + strspn(*p, " ");
	if ((*q != 'a' && *q != 'p') || (q[1] != 'm' && q[1] != '.'))
		return true;
	bool after = *q == 'p';
	q += strspn(q, "apm.");
	if (*hour < 1 || *hour > 12)
		return false;
	*hour = *hour % 12 + (after ? 12 : 0);
	*p = q;
	return true;
}

/* Reads a time zone, "Z" or "+02:00", or nothing, at the end of the text. */
static bool
parse_time_zone(const char *p, struct datetime *m)
{
	size_t n;
	p += strspn(p, " ");
	if (*p == '\0')
		return true;
	m->has_zone = true;
	if (*p == 'z')
		return p[1] == '\0';
	if (strncmp(p, "utc", 3) == 0 || strncmp(p, "gmt", 3) == 0)
		return p[3] == '\0';
	if (*p != '+' && *p != '-')
		return false;
	p++;
	if (parse_digits(&p, 4, &n) < 0)
		return false;
	if (*p == ':') {
		p++;
		parse_digits(&p, 2, &n);
	}
	return *p == '\0';
}

/* Reads a time of day that ends the text.  point: "10.15" is allowed too. */
static bool
datetime_parse_time(const char *p, bool point, struct datetime *m)
{
	size_t n;
	int hour = parse_digits(&p, 2, &n), minute, second = 0;
	double part = 0;
	char sign = *p;
	if (hour < 0 || (sign != ':' && !(point && sign == '.')))
		return false;
	p++;
	minute = parse_digits(&p, 2, &n);
	if (n != 2)
		return false;
	if (*p == sign) {
		p++;
		second = parse_digits(&p, 2, &n);
		if (second >= 0 && (*p == '.' || *p == ',') &&
		    isdigit((unsigned char)p[1])) {
			double scale = 1;
			for (p++; isdigit((unsigned char)*p); p++)
				part += (scale /= 10) * (*p - '0');
		}
	}
	if (!parse_am_pm(&p, &hour) || !parse_time_zone(p, m))
		return false;
	m->seconds = 3600 * hour + 60 * minute + second + part;
	m->has_time = true;
	return minute >= 0 && minute < 60 && second >= 0 && second < 60 &&
	       (hour < 24 || (hour == 24 && m->seconds == DAY));
}

bool
datetime_parse(const char *text, struct datetime *m)
{
	FREED char *folded = text_fold_case_and_accents(text);
	const char *all = text_trim(folded), *p = all;
	*m = (struct datetime){.plain = false};
	m->has_date = datetime_parse_date(&p, m);
	if (!m->has_date) {
		*m = (struct datetime){.plain = false};
		return datetime_parse_time(all, false, m);
	}
	size_t gap = strspn(p, "t, ");
	return *p == '\0' ||
	       (gap > 0 &&
		   (p[gap] == '\0' || datetime_parse_time(p + gap, true, m)));
}

double
datetime_seconds_since_1970(const struct datetime *m, enum datetime_order order)
{
	if (!m->has_date)
		return NAN;
	if (m->order != DATETIME_OPEN)
		order = m->order;
	bool turned = !m->plain && order == DATETIME_MONTH_FIRST;
	int month = turned ? m->day : m->month,
	    day = turned ? m->month : m->day;
	if ((!m->plain && order == DATETIME_OPEN) ||
	    !is_valid_date(m->year, month, day))
		return NAN;
	return (double)days_since_1970(m->year, month, day) * DAY + m->seconds;
}

double
datetime_start_of_day(double seconds)
{
	return floor(seconds / DAY) * DAY;
}

char *
datetime_time_of_day_text(double seconds)
{
	int of_day = (int)(seconds - datetime_start_of_day(seconds));
	int s = of_day % 60;
	if (s > 0)
		return xasprintf(
		    "%02d:%02d:%02d", of_day / 3600, of_day / 60 % 60, s);
	return xasprintf("%02d:%02d", of_day / 3600, of_day / 60 % 60);
}

bool
datetime_is_iso_date(const char *text)
{
	size_t n[3];
	const char *p = text;
	int year = parse_digits(&p, 4, &n[0]);
	if (*p++ != '-')
		return false;
	int month = parse_digits(&p, 2, &n[1]);
	if (*p++ != '-')
		return false;
	int day = parse_digits(&p, 2, &n[2]);
	return *p == '\0' && n[0] == 4 && n[1] == 2 && n[2] == 2 && year >= 0 &&
	       month >= 1 && month <= 12 && day >= 1 &&
	       day <= days_in_month(year, month);
}

/* Source: H. Hinnant, chrono-Compatible Low-Level Date Algorithms,
 * civil_from_days. */
char *
datetime_date_text_from_days(long days)
{
	long z = days + 719468, era = z / 146097, doe = z - era * 146097;
	long yoe = (doe - doe / 1460 + doe / 36524 - doe / 146096) / 365;
	long doy = doe - (365 * yoe + yoe / 4 - yoe / 100);
	long mp = (5 * doy + 2) / 153;
	long d = doy - (153 * mp + 2) / 5 + 1;
	long m = mp < 10 ? mp + 3 : mp - 9;
	long y = yoe + era * 400 + (m <= 2);
	return xasprintf("%04ld-%02ld-%02ld", y, m, d);
}

char *
datetime_to_text(double seconds)
{
	FREED char *day =
	    datetime_date_text_from_days((long)floor(seconds / DAY));
	FREED char *clock = datetime_time_of_day_text(seconds);
	return xasprintf("%s %s", day, clock);
}

char *
datetime_today_text(void)
{
	uint64_t whole;
	const char *epoch = getenv("SOURCE_DATE_EPOCH");
	bool fixed = epoch != NULL && text_parse_whole_number(epoch, &whole) &&
		     whole < (uint64_t)DAY * 366 * 8000;
	time_t now = fixed ? (time_t)whole : time(NULL);
	const struct tm *tm = fixed ? gmtime(&now) : localtime(&now);
	return xasprintf(
	    "%04d-%02d-%02d", tm->tm_year + 1900, tm->tm_mon + 1, tm->tm_mday);
}

bool
datetime_is_day_in_words(const char *text)
{
	FREED char *folded = text_fold_case_and_accents(text);
	size_t numbers = 0, months = 0, n;
	for (const char *p = folded; *p != '\0'; p += n) {
		n = strspn(p, "0123456789");
		numbers += n > 0;
		if (n > 0)
			continue;
		while (isalpha((unsigned char)p[n]))
			n++;
		if (n > 0 && month_from_name(p) == 0)
			return false;
		months += n > 0;
		n += n == 0;
	}
	return months == 1 && numbers > 0 && numbers <= 2;
}
