/* Numbers and words, independent of the locale; text for terminals: escaped,
 * measured and wrapped.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* wcwidth */
#include "base/text.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

#include "base/xalloc.h"

static const char DIGITS[] = "0123456789";

/* The functions of <ctype.h> depend on the locale: in Latin-1, a byte of UTF-8
 * may be a letter. */
static bool
is_digit(char c)
{
	return c >= '0' && c <= '9';
}

static bool
text_is_blank_character(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

static char
ascii_to_lower(char c)
{
	return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/* strtod is safe here: the program sets LC_CTYPE only, so the decimal sign is
 * always a point.  Hex, inf and nan, which it accepts too, are rejected before
 * the call. */
bool
text_parse_number(const char *s, double *value)
{
	while (*s == ' ' || *s == '\t')
		s++;
	if (*s == '\0' || s[strspn(s, "+-0123456789.eE \t")] != '\0')
		return false;
	char *end;
	errno = 0;
	double v = strtod(s, &end);
	if (end == s || end[strspn(end, " \t")] != '\0' || !isfinite(v))
		return false;
	*value = v;
	return true;
}

bool
text_is_decimal_comma(const char *s, const char *at)
{
	enum { THOUSANDS = 3 };
	const char *from = at, *end = at + 1;
	while (from > s && is_digit(from[-1]))
		from--;
	while (*at == ',' && is_digit(*end))
		end++;
	bool more = *end == ',' && is_digit(end[1]);
	bool before = from - s > 1 && from[-1] == ',' && is_digit(from[-2]);
	bool thousands = end - at - 1 == THOUSANDS && *from != '0';
	return *at == ',' && from < at && end > at + 1 && !more && !before &&
	       !thousands;
}

bool
text_is_comma_in_number(const char *list, const char *at)
{
	size_t n = *at == ',' ? strspn(at + 1, DIGITS) : 0;
	bool first = strspn(list, DIGITS) == (size_t)(at - list);
	return n > 0 && at > list && is_digit(at[-1]) &&
	       (at[1 + n] != '/' || first);
}

size_t
text_length_of_list_item(const char *list)
{
	size_t n = strcspn(list, ",;");
	while (text_is_comma_in_number(list, list + n))
		n += 1 + strcspn(list + n + 1, ",;");
	return n;
}

bool
text_parse_typed_number(const char *s, double *value)
{
	const char *comma = strchr(s, ',');
	if (comma == NULL || !text_is_decimal_comma(s, comma))
		return text_parse_number(s, value);
	FREED char *copy = xstrdup(s);
	copy[comma - s] = '.';
	return text_parse_number(copy, value);
}

bool
text_parse_whole_number(const char *s, uint64_t *value)
{
	if (!is_digit(*s))
		return false;
	char *end;
	errno = 0;
	unsigned long long v = strtoull(s, &end, 10);
	if (*end != '\0' || errno == ERANGE)
		return false;
	*value = v;
	return true;
}

const char *
text_shortest_exact_number(double value, char buf[static 32])
{
	for (int digits = 6; digits <= 17; digits++) {
		snprintf(buf, 32, "%.*g", digits, value);
		if (strtod(buf, NULL) == value)
			break;
	}
	return buf;
}

const char *
text_number_distinct_from(double value, double other, char buf[static 32])
{
	enum { SHORT = 7, LEAST = 4, MOST = 17 };
	double apart = fabs(value - other) / 10;
	snprintf(buf, 32, "%.*g", SHORT, value);
	for (int digits = LEAST; digits <= MOST && strtod(buf, NULL) != value;
	     digits++) {
		snprintf(buf, 32, "%.*g", digits, value);
		if (fabs(strtod(buf, NULL) - value) <= apart)
			break;
	}
	return buf;
}

char *
text_trim(char *s)
{
	while (text_is_blank_character(*s))
		s++;
	size_t n = strlen(s);
	while (n > 0 && text_is_blank_character(s[n - 1]))
		s[--n] = '\0';
	return s;
}

/* The letters of U+00C0..U+00FF without case and accents; '*' marks the two
 * signs among them. */
static const char LATIN1[] = "aaaaaaaceeeeiiiidnooooo*ouuuuyts"
			     "aaaaaaaceeeeiiiidnooooo*ouuuuyty";

/* The same for U+0100..U+017F (Polish, Czech, Turkish and others); '*' marks
 * letters that are kept. */
static const char LATIN_A[] = "aaaaaaccccccccddddeeeeeeeeeegggggggghhhh"
			      "iiiiiiiiii**jjkkkllllllllllnnnnnnnnnoooooo**"
			      "rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

/* Returns the letter of two bytes without case and accents, or '*' if the bytes
 * are to be kept. */
static char
plain_letter(unsigned char c, unsigned char d)
{
	if (d < 0x80 || d > 0xBF)
		return '*';
	if (c == 0xC3)
		return LATIN1[d - 0x80];
	if (c == 0xC4 || c == 0xC5)
		return LATIN_A[(c - 0xC4) * 64 + d - 0x80];
	return '*';
}

/* Writes a Cyrillic capital, the two bytes at s, in lower case to `to`.
 * Returns false for anything else. */
static bool
lowercase_cyrillic_letter(const unsigned char *s, char *to)
{
	if (s[0] != 0xD0 || s[1] < 0x90 || s[1] > 0xAF)
		return false;
	bool first = s[1] < 0xA0;
	to[0] = (char)(first ? 0xD0 : 0xD1);
	to[1] = (char)(first ? s[1] + 0x20 : s[1] - 0x20);
	return true;
}

char *
text_fold_case_and_accents(const char *s)
{
	char *folded = xcalloc(strlen(s) + 1, 1);
	size_t n = 0;
	while (*s != '\0') {
		unsigned char c = (unsigned char)s[0];
		unsigned char d = (unsigned char)s[1];
		char plain = plain_letter(c, d);
		bool accent = c == 0xCC || (c == 0xCD && d < 0xB0);
		if (plain != '*')
			folded[n++] = plain;
		if (plain != '*' || (accent && d >= 0x80)) {
			s += 2;
		} else if (lowercase_cyrillic_letter(
			       (const unsigned char *)s, &folded[n])) {
			n += 2;
			s += 2;
		} else {
			folded[n++] = ascii_to_lower((char)c);
			s++;
		}
	}
	return folded;
}

/* True if text_with_control_escaped replaces the character: controls, format
 * characters, and the noncharacters U+FFFE and U+FFFF.  Not the joiners U+200C
 * and U+200D, which words in Persian and Hindi need. */
static bool
text_is_hidden_character(uint32_t code)
{
	static const uint32_t RANGES[][2] = {{0, 0x1F}, {0x7F, 0x9F},
	    {0xAD, 0xAD}, {0x61C, 0x61C}, {0x180E, 0x180E}, {0x200B, 0x200B},
	    {0x200E, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F},
	    {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xFFFE, 0xFFFF},
	    {0xE0000, 0xE0FFF}};
	size_t i = 0;
	while (i < ARRAY_LEN(RANGES) && code > RANGES[i][1])
		i++;
	return i < ARRAY_LEN(RANGES) && code >= RANGES[i][0];
}

/* Returns the length in bytes of the letter, digit, point or underscore at p,
 * or 0 for anything else.  Beyond ASCII, everything counts as a letter except
 * the signs of Latin 1 (U+0080..BF, multiplication and division), U+2000..2FFF
 * and the punctuation U+3000..303F. */
static size_t
bytes_of_slug_character(const char *p)
{
	unsigned char c = (unsigned char)p[0], d = (unsigned char)p[1];
	if (c < 0x80)
		return is_digit(*p) || (*p >= 'a' && *p <= 'z') || *p == '.' ||
		       *p == '_';
	if (c < 0xC3 || c == 0xE2 || (c == 0xC3 && (d == 0x97 || d == 0xB7)) ||
	    (c == 0xE3 && d == 0x80))
		return 0;
	const char *end = p;
	uint32_t code = text_next_code_point(&end);
	return text_is_hidden_character(code) || code == 0xFFFD
		   ? 0
		   : (size_t)(end - p);
}

char *
text_slug(const char *s)
{
	char *slug = text_fold_case_and_accents(s);
	size_t n = 0, take;
	for (const char *p = slug; *p != '\0'; p += take > 0 ? take : 1) {
		take = bytes_of_slug_character(p);
		if (take == 0 && n > 0 && slug[n - 1] != '-')
			slug[n++] = '-';
		memmove(slug + n, p, take);
		n += take;
	}
	while (n > 0 && slug[n - 1] == '-')
		n--;
	slug[n] = '\0';
	return slug;
}

bool
text_may_be_formula(const char *s)
{
	double value;
	const char *sign = s + strspn(s, "'");
	if (*sign == '\0' || strchr("=+-@\t\r\n", *sign) == NULL)
		return false;
	return sign != s || (s[1] != '\0' && !text_parse_number(s, &value));
}

char *
text_without_quotes(const char *text, size_t n)
{
	char *word = xcalloc(n + 1, 1);
	bool quoted = false;
	size_t length = 0;
	for (size_t i = 0; i < n; i++) {
		bool twice = quoted && i + 1 < n && text[i + 1] == '"';
		if (text[i] != '"')
			word[length++] = text[i];
		else if (twice)
			word[length++] = text[i++];
		else
			quoted = !quoted;
	}
	return word;
}

char *
text_add_quotes(const char *s)
{
	char *quoted = xcalloc(2 * strlen(s) + 3, 1), *to = quoted;
	*to++ = '"';
	for (; *s != '\0'; s++) {
		if (*s == '"')
			*to++ = '"';
		*to++ = *s;
	}
	*to = '"';
	return quoted;
}

void
text_write_csv_cell(const char *text, char separator, FILE *out)
{
	const char marks[] = {separator, '"', '\n', '\r', '\0'};
	const char *guard = text_may_be_formula(text) ? "'" : "";
	if (strpbrk(text, marks) == NULL) {
		fprintf(out, "%s%s", guard, text);
		return;
	}
	FREED char *quoted = text_add_quotes(text);
	fprintf(out, "\"%s%s", guard, quoted + 1);
}

void
text_write_csv_number(double value, char separator, FILE *out)
{
	char text[32];
	text_shortest_exact_number(value, text);
	char *point = strchr(text, '.');
	if (separator == ';' && point != NULL)
		*point = ',';
	fputs(text, out);
}

const char *
text_column_letters(int column, char buf[static 8])
{
	enum { LETTERS = 26 };
	char *first = buf + 7;
	*first = '\0';
	for (; column > 0 && first > buf; column = (column - 1) / LETTERS)
		*--first = (char)('A' + (column - 1) % LETTERS);
	return first;
}

bool
text_ends_with(const char *s, const char *end)
{
	size_t n = strlen(s), m = strlen(end);
	return n > m && strcmp(s + n - m, end) == 0;
}

bool
text_is_same_folded(const char *a, const char *b)
{
	FREED char *fold_a = text_fold_case_and_accents(a),
		   *fold_b = text_fold_case_and_accents(b);
	return strcmp(fold_a, fold_b) == 0;
}

bool
text_is_same_but_case(const char *a, const char *b, size_t n)
{
	size_t i = 0;
	while (i < n && a[i] != '\0' &&
	       ascii_to_lower(a[i]) == ascii_to_lower(b[i]))
		i++;
	return i == n || (a[i] == '\0' && b[i] == '\0');
}

size_t
text_file_ending(const char *path, const char *const *ends, size_t n)
{
	FREED char *folded = text_fold_case_and_accents(path);
	size_t i = 0;
	while (i < n && !text_ends_with(folded, ends[i]))
		i++;
	return i;
}

bool
text_contains_folded(const char *text, const char *word)
{
	FREED char *folded = text_fold_case_and_accents(text),
		   *wanted = text_fold_case_and_accents(word);
	return strstr(folded, wanted) != NULL;
}

bool
text_find_word_in_list(const char *list, const char *word, size_t *index)
{
	size_t n = strlen(word);
	for (*index = 0; *list != '\0'; ++*index) {
		size_t m = strcspn(list, " ");
		if (n == m && strncmp(list, word, n) == 0)
			return true;
		list += m;
		list += strspn(list, " ");
	}
	return false;
}

static size_t
least_of_three(size_t a, size_t b, size_t c)
{
	size_t m = a < b ? a : b;
	return m < c ? m : c;
}

size_t
text_edit_distance(const char *a, const char *b)
{
	enum { LONGEST = 40 };
	size_t n = strlen(a), m = strlen(b);
	if (n > LONGEST || m > LONGEST)
		return strcmp(a, b) == 0 ? 0 : n > m ? n : m;
	size_t d[LONGEST + 1][LONGEST + 1];
	for (size_t i = 0; i <= n; i++)
		d[i][0] = i;
	for (size_t j = 0; j <= m; j++)
		d[0][j] = j;
	for (size_t i = 1; i <= n; i++) {
		for (size_t j = 1; j <= m; j++) {
			size_t other = a[i - 1] != b[j - 1];
			d[i][j] = least_of_three(d[i - 1][j] + 1,
			    d[i][j - 1] + 1, d[i - 1][j - 1] + other);
			bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
				       a[i - 2] == b[j - 1];
			if (swapped && d[i - 2][j - 2] + 1 < d[i][j])
				d[i][j] = d[i - 2][j - 2] + 1;
		}
	}
	return d[n][m];
}

/* Returns the length of the UTF-8 sequence at s (at most n bytes), or 0 if it
 * is malformed. */
static size_t
utf8_sequence_length(const unsigned char *s, size_t n)
{
	if (s[0] < 0x80)
		return s[0] != 0;
	size_t length = s[0] >= 0xF0 ? 4 : s[0] >= 0xE0 ? 3 : 2;
	if (s[0] < 0xC2 || s[0] > 0xF4 || length > n)
		return 0;
	for (size_t i = 1; i < length; i++)
		if ((s[i] & 0xC0) != 0x80)
			return 0;
	/* Overlong forms, halves of UTF-16 pairs, and codes above U+10FFFF. */
	bool overlong =
	    (s[0] == 0xE0 && s[1] < 0xA0) || (s[0] == 0xF0 && s[1] < 0x90);
	bool outside =
	    (s[0] == 0xED && s[1] >= 0xA0) || (s[0] == 0xF4 && s[1] >= 0x90);
	return overlong || outside ? 0 : length;
}

bool
text_is_utf8(const char *s, size_t n)
{
	for (size_t i = 0; i < n;) {
		size_t step =
		    utf8_sequence_length((const unsigned char *)s + i, n - i);
		if (step == 0)
			return false;
		i += step;
	}
	return true;
}

uint32_t
text_next_code_point(const char **text)
{
	const unsigned char *p = (const unsigned char *)*text;
	size_t n = utf8_sequence_length(p, 4);
	*text += n > 0 ? n : 1;
	if (n < 2)
		return n > 0 ? p[0] : 0xFFFD;
	uint32_t code = p[0] & (0x7Fu >> n);
	for (size_t i = 1; i < n; i++)
		code = code << 6 | (p[i] & 0x3F);
	return code;
}

size_t
text_bytes_up_to_limit(const char *s, size_t most)
{
	size_t n = strnlen(s, most);
	while (n > 0 && (s[n] & 0xC0) == 0x80)
		n--;
	return n;
}

size_t
text_shared_prefix_bytes(const char *a, const char *b)
{
	size_t n = 0;
	while (a[n] != '\0' && a[n] == b[n])
		n++;
	return text_bytes_up_to_limit(a, n);
}

FILE *
text_open_memory(char **text, size_t *n)
{
	FILE *file = open_memstream(text, n);
	if (file == NULL)
		xalloc_fail();
	return file;
}

enum text_line
text_read_line(char **text, size_t *n, size_t *room, FILE *in)
{
	enum { MOST = 10 * 1000 * 1000 };
	size_t from = *n;
	for (int c = 0; c != '\n' && (c = getc(in)) != EOF; (*n)++) {
		if (*n >= MOST)
			return TEXT_TOO_LONG;
		if (*n + 2 > *room) {
			*room = 2 * *room + 128;
			*text = xrealloc(*text, *room, 1);
		}
		(*text)[*n] = (char)c;
		bool alone = c == '\r' && ungetc(getc(in), in) != '\n';
		c = alone ? '\n' : c;
	}
	if (*n == from)
		return TEXT_END;
	(*text)[*n] = '\0';
	return ferror(in) ? TEXT_END : TEXT_LINE;
}

uint64_t
text_fnv1a_digest(uint64_t h, const void *bytes, size_t n)
{
	const unsigned char *b = bytes;
	for (size_t i = 0; i < n; i++)
		h = (h ^ b[i]) * UINT64_C(0x100000001b3);
	return h;
}

int
text_columns_of_character(uint32_t code)
{
	int columns = code < 0x80 ? 1 : wcwidth((wchar_t)code);
	return columns < 0 ? 1 : columns;
}

int
text_escape_next_character(const char **text, char shown[static TEXT_SHOWN])
{
	const char *from = *text;
	uint32_t code = text_next_code_point(text);
	int n = (int)(*text - from);
	if (n == 1 && (code >= 0x80 || text_is_hidden_character(code)))
		return snprintf(shown, TEXT_SHOWN, "\\x%02x",
		    (unsigned)(unsigned char)*from);
	if (text_is_hidden_character(code))
		return snprintf(shown, TEXT_SHOWN,
		    code > 0xFFFF ? "\\U%08x" : "\\u%04x", (unsigned)code);
	memcpy(shown, from, (size_t)n);
	shown[n] = '\0';
	return text_columns_of_character(code);
}

char *
text_with_control_escaped(const char *s)
{
	/* No byte becomes longer than the four characters of \x1b. */
	char *whole = xcalloc(4 * strlen(s) + 1, 1), *end = whole;
	char shown[TEXT_SHOWN];
	while (*s != '\0') {
		text_escape_next_character(&s, shown);
		end = stpcpy(end, shown);
	}
	return whole;
}

void
text_print_escaped(const char *s, FILE *out)
{
	char shown[TEXT_SHOWN];
	while (*s != '\0') {
		text_escape_next_character(&s, shown);
		fputs(shown, out);
	}
}

void
text_print_xml(const char *s, FILE *out)
{
	FREED char *shown = text_with_control_escaped(s);
	for (const char *p = shown; *p != '\0'; p++) {
		const char *entity = *p == '<'   ? "&lt;"
				     : *p == '>' ? "&gt;"
				     : *p == '&' ? "&amp;"
						 : NULL;
		if (entity != NULL)
			fputs(entity, out);
		else
			fputc(*p, out);
	}
}

int
text_width_in_columns(const char *s)
{
	int width = 0;
	char shown[TEXT_SHOWN];
	while (*s != '\0')
		width += text_escape_next_character(&s, shown);
	return width;
}

/* Replaces the rest of a text that is cut. */
static const char MORE[] = " ..";

char *
text_cut_to_width(const char *s, int columns)
{
	enum { LEAST = 2 };
	const int more = (int)strlen(MORE);
	size_t n = strlen(s), blank = strspn(s, " "), word = 0, letter = 0;
	size_t start = blank; /* of the word that contains the last letter
			       * kept */
	while (n > 0 && s[n - 1] == ' ')
		n--;
	int width = 0;
	for (const char *p = s; p < s + n;) {
		char shown[TEXT_SHOWN];
		size_t at = (size_t)(p - s);
		if (*p == ' ' && at > blank + LEAST && width + more <= columns)
			word = p[-1] == ' ' ? word : at;
		width += text_escape_next_character(&p, shown);
		if (width + more - 1 > columns)
			continue;
		start = s[at] == ' ' ? at + 1 : start;
		letter = (size_t)(p - s);
	}
	if (width <= columns)
		return xstrdup(s);
	if (word > 0)
		return xasprintf("%.*s%s", (int)word, s, MORE);
	char first = s[start + strspn(s + start, "+-.")];
	return (first >= '0' && first <= '9') || letter < start + LEAST
		   ? xstrdup("")
		   : xasprintf("%.*s%s", (int)letter, s, MORE + 1);
}

void
text_print_hanging(
    const char *text, int column, int margin, int width, FILE *out)
{
	FREED char *copy = text_with_control_escaped(text);
	char *save = NULL, *word = strtok_r(copy, " ", &save);
	while (word != NULL) {
		fputs(word, out);
		column += text_width_in_columns(word);
		word = strtok_r(NULL, " ", &save);
		if (word == NULL)
			break;
		bool fits = column + 1 + text_width_in_columns(word) <= width;
		fprintf(out, "%s%*s", fits ? "" : "\n", fits ? 1 : margin, "");
		column = fits ? column + 1 : margin;
	}
	fputc('\n', out);
}

void
text_print_wrapped(const char *text, int margin, int width, FILE *out)
{
	int blanks = (int)strspn(text, " ");
	margin += blanks;
	fprintf(out, "%*s", text[blanks] != '\0' ? margin : 0, "");
	text_print_hanging(text, margin, margin, width, out);
}

char *
text_wrapped(const char *text, int width)
{
	char *lines = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&lines, &n);
	text_print_wrapped(text, 0, width, out);
	fclose(out);
	return lines;
}

int
text_count_rows(const char *text, int width)
{
	FREED char *lines = text_wrapped(text, width);
	int n = 0;
	for (const char *p = lines; *p != '\0'; p++)
		n += *p == '\n';
	return text[0] != '\0' ? n : 0;
}
