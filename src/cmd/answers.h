/* Commands that answer: predict, sweep, validate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_H
#define TIPSPEED_CMD_ANSWERS_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"
#include "core/predict.h"

bool cmd_predict(struct session *, const struct args *, struct error *);
bool cmd_sweep(struct session *, const struct args *, struct error *);
bool cmd_validate(struct session *, const struct args *, struct error *);

/* False, with the next step, where the site has no parameters yet, or the
 * settings do not go together. */
bool answers_ready(struct session *s, struct error *error);

/* The run whose feed to take: at the speed the option names, else the run
 * nearest to the speed given. */
bool answers_feed(const struct site *site, const struct value *feed,
    double speed, size_t *run, struct error *error);

/* Says where parameters are from that were recalled. */
void answers_note_recalled(struct report *r, const struct entry *entry);

/* The JSON object of predict, see tipspeed(1), OUTPUT. */
json_t *answers_prediction_json(struct session *s, const struct prediction *p);

#endif
