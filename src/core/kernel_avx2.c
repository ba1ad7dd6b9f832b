/* The kernel for avx2.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/plan.h"

#if defined __x86_64__
#pragma GCC target("avx2")
#define LANES 4
#define KERNEL_NAME kernel_block_avx2
#include "core/kernel_body.h"
#else
void
kernel_block_avx2(const struct plan *plan,
    const double *const theta[PARAM_COUNT], size_t offset, double *scratch,
    double *misfit)
{
	kernel_block_base(plan, theta, index, scratch, misfit);
}
#endif
