/* The kernel and the breeding for avx512; on other processors, where nobody
 * calls them, as in isa_base.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/breed.h"
#include "core/plan.h"

#if defined __x86_64__
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw,prefer-vector-width=512")
#define LANES 8
#else
#define LANES 2
#endif
#define KERNEL_NAME kernel_block_avx512
#define BREED_NAME breed_block_avx512
#define BINS_NAME kernel_bins_avx512
#include "core/kernel_body.h"
#include "core/breed_body.h"
