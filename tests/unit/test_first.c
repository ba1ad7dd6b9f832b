/* The first minute on the full screen: ways to a site, files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <curses.h>

#include "desk.h"
#include "stage.h"

#include "base/text.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/folder.h"
#include "tui/frame.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/watch.h"
#include "tui/view.h"
#include "tui/widgets/list.h"

static int
stage_open(void **state)
{
	struct stage *stage = stage_new(24, 80, CHARSET_ASCII, 0, NULL);
	frame_draw(&stage->t);
	*state = stage;
	return 0;
}

/* What the loop does with a key. */
static void
press(struct tui *t, const char *name)
{
	int code = 0;
	assert_true(keys_code_of_name(name, &code));
	keymap_handle_key(t, code, code > 255);
	t->clock++;
	watch_run_due_fit_steps(t);
	view_update(t);
	frame_draw(t);
}

static void
type(struct tui *t, const char *text)
{
	while (*text != '\0') {
		const char key[2] = {*text++, '\0'};
		press(t, key[0] == ' ' ? "Space" : key);
	}
}

/* Whether the frame shows the words, in one row. */
static bool
shows(const char *words)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	canvas_print(screen_last_frame(), 0, out);
	fclose(out);
	bool found = strstr(text, words) != NULL;
	free(text);
	return found;
}

static void
choose(struct tui *t, const char *name)
{
	const struct folder *folder = &t->picker.folder;
	press(t, "Home");
	for (size_t i = 1;
	     i < folder->n &&
	     strcmp(folder->item[t->picker.list.at].name, name) != 0;
	     i++)
		press(t, "Down");
	assert_string_equal(folder->item[t->picker.list.at].name, name);
}

static void
without_a_site_it_shows_what_can_be_done(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	assert_true(shows("Open a sheet"));
	press(t, "Down");
	press(t, "Down");
	assert_true(shows("Quarries of the paper"));
	press(t, "Up");
	press(t, "Up");
	press(t, "Up");
	press(t, "Enter");
	assert_true(t->picker.on);
	assert_true(shows("open a sheet, in this folder"));
	press(t, "Esc");
	assert_false(t->picker.on);
	assert_true(shows("Open a sheet"));
}

/* Of saved sessions the list has nothing else but folders. */
static void
a_saved_session_is_restored(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct folder *folder = &t->picker.folder;
	press(t, "Down");
	press(t, "Enter");
	assert_true(shows("saved sessions, in this folder"));
	for (size_t i = 0; i < folder->n; i++)
		assert_true(folder->item[i].kind == FOLDER_SESSION ||
			    folder->item[i].kind == FOLDER_ABOVE ||
			    folder->item[i].kind == FOLDER_BELOW);
	choose(t, "data");
	press(t, "Enter");
	choose(t, "sessions");
	press(t, "Enter");
	choose(t, "paper.tip");
	assert_int_equal(folder->item[t->picker.list.at].kind, FOLDER_SESSION);
	char *line =
	    folder_command_to_open(&folder->item[t->picker.list.at], true);
	assert_string_equal(line, "restore \"data/sessions/paper.tip\"");
	free(line);
	press(t, "Esc");
	press(t, "Up");
}

static void
choose_borlange(struct tui *t)
{
	press(t, "o");
	choose(t, "data");
	press(t, "Enter");
	choose(t, "sites");
	press(t, "Right");
	keymap_handle_key(t, 0xE4, false);
	assert_string_equal(t->picker.word.text, "ä");
	press(t, "Esc");
	keymap_handle_key(t, 0x3B1, false);
	assert_non_null(strstr(t->message, "nothing here has 'α'"));
	choose(t, "borlange.csv");
}

