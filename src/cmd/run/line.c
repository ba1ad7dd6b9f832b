/* Runs command lines; creates and frees sessions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/run/line.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/xalloc.h"
#include "cmd/session/call_paths.h"
#include "cmd/session/energies.h"
#include "cmd/session/files.h"
#include "cmd/fit/job.h"
#include "cmd/session/journal.h"
#include "cmd/session/autosave.h"
#include "cmd/lang/parse.h"
#include "cmd/ask/blended.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/pin.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/condition_words.h"
#include "cmd/ask/question.h"
#include "cmd/run/speeds.h"
#include "cmd/session/script.h"
#include "cmd/session/invocation.h"
#include "cmd/session/undo.h"
#include "io/formats/plant_log.h"
#include "io/formats/spec.h"

struct session *
session_new(FILE *out, FILE *notes)
{
	struct session *s = xcalloc(1, sizeof *s);
	s->set = settings_default();
	s->isa = ISA_BEST;
	s->out = out;
	s->notes = notes;
	s->files = files_new();
	s->journal = journal_new();
	s->undo = undo_new();
	s->moved = moved_products_new();
	s->store = store_new(":memory:");
	return s;
}

void
session_free(struct session *s)
{
	if (s == NULL)
		return;
	session_abort_job(s);
	script_close_to_depth(s, 0);
	struct error stopped = {0};
	session_end_finished_commands(s, false, &stopped);
	autosave_end(s);
	question_free_cached_site(s);
	moved_products_free(s->moved);
	blended_free(s->fed);
	entries_free(s->entry, s->n_entry);
	for (size_t i = 0; i < s->n_site; i++)
		site_free(s->site[i]);
	free(s->site);
	for (size_t i = 0; i < s->n_log; i++)
		plant_log_free(s->logs[i]);
	free(s->logs);
	for (size_t i = 0; i < s->n_spec; i++)
		spec_free(s->specs[i]);
	free(s->specs);
	for (size_t i = 0; i < s->n_energies; i++)
		energies_free(s->energies[i]);
	free(s->energies);
	for (size_t i = 0; i < s->n_pin; i++)
		pin_free(s->pins[i]);
	free(s->pins);
	free(s->initial);
	files_free(s->files);
	session_remove_answers(s);
	free(s->answer);
	undo_free(s->undo);
	journal_free(s->journal);
	store_free(s->store);
	free(s);
}

/* Joins the words of "load belt cuts may.csv" if together they are the name of
 * a file, and none of them is by itself. */
static void
join_words_to_file_name(struct words *words)
{
	const struct command *command = words->command;
	size_t n = 1;
	if (command == NULL || (command->flags & COMMAND_FILES) == 0)
		return;
	while (n < words->n && strchr(words->text[n], '=') == NULL)
		n++;
	FREED char *whole = xstrdup("");
	for (size_t i = 1; i < n; i++) {
		if (call_path_length_of_file(words->text[i]) > 0)
			return;
		xappend_to_list(&whole, " ", "%s", words->text[i]);
	}
	if (n > 2 && call_path_length_of_file(whole) > 0)
		words_replace_by_one(words, 1, n - 1, whole);
}

/* Parses the words.  In a script, relative names of files to read are those
 * beside it, if they are there.  A quantity in the place of a command has a
 * hint of its own. */
static const struct command *
parse_call_of_script(struct session *s, struct words *words, struct place place,
    struct args *args, struct error *error)
{
	const struct command *command =
	    parse_command_words(words, place, args, error);
	if (words->command == NULL &&
	    quantities_is_beginning_of_text(words->text[0]))
		error_set_hint(error, "write: predict %s", words->typed);
	FREED char *folder = script_other_folder(s, place.file);
	if (command == NULL || folder == NULL ||
	    !call_paths_find_in_folder(s, args, words, folder))
		return command;
	args_free(args);
	return parse_command_words(words, place, args, error);
}

/* Runs the command.  Returns false with ERROR_STOPPED if the user interrupted
 * its answer, and then the command that runs this one, such as source, is
 * interrupted, too. */
static bool
run_command_function(
    struct session *s, const struct args *args, struct error *error)
{
	const struct command *command = args->command;
	bool cut = false, *outer = s->cut_short;
	s->cut_short = s->invocation->before == NULL ? &cut : NULL;
	bool ok = command->answer != NULL ? question_read_and_answer(
						s, args, command->answer, error)
					  : command->run(s, args, error);
	s->cut_short = outer;
	if (cut && outer != NULL)
		*outer = true;
	return cut ? error_set(error, ERROR_STOPPED, "interrupted") : ok;
}

static bool
run_command_words(struct session *s, struct words *words, struct place place,
    struct error *error)
{
	struct args args;
	join_words_to_file_name(words);
	if (!speeds_convert_from_rpm(s, words, place, error))
		return false;
	const struct command *command =
	    parse_call_of_script(s, words, place, &args, error);
	bool ok = command != NULL &&
		  (!(command->flags & COMMAND_NEEDS_SITE) ||
		      session_require_site(s, command->name, error)) &&
		  invocation_begin(s, &args, words, place, error);
	if (ok) {
		ok = run_command_function(s, &args, error);
		s->invocation->running = false;
		if (!ok || invocation_is_over(s))
			ok = invocation_end(s, ok, error);
	}
	args_free(&args);
	session_set_translation_by_format(s);
	if (!ok && error->line == 0 && strcmp(error->file, place.file) != 0)
		error_prefix_file_name(error, place.file, place.line,
		    error->column > 0 ? error->column : words->column[0]);
	return ok;
}

bool
session_run_line(struct session *s, const char *line, size_t from,
    const char *file, int number, size_t *next, struct error *error)
{
	struct place place = {.file = file,
	    .line = number,
	    .prompt = s->prompt && s->scripts <= s->typed_depth};
	size_t end = strlen(line), depth = s->scripts;
	*next = 0;
	if (!session_end_finished_commands(s, true, error))
		return false;
	while (from < end && !s->quit) {
		struct words words;
		bool ok = words_split_line(line, from, place, &words, error);
		speeds_join_words_to_list(s, &words);
		conditions_join_words(&words);
		if (ok && words.n > 0)
			ok = run_command_words(s, &words, place, error);
		from = words.next;
		place.column = words.reached_column;
		words_free(&words);
		if (!ok)
			return false;
		if (session_is_calibrating(s) || s->wants_tui ||
		    s->scripts > depth) {
			*next = from;
			return true;
		}
	}
	return true;
}
