/* Stores and returns the values of settings, as the rows of SETTINGS describe
 * them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* sched_getaffinity */
#include "cmd/session/settings.h"

#include <assert.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/lang/parse.h"
#include "core/model/breakage.h"

void
settings_set_value(const struct command_option *row, const struct value *value,
    struct settings *set)
{
	void *place = (char *)set + row->offset;
	if (row->kind == VALUE_FILE) {
		/* cmd_set reads the file. */
	} else if (row->kind == VALUE_TEXT || row->kind == VALUE_FEED) {
		bool none = strcmp(value->text, SETTINGS_NONE) == 0;
		snprintf(place, SETTINGS_TEXT, "%s", none ? "" : value->text);
	} else if (row->kind == VALUE_NUMBERS) {
		double *end = place;
		/* The steps of a range may not reach its end. */
		const char *dots = strstr(value->text, "..");
		end[0] = value->n > 0 ? value->list[0] : 0;
		end[1] = value->n == 0  ? 0
			 : dots != NULL ? strtod(dots + 2, NULL)
					: value->list[value->n - 1];
	} else if (row->kind == VALUE_NUMBER) {
		*(double *)place = value->number;
	} else {
		*(unsigned *)place =
		    (unsigned)(row->kind == VALUE_CHOICE ? value->choice
							 : value->whole);
	}
}

char *
settings_value_text(
    const struct command_option *row, const struct settings *set)
{
	const void *place = (const char *)set + row->offset;
	const char *word = option_choices(row);
	const double *number = place;
	if (row->kind == VALUE_NUMBERS)
		return number[1] > 0
			   ? xasprintf("%.15g..%.15g", number[0], number[1])
			   : xstrdup(word);
	if (row->kind == VALUE_FILE)
		return xstrdup(set->energy != NULL ? set->energy : "off");
	if (row->kind == VALUE_TEXT || row->kind == VALUE_FEED)
		return xstrdup(
		    *(const char *)place != '\0' ? place : SETTINGS_NONE);
	if (row->kind == VALUE_NUMBER)
		return xasprintf("%.15g", *number);
	unsigned whole = *(const unsigned *)place;
	if (row->kind == VALUE_WHOLE)
		return xasprintf("%u", whole);
	for (; whole > 0; whole--)
		word = strchr(word, ' ') + 1;
	return xstrndup(word, strcspn(word, " "));
}

/* Returns OMP_NUM_THREADS or, without it, the number of processors that this
 * process may use, which may be fewer than the machine has. */
static unsigned
default_thread_count(void)
{
	const char *text = getenv("OMP_NUM_THREADS");
	long n = text != NULL ? strtol(text, NULL, 10) : 0;
	cpu_set_t processors;
	if (n < 1 && sched_getaffinity(0, sizeof processors, &processors) == 0)
		n = CPU_COUNT(&processors);
	return n < 1 ? 1 : n > 64 ? 64 : (unsigned)n;
}

struct settings
settings_default(void)
{
	struct settings set = {.bounds = bounds_default(0),
	    .seed = 1,
	    .threads = default_thread_count()};
	for (const struct command_option *r = SETTINGS; r->name != NULL; r++) {
		struct value value = {0};
		struct error error = {0};
		const char *word = r->fallback;
		if (word[0] == '\0')
			continue;
		bool ok = value_parse(r, word, &value, &error);
		assert(ok);
		(void)ok;
		settings_set_value(r, &value, &set);
	}
	return set;
}

double
settings_band_probability(const struct settings *set)
{
	return set->level == 0 ? 0.8 : 0.9;
}

void
settings_default_speed_range(const struct settings *set,
    const struct site *site, double *from, double *to)
{
	site_default_speed_range(site, from, to);
	if (set->slider[1] > 0) {
		*from = set->slider[0];
		*to = set->slider[1];
	}
}

bool
settings_are_equal_but_for_looks(
    const struct settings *a, const struct settings *b)
{
	bool same = a->seed == b->seed &&
		    model_settings_are_same(&a->model, &b->model) &&
		    a->energy == b->energy && a->timing == b->timing &&
		    memcmp(&a->bounds, &b->bounds, sizeof a->bounds) == 0;
	for (const struct command_option *r = SETTINGS; r->name != NULL; r++) {
		FREED char *mine = settings_value_text(r, a),
			   *other = settings_value_text(r, b);
		same = same && (r->looks || strcmp(mine, other) == 0);
	}
	return same;
}
