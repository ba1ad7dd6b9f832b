/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/scenario.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/moved.h"
#include "cmd/sheets/load.h"
#include "cmd/ask/quantity_words.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/units.h"

/* The entries as they are, [n], and what stands in for each. */
struct stand_in {
	size_t n;
	struct entry *own;
	struct variant *variant;
};

/* The rotor that the parameters of an entry were measured with, m; 0: not
 * known. */
static double
measured_rotor(const struct entry *entry)
{
	bool known = entry->origin != NULL && entry->origin->spread != NULL;
	return known ? entry->origin->spread->site->rotor : entry->site->rotor;
}

/* "feed b.csv, cascade 10 %". */
static char *
with_words(const struct variant_wish *w)
{
	char *words = xstrdup("");
	if (w->feed != NULL)
		xlist(&words, ", ", "%s", w->words);
	if (w->rpm > 0)
		xlist(&words, ", ", tr("%g rpm"), w->rpm);
	if (w->rotor > 0)
		xlist(&words, ", ", tr("rotor %g mm"), units_mm(w->rotor));
	if (w->bypass > 0)
		xlist(&words, ", ", tr("cascade %g %%"), 100 * w->bypass);
	if (w->k > 0)
		xlist(&words, ", ", "k %g", w->k);
	return words;
}

static void
stand_in(struct entry *entry, const struct entry *own,
    const struct variant_wish *w, struct variant *v)
{
	size_t runs = own->site->n_run;
	double rotor = measured_rotor(own);
	*v = (struct variant){.own = own,
	    .feed = w->feed != NULL,
	    .rock = xstrdup(w->feed != NULL ? w->rock : ""),
	    .rotor = w->rotor,
	    .measured_rotor = rotor,
	    .other_rotor =
		w->rotor > 0 && rotor > 0 && fabs(w->rotor - rotor) > 5e-4,
	    .bypass = w->bypass,
	    .k = w->k};
	entry->site = w->feed != NULL
			  ? site_with_feed(own->site, w->feed, w->from, w->of)
			  : site_copy(own->site);
	free(entry->site->with);
	entry->site->with = with_words(w);
	entry->site->n_shown = w->n_sieve;
	entry->site->shown = xdoubles(w->n_sieve);
	for (size_t i = 0; i < w->n_sieve; i++)
		entry->site->shown[i] = w->sieve[i];
	entry->train = xcalloc(runs + 1, sizeof *entry->train);
	memcpy(entry->train, own->train, runs * sizeof *entry->train);
	entry->variant = v;
}

void
variant_begin(struct session *s, const struct variant_wish *wish)
{
	assert(s->stand_in == NULL);
	size_t n = s->n_entry;
	struct stand_in *all = s->stand_in = xcalloc(1, sizeof *all);
	*all = (struct stand_in){.n = n,
	    .own = xcalloc(n, sizeof *all->own),
	    .variant = xcalloc(n, sizeof *all->variant)};
	memcpy(all->own, s->entry, n * sizeof *all->own);
	for (size_t i = 0; i < n; i++)
		stand_in(&s->entry[i], &all->own[i], wish, &all->variant[i]);
}

void
variant_end(struct session *s)
{
	struct stand_in *all = s->stand_in;
	assert(s->n_entry == all->n);
	moved_forget(s->moved);
	for (size_t i = 0; i < all->n; i++) {
		struct entry *entry = &s->entry[i];
		for (size_t k = 0; k < all->n; k++) {
			const struct entry *own = &all->own[k];
			history_forget(own->history, entry->site);
			if (own->origin != NULL)
				history_forget(
				    own->origin->spread, entry->site);
		}
		site_free(entry->site);
		free(entry->train);
		free(all->variant[i].rock);
	}
	memcpy(s->entry, all->own, all->n * sizeof *all->own);
	free(all->own);
	free(all->variant);
	free(all);
	s->stand_in = NULL;
}

/* Others have options of these names that mean something else. */
static bool
can_vary(const struct command *command)
{
	size_t i = command_option_index(command, "feed");
	return i < OPTIONS && command_option_at(command, i)->kind == VALUE_FEED;
}

/* The option's value where it was given, else NULL. */
static struct value *
given(struct args *args, const char *name)
{
	size_t i = command_option_index(args->command, name);
	return i < OPTIONS && args->value[i].given ? &args->value[i] : NULL;
}

