/* Heads of the columns of a made-up sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "habits.h"

static const char *
micro(const struct plan *plan)
{
	static const char *const SIGNS[] = {
	    "\xC2\xB5m", "um", "micron", "microns"};
	return plan->micro_greek ? "\xCE\xBCm" : plan_word(plan, SIGNS, 4);
}

char *
head_size(const struct plan *plan)
{
	static const char *const FORMS[] = {"%s (%s)", "%s [%s]", "%s, %s"};
	static const char *const CORNERS[] = {
	    "Sample", "Sample ID", "ID", "Description"};
	bool english = plan->tongue == &TONGUES[0];
	char *word = plan_upper(
	    plan, !plan->sample_corner ? plan_word(plan, plan->tongue->size, 6)
		  : english            ? plan_word(plan, CORNERS, 4)
				       : plan->tongue->sample);
	const char *unit = plan->sizes == SIZE_MM || plan->sizes == SIZE_RANGES
			       ? "mm"
			   : plan->sizes == SIZE_UM     ? micro(plan)
			   : plan->sizes == SIZE_INCHES ? "in"
							: NULL;
	char *text;
	if (plan->sizes == SIZE_NUMBERS)
		text = plan->word % 2 == 0
			   ? xasprintf("%s mesh", plan->series->name)
			   : xasprintf("Mesh (%s)", plan->series->name);
	else if (unit == NULL)
		text = xstrdup(word);
	else if (plan->word % 11 == 0)
		text = xstrdup(unit);
	else if (plan->word % 11 == 1)
		text = xasprintf("d (%s)", unit);
	else if (FORMS[plan->word % 3][2] == ' ' && plan->word % 3 == 0)
		text = xasprintf("%s (%s)", word, unit);
	else if (plan->word % 3 == 1)
		text = xasprintf("%s [%s]", word, unit);
	else
		text = xasprintf("%s %s", word, unit);
	free(word);
	return text;
}

static const char *
turns(const struct plan *plan)
{
	switch (plan->tongue->name[0]) {
	case 's':
		return "varv/min";
	case 'd':
		return "U/min";
	case 'f':
		return plan->tongue->name[1] == 'r' ? "tr/min" : "rpm";
	default:
		return "rpm";
	}
}

static size_t
number_of(const struct plan *plan, const struct curve *curve)
{
	size_t n = 0;
	for (size_t i = 0; i < plan->n_curve; i++)
		if (&plan->curve[i] <= curve && !plan->curve[i].feed)
			n++;
	return n;
}

static char *
rpm_of(const struct plan *plan, const struct curve *curve)
{
	double round_m = acos(-1) * plan->rotor_mm / 1000;
	return plan_number(plan, round(curve->speed * 60 / round_m), 0);
}

static char *
speed_mps(const struct plan *plan, const char *v)
{
	switch (plan->plain_speed ? 0 : plan->word / 7 % 8) {
	case 1:
		return xasprintf("%sm/s", v);
	case 2:
		return xasprintf("(%s m/s)", v);
	case 3:
		return xasprintf("v = %s m/s", v);
	case 4:
		return xasprintf("@ %s m/s", v);
	default:
		return xasprintf("%s m/s", v);
	}
}

/* The speed as the sheet gives it, without the role; "" of a feed for all. */
char *
head_speed(const struct plan *plan, const struct curve *curve)
{
	if (curve->speed <= 0)
		return xstrdup("");
	char *v = plan_short(plan, curve->as_written, 1), *text, *rpm;
	switch (plan->speeds) {
	case SPEED_AT:
		text = xasprintf("@%s", v);
		break;
	case SPEED_BARE:
		text = xstrdup(v);
		break;
	case SPEED_BOTH:
		rpm = rpm_of(plan, curve);
		text = xasprintf("%s %s (%s m/s)", rpm, turns(plan), v);
		free(rpm);
		break;
	case SPEED_RPM:
		text = xasprintf("%s %s", v, turns(plan));
		break;
	case SPEED_FEET:
		text = xasprintf("%s ft/min", v);
		break;
	case SPEED_KMH:
		text = xasprintf("%s km/h", v);
		break;
	case SPEED_BRACKETS:
		text = xasprintf("%zu (%s m/s)", number_of(plan, curve), v);
		break;
	case SPEED_DATED:
		text = xasprintf(
		    "2026-05-%02zu %s m/s", 2 + number_of(plan, curve), v);
		break;
	default:
		text = speed_mps(plan, v);
	}
	free(v);
	return text;
}

