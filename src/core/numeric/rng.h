/* Random numbers as a pure function of seed and place of use.
 *
 * Nothing is carried from one number to the next, so the same seed gives the
 * same numbers with any number of threads and in any order of evaluation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_NUMERIC_RNG_H
#define TIPSPEED_CORE_NUMERIC_RNG_H

#include <stdint.h>

/* Two words that identify one stream of numbers. */
struct rng_key {
	uint32_t a, b;
};

/* The mixer of splitmix64 (Steele, Lea, Flood 2014): every bit of z affects
 * every bit of the result. */
static inline uint64_t
rng_mix_bits(uint64_t z)
{
	z += UINT64_C(0x9e3779b97f4a7c15);
	z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
	z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
	return z ^ (z >> 31);
}

/* Returns the stream for a seed, a generation and a use within the
 * generation. */
static inline struct rng_key
rng_make_key(uint64_t seed, uint64_t generation, uint64_t use)
{
	uint64_t z =
	    rng_mix_bits(rng_mix_bits(rng_mix_bits(seed) ^ generation) ^ use);
	return (struct rng_key){(uint32_t)z, (uint32_t)(z >> 32)};
}

/* Returns number i of a stream: 32 bits, from a multiply-xorshift hash of i
 * that uses the key twice.  All operations are on 32 bits, which every vector
 * unit supports. */
static inline uint32_t
rng_random_bits(struct rng_key key, uint32_t i)
{
	uint32_t x = i * UINT32_C(0x9e3779b9) + key.a;
	x ^= x >> 16;
	x *= UINT32_C(0x7feb352d);
	x ^= x >> 15;
	x += key.b;
	x *= UINT32_C(0x846ca68b);
	x ^= x >> 16;
	x *= UINT32_C(0xc2b2ae35);
	x ^= x >> 15;
	return x;
}

/* Returns a second random number, made from the bits of a first. */
static inline uint32_t
rng_rehash_bits(uint32_t x)
{
	x *= UINT32_C(0x9e3779b1);
	x ^= x >> 15;
	return x * UINT32_C(0x85ebca77);
}

/* Returns 32 bits as a number in (0, 1). */
static inline double
rng_bits_to_unit(uint32_t bits)
{
	/* Vector units have only the signed conversion. */
	double centred = (double)(int32_t)(bits ^ 0x80000000u);
	return (centred + 2147483648.5) * (1.0 / 4294967296.0);
}

/* Returns number i of a stream, uniform in (0, 1). */
static inline double
rng_uniform(struct rng_key key, uint32_t i)
{
	return rng_bits_to_unit(rng_random_bits(key, i));
}

/* Returns standard normal number i of a stream: the sum of twelve uniform
 * numbers, minus six.  The tails end at -6 and 6 and the kurtosis is 2.9, but
 * it needs no function whose last bit differs between machines. */
static inline double
rng_normal(struct rng_key key, uint32_t i)
{
	double sum = 0;
	for (uint32_t j = 0; j < 12; j++)
		sum += rng_uniform(key, 12 * i + j);
	return sum - 6;
}

#endif
