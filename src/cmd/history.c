/* history: the generations of a calibration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "cmd/answers.h"
#include "cmd/table.h"

/* Rows that fit a screen with their heading. */
enum { ROWS = 18 };

/* The middle 80 % of the candidates in per cent of the bounds; 0 where a
 * parameter is held fixed. */
static double
spread(const struct history *h, const struct calibrate_generation *g, size_t j)
{
	double range = h->bounds.upper[j] - h->bounds.lower[j];
	return range > 0 ? 100 * (g->p90[j] - g->p10[j]) / range : 0;
}

static void
add_heads(struct answer *r, const struct breakage *of, bool exact)
{
	answer_columns(r, "generation: gen, best, median");
	for (size_t j = 0; j < of->n; j++) {
		const char *name = of->parameter[j].name;
		if (exact)
			answer_columns(
			    r, "%s, %s_p10, %s_p90", name, name, name);
		else
			answer_columns(r, "%s_p90: %s", name, name);
	}
}

static void
add_row(struct answer *r, const struct history *h, size_t i, bool exact)
{
	const struct calibrate_generation *g = &h->generation[i];
	answer_cells(r, "%g %.6f %.6f", (double)(i + 1), g->best, g->median);
	for (size_t j = 0; j < breakage_of(&g->params)->n; j++) {
		if (exact) {
			answer_cells(r, "%g %g %g", g->params.at[j], g->p10[j],
			    g->p90[j]);
		} else {
			answer_cells(r, "%.1f", spread(h, g, j));
		}
	}
}

static void
add_rows(struct answer *r, const struct history *h, size_t step, bool exact)
{
	add_heads(r, breakage_of(&h->generation[0].params), exact);
	for (size_t i = 0; i < h->n; i++)
		if (i % step == 0 || i + 1 == h->n)
			add_row(r, h, i, exact);
}

void
history_drop(struct history *h)
{
	if (h == NULL || --h->holders > 0)
		return;
	free(h->generation);
	misfit_free(h->misfit);
	free(h->uncertainty);
	band_free(&h->band);
	free(h);
}

bool
cmd_history(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_entry(s);
	const struct history *h = entry->history;
	if (h == NULL || h->n == 0)
		return error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	const struct value *every = args_value(args, "every");
	size_t step =
	    every->given ? (size_t)every->whole : (h->n + ROWS - 1) / ROWS;
	struct answer *r =
	    answers_new(entry->site, "history", "%zu generations", h->n);
	add_rows(r, h, step, false);
	answer_for_programs(r);
	add_rows(r, h, step, true);
	answer_say(r, ANSWER_REMARK,
	    "best and median misfit of the search, then the spread of each "
	    "parameter in %% of its bounds");
	answers_note_worth(r, entry);
	if (entry->fit.edits > 0)
		answer_say(r, ANSWER_REMARK,
		    "the bounds were edited after generation %zu%s: earlier "
		    "spreads are in %% of the edited bounds",
		    entry->fit.edited_at,
		    entry->fit.edits > 1 ? " and before" : "");
	return session_answer(s, r);
}
