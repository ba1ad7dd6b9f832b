/* Allocation that never returns NULL: running out of memory ends the program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_XALLOC_H
#define TIPSPEED_BASE_XALLOC_H

#include <stdarg.h>
#include <stddef.h>

#define ARRAY_LEN(a) (sizeof(a) / sizeof((a)[0]))

/* The exit status when memory runs out: ERROR_SYSTEM. */
enum { XALLOC_STATUS = 5 };

/* xcalloc returns zeroed memory for n objects of the given size.  None of these
 * functions returns NULL: on failure the program ends.  Free results with
 * free(). */
void *xcalloc(size_t n, size_t size);
void *xrealloc(void *p, size_t n, size_t size);

/* Returns p with room for one more object after its n.  p must be NULL at first
 * and be enlarged by this function alone, which doubles it at powers of two. */
void *xgrow_by_one(void *p, size_t n, size_t size);
char *xstrdup(const char *s);
char *xstrndup(const char *s, size_t n);
char *xasprintf(const char *format, ...) __attribute__((format(printf, 1, 2)));
char *xvasprintf(const char *format, va_list ap)
    __attribute__((format(printf, 1, 0)));

/* Put before a declaration of pointers, each NULL or from one of these
 * functions, to free them at the end of their block, after a return value has
 * been computed. */
#define FREED __attribute__((cleanup(xfree_at)))
void xfree_at(void *pointer);

/* Frees *text and replaces it with value, whose ownership it takes. */
void xfree_and_set(char **text, char *value);

/* Append to a text that one of the functions above returned.  xappend_to_list
 * adds the separator first if the list is not empty.  xend_list_with puts a
 * word such as " and " in place of the last comma. */
void xappend(char **text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void xappend_to_list(char **list, const char *separator, const char *format,
    ...) __attribute__((format(printf, 3, 4)));
void xend_list_with(char **list, const char *word);

/* Returns zeroed doubles at an address that is a multiple of 64 bytes, for the
 * kernels. */
double *xcalloc_doubles(size_t n);

/* Ends the program because memory has run out.  Also called if a library
 * reports this. */
_Noreturn void xalloc_fail(void);

#endif
