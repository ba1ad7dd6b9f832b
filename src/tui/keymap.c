/* Finds the action of each key and runs it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/keymap.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <curses.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/files.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/fit.h"
#include "cmd/fit/job.h"
#include "cmd/lang/parse.h"
#include "tui/acts.h"
#include "tui/widgets/dialog.h"
#include "tui/widgets/file_picker.h"
#include "tui/control.h"
#include "tui/widgets/goal.h"
#include "tui/pane.h"
#include "tui/widgets/list.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"
#include "tui/cmdline.h"
#include "tui/widgets/viewer.h"
#include "tui/watch.h"
#include "tui/word.h"

/* Lets the page or its list handle a key that moves.  On a page with the
 * response strip, the slider comes before the list.  Returns false if neither
 * handled it. */
static bool
handle_move_key_of_page_or_list(struct tui *t, const struct key *key)
{
	const struct page_ops *page = pages_current(t);
	bool slides = page->strip && key->act != act_move_in_list;
	return (page->move != NULL && (page->move)(t, key)) ||
	       (!slides && list_handle_move_key(t, key));
}

void
act_move_list_or_slider(struct tui *t, const struct key *key)
{
	if (handle_move_key_of_page_or_list(t, key))
		return;
	t->pending_key = NULL;
	tui_set_slider_position(t, tui_slider_position(t) + key->amount);
}

void
act_move_to_end(struct tui *t, const struct key *key)
{
	const struct slider_range range = tui_slider_range(t);
	if (handle_move_key_of_page_or_list(t, key))
		return;
	t->pending_key = NULL;
	tui_set_slider_position(
	    t, key->amount == TO_LEAST ? range.least : range.most);
}

void
act_move_in_list(struct tui *t, const struct key *key)
{
	handle_move_key_of_page_or_list(t, key);
}

void
act_move_slider_to_run_speed(struct tui *t, const struct key *key)
{
	const struct entry *entry = tui_current_site_entry(t);
	t->pending_key = NULL;
	if (entry == NULL)
		return;
	const struct site *site = entry->site;
	double speed = key->amount < 0   ? site->run[0].speed
		       : key->amount > 0 ? site->run[site->n_run - 1].speed
					 : site_middle_speed(site);
	tui_set_slider_speed(t, speed);
}

void
act_type_speed(struct tui *t, const struct key *key)
{
	edit_insert_or_erase_letter(&t->speed, key->code, false, SPEED_LETTERS);
}

void
act_open_page(struct tui *t, const struct key *key)
{
	pages_go_to(t, (enum page)key->amount);
}

static char *
default_file_name(const struct tui *t)
{
	return text_slug(tui_current_site_entry(t) != NULL
			     ? tui_current_site_entry(t)->key
			     : "session");
}

/* Proposes to save in the script that the session was saved in or, if there is
 * none, under an unused name. */
void
act_propose_save(struct tui *t, const struct key *key)
{
	(void)key;
	bool saved;
	const char *holder = files_session_script_path(t->session, &saved);
	FREED char *slug = default_file_name(t);
	FREED char *name = holder != NULL ? xasprintf("\"%s\"%s", holder,
						saved ? "" : " replace=on")
					  : xasprintf("%s.tip", slug);
	for (int i = 2; holder == NULL && access(name, F_OK) == 0; i++)
		xfree_and_set(&name, xasprintf("%s-%d.tip", slug, i));
	edit_begin_with_proposal(&t->line, "save ", name);
}

/* Proposes "tierp-74.0.xlsx", which a spreadsheet opens whatever its decimal
 * sign. */
void
act_propose_export(struct tui *t, const struct key *key)
{
	(void)key;
	const struct entry *entry = tui_current_site_entry(t);
	if (entry == NULL || !entry->has_params) {
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
		return;
	}
	FREED char *line = tui_command_at_slider(t),
		   *slug = default_file_name(t);
	bool in_rpm = answers_is_sheet_in_rpm(entry->site);
	FREED char *name = xasprintf("%s-%.*f.xlsx", slug, in_rpm ? 0 : 1,
	    answers_speed_in_sheet_unit(entry->site, tui_slider_speed(t)));
	xappend(&line, " > ");
	edit_begin_with_proposal(&t->line, line, name);
}

void
act_open_command_line(struct tui *t, const struct key *key)
{
	(void)key;
	t->message[0] = '\0';
	edit_begin(&t->line, "");
}

void
act_run_hint_command(struct tui *t, const struct key *key)
{
	cmdline_run_line(t, key->hint);
}

