/* Decodes bytes as UTF-8, UTF-16 or Windows-1252.  It does not use iconv,
 * because the encodings that iconv knows, and their names, depend on the
 * system.  utf8proc composes letters with their accents.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/encoding.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <utf8proc.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

/* Windows-1252 from 0x80 to 0x9F, 0 where it has no character.  Source:
 * unicode.org, MAPPINGS/VENDORS/MICSFT/WINDOWS/CP1252.TXT. */
static const uint16_t C1[32] = {0x20AC, 0, 0x201A, 0x0192, 0x201E, 0x2026,
    0x2020, 0x2021, 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0, 0x017D, 0, 0,
    0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x02DC, 0x2122,
    0x0161, 0x203A, 0x0153, 0, 0x017E, 0x0178};

static char *
append_utf8_char(char *to, uint32_t code)
{
	return to + utf8proc_encode_char(
			(utf8proc_int32_t)code, (utf8proc_uint8_t *)to);
}

static struct decoded
decode_windows_1252(const char *bytes, size_t n)
{
	struct decoded d = {ENCODING_1252, xcalloc(3 * n + 1, 1), 0, 0, NULL};
	char *to = d.text;
	for (size_t i = 0; i < n; i++) {
		unsigned char c = (unsigned char)bytes[i];
		uint32_t code = c >= 0x80 && c < 0xA0 ? C1[c - 0x80] : c;
		bool none = code == 0 && bytes[i] != '\0';
		if (none && d.wrong == NULL) {
			d.wrong =
			    tr("expected UTF-8 or Windows-1252, got a byte "
			       "of neither");
			d.bad = (size_t)(to - d.text);
		}
		to = append_utf8_char(to, none ? 0xFFFD : code);
	}
	d.n = (size_t)(to - d.text);
	return d;
}

/* If some non-ASCII characters are valid UTF-8 and others are not, the file is
 * damaged: read as Windows-1252, the valid ones would become wrong letters. */
static struct decoded
decode_utf8_or_1252(const char *bytes, size_t n)
{
	size_t bad = n;
	bool beyond_ascii = false;
	for (size_t i = 0; i < n;) {
		utf8proc_int32_t code;
		utf8proc_ssize_t k =
		    utf8proc_iterate((const utf8proc_uint8_t *)bytes + i,
			(utf8proc_ssize_t)(n - i), &code);
		beyond_ascii = beyond_ascii || k > 1;
		if (k < 1 && bad == n)
			bad = i;
		i += k > 0 ? (size_t)k : 1;
	}
	if (bad < n && !beyond_ascii)
		return decode_windows_1252(bytes, n);
	struct decoded d = {ENCODING_UTF8, xcalloc(n + 1, 1), n, bad, NULL};
	memcpy(d.text, bytes, n);
	if (bad < n)
		d.wrong =
		    tr("expected UTF-8, got UTF-8 with a damaged character");
	return d;
}

static unsigned
read_utf16_unit(const char *bytes, bool big)
{
	unsigned a = (unsigned char)bytes[!big], b = (unsigned char)bytes[big];
	return a << 8 | b;
}

/* Returns the character at *i and moves *i past it.  Returns UINT32_MAX for
 * half a surrogate pair. */
static uint32_t
decode_next_utf16_char(const char *bytes, size_t n, bool big, size_t *i)
{
	if (*i + 2 > n)
		return UINT32_MAX;
	unsigned first = read_utf16_unit(bytes + *i, big);
	*i += 2;
	if (first < 0xD800 || first > 0xDFFF)
		return first;
	unsigned second = *i + 2 <= n ? read_utf16_unit(bytes + *i, big) : 0;
	if (first > 0xDBFF || second < 0xDC00 || second > 0xDFFF)
		return UINT32_MAX;
	*i += 2;
	return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
}

static struct decoded
decode_utf16(const char *bytes, size_t n, bool big)
{
	struct decoded d = {
	    ENCODING_UTF16, xcalloc(3 * (n / 2) + 4, 1), 0, 0, NULL};
	char *to = d.text;
	for (size_t i = 0; i < n;) {
		uint32_t code = decode_next_utf16_char(bytes, n, big, &i);
		if (code == UINT32_MAX) {
			d.wrong = tr("expected text, got damaged UTF-16");
			break;
		}
		to = append_utf8_char(to, code);
	}
	d.n = d.bad = (size_t)(to - d.text);
	return d;
}

struct decoded
encoding_decode(const char *bytes, size_t n)
{
	if (n >= 2 && memcmp(bytes, "\xFF\xFE", 2) == 0)
		return decode_utf16(bytes + 2, n - 2, false);
	if (n >= 2 && memcmp(bytes, "\xFE\xFF", 2) == 0)
		return decode_utf16(bytes + 2, n - 2, true);
	if (n > 3 && (bytes[0] == 0) != (bytes[1] == 0) &&
	    (bytes[0] == 0) == (bytes[2] == 0) &&
	    (bytes[1] == 0) == (bytes[3] == 0))
		return decode_utf16(bytes, n, bytes[0] == 0);
	if (n >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0)
		return decode_utf8_or_1252(bytes + 3, n - 3);
	return decode_utf8_or_1252(bytes, n);
}

/* Returns false if there is nothing to compose, or a letter has very many
 * accents: utf8proc sorts these by exchanging neighbours, which would take too
 * long for a million of them. */
static bool
should_compose_accents(const char *text)
{
	enum { MOST_MARKS = 30 };
	bool plain = true;
	for (int marks = 0; *text != '\0';) {
		uint32_t code = text_next_code_point(&text);
		const utf8proc_property_t *about =
		    utf8proc_get_property((utf8proc_int32_t)code);
		marks = about->combining_class > 0 ? marks + 1 : 0;
		if (marks > MOST_MARKS)
			return false;
		plain = plain && code < 0x300;
	}
	return !plain;
}

char *
encoding_to_nfc(const char *text)
{
	utf8proc_uint8_t *composed =
	    should_compose_accents(text)
		? utf8proc_NFC((const utf8proc_uint8_t *)text)
		: NULL;
	return composed != NULL ? (char *)composed : xstrdup(text);
}
