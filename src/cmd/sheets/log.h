/* The plant log of a session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_LOG_H
#define TIPSPEED_CMD_SHEETS_LOG_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "io/formats/plant_log.h"

/* Runs load FILE.. as=log: loads the log used to look up cuts. */
bool log_load(struct session *s, const struct args *args, struct error *error);

/* Looks up values in the log at a time, or within a number of seconds of it:
 * the tip speed, m/s, to a tenth, for the rotor's diameter, m (0: not known);
 * kW and t/h, NAN if the log has none.  Notes how they were found. */
struct logged {
	double speed, power, rate;
};
bool log_find_speed_at(struct session *s, double time, double within,
    double rotor, struct logged *found, struct error *error);

#endif
