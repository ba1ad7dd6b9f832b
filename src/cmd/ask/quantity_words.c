/* Parses quantities as typed, writes them for people and as keys with units,
 * and checks that the feed covers them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/quantity_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/sieve_size.h"
#include "io/sitefile/units.h"

static bool error_expected_quantity(const char *text, struct error *error);

/* Parses a size in mm, with or without "mm" after it, or the name of a sieve.
 */
static bool
parse_mm_to_metres(const char *text, double *m)
{
	FREED char *word = xstrdup(text);
	double mm = sieve_mm_of_name(text, SIEVE_NONE);
	if (text_ends_with(word, "mm"))
		word[strlen(word) - 2] = '\0';
	bool ok = (mm > 0 || text_parse_typed_number(word, &mm)) &&
		  mm >= SIZE_LEAST_MM && mm <= SIZE_MOST_MM;
	if (ok)
		*m = mm / 1000;
	return ok;
}

bool
quantities_parse_size_fraction(
    const char *text, struct fraction *fraction, struct error *error)
{
	const char *slash = strchr(text, '/');
	double coarse = 0, fine = 0;
	if (slash != NULL) {
		FREED char *lower = xstrndup(text, (size_t)(slash - text));
		bool zero = text_parse_number(lower, &fine) && fine == 0;
		if (!zero && !parse_mm_to_metres(lower, &fine))
			slash = NULL;
	}
	if (slash == NULL || !parse_mm_to_metres(slash + 1, &coarse) ||
	    fine >= coarse)
		return error_set(error, ERROR_USAGE,
		    "expected a fraction in mm, finer/coarser, got '%s'\n"
		    "write one such as 0/4 or 4/8",
		    text);
	fraction->fine = fine;
	fraction->coarse = coarse;
	return true;
}

/* These functions parse the quantities of KINDS.  text: all that was typed, for
 * the error; rest: what follows the word of the kind. */
static bool
parse_passing_quantity(
    const char *text, const char *rest, struct quantity *q, struct error *error)
{
	return parse_mm_to_metres(rest, &q->x) ||
	       error_expected_quantity(text, error);
}

/* Parses P80 or D80. */
static bool
parse_size_at_passing(
    const char *text, const char *rest, struct quantity *q, struct error *error)
{
	double percent;
	if (strchr("PpDd", rest[0]) == NULL ||
	    !text_parse_number(rest + (rest[0] != '\0'), &percent) ||
	    percent <= 0 || percent >= 100)
		return error_expected_quantity(text, error);
	q->letter = strchr("Dd", rest[0]) != NULL ? 'D' : 0;
	q->x = percent / 100;
	return true;
}

static bool
parse_fraction_bounds(
    const char *text, const char *rest, struct quantity *q, struct error *error)
{
	if (strchr(rest, '/') == NULL)
		return error_expected_quantity(text, error);
	return quantities_parse_size_fraction(rest, &q->fraction, error);
}

static bool
parse_fineness_modulus(
    const char *text, const char *rest, struct quantity *q, struct error *error)
{
	(void)text;
	for (size_t i = 0; i < MODULI; i++)
		if (rest[0] == '\0' ||
		    text_is_same_folded(rest, MODULUS[i].name)) {
			q->modulus = &MODULUS[i];
			return true;
		}
	return error_set(error, ERROR_USAGE,
	    "expected the standard of a fineness modulus, got '%s'\n"
	    "write fm EN, fm ASTM, fm IS, fm DIN or fm GB",
	    rest);
}

