/* The kernel for any processor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define LANES 2
#define KERNEL_NAME kernel_block_base
#include "core/kernel_body.h"
