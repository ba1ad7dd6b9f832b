/* window: the speeds at which conditions hold.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"

/* The conditions, the question, and the search for the speeds that meet them.
 * detail: show more than one speed and its range. */
struct window_request {
	struct condition_list list;
	const struct question *q;
	struct conditions_search wanted;
	struct speed_search *w;
	bool detail;
};

/* Takes the conditions of the session's goal if the call has none. */
static bool
add_session_goal_conditions(
    struct session *s, struct window_request *a, struct error *error)
{
	size_t n_value = 0;
	if (a->list.n > 0 || !goals_is_set(s))
		return true;
	if (!goals_parse(
		s, s->set.goal, question_feed(a->q), &a->list, &n_value, error))
		return false;
	return n_value == 0 || error_set(error, ERROR_USAGE,
				   "the goal %s is a value, not a limit\n"
				   "for the speed that meets it write: find %s",
				   s->set.goal, s->set.goal);
}

static bool
parse_window_conditions(struct session *s, const struct args *args,
    struct window_request *a, struct error *error)
{
	if (!conditions_add_from_args(s, args, a->q, &a->list, error) ||
	    !add_session_goal_conditions(s, a, error))
		return false;
	return a->list.n > 0 || error_set(error, ERROR_USAGE,
				    "expected conditions, got none\n"
				    "write: window \"passing 2 = 40..50\" "
				    "\"passing 0.063 < 6\", or window "
				    "spec=FILE");
}

static void
search_speed_window(
    struct session *s, struct window_request *a, double from, double to)
{
	a->wanted = conditions_open_search(s, a->q, &a->list, NULL);
	a->wanted.from = from;
	a->wanted.to = to;
	a->w = speed_search_run(&a->wanted);
	forecast_set_speed(a->wanted.forecast, a->w->best);
}

/* Notes "passing 0.5 mm sets the lower end, 71.5 m/s, passing 0.063 mm the
 * upper, 76.2 m/s".  One quantity may set both. */
static void
note_binding_conditions(struct answer *r, const struct window_request *a)
{
	const struct speed_range *in = speed_search_best_range(a->w);
	const struct site *site = a->wanted.entry->site;
	FREED char *from = rotor_speed_rpm_text(site->rotor, in->from, NAN);
	FREED char *to = rotor_speed_rpm_text(site->rotor, in->to, NAN);
	FREED char *both = rotor_speed_rpm_text(site->rotor, in->from, in->to);
	FREED char *asked =
	    rotor_speed_rpm_text(site->rotor, a->wanted.from, a->wanted.to);
	FREED char *words = xstrdup("");
	if (in->low.i != SIZE_MAX) {
		FREED char *q =
		    quantities_name(&a->list.at[in->low.i].quantity);
		if (in->high.i == in->low.i)
			xappend(&words,
			    tr("%s sets both ends: %.1f and %.1f m/s%s"), q,
			    in->from, in->to, both);
		else
			xappend(&words, tr("%s sets the lower end, %.1f m/s%s"),
			    q, in->from, from);
	}
	if (in->high.i != SIZE_MAX && in->high.i != in->low.i) {
		FREED char *q =
		    quantities_name(&a->list.at[in->high.i].quantity);
		if (words[0] == '\0')
			xappend(&words, tr("%s sets the upper end, %.1f m/s%s"),
			    q, in->to, to);
		else
			xappend_to_list(&words, ", ",
			    tr("%s the upper, %.1f m/s%s"), q, in->to, to);
	}
	if (words[0] != '\0')
		answer_note(r, "%s", words);
	else
		answer_note(r, "no condition sets a limit from %g to %g m/s%s",
		    a->wanted.from, a->wanted.to, asked);
}

/* Notes "1.2 points away, 0.9 times the width of its band". */
static void
note_margin_to_limit(struct answer *r, const struct window_request *a)
{
	const struct margin *m = &a->w->margin;
	if (!isfinite(m->passing))
		return;
	FREED char *limit = conditions_limit_text(a->list.at, m->limit);
	FREED char *distance = conditions_margin_text(&a->wanted, *m);
	if (isfinite(m->widths))
		answer_note(r,
		    "nearest limit there: %s, %s away, %.1f times the width of "
		    "the band",
		    limit, distance, m->widths);
	else
		answer_note(
		    r, "nearest limit there: %s, %s away", limit, distance);
}

