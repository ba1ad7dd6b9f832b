/* The meanings of words in sieve sheets, in several languages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LEXICON_H
#define TIPSPEED_IO_SITEFILE_LEXICON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The meanings of a word, as bits.  A word can have several. */
#define WORD_FEED (UINT64_C(1) << 0)
#define WORD_PRODUCT (UINT64_C(1) << 1)
#define WORD_SD (UINT64_C(1) << 2)
#define WORD_PASSES (UINT64_C(1) << 3)
#define WORD_STAYS (UINT64_C(1) << 4)
#define WORD_SUMS (UINT64_C(1) << 5) /* cumulative */
#define WORD_SHARE (UINT64_C(1) << 6)
#define WORD_PERCENT (UINT64_C(1) << 7)
#define WORD_GRAMS (UINT64_C(1) << 8)
#define WORD_MASS (UINT64_C(1) << 9)
#define WORD_SIZE (UINT64_C(1) << 10)
#define WORD_MM (UINT64_C(1) << 11)
#define WORD_UM (UINT64_C(1) << 12)
#define WORD_M (UINT64_C(1) << 13)
#define WORD_INCH (UINT64_C(1) << 14)
#define WORD_SPEED (UINT64_C(1) << 15)
#define WORD_LIMIT (UINT64_C(1) << 16)  /* a limit, not a sample */
#define WORD_OTHER (UINT64_C(1) << 17)  /* remarks, dates: not a sieve */
#define WORD_SAMPLE (UINT64_C(1) << 18) /* a sample of unstated material */
#define WORD_PAN (UINT64_C(1) << 19)
#define WORD_TOTAL (UINT64_C(1) << 20)
#define WORD_LOSS (UINT64_C(1) << 21)
#define WORD_WASHED (UINT64_C(1) << 22)
#define WORD_ROTOR (UINT64_C(1) << 23)
#define WORD_FILLER (UINT64_C(1) << 24)
#define WORD_RPM (UINT64_C(1) << 25)
#define WORD_MESH (UINT64_C(1) << 26)
#define WORD_TYLER (UINT64_C(1) << 27)
#define WORD_BS (UINT64_C(1) << 28)
#define WORD_ASTM (UINT64_C(1) << 29)
#define WORD_WEIGHED (UINT64_C(1) << 30) /* before sieving, M1 of EN 933-1 */
#define WORD_MACHINE (UINT64_C(1) << 32)
#define WORD_MEAN (UINT64_C(1) << 31) /* of samples */
#define WORD_PHI (UINT64_C(1) << 33)
#define WORD_NUMBER (UINT64_C(1) << 34) /* number of a sieve or sample */

/* True for a folded word that says when a sample was taken: "tue", "november",
 * "morning", "skift". */
bool lexicon_is_word_of_time(const char *word);

/* What the label of a cell says about a date in it.  DAY_OTHER: it is another
 * day than that of sampling, such as that of the analysis; DAY_NONE: nothing;
 * DAY_ANY: it is a day; DAY_SAMPLED: it is the day of sampling. */
enum lexicon_day { DAY_OTHER, DAY_NONE, DAY_ANY, DAY_SAMPLED };
enum lexicon_day lexicon_day_kind_of_label(const char *label);

/* True for "Date", "Provtagen", "Sample date", not for "Date of analysis". */
bool lexicon_is_date_label(const char *label);

/* Returns the meanings of one word, n bytes folded by
 * text_fold_case_and_accents, or 0 if unknown. */
uint64_t lexicon_word_meanings(const char *word, size_t n);

/* Returns the combined meanings of all words in a text.  *unknown gets the
 * number of words without a meaning; it may be NULL. */
uint64_t lexicon_text_meanings(const char *text, size_t *unknown);

/* Keys that lines above the tables begin with. */
enum lexicon_key {
	KEY_SITE,
	KEY_ROCK,
	KEY_MACHINE,
	KEY_PROVENANCE,
	KEY_TOP_SIZE,
	N_KEY
};

/* Returns the key that matches a text, ignoring case, accents and a colon at
 * its end, or N_KEY. */
enum lexicon_key lexicon_site_key_of_text(const char *text);

/* True if the label of a line or column says that its cells name sites
 * or machines: "Quarry", "Crusher No.". */
bool lexicon_is_label_of_sites(const char *label);

#endif
