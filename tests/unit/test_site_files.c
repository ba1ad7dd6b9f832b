/* Site files of any bytes, and files that cannot be read or written.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "often.h"
#include "rules.h"
#include "sheets.h"

#include "io/sitefile/results.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* Whatever the bytes are: a site that keeps the rules and reads back, or faults
 * of the file in their order. */
static void
read_anything(const char *bytes, size_t n)
{
	struct error_list errors = {0};
	struct site *site = site_read(put_sheet(bytes, n), &errors);
	assert_true((site == NULL) == (errors.n > 0));
	for (size_t i = 0; i < errors.n; i++) {
		const struct error *e = &errors.item[i];
		assert_int_equal(e->kind, ERROR_DATA);
		assert_true(e->text[0] != '\0' && e->hint[0] != '\0');
		assert_true(n == 0 || (e->line > 0 && e->column > 0));
		assert_true(i == 0 || e[-1].line <= e->line);
	}
	if (site == NULL)
		return;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		assert_true(keeps_rules(&run->feed));
		assert_true(keeps_rules(&run->product));
		assert_true(run->feed.n >= 2 && run->feed.passing[0] >= 1);
	}
	if (!reads_back(site))
		fail_msg("does not read back:\n%.*s", (int)n, bytes);
	site_free(site);
}

static void
every_prefix_is_read_or_refused(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(SAME); i++)
		for (size_t n = 0; n <= strlen(SAME[i]); n++)
			read_anything(SAME[i], n);
	for (size_t n = 0; n <= strlen(GOOD); n++)
		read_anything(GOOD, n);
}

static uint64_t
next_random(uint64_t *x)
{
	*x ^= *x << 13;
	*x ^= *x >> 7;
	*x ^= *x << 17;
	return *x >> 11;
}

static void
every_mutation_is_read_or_refused(void **state)
{
	(void)state;
	static const char bytes[] = "0123456789,,;;..\"\"\n\r\t@-#% eE\xC3\xA5";
	uint64_t seed = 20240509;
	char text[2000];
	for (size_t i = 0; i < often(1500, 60000); i++) {
		size_t which = next_random(&seed) % (ARRAY_LEN(SAME) + 1);
		snprintf(text, sizeof text, "%s",
		    which == 0 ? GOOD : SAME[which - 1]);
		size_t n = strlen(text);
		size_t changes = 1 + next_random(&seed) % 3;
		for (size_t k = 0; k < changes; k++) {
			size_t at = next_random(&seed) % n;
			size_t from = next_random(&seed) % n;
			char byte =
			    bytes[next_random(&seed) % (sizeof bytes - 1)];
			switch (next_random(&seed) % 4) {
			case 0:
				text[at] = byte;
				break;
			case 1:
				memmove(text + at, text + at + 1, n - at);
				n--;
				break;
			case 2:
				memmove(text + at + 1, text + at, n - at);
				text[at] = byte;
				n++;
				break;
			default:
				text[at] = text[from];
			}
		}
		read_anything(text, n);
	}
}

static void
expect_other_file(const char *bytes, size_t n, const char *part)
{
	struct error_list errors = {0};
	assert_null(site_read(put_sheet(bytes, n), &errors));
	assert_non_null(strstr(errors.item[0].text, part));
	assert_true(errors.item[0].hint[0] != '\0');
}

