/* Times reading large files: the processor time for each file of
 * tests/unit/large.h at growing sizes, and the longest time in which reading
 * did not ask whether to stop.  Prints a row for each size; bench/README.md has
 * results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "../tests/unit/large.h"

#include <time.h>
#include <unistd.h>

#include "io/sitefile/site_read.h"

static double last, longest;

static double
processor(void)
{
	return (double)clock() / CLOCKS_PER_SEC;
}

static bool
note_time(void)
{
	double now = processor();
	longest = fmax(longest, now - last);
	last = now;
	return false;
}

/* Takes the shortest of three times, because other processes can only make it
 * longer. */
static void
measure(const struct large *large, size_t n, const char *path)
{
	double best = INFINITY, silent = INFINITY;
	bool site_is_read = false;
	if (!put_large(large, n, path)) {
		perror(path);
		exit(1);
	}
	for (int i = 0; i < 3; i++) {
		struct error_list errors = {.stop = note_time};
		double began = processor();
		last = began;
		longest = 0;
		struct site *site = site_read(path, &errors);
		note_time();
		best = fmin(best, last - began);
		silent = fmin(silent, longest);
		site_is_read = site != NULL;
		site_free(site);
	}
	printf("%9zu %-38s %7.3f %10.3f  %s\n", n, large->what, best, silent,
	    site_is_read ? "read" : "refused");
}

int
main(int argc, char **argv)
{
	if (argc != 2) {
		fputs("usage: large FILE, which is written and removed\n",
		    stderr);
		return 2;
	}
	puts("        n of                                     seconds  "
	     "unasked s");
	for (size_t i = 0; i < ARRAY_LEN(LARGE); i++)
		for (size_t of = 16; of > 0; of /= 4)
			measure(&LARGE[i], LARGE[i].n / of, argv[1]);
	return unlink(argv[1]) == 0 ? 0 : 1;
}
