/* A crusher with its screens, as asked and as worked out at a speed: tonnes,
 * power, earnings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLANT_PLANT_H
#define TIPSPEED_CMD_PLANT_PLANT_H

#include "cmd/ask/question.h"
#include "cmd/session/session.h"
#include "core/answer/circuit.h"
#include "core/answer/crusher.h"
#include "core/answer/power.h"

/* What flow is asked, as a circuit with its prices and its power.  question:
 * borrowed.  size [n]: the classes.  back: what goes back to the crusher, in
 * words; NULL of a circuit of a file.  priced: there are prices; kwh: of a kWh,
 * 0 where it has none. */
struct flow_plan {
	struct circuit *circuit;
	char *back;
	bool from_file, priced;
	const struct question *question;
	size_t n;
	double *size, kwh;
	size_t n_reading;
	struct reading *reading;
	bool of_cuts; /* the readings are those of belt cuts */
};

/* Reads options and file. */
bool flow_plan_read(struct session *s, const struct args *args,
    const struct question *q, struct flow_plan *plan, struct error *error);
void flow_plan_free(struct flow_plan *plan);

/* A circuit with what its crushers are worked out by.  feed [plan->n]: masses
 * of the new feed.  own [n_unit]: of crushers that have a speed of their own.
 * bypass: the fitted share that misses the rotor; level: of bands. */
struct plant {
	struct session *s;
	const struct flow_plan *plan;
	const struct circuit *circuit;
	struct crusher *crusher;
	double *feed;
	struct transfer **own;
	struct power power;
	double bypass, level;
};

/* What a speed gives: values for the answer, then of each draw. */
struct outcome {
	double speed;
	struct flow flow;
	double kw, money, kw_draw[POSTERIOR_DRAWS], money_draw[POSTERIOR_DRAWS];
};

struct plant plant_new(struct session *s, const struct flow_plan *plan);
void plant_free(struct plant *p);

/* Of what goes into a crusher, t/h, that which meets the rotor; and the speed
 * that it has. */
double plant_rotor_share(const struct plant *p, const struct unit *unit);
double plant_speed(const struct unit *unit, double speed);

/* At a speed; flow_free its flow. */
struct outcome plant_at(const struct plant *p, double speed);

/* A row of the table: what leaves (unit), or goes back (unit NULL). */
struct plant_line {
	const char *name;
	const struct unit *unit;
	size_t stream;
};

/* Products and what goes back, in the order of the deck from fine to coarse, of
 * a file in its own; [n_stream + n_unit] out. */
size_t plant_lines(
    const struct plant *p, const struct outcome *o, struct plant_line *line);

/* Says so of an outcome that is still open; false. */
bool plant_not_steady(
    const struct plant *p, const struct outcome *o, struct error *error);

/* What an empty crusher takes at a speed, kW, as far as the readings tell; its
 * band. */
double plant_idle(const struct plant *p, double speed, double range[static 2]);

/* What the power was estimated from. */
char *plant_power_words(const struct plant *p, const struct outcome *o);

#endif
