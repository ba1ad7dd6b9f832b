/* The kernel and the breeding for avx2.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/breed.h"
#include "core/plan.h"

#if defined __x86_64__
#pragma GCC target("avx2")
#define LANES 4
#define KERNEL_NAME kernel_block_avx2
#define BREED_NAME breed_block_avx2
#define BINS_NAME kernel_bins_avx2
#include "core/kernel_body.h"
#include "core/breed_body.h"
#else
void
kernel_block_avx2(const struct plan *plan,
    const double *const theta[PARAM_COUNT], const uint32_t *index, bool calm,
    double *scratch, double *misfit)
{
	kernel_block_base(plan, theta, index, calm, scratch, misfit);
}

void
breed_block_avx2(const struct breed *b, size_t first)
{
	breed_block_base(b, first);
}

void
kernel_bins_avx2(const struct plan *plan,
    const double *const theta[PARAM_COUNT], size_t first, uint16_t *bin)
{
	kernel_bins_base(plan, theta, first, bin);
}
#endif
