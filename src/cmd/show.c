/* show: what a sheet says, and the table of all that can be shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/data.h"
#include "cmd/table.h"
#include "io/units.h"

static bool
show_site(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct site *site = session_entry(s)->site;
	struct answer *r = answer_new("show");
	char *label = session_label(site);
	char *speeds = data_speeds(site, " ", NULL, true);
	answer_title(r, "%s", label);
	answer_site(r, site->name, site->provenance);
	answer_columns(r, "what, value");
	answer_pair(r, "data", "%s", site->provenance);
	answer_pair(r, "rock", "%s", site->rock);
	if (site->top_size > 0)
		answer_pair(r, "top size mm", "%g", units_mm(site->top_size));
	else
		answer_pair(r, "top size mm", "not stated");
	answer_pair(r, "machine", "%s", site->machine);
	answer_pair(r, "file", "%s", site->path);
	answer_pair(r, "speeds m/s", "%s", speeds);
	answer_pair(r, "feeds", "one for %s",
	    site->individual_feeds ? "each speed" : "all speeds");
	for (size_t i = 0; i < site->n_note; i++)
		answer_cells(
		    r, "%s %s", site->note[i].key, site->note[i].value);
	free(label);
	free(speeds);
	return session_answer(s, r);
}

/* The largest sieve of the curves below a size, m; 0 when there is none. */
static double
next_sieve(const struct psd *const *curve, size_t n, double below)
{
	double x = 0;
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < curve[i]->n; j++)
			if (curve[i]->size[j] < below)
				x = fmax(x, curve[i]->size[j]);
	return x;
}

/* Columns feed@69, or the one feed of all runs, or product@69; their curves go
 * to curve [n_run].  Returns how many. */
static size_t
add_columns(struct answer *r, const struct site *site, bool feed,
    const struct psd **curve)
{
	size_t n = 0;
	for (size_t i = 0; i < site->n_run; i++) {
		const struct run *run = &site->run[i];
		bool shared = feed && !site->individual_feeds;
		if ((!feed && run->product.n == 0) || (shared && i > 0))
			continue;
		if (shared)
			answer_columns(r, "feed");
		else
			answer_columns(
			    r, "%s@%g", feed ? "feed" : "product", run->speed);
		curve[n++] = feed ? &run->feed : &run->product;
	}
	return n;
}

/* show feed and show product. */
static bool
show_curves(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct site *site = session_entry(s)->site;
	bool feed = strcmp(args->operand[0], "feed") == 0;
	const struct psd **curve = xcalloc(site->n_run, sizeof(*curve));
	struct answer *r = answers_new(site, "show", "%s, %% passing",
	    feed ? "feed" : "measured products");
	answer_columns(r, "sieve_mm: sieve mm");
	size_t n = add_columns(r, site, feed, curve);
	if (n == 0)
		answer_note(r, "the site file has a feed only");
	answer_missing(r, "");
	for (double x = INFINITY; (x = next_sieve(curve, n, x)) > 0;) {
		answer_cells(r, "%g", units_mm(x));
		for (size_t i = 0; i < n; i++)
			answer_cells(
			    r, "%.2f", units_pct(psd_at_sieve(curve[i], x)));
	}
	free(curve);
	return session_answer(s, r);
}

/* What can be shown; the first is shown when nothing is named. */
static const struct {
	const char *name;
	bool at_site;
	bool at_speed; /* takes the option speed */
	command_run *show;
} WHAT[] = {
    {"site", true, false, show_site},
    {"feed", true, false, show_curves},
    {"product", true, false, show_curves},
    {"params", true, false, show_params},
    {"bounds", false, false, show_bounds},
    {"model", true, false, show_model},
    {"models", false, false, show_models},
    {"selection", true, true, show_selection},
    {"appearance", true, false, show_appearance},
    {"store", false, false, show_store},
};

bool
cmd_show(struct session *s, const struct args *args, struct error *error)
{
	const char *what = args->n_operand > 0 ? args->operand[0] : "site";
	size_t i = 0;
	while (i < ARRAY_LEN(WHAT) && strcmp(what, WHAT[i].name) != 0)
		i++;
	if (i == ARRAY_LEN(WHAT))
		return error_set(error, ERROR_USAGE,
		    "there is no '%s' to show\n"
		    "write: show %s",
		    what, args->command->operands.usage);
	if (args_value(args, "speed")->given && !WHAT[i].at_speed)
		return error_set(error, ERROR_USAGE,
		    "show %s: expected no speed; it is the same at all speeds",
		    what);
	if (WHAT[i].at_site && !session_need_site(s, "show", error))
		return false;
	return WHAT[i].show(s, args, error);
}
