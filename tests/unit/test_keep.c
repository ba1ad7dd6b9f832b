/* What was not saved is kept, of each program by itself, and comes back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>

#include "desk.h"

#include "cmd/session/autosave.h"
#include "cmd/session/script.h"
#include "cmd/session/invocation.h"
#include "io/fs/autosave_file.h"
#include "io/store/store.h"

static char folder[] = "/tmp/tipspeed-keep-XXXXXX";

static void
empty_folder(void)
{
	char *path = xasprintf("%s/tipspeed", folder);
	DIR *dir = opendir(path);
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		char *file = xasprintf("%s/%s", path, e->d_name);
		remove(file);
		free(file);
	}
	if (dir != NULL)
		closedir(dir);
	remove(path);
	free(path);
}

/* A session with somebody at its terminal.  Returns what is offered. */
static char *
attend(struct desk *desk)
{
	store_free(desk->session->store);
	desk->session->store = store_new("/tmp/tipspeed-keep-no-store");
	return autosave_begin(desk->session);
}

static struct desk *
sit_down(char **offer)
{
	void *desk;
	desk_open(&desk);
	char *text = attend(desk);
	if (offer != NULL)
		*offer = text;
	else
		free(text);
	return desk;
}

static void
leave(struct desk *desk)
{
	desk_close((void **)&desk);
}

/* The line, with the scripts that it opens. */
static bool
say(struct desk *desk, const char *line)
{
	struct session *s = desk->session;
	bool ok = desk_say(desk, line);
	while (ok && s->script != NULL) {
		struct place place;
		char *next = script_read_line(s, &place, &desk->error);
		ok = next != NULL ? desk_say(desk, next)
				  : desk->error.kind == ERROR_NONE;
		free(next);
	}
	script_close_to_depth(s, 0);
	return session_end_finished_commands(s, ok, &desk->error);
}

/* How many files there are, of running programs too; *info: of the last. */
static size_t
files(struct stat *info)
{
	char *path = xasprintf("%s/tipspeed", folder);
	DIR *dir = opendir(path);
	size_t n = 0;
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		char *file = xasprintf("%s/%s", path, e->d_name);
		n += e->d_name[0] != '.';
		if (e->d_name[0] != '.' && info != NULL)
			assert_int_equal(stat(file, info), 0);
		free(file);
	}
	if (dir != NULL)
		closedir(dir);
	free(path);
	return n;
}

static const char CHANGE[] = "params set f_mat=2 e0_min=16 alpha=1";

static int
open_desk(void **state)
{
	empty_folder();
	*state = sit_down(NULL);
	return 0;
}

static int
close_desk(void **state)
{
	return desk_close(state);
}

static void
looking_is_not_kept(void **state)
{
	assert_true(say(*state, "help; version; set k 2; seed 7; echo a"));
	assert_int_equal(files(NULL), 0);
}

static void
what_the_command_line_loaded_is_not_kept(void **state)
{
	void *desk;
	(void)state;
	desk_open(&desk);
	desk_expect(desk, "load data/sites/tierp.csv data/sites/bro.csv");
	free(attend(desk));
	assert_true(say(desk, "use tierp; show; check"));
	assert_int_equal(files(NULL), 0);
	assert_true(say(desk, CHANGE));
	assert_int_equal(files(NULL), 1);
	desk_close(&desk);
}

static void
a_change_is_kept_at_once_for_the_user_alone(void **state)
{
	struct stat info;
	assert_true(say(*state, "load data/sites/tierp.csv"));
	assert_int_equal(files(&info), 1);
	assert_int_equal(info.st_mode & 0777, 0600);
	char *path = xasprintf("%s/tipspeed", folder);
	assert_int_equal(stat(path, &info), 0);
	assert_int_equal(info.st_mode & 0777, 0700);
	free(path);
}

