/* Every file of tests/fuzz/corpus through its reader, without a fuzzer: none
 * crashes, hangs or leaks (where a sanitizer looks), and those named good-* are
 * taken.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* setitimer */

#include <dirent.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "readers.h"

/* One that takes longer hangs: seconds of its own processor time, and of the
 * clock where it waits for what never comes. */
enum { LIMIT = 10, LIMIT_CLOCK = 60 };

static int n_test, n_bad;

static void
limit_time(bool on)
{
	const struct itimerval most = {.it_value.tv_sec = on ? LIMIT : 0};
	setitimer(ITIMER_PROF, &most, NULL);
	alarm(on ? LIMIT_CLOCK : 0);
}

static void
try_file(const struct reader *reader, const char *path, const char *name)
{
	enum { ROOM = 1000000 };
	uint8_t *bytes = xcalloc(ROOM, 1);
	FILE *in = fopen(path, "rb");
	size_t n = in != NULL ? fread(bytes, 1, ROOM, in) : 0;
	if (in != NULL)
		fclose(in);
	/* Told before, so that a crash has its file. */
	printf("# %s/%s\n", reader->name, name);
	fflush(stdout);
	limit_time(true);
	bool taken = reader_feed(reader, bytes, n);
	limit_time(false);
	bool good = taken || strncmp(name, "good-", 5) != 0;
	n_bad += !good;
	printf("%sok %d - %s/%s is %s\n", good ? "" : "not ", ++n_test,
	    reader->name, name, taken ? "taken" : "refused");
	free(bytes);
}

static void
try_folder(const char *corpus, const char *name)
{
	const struct reader *reader = reader_find(name);
	char *folder = xasprintf("%s/%s", corpus, name);
	struct dirent **entry;
	int n = scandir(folder, &entry, NULL, alphasort);
	if (reader == NULL || n < 0) {
		printf("not ok %d - a reader for %s\n", ++n_test, folder);
		n_bad++;
	}
	for (int i = 0; i < n; i++) {
		char *path = xasprintf("%s/%s", folder, entry[i]->d_name);
		if (reader != NULL && entry[i]->d_name[0] != '.')
			try_file(reader, path, entry[i]->d_name);
		free(path);
		free(entry[i]);
	}
	if (n >= 0)
		free(entry);
	free(folder);
}

int
main(void)
{
	const char *srcdir = getenv("srcdir");
	char *corpus =
	    xasprintf("%s/tests/fuzz/corpus", srcdir != NULL ? srcdir : ".");
	struct dirent **entry;
	int n = scandir(corpus, &entry, NULL, alphasort);
	gsl_set_error_handler_off();
	for (int i = 0; i < n; i++) {
		if (entry[i]->d_name[0] != '.')
			try_folder(corpus, entry[i]->d_name);
		free(entry[i]);
	}
	if (n >= 0)
		free(entry);
	free(corpus);
	printf("1..%d\n", n_test);
	return n_bad > 0;
}
