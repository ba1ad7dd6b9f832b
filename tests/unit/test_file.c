/* The one writer of files: rights, links, left-overs, full disks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/fs/file.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "made.h"

#include "base/text.h"

/* A folder of the test's own, which is the current one. */
static int
enter_folder(void **state)
{
	char *folder = xstrdup("/tmp/tipspeed-file-XXXXXX");
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	*state = folder;
	return 0;
}

/* Fails where a test left something behind. */
static int
leave_folder(void **state)
{
	char *folder = *state;
	assert_int_equal(chdir("/"), 0);
	assert_int_equal(rmdir(folder), 0);
	free(folder);
	return 0;
}

static void
put(const char *path, const char *text)
{
	struct error error = {0};
	if (!file_replace_contents(
		path, FILE_SHARED, text, strlen(text), &error))
		fail_msg("%s", error.text);
}

static bool
holds(const char *path, const char *text)
{
	char bytes[100] = "";
	FILE *in = fopen(path, "r");
	assert_non_null(in);
	size_t n = fread(bytes, 1, sizeof bytes - 1, in);
	fclose(in);
	return n == strlen(text) && strcmp(bytes, text) == 0;
}

static int
rights(const char *path)
{
	struct stat about;
	assert_int_equal(stat(path, &about), 0);
	return about.st_mode & 0777;
}

static void
a_new_file_has_the_rights_that_the_user_gives(void **state)
{
	(void)state;
	struct error error = {0};
	mode_t before = umask(027);
	put("shared", "x");
	assert_true(file_replace_contents("own", FILE_PRIVATE, "x", 1, &error));
	assert_true(file_append_bytes("added", FILE_PRIVATE, "x", 1, &error));
	umask(before);
	assert_int_equal(rights("shared"), 0640);
	assert_int_equal(rights("own"), 0600);
	assert_int_equal(rights("added"), 0600);
	unlink("shared");
	unlink("own");
	unlink("added");
}

static void
a_file_keeps_its_rights(void **state)
{
	(void)state;
	put("x", "old");
	chmod("x", 0666);
	mode_t before = umask(077);
	put("x", "new");
	umask(before);
	assert_true(holds("x", "new"));
	assert_int_equal(rights("x"), 0666);
	unlink("x");
}

/* In a folder of its own, by a path from there, and by a chain of two. */
static void
a_link_stays_and_its_target_is_written(void **state)
{
	(void)state;
	struct stat about;
	mkdir("far", 0700);
	put("far/x", "old");
	assert_int_equal(symlink("x", "far/link"), 0);
	assert_int_equal(symlink("far/link", "chain"), 0);
	put("chain", "new");
	assert_true(holds("far/x", "new"));
	assert_int_equal(lstat("chain", &about), 0);
	assert_true(S_ISLNK(about.st_mode));
	assert_int_equal(lstat("far/link", &about), 0);
	assert_true(S_ISLNK(about.st_mode));
	unlink("far/x");
	put("chain", "made");
	assert_true(holds("far/x", "made"));
	unlink("chain");
	unlink("far/link");
	unlink("far/x");
	rmdir("far");
}

static void
a_left_over_is_removed_and_nothing_else(void **state)
{
	(void)state;
	static const char dead[] = ".tipspeed-0123456789abcdef.tmp",
			  alive[] = ".tipspeed-fedcba9876543210.tmp",
			  other[] = "x.4711.tmp";
	put(dead, "torn");
	put(other, "of somebody");
	put("x", "old");
	/* As another program's writer holds it. */
	int fd = open(alive, O_WRONLY | O_CREAT, 0600);
	assert_int_equal(flock(fd, LOCK_EX), 0);
	put("x", "new");
	assert_int_equal(access(dead, F_OK), -1);
	assert_int_equal(access(alive, F_OK), 0);
	assert_int_equal(access(other, F_OK), 0);
	close(fd);
	put("x", "newer");
	assert_int_equal(access(alive, F_OK), -1);
	unlink(other);
	unlink("x");
}

