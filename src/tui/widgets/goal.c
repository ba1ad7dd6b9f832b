/* Completes and parses typed conditions, and composes the command that sets or
 * clears the goal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/goal.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <curses.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/envelope.h"
#include "cmd/ask/quantity_words.h"
#include "io/formats/standards.h"
#include "tui/acts.h"

/* More conditions than this are those of an envelope. */
enum { MANY = 4 };

bool
goal_is_search_done(const struct tui *t)
{
	return goals_is_search_done(t->session, &t->view.goal);
}

bool
goal_is_search_needed(const struct tui *t)
{
	return goals_is_search_needed(
	    t->session, &t->view.goal, tui_run_index_of_feed(t));
}

double
goal_best_speed(const struct tui *t)
{
	return goals_best_speed(t->session, &t->view.goal, tui_slider_speed(t));
}

char *
goal_result_text(const struct tui *t, enum goals_length length)
{
	return goals_outcome_text(t->session, tui_site_entry_for_prediction(t),
	    &t->view.goal, tui_slider_speed(t), length);
}

size_t
goal_list_limit_speeds(const struct tui *t, double *speed, size_t most)
{
	const struct goal *g = &t->view.goal;
	size_t n = 0;
	if (!goal_is_search_done(t))
		return 0;
	for (size_t i = 0; i < g->n_met && n < most; i++)
		speed[n++] = g->met[i];
	for (size_t i = 0; i < g->found->n_inside && n + 2 <= most; i++) {
		const struct speed_range *in = &g->found->inside[i];
		/* An end of the search is not a limit of the goal. */
		if (in->from > g->found->speed[0])
			speed[n++] = in->from;
		if (in->to < g->found->speed[g->found->n - 1])
			speed[n++] = in->to;
	}
	if (n == 0 && most > 0)
		speed[n++] = goal_best_speed(t);
	return n;
}

bool
goal_is_met_between(const struct tui *t, double from, double to, bool *certain)
{
	const struct goal *g = &t->view.goal;
	bool holds = false;
	*certain = false;
	if (!goal_is_search_done(t))
		return false;
	for (size_t i = 0; i < g->n_met; i++)
		holds = holds || (g->met[i] >= from && g->met[i] < to);
	for (size_t i = 0; i < g->found->n_inside && g->n_value == 0; i++)
		holds = holds || (g->found->inside[i].from < to &&
				     g->found->inside[i].to >= from);
	*certain = holds && g->n_value == 0 && g->found->sure[0] < to &&
		   g->found->sure[1] >= from;
	return holds;
}

double
goal_probability_at(const struct tui *t, double speed)
{
	const struct speed_search *found = t->view.goal.found;
	size_t k = 0;
	if (!goal_is_search_done(t))
		return NAN;
	while (k + 1 < found->n && found->speed[k] < speed - 0.05)
		k++;
	return found->certain[k];
}

double
goal_probability_at_slider(const struct tui *t)
{
	bool fits =
	    session_entry_being_fitted(t->session) == tui_current_site_entry(t);
	return fits || t->view.goal.n_value > 0
		   ? NAN
		   : goal_probability_at(t, tui_slider_speed(t));
}

bool
goal_is_viewed(const struct tui *t)
{
	const struct entry *entry = tui_current_site_entry(t);
	return t->ui.goal_view && t->ui.page == PAGE_PREDICT &&
	       goals_is_set(t->session) && entry != NULL && entry->has_params;
}

void
goal_show_condition_quantity(struct tui *t)
{
	const struct condition_list *list = &t->view.goal.list;
	size_t at = t->ui.list[PAGE_PREDICT].at;
	if (!goal_is_viewed(t) || list->n == 0)
		return;
	const struct quantity *q =
	    &list->at[at < list->n ? at : list->n - 1].quantity;
	/* A quantity with a list of sieves is not copied, because the list is
	 * freed with the goal. */
	t->ui.quantity_of_goal = false;
	if (q->sieve == NULL)
		t->ui.quantity = *q;
}

void
act_toggle_goal_view(struct tui *t, const struct key *key)
{
	(void)key;
	bool opens = !goal_is_viewed(t);
	t->ui.goal_view = opens;
	t->ui.goal_view = goal_is_viewed(t);
	/* The conditions are read by the first step. */
	if (t->ui.goal_view && goal_is_search_needed(t))
		goal_run_search_step(t);
	if (t->ui.goal_view && goal_is_search_done(t))
		t->ui.list[PAGE_PREDICT].at = t->view.goal.binds;
	goal_show_condition_quantity(t);
	if (opens && !goals_is_set(t->session))
		tui_set_message(t, false, "no goal yet: t sets one");
	else if (opens && !t->ui.goal_view)
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
}

