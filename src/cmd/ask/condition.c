/* Parses conditions and lists of them, writes them for people and for programs,
 * and searches for the speeds at which they hold.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/condition.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/envelope.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/outlook.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

static const char DIGITS[] = "0123456789", SIZE[] = "0123456789., ";

/* Words for the largest and the smallest value; understood: by find. */
static const struct extreme {
	const char *word;
	bool most, understood;
} EXTREMES[] = {{"maximise ", true, true}, {"maximize ", true, true},
    {"minimise ", false, true}, {"minimize ", false, true},
    {"max ", true, true}, {"min ", false, true}, {"most ", true, false},
    {"best ", true, false}, {"highest ", true, false},
    {"maximum ", true, false}, {"least ", false, false},
    {"lowest ", false, false}, {"minimum ", false, false}};

/* Returns the extreme whose word the text begins with, or NULL. */
static const struct extreme *
find_extreme_word(const char *text)
{
	for (size_t i = 0; i < ARRAY_LEN(EXTREMES); i++)
		if (text_is_same_but_case(
			text, EXTREMES[i].word, strlen(EXTREMES[i].word)))
			return &EXTREMES[i];
	return NULL;
}

char *
conditions_rewrite_superlative(const char *text)
{
	const struct extreme *e = find_extreme_word(text);
	const char *of = e != NULL ? text + strlen(e->word) : "";
	const char *unit = of + strspn(of, SIZE);
	bool size = unit > of && strcmp(unit, "mm") == 0;
	return e == NULL || (e->understood && !size)
		   ? NULL
		   : xasprintf("%s %s%s", e->most ? "max" : "min",
			 size ? "passing " : "", of);
}

const char *
conditions_parse_max_or_min(const char *text, bool *most)
{
	const struct extreme *e = find_extreme_word(text);
	*most = e != NULL && e->most;
	return e != NULL && e->understood ? text + strlen(e->word) : NULL;
}

static bool
error_expected_condition(const char *text, struct error *error)
{
	FREED char *extreme = conditions_rewrite_superlative(text);
	if (extreme != NULL)
		return error_set(error, ERROR_USAGE,
		    "expected max or min and a quantity, got '%s'\n"
		    "write: find \"%s\"",
		    text, extreme);
	return error_set(error, ERROR_USAGE,
	    "expected a condition: a quantity, then <, > or = and a limit, got "
	    "'%s'\n"
	    "begin with the quantity, in quotes: \"passing 2 = 40..50\", "
	    "\"passing 0.063 < 6\", \"P80 > 5\" or \"0/2 >= 30\"",
	    text);
}

/* Sets the error for a limit outside the values that the quantity can have.
 * Returns false. */
static bool
error_limit_out_of_range(const char *text, const struct quantity *q,
    double most, struct error *error)
{
	const char *unit = quantities_unit(q);
	FREED char *range = isfinite(most)
				? xasprintf(tr("0 to %g %s"), most, unit)
				: xstrdup(tr("0 or more"));
	return error_set(error, ERROR_USAGE,
	    "expected %s, got %s\nwrite a limit within that, or after = a "
	    "range such as 40..50",
	    range, text);
}

static bool
error_expected_limit(
    const char *text, const struct quantity *q, struct error *error)
{
	const char *unit = quantities_unit(q);
	return error_set(error, ERROR_USAGE,
	    "expected a limit in %s after the sign, got '%s'\n"
	    "write a number, or after = a range such as 40..50",
	    unit[0] != '\0' ? unit : tr("numbers"), text);
}

/* Parses a number, after which the quantity's unit may follow, into core's
 * unit. */
static bool
parse_condition_limit(const char *text, const struct quantity *q, double *limit,
    struct error *error)
{
	FREED char *copy = xstrdup(text);
	char *word = text_trim(copy);
	const char *unit = quantities_unit(q);
	if (unit[0] != '\0' && text_ends_with(word, unit))
		word[strlen(word) - strlen(unit)] = '\0';
	word = text_trim(word);
	double one = quantities_value_in_shown_unit(q, 1);
	double most = unit[0] == '%'          ? 100
		      : quantities_is_size(q) ? SIZE_MOST_MM
					      : INFINITY;
	bool ok = text_parse_number(word, limit) ||
		  error_expected_limit(word, q, error);
	if (ok && (*limit < 0 || *limit > most))
		ok = error_limit_out_of_range(word, q, most, error);
	*limit /= one;
	return ok;
}

const char *
conditions_find_range_sign(const char *text, size_t *length)
{
	static const char *const SIGNS[] = {
	    "..", " to ", " and ", "\xE2\x80\x93", "-"};
	text += strspn(text, " ");
	for (size_t i = 0; i < ARRAY_LEN(SIGNS); i++) {
		const char *at = strstr(text, SIGNS[i]);
		*length = strlen(SIGNS[i]);
		if (at > text && (*at != '-' || !strchr("eE", at[-1])))
			return at;
	}
	return NULL;
}

