/* LANES candidates side by side in one vector register.  The file for each
 * instruction set defines LANES.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_LANES_H
#define TIPSPEED_CORE_SEARCH_LANES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "core/numeric/elementary.h"

typedef double lanes __attribute__((vector_size(8 * LANES)));
typedef int64_t lanes_mask __attribute__((vector_size(8 * LANES)));

static inline lanes
lanes_load(const double *from)
{
	lanes v = {0};
	memcpy(&v, from, sizeof v);
	return v;
}

static inline lanes
lanes_broadcast(double x)
{
	return (lanes){0} + x;
}

static inline lanes
lanes_gather(const double *from, const uint32_t *index)
{
	lanes v = {0};
	for (size_t l = 0; l < LANES; l++)
		v[l] = from[index[l]];
	return v;
}

static inline lanes
lanes_select(lanes_mask mask, lanes a, lanes b)
{
	return (lanes)((mask & (lanes_mask)a) | (~mask & (lanes_mask)b));
}

/* Returns the larger value of each lane, or b's if a's is NaN.  Uses the
 * processor's instruction, because gcc only sometimes generates it from the
 * plain loop. */
static inline lanes
lanes_max(lanes a, lanes b)
{
#if LANES == 8
	return (lanes)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif LANES == 4
	return (lanes)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined __SSE2__
	return (lanes)_mm_max_pd((__m128d)a, (__m128d)b);
#else
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = a[l] > b[l] ? a[l] : b[l];
	return r;
#endif
}

/* As lanes_max, but returns the smaller value. */
static inline lanes
lanes_min(lanes a, lanes b)
{
#if LANES == 8
	return (lanes)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif LANES == 4
	return (lanes)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined __SSE2__
	return (lanes)_mm_min_pd((__m128d)a, (__m128d)b);
#else
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = a[l] < b[l] ? a[l] : b[l];
	return r;
#endif
}

static inline lanes
lanes_exp(lanes a)
{
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = el_exp(a[l]);
	return r;
}

/* Returns exp(x) to 2e-10 for x up to 708: el_expm1_and_scale with fewer terms
 * and ln 2 in one piece. */
static inline lanes
lanes_exp_quick(lanes x)
{
	const double round = 6755399441056767.0; /* 1.5 * 2^52 + 1023 */
	x = lanes_max(x, lanes_broadcast(-708));
	lanes shifted = x * 1.4426950408889634074 + round;
	lanes r = x - (shifted - round) * 0.69314718055994530942;
	lanes r2 = r * r;
	lanes low = 0.5000000013457727 + 0.16666666681614198 * r;
	lanes middle = 0.0416664650060376 + 0.00833331093446465 * r;
	lanes high = 0.0013933641032215737 + 0.00019890980860877146 * r;
	lanes q = low + r2 * (middle + r2 * high);
	return (lanes)((lanes_mask)shifted << 52) * (1 + (r + r2 * q));
}

static inline lanes
lanes_log(lanes a)
{
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = el_log(a[l]);
	return r;
}

/* Returns a bit for each lane in which the condition holds. */
static inline unsigned
lanes_mask_bits(lanes_mask mask)
{
#if LANES == 8
	return (unsigned)_mm512_movepi64_mask((__m512i)mask);
#elif LANES == 4
	return (unsigned)_mm256_movemask_pd((__m256d)mask);
#else
	unsigned bits = 0;
	for (unsigned l = 0; l < LANES; l++)
		bits |= (unsigned)(mask[l] != 0) << l;
	return bits;
#endif
}

static inline bool
lanes_all(lanes_mask mask)
{
	return lanes_mask_bits(mask) == (1u << LANES) - 1;
}

static inline bool
lanes_any(lanes_mask mask)
{
	return lanes_mask_bits(mask) != 0;
}

#endif