void
act_open_goal_field(struct tui *t, const struct key *key)
{
	(void)key;
	const struct entry *entry = tui_current_site_entry(t);
	/* During a search, its best candidate so far is shown, and will do. */
	if (entry == NULL ||
	    (!entry->has_params && t->view.shown.product.n == 0)) {
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
		return;
	}
	FREED char *words = quantities_text_to_type(&t->ui.quantity);
	FREED char *line = goals_is_set(t->session)
			       ? xstrdup(t->session->set.goal)
			       : xasprintf("%s=", words);
	if (!goals_is_set(t->session))
		tui_set_message(t, false,
		    "such as p80=5.4, or passing 2 = 32..36, fines<3; Tab has "
		    "more");
	t->goal_field = t->goal_fresh = true;
	edit_begin(&t->line, line);
}

/* Completes the last condition with the names of quantities and of the
 * envelopes that come with the program. */
static void
complete_last_condition(struct edit *y)
{
	char *text = xstrdup(y->text), *comma = strrchr(text, ',');
	char *word = comma != NULL ? comma + 1 : text, *offers = xstrdup("");
	word += strspn(word, " ");
	char *first = NULL;
	struct standards *standards = standards_read_built_in();
	for (size_t i = 0, spec = 0; spec < standards->n; i++) {
		const char *name = quantities_nth_completion(i);
		if (name == NULL)
			name = standards->spec[spec++]->name;
		if (!text_is_same_but_case(name, word, strlen(word)))
			continue;
		xappend_to_list(&offers, "  ", "%s", name);
		if (first == NULL)
			first = xstrdup(name);
		else
			first[text_shared_prefix_bytes(first, name)] = '\0';
	}
	standards_free(standards);
	if (first != NULL && strlen(first) > strlen(word)) {
		*word = '\0';
		xappend(&text, "%s", first);
		edit_begin(y, text);
		free(offers);
	} else {
		xfree_and_set(&y->offers, offers[0] != '\0' ? offers : NULL);
		if (y->offers == NULL)
			free(offers);
	}
	free(first);
	free(text);
}

static void
close_goal_field(struct tui *t)
{
	edit_stop_editing(&t->line);
	t->goal_field = false;
	t->message[0] = '\0';
}

/* Returns the line that sets or clears the goal; NULL if nothing changes.  A
 * single envelope is also put to use, so that its limits are drawn. */
static char *
command_that_sets_goal(struct tui *t, const char *text)
{
	const struct session *s = t->session;
	bool envelope = text[0] != '\0' && !goals_is_condition_text(text) &&
			text_length_of_list_item(text) == strlen(text);
	FREED char *goal =
	    text_add_quotes(text[0] != '\0' ? text : SETTINGS_NONE);
	char *line = xstrdup("");
	close_goal_field(t);
	if (envelope && !session_is_calibrating(s))
		xappend(&line, "spec use %s; ", goal);
	xappend(&line, "set goal %s", goal);
	if (strcmp(text, s->set.goal) != 0)
		return line;
	free(line);
	return NULL;
}

/* Shows a quantity typed without a value, "p80" or "p80=", above the track and
 * leaves the goal as it is.  Returns false if the text is not a quantity. */
static bool
show_typed_quantity(struct tui *t, const char *text)
{
	struct quantity q;
	struct error error = {0};
	FREED char *copy = xstrdup(text);
	size_t n = strlen(copy);
	if (n > 0 && copy[n - 1] == '=')
		copy[n - 1] = '\0';
	bool ok = quantities_parse_one(copy, &PARTITION_IDEAL, &q, &error);
	if (ok && quantities_check_feed_covers(&q, tui_feed_curve(t), &error)) {
		t->ui.quantity = q;
		t->ui.quantity_of_goal = false;
		close_goal_field(t);
		if (goals_is_set(t->session))
			tui_set_message(t, false,
			    "above the track now: %s; the goal stays %s", text,
			    t->session->set.goal);
	} else if (ok) {
		tui_set_message(t, true, "%s: %s", error.text, error.hint);
	}
	return ok;
}

/* Shows the quantity of the condition that binds, once that is known, unless
 * the user chose another. */