/* Parses "40..50", or one number as both limits. */
static bool
parse_range_or_number(
    const char *text, struct condition *c, struct error *error)
{
	size_t length;
	const char *sign = conditions_find_range_sign(text, &length);
	if (sign == NULL) {
		bool ok =
		    parse_condition_limit(text, &c->quantity, &c->least, error);
		c->most = c->least;
		return ok;
	}
	FREED char *low = xstrndup(text, (size_t)(sign - text));
	bool ok =
	    parse_condition_limit(low, &c->quantity, &c->least, error) &&
	    parse_condition_limit(sign + length, &c->quantity, &c->most, error);
	if (!ok || c->least <= c->most)
		return ok;
	double least = quantities_value_in_shown_unit(&c->quantity, c->least);
	double most = quantities_value_in_shown_unit(&c->quantity, c->most);
	return error_set(error, ERROR_USAGE,
	    "expected a range from low to high, got %g..%g\nwrite %g..%g",
	    least, most, most, least);
}

static bool
error_decimal_comma(const char *text, const char *comma, struct error *error)
{
	const char *from = comma;
	while (from > text && strchr(DIGITS, from[-1]))
		from--;
	size_t n = (size_t)(comma - from);
	size_t all = n + 1 + strspn(comma + 1, DIGITS);
	FREED char *got = xstrndup(from, all), *right = xstrdup(got);
	right[n] = '.';
	return error_set(error, ERROR_USAGE,
	    "expected a number, got '%s'\nuse a decimal point: %s", got, right);
}

/* Words for the sign of a limit. */
static const struct {
	const char *words;
	char sign;
} LIMIT_WORDS[] = {{" between ", '='}, {" at least ", '>'}, {" at most ", '<'},
    {" more than ", '>'}, {" less than ", '<'}, {" min ", '>'}, {" max ", '<'}};

/* Turns "58 % passes 2 mm", as answers put it, and "58 % < 2 mm" into "passes 2
 * mm = 58 %", and "at most 6 % fines" into "fines < 6 %".  Returns NULL for
 * other texts.  The caller frees it. */
static char *
rewrite_value_first_condition(const char *text)
{
	char sign = '=';
	for (size_t i = 0; i < ARRAY_LEN(LIMIT_WORDS) && sign == '='; i++) {
		const char *words = LIMIT_WORDS[i].words + 1;
		if (!text_is_same_but_case(text, words, strlen(words)))
			continue;
		sign = LIMIT_WORDS[i].sign;
		text += strlen(words);
	}
	int n = (int)strspn(text, "0123456789.,");
	const char *of = text + n + strspn(text + n, " %");
	bool percent = strchr(text, '%') != NULL, retained;
	size_t word = quantities_word_before_size(of, &retained);
	struct quantity q;
	bool named = word > 0 ? percent || *of != '<'
			      : percent && quantities_parse_one(
					       of, &PARTITION_IDEAL, &q, NULL);
	return n > 0 && named && strpbrk(of + word, "<>=") == NULL
		   ? xasprintf("%s %c %.*s %%", of, sign, n, text)
		   : NULL;
}

/* Turns "<2 mm = 30", as the screen puts it, "under 2 mm < 30" and "2 mm > 30"
 * into a condition of "passing 2 mm".  Returns other texts unchanged.  The
 * caller frees it. */
static char *
name_passing_of_size(const char *text)
{
	bool retained;
	size_t word = quantities_word_before_size(text, &retained);
	const char *size = text + word, *unit = size + strspn(size, SIZE);
	bool named = size + strcspn(size, "0123456789") < unit &&
		     (word > 0 || strncmp(unit, "mm", 2) == 0) &&
		     strpbrk(unit, "<>=") != NULL;
	return named && !retained ? xasprintf("passing %s", size)
				  : xstrdup(text);
}

/* Returns the text with words such as " at least " replaced by a sign.  The
 * caller frees it. */
static char *
replace_limit_words_by_sign(const char *text)
{
	FREED char *turned = rewrite_value_first_condition(text);
	FREED char *with = xstrdup(turned != NULL ? turned : text);
	for (size_t i = 0; i < ARRAY_LEN(LIMIT_WORDS) && turned == NULL; i++) {
		char *at = strstr(with, LIMIT_WORDS[i].words);
		if (at == NULL)
			continue;
		at[1] = LIMIT_WORDS[i].sign;
		memset(at + 2, ' ', strlen(LIMIT_WORDS[i].words) - 2);
		break;
	}
	return name_passing_of_size(with);
}

/* For a text of a quantity, a space and a limit, returns the quantity as typed,
 * and the condition; NULL for other texts.  The caller frees it. */
static char *
split_quantity_and_limit(
    const char *text, const struct fraction *fraction, struct condition *c)
{
	FREED char *name = xstrdup(text);
	for (size_t n = strlen(text); n-- > 0;) {
		if (text[n] != ' ')
			continue;
		name[n] = '\0';
		if (quantities_parse_one(
			name, &fraction->partition, &c->quantity, NULL) &&
		    parse_range_or_number(text + n, c, NULL))
			return xstrdup(text_trim(name));
	}
	return NULL;
}

/* Sets the error for a quantity and a limit without a sign between them, as we
 * cannot know which one is meant.  In "2 mm 42", the size is taken for what
 * passes it.  Returns false. */
