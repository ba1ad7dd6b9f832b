/* Reads a circuit, see tipspeed-circuit(5).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_CIRCUIT_FILE_H
#define TIPSPEED_IO_FORMATS_CIRCUIT_FILE_H

#include "base/error.h"
#include "core/answer/circuit.h"

/* Reads a circuit.  Every stream must have one source and one destination,
 * every unit must be fed, and all material must be able to reach a stockpile.
 * tph is 0 if the file does not state it.  On failure, returns NULL and adds
 * all faults of the file, each with line and column, to errors, which the
 * caller has zeroed. */
struct circuit *circuit_file_read(const char *path, struct error_list *errors);

#endif
