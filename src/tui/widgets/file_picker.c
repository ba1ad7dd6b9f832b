/* Lists and previews files, and composes the command that opens the chosen one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/file_picker.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/units.h"
#include "tui/acts.h"
#include "tui/control.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/watch.h"
#include "tui/widgets/list.h"

static void
free_file_preview(struct picker *c)
{
	xfree_and_set(&c->preview, NULL);
	c->previewed = SIZE_MAX;
}

static void
list_files_in_folder(struct picker *c, const char *path)
{
	FREED char *copy = xstrdup(path);
	edit_begin(&c->word, "");
	folder_free(&c->folder);
	if (c->what == PICK_SHIPPED)
		folder_list_shipped_sites(&c->folder);
	else
		folder_list(&c->folder, copy);
	if (c->what == PICK_FEEDS || c->what == PICK_SESSIONS)
		folder_filter_by_kind(&c->folder,
		    1U << FOLDER_ABOVE | 1U << FOLDER_BELOW |
			1U << (c->what == PICK_FEEDS ? FOLDER_SHEET
						     : FOLDER_SESSION));
	c->list = (struct list){0};
	free_file_preview(c);
}

static void
close_file_picker(struct tui *t)
{
	folder_free(&t->picker.folder);
	free_file_preview(&t->picker);
	t->picker = (struct picker){0};
}

/* Types a guess command, with the cursor where something is missing that the
 * sheet does not state. */
static void
prefill_line_with_guess_command(struct tui *t)
{
	static const char BEGIN[] = "guess rock=";
	const struct site *site = tui_current_site_entry(t)->site;
	const char *quote = strchr(site->rock, ' ') != NULL ? "\"" : "";
	FREED char *line =
	    xasprintf("%s%s%s%s", BEGIN, quote, site->rock, quote);
	if (site->top_size > 0)
		xappend(&line, " top=%g", units_m_to_mm(site->top_size));
	edit_begin(&t->line, line);
	if (site->rock[0] == '\0') {
		t->line.at = strlen(BEGIN);
		tui_set_message(t, false,
		    "type the rock, say granite, and Enter: the sheet does not "
		    "state it");
	}
}

/* Runs the command that opens a file, and says what to do next.  estimates: the
 * sheet was chosen for its feed.  Returns true if a site is loaded. */
static bool
run_line_that_opens_file(struct tui *t, const char *line, bool estimates)
{
	const size_t before = t->session->n_entry;
	const char *stopped = tui_stop_fit(t);
	bool ok = control_run_command_captured(t, line);
	const struct entry *entry = tui_current_site_entry(t);
	if (!ok || entry == NULL) {
		tui_append_to_message(t, stopped);
		return false;
	}
	size_t products = site_count_products(entry->site);
	FREED char *label = session_site_label(entry->site);
	if (estimates || products == 0)
		prefill_line_with_guess_command(t);
	else if (!entry->has_params)
		tui_set_message(t, false,
		    t->session->n_entry > before
			? N_("loaded %s: press f to calibrate")
			: N_("replaced %s, loaded earlier: press f to "
			     "calibrate, u to undo"),
		    label);
	tui_append_to_message(t, stopped);
	return true;
}

static void
open_chosen_file(struct tui *t)
{
	struct picker *c = &t->picker;
	if (c->folder.n == 0)
		return;
	const struct folder_item *item = &c->folder.item[c->list.at];
	if (item->kind == FOLDER_ABOVE || item->kind == FOLDER_BELOW) {
		FREED char *into = folder_path_of_item(&c->folder, c->list.at);
		list_files_in_folder(c, into);
		return;
	}
	FREED char *line =
	    folder_command_to_open(item, c->what == PICK_SESSIONS);
	if (run_line_that_opens_file(t, line, c->what == PICK_FEEDS))
		close_file_picker(t);
}

static size_t
count_listed_files(const struct tui *t)
{
	return t->picker.folder.n;
}

static void
clear_message_on_file_choice(struct tui *t)
{
	t->message[0] = '\0';
}

static char *
file_row_text(const struct tui *t, size_t i)
{
	const struct folder_item *item = &t->picker.folder.item[i];
	return xasprintf(
	    "%s\n%s", item->name, item->about != NULL ? item->about : "");
}

/* Reads the chosen file for its preview, once. */
static void
update_file_preview(struct tui *t)
{
	struct picker *c = &t->picker;
	if (c->folder.n == 0 || c->previewed == c->list.at)
		return;
	free_file_preview(c);
	c->preview = folder_item_preview_text(&c->folder.item[c->list.at]);
	c->previewed = c->list.at;
}

static const struct page_list FILES = {.n = count_listed_files,
    .text = file_row_text,
    .chosen = clear_message_on_file_choice,
    .open = open_chosen_file,
    .update = update_file_preview};

void
file_picker_open(struct tui *t, enum picker_list what)
{
	if (t->session->safe) {
		tui_set_message(t, true,
		    "files are not opened with --safe: start the program "
		    "without it");
		return;
	}
	close_file_picker(t);
	t->message[0] = '\0';
	t->picker.on = true;
	t->picker.rows = &FILES;
	t->picker.what = what;
	list_files_in_folder(&t->picker, "");
}

static void
go_to_folder_above(struct tui *t)
{
	struct picker *c = &t->picker;
	if (c->word.n > 0)
		list_files_in_folder(c, c->folder.path);
	for (size_t i = 0; i < c->folder.n; i++)
		if (c->folder.item[i].kind == FOLDER_ABOVE) {
			c->list.at = i;
			open_chosen_file(t);
			return;
		}
}

/* Handles a key that adds a letter to the filter or deletes one.  Returns false
 * for other keys.  A letter is refused if no name then matches. */