static bool
error_missing_limit_sign(
    const char *text, const struct fraction *fraction, struct error *error)
{
	struct condition c;
	FREED char *passing = xasprintf("passing %s", text);
	FREED char *own = split_quantity_and_limit(text, fraction, &c);
	FREED char *size = own == NULL
			       ? split_quantity_and_limit(passing, fraction, &c)
			       : NULL;
	const char *name = own != NULL ? own : size;
	if (name == NULL)
		return error_expected_condition(text, error);
	FREED char *limit = xasprintf(
	    "%g", quantities_value_in_shown_unit(&c.quantity, c.least));
	if (c.least != c.most)
		xappend(&limit, "..%g",
		    quantities_value_in_shown_unit(&c.quantity, c.most));
	return error_set(error, ERROR_USAGE,
	    "expected <, > or = after the quantity, got '%s'\n"
	    "write: %s = %s",
	    text, name, limit);
}

static bool
parse_condition_with_sign(const char *text, const struct fraction *fraction,
    struct condition *c, struct error *error)
{
	size_t n = strcspn(text, "<>=");
	if (n == 0)
		return error_expected_condition(text, error);
	if (text[n] == '\0')
		return error_missing_limit_sign(text, fraction, error);
	bool retained;
	size_t word = quantities_word_before_size(text, &retained);
	FREED char *name =
	    retained ? xasprintf("passing %.*s", (int)(n - word), text + word)
		     : xstrndup(text, n);
	bool ok = quantities_parse_one(
		      name, &fraction->partition, &c->quantity, error) &&
		  quantities_apply_cut_option(&c->quantity, fraction, error);
	if (!ok)
		return false;
	const char *limit = text + n + 1;
	limit += text[n] != '=' && *limit == '=';
	c->least = c->most = NAN;
	ok = text[n] == '=' ? parse_range_or_number(limit, c, error)
			    : parse_condition_limit(limit, &c->quantity,
				  text[n] == '<' ? &c->most : &c->least, error);
	if (ok && retained) {
		double least = c->least;
		c->least = 1 - c->most;
		c->most = 1 - least;
	}
	return ok;
}

bool
conditions_parse_one(const char *text, const struct fraction *fraction,
    struct condition *c, struct error *error)
{
	FREED char *with = replace_limit_words_by_sign(text);
	bool ok = true;
	for (char *at = with; ok && *at != '\0'; at++) {
		if (!text_is_comma_in_number(with, at))
			continue;
		ok = text_is_decimal_comma(with, at) ||
		     error_decimal_comma(with, at, error);
		*at = '.';
	}
	return ok && parse_condition_with_sign(with, fraction, c, error);
}

bool
conditions_is_likely_complete(const char *text)
{
	bool most;
	const char *of = conditions_parse_max_or_min(text, &most);
	struct quantity q;
	if (of != NULL)
		return quantities_parse_one(of, &PARTITION_IDEAL, &q, NULL);
	const struct fraction whole = {.partition = PARTITION_IDEAL};
	FREED char *with = replace_limit_words_by_sign(text);
	const char *sign = strpbrk(with, "<>=");
	if (sign != NULL)
		return strpbrk(sign, DIGITS) != NULL;
	struct condition c;
	FREED char *name = split_quantity_and_limit(with, &whole, &c);
	return name != NULL;
}

bool
conditions_parse_list(const char *text, const struct fraction *fraction,
    struct condition_list *list, struct error *error)
{
	for (const char *at = text; *at != '\0';) {
		struct condition c;
		size_t length = text_length_of_list_item(at);
		FREED char *copy = xstrndup(at, length);
		if (!conditions_parse_one(text_trim(copy), fraction, &c, error))
			return false;
		conditions_add(list, c);
		at += length + (at[length] != '\0');
	}
	return true;
}

bool
conditions_add_envelope(const struct spec *spec, const char *cut,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, struct error *error)
{
	const struct fraction f = envelope_fraction(spec, cut, fraction);
	struct condition_list all = {0};
	size_t n_sieve, before = list->n, unknown = 0;
	bool modulus =
	    envelope_limits_to_conditions(spec, &f, feed, &all, &n_sieve);
	for (size_t i = 0; i < all.n; i++)
		if (!isnan(all.at[i].least) || !isnan(all.at[i].most))
			conditions_add(list, all.at[i]);
	conditions_free(&all);
	if (list->n == before)
		return envelope_set_error_no_sieve(spec, error);
	for (size_t i = n_sieve; i < spec->n; i++)
		unknown += !isnan(spec->least[i]) || !isnan(spec->most[i]);
	FREED char *unchecked = xstrdup("");
	if (unknown > 0)
		xappend(&unchecked,
		    tr_n("%zu sieve finer than the feed's finest",
			"%zu sieves finer than the feed's finest", unknown),
		    unknown);
	if (!modulus)
		xappend_to_list(&unchecked, tr(" and "), "%s",
		    tr("the fineness modulus, which needs finer sieves of the "
		       "feed"));
	xfree_and_set(&list->source,
	    spec->source[0] != '\0'
		? xasprintf(tr("limits of %s: %s"), spec->name, spec->source)
		: xasprintf(tr("limits of %s"), spec->name));
	if (unchecked[0] != '\0')
		xappend_to_list(
		    &list->source, "; ", tr("not checked: %s"), unchecked);
	return true;
}