enum { OFFERS = 3 };
static const struct {
	/* How the kind is written: for people, as a key, as typed, and with
	 * which unit; %s stands for quantity_text_without_kind.  word: how it
	 * begins when typed, or NULL. */
	const char *words, *key, *typed, *unit, *word;
	/* Parses what follows the word; NULL if nothing may. */
	bool (*read)(const char *text, const char *rest, struct quantity *q,
	    struct error *error);
	/* What errors suggest to type, and what completion of a goal offers. */
	const char *examples, *offers[OFFERS];
} KINDS[] = {
    [QUANTITY_SIZE] = {"%s", "p%s", "p%s", " mm", NULL, parse_size_at_passing,
	"P80, D10", {"p80=", "p50=", "p20="}},
    [QUANTITY_PASSING] = {N_("passing %s mm"), "passing_%s", "passing %s mm",
	" %", "passing", parse_passing_quantity, "passing 2, fines",
	{"passing ", "fines<"}},
    [QUANTITY_SHARE] = {"%s", "share", "%s", " %", "share",
	parse_fraction_bounds, "0/2", {"0/2>="}},
    [QUANTITY_MODULUS] = {N_("fineness modulus (%s)"), "fm_%s", "fm %s", "",
	"fm", parse_fineness_modulus, "fm EN", {"fm EN="}},
    [QUANTITY_UNIFORMITY] = {N_("Cu (D60/D10)"), "cu", "cu", "", "cu", NULL,
	"cu", {"cu<"}},
    [QUANTITY_CURVATURE] = {N_("Cc (D30^2/(D60 D10))"), "cc", "cc", "", "cc",
	NULL, "cc", {"cc<"}},
    [QUANTITY_STEP] = {N_("between two sieves"), "step", "step", " %", NULL,
	NULL, NULL, {NULL}},
};

static bool
error_expected_quantity(const char *text, struct error *error)
{
	FREED char *examples = xstrdup("");
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++)
		if (KINDS[i].examples != NULL)
			xappend_to_list(
			    &examples, ", ", "%s", KINDS[i].examples);
	return error_set(error, ERROR_USAGE,
	    "expected a quantity, got '%s'\n"
	    "write one of: %s; and of a fraction: passing 0.5 of 0/4",
	    text, examples);
}

const char *
quantities_nth_completion(size_t n)
{
	for (size_t kind = 0; kind < ARRAY_LEN(KINDS); kind++)
		for (size_t i = 0; i < OFFERS; i++)
			if (KINDS[kind].offers[i] != NULL && n-- == 0)
				return KINDS[kind].offers[i];
	return NULL;
}

/* Returns what follows the kind's word and spaces, or NULL if the text does not
 * begin with that word.  Nothing may follow the word of a kind without
 * argument. */
static const char *
text_after_quantity_kind(const char *text, enum quantity_kind kind)
{
	const char *word = KINDS[kind].word;
	size_t n = word != NULL ? strlen(word) : 0;
	bool alone = strstr(KINDS[kind].typed, "%s") == NULL;
	if (n == 0 || !text_is_same_but_case(text, word, n) ||
	    (alone && text[n] != '\0'))
		return NULL;
	return text + n + strspn(text + n, " _-");
}

/* Returns the kind whose word the text begins with, the longest of several.
 * Without one, a text with "/" is a fraction, any other a size such as P80. */
static enum quantity_kind
parse_quantity_kind(const char *text, const char **rest)
{
	enum quantity_kind kind =
	    strchr(text, '/') != NULL ? QUANTITY_SHARE : QUANTITY_SIZE;
	*rest = text;
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++) {
		const char *after =
		    text_after_quantity_kind(text, (enum quantity_kind)i);
		if (after != NULL && after > *rest) {
			kind = (enum quantity_kind)i;
			*rest = after;
		}
	}
	return kind;
}

/* Words before a size for what passes it or is retained on it. */
static const struct {
	const char *word;
	bool retained;
} BEFORE[] = {{"over ", true}, {"above ", true}, {"coarser than ", true},
    {"retained on ", true}, {"passing ", false}, {"passes ", false},
    {"under ", false}, {"below ", false}, {"finer than ", false}, {"<", false}};

