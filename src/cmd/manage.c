/* What is loaded and set as a whole, and small things about the session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/journal.h"
#include "cmd/keep.h"
#include "cmd/script.h"
#include "cmd/settings.h"
#include "cmd/table.h"
#include "cmd/turn.h"

bool
cmd_drop(struct session *s, const struct args *args, struct error *error)
{
	size_t index;
	if (!session_find(s, args->operand[0], &index, error))
		return false;
	session_note(s, "dropped %s", s->entry[index].key);
	session_drop(s, index);
	return true;
}

/* Forgets all that was loaded and set. */
static void
forget_all(struct session *s, const struct choices *choices)
{
	session_let_go(s);
	entries_free(s->entry, s->n_entry);
	s->entry = NULL;
	s->n_entry = s->current = 0;
	s->set = *choices;
	session_forget(s);
	journal_restart(s);
}

bool
cmd_reset(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	forget_all(s, s->first);
	journal_settings(s);
	return true;
}

/* The script says by itself what the command line had set when it was saved. */
static bool
restore(struct session *s, const char *path, struct error *error)
{
	struct choices plain = settings_default();
	if (!script_open(s, path, error))
		return false;
	forget_all(s, &plain);
	return true;
}

bool
cmd_restore(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0)
		return keep_list(s);
	if (strcmp(args->operand[0], "last") != 0) {
		turn_saved(s);
		return restore(s, args->operand[0], error);
	}
	char *last = keep_last(s, error);
	bool ok = last != NULL && restore(s, last, error);
	free(last);
	return ok;
}

bool
cmd_echo(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	char *text = xstrdup("");
	for (size_t i = 0; i < args->n_operand; i++)
		xappend(&text, i > 0 ? " %s" : "%s", args->operand[i]);
	if (s->set.format == ANSWER_JSON) {
		struct answer *r = answer_new("echo");
		fields_put(answer_fields(r), "text %s", text);
		session_answer(s, r);
	} else {
		text_put(text, s->out);
		fputc('\n', s->out);
	}
	free(text);
	return true;
}

bool
cmd_timing(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct value *state = args_value(args, "state");
	s->set.timing = state->choice == 0;
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