bool
conditions_add_envelope_option(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error)
{
	if (args->spec == NULL)
		return true;
	const struct spec *spec =
	    envelope_named_or_chosen(s, args->spec, error);
	return spec != NULL && conditions_add_envelope(spec, args->cut,
				   &q->fraction, question_feed(q), list, error);
}

void
conditions_note_source_of_limits(
    struct answer *r, const struct condition_list *list)
{
	if (list->source != NULL)
		answer_add_sentence(r, ANSWER_REMARK, "%s", list->source);
}

bool
conditions_check_feed_covers(
    const struct condition *c, const struct psd *feed, struct error *error)
{
	const double limit[] = {c->least, c->most};
	bool ok = quantities_check_feed_covers(&c->quantity, feed, error);
	for (size_t i = 0; i < 2 && ok; i++) {
		struct quantity at = {.kind = QUANTITY_PASSING, .x = limit[i]};
		if (quantities_is_size(&c->quantity) && !isnan(limit[i]))
			ok = quantities_check_feed_covers(&at, feed, error);
	}
	return ok;
}

bool
conditions_add_from_args(struct session *s, const struct args *args,
    const struct question *q, struct condition_list *list, struct error *error)
{
	const struct psd *feed = question_feed(q);
	for (size_t i = 0; i < args->n_operand; i++) {
		struct condition c;
		bool ok = conditions_parse_one(
			      args->operand[i], &q->fraction, &c, error) &&
			  conditions_check_feed_covers(&c, feed, error);
		if (ok && c.least == c.most)
			ok = error_set(error, ERROR_USAGE,
			    "expected a range, got one value: '%s'\nwrite a "
			    "range such as 40..50; or, for the speed that "
			    "gives this value: find \"%s\"",
			    args->operand[i], args->operand[i]);
		if (!ok) {
			error->column = args->column[i];
			return false;
		}
		conditions_add(list, c);
	}
	return conditions_add_envelope_option(s, args, q, list, error);
}

bool
conditions_parse_search_range(const struct session *s, const struct args *args,
    const struct site *site, double *from, double *to, struct error *error)
{
	settings_default_speed_range(&s->set, site, from, to);
	*from = args->from > 0 ? args->from : *from;
	*to = args->to > 0 ? args->to : *to;
	if (*from < *to)
		return true;
	double low = args->from > 0 ? *from : fmax(*to - 10, *to / 2),
	       high = args->from > 0 ? *from + 10 : *to;
	bool swap = args->from > 0 && args->to > 0 && *from > *to;
	return error_set(error, ERROR_USAGE,
	    "from= must be below to=, got %g and %g m/s\n"
	    "write from=%g to=%g",
	    *from, *to, swap ? *to : low, swap ? *from : high);
}

char *
conditions_one_text(const struct condition *c)
{
	const struct quantity *q = &c->quantity;
	FREED char *of = quantities_name(q);
	const char *unit = quantities_unit_suffix(q);
	double least = quantities_value_in_shown_unit(q, c->least);
	double most = quantities_value_in_shown_unit(q, c->most);
	return isnan(least) ? xasprintf(tr("%s at most %g%s"), of, most, unit)
	       : isnan(most)
		   ? xasprintf(tr("%s at least %g%s"), of, least, unit)
	       : c->least == c->most
		   ? xasprintf("%s %g%s", of, most, unit)
		   : xasprintf(tr("%s %g to %g%s"), of, least, most, unit);
}

char *
conditions_list_text(const struct condition_list *list)
{
	char *words = xstrdup("");
	for (size_t i = 0; i < list->n; i++) {
		FREED char *one = conditions_one_text(&list->at[i]);
		xappend_to_list(&words, ", ", "%s", one);
	}
	return words;
}

char *
conditions_limit_text(const struct condition *at, struct wanted_limit limit)
{
	struct condition one = at[limit.i];
	if (limit.most)
		one.least = NAN;
	else
		one.most = NAN;
	return conditions_one_text(&one);
}

/* Returns the speeds in rpm, "1319 to 1434", if the rotor's diameter is not 0,
 * otherwise in m/s: "69.0 to 70.1 and 74.4", "74.42 to 74.47".  The caller
 * frees it. */
static char *
met_speed_ranges_text(const struct speed_search *found, double rotor)
{
	const double tenth = 0.1, hair = 1e-6;
	char *words = xstrdup("");
	for (size_t k = 0; k < found->n_inside; k++) {
		double from = found->inside[k].from, to = found->inside[k].to;
		double slow = rotor_speed_to_rpm(from, rotor),
		       fast = rotor_speed_to_rpm(to, rotor);
		if (rotor > 0)
			xappend_to_list(&words, tr(" and "),
			    fast - slow < 1 ? "%.0f" : tr("%.0f to %.0f"), slow,
			    fast);
		else
			xappend_to_list(&words, tr(" and "),
			    to - from < hair           ? "%.1f"
			    : to - from < tenth - hair ? tr("%.2f to %.2f")
						       : tr("%.1f to %.1f"),
			    from, to);
	}
	return words;
}

char *
conditions_met_speeds_text(
    const struct speed_search *found, const struct site *site)
{
	return met_speed_ranges_text(
	    found, answers_is_sheet_in_rpm(site) ? site->rotor : 0);
}

/* Returns a suffix such as ", up to the fastest tried", to be translated, if an
 * end of the range is only that of the search; otherwise "". */
