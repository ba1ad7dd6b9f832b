/* Preloaded: the allocation number $FAULT fails as if there were no memory.
 * Writes how many there were into the file $FAULT_COUNT when the program ends
 * by itself.  All of the process counts, from its first on.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* RTLD_NEXT */
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static atomic_long count;

/* Shells that the program starts are none of our business. */
__attribute__((constructor)) static void
begin(void)
{
	unsetenv("LD_PRELOAD");
}

__attribute__((destructor)) static void
end(void)
{
	long n = atomic_load(&count);
	const char *path = getenv("FAULT_COUNT");
	FILE *out = path != NULL ? fopen(path, "w") : NULL;
	if (out == NULL)
		return;
	fprintf(out, "%ld\n", n);
	fclose(out);
}

/* Counts one, and says whether it is to fail. */
static bool
fails(void)
{
	static long at = -1;
	if (at < 0) {
		const char *number = getenv("FAULT");
		at = number != NULL ? strtol(number, NULL, 10) : 0;
	}
	if (atomic_fetch_add(&count, 1) + 1 != at)
		return false;
	errno = ENOMEM;
	return true;
}

static void
find(void *function, const char *name)
{
	void *found = dlsym(RTLD_NEXT, name);
	memcpy(function, &found, sizeof found);
}

void *
malloc(size_t n)
{
	static void *(*next)(size_t);
	if (next == NULL)
		find(&next, "malloc");
	return fails() ? NULL : next(n);
}

void *
calloc(size_t n, size_t size)
{
	static void *(*next)(size_t, size_t);
	static bool finding;
	/* The dlsym of older C libraries calls calloc, and can do without. */
	if (finding)
		return NULL;
	if (next == NULL) {
		finding = true;
		find(&next, "calloc");
		finding = false;
	}
	return fails() ? NULL : next(n, size);
}

void *
realloc(void *p, size_t n)
{
	static void *(*next)(void *, size_t);
	if (next == NULL)
		find(&next, "realloc");
	return n > 0 && fails() ? NULL : next(p, n);
}

void *
aligned_alloc(size_t alignment, size_t n)
{
	static void *(*next)(size_t, size_t);
	if (next == NULL)
		find(&next, "aligned_alloc");
	return fails() ? NULL : next(alignment, n);
}

int
posix_memalign(void **p, size_t alignment, size_t n)
{
	static int (*next)(void **, size_t, size_t);
	if (next == NULL)
		find(&next, "posix_memalign");
	return fails() ? ENOMEM : next(p, alignment, n);
}
