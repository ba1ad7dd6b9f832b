/* What libFuzzer calls: the reader that TIPSPEED_FUZZ names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_errno.h>
#include <stdlib.h>

#include "readers.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
	static const struct reader *reader;
	if (reader == NULL) {
		const char *name = getenv("TIPSPEED_FUZZ");
		reader = reader_find(name != NULL ? name : "");
		if (reader == NULL)
			abort();
		gsl_set_error_handler_off();
	}
	reader_feed(reader, bytes, n);
	return 0;
}
