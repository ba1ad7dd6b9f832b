/* Solves the circuit for the draws at a speed (circuit_flow), and adds power
 * and earnings draw by draw.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/plant/plant.h"

#include <math.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/outlook.h"
#include "core/posterior/ensemble.h"

struct plant
plant_new(struct session *s, const struct flow_plan *plan)
{
	const struct entry *entry = plan->question->entry;
	const struct breakage *of = breakage_of(&entry->params);
	struct plant p = {.s = s,
	    .plan = plan,
	    .circuit = plan->circuit,
	    .crusher = outlook_crusher(s, entry, plan->size, plan->n),
	    .own = xcalloc(plan->circuit->n_unit, sizeof(*p.own)),
	    .power = power_fit(plan->reading, plan->n_reading),
	    .bypass = of->bypass ? entry->params.at[of->n - 1] : 0,
	    .level = settings_level(&s->set)};
	p.feed = xdoubles(plan->n);
	const struct psd *feed = site_feed(entry->site, plan->question->feed);
	crusher_classes(p.crusher, feed, p.feed);
	struct psd sieves = predict_sizes(entry->site, feed);
	crusher_match(p.crusher, feed, sieves.size, sieves.n);
	psd_free(&sieves);
	for (size_t u = 0; u < p.circuit->n_unit; u++)
		if (p.circuit->unit[u].speed > 0)
			p.own[u] =
			    crusher_at(p.crusher, p.circuit->unit[u].speed);
	return p;
}

void
plant_free(struct plant *p)
{
	for (size_t u = 0; u < p->circuit->n_unit; u++)
		transfer_free(p->own[u]);
	free(p->own);
	free(p->feed);
	crusher_free(p->crusher);
}

double
plant_rotor_share(const struct plant *p, const struct unit *unit)
{
	return (1 - unit->cascade) * (1 - p->bypass);
}

double
plant_speed(const struct unit *unit, double speed)
{
	return unit->speed > 0 ? unit->speed : speed;
}

/* Power and earnings of a draw; a model alone has one product for all draws of
 * the power. */
static void
count_draw(const struct plant *p, struct outcome *o, size_t d)
{
	double kw = 0, money = 0;
	size_t of = d % o->flow.draws;
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		double tph = flow_draw_into(&o->flow, unit, of);
		if (unit->kind == UNIT_CRUSHER)
			kw +=
			    power_at(&p->power, d, plant_speed(unit, o->speed),
				tph * plant_rotor_share(p, unit));
		if (unit->kind == UNIT_STOCKPILE && isfinite(unit->price))
			money += tph * unit->price;
	}
	o->kw_draw[d] = kw;
	o->money_draw[d] = money - kw * p->plan->kwh;
	o->kw += kw / POWER_DRAWS;
	o->money += o->money_draw[d] / POWER_DRAWS;
}

struct outcome
plant_at(const struct plant *p, double speed)
{
	struct outcome o = {.speed = speed};
	struct transfer *t = crusher_at(p->crusher, speed);
	struct transfer **of = xcalloc(p->circuit->n_unit, sizeof(*of));
	for (size_t u = 0; u < p->circuit->n_unit; u++)
		of[u] = p->own[u] != NULL ? p->own[u] : t;
	o.flow =
	    circuit_flow(p->circuit, p->feed, p->plan->size, p->plan->n, of);
	for (size_t d = 0; d < POWER_DRAWS; d++)
		count_draw(p, &o, d);
	free(of);
	transfer_free(t);
	return o;
}

size_t
plant_lines(
    const struct plant *p, const struct outcome *o, struct plant_line *line)
{
	const struct circuit *c = p->circuit;
	size_t n = 0;
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_STOCKPILE)
			line[n++] = (struct plant_line){
			    c->unit[u].name, &c->unit[u], c->unit[u].in[0]};
	for (size_t i = 0; i < c->n_stream; i++)
		if (o->flow.back[i])
			line[n++] = (struct plant_line){c->stream[i], NULL, i};
	/* Streams of the deck were made from coarse to fine. */
	for (size_t i = 1; i < n && !p->plan->from_file; i++)
		for (size_t k = i; k > 0 && line[k - 1].stream < line[k].stream;
		     k--) {
			struct plant_line other = line[k];
			line[k] = line[k - 1];
			line[k - 1] = other;
		}
	return n;
}

/* "7.3e+03 t/h circulate after 1000 passes". */
bool
plant_not_steady(
    const struct plant *p, const struct outcome *o, struct error *error)
{
	return error_set(error, ERROR_NUMERIC,
	    "the circuit does not become steady at %g m/s: after %d passes "
	    "%.4g t/h circulate for %g t/h of new feed, and it still grows\n"
	    "what goes back hardly breaks: send a coarser fraction back, take "
	    "some of it out, or use a higher speed",
	    o->speed, (int)CIRCUIT_PASSES, o->flow.circulating,
	    p->circuit->tph);
}

double
plant_idle(const struct plant *p, double speed, double range[static 2])
{
	double draw[POWER_DRAWS], mean = 0;
	for (size_t d = 0; d < POWER_DRAWS; d++) {
		draw[d] = power_idle(&p->power, d, speed);
		mean += draw[d] / POWER_DRAWS;
	}
	ensemble_range(draw, p->level, mean, range);
	return mean;
}

char *
plant_power_words(const struct plant *p, const struct outcome *o)
{
	const struct power *w = &p->power;
	double range[2], idle = plant_idle(p, o->speed, range);
	if (w->n == 0)
		return xstrdup(
		    tr("no motor readings: Q v2 alone, what it takes to bring "
		       "the rock to the tip speed, which is a lower limit; "
		       "give power=m/s:kW:t/h"));
	char *words =
	    xasprintf(tr_n("engineering estimate from %zu reading %s, idle "
			   "%.0f kW (%.0f to %.0f) at %g m/s",
			  "engineering estimate from %zu readings %s, idle "
			  "%.0f kW (%.0f to %.0f) at %g m/s",
			  w->n),
		w->n, p->plan->of_cuts ? tr("of the belt cuts") : tr("given"),
		idle, range[0], range[1], o->speed);
	if (w->n > 3)
		xlist(&words, "; ", tr("the readings miss it by %.1f kW (RMS)"),
		    w->rms);
	if (range[1] - range[0] > 0.1 * o->kw)
		xlist(&words, "; ", "%s",
		    tr("the readings do not tell idle from load: read the "
		       "empty crusher at two speeds, too, as in "
		       "power=66:kW:0,78:kW:0"));
	return words;
}
