/* The models' parts of the search, for one instruction set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/breakage_grunditz.c"

#include "core/breakage_energy.c"
#include "core/breakage_t10.c"
#include "core/breakage_vogel.c"
