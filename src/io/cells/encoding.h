/* Converts the text of a file from its encoding to UTF-8.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ENCODING_H
#define TIPSPEED_IO_CELLS_ENCODING_H

#include <stddef.h>

/* The text of a file, n bytes of UTF-8 without a byte order mark; never NULL.
 * encoding: UTF-16 is recognised by its byte order mark, or by zeros beside the
 * first two characters; Windows-1252 by bytes that are invalid in UTF-8, if
 * there are no non-ASCII characters that are valid; everything else is UTF-8.
 * wrong: what is wrong at byte `bad` of the text, or NULL. */
enum encoding { ENCODING_UTF8, ENCODING_UTF16, ENCODING_1252 };
struct decoded {
	enum encoding encoding;
	char *text;
	size_t n, bad;
	const char *wrong;
};

/* Decodes n bytes.  The caller frees the result's text. */
struct decoded encoding_decode(const char *bytes, size_t n);

/* Returns a copy in which a letter and its accent are one character (NFC), as
 * most keyboards produce.  A text with more than 30 accents on one letter is
 * copied unchanged.  The caller frees it. */
char *encoding_to_nfc(const char *text);

#endif
