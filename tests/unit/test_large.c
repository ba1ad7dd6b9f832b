/* What is large is read with a cost that grows with its cells, or refused
 * before it is looked at; and whoever waits can have it stopped.  No clock is
 * read: bench/large prints seconds.  What counts here is how often reading asks
 * whether to stop, as every loop over a file's contents does.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "large.h"
#include "often.h"
#include "sheets.h"

#include <signal.h>

/* Cells between two questions; how much more often four times the cells may ask
 * than the cells do, and so much beyond for what asks once or twice. */
enum { MOST_CELLS = 10000, MOST_TIMES = 5, MOST_BEYOND = 20 };

static const char PATH[] = "large";

/* What reading asks: how often it did, and at which question it is told to stop
 * (0: never). */
static size_t asked, stop_at;

static bool
stop(void)
{
	return ++asked == stop_at;
}

/* What reads for so long hangs: SIGALRM ends the test. */
static struct site *
read_large(struct error_list *errors, size_t at)
{
	*errors = (struct error_list){.stop = stop};
	asked = 0;
	stop_at = at;
	alarm(300);
	struct site *site = site_read(PATH, errors);
	alarm(0);
	return site;
}

/* How often is asked while a quarter of it is read. */
static size_t
asked_of_quarter(const struct large *large)
{
	struct error_list errors;
	assert_true(put_large(large, large->n / 4, PATH));
	site_free(read_large(&errors, 0));
	return asked;
}

static void
the_cost_of_reading_grows_with_the_cells(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(LARGE); i++) {
		struct large shorter = LARGE[i], *large = &shorter;
		struct error_list errors;
		/* What is refused for its size keeps it. */
		bool sized = strcmp(large->wanted, "") != 0 &&
			     strcmp(large->wanted, NO_TABLE) != 0 &&
			     strcmp(large->wanted, NO_SIEVES) != 0;
		size_t share = sized ? 1 : often(8, 1);
		shorter.n /= share;
		shorter.cells /= share;
		size_t quarter = asked_of_quarter(large);
		assert_true(put_large(large, large->n, PATH));
		struct site *site = read_large(&errors, 0);
		print_message("# %zu %s: asked %zu times, of a quarter %zu\n",
		    large->n, large->what, asked, quarter);
		if (asked < large->cells / MOST_CELLS)
			fail_msg("%s: asked %zu times in %zu cells",
			    large->what, asked, large->cells);
		if (asked > MOST_TIMES * quarter + MOST_BEYOND)
			fail_msg("%s: asked %zu times, of a quarter %zu",
			    large->what, asked, quarter);
		if ((site != NULL) != (large->wanted[0] == '\0') ||
		    (site == NULL &&
			strstr(errors.item[0].text, large->wanted) == NULL))
			fail_msg("%s: %s", large->what, errors.item[0].text);
		site_free(site);
	}
}

/* At each of the first questions, and at ever later ones. */
static void
reading_stops_when_it_is_told_to(void **state)
{
	(void)state;
	size_t step = often(4, 1);
	for (size_t i = 0; i < ARRAY_LEN(LARGE); i++) {
		struct error_list errors;
		assert_true(put_large(&LARGE[i], LARGE[i].n / 16, PATH));
		site_free(read_large(&errors, 0));
		size_t all = asked;
		for (size_t at = 1; at <= all; at += 1 + at * step / 2) {
			struct site *site = read_large(&errors, at);
			assert_null(site);
			assert_true(errors.stopped);
			assert_int_equal(asked, at); /* and no more */
			bool told = false;
			for (size_t k = 0; k < errors.n; k++)
				told = told ||
				       errors.item[k].kind == ERROR_STOPPED;
			assert_true(told || errors.more > 0);
		}
	}
}

static int
remove_sheet(void **state)
{
	(void)state;
	return remove(PATH);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_cost_of_reading_grows_with_the_cells),
	    cmocka_unit_test(reading_stops_when_it_is_told_to)};
	return cmocka_run_group_tests(tests, NULL, remove_sheet);
}