static void
show_binding_condition_quantity(struct tui *t)
{
	const struct goal *g = &t->view.goal;
	if (!goal_is_search_done(t) || !t->ui.quantity_of_goal)
		return;
	const struct quantity *binds = &g->list.at[g->binds].quantity;
	/* A quantity with a list of sieves is not copied, because the list is
	 * freed with the goal. */
	if (binds->sieve == NULL)
		t->ui.quantity = *binds;
}

void
goal_run_search_step(struct tui *t)
{
	struct goal *g = &t->view.goal;
	bool pending = goal_is_search_needed(t);
	goals_step_search(t->session, tui_site_entry_for_prediction(t), g,
	    tui_run_index_of_feed(t));
	if (pending)
		show_binding_condition_quantity(t);
}

/* Reads the field on Enter.  Returns the command to run, or NULL.  A text that
 * cannot be read stays, to be corrected. */
static char *
parse_goal_field(struct tui *t)
{
	char *line = NULL;
	struct condition_list list = {0};
	struct error error = {0};
	char *copy = xstrdup(t->line.text), *text = text_trim(copy);
	/* Quotes are needed at the prompt, but mean nothing here. */
	for (char *p = text; (p = strchr(p, '"')) != NULL;)
		memmove(p, p + 1, strlen(p));
	size_t n_value = 0;
	t->message[0] = '\0';
	if (text[0] == '\0' || text_is_same_folded(text, SETTINGS_NONE)) {
		line = command_that_sets_goal(t, "");
	} else if (show_typed_quantity(t, text)) {
	} else if (goals_parse(t->session, text, tui_feed_curve(t), &list,
		       &n_value, &error)) {
		/* Until it is known which condition binds, that of the last
		 * is shown or, of an envelope, of one in the middle. */
		size_t shown = list.n > MANY ? list.n / 2 : list.n - 1;
		if (list.n > 0)
			t->ui.quantity = list.at[shown].quantity;
		t->ui.quantity_of_goal = true;
		line = command_that_sets_goal(t, text);
		if (line == NULL)
			show_binding_condition_quantity(t);
	} else {
		tui_set_message(t, true, "%s%s%s", error.text,
		    error.hint[0] != '\0' ? ": " : "", error.hint);
	}
	conditions_free(&list);
	free(copy);
	return line;
}

/* Replaces the proposed text when the first character is typed: a letter begins
 * another quantity, a sign a condition of the quantity shown, a digit its
 * value.  After a comma, another condition is added instead. */
static void
replace_proposed_goal_text(struct tui *t, int code)
{
	if (code == ',' || code == ';')
		return;
	FREED char *words = quantities_text_to_type(&t->ui.quantity);
	if (!strchr("<>=", code))
		xappend(&words, "=");
	edit_begin(&t->line, isalpha(code) ? "" : words);
}

/* Handles "/" typed after a value, "p80=0": leaves the number alone, because it
 * begins a fraction, "0/2". */
static void
reduce_goal_text_to_number(struct edit *y)
{
	const char *sign = strchr(y->text, '=');
	if (sign == NULL || sign[1] == '\0' ||
	    sign[1 + strspn(sign + 1, "0123456789.")] != '\0')
		return;
	FREED char *number = xstrdup(sign + 1);
	edit_begin(y, number);
}

char *
goal_edit_field_by_key(struct tui *t, int code, bool special)
{
	struct edit *y = &t->line;
	if (!special && code == '\t') {
		/* A goal that is set is completed; what is only proposed makes
		 * room for the list. */
		if (t->goal_fresh && !goals_is_set(t->session))
			edit_begin(y, "");
		t->goal_fresh = false;
		size_t next = edit_first_unshown_completion(y), n = y->n;
		complete_last_condition(y);
		y->from = y->n == n ? next : 0;
		return NULL;
	}
	if (special && (code == KEY_UP || code == KEY_DOWN))
		return NULL;
	if (t->goal_fresh && !special && code > ' ' && code < 127)
		replace_proposed_goal_text(t, code);
	if (!special && code == '/')
		reduce_goal_text_to_number(y);
	t->goal_fresh = false;
	switch (edit_handle_key(y, t->session, code, special)) {
	case EDIT_DONE:
		return parse_goal_field(t);
	case EDIT_GIVEN_UP:
		close_goal_field(t);
		break;
	case EDIT_ON:
		break;
	}
	return NULL;
}
