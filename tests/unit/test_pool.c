/* Work sharing: every piece once, whatever the threads do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "base/pool.h"
#include "base/xalloc.h"

enum { PIECES = 300 };

struct tally {
	atomic_int times[PIECES];
	atomic_int in_use[64];
	atomic_bool clash;
};

static void
count(void *data, size_t piece, unsigned thread)
{
	struct tally *tally = data;
	if (atomic_fetch_add(&tally->in_use[thread], 1) != 0)
		atomic_store(&tally->clash, true);
	atomic_fetch_add(&tally->times[piece], 1);
	atomic_fetch_sub(&tally->in_use[thread], 1);
}

static void
expect_once(struct pool *pool, size_t n)
{
	struct tally *tally = xcalloc(1, sizeof *tally);
	pool_run(pool, n, count, tally);
	for (size_t i = 0; i < PIECES; i++)
		assert_int_equal(atomic_load(&tally->times[i]), i < n);
	assert_false(atomic_load(&tally->clash));
	free(tally);
}

static void
every_piece_is_done_once(void **state)
{
	(void)state;
	for (unsigned threads = 1; threads <= 16; threads *= 2) {
		struct pool *pool = pool_new(threads);
		assert_int_equal(pool_count_threads(pool), threads);
		for (size_t n = 0; n <= PIECES; n += 50)
			expect_once(pool, n);
		pool_free(pool);
	}
}

static void
many_short_jobs_follow_each_other(void **state)
{
	(void)state;
	struct pool *pool = pool_new(4);
	for (size_t i = 0; i < 3000; i++)
		expect_once(pool, i % 7);
	pool_free(pool);
}

static void
no_pool_is_the_caller_alone(void **state)
{
	(void)state;
	assert_int_equal(pool_count_threads(NULL), 1);
	expect_once(NULL, PIECES);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(every_piece_is_done_once),
	    cmocka_unit_test(many_short_jobs_follow_each_other),
	    cmocka_unit_test(no_pool_is_the_caller_alone),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
