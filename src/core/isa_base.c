/* The code for any processor: kernel, breeding and covariances.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define LANES 2
#define ISA base
#define BREED_NAME breed_block_base
#define TRIANGLE_NAME TRIANGLE_BASE
#include "core/search/kernel_body.h"
/* In this order, because the models need the kernel. */
#include "core/model/breakage_all.h"
#include "core/search/ga_operators_body.h"
#include "core/posterior/triangle_body.h"