void
act_describe_plot(struct tui *t, const struct key *key)
{
	char *(*words)(const struct tui *) = pages_current(t)->words;
	FREED char *of =
	    words != NULL ? words(t) : pane_curves_plot_arguments(t);
	FREED char *line = xasprintf("%s %s", key->hint, of);
	cmdline_run_line(t, line);
}

/* Goes to the next choice of runs that correct the answer. */
void
act_next_correction_setting(struct tui *t, const struct key *key)
{
	(void)key;
	static const char *const SAID[] = {
	    [CORRECTION_ALL] =
		N_("all runs correct the answer now: u undoes this"),
	    [CORRECTION_TRAIN] = N_(
		"only the training runs correct the answer now: u undoes this"),
	    [CORRECTION_OFF] = N_("no run corrects the answer now; it is the "
				  "model's: u undoes this")};
	static const char *const NEXT[] = {[CORRECTION_ALL] = "train",
	    [CORRECTION_TRAIN] = "off",
	    [CORRECTION_OFF] = "all"};
	FREED char *line =
	    xasprintf("set correction %s", NEXT[t->session->set.correction]);
	cmdline_run_line(t, line);
	if (!t->failed && t->viewer.text == NULL)
		tui_set_message(
		    t, false, "%s", tr(SAID[t->session->set.correction]));
}

/* Asks before a calibration replaces parameters.  Returns true if it may. */
static bool
confirm_replace_params(struct tui *t)
{
	struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	if (!entry->has_params)
		return true;
	FREED char *asks = xasprintf(
	    entry->has_fit ? tr("%s is calibrated: calibrate it again?")
			   : tr("%s has parameters: replace them by a "
				"calibration?"),
	    entry->key);
	bool yes = s->hooks.confirm(s, asks, false);
	if (!yes)
		tui_set_message(t, false,
		    entry->has_fit
			? N_("not calibrated again: the parameters stay")
			: N_("not calibrated: the parameters stay"));
	return yes;
}

void
act_calibrate(struct tui *t, const struct key *key)
{
	(void)key;
	if (tui_current_site_entry(t) == NULL) {
		tui_set_message(t, true, TUI_NO_SITE);
		return;
	}
	const struct session *s = t->session;
	if (session_is_calibrating(s) && !s->job.type->alone) {
		tui_set_message(t, false,
		    "several calibrations are running: s stops them, then f "
		    "calibrates this site");
		return;
	}
	if (!confirm_replace_params(t))
		return;
	pages_go_to(t, PAGE_FIT);
	tui_stop_fit(t);
	control_run_command_captured(t, "calibrate");
}

/* Pauses or continues the calibration, or continues one that was stopped. */
void
act_toggle_calibration_pause(struct tui *t, const struct key *key)
{
	(void)key;
	const struct session *s = t->session;
	if (session_is_calibrating(s)) {
		watch_set_fit_paused(t, !t->held);
		tui_set_message(t, false,
		    t->held ? N_("paused: Space continues") : N_("continuing"));
	} else if (s->job.calibration != NULL) {
		control_run_command_captured(t, "continue");
	} else {
		tui_set_message(
		    t, false, "no calibration is running: f starts one");
	}
}

void
act_change_calibration_pace(struct tui *t, const struct key *key)
{
	int from = t->ui.pace == PACE_AUTO ? PACE_USUAL : t->ui.pace;
	t->ui.pace =
	    (int)pane_move_index_clamped((size_t)from, key->amount, PACE_COUNT);
	t->due = t->clock;
	if (t->ui.pace == PACE_AUTO)
		tui_set_message(
		    t, false, "pace: slower while the best improves fast");
	else if (t->ui.pace == PACE_FULL)
		tui_set_message(
		    t, false, "pace: as many generations as possible");
	else
		tui_set_message(t, false,
		    tr_n("pace: %g generation a second",
			"pace: %g generations a second",
			PACES[t->ui.pace] > 1 ? 2 : 1),
		    PACES[t->ui.pace]);
}

void
act_toggle_pin(struct tui *t, const struct key *key)
{
	(void)key;
	const struct numbers was = t->view.pinned;
	const bool pinned = was.site[0] != '\0';
	FREED char *where = tui_speed_and_feed_options(t),
		   *line = xasprintf("pin %s", where);
	FREED char *speed = answers_speed_text(
	    pinned ? tui_pinned_site(t) : tui_current_site(t),
	    pinned ? was.speed : tui_slider_speed(t), 1);
	if (!pinned && t->view.current.site[0] == '\0')
		tui_set_message(t, true, "%s", tui_why_no_prediction(t));
	else if (!control_run_command_captured(t, pinned ? "pin off" : line))
		; /* it has shown the error */
	else if (pinned)
		tui_set_message(t, false,
		    "unpinned %s at %s: u pins it again, x what is shown now",
		    was.site, speed);
	else
		tui_set_message(t, false,
		    session_is_calibrating(t->session)
			? N_("pinned %s at %s: go to another speed or "
			     "site; e exports both; from a running search, so "
			     "it is not saved")
			: N_("pinned %s at %s: go to another speed or "
			     "site; e exports both"),
		    t->view.pinned.site, speed);
}