static void
a_sheet_is_opened_by_a_command_that_can_be_undone(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	choose_borlange(t);
	assert_true(shows("3 runs: 69, 74, 79 m/s"));
	press(t, "Enter");
	assert_false(t->picker.on);
	assert_string_equal(t->command, "load \"data/sites/borlange.csv\"");
	assert_non_null(strstr(t->message, "press f to calibrate"));
	assert_int_equal(stage->desk->session->n_entry, 1);
	/* Once more, it takes the place of the site. */
	choose_borlange(t);
	press(t, "Enter");
	assert_non_null(strstr(t->message, "loaded earlier"));
	press(t, "u");
	assert_int_equal(stage->desk->session->n_entry, 1);
	press(t, "u");
	assert_int_equal(stage->desk->session->n_entry, 0);
	assert_true(shows("Open a sheet"));
}

static void
left_goes_to_the_folder_above(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	press(t, "o");
	choose(t, "data");
	press(t, "Enter");
	assert_string_equal(t->picker.folder.path, "data/");
	press(t, "Left");
	assert_string_equal(t->picker.folder.path, "");
	press(t, "Left");
	press(t, "Left");
	assert_string_equal(t->picker.folder.path, "../../");
	/* A key that is no letter closes the list and does what it does. */
	press(t, ":");
	assert_false(t->picker.on);
	assert_true(t->line.active);
}

/* Not to one another, and to no line that cannot be run. */
static void
without_a_site_all_keys_lead_to_a_sheet(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	static const char *const ASKING[] = {"x", "f", "e", "c", "t"};
	assert_false(shows("P80, mm"));
	for (size_t i = 0; i < ARRAY_LEN(ASKING); i++) {
		t->message[0] = '\0';
		press(t, ASKING[i]);
		assert_string_equal(t->message, TUI_NO_SITE);
		assert_false(t->line.active);
		assert_int_equal(t->ui.page, PAGE_PREDICT);
	}
	t->message[0] = '\0';
	for (enum page page = PAGE_FIT; page < PAGES; page++) {
		keymap_handle_key(t, keys_code_of_page(page), false);
		view_update(t);
		frame_draw(t);
		assert_false(shows(":load"));
	}
	press(t, "5");
	assert_false(shows("Enter use it"));
	assert_true(shows("o open a sheet"));
	press(t, "o");
	assert_true(t->picker.on);
}

/* Only the program, in a folder. */
static void
made_sites_need_no_installation(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char folder[] = "/tmp/tipspeed-first-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	press(t, "Down");
	press(t, "Down");
	press(t, "Enter");
	assert_in_range(t->picker.folder.n, 15, 19);
	type(t, "forsby");
	press(t, "Enter");
	assert_string_equal(tui_current_site_entry(t)->site->name, "Forsby");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
}

/* Not keys of the page behind it. */
static void
enter_calibrates_what_was_read(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":load data/sites/tierp.csv");
	press(t, "Enter");
	assert_true(shows("Enter calibrates"));
	assert_true(shows("3 runs: 69, 74, 79 m/s"));
	press(t, "Enter");
	assert_true(session_is_calibrating(t->session));
	assert_int_equal(t->ui.page, PAGE_FIT);
}

static void
letters_narrow_the_list(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	press(t, "Down");
	press(t, "Down");
	press(t, "Enter");
	size_t all = t->picker.folder.n;
	type(t, "limestone");
	assert_true(t->picker.on);
	assert_true(shows("containing 'limestone'"));
	assert_in_range(list_count_matching_rows(t), 1, all - 1);
	press(t, "Esc");
	assert_int_equal(list_count_matching_rows(t), all);
	type(t, "tierz");
	assert_true(shows("nothing here has 'tierz'"));
	assert_string_equal(t->picker.word.text, "tier");
	press(t, "Enter");
	assert_string_equal(tui_current_site_entry(t)->site->name, "Tierp");
	/* Left is the folder above, narrowed or not. */
	press(t, "o");
	type(t, "data");
	press(t, "Enter");
	type(t, "sit");
	assert_int_equal(list_count_matching_rows(t), 1);
	press(t, "Left");
	assert_string_equal(t->picker.folder.path, "");
	assert_int_equal(t->picker.word.n, 0);
	press(t, "Esc");
	assert_false(t->picker.on);
}

