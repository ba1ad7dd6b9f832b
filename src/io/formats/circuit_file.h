/* Reads a circuit, see tipspeed-circuit(5).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_CIRCUIT_FILE_H
#define TIPSPEED_IO_FORMATS_CIRCUIT_FILE_H

#include "base/error.h"
#include "core/answer/circuit.h"
#include "core/psd/site.h"

/* Reads a circuit in which every stream has one source and one destination,
 * every unit is fed, and all material can reach a stockpile.  tph is 0 if the
 * file does not state it.  Speeds in rpm are those of the site's rotor; site
 * may be NULL.  On failure, returns NULL and all faults of the file, each with
 * line and column, in errors, zeroed by the caller. */
struct circuit *circuit_file_read(
    const char *path, const struct site *site, struct error_list *errors);

#endif
