/* Commands that draw.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PICTURES_H
#define TIPSPEED_CMD_PICTURES_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/plots.h"
#include "cmd/session.h"

/* What the call asks for: its kind and the options that plot and describe have
 * in common. */
bool pictures_request(
    const struct args *args, struct plot_request *request, struct error *error);

/* A report headed as the chart is. */
struct report *pictures_report(
    const struct session *s, const char *command, const struct chart *chart);

#endif
