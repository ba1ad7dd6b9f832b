/* The code for AVX-512: kernel, breeding and covariances, compiled with flags
 * for this file alone.  On other architectures it is the same as in isa_base.c
 * and is never called.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifdef __AVX512F__
#define LANES 8
#else
#define LANES 2
#endif
#define ISA avx512
#define BREED_NAME breed_block_avx512
#define TRIANGLE_NAME TRIANGLE_AVX512
#include "core/search/kernel_body.h"
/* In this order, because the models need the kernel. */
#include "core/model/breakage_all.h"
#include "core/search/ga_operators_body.h"
#include "core/posterior/triangle_body.h"
