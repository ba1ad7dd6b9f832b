/* Instruction sets for which some code is compiled separately.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_NUMERIC_ISA_H
#define TIPSPEED_CORE_NUMERIC_ISA_H

/* In rising order; ISA_BEST means the best one that the processor has. */
enum isa { ISA_BASE, ISA_AVX2, ISA_AVX512, ISA_BEST };

/* Returns `wanted` or, if the processor lacks that set, the best one that it
 * has. */
enum isa isa_usable_or_best(enum isa wanted);

/* Returns "baseline", "avx2" or "avx512". */
const char *isa_name(enum isa isa);

/* Returns the set with that name; ISA_BEST for NULL and for unknown names. */
enum isa isa_from_name(const char *name);

#endif