static void
what_is_no_file_is_written_to_or_refused(void **state)
{
	(void)state;
	struct error error = {0};
	put("/dev/null", "gone");
	assert_false(file_replace_contents(".", FILE_SHARED, "x", 1, &error));
	assert_int_equal(error.kind, ERROR_SYSTEM);
	assert_non_null(strstr(error.text, "Is a directory"));
	assert_false(file_check_writable(".", false, NULL));
	assert_false(file_append_bytes(".", FILE_SHARED, "x", 1, NULL));
	assert_false(
	    file_replace_contents("none/x", FILE_SHARED, "x", 1, &error));
	assert_non_null(strstr(error.text, "none/x: No such file"));
	assert_false(file_check_writable("none/x", false, NULL));
	assert_true(file_check_writable("x", false, NULL));
	assert_int_equal(symlink("round", "round"), 0);
	assert_false(
	    file_replace_contents("round", FILE_SHARED, "x", 1, &error));
	unlink("round");
}

/* The old text stays whole, whether it was to be replaced or added to. */
static void
a_full_disk_takes_nothing_away(void **state)
{
	(void)state;
	char much[1000] = "";
	memset(much, 'x', sizeof much);
	put("x", "old");
	struct rlimit before, tight;
	getrlimit(RLIMIT_FSIZE, &before);
	tight = before;
	tight.rlim_cur = 100;
	signal(SIGXFSZ, SIG_IGN);
	setrlimit(RLIMIT_FSIZE, &tight);
	struct error replaced = {0}, added = {0};
	bool ok = file_replace_contents(
	    "x", FILE_SHARED, much, sizeof much, &replaced);
	bool more =
	    file_append_bytes("x", FILE_SHARED, much, sizeof much, &added);
	setrlimit(RLIMIT_FSIZE, &before);
	signal(SIGXFSZ, SIG_DFL);
	assert_false(ok);
	assert_false(more);
	assert_non_null(strstr(replaced.text, "File too large"));
	assert_non_null(strstr(added.text, "File too large"));
	assert_true(holds("x", "old"));
	unlink("x");
}

static void
what_is_added_follows_what_was_there(void **state)
{
	(void)state;
	struct error error = {0};
	assert_true(file_append_bytes("x", FILE_SHARED, "one\n", 4, &error));
	assert_true(file_append_bytes("x", FILE_SHARED, "two\n", 4, &error));
	assert_true(holds("x", "one\ntwo\n"));
	unlink("x");
}

/* A program that writes without end gets each signal that can be caught or ends
 * it, at moments of chance; leave_folder sees what it leaves. */
static void
no_signal_leaves_a_file_behind(void **state)
{
	(void)state;
	static const int SIGNALS[] = {SIGHUP, SIGINT, SIGQUIT, SIGABRT, SIGSEGV,
	    SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGPIPE, SIGXCPU};
	static char much[200000];
	for (size_t i = 0; i < 4 * ARRAY_LEN(SIGNALS); i++) {
		pid_t child = fork();
		if (child == 0) {
			setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
			for (size_t s = 0; s < ARRAY_LEN(SIGNALS); s++)
				signal(SIGNALS[s], SIG_DFL);
			for (;;)
				file_replace_contents(
				    "x", FILE_SHARED, much, sizeof much, NULL);
		}
		struct stat about;
		while (stat("x", &about) != 0)
			;
		nanosleep(&(struct timespec){0, 370000 * (long)i}, NULL);
		kill(child, SIGNALS[i % ARRAY_LEN(SIGNALS)]);
		int status;
		waitpid(child, &status, 0);
		assert_true(WIFSIGNALED(status));
		assert_int_equal(stat("x", &about), 0);
		assert_int_equal(about.st_size, sizeof much);
		unlink("x");
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_new_file_has_the_rights_that_the_user_gives),
	    cmocka_unit_test(a_file_keeps_its_rights),
	    cmocka_unit_test(a_link_stays_and_its_target_is_written),
	    cmocka_unit_test(a_left_over_is_removed_and_nothing_else),
	    cmocka_unit_test(what_is_no_file_is_written_to_or_refused),
	    cmocka_unit_test(a_full_disk_takes_nothing_away),
	    cmocka_unit_test(what_is_added_follows_what_was_there),
	    cmocka_unit_test(no_signal_leaves_a_file_behind),
	};
	return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
