/* Parses typed quantities, writes them for people and as keys with units, and
 * checks that the feed covers them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/quantity_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/sieve_size.h"
#include "io/sitefile/units.h"

static bool
quantities_expected(const char *text, struct error *error)
{
	return error_set(error, ERROR_USAGE,
	    "expected a quantity, got '%s'\n"
	    "write one of: passing 2, P80, D10, fm EN, cu, cc, fines, 0/2; and "
	    "of a fraction: passing 0.5 of 0/4",
	    text);
}

/* A size in mm, which "mm" may follow, as m. */
static bool
read_size(const char *text, double *m)
{
	FREED char *word = xstrdup(text);
	double mm = sieve_name_mm(text, SIEVE_NONE);
	if (text_ends_with(word, "mm"))
		word[strlen(word) - 2] = '\0';
	bool ok = (mm > 0 || text_typed_number(word, &mm)) &&
		  mm >= SIZE_LEAST_MM && mm <= SIZE_MOST_MM;
	if (ok)
		*m = mm / 1000;
	return ok;
}

bool
quantities_fraction(
    const char *text, struct fraction *fraction, struct error *error)
{
	const char *slash = strchr(text, '/');
	double coarse = 0, fine = 0;
	if (slash != NULL) {
		FREED char *lower = xstrndup(text, (size_t)(slash - text));
		bool zero = text_number(lower, &fine) && fine == 0;
		if (!zero && !read_size(lower, &fine))
			slash = NULL;
	}
	if (slash == NULL || !read_size(slash + 1, &coarse) || fine >= coarse)
		return error_set(error, ERROR_USAGE,
		    "expected a fraction in mm, finer/coarser, got '%s'\n"
		    "write one such as 0/4 or 4/8",
		    text);
	fraction->fine = fine;
	fraction->coarse = coarse;
	return true;
}

static bool
read_modulus(const char *name, struct quantity *q, struct error *error)
{
	q->kind = QUANTITY_MODULUS;
	for (size_t i = 0; i < MODULI; i++)
		if (name[0] == '\0' ||
		    text_same_folded(name, MODULUS[i].name)) {
			q->modulus = &MODULUS[i];
			return true;
		}
	return error_set(error, ERROR_USAGE,
	    "expected the standard of a fineness modulus, got '%s'\n"
	    "write fm EN, fm ASTM, fm IS, fm DIN or fm GB",
	    name);
}

/* What follows a word at the start, without the blanks between; NULL where
 * the text begins with another word. */
static const char *
text_after_word(const char *text, const char *word)
{
	size_t n = strlen(word);
	if (strncasecmp(text, word, n) != 0)
		return NULL;
	return text + n + strspn(text + n, " _-");
}

static bool
read_kind(const char *text, struct quantity *q, struct error *error)
{
	const char *rest;
	double percent;
	if (strcasecmp(text, "fines") == 0) {
		q->kind = QUANTITY_PASSING;
		q->x = QUANTITIES_FINES;
		q->letter = 'f';
	} else if ((rest = text_after_word(text, "passing")) != NULL) {
		q->kind = QUANTITY_PASSING;
		if (!read_size(rest, &q->x))
			return quantities_expected(text, error);
	} else if ((rest = text_after_word(text, "fm")) != NULL) {
		return read_modulus(rest, q, error);
	} else if (strcasecmp(text, "cu") == 0) {
		q->kind = QUANTITY_UNIFORMITY;
	} else if (strcasecmp(text, "cc") == 0) {
		q->kind = QUANTITY_CURVATURE;
	} else if (strchr(text, '/') != NULL) {
		rest = text_after_word(text, "share");
		q->kind = QUANTITY_SHARE;
		return quantities_fraction(
		    rest != NULL ? rest : text, &q->fraction, error);
	} else if (strchr("PpDd", text[0]) != NULL &&
		   text_number(text + (text[0] != '\0'), &percent) &&
		   percent > 0 && percent < 100) {
		q->kind = QUANTITY_SIZE;
		q->letter = strchr("Dd", text[0]) != NULL ? 'D' : 0;
		q->x = percent / 100;
	} else {
		return quantities_expected(text, error);
	}
	return true;
}

