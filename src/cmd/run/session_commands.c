/* Commands about the session as a whole: set, seed, drop, reset, save, restore,
 * undo, redo, echo, timing, tui.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/energies.h"
#include "cmd/session/sites.h"
#include "cmd/session/files.h"
#include "cmd/ask/blended.h"
#include "cmd/ask/goals.h"
#include "cmd/fit/job.h"
#include "cmd/session/journal.h"
#include "cmd/session/autosave.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/session/script.h"
#include "cmd/session/settings.h"
#include "cmd/lang/table.h"
#include "cmd/session/invocation.h"
#include "cmd/session/undo.h"
#include "config.h"
#include "core/model/breakage.h"
#include "io/fs/file.h"

bool
cmd_drop(struct session *s, const struct args *args, struct error *error)
{
	size_t index;
	if (!session_find_site(s, args->operand[0], &index, error))
		return false;
	session_print_note(s, "dropped %s", s->entry[index].key);
	session_remove_site(s, index);
	return true;
}

/* Clears all that was loaded and set, except for these settings. */
static void
reset_session(struct session *s, const struct settings *choices)
{
	session_discard_paused_job(s);
	entries_free(s->entry, s->n_entry);
	s->entry = NULL;
	s->log = NULL;
	s->spec = NULL;
	s->pin = NULL;
	s->energy = NULL;
	s->n_entry = s->current = 0;
	s->last_asked = (struct last_asked){0};
	s->set = *choices;
	session_remove_answers(s);
	journal_discard_all_lines(s);
}

bool
cmd_reset(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	reset_session(s, s->initial);
	journal_add_settings(s);
	return true;
}

/* Begins with the defaults, because the script itself sets what the command
 * line had set when it was saved. */
static bool
restore_session_from_script(
    struct session *s, const char *path, struct error *error)
{
	struct settings plain = settings_default();
	if (!script_open(s, path, error))
		return false;
	reset_session(s, &plain);
	return true;
}

/* Returns the name as typed, with .tip if it has no ending, unless it is a
 * device or pipe: nobody means a file beside /dev/full.  The caller frees
 * it. */
static char *
add_script_ending(const char *typed)
{
	struct stat about;
	const char *name = file_name_without_folders(typed);
	bool bare = name[0] != '\0' && strchr(name, '.') == NULL;
	bool device = stat(typed, &about) == 0 && !S_ISREG(about.st_mode) &&
		      !S_ISDIR(about.st_mode);
	return xasprintf("%s%s", typed, bare && !device ? ".tip" : "");
}

bool
cmd_restore(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0)
		return autosave_show_sessions(s);
	const char *typed = args->operand[0];
	bool last = strcmp(typed, "last") == 0;
	FREED char *path = last                 ? autosave_newest_path(s, error)
			   : file_exists(typed) ? xstrdup(typed)
						: add_script_ending(typed);
	if (!last)
		s->invocation->saved = true;
	bool ok = path != NULL && restore_session_from_script(s, path, error);
	if (ok && !last)
		files_set_session_script_path(s, path, false);
	return ok;
}

bool
cmd_echo(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	FREED char *text = xstrdup("");
	for (size_t i = 0; i < args->n_operand; i++)
		xappend(&text, i > 0 ? " %s" : "%s", args->operand[i]);
	if (s->set.format == ANSWER_JSON) {
		struct answer *r = answer_new("echo");
		fields_put_values(answer_json_fields(r), "text %s", text);
		session_show_answer(s, r);
	} else {
		text_print_escaped(text, s->out);
		fputc('\n', s->out);
	}
	return true;
}

bool
cmd_timing(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	s->set.timing = args->state;
	return true;
}

bool
cmd_tui(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO))
		return error_set(error, ERROR_USAGE,
		    "tui: expected a terminal for input and output\n"
		    "use 'predict' without one");
	s->wants_tui = true;
	return true;
}

static bool
show_settings(struct session *s)
{
	struct answer *r = answer_new("set");
	answer_add_columns(r, "setting, value");
	for (const struct command_option *row = SETTINGS; row->name != NULL;
	     row++) {
		FREED char *text = settings_value_text(row, &s->set);
		answer_add_cells(r, "%s %s", row->name, text);
	}
	return session_show_answer(s, r);
}

/* Returns false with an error for texts that cannot be parsed, and for speeds
 * that are no range.  No feed has to cover a goal's sizes yet. */
static bool
check_setting_value(struct session *s, const struct command_option *row,
    const struct value *value, struct error *error)
{
	struct condition_list list = {0};
	struct quantity q;
	size_t n_value;
	bool text = row->kind == VALUE_TEXT ||
		    (row->kind == VALUE_FEED && value_is_file(row, value));
	if (row->kind == VALUE_NUMBERS && value->n > 0 &&
	    value->list[0] >= value->list[value->n - 1])
		return error_set(error, ERROR_USAGE,
		    "%s: expected two speeds, the slower one first, got '%s'\n"
		    "for instance: set %s 20..120",
		    row->name, value->text, row->name);
	if (!text || strcmp(value->text, SETTINGS_NONE) == 0)
		return true;
	if (strlen(value->text) >= SETTINGS_TEXT)
		return error_set(error, ERROR_USAGE,
		    "%s: expected %d letters at most", row->name,
		    SETTINGS_TEXT - 1);
	if (row->offset == offsetof(struct settings, feed))
		return blended_read_feed_setting(s, value->text, error) != NULL;
	if (row->offset == offsetof(struct settings, quantity))
		return quantities_parse_one(
		    value->text, &PARTITION_IDEAL, &q, error);
	bool ok = goals_parse(s, value->text, NULL, &list, &n_value, error);
	conditions_free(&list);
	return ok;
}