void
act_toggle_band(struct tui *t, const struct key *key)
{
	(void)key;
	const struct entry *entry = tui_current_site_entry(t);
	t->ui.band = !t->ui.band;
	if (!t->ui.band)
		tui_set_message(t, false, "band off");
	else if (t->view.shown.low != NULL)
		tui_set_message(
		    t, false, "band on; the line hides it where thin");
	else if (t->view.current.site[0] != '\0')
		tui_set_message(t, false,
		    t->session->set.correction == CORRECTION_OFF ||
			    (entry->has_fit &&
				fit_has_too_few_data(&entry->fit))
			? "%s"
			: N_("%s; f calibrates"),
		    band_why_missing(t->session, entry));
}

void
act_stop_fit(struct tui *t, const struct key *key)
{
	(void)key;
	if (session_is_calibrating(t->session))
		tui_stop_fit(t);
	else
		tui_set_message(t, false, "no calibration to stop: q quits");
}

void
act_toggle_mouse(struct tui *t, const struct key *key)
{
	(void)key;
	bool on = !t->mouse && screen_set_mouse(true);
	if (t->mouse)
		screen_set_mouse(false);
	tui_set_message(t, false,
	    on         ? N_("mouse on: Shift-drag selects text")
	    : t->mouse ? N_("mouse off: drag selects text, M turns it on")
		       : N_("this terminal has no mouse"));
	t->mouse = on;
}

/* Esc: goes back one step. */
void
act_go_back(struct tui *t, const struct key *key)
{
	(void)key;
	bool predict = t->ui.page == PAGE_PREDICT;
	if (t->pending_key != NULL) {
		t->pending_key = NULL;
		return;
	}
	if (list_clear_filter(t))
		return;
	if (session_is_calibrating(t->session) && !t->session->job.fits)
		tui_stop_fit(t);
	else if (goal_is_viewed(t))
		t->ui.goal_view = false;
	else if (predict && t->ui.crosshair)
		act_toggle_crosshair(t, key);
	else if (predict && t->ui.runs)
		t->ui.runs = false;
	else if (!predict)
		pages_go_to(t, PAGE_PREDICT);
	else
		tui_set_message(
		    t, false, "there is nothing to go back to: q quits");
}

void
act_open_file_picker(struct tui *t, const struct key *key)
{
	(void)key;
	file_picker_open(t, PICK_FILES);
}

void
act_redraw_screen(struct tui *t, const struct key *key)
{
	(void)t, (void)key;
	screen_resize();
}

/* Leaves the rest to the loop of the screen, which handles the signal. */
void
act_suspend_program(struct tui *t, const struct key *key)
{
	(void)t, (void)key;
	raise(SIGTSTP);
}

void
act_leave_screen(struct tui *t, const struct key *key)
{
	(void)key;
	t->leave = true;
}

/* Runs the action of a key; does nothing for NULL. */
static void
run_key_action(struct tui *t, const struct key *key)
{
	if (key == NULL)
		return;
	if (key->where & AT_SPEED)
		track_run_pending_key(t, true);
	key->act(t, key);
}

static bool
handle_goal_field_key(struct tui *t, int code, bool special)
{
	FREED char *line = goal_edit_field_by_key(t, code, special);
	if (line != NULL && control_run_command_captured(t, line) &&
	    !goals_is_set(t->session))
		tui_set_message(t, false, "no goal any more: u brings it back");
	return true;
}

static bool
handle_command_line_key(struct tui *t, int code, bool special)
{
	struct edit *y = &t->line;
	enum edit_result result = edit_handle_key(y, t->session, code, special);
	if (result == EDIT_ON)
		return true;
	edit_stop_editing(y);
	t->message[0] = '\0';
	if (result == EDIT_DONE)
		cmdline_run_line(t, y->text);
	return true;
}

/* Lets the text on the screen handle a key.  In the list of keys, Enter runs
 * the chosen key. */
static bool
handle_viewer_key(struct tui *t, int code, bool special)
{
	const struct key *run = NULL;
	bool took = viewer_handle_key(t, code, special, &run);
	if (took)
		run_key_action(t, run);
	return took;
}