static void
the_slider_costs_no_writing(void **state)
{
	struct desk *desk = *state;
	size_t n;
	assert_true(say(desk, "load data/sites/tierp.csv"));
	assert_true(say(desk, CHANGE));
	assert_true(say(desk, "predict 74"));
	/* Who writes makes it anew. */
	struct stat before, after;
	assert_int_equal(files(&before), 1);
	assert_true(say(desk, "predict 75"));
	assert_true(say(desk, "predict 76"));
	assert_int_equal(files(&after), 1);
	assert_int_equal(before.st_ino, after.st_ino);
	assert_true(say(desk, "bounds alpha 0.5"));
	assert_int_equal(files(&after), 1);
	assert_true(before.st_ino != after.st_ino);
	assert_true(say(desk, "predict 77"));
	assert_true(say(desk, "predict 78"));
	/* But the last one is there in the end. */
	leave(desk);
	struct autosave_left *file = autosave_list_left_files(&n);
	assert_int_equal(n, 1);
	char *text = xasprintf("grep -q '^predict 78$' %s", file[0].path);
	assert_int_equal(system(text), 0);
	free(text);
	autosave_left_free(file, n);
	*state = sit_down(NULL);
}

static void
what_was_undone_or_saved_is_not_kept(void **state)
{
	struct desk *desk = *state;
	char *line = xasprintf("save %s/x.tip replace=on", folder),
	     *file = xasprintf("%s/x.tip", folder);
	assert_true(say(desk, "bounds alpha 0.5"));
	assert_int_equal(files(NULL), 1);
	assert_true(say(desk, "undo"));
	assert_int_equal(files(NULL), 0);
	assert_true(say(desk, "redo"));
	assert_int_equal(files(NULL), 1);
	assert_true(say(desk, line));
	assert_int_equal(files(NULL), 0);
	assert_true(say(desk, "bounds alpha 0.6"));
	assert_int_equal(files(NULL), 1);
	assert_true(say(desk, "undo"));
	assert_int_equal(files(NULL), 0);
	remove(file);
	free(file);
	free(line);
}

static void
the_next_session_has_it_back(void **state)
{
	struct desk *desk = *state;
	char *offer;
	assert_true(say(desk, "load data/sites/tierp.csv"));
	assert_true(say(desk, CHANGE));
	leave(desk);
	*state = desk = sit_down(&offer);
	assert_non_null(
	    strstr(offer, "'restore last' brings back your last session"));
	assert_non_null(strstr(offer, " (2 commands, Tierp)"));
	free(offer);
	assert_true(say(desk, "restore last"));
	assert_true(say(desk, "predict 74; assert p50 > 0"));
	leave(desk);
	/* It is still not saved, and there once. */
	assert_int_equal(files(NULL), 1);
	*state = desk = sit_down(&offer);
	assert_non_null(strstr(offer, "(3 commands, Tierp)"));
	free(offer);
	/* Nor is it gone when it was taken up and put down again. */
	assert_true(say(desk, "restore last"));
	assert_true(say(desk, "undo"));
	leave(desk);
	assert_int_equal(files(NULL), 1);
	*state = desk = sit_down(NULL);
	char *line = xasprintf("save %s/x.tip", folder);
	assert_true(say(desk, "restore last"));
	assert_true(say(desk, line));
	memcpy(line, "rm  ", 4);
	assert_int_equal(system(line), 0);
	free(line);
	leave(desk);
	assert_int_equal(files(NULL), 0);
	*state = sit_down(&offer);
	assert_null(offer);
}

static void
what_reset_put_aside_is_kept(void **state)
{
	struct desk *desk = *state;
	char *offer;
	assert_true(say(desk, "load data/sites/bro.csv"));
	assert_true(say(desk, "reset"));
	leave(desk);
	*state = sit_down(&offer);
	assert_non_null(strstr(offer, "(1 command, Bro)"));
	free(offer);
}

static void
a_restore_that_fails_leaves_what_was_kept(void **state)
{
	struct desk *desk = *state;
	char *copy = xasprintf("%s/gone.csv", folder),
	     *load = xasprintf("load data/sites/bro.csv %s", copy),
	     *make = xasprintf("cp data/sites/tierp.csv %s", copy);
	assert_int_equal(system(make), 0);
	assert_true(say(desk, load));
	leave(desk);
	remove(copy);
	*state = desk = sit_down(NULL);
	assert_false(say(desk, "restore last"));
	assert_int_equal(files(NULL), 1);
	assert_int_equal(system(make), 0);
	assert_true(say(desk, "restore last"));
	remove(copy);
	free(make);
	free(load);
	free(copy);
}

