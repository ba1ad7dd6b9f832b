/* The paper's model, for tests that know its parameters by their places.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_PAPER_H
#define TIPSPEED_TESTS_PAPER_H

#include "core/model/breakage.h"

enum { PARAM_COUNT = 7, PARAM_F_MAT = 4, PARAM_E0_MIN = 5, PARAM_ALPHA = 6 };

#define PARAMS (BREAKAGES[0]->parameter)

#endif