/* Whose numbers they are: "Product", "Prov 2"; "" before a speed alone. */
static char *
role_text(const struct plan *plan, const struct curve *curve)
{
	if (!curve->feed && plan->speeds == SPEED_ALONE &&
	    plan->heads != HEADS_SPEED_ROW && plan->heads != HEADS_APART)
		return xstrdup("");
	if (!curve->feed && plan->speeds == SPEED_SAMPLE) {
		char *word = plan_upper(plan, plan->tongue->sample);
		char *text = xasprintf("%s %zu", word, number_of(plan, curve));
		free(word);
		return text;
	}
	return plan_role(plan, curve->feed);
}

/* The parts that are not empty, with blanks between; frees them. */
static char *
joined(char *a, char *b, char *c)
{
	char *text = xasprintf("%s%s%s%s%s", a,
	    *a != '\0' && *b != '\0' && *b != '@' ? " " : "", b,
	    (*a != '\0' || *b != '\0') && *c != '\0' && *c != '@' && *c != ','
		? " "
		: "",
	    c);
	free(a);
	free(b);
	free(c);
	return text;
}

/* "Product 69 m/s". */
char *
head_sample(const struct plan *plan, const struct curve *curve)
{
	return joined(
	    role_text(plan, curve), head_speed(plan, curve), xstrdup(""));
}

size_t
head_rows(const struct plan *plan)
{
	static const size_t ROWS[] = {1, 2, 3, 2, 2, 2, 3};
	return ROWS[plan->heads];
}

static char *
quantity_text(const struct plan *plan, enum written quantity)
{
	return plan->plain_heads ? xstrdup("") : plan_quantity(plan, quantity);
}

/* "Product 69 m/s retained (g)", in one of several orders. */
static char *
whole_head(const struct plan *plan, const struct curve *curve, char *quantity)
{
	char *role = role_text(plan, curve), *speed = head_speed(plan, curve);
	if (plan->speeds == SPEED_AT || plan->word % 5 == 1)
		return joined(role, quantity, speed);
	if (plan->word % 5 == 2)
		return joined(quantity, role, speed);
	if (plan->word % 5 == 3 && *quantity != '\0') {
		char *with_comma = xasprintf(", %s", quantity);
		free(quantity);
		return joined(role, speed, with_comma);
	}
	return joined(role, speed, quantity);
}

/* With a line break in place of the first blank, as in a wrapped cell. */
static char *
broken(const struct plan *plan, char *text)
{
	char *blank = strchr(text, ' ');
	if (plan->broken_heads && blank != NULL)
		*blank = '\n';
	return text;
}