static void
two_at_a_time_keep_what_each_has(void **state)
{
	struct desk *one = *state, *two = sit_down(NULL);
	char *offer;
	size_t n;
	assert_true(say(one, "load data/sites/tierp.csv"));
	assert_true(say(two, "load data/sites/bro.csv"));
	/* Of one that runs nothing is offered. */
	struct desk *three = sit_down(&offer);
	assert_null(offer);
	assert_false(say(three, "restore last"));
	leave(three);
	leave(two);
	three = sit_down(&offer);
	assert_non_null(strstr(offer, "(1 command, Bro)"));
	free(offer);
	leave(three);
	leave(one);
	struct autosave_left *file = autosave_list_left_files(&n);
	assert_int_equal(n, 2);
	*state = one = sit_down(NULL);
	assert_true(say(one, "set format csv; restore"));
	assert_non_null(strstr(one->out, "\"1 command, Bro\""));
	assert_non_null(strstr(one->out, "\"1 command, Tierp\""));
	assert_non_null(strstr(one->out, file[0].path));
	/* As far from now as the file system goes: a tmpfs has no limit. */
	const struct timespec far[2] = {{INT64_MAX, 0}, {INT64_MAX, 0}};
	assert_int_equal(utimensat(AT_FDCWD, file[0].path, far, 0), 0);
	assert_true(say(one, "restore"));
	autosave_left_free(file, n);
}

static void
the_newest_few_stay(void **state)
{
	for (int i = 0; i < 9; i++) {
		struct desk *desk = sit_down(NULL);
		assert_true(say(desk, "bounds alpha 0.5"));
		leave(desk);
	}
	assert_int_equal(files(NULL), 6);
	(void)state;
}

static void
safe_and_without_trace_keep_nothing(void **state)
{
	void *desk;
	(void)state;
	desk_open(&desk);
	assert_null(autosave_begin(((struct desk *)desk)->session));
	desk_expect(desk, "bounds alpha 0.5");
	desk_close(&desk);
	desk_open(&desk);
	((struct desk *)desk)->session->safe = true;
	free(attend(desk));
	desk_expect(desk, "bounds alpha 0.5");
	desk_close(&desk);
	assert_int_equal(files(NULL), 0);
}

static void
where_it_cannot_be_kept_it_says_so_at_the_end(void **state)
{
	struct desk *desk = *state;
	setenv("XDG_STATE_HOME", "/dev/null", 1);
	assert_true(say(desk, "bounds alpha 0.5"));
	fflush(desk->notes_file);
	assert_int_equal(desk->n_notes, 0);
	autosave_end(desk->session);
	fflush(desk->notes_file);
	setenv("XDG_STATE_HOME", folder, 1);
	assert_string_equal(desk->notes,
	    "could not keep this session: /dev/null/tipspeed: "
	    "Not a directory\n");
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, open_desk, close_desk)
	const struct CMUnitTest tests[] = {
	    at_desk(looking_is_not_kept),
	    at_desk(what_the_command_line_loaded_is_not_kept),
	    at_desk(a_change_is_kept_at_once_for_the_user_alone),
	    at_desk(the_slider_costs_no_writing),
	    at_desk(what_was_undone_or_saved_is_not_kept),
	    at_desk(the_next_session_has_it_back),
	    at_desk(what_reset_put_aside_is_kept),
	    at_desk(a_restore_that_fails_leaves_what_was_kept),
	    at_desk(two_at_a_time_keep_what_each_has),
	    at_desk(the_newest_few_stay),
	    at_desk(safe_and_without_trace_keep_nothing),
	    at_desk(where_it_cannot_be_kept_it_says_so_at_the_end),
	};
	chdir_to_source();
	assert_non_null(mkdtemp(folder));
	setenv("XDG_STATE_HOME", folder, 1);
	int status = cmocka_run_group_tests(tests, NULL, NULL);
	empty_folder();
	remove(folder);
	return status;
}
