/* exp, log and sums of products that give the same bits on every machine; exp
 * and log also give the same bits in every lane.
 *
 * The C library's functions differ in the last bit between processors (it picks
 * a variant with fused multiply-add where there is one), and a genetic
 * algorithm turns one different bit into a different search.  These functions
 * are plain double arithmetic without branches, so gcc can vectorise a loop
 * over lanes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_NUMERIC_ELEMENTARY_H
#define TIPSPEED_CORE_NUMERIC_ELEMENTARY_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline double
el_double_from_bits(uint64_t bits)
{
	double d;
	memcpy(&d, &bits, sizeof d);
	return d;
}

static inline uint64_t
el_bits_of_double(double d)
{
	uint64_t bits;
	memcpy(&bits, &d, sizeof bits);
	return bits;
}

/* Returns e^r - 1 and sets scale to a power of two such that exp(x) = scale *
 * (1 + result).  x is first clamped to -708..708; NaN gives the value at one
 * end, so callers must test for NaN themselves.
 * Method: x = n ln 2 + r, |r| <= ln 2 / 2 (Cody and Waite); a polynomial
 * through the Chebyshev points, within 1e-17 of e^r. */
static inline double
el_expm1_and_scale(double x, double *scale)
{
	const double round = 6755399441055744.0; /* 1.5 * 2^52 */
	x = x > -708.0 ? x : -708.0;
	x = x < 708.0 ? x : 708.0;
	double shifted = x * 1.4426950408889634074 + round;
	double n = shifted - round;
	double r = x - n * 6.93147180369123816490e-01;
	r = r - n * 1.90821492927058770002e-10;
	/* (e^r - 1 - r) / r^2, in pairs so that few terms wait for others. */
	double r2 = r * r, r4 = r2 * r2;
	double low = (0.5 + 0.16666666666666669 * r) +
		     (0.04166666666662399 + 0.008333333333330051 * r) * r2;
	double high = (0.0013888888917281794 + 0.00019841269863105968 * r) +
		      (2.480152119021773e-05 + 2.7557268378684192e-06 * r) * r2;
	double top = 2.7620138719733994e-07 + 2.5100424157005067e-08 * r;
	double q = (low + high * r4) + top * (r4 * r4);
	/* The low bits of shifted hold n; in the exponent they give 2^n. */
	*scale = el_double_from_bits((el_bits_of_double(shifted) + 1023) << 52);
	return q * r2 + r;
}

/* Returns exp(x) to about 1 ulp, with x clamped to -708..708. */
static inline double
el_exp(double x)
{
	double scale, p = el_expm1_and_scale(x, &scale);
	return scale * p + scale;
}

/* Returns exp(x) - 1 without loss of precision near 0. */
static inline double
el_expm1(double x)
{
	double scale, p = el_expm1_and_scale(x, &scale);
	return scale * p + (scale - 1.0);
}

/* Returns ln(x) to about 2 ulp for normal x > 0.
 * Method: x = 2^k m, m in [sqrt(1/2), sqrt(2)), ln m by the odd series in z =
 * (m - 1) / (m + 1). */
static inline double
el_log(double x)
{
	const double magic = 6755399441055744.0;
	uint64_t bits = el_bits_of_double(x);
	uint64_t over = (bits - UINT64_C(0x3fe6a09e667f3bcd)) >> 52;
	/* over is the exponent k modulo 2^12, as an unsigned number. */
	uint64_t k = (over ^ 0x800) - 0x800;
	double m = el_double_from_bits(bits - (k << 52));
	double kd = el_double_from_bits((k + el_bits_of_double(magic))) - magic;
	double f = m - 1.0;
	double z = f / (2.0 + f);
	double w = z * z;
	double p = 1.0 / 21.0;
	p = p * w + 1.0 / 19.0;
	p = p * w + 1.0 / 17.0;
	p = p * w + 1.0 / 15.0;
	p = p * w + 1.0 / 13.0;
	p = p * w + 1.0 / 11.0;
	p = p * w + 1.0 / 9.0;
	p = p * w + 1.0 / 7.0;
	p = p * w + 1.0 / 5.0;
	p = p * w + 1.0 / 3.0;
	double ln_m = 2.0 * z + 2.0 * z * (w * p);
	return kd * 6.93147180369123816490e-01 +
	       (ln_m + kd * 1.90821492927058770002e-10);
}

/* Returns x^a for normal x > 0. */
static inline double
el_pow(double x, double a)
{
	return el_exp(a * el_log(x));
}

/* Returns the sum of a[i] b[i], added in order. */
static inline double
el_dot(const double *a, const double *b, size_t n)
{
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += a[i] * b[i];
	return sum;
}

#endif