static const char *
search_range_end_suffix(
    const struct conditions_search *wanted, double from, double to)
{
	bool slowest = from <= wanted->from, fastest = to >= wanted->to;
	return slowest && fastest ? N_(", all speeds tried")
	       : slowest          ? N_(", from the slowest tried")
	       : fastest          ? N_(", up to the fastest tried")
				  : "";
}

char *
conditions_met_speeds_text_with_units(
    const struct conditions_search *wanted, const struct speed_search *found)
{
	double rotor = wanted->entry->site->rotor;
	size_t n = found->n_inside;
	const char *ends =
	    n == 0 ? ""
		   : tr(search_range_end_suffix(wanted, found->inside[0].from,
			 found->inside[n - 1].to));
	FREED char *mps = met_speed_ranges_text(found, 0);
	FREED char *rpm = met_speed_ranges_text(found, rotor);
	return rotor > 0 ? xasprintf(tr("%s m/s (%s rpm)%s"), mps, rpm, ends)
			 : xasprintf(tr("%s m/s%s"), mps, ends);
}

/* Returns the distance between the value at the forecast's speed and the limit
 * of the margin, in the quantity's unit; negative if the limit is missed. */
static double
margin_in_quantity_unit(
    const struct conditions_search *wanted, struct margin margin)
{
	size_t i = margin.limit.i;
	if (i == SIZE_MAX || quantities_unit(&wanted->at[i].quantity)[0] == '%')
		return 100 * margin.passing;
	const struct condition *c = &wanted->at[i];
	double value = forecast_value_in_shown_unit(wanted->forecast, i).value;
	return margin.limit.most
		   ? quantities_value_in_shown_unit(&c->quantity, c->most) -
			 value
		   : value -
			 quantities_value_in_shown_unit(&c->quantity, c->least);
}

char *
conditions_margin_text(
    const struct conditions_search *wanted, struct margin margin)
{
	const struct quantity *q = &wanted->at[margin.limit.i].quantity;
	double points = fabs(100 * margin.passing);
	double distance = fabs(margin_in_quantity_unit(wanted, margin));
	int digits = quantities_decimals(q);
	if (isnan(distance) || quantities_unit(q)[0] == '%')
		return xasprintf(tr("%.*f points"),
		    conditions_decimals_of_miss(points), points);
	digits += distance < pow(10, -digits);
	return xasprintf("%.*f%s", digits, distance, quantities_unit_suffix(q));
}

void
conditions_put_fields(struct fields *o, const struct conditions_search *wanted,
    const struct speed_search *found)
{
	struct fields *list = fields_add_list(o, "conditions");
	for (size_t i = 0; i < wanted->n; i++) {
		const struct quantity *q = &wanted->at[i].quantity;
		struct margin margin = condition_margin(wanted, i);
		struct figure f =
		    forecast_value_in_shown_unit(wanted->forecast, i);
		FREED char *key = quantities_field_name(q);
		fields_put_values(fields_add_object(list, NULL),
		    "quantity %s unit %s min %g max %g value %g low %g high %g "
		    "margin_pct %g margin_widths %g holds_from %g holds_to %g",
		    key, quantities_unit(q),
		    quantities_value_in_shown_unit(q, wanted->at[i].least),
		    quantities_value_in_shown_unit(q, wanted->at[i].most),
		    f.value, f.low, f.high, 100 * margin.passing, margin.widths,
		    found->alone[i][0], found->alone[i][1]);
	}
}

/* Adds a row for each condition.  For people, the margin is in the quantity's
 * unit; for programs, in points. */
static void
add_condition_rows(struct answer *r, const struct conditions_search *wanted,
    const struct speed_search *found, bool people)
{
	double rotor = people ? wanted->entry->site->rotor : 0;
	bool drawn = forecast_draws_of_quantity(wanted->forecast, 0) != NULL;
	answer_add_columns(r, "quantity: condition on, min, max, value");
	if (drawn)
		answer_add_columns(r, "low, high");
	answer_add_columns(
	    r, rotor > 0 ? N_("margin_pct: margin, holds_from: from rpm, "
			      "holds_to: to rpm")
			 : N_("margin_pct: margin, holds_from: from m/s, "
			      "holds_to: to m/s"));
	for (size_t i = 0; i < wanted->n; i++) {
		const struct quantity *q = &wanted->at[i].quantity;
		struct figure f =
		    forecast_value_in_shown_unit(wanted->forecast, i);
		const char *unit = quantities_unit(q);
		int digits = quantities_decimals(q);
		FREED char *words = quantities_name(q);
		FREED char *key = quantities_field_name(q);
		if (unit[0] != '\0')
			xappend(&words, ", %s", unit);
		answer_add_keyed_cell(r, key, words);
		answer_add_cells(r, "%g %g %.*f",
		    quantities_value_in_shown_unit(q, wanted->at[i].least),
		    quantities_value_in_shown_unit(q, wanted->at[i].most),
		    digits, f.value);
		if (drawn)
			answer_add_cells(
			    r, "%.*f %.*f", digits, f.low, digits, f.high);
		struct margin margin = condition_margin(wanted, i);
		answer_add_cells(r, "%.*f", people ? digits : 1,
		    people ? margin_in_quantity_unit(wanted, margin)
			   : 100 * margin.passing);
		for (size_t k = 0; k < 2; k++)
			answer_add_cells(r, rotor > 0 ? "%.0f" : "%.1f",
			    rotor > 0
				? rotor_speed_to_rpm(found->alone[i][k], rotor)
				: found->alone[i][k]);
	}
}