/* True if the conditions hold at none of the site's speeds and the best speed
 * is outside the training speeds. */
static bool
is_window_beyond_measured_speeds(const struct window_request *a)
{
	const struct site *site = a->wanted.entry->site;
	const struct speed_search *w = a->w;
	for (size_t i = 0; i < site->n_run; i++)
		for (size_t k = 0; k < w->n_inside; k++)
			if (site->run[i].speed >= w->inside[k].from &&
			    site->run[i].speed <= w->inside[k].to)
				return false;
	return isfinite(a->wanted.reach) &&
	       answers_is_speed_extrapolated(a->q->entry, w->best);
}

static bool
is_any_run_in_searched_range(const struct window_request *a)
{
	const struct site *site = a->wanted.entry->site;
	bool any = false;
	for (size_t i = 0; i < site->n_run && !any; i++)
		any = site->run[i].speed >= a->wanted.from &&
		      site->run[i].speed <= a->wanted.to;
	return any;
}

/* Notes all speeds at which the answer meets the conditions. */
static void
note_speeds_meeting_conditions(
    struct answer *r, const struct window_request *a, bool no_run)
{
	FREED char *speeds =
	    conditions_met_speeds_text_with_units(&a->wanted, a->w);
	bool several = a->list.n > 1;
	FREED char *rpm = rotor_speed_rpm_text(
	    a->wanted.entry->site->rotor, a->wanted.from, a->wanted.to);
	if (no_run && !is_any_run_in_searched_range(a))
		answer_note(r,
		    several ? N_("no speed from %g to %g m/s%s was measured: "
				 "by the model all conditions hold at %s")
			    : N_("no speed from %g to %g m/s%s was measured: "
				 "by the model it holds at %s"),
		    a->wanted.from, a->wanted.to, rpm, speeds);
	else if (no_run)
		answer_note(r,
		    several ? N_("no measured speed will do: by the model all "
				 "conditions hold at %s")
			    : N_("no measured speed will do: by the model it "
				 "holds at %s"),
		    speeds);
	else
		answer_note(r,
		    several ? N_("the answer meets all conditions at %s")
			    : N_("the answer meets it at %s"),
		    speeds);
}

static void
note_if_window_extrapolated(struct answer *r, const struct window_request *a)
{
	const struct speed_range *in = speed_search_best_range(a->w);
	double slowest, fastest;
	if (!origin_training_speed_range(a->q->entry, &slowest, &fastest) ||
	    (in->from >= slowest && in->to <= fastest))
		return;
	FREED char *reach =
	    answers_training_range_text(a->q->entry, slowest, fastest);
	answer_add_sentence(
	    r, ANSWER_REMARK, "outside the %s, it rests on the model", reach);
}

/* Notes the speeds at which the answer meets the conditions, unless the certain
 * speeds already noted are about the same; with detail=on also what limits
 * them. */
static void
note_speeds_in_window(struct answer *r, const struct window_request *a)
{
	const struct speed_range *in = speed_search_best_range(a->w);
	bool no_run = is_window_beyond_measured_speeds(a);
	if (a->detail || no_run || a->w->n_inside > 1 ||
	    !isfinite(a->w->sure[0]))
		note_speeds_meeting_conditions(r, a, no_run);
	if (a->detail)
		note_binding_conditions(r, a);
	conditions_note_unsearched_speeds(r, &a->wanted,
	    in->low.i == SIZE_MAX && in->from <= a->wanted.from,
	    in->high.i == SIZE_MAX && in->to >= a->wanted.to);
	if (!a->detail)
		return;
	note_if_window_extrapolated(r, a);
	note_margin_to_limit(r, a);
}

static void
put_certainty_fields(struct fields *o, const struct window_request *a)
{
	const struct speed_search *w = a->w;
	if (isfinite(w->sure[0]))
		answers_put_low_high_field(
		    o, "certain", w->sure[0], w->sure[1]);
	else
		fields_put_number(o, "certain", NAN);
	fields_put_values(o, "certainty_pct %g level %g slowest_safe %g",
	    100 * w->best_certain, 100 * a->wanted.level, w->safe);
}

