/* Every generation of a calibration as CSV, for log=FILE.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LOG_H
#define TIPSPEED_CMD_LOG_H

#include <stdbool.h>

#include "cmd/session.h"
#include "core/calibrate.h"

/* Kept in memory until log_save: the file of the search before stays until
 * there is a new one. */
struct log *log_new(const char *path);
void log_free(struct log *log);

void log_add(
    struct log *log, const char *key, const struct calibration *calibration);

bool log_save(struct session *s, struct log *log, struct error *error);

#endif