void
conditions_add_answer_rows(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found)
{
	add_condition_rows(r, wanted, found, true);
	answer_begin_table_for_programs(r);
	add_condition_rows(r, wanted, found, false);
}

struct conditions_search
conditions_open_search(const struct session *s, const struct question *q,
    const struct condition_list *list, const struct condition *target)
{
	const struct quantity *more = target != NULL ? &target->quantity : NULL;
	struct conditions_search w = conditions_search_from_question(
	    s, q, list->n, list->at, more != NULL, more);
	w.target = target;
	return w;
}

bool
conditions_note_feed_too_fine(struct answer *r,
    const struct conditions_search *wanted, const struct condition *c,
    bool most)
{
	const struct quantity *q = &c->quantity;
	int rises = quantity_sign_if_finer(q);
	double limit = most ? c->most : c->least;
	if (rises == 0 || most != (rises > 0))
		return false;
	double own = screened_quantity_of_product(
	    site_feed_of_run(wanted->entry->site, wanted->feed), q);
	if (!(rises > 0 ? own > limit : own < limit))
		return false;
	answer_note(r,
	    "the feed itself has %.*f%s: no speed gives a coarser product",
	    quantities_decimals(q), quantities_value_in_shown_unit(q, own),
	    quantities_unit_suffix(q));
	return true;
}

/* Notes the limits that exclude slower and faster speeds than the best one.
 * Nothing is known beyond the ends of the search. */
static void
note_conflicting_limits(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found)
{
	const struct wanted_limit low = found->low, high = found->high;
	bool slowest = fabs(found->best - wanted->from) < 1e-3,
	     fastest = fabs(found->best - wanted->to) < 1e-3;
	FREED char *below = slowest || low.i == SIZE_MAX
				? NULL
				: conditions_limit_text(wanted->at, low);
	FREED char *above = fastest || high.i == SIZE_MAX
				? NULL
				: conditions_limit_text(wanted->at, high);
	if (below != NULL && above != NULL && low.i == high.i &&
	    low.most == high.most) {
		answer_note(r, "limiting condition: %s", below);
		return;
	}
	if (below != NULL)
		answer_note(r, "limiting at lower speeds: %s", below);
	if (above != NULL)
		answer_note(r, "limiting at higher speeds: %s", above);
	conditions_note_no_reliable_speed(r, wanted, slowest, fastest);
}

int
conditions_decimals_of_miss(double points)
{
	return fabs(points) < 0.1 ? 2 : 1;
}

double
conditions_nearest_measured_speed(
    const struct conditions_search *wanted, double speed)
{
	const struct site *site = wanted->entry->site;
	double near = NAN, slowest = INFINITY, fastest = -INFINITY;
	for (size_t i = 0; i < site->n_run; i++) {
		double v = site->run[i].speed;
		slowest = fmin(slowest, v);
		fastest = fmax(fastest, v);
		if (!(fabs(v - speed) >= fabs(near - speed)))
			near = v;
	}
	bool beyond = speed < slowest - 0.05 || speed > fastest + 0.05;
	return isfinite(wanted->reach) && near > 0 && beyond ? near : NAN;
}

/* If the best speed is beyond the measured ones, notes by how much the nearest
 * measured speed misses.  Leaves the forecast at the best speed. */
static void
note_nearest_measured_speed(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found)
{
	const struct site *site = wanted->entry->site;
	double near = conditions_nearest_measured_speed(wanted, found->best);
	if (isnan(near))
		return;
	forecast_set_speed(wanted->forecast, near);
	struct margin margin = condition_margin(wanted, SIZE_MAX);
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, near, NAN);
	if (isfinite(margin.passing)) {
		FREED char *misses = conditions_margin_text(wanted, margin);
		answer_note(r,
		    "the nearest measured speed, %.*f m/s%s, misses by %s",
		    units_speed_decimals(near), near, rpm, misses);
	}
	forecast_set_speed(wanted->forecast, found->best);
}

void
conditions_note_why_unmet(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *found)
{
	const char *what =
	    wanted->n > 1 ? tr("all conditions") : tr("the condition");
	FREED char *range = rotor_speed_rpm_text(
	    wanted->entry->site->rotor, wanted->from, wanted->to);
	if (!isfinite(found->margin.passing)) {
		answer_note(r,
		    "no speed from %g to %g m/s%s gives a value for every "
		    "condition",
		    wanted->from, wanted->to, range);
		return;
	}
	const struct wanted_limit missed = found->margin.limit;
	const struct condition *c = &wanted->at[missed.i];
	forecast_set_speed(wanted->forecast, found->best);
	FREED char *misses = conditions_margin_text(wanted, found->margin);
	if (found->alike) {
		FREED char *words = conditions_limit_text(wanted->at, missed);
		answer_note(r,
		    "no speed from %g to %g m/s%s meets %s: every speed misses "
		    "%s equally, by %s",
		    wanted->from, wanted->to, range, what, words, misses);
	} else {
		FREED char *rpm = rotor_speed_rpm_text(
		    wanted->entry->site->rotor, found->best, NAN);
		answer_note(r,
		    "no speed from %g to %g m/s%s meets %s; the nearest is "
		    "%.1f m/s%s, which misses by %s",
		    wanted->from, wanted->to, range, what, found->best, rpm,
		    misses);
		note_nearest_measured_speed(r, wanted, found);
	}
	bool fine = conditions_note_feed_too_fine(r, wanted, c, missed.most);
	if (!fine && !found->alike)
		note_conflicting_limits(r, wanted, found);
}