size_t
quantities_word_before_size(const char *text, bool *retained)
{
	*retained = false;
	for (size_t i = 0; i < ARRAY_LEN(BEFORE); i++) {
		size_t n = strlen(BEFORE[i].word);
		if (!text_is_same_but_case(text, BEFORE[i].word, n))
			continue;
		*retained = BEFORE[i].retained;
		return n;
	}
	return 0;
}

/* What is retained on a size is the fraction from it to the largest size. */
static bool
parse_quantity_by_kind(
    const char *text, struct quantity *q, struct error *error)
{
	const char *rest;
	bool retained;
	size_t word = quantities_word_before_size(text, &retained);
	q->kind = parse_quantity_kind(text, &rest);
	if (retained) {
		q->kind = QUANTITY_SHARE;
		q->fraction.coarse = SIZE_MOST_MM / 1000;
		return parse_mm_to_metres(text + word, &q->fraction.fine) ||
		       error_expected_quantity(text, error);
	}
	if (word > 0) {
		q->kind = QUANTITY_PASSING;
		rest = text + word;
	}
	if (text_is_same_folded(text, "fines")) {
		q->kind = QUANTITY_PASSING;
		q->x = QUANTITIES_FINES;
		q->letter = 'f';
		return true;
	}
	return KINDS[q->kind].read == NULL ||
	       KINDS[q->kind].read(text, rest, q, error);
}

bool
quantities_parse_one(const char *text, const struct partition *partition,
    struct quantity *q, struct error *error)
{
	char *copy = xstrdup(text), *word = text_trim(copy);
	char *of = strstr(word, " of ");
	bool ok = true;
	*q = (struct quantity){.kind = QUANTITY_SHARE};
	if (of != NULL) {
		*of = '\0';
		ok = quantities_parse_size_fraction(
		    text_trim(of + 4), &q->fraction, error);
	}
	ok = ok && parse_quantity_by_kind(text_trim(word), q, error);
	if (ok && of != NULL && q->kind == QUANTITY_SHARE)
		ok = error_expected_quantity(text, error);
	q->fraction.partition = *partition;
	free(copy);
	return ok;
}

bool
quantities_is_beginning_of_text(const char *text)
{
	struct quantity q;
	size_t item = text_length_of_list_item(text);
	size_t n = strcspn(text, " \t<>=");
	n = n < item ? n : item;
	FREED char *word = xstrndup(text, n);
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++) {
		const char *first = KINDS[i].word;
		if (first != NULL && strcspn(first, " ") == n &&
		    text_is_same_but_case(first, word, n))
			return true;
	}
	for (size_t i = 0; i < ARRAY_LEN(BEFORE); i++)
		if (n > 0 && text_is_same_but_case(BEFORE[i].word, word, n) &&
		    BEFORE[i].word[n] == ' ')
			return true;
	return quantities_parse_one(word, &PARTITION_IDEAL, &q, NULL);
}

bool
quantities_apply_cut_option(
    struct quantity *q, const struct fraction *cut, struct error *error)
{
	FREED char *name = quantities_text_to_type(q);
	if (q->kind == QUANTITY_SHARE && fraction_is_screened(cut))
		return error_set(error, ERROR_USAGE,
		    "%s is itself a fraction, and cut= names another one\n"
		    "leave out cut=, or ask for the fraction by itself: its "
		    "share is of the whole product",
		    name);
	if (!fraction_is_screened(&q->fraction))
		q->fraction = *cut;
	return true;
}

bool
quantities_check_feed_covers(
    const struct quantity *q, const struct psd *feed, struct error *error)
{
	double point[QUANTITY_POINTS];
	size_t n = quantity_sizes_needed(q, point);
	for (size_t i = 0; i < n; i++)
		if (!psd_covers_size(feed, point[i]))
			return error_set(error, ERROR_USAGE,
			    "%g mm is finer than the feed's finest sieve, %g "
			    "mm\nuse a size on or above that sieve",
			    units_m_to_mm(point[i]),
			    units_m_to_mm(feed->size[feed->n - 1]));
	return true;
}

