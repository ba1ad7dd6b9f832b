/* Threads that share pieces of work.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_POOL_H
#define TIPSPEED_BASE_POOL_H

#include <stddef.h>

/* A few threads that sleep until there is work.  Each idle thread, and the
 * caller, takes the next piece, and the caller waits only for pieces that have
 * begun.  So on a busy machine a thread that gets no processor does not delay
 * the others. */
struct pool;

/* Starts threads - 1 threads; threads >= 1 includes the caller.  If a thread
 * cannot be started, the pool has only the threads before it. */
struct pool *pool_new(unsigned threads);
void pool_free(struct pool *pool);

/* Returns the number of threads including the caller; 1 for NULL. */
unsigned pool_count_threads(const struct pool *pool);

/* Calls run(data, piece, thread) for each piece from 0 to n-1, n < 2^32 - 1,
 * once each and in any order; thread is less than pool_count_threads and unique
 * among concurrent pieces.  Returns when all pieces are done.  pool NULL: runs
 * them one after the other. */
void pool_run(struct pool *pool, size_t n,
    void (*run)(void *data, size_t piece, unsigned thread), void *data);

#endif
