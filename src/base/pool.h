/* Threads that share out pieces of work.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_POOL_H
#define TIPSPEED_BASE_POOL_H

#include <stddef.h>

/* A few threads that sleep until there is work.  A free thread takes the next
 * piece, the caller too, and the caller waits only for pieces that were taken:
 * on a busy machine a thread that gets no processor delays no other. */
struct pool;

/* threads >= 1, the caller among them.  Where a thread cannot be started there
 * is one less. */
struct pool *pool_new(unsigned threads);
void pool_free(struct pool *pool);

/* Threads there are, the caller among them; 1 for NULL. */
unsigned pool_threads(const struct pool *pool);

/* Calls run(data, piece, thread) for each piece from 0 to n-1, n < 2^32 - 1,
 * each once and in any order; thread is below pool_threads and never in use
 * twice at a time.  Returns when all are done.  pool NULL: one after the
 * other. */
void pool_run(struct pool *pool, size_t n,
    void (*run)(void *data, size_t piece, unsigned thread), void *data);

#endif