/* Returns the end of the range around the best speed that is farther beyond the
 * measured speeds, or NAN if neither end is beyond them. */
static double
farthest_extrapolated_window_end(
    const struct conditions_search *wanted, const struct speed_search *found)
{
	const struct speed_range *in = speed_search_best_range(found);
	if (in == NULL)
		return NAN;
	double below = wanted->measured[0] - in->from,
	       above = in->to - wanted->measured[1];
	return fmax(below, above) <= 1e-9 ? NAN
	       : above > below            ? in->to
					  : in->from;
}

void
conditions_note_basis_and_trust(struct answer *r, const struct question *q,
    const struct conditions_search *wanted, const struct speed_search *found,
    double speed)
{
	const struct session *s = wanted->s;
	const double at[] = {
	    speed, farthest_extrapolated_window_end(wanted, found)};
	struct trust light = trust_at_speed(s, q->entry, speed, q->feed);
	struct trust far = {0};
	fields_put_values(
	    answer_json_fields(r), "best_trust %s", LIGHT_NAME[light.light]);
	if (!isnan(at[1]))
		far = trust_at_speed(s, q->entry, at[1], q->feed);
	if (far.light <= light.light) {
		trust_free(&far);
		answers_note_basis_and_trust(s, r, q, speed, false, light);
		return;
	}
	correction_note_unless_all(r, s, q->entry);
	answers_note_basis_without_trust(s, r, q, speed, NULL, &light);
	for (size_t k = 0; k < 2; k++) {
		FREED char *words =
		    trust_in_words_at_speed(s, q->entry, at[k], q->feed);
		answer_add_sentence(r,
		    k == 1 && far.light == LIGHT_RED ? ANSWER_WARNING
						     : ANSWER_REMARK,
		    "%s", words);
	}
	trust_put_fields(answer_json_fields(r), &far);
	trust_free(&light);
	trust_free(&far);
}

/* True if the slow or, if `fast`, the fast end of the search is so far beyond
 * the measured speeds that answers there cannot be relied on. */
static bool
is_range_end_unreliable(const struct conditions_search *wanted, bool fast)
{
	return fast ? wanted->to > wanted->measured[1] + wanted->reach
		    : wanted->from < wanted->measured[0] - wanted->reach;
}

/* Returns an end of the search as one would type it: "100", or "2010 rpm", the
 * last multiple of ten inside it, if the sheet is in rpm.  The caller frees
 * it. */
static char *
search_range_end_to_type(const struct site *site, double speed, bool fastest)
{
	if (!answers_is_sheet_in_rpm(site))
		return xasprintf("%g", speed);
	double tens = rotor_speed_to_rpm(speed, site->rotor) / 10;
	return xasprintf("%g rpm", 10 * (fastest ? floor(tens) : ceil(tens)));
}

void
conditions_note_unsearched_speeds(struct answer *r,
    const struct conditions_search *wanted, bool slower, bool faster)
{
	const double more = 15;
	const struct site *site = wanted->entry->site;
	for (int fast = 0; fast < 2; fast++) {
		double end = fast ? wanted->to : wanted->from;
		bool last = fast ? end >= SITE_FASTEST : end <= 1;
		if (!(fast ? faster : slower) || last ||
		    is_range_end_unreliable(wanted, fast))
			continue;
		FREED char *rpm = rotor_speed_rpm_text(site->rotor, end, NAN);
		FREED char *beyond = search_range_end_to_type(site,
		    fast ? fmin(SITE_FASTEST, end + more) : fmax(1, end - more),
		    fast);
		answer_note(r,
		    fast ? N_("speeds above %g m/s%s were not searched: add "
			      "to=%s")
			 : N_("speeds below %g m/s%s were not searched: add "
			      "from=%s"),
		    end, rpm, beyond);
	}
}

void
conditions_note_no_reliable_speed(struct answer *r,
    const struct conditions_search *wanted, bool slower, bool faster)
{
	bool all_measured = wanted->from <= wanted->measured[0] &&
			    wanted->to >= wanted->measured[1];
	if (all_measured &&
	    ((slower && is_range_end_unreliable(wanted, false)) ||
		(faster && is_range_end_unreliable(wanted, true))))
		answer_note(r, "no speed near the measured ones meets it, and "
			       "answers farther away are not reliable");
	else
		conditions_note_unsearched_speeds(r, wanted, slower, faster);
}

char *
conditions_probability_text(double share)
{
	return share > 0.99   ? xstrdup(tr("over 99 %"))
	       : share < 0.01 ? xstrdup(tr("under 1 %"))
			      : xasprintf("%.0f %%", 100 * share);
}

