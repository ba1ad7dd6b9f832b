/* Draws a row for each condition, with its value at the slider's speed and the
 * speeds at which it holds by itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/goal_view.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "core/psd/rotor_speed.h"
#include "tui/screen.h"
#include "tui/widgets/goal.h"
#include "tui/widgets/list.h"

enum column { CONDITION, NOW, HOLDS, SPEEDS, COLUMNS };

static const struct list_column COLUMN[COLUMNS] = {
    [CONDITION] = {N_("condition"), 12, 0},
    [NOW] = {N_("now"), 6, 1, .right = true},
    [HOLDS] = {N_("met"), 5, 2},
    [SPEEDS] = {N_("by itself at"), 12, 3}};

/* Returns the value of a condition's quantity at the slider's speed, in the
 * unit of the condition. */
static double
condition_value_at_slider(const struct tui *t, const struct condition *c)
{
	const struct psd *product = &t->view.shown.product;
	return product->n > 0
		   ? screened_quantity_of_product(product, &c->quantity)
		   : NAN;
}

/* Returns true if the speeds of the goal are known.  During a search, those
 * known are of the old parameters, while the values shown are of the new
 * ones. */
static bool
are_goal_speeds_known(const struct tui *t)
{
	return goal_is_search_done(t) &&
	       session_entry_being_fitted(t->session) !=
		   tui_current_site_entry(t);
}

/* Returns true if the slider is as near as it gets to a speed that gives the
 * value of the goal. */
static bool
is_slider_at_goal_value(const struct tui *t)
{
	const struct slider_range range = tui_slider_range(t);
	bool at = false;
	if (!are_goal_speeds_known(t))
		return false;
	const struct speed_search *found = t->view.goal.found;
	for (size_t k = 0; k < found->n_root; k++)
		at |= slider_position_of_speed(range, found->root[k].speed) ==
		      tui_slider_position(t);
	return at;
}

static bool
is_condition_met_at_slider(const struct tui *t, const struct condition *c)
{
	double value = condition_value_at_slider(t, c);
	if (c->least == c->most)
		return is_slider_at_goal_value(t);
	return !(value < c->least) && !(value > c->most) && !isnan(value);
}

/* Returns the speeds at which condition i holds by itself, "70.8 to 78.0 m/s"
 * or, for a goal that is a value, those that give it. */
static char *
condition_speeds_text(const struct tui *t, size_t i)
{
	const struct goal *g = &t->view.goal;
	bool known = are_goal_speeds_known(t);
	if (!known || i >= g->list.n - g->n_value) {
		char *met = xstrdup(known && g->n_met > 0 ? "" : "-");
		for (size_t k = 0; known && k < g->n_met; k++) {
			FREED char *speed = answers_speed_text(
			    tui_current_site(t), g->met[k], 1);
			xappend_to_list(&met, ", ", "%s", speed);
		}
		return met;
	}
	const double *alone = g->found->alone[i];
	const struct site *site = tui_current_site_entry(t)->site;
	double low = isfinite(alone[0]) ? alone[0] : alone[1];
	double high =
	    isfinite(alone[0]) && isfinite(alone[1]) ? alone[1] : (double)NAN;
	FREED char *rpm = isfinite(low)
			      ? rotor_speed_rpm_text(site->rotor, low, high)
			      : xstrdup("");
	if (isfinite(high))
		return xasprintf(tr("%.1f to %.1f m/s%s"), low, high, rpm);
	if (isfinite(low))
		return xasprintf(isfinite(alone[0]) ? tr("from %.1f m/s%s")
						    : tr("up to %.1f m/s%s"),
		    low, rpm);
	FREED char *range = answers_speed_range_words(
	    site, g->found->speed[0], g->found->speed[g->found->n - 1], true);
	return xasprintf(is_condition_met_at_slider(t, &g->list.at[i])
			     ? tr("all %s")
			     : tr("none %s"),
	    range);
}

static char *
condition_cell_text(const struct tui *t, size_t i, int column)
{
	const struct condition *c = &t->view.goal.list.at[i];
	double value = quantities_value_in_shown_unit(
	    &c->quantity, condition_value_at_slider(t, c));
	if (column == CONDITION)
		return conditions_one_text(c);
	if (column == SPEEDS)
		return condition_speeds_text(t, i);
	if (column == HOLDS)
		return xstrdup(
		    is_condition_met_at_slider(t, c) ? tr("yes")
		    : c->least == c->most && !are_goal_speeds_known(t)
			? "-"
			: tr(" NO"));
	return isnan(value) ? xstrdup("-")
			    : xasprintf("%.*f",
				  quantities_decimals(&c->quantity), value);
}

static const struct list_table TABLE = {
    .column = COLUMN, .n = COLUMNS, .cell = condition_cell_text};

int
goal_view_count_rows(const struct tui *t)
{
	enum { HEAD = 1, FOOT = 1, MOST = 9 };
	int rows = HEAD + (int)t->view.goal.list.n + FOOT;
	return !goal_is_viewed(t) ? 0 : rows < MOST ? rows : MOST;
}

/* Says how likely the goal is to be met at the slider's speed. */
static void
draw_goal_probability(const struct tui *t, const struct area *area)
{
	double speed = tui_slider_speed(t);
	double certain = goal_probability_at_slider(t);
	if (isnan(certain))
		return;
	FREED char *percent = conditions_probability_text(certain);
	FREED char *rpm =
	    rotor_speed_rpm_text(tui_rotor_diameter(t), speed, NAN);
	screen_draw_text(area, 0, 0, LOOK_BOLD,
	    t->view.goal.list.n > 1 ? N_("chance of all at %.1f m/s%s: %s")
				    : N_("chance at %.1f m/s%s: %s"),
	    speed, rpm, percent);
}

void
goal_view_draw(struct tui *t)
{
	struct area list = t->layout.body,
		    foot = area_of_row(&list, list.rows - 1);
	int wanted[LIST_COLUMNS];
	if (list.rows > 2) {
		draw_goal_probability(t, &foot);
		list.rows--;
	}
	table_measure_columns(t, &TABLE, t->view.goal.list.n, wanted);
	table_draw(t, &list, &TABLE, wanted);
}