/* Refuses "passing 2,4", which may mean 2.4 mm or the two sizes; not "0,5". */
static bool
check_comma_has_one_meaning(
    const char *word, const struct quantity *q, struct error *error)
{
	const char *comma = strchr(word, ',');
	double mm = units_m_to_mm(
	    q->kind == QUANTITY_PASSING ? q->x : q->fraction.fine);
	bool retained;
	bool size = q->kind == QUANTITY_PASSING ||
		    quantities_word_before_size(word, &retained) > 0;
	int n = (int)strcspn(word, "0123456789");
	if (comma == NULL || !size || mm < 1 || comma[1] == '0')
		return true;
	FREED char *one = xstrdup(word);
	one[comma - word] = '.';
	return error_set(error, ERROR_USAGE,
	    "expected one size, got '%.0f,%s'\nwrite \"%s\" or, for two sizes, "
	    "\"%.*s%.0f, %.*s%s\"",
	    floor(mm), comma + 1, one, n, word, floor(mm), n, word, comma + 1);
}

struct quantity *
quantities_parse_list_for_feed(const char *text, const struct fraction *cut,
    const struct psd *feed, bool all, size_t *n, struct error *error)
{
	struct quantity *list = xcalloc(strlen(text) + 1, sizeof *list);
	bool ok = true;
	*n = 0;
	for (const char *at = text; ok && *at != '\0';) {
		size_t length = text_length_of_list_item(at);
		FREED char *word = xstrndup(at, length);
		struct quantity *q = &list[*n];
		ok = quantities_parse_one(word, &cut->partition, q, error) &&
		     check_comma_has_one_meaning(word, q, error) &&
		     quantities_apply_cut_option(q, cut, error);
		if (ok &&
		    quantities_check_feed_covers(q, feed, all ? error : NULL))
			++*n;
		else
			ok = ok && !all;
		at += length + (at[length] != '\0');
	}
	if (ok)
		return list;
	free(list);
	return NULL;
}

char *
quantities_fraction_text(const struct fraction *fraction)
{
	return xasprintf("%g/%g", units_m_to_mm(fraction->fine),
	    units_m_to_mm(fraction->coarse));
}

enum form { FOR_PEOPLE, AS_KEY, AS_TYPED };

/* True for "over 8", the fraction up to the largest size. */
static bool
is_retained_quantity(const struct quantity *q)
{
	return q->kind == QUANTITY_SHARE &&
	       q->fraction.coarse >= SIZE_MOST_MM / 1000;
}

/* Returns the size, percentage, fraction or standard of a quantity, or "".  The
 * caller frees it. */
static char *
quantity_text_without_kind(const struct quantity *q, enum form form)
{
	char letter[] = {q->letter != 0 ? q->letter : 'P', '\0'};
	switch (q->kind) {
	case QUANTITY_PASSING:
		return xasprintf("%g", units_m_to_mm(q->x));
	case QUANTITY_SIZE:
		return xasprintf("%s%g", form == FOR_PEOPLE ? letter : "",
		    units_fraction_to_pct(q->x));
	case QUANTITY_SHARE:
		if (is_retained_quantity(q))
			return xasprintf(
			    form == FOR_PEOPLE ? tr("over %g mm") : "over %g",
			    units_m_to_mm(q->fraction.fine));
		return quantities_fraction_text(&q->fraction);
	case QUANTITY_MODULUS:
		return xstrdup(form == FOR_PEOPLE ? q->modulus->standard
						  : q->modulus->name);
	default:
		return xstrdup("");
	}
}

/* Returns words of KINDS with %s replaced by the argument.  The caller frees
 * it. */
static char *
put_argument_into_quantity_name(
    const char *words, const struct quantity *q, enum form form)
{
	const char *at = strstr(words, "%s");
	FREED char *name = quantity_text_without_kind(q, form);
	return at == NULL ? xstrdup(words)
			  : xasprintf("%.*s%s%s", (int)(at - words), words,
				name, at + strlen("%s"));
}