char *
conditions_times_in_100_text(double share)
{
	return share > 0.99   ? xstrdup(tr("over 99 times in 100"))
	       : share < 0.01 ? xstrdup(tr("less than once in 100"))
			      : xasprintf(tr("%.0f times in 100"), 100 * share);
}

/* True if the conditions hold more surely at a speed that is not measured: of
 * those as sure as the best, within 2 %, the best was preferred. */
static bool
is_other_speed_surer(const struct speed_search *w)
{
	const double alike = 0.02;
	bool surer = false;
	for (size_t k = 0; k < w->n && !surer; k++)
		surer = w->certain[k] > w->best_certain + alike;
	return surer;
}

/* Returns "run at 73.3 m/s: they are most likely to be met there, over 99 times
 * in 100", or "best 84.9 m/s, .." if the answer there is not to be relied on.
 * The caller frees it. */
static char *
recommended_speed_text(const struct conditions_search *wanted, bool several,
    const struct speed_search *w)
{
	const struct entry *entry = wanted->entry;
	bool beyond = answers_is_speed_extrapolated(entry, w->best);
	struct trust light =
	    trust_at_speed(wanted->s, entry, w->best, wanted->feed);
	bool is_sure =
	    light.light != LIGHT_RED && w->best_certain >= wanted->level;
	FREED char *rpm =
	    rotor_speed_rpm_text(wanted->entry->site->rotor, w->best, NAN);
	char *words =
	    xasprintf(beyond ? tr("best %.1f m/s%s, beyond the "
				  "measured speeds: ")
		      : is_sure && is_other_speed_surer(w)
			  ? tr("run at %.1f m/s%s, the best of the measured "
			       "range: ")
		      : is_sure ? tr("run at %.1f m/s%s: ")
				: tr("best %.1f m/s%s in the measured range: "),
		w->best, rpm);
	trust_free(&light);
	if (isnan(w->best_certain)) {
		xappend(&words, tr("it is farthest from the limits"));
		return words;
	}
	FREED char *times = conditions_times_in_100_text(w->best_certain);
	xappend(&words,
	    several ? tr("they are most likely to be met there, %s")
		    : tr("it is most likely to be met there, %s"),
	    times);
	return words;
}

/* Notes which speed to run at, and in which range the conditions hold with the
 * probability of the band. */
static void
note_recommended_speed(struct answer *r, const struct conditions_search *wanted,
    bool several, const struct speed_search *w)
{
	double level = 100 * wanted->level;
	double rotor = wanted->entry->site->rotor, low = w->sure[0],
	       high = w->sure[1];
	FREED char *rpm = rotor_speed_rpm_text(rotor, low, high);
	FREED char *words = recommended_speed_text(wanted, several, w);
	if (isfinite(low))
		xappend(&words,
		    tr("; at least %.0f times in 100 from %.1f to %.1f "
		       "m/s%s%s"),
		    level, low, high, rpm,
		    tr(search_range_end_suffix(wanted, low, high)));
	else if (round(100 * w->best_certain) < round(level))
		xappend(&words, tr("; no speed reaches %.0f in 100"), level);
	answer_note(r, "%s", words);
}

static void
note_slowest_safe_speed(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *w)
{
	FREED char *rpm =
	    rotor_speed_rpm_text(wanted->entry->site->rotor, w->safe, NAN);
	if (w->safe < w->best)
		answer_note(r,
		    "least energy and wear: %.1f m/s%s, the slowest that meets "
		    "it 95 times in 100 or more",
		    w->safe, rpm);
}

/* If the answer meets the conditions at no speed, notes where they are most
 * likely to hold. */
static void
note_highest_certainty_if_unmet(struct answer *r,
    const struct conditions_search *wanted, const struct speed_search *w)
{
	size_t most = 0;
	for (size_t k = 0; k < w->n; k++)
		if (w->certain[k] > w->certain[most])
			most = k;
	FREED char *highest = conditions_probability_text(w->certain[most]);
	FREED char *rpm = rotor_speed_rpm_text(
	    wanted->entry->site->rotor, w->speed[most], NAN);
	if (w->certain[most] <= 0)
		answer_note(r,
		    "no speed meets it with %.0f %% certainty; the certainty "
		    "is under 1 %% at every speed",
		    100 * wanted->level);
	else
		answer_note(r,
		    "no speed meets it with %.0f %% certainty; the highest, at "
		    "%.1f m/s%s, is %s",
		    100 * wanted->level, w->speed[most], rpm, highest);
}

void
conditions_note_best_speed(struct answer *r,
    const struct conditions_search *wanted, bool several, bool detail,
    const struct speed_search *w)
{
	if (w->n_inside > 0) {
		note_recommended_speed(r, wanted, several, w);
		if (detail)
			note_slowest_safe_speed(r, wanted, w);
	} else if (!isnan(w->best_certain) && !isfinite(w->sure[0]))
		note_highest_certainty_if_unmet(r, wanted, w);
}

const char *
conditions_verdict(double share, bool holds)
{
	double percent = round(100 * share); /* as it is shown */
	if (isnan(share))
		return holds ? tr("met") : tr("missed");
	return percent >= 90   ? tr("met")
	       : percent >= 70 ? tr("likely met")
	       : percent > 30  ? tr("about even")
	       : percent > 10  ? tr("likely missed")
			       : tr("missed");
}
