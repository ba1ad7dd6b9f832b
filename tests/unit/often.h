/* How often a test repeats what it tries.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_OFTEN_H
#define TIPSPEED_TESTS_OFTEN_H

#include <stddef.h>
#include <stdlib.h>

/* `few` times in `make check`, `many` in `make check-long`: TIPSPEED_TEST_LONG says
 * how far between, 0 (or unset) to 1, as it does in tests/tap.sh. */
static inline size_t
often(size_t few, size_t many)
{
	const char *text = getenv("TIPSPEED_TEST_LONG");
	double share = text != NULL ? strtod(text, NULL) : 0;
	if (!(share > 0))
		return few;
	share = share < 1 ? share : 1;
	return (size_t)((1 - share) * (double)few + share * (double)many);
}

#endif
