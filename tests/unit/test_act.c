/* What keys do on the full screen, and in a line that is typed there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include "desk.h"

#include "base/text.h"
#include "ui/act.h"
#include "ui/pane.h"
#include "ui/screen.h"
#include "ui/tui_state.h"

static void
type(struct tui *t, const char *text)
{
	while (*text != '\0')
		act_key(t, (int)text_next(&text), false);
}

/* A full screen on the session of a desk, drawn aside. */
struct stage {
	struct tui t;
	struct desk *desk;
	struct display *was;
};

static int
stage_open(void **state)
{
	struct stage *stage = xcalloc(1, sizeof *stage);
	void *desk;
	desk_open(&desk);
	stage->desk = desk;
	stage->was = screen_aside(24, 80, CHARSET_ASCII, 0);
	tui_begin(&stage->t, stage->desk->session);
	stage->t.aside = true;
	pane_draw(&stage->t);
	*state = stage;
	return 0;
}

static int
stage_close(void **state)
{
	struct stage *stage = *state;
	void *desk = stage->desk;
	tui_end(&stage->t);
	canvas_free(screen_back(stage->was));
	free(stage);
	return desk_close(&desk);
}

/* U+0157 has the number of the keypad's Enter. */
static void
every_letter_is_text_in_a_line(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":\u0157\u0107");
	assert_true(t->typing.active);
	assert_string_equal(t->typing.text, "\u0157\u0107");
}

static void
what_is_completed_is_whole_letters(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char folder[] = "/tmp/tipspeed-act-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	close(open("xå.csv", O_CREAT | O_WRONLY, 0600));
	close(open("xä.csv", O_CREAT | O_WRONLY, 0600));
	type(t, ":load x\t");
	unlink("xå.csv");
	unlink("xä.csv");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
	assert_string_equal(t->typing.text, "load x");
}

static void
the_keypad_has_an_enter(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "72.3");
	act_key(t, PANE_ENTER, true);
	assert_int_equal(t->tenths, 723);
	type(t, "?/up by 5");
	act_key(t, PANE_ENTER, true);
	assert_int_equal(t->tenths, 773);
	type(t, ":set k 1");
	act_key(t, PANE_ENTER, true);
	assert_false(t->typing.active);
	assert_string_equal(t->command, "set k 1");
}

static void
a_word_too_long_to_find_does_nothing_else(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "?/what is longer than the room there is for a word: q");
	assert_true(t->viewer.filtering);
	assert_int_equal(strlen(t->viewer.word), sizeof t->viewer.word - 1);
	assert_false(t->leave);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(
		every_letter_is_text_in_a_line, stage_open, stage_close),
	    cmocka_unit_test_setup_teardown(
		what_is_completed_is_whole_letters, stage_open, stage_close),
	    cmocka_unit_test_setup_teardown(
		the_keypad_has_an_enter, stage_open, stage_close),
	    cmocka_unit_test_setup_teardown(
		a_word_too_long_to_find_does_nothing_else, stage_open,
		stage_close),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