static void
large_garbage_is_refused(void **state)
{
	(void)state;
	enum { N = 10 * 1000 * 1000 };
	char *bytes = xcalloc(N + 1, 1);
	static const struct {
		const char *fill, *part;
	} garbage[] = {{"lorem ipsum\n", "more than 20000 lines"},
	    {"lorem ipsum ", "200000 bytes"}, {",", "200000 bytes"},
	    {"\"", "200000 bytes"}, {"1,2,3\n", "more than 20000 lines"},
	    {"#\n", "a table of sieves"}, {"\n ", "empty file"}};
	for (size_t i = 0; i < ARRAY_LEN(garbage); i++) {
		for (size_t k = 0; k < N; k++)
			bytes[k] = garbage[i].fill[k % strlen(garbage[i].fill)];
		expect_other_file(bytes, N, garbage[i].part);
		expect_other_file(bytes, N + 1, "at most 10 MB");
	}
	uint64_t seed = 7;
	for (size_t k = 0; k < N; k++)
		bytes[k] = (char)next_random(&seed);
	expect_other_file(bytes, N, "a binary file");
	free(bytes);
}

static void
files_that_are_no_text_are_named(void **state)
{
	(void)state;
	expect_other_file("\xFF\xFEs\0i\0t", 7, "damaged UTF-16");
	expect_other_file("\xFE\xFF\xD8\0\0i", 6, "damaged UTF-16");
	expect_other_file("\xFF\xFEs\0\0\0t\0", 8, "a binary file");
	expect_other_file("PK\3\4\0\0\0\0", 8, "a damaged one");
	expect_other_file("site,T\0", 7, "a binary file");
}

/* A folder for the files of a test; the group's teardown takes it away. */
static int
make_folder(void **state)
{
	char *folder = xstrdup("/tmp/tipspeed-test-XXXXXX");
	*state = mkdtemp(folder);
	return *state == NULL;
}

static int
drop_folder(void **state)
{
	char *folder = *state;
	int failed = rmdir(folder);
	free(folder);
	return failed;
}

static void
expect_file_fault(const char *path, enum error_kind kind, const char *part)
{
	struct error_list errors = {0};
	assert_null(site_read(path, &errors));
	assert_int_equal(errors.n, 1);
	assert_int_equal(errors.item[0].kind, kind);
	assert_string_equal(errors.item[0].file, path);
	assert_non_null(strstr(errors.item[0].text, part));
	assert_true(errors.item[0].hint[0] != '\0');
}

static void
files_that_cannot_be_read_are_told(void **state)
{
	const char *folder = *state;
	char *path = xasprintf("%s/x.csv", folder);
	expect_file_fault(path, ERROR_SYSTEM, "No such file");
	expect_file_fault(folder, ERROR_SYSTEM, "directory");
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	expect_file_fault(path, ERROR_DATA, "empty file");
	/* A hole: large, and nothing on the disk. */
	assert_int_equal(ftruncate(fileno(file), 3000000000), 0);
	fclose(file);
	expect_file_fault(path, ERROR_DATA, "got 3000.0 MB");
	if (geteuid() != 0) { /* to root every file is readable */
		chmod(path, 0);
		expect_file_fault(path, ERROR_SYSTEM, "ermission");
	}
	unlink(path);
	free(path);
}

static void
a_saved_site_reads_back(void **state)
{
	char *path = xasprintf("%s/Gåsgruvan 2.b.csv", (char *)*state);
	size_t rows = 0;
	struct error error = {0};
	struct error_list errors = {0};
	struct site *site = accept(TOP ROWS);
	free(site->name);
	site->name = xstrdup("");
	for (int i = 0; i < 2; i++) {
		assert_true(site_save(site, path, &rows, &error));
		chmod(path, 0640);
	}
	struct stat about;
	assert_int_equal(stat(path, &about), 0);
	assert_int_equal(about.st_mode & 0777, 0640);
	assert_int_equal(rows, site->run[0].feed.n);
	struct site *again = site_read(path, &errors);
	assert_non_null(again);
	assert_true(again->digest == site->digest);
	assert_string_equal(again->name, "Gåsgruvan 2.b");
	assert_string_equal(again->path, path);
	unlink(path);
	free(path);
	site_free(site);
	site_free(again);
}

/* The old sheet stays and nothing else is left when the disk takes no more;
 * drop_folder fails if something is. */