/* Returns true if a key continues the typed speed.  After "=" a unit may be
 * typed as well: "72.5 m/s" or "1450 rpm". */
static bool
is_letter_of_typed_speed(const struct edit *y, int code)
{
	static const char UNITS[] = " rpm/s";
	bool unit = y->text[0] == '=' && y->n > 1 && code > 0 && code < 128 &&
		    strchr(UNITS, code) != NULL;
	return y->n < SPEED_LETTERS &&
	       (code == '.' || (code >= '0' && code <= '9') || unit);
}

static void
move_slider_to_typed_speed(struct tui *t, const char *text)
{
	double rotor = tui_rotor_diameter(t), v = NAN;
	bool said = strstr(text, "rpm") != NULL;
	bool read = value_parse_number(text, said ? "rpm" : "m/s", &v);
	/* A number above SITE_FASTEST must be rpm: no tip speed is as high. */
	bool turns = said || v > SITE_FASTEST;
	double speed = turns && rotor > 0
			   ? site_speed_from_rpm(tui_current_site(t), v, rotor)
			   : v;
	if (!read)
		tui_set_message(t, true,
		    "expected a speed such as 72.5 or 1450 rpm, got %s", text);
	else if (turns && !(rotor > 0))
		tui_set_message(t, true,
		    "the rotor's diameter is not known: type m/s, or state it "
		    "in the sheet as rotor_mm");
	else if (speed < 1 || speed > SITE_FASTEST)
		tui_set_message(t, true,
		    "expected a speed from 1 to %d m/s, got %s", SITE_FASTEST,
		    text);
	else if (slider_has_speed(tui_slider_range(t), speed))
		tui_set_slider_speed(t, speed);
	else
		control_report_speed_off_slider(t, speed);
}

/* Handles a key of a typed speed, which begins with = or a digit. */
static bool
handle_typed_speed_key(struct tui *t, int code, bool special)
{
	struct edit *y = &t->speed;
	bool back = code == DELETE || code == '\b';
	/* A digit that opens a page begins none: 50 to 59 m/s need the =. */
	if (y->n == 0 && (code < '0' || code > '9' ||
			     keys_find_by_code(code, t->ui.page) != NULL))
		return false;
	if (code == ',')
		code = '.';
	if (back || (!special && is_letter_of_typed_speed(y, code)))
		return edit_insert_or_erase_letter(
		    y, code, special, SPEED_LETTERS);
	/* Behind "=" no letter is meant as a key of the page. */
	if (!special && y->text[0] == '=' && code >= ' ')
		return true;
	if (code == '\n' || code == '\r') {
		const char *text = y->text + (y->text[0] == '=');
		if (*text != '\0')
			move_slider_to_typed_speed(t, text);
	}
	edit_begin(y, "");
	return code == '\n' || code == '\r' || code == ESCAPE;
}

/* Handles a mouse action.  A click ends the typing of a speed, except a click
 * on its own hints.  While a line is typed, only its own areas can be
 * clicked. */
static void
handle_mouse_action(struct tui *t, enum hit_kind kind, int row, int column)
{
	const struct hit *at = hits_find_area_at(&t->hits, row, column);
	bool own = at != NULL && (at->code == '\n' || at->code == ESCAPE);
	if (kind == HIT_PRESS && !own)
		edit_begin(&t->speed, "");
	if (kind == HIT_PRESS && !t->line.active && t->viewer.text == NULL)
		t->message[0] = '\0';
	hits_dispatch_mouse(t, &t->hits, kind, row, column, keymap_handle_key);
}

static void
dispatch_curses_mouse_event(struct tui *t,
    void (*touched)(struct tui *t, enum hit_kind kind, int row, int column))
{
	MEVENT e;
	if (getmouse(&e) != OK)
		return;
	if (e.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED))
		touched(t, HIT_PRESS, e.y, e.x);
	else if (e.bstate & (BUTTON4_PRESSED | BUTTON5_PRESSED))
		touched(t, e.bstate & BUTTON4_PRESSED ? HIT_UP : HIT_DOWN, e.y,
		    e.x);
	else if (e.bstate & REPORT_MOUSE_POSITION)
		touched(t, HIT_DRAG, e.y, e.x);
	if (e.bstate & (BUTTON1_RELEASED | BUTTON1_CLICKED))
		hits_end_drag(&t->hits);
}

/* The next input_read_next_key returns this key. */
static void
put_key_back(struct tui *t, int code, bool special)
{
	t->put_back.is = true;
	t->put_back.code = code;
	t->put_back.special = special;
}