bool
cmd_set(struct session *s, const struct args *args, struct error *error)
{
	const struct settings was = s->set;
	bool any = false;
	for (size_t i = 0; SETTINGS[i].name != NULL; i++) {
		if (!args->value[i].given)
			continue;
		if ((SETTINGS[i].kind == VALUE_FILE &&
			!energies_use_file_in_model(
			    s, args->value[i].text, error)) ||
		    !check_setting_value(
			s, &SETTINGS[i], &args->value[i], error)) {
			s->set = was;
			return false;
		}
		settings_set_value(&SETTINGS[i], &args->value[i], &s->set);
		any = true;
	}
	if (!model_settings_are_same(&was.model, &s->set.model))
		session_remove_answers(s);
	/* Settings alone need no saving, but a goal does. */
	if (strcmp(was.goal, s->set.goal) != 0)
		journal_assign_state_number(s);
	/* This does not change the parameters of loaded sites. */
	if (s->set.model.breakage != was.model.breakage) {
		const struct bounds usual = bounds_default(was.model.breakage);
		if (memcmp(&usual, &s->set.bounds, sizeof usual) != 0)
			session_print_note(s,
			    "  the search bounds are now the defaults of %s",
			    BREAKAGES[s->set.model.breakage]->name);
		s->set.bounds = bounds_default(s->set.model.breakage);
	}
	return any || show_settings(s);
}

bool
cmd_seed(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	if (args_is_given(args, &args->seed)) {
		s->set.seed = args->seed;
		return true;
	}
	struct answer *r = answer_new("seed");
	answer_add_columns(r, "seed: seed");
	answer_add_text_cell(r, "%llu", (unsigned long long)s->set.seed);
	return session_show_answer(s, r);
}

/* A script to write, and its folder without links, or NULL. */
struct saved_script {
	const struct session *session;
	const char *folder;
};

static void
print_script_with_heading(const void *data, FILE *out)
{
	const struct saved_script *script = data;
	fprintf(out, "# A session of tipspeed %s, written by 'save'.\n",
	    PACKAGE_VERSION);
	journal_write_script(script->session, script->folder, out);
}

/* True if the script may be written: the file that this session was saved to
 * may be replaced without asking, the one that it was restored from only with
 * replace=on. */
static bool
may_overwrite_script(const struct session *s, const struct args *args,
    const char *path, struct error *error)
{
	bool saved;
	const char *holder = files_session_script_path(s, &saved);
	bool again = holder != NULL && strcmp(holder, path) == 0;
	if (!again)
		return files_may_overwrite(s, args, path, error);
	return file_check_writable(path, false, error) &&
	       (saved || files_check_replace(args, path, error));
}

static bool
save_session_as(struct session *s, const struct args *args, const char *path,
    struct error *error)
{
	FREED char *folder = file_real_folder(path);
	const struct saved_script script = {s, folder};
	if (!may_overwrite_script(s, args, path, error) ||
	    !journal_can_be_saved(s, error) ||
	    !file_replace_using_writer(
		path, FILE_SHARED, print_script_with_heading, &script, error))
		return false;
	files_set_session_script_path(s, path, true);
	s->invocation->saved = true;
	struct mark mark = journal_current_place(s);
	size_t n = mark.n - mark.start;
	session_print_note(s,
	    tr_n("wrote %s: %zu command", "wrote %s: %zu commands", n), path,
	    n);
	return true;
}

bool
cmd_save(struct session *s, const struct args *args, struct error *error)
{
	FREED char *path = add_script_ending(args->operand[0]);
	return text_ends_with(path, ".tip")
		   ? save_session_as(s, args, path, error)
		   : error_set(error, ERROR_USAGE,
			 "save: expected a name that ends in .tip, got '%s'\n"
			 "use > FILE to save results, write to save a site "
			 "file",
			 path);
}

/* Undoes or redoes a step by `where`.  A stopped calibration is kept only if
 * its site, with the fit that it gave it, is still there afterwards. */
static const char *
undo_or_redo(struct session *s, const char *(*where)(struct session *))
{
	struct entry held = {0};
	bool paused = s->job.paused;
	if (paused)
		held = s->entry[s->job.entry];
	const char *label = where(s);
	if (label == NULL)
		return NULL;
	for (size_t i = 0; i < s->n_entry && paused; i++) {
		if (s->entry[i].site != held.site ||
		    !fits_are_equal(&s->entry[i].fit, &held.fit))
			continue;
		s->job.entry = i;
		return label;
	}
	session_discard_paused_job(s);
	return label;
}

bool
cmd_undo(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (s->job.paused && s->job.held_back &&
	    s->job.undo_steps == undo_count_steps(s)) {
		session_discard_paused_job(s);
		return true;
	}
	const char *label = undo_or_redo(s, undo_last_step);
	if (label == NULL)
		return error_set(error, ERROR_USAGE, "nothing to undo");
	session_print_note(s, "undone: %s", label);
	return true;
}

bool
cmd_redo(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	const char *label = undo_or_redo(s, undo_redo_step);
	if (label == NULL)
		return error_set(error, ERROR_USAGE, "nothing to redo");
	session_print_note(s, "redone: %s", label);
	return true;
}