static void
put_binding_limits(struct fields *o, const struct window_request *a)
{
	const struct wanted_limit limit[] = {a->w->low, a->w->high};
	for (size_t k = 0; k < 2; k++) {
		if (limit[k].i == SIZE_MAX) {
			fields_put_number(
			    o, k == 0 ? "binds_low" : "binds_high", NAN);
			continue;
		}
		FREED char *words = conditions_limit_text(a->list.at, limit[k]);
		fields_put_values(
		    o, k == 0 ? "binds_low %s" : "binds_high %s", words);
	}
}

static void
put_window_fields(
    struct fields *o, const struct window_request *a, bool outside)
{
	const struct speed_search *w = a->w;
	struct fields *inside = fields_add_list(o, "inside");
	for (size_t k = 0; k < w->n_inside; k++)
		fields_put_values(fields_add_list(inside, NULL), "%g %g",
		    w->inside[k].from, w->inside[k].to);
	fields_put_values(o,
	    "best %g margin_pct %g margin_widths %g from %g to %g "
	    "extrapolated %d",
	    w->best, 100 * w->margin.passing, w->margin.widths, a->wanted.from,
	    a->wanted.to, outside);
	put_binding_limits(o, a);
}

/* Notes the plot that shows the same.  It has no from= and to=. */
static void
note_plot_command_showing_same(struct answer *r, const struct args *args)
{
	FREED char *limits = xstrdup("");
	for (size_t i = 0; i < args->n_operand; i++)
		xappend_to_list(&limits, ",", "%s", args->operand[i]);
	bool same = !args_is_given(args, &args->from) &&
		    !args_is_given(args, &args->to);
	if (same && args->n_operand > 0 && strchr(limits, '"') == NULL)
		answer_note(r, "picture: plot response limits=\"%s\"", limits);
}

static void
note_window_result(
    struct answer *r, const struct session *s, const struct window_request *a)
{
	if (a->w->n_inside > 0) {
		conditions_note_best_speed(
		    r, &a->wanted, a->list.n > 1, a->detail, a->w);
		note_speeds_in_window(r, a);
	} else {
		conditions_note_why_unmet(r, &a->wanted, a->w);
		conditions_note_best_speed(
		    r, &a->wanted, a->list.n > 1, a->detail, a->w);
	}
	if (isnan(a->w->best_certain))
		answer_note(r, "%s", band_why_missing(s, a->q->entry));
}

static struct answer *
begin_window_answer(const struct window_request *a)
{
	const struct site *site = a->wanted.entry->site;
	double v = a->w->best;
	bool several = a->list.n > 1;
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, v, NAN);
	if (a->w->n_inside > 0)
		return answer_new_about_site(site, "window", "%s at %.1f m/s%s",
		    several ? tr("conditions") : tr("the condition"), v, rpm);
	return answer_new_about_site(site, "window",
	    several ? N_("no speed meets the conditions; at %.1f m/s%s")
		    : N_("no speed meets the condition; at %.1f m/s%s"),
	    v, rpm);
}

bool
cmd_window(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct entry *entry = q->entry;
	struct window_request a = {.q = q, .detail = args->detail};
	double from, to;
	bool ok = conditions_parse_search_range(
		      s, args, entry->site, &from, &to, error) &&
		  parse_window_conditions(s, args, &a, error);
	if (ok) {
		search_speed_window(s, &a, from, to);
		struct answer *r = begin_window_answer(&a);
		conditions_add_answer_rows(r, &a.wanted, a.w);
		conditions_put_fields(answer_json_fields(r), &a.wanted, a.w);
		note_window_result(r, s, &a);
		put_window_fields(answer_json_fields(r), &a,
		    answers_is_speed_extrapolated(entry, a.w->best));
		put_certainty_fields(answer_json_fields(r), &a);
		answer_repeat_fields_in_rows(
		    r, "best certainty_pct best_trust");
		if (a.detail)
			note_plot_command_showing_same(r, args);
		conditions_note_source_of_limits(r, &a.list);
		conditions_note_basis_and_trust(
		    r, q, &a.wanted, a.w, a.w->best);
		session_set_last_question(s, a.w->best, &a.list.at[0].quantity);
		s->last_asked.found_by = "window";
		forecast_close(a.wanted.forecast);
		speed_search_free(a.w);
		ok = session_show_answer(s, r);
	}
	conditions_free(&a.list);
	return ok;
}
