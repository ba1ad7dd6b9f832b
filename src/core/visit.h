/* A walk through an object's state by name, to save it or to restore it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_VISIT_H
#define TIPSPEED_CORE_VISIT_H

#include <stdbool.h>
#include <stddef.h>

/* real and whole are called for n values each, always in the same order: one
 * that saves reads them, one that restores writes them. False ends the walk. */
struct visit {
	void *data;
	bool (*real)(void *data, const char *name, double *value, size_t n);
	bool (*whole)(void *data, const char *name, size_t *value, size_t n);
};

#endif
