/* Chooses the next step by what the current site still lacks: a check, a
 * calibration, a validation, or nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/run/next.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/cut.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"

/* Returns the number of runs with a product to compare with.  *held_out:
 * whether any of them is held out. */
static size_t
count_runs_with_product(const struct entry *entry, bool *held_out)
{
	size_t n = 0;
	*held_out = false;
	for (size_t r = 0; r < entry->site->n_run; r++) {
		if (misfit_count_covered_sieves(&entry->site->run[r]) == 0)
			continue;
		n++;
		*held_out = *held_out || !entry->train[r];
	}
	return n;
}

static struct next
suggest_step_before_fit(const struct session *s, const struct entry *entry)
{
	bool held_out;
	size_t n = count_runs_with_product(entry, &held_out);
	double checked = session_number_in_last_answer(s, "check", "ok");
	if (entry->has_params)
		return (struct next){.stage = NEXT_ANSWER};
	if (n == 0)
		return (struct next){"guess",
		    N_("estimate its product from other quarries?"), false,
		    NEXT_CHECK};
	if (checked == 0)
		return (struct next){NULL,
		    N_("next: correct the sheet and load it again, or "
		       "'calibrate' with it as it is"),
		    false, NEXT_CALIBRATE};
	if (checked > 0)
		return held_out
			   ? (struct next){"calibrate; validate",
				 N_("calibrate and validate now?"), true,
				 NEXT_CALIBRATE}
			   : (struct next){"calibrate", N_("calibrate now?"),
				 true, NEXT_CALIBRATE};
	return held_out ? (struct next){"check; calibrate; validate",
			      N_("check, calibrate and validate now?"), true,
			      NEXT_CHECK}
			: (struct next){"check; calibrate",
			      N_("check and calibrate now?"), true, NEXT_CHECK};
}

static struct next
suggest_step_after_fit(const struct session *s, const struct entry *entry)
{
	bool held_out;
	count_runs_with_product(entry, &held_out);
	struct later later = cut_compare_runs_since_fit(s, entry);
	if (later.missed && later.n > 1 && !later.twice)
		return (struct next){"drift",
		    N_("follow the new cuts one by one?"), false,
		    NEXT_CALIBRATE};
	/* `add` has already suggested what to check. */
	if (later.missed || later.off || later.twice)
		return (struct next){.stage = NEXT_CALIBRATE};
	if (later.n > 0)
		return (struct next){"calibrate",
		    later.n > 1 ? N_("calibrate again, with the new cuts?")
				: N_("calibrate again, with the new cut?"),
		    true, NEXT_CALIBRATE};
	if (held_out && !origin_is_from_store(entry->origin) &&
	    isnan(session_number_in_last_answer(
		s, "validate", "holdout.speed")) &&
	    isnan(session_number_in_last_answer(s, "validate", "sites")))
		return (struct next){"validate",
		    N_("validate: compare it with what was kept as a check?"),
		    true, NEXT_VALIDATE};
	if (session_number_in_last_answer(s, "validate calibrate", "warnings") >
	    0)
		return (struct next){NULL,
		    N_("next: 'why' shows the reasons to doubt it, and what to "
		       "do"),
		    false, NEXT_ANSWER};
	if (s->linear)
		return (struct next){NULL,
		    N_("next: 'predict' at any speed; 'remember' keeps the "
		       "calibration for another day"),
		    false, NEXT_ANSWER};
	return (struct next){"tui",
	    origin_is_from_store(entry->origin)
		? N_("'predict' answers at this prompt, 'add' takes new cuts; "
		     "open full-screen mode?")
		: N_("'remember' keeps the calibration; open full-screen "
		     "mode?"),
	    false, NEXT_ANSWER};
}

static struct next
suggest_step_before_load(const struct session *s)
{
	size_t own = 0;
	bool remembered =
	    store_count_materials(s->store, &own, NULL) && own > 0;
	return (struct next){NULL,
	    remembered
		? N_("load your own sheet: load plant.xlsx; or bring back a "
		     "site that was remembered: 'recall', which lists them if "
		     "there are several")
		: N_("load your own sheet: load plant.xlsx; an empty one to "
		     "fill in: template > my.csv"),
	    false, NEXT_LOAD};
}

/* True if several sites are loaded and none has parameters, so that we cannot
 * know which one is meant. */
static bool
has_several_sites_all_without_params(const struct session *s)
{
	bool known = false;
	for (size_t i = 0; i < s->n_entry; i++)
		known = known || s->entry[i].has_params;
	return s->n_entry > 1 && !known;
}

struct next
suggest_next_step(const struct session *s)
{
	if (s->n_entry == 0)
		return suggest_step_before_load(s);
	if (has_several_sites_all_without_params(s))
		return (struct next){"check all; calibrate all; validate all",
		    N_("check, calibrate and validate all of them now?"), false,
		    NEXT_CHECK};
	if (s->job.paused)
		return (struct next){"continue",
		    N_("continue the stopped calibration?"), false,
		    NEXT_CALIBRATE};
	const struct entry *entry = &s->entry[s->current];
	return entry->has_fit ? suggest_step_after_fit(s, entry)
			      : suggest_step_before_fit(s, entry);
}

/* Notes at which speeds predict can answer. */
static void
note_predictable_speeds(const struct session *s, const struct entry *entry)
{
	double from, to;
	if (!origin_training_speed_range(entry, &from, &to))
		return;
	FREED char *usual =
	    speed_text_in_typed_unit(entry->site, answers_default_speed(entry));
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, from, to);
	session_print_note(s,
	    from < to ? N_("now 'predict %s', or any speed from %g to %g m/s%s")
		      : N_("now 'predict %s'"),
	    usual, from, to, rpm);
}

/* True if the answer before the newest one has this sentence. */
static bool
was_sentence_in_previous_answer(const struct session *s, const char *text)
{
	if (s->n_answer < 2)
		return false;
	struct answer_view before = answer_view(s->answer[s->n_answer - 2]);
	for (size_t i = 0; i < before.n_sentence; i++)
		if (strcmp(before.sentence[i].text, text) == 0)
			return true;
	return false;
}

void
next_print_answer_summary(const struct session *s)
{
	const struct answer *a = s->answer[s->n_answer - 1];
	struct answer_view view = answer_view(a);
	bool check = strcmp(answer_command_name(a), "check") == 0;
	/* Leaves out the first and the last sentence: load has said what was
	 * read, suggest_next_step suggests what to do, and check ends with
	 * remarks that are not shown here. */
	for (size_t i = check; i + 1 < view.n_sentence; i++)
		if (!was_sentence_in_previous_answer(s, view.sentence[i].text))
			session_print_note(s, "%s", view.sentence[i].text);
	size_t n = check ? view.n_row : 0;
	if (check)
		session_print_note(s,
		    n == 0
			? tr("no faults found")
			: tr_n("no faults found; %zu remark: 'check' shows it",
			      "no faults found; %zu remarks: 'check' shows "
			      "them",
			      n),
		    n);
	else if (suggest_next_step(s).stage == NEXT_ANSWER)
		note_predictable_speeds(s, &s->entry[s->current]);
}