static void
on_mouse_in_question(struct tui *t, enum hit_kind kind, int row, int column)
{
	hits_dispatch_mouse(t, &t->hits, kind, row, column, put_key_back);
}

void
keymap_handle_question_mouse(struct tui *t)
{
	dispatch_curses_mouse_event(t, on_mouse_in_question);
}

static bool
handle_page_key(struct tui *t, int code, bool special)
{
	const struct key *key = keys_find_by_code(code, t->ui.page);
	if (word_hold_letter_until_next_key(t, code, special, key))
		return true;
	run_key_action(t, key);
	if (key == NULL && code > ' ' && code < DELETE)
		tui_set_message(
		    t, false, "this key has no function: ? lists the keys");
	return true;
}

static bool
handle_dialog_answer_key(struct tui *t, int code, bool special)
{
	dialog_handle_key(t, code, special);
	return true;
}

/* The modes that take keys, the topmost first.  Each function returns false for
 * a key that it leaves to the next mode.  The keys of a QUESTION, yes and no,
 * are read elsewhere. */
enum mode { ANSWER, QUESTION, GOAL, LINE, TEXT, FILES, FILTER, SPEED, PAGE };
static bool (*const MODES[])(struct tui *t, int code, bool special) = {
    [ANSWER] = handle_dialog_answer_key,
    [QUESTION] = NULL,
    [GOAL] = handle_goal_field_key,
    [LINE] = handle_command_line_key,
    [TEXT] = handle_viewer_key,
    [FILES] = file_picker_handle_key,
    [FILTER] = list_handle_filter_key,
    [SPEED] = handle_typed_speed_key,
    [PAGE] = handle_page_key};

static enum mode
find_active_input_mode(const struct tui *t, enum mode from)
{
	const bool open[] = {[ANSWER] = t->inquiry != NULL,
	    [QUESTION] = t->question != NULL,
	    [GOAL] = t->line.active && t->goal_field,
	    [LINE] = t->line.active,
	    [TEXT] = t->viewer.text != NULL,
	    [FILES] = t->picker.on,
	    [FILTER] = t->filter.active,
	    [SPEED] = true,
	    [PAGE] = true};
	while (!open[from])
		from++;
	return from;
}

bool
keymap_is_typed_as_text(const struct tui *t, int code)
{
	switch (find_active_input_mode(t, ANSWER)) {
	case ANSWER:
	case GOAL:
	case LINE:
	case FILTER:
		return true;
	case TEXT:
		return t->viewer.word.active;
	case SPEED:
		return t->speed.n > 0 && is_letter_of_typed_speed(&t->speed,
					     code == ',' ? '.' : code);
	default:
		return false;
	}
}

void
keymap_open_command_line(struct tui *t)
{
	if (find_active_input_mode(t, ANSWER) == SPEED && t->speed.n == 0)
		act_open_command_line(t, NULL);
}

void
keymap_run_delayed_key(struct tui *t)
{
	run_key_action(t, word_pop_delayed_key(t));
}

/* Runs the held key before the key `code`.  It may ask a question, such as
 * whether to calibrate again, and the question then reads `code` as its answer.
 * Returns true if that was read. */
static bool
run_delayed_key_before(struct tui *t, int code, bool special)
{
	put_key_back(t, code, special);
	keymap_run_delayed_key(t);
	bool read = !t->put_back.is;
	t->put_back.is = false;
	return read;
}

void
keymap_handle_key(struct tui *t, int code, bool special)
{
	if (word_open_line_on_two_keys(t, code, special) ||
	    run_delayed_key_before(t, code, special))
		return;
	if (special && (code == KEY_ENTER || code == KEY_BACKSPACE)) {
		code = code == KEY_ENTER ? '\n' : DELETE;
		special = false;
	}
	/* A character beyond ASCII is not a key, though its code may equal that
	 * of one. */
	enum mode mode = find_active_input_mode(t, ANSWER);
	if (!special && code > DELETE && mode != FILES &&
	    !keymap_is_typed_as_text(t, code))
		return;
	const struct key *key = keys_find_by_code(code, t->ui.page);
	if (special && code == KEY_MOUSE) {
		dispatch_curses_mouse_event(t, handle_mouse_action);
		return;
	}
	if (key != NULL && (key->act == act_suspend_program ||
			       key->act == act_redraw_screen)) {
		run_key_action(t, key);
		return;
	}
	/* A message stays until the next key, except a key that closes a text
	 * and leaves a message. */
	if (mode >= FILTER)
		t->message[0] = '\0';
	while (MODES[mode] != NULL && !MODES[mode](t, code, special))
		mode = find_active_input_mode(t, mode + 1);
}
