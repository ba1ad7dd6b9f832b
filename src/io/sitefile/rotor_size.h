/* Rotor diameters in titles and remarks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_ROTOR_SIZE_H
#define TIPSPEED_IO_SITEFILE_ROTOR_SIZE_H

#include <stdbool.h>

/* Returns the rotor diameter, mm, that a text states, as in "VSI, rotor 840 mm,
 * 1560 rpm", "rotor diameter 0.84 m" or "VSI, \u00D8 840".  Returns 0 if it
 * states none, and -1 if it states several that differ.  machine: the text is
 * the name of a machine, in which the number after "rotor" needs no unit: below
 * 10 it is in m. */
double rotor_diameter_mm_in_text(const char *text, bool machine);

#endif
