/* What the words of sieve sheets mean, in the languages of their plants.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_VOCABULARY_H
#define TIPSPEED_IO_VOCABULARY_H

#include <stddef.h>

/* What a word can mean; one may mean several, as a compound does. */
enum word_meaning {
	WORD_FEED = 1 << 0,
	WORD_PRODUCT = 1 << 1,
	WORD_SD = 1 << 2,
	WORD_PASSES = 1 << 3,
	WORD_STAYS = 1 << 4,
	WORD_SUMS = 1 << 5, /* cumulative */
	WORD_SHARE = 1 << 6,
	WORD_PERCENT = 1 << 7,
	WORD_GRAMS = 1 << 8,
	WORD_MASS = 1 << 9,
	WORD_SIZE = 1 << 10,
	WORD_MM = 1 << 11,
	WORD_UM = 1 << 12,
	WORD_M = 1 << 13,
	WORD_INCH = 1 << 14,
	WORD_SPEED = 1 << 15,
	WORD_LIMIT = 1 << 16,  /* of a specification: no sample */
	WORD_OTHER = 1 << 17,  /* remark, date: no number of a sieve */
	WORD_SAMPLE = 1 << 18, /* a sample, of what is not said */
	WORD_PAN = 1 << 19,
	WORD_TOTAL = 1 << 20,
	WORD_LOSS = 1 << 21,
	WORD_WASHED = 1 << 22,
	WORD_ROTOR = 1 << 23,
	WORD_FILLER = 1 << 24,
	WORD_RPM = 1 << 25,
	WORD_MESH = 1 << 26,
	WORD_TYLER = 1 << 27,
	WORD_BS = 1 << 28,
	WORD_ASTM = 1 << 29,
	WORD_WEIGHED = 1 << 30 /* before sieving: M1 of EN 933-1 */
};

/* The meanings of n bytes of text_fold's, one word; 0 where it is unknown. */
unsigned vocabulary_word(const char *word, size_t n);

/* The meanings of all words of a text together.  unknown: how many words have
 * none (NULL: not wanted). */
unsigned vocabulary_text(const char *text, size_t *unknown);

/* What a line above the tables can tell by its first cell. */
enum vocabulary_key {
	KEY_SITE,
	KEY_ROCK,
	KEY_MACHINE,
	KEY_PROVENANCE,
	KEY_TOP_SIZE,
	N_KEY
};

/* N_KEY where a text is none of them, but for case and accents. */
enum vocabulary_key vocabulary_key(const char *text);

#endif