static void
a_save_that_fails_leaves_the_old_file(void **state)
{
	const char *folder = *state;
	char *path = xasprintf("%s/x.csv", folder);
	char *none = xasprintf("%s/none/x.csv", folder);
	size_t rows;
	struct error error = {0};
	struct site *site = accept(GOOD), *small = accept(TOP ROWS);
	assert_true(site_save(small, path, &rows, &error));
	struct rlimit before, tight;
	getrlimit(RLIMIT_FSIZE, &before);
	tight = before;
	tight.rlim_cur = 100;
	signal(SIGXFSZ, SIG_IGN);
	setrlimit(RLIMIT_FSIZE, &tight);
	assert_false(site_save(site, path, &rows, &error));
	setrlimit(RLIMIT_FSIZE, &before);
	signal(SIGXFSZ, SIG_DFL);
	assert_int_equal(error.kind, ERROR_SYSTEM);
	assert_non_null(strstr(error.text, path));
	assert_false(site_save(site, none, &rows, &error));
	assert_non_null(strstr(error.text, "No such file"));
	assert_false(site_save(site, folder, &rows, &error));
	assert_false(site_save(site, folder, &rows, NULL));
	struct error_list errors = {0};
	struct site *kept = site_read(path, &errors);
	assert_non_null(kept);
	assert_true(kept->digest == small->digest);
	unlink(path);
	free(path);
	free(none);
	site_free(kept);
	site_free(small);
	site_free(site);
}

/* n runs, each at a speed of its own, with the sieves of the rows. */
static struct site *
site_of_runs(size_t n, bool individual_feeds)
{
	struct site *site = site_new(n), *one = accept(TOP ROWS);
	const struct psd *coarse = &one->run[0].feed;
	for (size_t r = 0; r < n; r++) {
		site->run[r].speed = 60 + 0.01 * (double)r;
		site->run[r].feed = psd_copy(coarse);
		site->run[r].product = psd_copy(coarse);
		site->run[r].product.passing[1] *= 0.9 + 1e-5 * (double)r;
	}
	site->individual_feeds = individual_feeds;
	site_update_digest_and_mean_feed(site);
	site_free(one);
	return site;
}

/* Speeds of which each is that of its neighbours, but not the first that of the
 * last, make a run for each product. */
static void
speeds_close_in_a_row_make_a_run_each(void **state)
{
	(void)state;
	enum { N = 12 };
	char *text = xstrdup("top_size_mm,8\nsize_mm,feed");
	for (int i = 0; i < N; i++)
		xappend(&text, ",product@60.%03d", i);
	for (int mm = 8; mm >= 4; mm -= 4) {
		xappend(&text, "\n%d,%d", mm, mm == 8 ? 100 : 60);
		for (int i = 0; i < N; i++)
			xappend(&text, ",%d", mm == 8 ? 100 : 70 + i);
	}
	struct site *site = accept(text);
	assert_int_equal(site->n_run, N);
	site_free(site);
	free(text);
}

/* What can be written can be read: 4000 columns, that of the sizes included. */
static void
a_site_of_many_runs_reads_back_or_is_not_written(void **state)
{
	char *path = xasprintf("%s/many.csv", (char *)*state);
	static const struct {
		size_t runs;
		bool individual_feeds, written;
	} sites[] = {{300, false, true}, {3998, false, true},
	    {3999, false, false}, {1999, true, true}, {2000, true, false}};
	for (size_t i = 0; i < ARRAY_LEN(sites); i++) {
		size_t rows;
		struct error error = {0};
		struct error_list errors = {0};
		struct site *site =
		    site_of_runs(sites[i].runs, sites[i].individual_feeds);
		bool written = site_save(site, path, &rows, &error);
		assert_int_equal(written, sites[i].written);
		if (written) {
			struct site *again = site_read(path, &errors);
			assert_non_null(again);
			assert_int_equal(again->n_run, sites[i].runs);
			assert_int_equal(
			    again->individual_feeds, sites[i].individual_feeds);
			site_free(again);
			unlink(path);
		} else
			assert_non_null(
			    strstr(error.text, "at most 4000 columns"));
		site_free(site);
	}
	free(path);
}