static void
a_site_of_the_program_is_tried(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "Down");
	press(t, "Down");
	press(t, "Enter");
	assert_int_equal(t->picker.folder.n, 19);
	choose(t, "tierp.csv");
	assert_true(shows("tierp           Granite          "));
	press(t, "Enter");
	assert_string_equal(stage->desk->session->entry[0].site->name, "Tierp");
}

static void
a_feed_fills_the_guess(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char folder[] = "/tmp/tipspeed-first-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	FILE *sheet = fopen("feed.csv", "w");
	fputs("rock,Gneiss\ntop_size_mm,16\nsize_mm,feed\n16,100\n4,40\n1,9\n",
	    sheet);
	fclose(sheet);
	press(t, "Down");
	press(t, "Down");
	press(t, "Down");
	press(t, "Enter");
	choose(t, "feed.csv");
	assert_true(shows("a feed, no product"));
	press(t, "Enter");
	assert_true(t->line.active);
	assert_string_equal(t->line.text, "guess rock=Gneiss top=16");
	/* What is not stated is typed where it belongs. */
	sheet = fopen("feed.csv", "w");
	fputs("top_size_mm,16\nsize_mm,feed\n16,100\n4,40\n1,9\n", sheet);
	fclose(sheet);
	press(t, "Esc");
	press(t, "o");
	choose(t, "feed.csv");
	press(t, "Enter");
	unlink("feed.csv");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
	type(t, "granitegranite");
	assert_string_equal(t->line.text, "guess rock=granitegranite top=16");
	press(t, "Enter");
	assert_non_null(t->viewer.text);
	assert_non_null(strstr(t->viewer.text,
	    "no material is of the rock type 'granitegranite'"));
	/* f would calibrate nothing. */
	press(t, "Esc");
	press(t, "c");
	assert_string_equal(t->message, "no product: type :guess");
	press(t, "2");
	assert_false(shows("f fit"));
}

static void
what_cannot_be_loaded_leaves_the_list_open(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	press(t, "o");
	type(t, "README");
	press(t, "Enter");
	assert_true(t->bad);
	assert_true(t->picker.on);
	assert_true(shows("! README.md"));
	press(t, "Down");
	assert_false(shows("! README.md"));
	press(t, "Esc");
	press(t, "Esc");
	assert_false(t->picker.on);
}

static void
the_mouse_chooses_and_opens(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	const struct layout *l = &t->layout;
	press(t, "o");
	int row = l->body.row + 2;
	hits_dispatch_mouse(t, &t->hits, HIT_PRESS, row, 3, keymap_handle_key);
	assert_int_equal(t->picker.list.at, 1);
	frame_draw(t);
	hits_dispatch_mouse(t, &t->hits, HIT_DOWN, row, 3, keymap_handle_key);
	assert_int_equal(t->picker.list.at, 2);
	frame_draw(t);
	hits_dispatch_mouse(
	    t, &t->hits, HIT_PRESS, row + 1, 3, keymap_handle_key);
	assert_string_not_equal(t->picker.folder.path, "");
}

static void
safe_lists_no_files(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	stage->desk->session->safe = true;
	static const char *const KEYS_THERE[] = {"o", "Enter"};
	for (size_t i = 0; i < ARRAY_LEN(KEYS_THERE); i++) {
		t->message[0] = '\0';
		press(t, KEYS_THERE[i]);
		assert_false(t->picker.on);
		assert_non_null(strstr(t->message, "--safe"));
	}
}