bool
quantities_read(const char *text, const struct partition *partition,
    struct quantity *q, struct error *error)
{
	char *copy = xstrdup(text), *word = text_trim(copy);
	char *of = strstr(word, " of ");
	bool ok = true;
	*q = (struct quantity){.kind = QUANTITY_SHARE};
	if (of != NULL) {
		*of = '\0';
		ok =
		    quantities_fraction(text_trim(of + 4), &q->fraction, error);
	}
	ok = ok && read_kind(text_trim(word), q, error);
	if (ok && of != NULL && q->kind == QUANTITY_SHARE)
		ok = quantities_expected(text, error);
	q->fraction.partition = *partition;
	free(copy);
	return ok;
}

bool
quantities_begins(const char *text)
{
	static const struct partition SHARP = {0, 1};
	struct quantity q;
	struct error error = {0};
	FREED char *word = xstrndup(text, strcspn(text, " \t<>="));
	return strcasecmp(word, "passing") == 0 ||
	       strcasecmp(word, "share") == 0 ||
	       quantities_read(word, &SHARP, &q, &error);
}

struct quantity *
quantities_list(const char *text, const struct partition *partition, size_t *n,
    struct error *error)
{
	struct quantity *list = xcalloc(strlen(text) + 1, sizeof *list);
	*n = 0;
	for (const char *at = text; *at != '\0';) {
		size_t length = strcspn(at, ",;");
		FREED char *word = xstrndup(at, length);
		bool ok = quantities_read(word, partition, &list[*n], error);
		if (!ok) {
			free(list);
			return NULL;
		}
		++*n;
		at += length + (at[length] != '\0');
	}
	return list;
}

bool
quantities_cut(
    struct quantity *q, const struct fraction *cut, struct error *error)
{
	if (q->kind == QUANTITY_SHARE && fraction_screens(cut))
		return error_set(error, ERROR_USAGE,
		    "%g/%g names a fraction itself, and cut= another one\n"
		    "leave out cut=, or ask for it by itself: its share is "
		    "that of the whole product",
		    units_mm(q->fraction.fine), units_mm(q->fraction.coarse));
	if (!fraction_screens(&q->fraction))
		q->fraction = *cut;
	return true;
}

bool
quantities_covered(
    const struct quantity *q, const struct psd *feed, struct error *error)
{
	double point[QUANTITY_POINTS];
	size_t n = quantity_points(q, point);
	for (size_t i = 0; i < n; i++)
		if (!psd_covers(feed, point[i]))
			return error_set(error, ERROR_USAGE,
			    "%g mm is finer than the feed's finest sieve, %g "
			    "mm\nuse a size on or above that sieve",
			    units_mm(point[i]),
			    units_mm(feed->size[feed->n - 1]));
	return true;
}

struct quantity *
quantities_asked(const char *text, const struct fraction *cut,
    const struct psd *feed, bool all, size_t *n, struct error *error)
{
	struct quantity *list =
	    quantities_list(text, &cut->partition, n, error);
	bool ok = list != NULL;
	size_t kept = 0;
	for (size_t i = 0; ok && i < *n; i++) {
		struct error none = {0};
		ok = quantities_cut(&list[i], cut, error);
		if (!ok)
			break;
		if (quantities_covered(&list[i], feed, all ? error : &none))
			list[kept++] = list[i];
		else
			ok = !all;
	}
	*n = kept;
	if (ok)
		return list;
	free(list);
	return NULL;
}

char *
quantities_fraction_text(const struct fraction *fraction)
{
	return xasprintf(
	    "%g/%g", units_mm(fraction->fine), units_mm(fraction->coarse));
}

/* How each kind is written: for people, as a key, as it is typed, and the unit
 * behind a number.  %s: what tells it from others of its kind, see
 * name_in_kind. */
static const struct {
	const char *words, *key, *typed, *unit;
} KINDS[] = {
    [QUANTITY_PASSING] = {N_("passing %s mm"), "passing_%s", "passing %s mm",
	" %"},
    [QUANTITY_SIZE] = {"%s", "p%s", "p%s", " mm"},
    [QUANTITY_SHARE] = {"%s", "share", "%s", " %"},
    [QUANTITY_MODULUS] = {N_("fineness modulus (%s)"), "fm_%s", "fm %s", ""},
    [QUANTITY_UNIFORMITY] = {N_("Cu (D60/D10)"), "cu", "cu", ""},
    [QUANTITY_CURVATURE] = {N_("Cc (D30^2/(D60 D10))"), "cc", "cc", ""},
    [QUANTITY_STEP] = {N_("between two sieves"), "step", "step", " %"},
};