/* Appends " of 0/4" if the quantity is one of a fraction. */
static char *
append_fraction_name(char *words, const struct quantity *q)
{
	if (q->kind == QUANTITY_SHARE || !fraction_is_screened(&q->fraction))
		return words;
	FREED char *fraction = quantities_fraction_text(&q->fraction);
	xappend(&words, " of %s", fraction);
	return words;
}

static bool
is_fines_quantity(const struct quantity *q)
{
	return q->kind == QUANTITY_PASSING && q->letter != 0;
}

char *
quantities_name(const struct quantity *q)
{
	return append_fraction_name(
	    is_fines_quantity(q) ? xstrdup(tr("fines"))
				 : put_argument_into_quantity_name(
				       tr(KINDS[q->kind].words), q, FOR_PEOPLE),
	    q);
}

char *
quantities_sentence_with_value(const struct quantity *q, double value)
{
	double shown = quantities_value_in_shown_unit(q, value);
	if (q->kind == QUANTITY_PASSING && !fraction_is_screened(&q->fraction))
		return xasprintf(
		    tr("%.1f %% passes %g mm"), shown, units_m_to_mm(q->x));
	FREED char *words = quantities_name(q);
	return xasprintf(tr("%s is %.*f%s"), words, quantities_decimals(q),
	    shown, quantities_unit_suffix(q));
}

char *
quantities_text_to_type(const struct quantity *q)
{
	const char *typed =
	    is_fines_quantity(q) ? "fines" : KINDS[q->kind].typed;
	return append_fraction_name(
	    put_argument_into_quantity_name(typed, q, AS_TYPED), q);
}

char *
quantities_field_name(const struct quantity *q)
{
	char *key =
	    put_argument_into_quantity_name(KINDS[q->kind].key, q, AS_KEY);
	const char *unit = quantities_unit(q);
	if (is_retained_quantity(q))
		xappend(&key, "_over_%g", units_m_to_mm(q->fraction.fine));
	else if (fraction_is_screened(&q->fraction))
		xappend(&key, "_%g_%g", units_m_to_mm(q->fraction.fine),
		    units_m_to_mm(q->fraction.coarse));
	if (unit[0] != '\0')
		xappend(&key, "_%s", unit[0] == '%' ? "pct" : unit);
	return key;
}

char *
quantities_band_text(double low, double high, int decimals)
{
	if (isfinite(low) && isfinite(high))
		return xasprintf(
		    tr(" (%.*f to %.*f)"), decimals, low, decimals, high);
	return isfinite(high) ? xasprintf(tr(" (at most %.*f)"), decimals, high)
	       : isfinite(low)
		   ? xasprintf(tr(" (at least %.*f)"), decimals, low)
		   : xstrdup("");
}

const char *
quantities_unit_suffix(const struct quantity *q)
{
	return KINDS[q->kind].unit;
}

const char *
quantities_difference_suffix(const struct quantity *q)
{
	const char *unit = quantities_unit_suffix(q);
	return strcmp(unit, " %") == 0 ? tr(" points") : unit;
}

const char *
quantities_unit(const struct quantity *q)
{
	const char *after = quantities_unit_suffix(q);
	return after[0] == ' ' ? after + 1 : after;
}

bool
quantities_is_size(const struct quantity *q)
{
	return strcmp(quantities_unit(q), "mm") == 0;
}

double
quantities_value_in_shown_unit(const struct quantity *q, double value)
{
	const char *unit = quantities_unit(q);
	return strcmp(unit, "%") == 0    ? units_fraction_to_pct(value)
	       : strcmp(unit, "mm") == 0 ? units_m_to_mm(value)
					 : value;
}

int
quantities_decimals(const struct quantity *q)
{
	return strcmp(quantities_unit(q), "%") == 0 ? 1 : 2;
}