/* Results of its own are no sheet to open, and come last. */
static void
results_in_a_workbook_are_no_sheet(void **state)
{
	(void)state;
	char folder[] = "/tmp/tipspeed-first-XXXXXX/";
	const size_t end = strlen(folder) - 1;
	void *desk;
	struct folder list;
	folder[end] = '\0';
	assert_non_null(mkdtemp(folder));
	FREED char *path = xasprintf("%s/a.xlsx", folder);
	FREED char *sheet = xasprintf("%s/b.csv", folder);
	FREED char *line = xasprintf(
	    TIERP_CALIBRATED "; predict 74 > %s; write %s", path, sheet);
	desk_open(&desk);
	desk_expect(desk, line);
	desk_close(&desk);
	folder[end] = '/';
	folder_list(&list, folder);
	unlink(path);
	unlink(sheet);
	rmdir(folder);
	assert_int_equal(list.n, 3);
	assert_string_equal(list.item[0].name, "b.csv");
	assert_string_equal(list.item[2].name, "a.xlsx");
	assert_string_equal(list.item[2].about, "results of predict");
	folder_free(&list);
}

static void
strange_files_are_looked_at_without_being_read(void **state)
{
	(void)state;
	char folder[] = "/tmp/tipspeed-first-XXXXXX", was[4096];
	struct folder list;
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	assert_int_equal(mkfifo("pipe.csv", 0600), 0);
	assert_int_equal(symlink("nowhere", "link.csv"), 0);
	fclose(fopen("empty.csv", "w"));
	fclose(fopen(".hidden.csv", "w"));
	fclose(fopen("a\"b.csv", "w"));
	fclose(fopen("big.csv", "w"));
	assert_int_equal(truncate("big.csv", 5000000), 0);
	FILE *results = fopen("a.csv", "w");
	fputs("command,size_mm,feed\npredict,8,100\n", results);
	fclose(results);
	folder_list(&list, "");
	assert_int_equal(list.n, 4);
	assert_string_equal(list.item[3].name, "a.csv");
	assert_string_equal(list.item[3].about, "results of predict");
	char *big = folder_item_preview_text(&list.item[0]);
	assert_int_equal(truncate("big.csv", 10000001), 0);
	char *refused = folder_item_preview_text(&list.item[0]);
	char *empty = folder_item_preview_text(&list.item[1]);
	char *command = folder_command_to_open(
	    &(struct folder_item){
		.name = (char *)"a=b.csv", .path = (char *)"a=b.csv"},
	    false);
	static const char *const NAMES[] = {"pipe.csv", "link.csv", "empty.csv",
	    ".hidden.csv", "a\"b.csv", "big.csv", "a.csv"};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++)
		unlink(NAMES[i]);
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
	assert_string_equal(
	    big, "large: not read for a preview; Enter loads it\n");
	assert_non_null(strstr(refused, "larger than the 10 MB"));
	assert_string_equal(empty, "an empty file\n");
	assert_string_equal(command, "load \"./a=b.csv\"");
	assert_string_equal(list.item[2].name, "..");
	free(big);
	free(refused);
	free(empty);
	free(command);
	folder_free(&list);
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    ON_STAGE(without_a_site_it_shows_what_can_be_done),
	    ON_STAGE(a_saved_session_is_restored),
	    ON_STAGE(a_sheet_is_opened_by_a_command_that_can_be_undone),
	    ON_STAGE(left_goes_to_the_folder_above),
	    ON_STAGE(without_a_site_all_keys_lead_to_a_sheet),
	    ON_STAGE(made_sites_need_no_installation),
	    ON_STAGE(enter_calibrates_what_was_read),
	    ON_STAGE(letters_narrow_the_list),
	    ON_STAGE(a_site_of_the_program_is_tried),
	    ON_STAGE(a_feed_fills_the_guess),
	    ON_STAGE(what_cannot_be_loaded_leaves_the_list_open),
	    ON_STAGE(the_mouse_chooses_and_opens),
	    ON_STAGE(safe_lists_no_files),
	    cmocka_unit_test(results_in_a_workbook_are_no_sheet),
	    cmocka_unit_test(strange_files_are_looked_at_without_being_read),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
