/* Shares work by one atomic ticket.
 *
 * OpenMP was tried first: its barriers wait for every thread, so on a busy
 * machine a calibration of 2 s took 12 s.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/xalloc.h"

enum { SPINS = 60000 }; /* tries to find work before sleeping: some 10 us */

struct worker {
	struct pool *pool;
	unsigned number;
};

/* ticket has the number of the job in its upper half and the next piece in its
 * lower half.  When a job is closed, its next piece is CLOSED, so that a late
 * thread cannot take a piece while the next job is being set up. */
struct pool {
	unsigned threads;
	pthread_t *thread;
	struct worker *worker;
	pthread_mutex_t lock;
	pthread_cond_t wake;
	atomic_bool quit;
	atomic_uint sleepers;
	atomic_uint_fast64_t ticket;
	atomic_size_t done, n;
	_Atomic(void (*)(void *, size_t, unsigned)) run;
	_Atomic(void *) data;
};

static const uint64_t CLOSED = UINT32_MAX;

/* Takes and runs one piece.  Returns false if there is none. */
static bool
run_next_pool_piece(struct pool *pool, unsigned number)
{
	uint_fast64_t ticket = atomic_load(&pool->ticket);
	size_t piece = (size_t)(ticket & CLOSED);
	if (piece == CLOSED || piece >= atomic_load(&pool->n))
		return false;
	void (*run)(void *, size_t, unsigned) = atomic_load(&pool->run);
	void *data = atomic_load(&pool->data);
	/* Fails if another thread took the piece or the job changed meanwhile;
	 * the caller tries again. */
	if (atomic_compare_exchange_strong(
		&pool->ticket, &ticket, ticket + 1)) {
		run(data, piece, number);
		atomic_fetch_add(&pool->done, 1);
	}
	return true;
}

static bool
is_pool_idle(struct pool *pool)
{
	size_t piece = (size_t)(atomic_load(&pool->ticket) & CLOSED);
	return piece == CLOSED || piece >= atomic_load(&pool->n);
}

static void
sleep_until_work(struct pool *pool)
{
	pthread_mutex_lock(&pool->lock);
	atomic_fetch_add(&pool->sleepers, 1);
	while (is_pool_idle(pool) && !atomic_load(&pool->quit))
		pthread_cond_wait(&pool->wake, &pool->lock);
	atomic_fetch_sub(&pool->sleepers, 1);
	pthread_mutex_unlock(&pool->lock);
}

static void *
run_pool_thread(void *argument)
{
	const struct worker *worker = argument;
	struct pool *pool = worker->pool;
	int idle = 0;
	while (!atomic_load(&pool->quit)) {
		if (run_next_pool_piece(pool, worker->number)) {
			idle = 0;
		} else if (++idle > SPINS) {
			sleep_until_work(pool);
			idle = 0;
		}
	}
	return NULL;
}

static void
wake_all_threads(struct pool *pool)
{
	if (atomic_load(&pool->sleepers) == 0)
		return;
	pthread_mutex_lock(&pool->lock);
	pthread_cond_broadcast(&pool->wake);
	pthread_mutex_unlock(&pool->lock);
}

/* Blocks signals, because only the main thread handles them, and blocks them
 * while it writes a file.  Faults are not blocked, as they concern the thread
 * in which they happen. */
static void
block_signals_for_threads(sigset_t *before)
{
	static const int FAULTS[] = {
	    SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};
	sigset_t held;
	sigfillset(&held);
	for (size_t i = 0; i < ARRAY_LEN(FAULTS); i++)
		sigdelset(&held, FAULTS[i]);
	pthread_sigmask(SIG_SETMASK, &held, before);
}

struct pool *
pool_new(unsigned threads)
{
	sigset_t before;
	struct pool *pool = xcalloc(1, sizeof *pool);
	pthread_mutex_init(&pool->lock, NULL);
	pthread_cond_init(&pool->wake, NULL);
	atomic_store(&pool->ticket, CLOSED);
	pool->thread = xcalloc(threads, sizeof *pool->thread);
	pool->worker = xcalloc(threads, sizeof *pool->worker);
	pool->threads = 1;
	block_signals_for_threads(&before);
	while (pool->threads < threads) {
		unsigned i = pool->threads;
		pool->worker[i] = (struct worker){pool, i};
		if (pthread_create(&pool->thread[i], NULL, run_pool_thread,
			&pool->worker[i]) != 0)
			break;
		pool->threads++;
	}
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	return pool;
}

void
pool_free(struct pool *pool)
{
	if (pool == NULL)
		return;
	pthread_mutex_lock(&pool->lock);
	atomic_store(&pool->quit, true);
	pthread_cond_broadcast(&pool->wake);
	pthread_mutex_unlock(&pool->lock);
	for (unsigned i = 1; i < pool->threads; i++)
		pthread_join(pool->thread[i], NULL);
	pthread_mutex_destroy(&pool->lock);
	pthread_cond_destroy(&pool->wake);
	free(pool->thread);
	free(pool->worker);
	free(pool);
}

unsigned
pool_count_threads(const struct pool *pool)
{
	return pool != NULL ? pool->threads : 1;
}

void
pool_run(struct pool *pool, size_t n,
    void (*run)(void *data, size_t piece, unsigned thread), void *data)
{
	if (pool_count_threads(pool) == 1) {
		for (size_t i = 0; i < n; i++)
			run(data, i, 0);
		return;
	}
	uint64_t job = (atomic_load(&pool->ticket) >> 32) + 1;
	atomic_store(&pool->n, n);
	atomic_store(&pool->run, run);
	atomic_store(&pool->data, data);
	atomic_store(&pool->done, 0);
	atomic_store(&pool->ticket, job << 32);
	wake_all_threads(pool);
	while (run_next_pool_piece(pool, 0))
		;
	while (atomic_load(&pool->done) < n)
		sched_yield();
	atomic_store(&pool->ticket, job << 32 | CLOSED);
}
