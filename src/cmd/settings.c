/* Settings by their rows, and seed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/settings.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "cmd/parse.h"
#include "cmd/table.h"
#include "core/breakage.h"

static void
put(const struct setting *row, const struct value *value, struct choices *set)
{
	char *place = (char *)set + row->offset;
	unsigned whole =
	    (unsigned)(row->option.kind == VALUE_CHOICE ? value->choice
							: value->whole);
	if (row->option.kind == VALUE_NUMBER)
		memcpy(place, &value->number, sizeof value->number);
	else
		memcpy(place, &whole, sizeof whole);
}

char *
settings_text(const struct setting *row, const struct choices *set)
{
	const char *place = (const char *)set + row->offset;
	const char *word = row->option.choices;
	double number;
	unsigned whole;
	if (row->option.kind == VALUE_NUMBER) {
		memcpy(&number, place, sizeof number);
		return xasprintf("%.15g", number);
	}
	memcpy(&whole, place, sizeof whole);
	if (row->option.kind == VALUE_WHOLE)
		return xasprintf("%u", whole);
	for (; whole > 0; whole--)
		word = strchr(word, ' ') + 1;
	return xstrndup(word, strcspn(word, " "));
}

static unsigned
processors(void)
{
	long n = sysconf(_SC_NPROCESSORS_ONLN);
	return n < 1 ? 1 : n > 64 ? 64 : (unsigned)n;
}

struct choices
settings_default(void)
{
	struct choices set = {
	    .bounds = bounds_default(0), .seed = 1, .threads = processors()};
	for (const struct setting *r = SETTINGS; r->option.name != NULL; r++) {
		struct value value = {0};
		struct error error = {0};
		const char *word = r->option.fallback;
		if (word[0] == '\0')
			continue;
		bool ok = value_take(&r->option, word, &value, &error);
		assert(ok);
		(void)ok;
		put(r, &value, &set);
	}
	return set;
}

bool
settings_same(const struct choices *a, const struct choices *b)
{
	bool same = a->seed == b->seed && a->timing == b->timing &&
		    memcmp(&a->bounds, &b->bounds, sizeof a->bounds) == 0;
	for (const struct setting *r = SETTINGS; r->option.name != NULL; r++)
		same = same && memcmp((const char *)a + r->offset,
				   (const char *)b + r->offset,
				   r->option.kind == VALUE_NUMBER
				       ? sizeof(double)
				       : sizeof(unsigned)) == 0;
	return same;
}

static bool
show_settings(struct session *s)
{
	struct answer *r = answer_new("set");
	answer_columns(r, "setting, value");
	for (const struct setting *row = SETTINGS; row->option.name != NULL;
	     row++) {
		char *text = settings_text(row, &s->set);
		answer_pair(r, row->option.name, "%s", text);
		free(text);
	}
	return session_answer(s, r);
}

bool
cmd_set(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct model_settings before = s->set.model;
	bool any = false;
	for (size_t i = 0; SETTINGS[i].option.name != NULL; i++) {
		if (!args->value[i].given)
			continue;
		put(&SETTINGS[i], &args->value[i], &s->set);
		any = true;
	}
	if (!model_settings_same(&before, &s->set.model))
		session_forget(s);
	/* What a site has stays as it is. */
	if (s->set.model.breakage != before.breakage)
		s->set.bounds = bounds_default(s->set.model.breakage);
	return any || show_settings(s);
}

bool
cmd_seed(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct value *value = args_value(args, "seed");
	if (value->given) {
		s->set.seed = value->whole;
		return true;
	}
	struct answer *r = answer_new("seed");
	answer_columns(r, "seed");
	answer_text(r, "%llu", (unsigned long long)s->set.seed);
	return session_answer(s, r);
}
