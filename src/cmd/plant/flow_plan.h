/* What flow is asked, as a circuit with its prices and its power.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLANT_FLOW_PLAN_H
#define TIPSPEED_CMD_PLANT_FLOW_PLAN_H

#include "cmd/ask/question.h"
#include "cmd/session/session.h"
#include "core/answer/circuit.h"
#include "core/answer/power.h"

/* question: borrowed.  size [n]: the classes.  back: what
 * goes back to the crusher, in words; NULL of a circuit of a file.  priced:
 * there are prices; kwh: of a kWh, 0 where it has none. */
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

#endif
