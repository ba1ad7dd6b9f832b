/* Asks the processor which instruction sets it has.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/numeric/isa.h"

#include <assert.h>
#include <string.h>

static enum isa
detect_best_isa(void)
{
#if defined __x86_64__
	if (__builtin_cpu_supports("avx512f") &&
	    __builtin_cpu_supports("avx512dq") &&
	    __builtin_cpu_supports("avx512vl") &&
	    __builtin_cpu_supports("avx512bw"))
		return ISA_AVX512;
	if (__builtin_cpu_supports("avx2"))
		return ISA_AVX2;
#endif
	return ISA_BASE;
}

enum isa
isa_usable_or_best(enum isa wanted)
{
	enum isa most = detect_best_isa();
	return wanted < most ? wanted : most;
}

const char *
isa_name(enum isa isa)
{
	static const char *const NAMES[] = {"baseline", "avx2", "avx512"};
	assert(isa < ISA_BEST);
	return NAMES[isa];
}

enum isa
isa_from_name(const char *name)
{
	enum isa isa = name != NULL ? ISA_BASE : ISA_BEST;
	while (isa < ISA_BEST && strcmp(name, isa_name(isa)) != 0)
		isa++;
	return isa;
}
