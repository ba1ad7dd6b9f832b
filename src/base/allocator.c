/* Replaces malloc and related functions for the whole process.
 *
 * Libraries call them too, and cannot be relied on when memory runs out: GSL
 * and font loaders write through NULL, jansson omits a key, and getline reports
 * the end of the file.  So these functions never return NULL: the program ends,
 * as with its own allocations (xalloc.h).  The memory comes from the C library,
 * or from an allocator that was loaded before it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* RTLD_NEXT */
#include <dlfcn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

/* Sanitizers have their own allocator, which also ends the program. */
#ifndef __has_feature
#define __has_feature(x) 0
#endif
#if !defined(__SANITIZE_ADDRESS__) && !__has_feature(address_sanitizer)
#define PUBLIC __attribute__((visibility("default")))

/* Sets a pointer to a function.  ISO C cannot cast an object pointer to one. */
static void
look_up_libc_function(void *function, const char *name)
{
	void *found = dlsym(RTLD_NEXT, name);
	memcpy(function, &found, sizeof found);
}

PUBLIC void *
malloc(size_t n)
{
	static void *(*next)(size_t);
	if (next == NULL)
		look_up_libc_function(&next, "malloc");
	void *p = next(n);
	if (p == NULL)
		xalloc_fail();
	return p;
}

PUBLIC void *
calloc(size_t n, size_t size)
{
	static void *(*next)(size_t, size_t);
	static bool finding;
	/* The dlsym of older C libraries calls calloc, and copes with NULL. */
	if (finding)
		return NULL;
	if (next == NULL) {
		finding = true;
		look_up_libc_function(&next, "calloc");
		finding = false;
	}
	void *p = next(n, size);
	if (p == NULL)
		xalloc_fail();
	return p;
}

PUBLIC void *
realloc(void *p, size_t n)
{
	static void *(*next)(void *, size_t);
	if (next == NULL)
		look_up_libc_function(&next, "realloc");
	void *q = next(p, n);
	/* realloc to 0 bytes frees. */
	if (q == NULL && n > 0)
		xalloc_fail();
	return q;
}

/* musl's aligned_alloc returns NULL if malloc is replaced but aligned_alloc is
 * not. */
PUBLIC void *
aligned_alloc(size_t line, size_t n)
{
	static void *(*next)(size_t, size_t);
	if (next == NULL)
		look_up_libc_function(&next, "aligned_alloc");
	void *p = next(line, n);
	if (p == NULL)
		xalloc_fail();
	return p;
}
#endif