/* Turns of the rotor become the speed. */
static bool
take_turns(struct session *s, struct args *args, struct variant_wish *w,
    struct error *error)
{
	const struct value *rpm = given(args, "rpm");
	const struct value *rotor = given(args, "rotor_mm");
	struct value *speed =
	    &args->value[command_option_index(args->command, "speed")];
	w->rotor = rotor != NULL ? rotor->number / 1000 : 0;
	if (rpm == NULL)
		return true;
	double diameter =
	    rotor != NULL ? w->rotor : session_entry(s)->site->rotor;
	w->rpm = rpm->number;
	if (speed->given)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a speed or rpm, got both",
		    args->command->name);
	if (!(diameter > 0))
		return error_set(error, ERROR_USAGE,
		    "%s: expected the rotor's diameter with rpm, which %s does "
		    "not state\n"
		    "write: %s rpm=%g rotor_mm=DIAMETER, or a line rotor_mm in "
		    "the site file",
		    args->command->name, session_entry(s)->site->name,
		    args->command->name, w->rpm);
	double v = head_mps(w->rpm, SPEED_RPM, diameter);
	if (v < 1 || v > 200)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a tip speed from 1 to 200 m/s, got %g (%g "
		    "rpm with a rotor of %g mm)",
		    args->command->name, v, w->rpm, units_mm(diameter));
	*speed = (struct value){.given = true, .number = v, .text = rpm->text};
	return true;
}

const char *
variant_file(const char *path)
{
	const char *slash = strrchr(path, '/');
	return slash != NULL ? slash + 1 : path;
}

/* The sheet that the option feed names, or NULL where it names none. */
static bool
take_feed(struct session *s, struct args *args, struct variant_wish *w,
    struct site **sheet, char **words, struct error *error)
{
	const struct value *feed = given(args, "feed");
	size_t i = command_option_index(args->command, "feed"), run;
	if (feed == NULL ||
	    !value_is_file(command_option_at(args->command, i), feed))
		return true;
	*sheet = load_feed(s, feed->text, &run, error);
	if (*sheet == NULL)
		return false;
	*words = xasprintf(tr("feed %s"), variant_file(feed->text));
	w->feed = &(*sheet)->run[run].feed;
	w->from = feed->text;
	w->words = *words;
	w->of = (*sheet)->provenance;
	w->rock = (*sheet)->rock;
	return true;
}

/* Sieves of one's own choice, which the feeds have to tell of; the caller
 * frees. */
static bool
take_sieves(struct session *s, struct args *args, struct variant_wish *w,
    double **sieve, struct error *error)
{
	const struct value *sieves = given(args, "sieves");
	const struct site *site = session_entry(s)->site;
	if (sieves == NULL)
		return true;
	*sieve = xdoubles(sieves->n);
	for (size_t i = 0; i < sieves->n; i++)
		(*sieve)[i] = sieves->list[i] / 1000;
	w->n_sieve = psd_sort(*sieve, sieves->n, 1e-12);
	w->sieve = *sieve;
	struct quantity finest = {
	    .kind = QUANTITY_PASSING, .x = (*sieve)[w->n_sieve - 1]};
	bool ok =
	    w->feed == NULL || quantities_covered(&finest, w->feed, error);
	for (size_t r = 0; r < site->n_run && ok && w->feed == NULL; r++)
		ok = site->run[r].feed.n == 0 ||
		     quantities_covered(&finest, &site->run[r].feed, error);
	return ok;
}

bool
variant_run(struct session *s, struct args *args, struct error *error)
{
	struct variant_wish w = {0};
	struct site *sheet = NULL;
	char *words = NULL;
	double *sieve = NULL;
	const struct value *cascade = given(args, "cascade");
	const struct value *k = given(args, "k");
	bool here = s->n_entry > 0 && can_vary(args->command);
	if (here && !(take_turns(s, args, &w, error) &&
			take_feed(s, args, &w, &sheet, &words, error) &&
			take_sieves(s, args, &w, &sieve, error))) {
		site_free(sheet);
		free(words);
		free(sieve);
		return false;
	}
	w.bypass = cascade != NULL ? cascade->number / 100 : 0;
	w.k = k != NULL ? k->number : 0;
	bool asked = w.feed != NULL || w.rotor > 0 || w.rpm > 0 ||
		     w.bypass > 0 || w.k > 0 || w.n_sieve > 0;
	if (!here || !asked)
		return args->command->run(s, args, error);
	variant_begin(s, &w);
	bool ok = args->command->run(s, args, error);
	variant_end(s);
	site_free(sheet);
	free(words);
	free(sieve);
	return ok;
}