/* A feed alone serves a guess; it reads back as it was. */
static void
a_feed_needs_no_product(void **state)
{
	(void)state;
	struct site *site = accept("size_mm,feed\n8,100\n4,60\n");
	assert_int_equal(site->n_run, 1);
	assert_true(site->run[0].speed == 0 && !site->individual_feeds);
	assert_int_equal(site->run[0].feed.n, 2);
	assert_int_equal(site_count_products(site), 0);
	assert_true(reads_back(site));
	site_free(site);
	site = accept("size_mm,feed@79,feed@69\n8,100,100\n4,60,50\n");
	assert_int_equal(site->n_run, 2);
	assert_true(site->run[0].speed == 69 && site->individual_feeds);
	assert_true(reads_back(site));
	site_free(site);
}

/* What was predicted is not taken for a product, whatever separates it. */
static void
own_results_are_no_sheet(void **state)
{
	(void)state;
	static const char *const RESULTS[] = {
	    "command,site,provenance,series,size_mm,passing_pct,low,high\n"
	    "plot,T,\"made up, here\",feed,8,100,,\nplot,T,m,feed,4,60,,\n"
	    "plot,T,m,product@74.9,8,100,,\nplot,T,m,product@74.9,4,80,,\n",
	    "command;site;provenance;size_mm;feed_pct;product@74_pct\r\n"
	    "plot;T;m;8;100;100\r\nplot;T;m;4;60,5;80,5\r\n",
	    "command,size_mm,feed,product@74\nplot,8,100,100\n"
	    "plot,4,60,80\n"};
	for (size_t i = 0; i < ARRAY_LEN(RESULTS); i++) {
		const char *path = put_sheet(RESULTS[i], strlen(RESULTS[i]));
		const struct site_request request = {.n = 1,
		    .path = &path,
		    .columns =
			i == 2 ? "2=sieve mm, 3=feed, 4=product@74" : NULL};
		struct error_list errors = {0};
		assert_null(site_read_with_options(&request, &errors, NULL));
		assert_string_equal(errors.item[0].text,
		    "expected a site file, got tipspeed's own results "
		    "(plot)");
		char *command = command_that_made_file(path);
		assert_string_equal(command, "plot");
		free(command);
	}
	static const char JSON[] = "{\"command\":\"predict\",\"site\":\"T\"}";
	FREED char *command =
	    command_that_made_file(put_sheet(JSON, strlen(JSON)));
	assert_string_equal(command, "predict");
	const char *path = put_sheet(GOOD, strlen(GOOD));
	assert_null(command_that_made_file(path));
	path = put_sheet("{\"sieves\":[8,4]}", 16);
	assert_null(command_that_made_file(path));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(every_prefix_is_read_or_refused),
	    cmocka_unit_test(every_mutation_is_read_or_refused),
	    cmocka_unit_test(large_garbage_is_refused),
	    cmocka_unit_test(files_that_are_no_text_are_named),
	    cmocka_unit_test_setup_teardown(
		files_that_cannot_be_read_are_told, make_folder, drop_folder),
	    cmocka_unit_test_setup_teardown(
		a_saved_site_reads_back, make_folder, drop_folder),
	    cmocka_unit_test_setup_teardown(
		a_save_that_fails_leaves_the_old_file, make_folder,
		drop_folder),
	    cmocka_unit_test_setup_teardown(
		a_site_of_many_runs_reads_back_or_is_not_written, make_folder,
		drop_folder),
	    cmocka_unit_test(speeds_close_in_a_row_make_a_run_each),
	    cmocka_unit_test(a_feed_needs_no_product),
	    cmocka_unit_test(own_results_are_no_sheet),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
