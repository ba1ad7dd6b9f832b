/* Solves the circuit (plant_at) at speeds across the range and draws the tonnes
 * of each product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/flow_chart.h"

#include <math.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/trust_light.h"
#include "cmd/draw/site_chart.h"

/* Each point solves the circuit for all draws. */
enum { POINTS = 21, DRAWS = POSTERIOR_DRAWS };

/* The products, in the order of the table; circuits have the same at all
 * speeds.  Returns how many. */
static size_t
add_products(struct chart *chart, const struct plant *p,
    const struct outcome *o, const struct unit **unit)
{
	const struct circuit *c = p->circuit;
	struct plant_line *line =
	    xcalloc(c->n_stream + c->n_unit, sizeof *line);
	size_t n = plant_lines(p, o, line), products = 0;
	for (size_t i = 0; i < n; i++) {
		if (line[i].unit == NULL)
			continue;
		struct chart_series look = site_chart_look(products);
		look.line = CHART_SOLID;
		struct chart_series *s =
		    chart_add(chart, look, POINTS, "%s", line[i].name);
		if (o->flow.draws == DRAWS)
			chart_add_band(s);
		unit[products++] = line[i].unit;
	}
	free(line);
	return products;
}

static void
take_point(const struct plant *p, const struct outcome *o,
    const struct unit *unit, struct chart_series *s, size_t k)
{
	double draw[DRAWS], range[2];
	s->x[k] = o->speed;
	s->y[k] = o->flow.open ? NAN : flow_into(&o->flow, unit);
	if (s->low == NULL)
		return;
	s->low[k] = s->high[k] = s->y[k];
	if (o->flow.draws < DRAWS || o->flow.open)
		return;
	for (size_t d = 0; d < DRAWS; d++)
		draw[d] = flow_draw_into(&o->flow, unit, d);
	ensemble_range(draw, p->level, s->y[k], range);
	s->low[k] = range[0];
	s->high[k] = range[1];
}

struct chart *
flow_chart(const struct plant *p, double from, double to)
{
	const struct circuit *c = p->circuit;
	struct chart *chart = site_chart(p->plan->question->entry->site,
	    axis_linear(tr("tip speed, m/s"), from, to),
	    axis_linear("t/h", 0, c->tph), "products of %g t/h against speed",
	    c->tph);
	const struct unit **unit =
	    xcalloc(c->n_stream + c->n_unit, sizeof *unit);
	size_t n = 0;
	for (size_t k = 0; k < POINTS; k++) {
		double v = from + (to - from) * (double)k / (POINTS - 1);
		struct outcome o = plant_at(p, v);
		if (k == 0)
			n = add_products(chart, p, &o, unit);
		for (size_t i = 0; i < n; i++)
			take_point(p, &o, unit[i], chart->series[i], k);
		flow_free(&o.flow);
	}
	if (n > 0 && chart->series[0]->low != NULL)
		chart_note(chart, "band: %.0f %% uncertainty", 100 * p->level);
	/* That of the middle speed: further out it is as good at most. */
	char *light = light_said_at(p->s, p->plan->question->entry,
	    (from + to) / 2, p->plan->question->feed);
	chart_note(chart, "%s", light);
	free(light);
	free(unit);
	return chart;
}
