/* Candidates side by side in one vector register: LANES of them, which the file
 * of each instruction set defines.  The compiler's vector extension lives here
 * and in kernel_body.h only.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_LANES_H
#define TIPSPEED_CORE_LANES_H

#include <stddef.h>
#include <stdint.h>

#include "core/elementary.h"

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
lanes_of(double x)
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

/* max(a, 0) */
static inline lanes
lanes_positive(lanes a)
{
	return (lanes)((a > 0.0) & (lanes_mask)a);
}

static inline lanes
lanes_select(lanes_mask mask, lanes a, lanes b)
{
	return (lanes)((mask & (lanes_mask)a) | (~mask & (lanes_mask)b));
}

static inline lanes
lanes_max(lanes a, lanes b)
{
	return lanes_select(a > b, a, b);
}

static inline lanes
lanes_min(lanes a, lanes b)
{
	return lanes_select(a < b, a, b);
}

static inline lanes
lanes_exp(lanes a)
{
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = el_exp(a[l]);
	return r;
}

static inline lanes
lanes_log(lanes a)
{
	lanes r = {0};
	for (size_t l = 0; l < LANES; l++)
		r[l] = el_log(a[l]);
	return r;
}

/* True when the condition holds in every lane, in any lane. */
static inline int
lanes_all(lanes_mask mask)
{
	int64_t all = -1;
	for (size_t l = 0; l < LANES; l++)
		all &= mask[l];
	return all != 0;
}

static inline int
lanes_any(lanes_mask mask)
{
	int64_t any = 0;
	for (size_t l = 0; l < LANES; l++)
		any |= mask[l];
	return any != 0;
}

#endif