static void
curve_heads(const struct plan *plan, const struct curve *curve,
    const struct curve *left, struct sheets *grid, size_t row, size_t at)
{
	enum written q = curve->quantity;
	bool apart = plan->heads == HEADS_APART;
	char *unit = plan->plain_heads ? xstrdup(quantity_unit(plan, q))
				       : plan_quantity(plan, q);
	switch (plan->heads) {
	case HEADS_ONE:
		grid_put(grid, row, at,
		    broken(
			plan, whole_head(plan, curve, quantity_text(plan, q))));
		break;
	case HEADS_TWO:
		grid_put(grid, row, at, head_sample(plan, curve));
		grid_put(grid, row + 1, at, xstrdup(unit));
		break;
	case HEADS_THREE:
		if (left == NULL || left->feed != curve->feed ||
		    plan->speeds == SPEED_SAMPLE)
			grid_put(grid, row, at, role_text(plan, curve));
		grid_put(grid, row + 1, at, head_speed(plan, curve));
		grid_put(grid, row + 2, at, xstrdup(unit));
		break;
	case HEADS_SPEED_ROW:
	case HEADS_APART:
		grid_put(grid, apart ? row + 2 : row, at,
		    joined(role_text(plan, curve), quantity_text(plan, q),
			xstrdup("")));
		if (curve->speed > 0)
			grid_put(grid, apart ? row : row + 1, at,
			    plan_short(plan, curve->as_written, 1));
		break;
	case HEADS_UNIT_ROW:
		grid_put(grid, row, at,
		    whole_head(plan, curve,
			plan->plain_heads
			    ? xstrdup("")
			    : plan_upper(plan, quantity_word(plan, q))));
		grid_put(grid, row + 1, at, xstrdup(quantity_unit(plan, q)));
		break;
	case HEADS_ABOVE:
		grid_put(grid, row + 1, at, xstrdup(unit));
		break;
	}
	free(unit);
}

static void
size_heads(const struct plan *plan, struct sheets *grid, size_t row, size_t at)
{
	if (plan->heads == HEADS_UNIT_ROW && plan->sizes <= SIZE_UM) {
		grid_put(grid, row, at,
		    plan_upper(plan, plan_word(plan, plan->tongue->size, 6)));
		grid_put(grid, row + 1, at,
		    xstrdup(plan->sizes == SIZE_MM ? "mm" : micro(plan)));
		return;
	}
	bool first = plan->heads == HEADS_SPEED_ROW ||
		     plan->heads == HEADS_UNIT_ROW ||
		     (plan->heads != HEADS_ABOVE &&
			 plan->heads != HEADS_APART && plan->word % 2 == 0);
	grid_put(
	    grid, first ? row : row + head_rows(plan) - 1, at, head_size(plan));
	bool apart = plan->heads == HEADS_APART;
	if (plan->heads != HEADS_SPEED_ROW && !apart)
		return;
	const char *unit = plan->speeds == SPEED_RPM    ? turns(plan)
			   : plan->speeds == SPEED_FEET ? "ft/min"
			   : plan->speeds == SPEED_KMH  ? "km/h"
							: "m/s";
	char *word = plan_upper(plan, plan->tongue->speed);
	grid_put(grid, apart ? row : row + 1, at,
	    plan->word % 3 == 0 ? xasprintf("%s [%s]", word, unit)
				: xasprintf("%s (%s)", word, unit));
	if (apart && plan->word % 5 > 0)
		grid_put(grid, row + 1, at, xstrdup("Operator: JK"));
	free(word);
}

void
head_put(const struct plan *plan, const struct column_plan *column,
    const struct column_plan *before, struct sheets *grid, size_t row,
    size_t at)
{
	const struct tongue *t = plan->tongue;
	const struct curve *curve = &plan->curve[column->curve];
	const struct curve *left =
	    before != NULL && (before->kind == COLUMN_CURVE ||
				  before->kind == COLUMN_OTHER)
		? &plan->curve[before->curve]
		: NULL;
	const char *word = column->kind == COLUMN_NUMBER   ? ""
			   : column->kind == COLUMN_LOW    ? t->low
			   : column->kind == COLUMN_HIGH   ? t->high
			   : column->kind == COLUMN_REMARK ? t->remark
			   : column->kind == COLUMN_DATE   ? t->date
			   : column->kind == COLUMN_LAB    ? t->lab
							   : NULL;
	if (word != NULL && *word != '\0')
		grid_put(grid, row, at, plan_upper(plan, word));
	else if (column->kind == COLUMN_SIZE)
		size_heads(plan, grid, row, at);
	else if (column->kind == COLUMN_SIZE_MM)
		grid_put(grid, row, at, xstrdup("mm"));
	else if (column->kind == COLUMN_OTHER)
		curve_heads(plan, &column->other, left, grid, row, at);
	else if (column->kind == COLUMN_CURVE)
		curve_heads(plan, curve, left, grid, row, at);
}
