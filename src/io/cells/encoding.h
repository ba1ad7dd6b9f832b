/* From the characters that a file is coded in to UTF-8.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ENCODING_H
#define TIPSPEED_IO_CELLS_ENCODING_H

#include <stddef.h>

/* Text of n bytes.  UTF-16 is recognised by its mark, or by zeros beside its
 * first two characters; Windows-1252 where some bytes are not UTF-8 and no
 * character beyond ASCII is; else it is UTF-8. text: UTF-8 without a mark,
 * never NULL. wrong: NULL, or the fault at byte `bad` of text. */
enum encoding { ENCODING_UTF8, ENCODING_UTF16, ENCODING_1252 };
struct decoded {
	enum encoding encoding;
	char *text;
	size_t n, bad;
	const char *wrong;
};

/* The caller frees text. */
struct decoded encoding_decode(const char *bytes, size_t n);

/* A copy in which a letter and its accent are one character (NFC), as they are
 * on most keyboards; text with more than 30 accents on one letter stays as it
 * is.  The caller frees. */
char *encoding_compose(const char *text);

#endif
