/* The kernel and the breeding for AVX2, compiled with flags for this file only.
 * On other architectures they equal those of isa_base.c and are never called.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifdef __AVX2__
#define LANES 4
#else
#define LANES 2
#endif
#define ISA avx2
#define BREED_NAME breed_block_avx2
#define TRIANGLE_NAME TRIANGLE_AVX2
#include "core/search/kernel_body.h"
/* Its own order: the models need the kernel. */
#include "core/model/breakage_all.h"
#include "core/search/ga_operators_body.h"
#include "core/posterior/triangle_body.h"