static bool
handle_file_filter_key(struct tui *t, int code, bool special)
{
	struct picker *c = &t->picker;
	bool back = code == DELETE || code == '\b' || code == ESCAPE,
	     letter = code > DELETE || isalnum(code) || strchr("._- ", code);
	if (special || code == '\0' || (back ? c->word.n == 0 : !letter))
		return false;
	t->message[0] = '\0';
	c->list = (struct list){0};
	if (code == ESCAPE)
		list_clear_filter(t);
	else
		list_handle_filter_key(t, code, false);
	if (list_count_matching_rows(t) == 0) {
		FREED char *word = xstrdup(c->word.text);
		list_handle_filter_key(t, DELETE, false);
		tui_set_message(t, false, "nothing here has '%s'", word);
	}
	return true;
}

bool
file_picker_handle_key(struct tui *t, int code, bool special)
{
	if (handle_file_filter_key(t, code, special))
		return true;
	const struct key *key = keys_find_by_code(code, t->ui.page);
	key_action *act = key != NULL ? key->act : NULL;
	bool aside = act == act_move_list_or_slider && abs(key->amount) == STEP;
	bool moves =
	    !aside && (act == act_move_list_or_slider ||
			  act == act_move_to_end || act == act_move_in_list);
	if (moves)
		t->message[0] = '\0';
	if (code == '\n' || code == '\r' || (aside && key->amount > 0))
		open_chosen_file(t);
	else if (code == DELETE || code == '\b' || aside)
		go_to_folder_above(t);
	else if (!moves || !list_handle_move_key(t, key)) {
		close_file_picker(t);
		return code == ESCAPE || code == INTERRUPT;
	}
	return true;
}

static void
draw_file_row(struct tui *t, const struct area *line, size_t i, unsigned look,
    const void *of)
{
	(void)of;
	enum { NAME = 16 };
	const struct folder_item *item = &t->picker.folder.item[i];
	bool folder = item->kind == FOLDER_BELOW || item->kind == FOLDER_ABOVE;
	if (look == LOOK_PLAIN && item->kind >= FOLDER_OTHER)
		look = LOOK_DIM;
	if (item->kind == FOLDER_RESULTS || item->kind == FOLDER_SESSION)
		screen_draw_text(
		    line, 0, 1, look, "%s  %s", item->name, item->about);
	else if (item->about == NULL)
		screen_draw_text(
		    line, 0, 1, look, "%s%s", item->name, folder ? "/" : "");
	else
		screen_draw_text(line, 0, 1, look, "%-*.*s%s", NAME,
		    (int)(strrchr(item->name, '.') - item->name), item->name,
		    item->about);
}

static void
draw_picker_title(const struct tui *t, const struct area *area)
{
	const struct picker *c = &t->picker;
	const char *folder =
	    c->folder.path[0] != '\0' ? c->folder.path : tr("this folder");
	int column = screen_draw_text(area, 0, 0, LOOK_BOLD,
	    c->what == PICK_FEEDS      ? N_("sheet with a feed, in %s")
	    : c->what == PICK_SESSIONS ? N_("saved sessions, in %s")
	    : c->what == PICK_SHIPPED  ? N_("sites that come with tipspeed, %s")
				       : N_("open a sheet, in %s"),
	    folder);
	if (c->word.n > 0)
		screen_draw_text(area, 0, column, 0, ": containing '%s', %zu",
		    c->word.text, list_count_matching_rows(t));
	else if (c->folder.why != NULL)
		screen_draw_text(area, 0, column, 0, ": %s", c->folder.why);
	else if (c->folder.more)
		screen_draw_text(
		    area, 0, column, 0, ": the first %zu", c->folder.n);
}

/* Draws the message over the hints and, if it needs two rows, the row above. */
static void
file_picker_draw_message(const struct tui *t)
{
	struct area area = t->layout.hints;
	FREED char *text = xasprintf("%s%s", t->bad ? "! " : "", t->message);
	if (text_width_in_columns(text) > area.columns && area.row > 1) {
		area.row--;
		area.rows++;
	}
	screen_clear_area(&area);
	screen_draw_wrapped(&area, 0, LOOK_BOLD, text);
}

/* The preview is beside the list or, on a narrow screen, below it. */
void
file_picker_draw(struct tui *t)
{
	enum { WIDE = 72, TALL = 10, LIST = 60 };
	struct area list = t->layout.body, preview = {0},
		    title = area_cut_off_edge(
			&list, EDGE_TOP, list.rows > 2 ? 1 : 0);
	bool shipped = t->picker.what == PICK_SHIPPED;
	int half = list.columns / 2;
	if (title.rows > 0)
		draw_picker_title(t, &title);
	if (list.columns >= WIDE + (shipped ? LIST - WIDE / 2 : 0)) {
		preview = list;
		list = area_cut_off_edge(
		    &preview, EDGE_LEFT, shipped || half >= LIST ? LIST : half);
		screen_draw_vertical_rule(list.row, list.columns, list.rows);
		area_cut_off_edge(&preview, EDGE_LEFT, 2);
	} else if (t->layout.body.rows >= TALL) {
		preview = area_cut_off_edge(&list, EDGE_FOOT, list.rows / 2);
	}
	list_draw_rows(t, &list, draw_file_row, NULL);
	if (t->picker.preview != NULL)
		pane_draw_text_lines(&preview, 0, t->picker.preview);
	if (t->message[0] != '\0') {
		file_picker_draw_message(t);
		return;
	}
	pane_draw_key_hints(
	    t, t->picker.word.n > 0 ? N_("Esc all  Enter opens it  Up/Down")
	       : shipped
		   ? N_("Esc back  Enter opens it  Up/Down  letters narrow the "
			"list")
		   : N_("Esc back  Enter opens it  Up/Down  Left folder above  "
			"letters narrow the list"));
}
