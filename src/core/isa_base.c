/* The kernel and the breeding for any processor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define LANES 2
#define KERNEL_NAME kernel_block_base
#define BREED_NAME breed_block_base
#define BINS_NAME kernel_bins_base
#include "core/kernel_body.h"
#include "core/breed_body.h"
