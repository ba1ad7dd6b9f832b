/* Includes the models' parts of the kernel, for one instruction set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/breakage_grunditz.c"

#include "core/model/breakage_energy.c"
#include "core/model/breakage_t10.c"
#include "core/model/breakage_vogel.c"
