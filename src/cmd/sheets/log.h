/* The plant log of a session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_LOG_H
#define TIPSPEED_CMD_SHEETS_LOG_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "io/formats/plant_log.h"

/* Runs load FILE.. as=log: loads the log in which add looks up cuts. */
bool log_load_plant_log(
    struct session *s, const struct args *args, struct error *error);

/* Finds the medians of the log's rows within so many seconds of a time: the tip
 * speed, m/s, to a tenth; kW and t/h, or NAN if the log has none.  rotor:
 * diameter, m, to convert rpm; 0: not known.  Notes how they were found. */
struct logged {
	double speed, power, rate;
};
bool log_find_speed_at_time(struct session *s, double time, double within,
    double rotor, struct logged *found, struct error *error);

#endif