/* The size, percentage, fraction or standard of a quantity; for people or, with
 * key, for programs.  The caller frees. */
static char *
name_in_kind(const struct quantity *q, bool key)
{
	char letter[] = {q->letter != 0 ? q->letter : 'P', '\0'};
	switch (q->kind) {
	case QUANTITY_PASSING:
		return xasprintf("%g", units_mm(q->x));
	case QUANTITY_SIZE:
		return xasprintf("%s%g", key ? "" : letter, units_pct(q->x));
	case QUANTITY_SHARE:
		return quantities_fraction_text(&q->fraction);
	case QUANTITY_MODULUS:
		return xstrdup(key ? q->modulus->name : q->modulus->standard);
	default:
		return xstrdup("");
	}
}

/* A form of KINDS with the name in it.  The caller frees. */
static char *
fill_in_name(const char *form, const struct quantity *q, bool key)
{
	const char *at = strstr(form, "%s");
	FREED char *name = name_in_kind(q, key);
	return at == NULL ? xstrdup(form)
			  : xasprintf("%.*s%s%s", (int)(at - form), form, name,
				at + strlen("%s"));
}

/* " of 0/4" behind the words of what is not of the whole product. */
static char *
with_fraction(char *words, const struct quantity *q)
{
	if (q->kind == QUANTITY_SHARE || !fraction_screens(&q->fraction))
		return words;
	FREED char *fraction = quantities_fraction_text(&q->fraction);
	xappend(&words, " of %s", fraction);
	return words;
}

static bool
is_fines(const struct quantity *q)
{
	return q->kind == QUANTITY_PASSING && q->letter != 0;
}

char *
quantities_words(const struct quantity *q)
{
	return with_fraction(
	    is_fines(q) ? xstrdup(tr("fines"))
			: fill_in_name(tr(KINDS[q->kind].words), q, false),
	    q);
}

char *
quantities_statement(const struct quantity *q, double value)
{
	double shown = quantities_shown(q, value);
	if (q->kind == QUANTITY_PASSING && !fraction_screens(&q->fraction))
		return xasprintf(
		    tr("%.1f %% passes %g mm"), shown, units_mm(q->x));
	FREED char *words = quantities_words(q);
	return xasprintf(tr("%s is %.*f%s"), words, quantities_decimals(q),
	    shown, quantities_unit_suffix(q));
}

char *
quantities_as_typed(const struct quantity *q)
{
	const char *typed = is_fines(q) ? "fines" : KINDS[q->kind].typed;
	return with_fraction(fill_in_name(typed, q, true), q);
}

char *
quantities_key(const struct quantity *q)
{
	char *key = fill_in_name(KINDS[q->kind].key, q, true);
	const char *unit = quantities_unit(q);
	if (fraction_screens(&q->fraction))
		xappend(&key, "_%g_%g", units_mm(q->fraction.fine),
		    units_mm(q->fraction.coarse));
	if (unit[0] != '\0')
		xappend(&key, "_%s", unit[0] == '%' ? "pct" : unit);
	return key;
}

char *
quantities_band(double low, double high, int decimals)
{
	return isfinite(low) && isfinite(high)
		   ? xasprintf(
			 tr(" (%.*f to %.*f)"), decimals, low, decimals, high)
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

double
quantities_shown(const struct quantity *q, double value)
{
	const char *unit = quantities_unit(q);
	return strcmp(unit, "%") == 0    ? units_pct(value)
	       : strcmp(unit, "mm") == 0 ? units_mm(value)
					 : value;
}

int
quantities_decimals(const struct quantity *q)
{
	return strcmp(quantities_unit(q), "%") == 0 ? 1 : 2;
}

bool
quantities_option(const struct args *args, struct fraction *fraction,
    bool alone, struct error *error)
{
	*fraction = (struct fraction){0};
	if (args->cut != NULL &&
	    !quantities_fraction(args->cut, fraction, error))
		return false;
	if (args->cut == NULL && !alone &&
	    (args->sharpness > 0 || args_given(args, &args->cut_size)))
		return error_set(error, ERROR_USAGE,
		    "sharpness= and cut_size= describe the screens of cut=, "
		    "which is not given\nadd a fraction such as cut=0/4");
	fraction->partition.sharpness = args->sharpness;
	fraction->partition.cut_size = args->cut_size / 100;
	return true;
}
