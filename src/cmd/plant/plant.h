/* A crusher with its screens, as specified and as computed at a speed: tonnes,
 * power, earnings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLANT_PLANT_H
#define TIPSPEED_CMD_PLANT_PLANT_H

#include "cmd/ask/question.h"
#include "cmd/session/session.h"
#include "core/answer/circuit.h"
#include "core/answer/crusher.h"
#include "core/answer/power.h"

/* A circuit with its prices and its power, and what its crushers are computed
 * from.  question: borrowed.  back: the fractions that return to the crusher,
 * as typed; NULL for a circuit from a file.  priced: there are prices; kwh:
 * price per kWh, 0 if not given.  of_cuts: the power readings are from belt
 * cuts.  size, feed [n]: the size classes, and the masses of the new feed in
 * them.  own [n_unit]: models of the crushers with a speed of their own, else
 * NULL.  bypass: the fitted share that bypasses the rotor. */
struct plant {
	struct session *s;
	const struct question *question;
	struct circuit *circuit;
	char *back;
	bool from_file, priced, of_cuts;
	double kwh;
	size_t n, n_reading;
	double *size, *feed;
	struct reading *reading;
	struct crusher *crusher;
	struct transfer **own;
	struct power power;
	double bypass;
};

/* Reads the options and the file of the call.  If that fails, there is nothing
 * to free. */
bool plant_from_args(struct session *s, const struct args *args,
    const struct question *q, struct plant *plant, struct error *error);
void plant_free(struct plant *plant);

/* Results at a speed, m/s: the flow; power, kW, and earnings per hour, on
 * average and in each draw. */
struct plant_result {
	double speed;
	struct flow flow;
	double kw, money, kw_draw[POSTERIOR_DRAWS], money_draw[POSTERIOR_DRAWS];
};

/* plant_share_through_rotor returns the share of a crusher's feed that goes
 * through the rotor; plant_speed_of_circuit_unit its own speed or else `speed`.
 */
double plant_share_through_rotor(
    const struct plant *p, const struct unit *unit);
double plant_speed_of_circuit_unit(const struct unit *unit, double speed);

/* Returns "62, 74", the speeds of the crushers, if each has one of its own, so
 * that the command's speed changes nothing; else NULL.  The caller frees it.
 * *first, unless NULL, is then the first of them. */
char *plant_fixed_speeds_text(const struct plant *p, double *first);

/* Returns the outcome at a speed; free its flow with flow_free. */
struct plant_result plant_compute_flow_at_speed(
    const struct plant *p, double speed);

/* A row of the table: the product that leaves at a unit, or a stream that
 * returns to a crusher (unit NULL). */
struct plant_stream_row {
	const char *name;
	const struct unit *unit;
	size_t stream;
};

/* Lists products and returned streams in line [n_stream + n_unit], from fine to
 * coarse or, for a circuit from a file, in the order of the file.  Returns
 * their number. */
size_t plant_list_streams(const struct plant *p, const struct plant_result *o,
    struct plant_stream_row *line);

/* Sets the error for a flow without a steady state.  Returns false. */
bool plant_set_error_not_steady(
    const struct plant *p, const struct plant_result *o, struct error *error);

/* Returns the power of the empty crusher at a speed, kW, estimated from the
 * readings, and sets range to its band. */
double plant_idle_power(
    const struct plant *p, double speed, double range[static 2]);

/* Returns a text on what the estimate of power is based on.  The caller frees
 * it. */
char *plant_power_basis_text(
    const struct plant *p, const struct plant_result *o);

#endif
