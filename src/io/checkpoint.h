/* Checkpoints: a calibration between two steps, as text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CHECKPOINT_H
#define TIPSPEED_IO_CHECKPOINT_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/calibrate.h"

/* What a checkpoint belongs to: it is refused for any other.  options: one line
 * of text that tells two sets of options apart. */
struct checkpoint_of {
	uint64_t site_digest;
	const char *options;
};

/* Writes it, exact doubles as %a, whole or not at all (file.h). */
bool checkpoint_save(const char *path, const struct checkpoint_of *of,
    struct calibration *c, struct error *error);

/* Restores c, which was made with the same site and options.  False, with the
 * reason, when the file is of another site, of other options, damaged or cut
 * off; c is then not to be used. */
bool checkpoint_load(const char *path, const struct checkpoint_of *of,
    struct calibration *c, struct error *error);

#endif
