/* assert: compares answers with expected values.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/files.h"
#include "cmd/lang/table.h"

const struct asserted ASSERTED_NAMES[ANSWERS_ASSERTED] = {
    {"p20", "predict", "p20_mm"}, {"p50", "predict", "p50_mm"},
    {"p80", "predict", "p80_mm"}, {"break", "predict", "break_mm"},
    {"speed", "predict find", "speed"}, {"misfit", "calibrate", "misfit"},
    {"rmse", "calibrate", "rmse_pct"},
    {"holdout", "validate", "holdout.rmse_pct"}, {"poor", "calibrate", "poor"},
    {"extrapolated", "predict", "extrapolated"},
    {"inside", "spec find", "inside"}};

/* Returns the command of COMMAND.FIELD, or NULL if the word is none. */
static const struct command *
find_command_of_field(const char *word)
{
	const char *point = strchr(word, '.');
	FREED char *name =
	    point != NULL ? xstrndup(word, (size_t)(point - word)) : NULL;
	return name != NULL ? command_find(name) : NULL;
}

/* Returns the text in COMMAND.FIELD, or NULL if it has none. */
static const char *
asserted_field_text(const struct session *s, const char *word)
{
	const struct command *command = find_command_of_field(word);
	return command == NULL ? NULL
			       : session_text_in_last_answer(
				     s, command->name, strchr(word, '.') + 1);
}

/* Finds the value of a name in ASSERTED_NAMES or of a field written as
 * COMMAND.FIELD.  Returns false if the word is neither. */
static bool
find_asserted_value(const struct session *s, const char *word, double *value)
{
	for (size_t i = 0; i < ANSWERS_ASSERTED; i++) {
		const struct asserted *a = &ASSERTED_NAMES[i];
		if (!text_is_same_folded(word, a->name))
			continue;
		*value = session_number_in_last_answer(s, a->from, a->path);
		return true;
	}
	const struct command *command = find_command_of_field(word);
	if (command != NULL)
		*value = session_number_in_last_answer(
		    s, command->name, strchr(word, '.') + 1);
	return command != NULL;
}

static bool
evaluate_assert_operand(const struct session *s, const char *word,
    double *value, struct error *error)
{
	if (text_parse_typed_number(word, value))
		return true;
	if (!find_asserted_value(s, word, value))
		return error_set(error, ERROR_USAGE,
		    "assert: expected a number or a name, got '%s'\n"
		    "use one of p20 p50 p80 break speed extrapolated inside "
		    "misfit rmse poor holdout, and spaces around = < and >",
		    word);
	return !isnan(*value) ||
	       error_set(error, ERROR_CHECK,
		   strchr(word, '.') != NULL
		       ? N_("%s is not known\n"
			    "run the command first; 'set format json' shows "
			    "the fields of a result. Another site or a new "
			    "calibration clears them")
		       : N_("%s is not known\n"
			    "run the command that sets it: predict or find "
			    "(p20, p50, p80, break, speed, extrapolated), spec "
			    "(inside), calibrate (misfit, rmse, and poor "
			    "unless there are too few data), validate "
			    "(holdout). Another site or a new calibration "
			    "clears them"),
		   word);
}

/* Returns 1 if the comparison holds, 0 if not, and -1 if there is no such
 * operator. */
static int
compare_asserted_values(const char *op, double a, double b, double within)
{
	if (strcmp(op, "=") == 0)
		return fabs(a - b) <= within;
	if (strcmp(op, "<") == 0)
		return a < b;
	if (strcmp(op, ">") == 0)
		return a > b;
	return -1;
}

/* Checks "predict.trust = green". */
static bool
check_asserted_text(const char *field, const char *op, const char *wanted,
    const char *text, struct error *error)
{
	if (strcmp(op, "=") != 0)
		return error_set(error, ERROR_USAGE,
		    "assert: expected = after %s, which is a text, got '%s'",
		    field, op);
	return strcmp(text, wanted) == 0 ||
	       error_set(error, ERROR_CHECK,
		   "assertion failed: %s = %s: got %s", field, wanted, text);
}

/* Checks for "assert FILE is DIGEST" that the file has not changed. */
static bool
check_file_digest(const struct session *s, const char *path, const char *wanted,
    struct error *error)
{
	uint64_t digest = 0;
	if (s->safe)
		return error_set(error, ERROR_USAGE,
		    "assert FILE is not allowed: it names a file\n"
		    "start the program without --safe to allow it");
	if (!files_compute_digest(path, &digest))
		return error_set(error, ERROR_DATA,
		    "%s cannot be read, and the session needs it\n"
		    "put it back where it was, or take out its lines",
		    path);
	FREED char *found = xasprintf("%016" PRIx64, digest);
	bool good = strcmp(found, wanted) == 0;
	if (!good)
		error_set(error, ERROR_DATA,
		    "expected %s with digest %s, got %s: the file has changed\n"
		    "take out this line to read it anyway; results will change",
		    path, wanted, found);
	return good;
}

bool
cmd_assert(struct session *s, const struct args *args, struct error *error)
{
	const char *const *word = args->operand;
	double a, b, within = 0;
	bool has_within = args->n_operand > 3;
	if (has_within &&
	    (args->n_operand != 5 || strcmp(word[3], "within") != 0 ||
		!text_parse_typed_number(word[4], &within) || within < 0))
		return error_set(error, ERROR_USAGE,
		    "assert: expected 'within NUMBER' after %s, got '%s%s%s'\n"
		    "for instance: assert %s = %s within 0.05",
		    word[2], word[3], args->n_operand > 4 ? " " : "",
		    args->n_operand > 4 ? word[4] : "", word[0], word[2]);
	if (strcmp(word[1], "is") == 0)
		return check_file_digest(s, word[0], word[2], error);
	const char *text = asserted_field_text(s, word[0]);
	if (text != NULL && has_within)
		return error_set(error, ERROR_USAGE,
		    "assert: expected nothing after a text, got 'within'");
	if (text != NULL)
		return check_asserted_text(
		    word[0], word[1], word[2], text, error);
	if (!evaluate_assert_operand(s, word[0], &a, error) ||
	    !evaluate_assert_operand(s, word[2], &b, error))
		return false;
	int result = compare_asserted_values(word[1], a, b, within);
	if (result < 0)
		return error_set(error, ERROR_USAGE,
		    "assert: expected = < or > between two values, got '%s'",
		    word[1]);
	if (result > 0)
		return true;
	if (has_within)
		return error_set(error, ERROR_CHECK,
		    "assertion failed: %s %s %s within %s: got %.6g and %.6g",
		    word[0], word[1], word[2], word[4], a, b);
	return error_set(error, ERROR_CHECK,
	    "assertion failed: %s %s %s: got %.6g and %.6g", word[0], word[1],
	    word[2], a, b);
}
