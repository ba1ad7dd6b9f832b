/* The prompt, its signals and its lines.  Signals are unblocked only in pselect
 * at the prompt and while a command runs, so none interrupts readline or the
 * session in an inconsistent state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/repl.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <readline/readline.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/run/complete.h"
#include "cmd/run/next.h"
#include "cmd/session/script.h"
#include "config.h"
#include "io/fs/xdg.h"
#include "cli/batch.h"
#include "cli/manpage.h"
#include "cli/pager.h"
#include "cli/ask.h"
#include "cli/signals.h"
#include "cli/restore.h"
#include "cli/terminal.h"
#include "cli/history.h"

/* The state of the prompt, static because readline's callbacks cannot be passed
 * it.  before: the lines of a command that continues, joined.  given: how many
 * bytes fake_key_to_end_input has made up.  offer: what Return alone does now.
 * stage, site, history: of the step offered last, and the site and fit that it
 * was for.  declined: it was declined, and an empty line makes the offer again.
 * command: typed instead of yes or no, or NULL. */
static struct {
	struct session *session;
	char *before, *command;
	size_t given;
	struct next offer;
	int stage;
	bool declined;
	const struct site *site;
	const struct history *history;
} prompt;

/* Returns the length, in bytes, of what all candidates begin with. */
static size_t
shared_prefix_bytes(char **text, size_t n)
{
	size_t shared = strlen(text[0]);
	for (size_t i = 1; i < n; i++) {
		size_t same = text_shared_prefix_bytes(text[0], text[i]);
		shared = same < shared ? same : shared;
	}
	return shared;
}

/* Returns the text of a candidate that replaces readline's word, or NULL if the
 * two do not match.  from: where the candidate's word begins in the line;
 * start: where readline's word does. */
static char *
candidate_as_readline_word(
    const struct candidate *c, const char *line, long from, long start)
{
	const char *tail = c->append == '=' ? "=" : "";
	if (from >= start)
		return xasprintf("%.*s%s%s", (int)(from - start), line + start,
		    c->text, tail);
	size_t head = (size_t)(start - from);
	if (strncmp(c->text, line + from, head) != 0)
		return NULL;
	return xasprintf("%s%s", c->text + head, tail);
}

/* For readline: returns the completions of a word, or NULL.  The first element
 * is what all of them share. */
static char **
on_readline_complete(const char *text, int start, int end)
{
	(void)text;
	size_t before = strlen(prompt.before), n = 0;
	FREED char *line = xasprintf("%s%s", prompt.before, rl_line_buffer);
	struct completion *c = find_completions_at_cursor(
	    prompt.session, line, before + (size_t)end);
	char **matches = xcalloc(c->n + 2, sizeof *matches);
	for (size_t i = 0; i < c->n; i++) {
		char *word = candidate_as_readline_word(&c->candidate[i], line,
		    (long)c->start, (long)before + start);
		if (word != NULL)
			matches[++n] = word;
	}
	rl_attempted_completion_over = 1;
	rl_completion_append_character =
	    n == 1 && c->candidate[0].append == ' ' ? ' ' : '\0';
	if (n > 0)
		matches[0] =
		    xstrndup(matches[1], shared_prefix_bytes(matches + 1, n));
	if (n == 1)
		xfree_and_set(&matches[1], NULL);
	completion_free(c);
	if (n > 0)
		return matches;
	free(matches);
	return NULL;
}

/* Returns "tierp (fit)> ".  Keys of sites are ASCII, whatever their names. */
static char *
prompt_text(const struct session *s)
{
	if (prompt.before[0] != '\0')
		return xstrdup("> ");
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	const char *state = entry == NULL       ? ""
			    : entry->has_fit    ? tr(" (fit)")
			    : entry->has_params ? tr(" (params)")
						: "";
	const char *name =
	    entry != NULL && entry->key[0] != '\0' ? entry->key : "tipspeed";
	bool colour = terminal_has_colour();
	return xasprintf("%s%s%s%s> ", colour ? "\001\033[1m\002" : "", name,
	    colour ? "\001\033[0m\002" : "", state);
}

/* Sets the size of readline's screen, because readline asks the terminal only
 * if it is given none, but not to sizes that readline 8.2 cannot handle.  It
 * divides by what is left of a row of two columns.  If the cursor cannot go up,
 * it scrolls the line, and loops for ever if the prompt with its invisible
 * characters is as wide as the screen. */
static void
set_readline_screen_size(const char *text)
{
	enum { ROWS = 2, COLUMNS = 20 };
	int rows, columns, least = COLUMNS;
	const char *up = rl_get_termcap("up");
	terminal_size(&rows, &columns);
	if (up == NULL || up[0] == '\0')
		least += (int)strlen(text);
	rl_set_screen_size(
	    rows > ROWS ? rows : ROWS, columns > least ? columns : least);
}

/* Wraps the prompt again after a change of columns, except during a search,
 * which has a prompt of its own. */
static void
wrap_prompt_to_columns(void)
{
	if (RL_ISSTATE(RL_STATE_ISEARCH | RL_STATE_NSEARCH))
		return;
	FREED char *text = xstrdup(rl_prompt);
	rl_set_prompt(text);
}

/* Handles ^Z, the return from it, and a change of size. */
static void
process_terminal_signals(void)
{
	int news = signals_take_terminal_events();
	if (news & SIGNALS_STOP) {
		rl_deprep_terminal();
		signals_suspend_program();
		news |= signals_take_terminal_events() | SIGNALS_WAKE;
	}
	if (news & SIGNALS_WAKE) {
		/* The shell may have changed the terminal's settings. */
		rl_deprep_terminal();
		rl_prep_terminal(1);
		rl_on_new_line();
	}
	if (news & (SIGNALS_WAKE | SIGNALS_SIZE)) {
		rl_clear_visible_line();
		set_readline_screen_size(rl_prompt);
		wrap_prompt_to_columns();
		rl_forced_update_display();
	}
}

/* Waits for a key.  Returns false on a signal that is not handled here. */
static bool
wait_for_key(void)
{
	while (signals_get_ending_or_interrupt() == 0) {
		if (signals_wait_for_input(INFINITY))
			return true;
		process_terminal_signals();
	}
	return false;
}

static bool
is_bracketed_paste_on(void)
{
	return strcmp(rl_variable_value("enable-bracketed-paste"), "on") == 0;
}

/* Returns the key that readline gets on a signal and at the end of input, so
 * that it drops the line and returns.  If it is reading something other than a
 * command, such as pasted text, it first gets the bytes that end a paste,
 * because readline 8.2 reads past its text if a paste ends in any other way. */
static int
fake_key_to_end_input(void)
{
	static const char END[] = "\033[201~";
	if (!RL_ISSTATE(RL_STATE_READCMD))
		return prompt.given < sizeof END - 1 ? END[prompt.given++]
						     : EOF;
	rl_point = rl_end;
	rl_redisplay();
	if (signals_get_ending_or_interrupt() == SIGINT)
		fputs("^C", rl_outstream);
	return READERR;
}

/* For readline: reads a key.  readline's own function would wait for a key with
 * signals blocked if ^C emptied the terminal's queue between pselect and the
 * read. */
static int
on_readline_getc(FILE *in)
{
	unsigned char c;
	/* With this on, readline 8.2 frees its undo list twice.  Set before
	 * each key, because any key may read the file of settings again. */
	rl_variable_bind("revert-all-at-newline", "off");
	while (wait_for_key()) {
		ssize_t got = -1;
		errno = EINTR;
		signals_unblock();
		if (signals_get_ending_or_interrupt() == 0)
			got = read(fileno(in), &c, 1);
		signals_block();
		if (got == 1)
			return c;
		if (got == 0 || errno != EINTR)
			break;
	}
	return fake_key_to_end_input();
}

/* Returns a typed line, which the caller frees, or NULL at the end of input or
 * on a signal.  Does not use readline's callback interface: in 8.2 that jumps
 * into a function that has returned when an unknown key sequence ends a
 * search. */
static char *
read_prompt_line(const char *text)
{
	struct sigaction was[3];
	signals_block();
	signals_catch_terminal(was);
	prompt.given = 0;
	set_readline_screen_size(text);
	restore_arm_tty_for_prompt(
	    is_bracketed_paste_on() ? "\033[?2004l\r\n" : "\n");
	char *line = readline(text);
	restore_disarm_tty();
	/* readline ends the line itself only if it turns bracketed paste
	 * off. */
	if (line == NULL && !is_bracketed_paste_on())
		fputc('\n', rl_outstream);
	signals_uncatch_terminal(was);
	signals_unblock();
	return line;
}

/* Runs a line, and then a command that was typed instead of an answer to a
 * question that the line asked.  Returns the status of the last. */
static int
run_line_with_pager(struct session *s, const char *line, int number)
{
	struct pager pager;
	typed_history_add(line);
	pager_begin_capture(&pager, s);
	int status = batch_run_line(s, line, number, &pager);
	pager_end_capture(&pager);
	FREED char *command = prompt.command;
	prompt.command = NULL;
	return command != NULL ? run_line_with_pager(s, command, number)
			       : status;
}

/* Runs what was typed up to Return: one line, or several that were pasted.
 * After an error, the step that was offered is offered again. */
static void
run_entered_lines(struct session *s, char *typed, int *number)
{
	if (!text_is_utf8(typed, strlen(typed))) {
		fputs(
		    tr("expected UTF-8: check the terminal's character set\n"),
		    stderr);
		return;
	}
	for (char *line = typed, *end; line != NULL && !s->quit; line = end) {
		end = strchr(line, '\n');
		if (end != NULL)
			*end++ = '\0';
		FREED char *joined = xasprintf("%s%s", prompt.before, line);
		bool more =
		    script_remove_line_end(joined, strlen(prompt.before));
		xfree_and_set(&prompt.before, xstrdup(more ? joined : ""));
		if (!more && run_line_with_pager(s, joined, (*number)++) != 0 &&
		    prompt.offer.line != NULL)
			prompt.stage = -1;
		if (signals_get_ending_or_interrupt() != 0)
			break;
	}
}

/* Prints the next step, if it is further on than the one printed last, or for
 * another site or fit.  With several sites, it says only once that answers are
 * possible.  The line typed next may accept the step. */
static void
offer_next_step(const struct session *s)
{
	const struct entry *entry =
	    s->n_entry > 0 ? &s->entry[s->current] : NULL;
	const struct site *site = entry != NULL ? entry->site : NULL;
	const struct history *history = entry != NULL ? entry->history : NULL;
	struct next next = suggest_next_step(s);
	bool same = (site == prompt.site && history == prompt.history) ||
		    (s->n_entry > 1 && next.stage == NEXT_ANSWER);
	prompt.offer = (struct next){.line = NULL};
	if (same && (int)next.stage <= prompt.stage)
		return;
	prompt.stage = (int)next.stage;
	prompt.site = site;
	prompt.history = history;
	if (next.line != NULL)
		session_print_note(s, "%s [Y/n, or a command]", tr(next.words));
	else if (next.words != NULL)
		session_print_note(s, "%s", tr(next.words));
	prompt.offer = next;
}

/* Runs the offered commands: as one line or, if the offer is brief, one by one
 * with only the result of each. */
static void
run_offered_commands(struct session *s, int *number)
{
	const char *line = prompt.offer.line;
	if (!prompt.offer.brief) {
		run_line_with_pager(s, line, (*number)++);
		return;
	}
	typed_history_add(line);
	session_print_note(s, "  %s", line);
	int status = 0;
	while (status == 0 && *line != '\0' && !signals_is_end_wanted()) {
		size_t n = strcspn(line, ";");
		FREED char *command = xstrndup(line, n);
		status = batch_run_line_quietly(s, command, *number);
		if (status == 0)
			next_print_answer_summary(s);
		line += n + strspn(line + n, "; ");
	}
	++*number;
}

enum reply { REPLY_YES, REPLY_NO, REPLY_EMPTY, REPLY_COMMAND };

static enum reply
classify_reply_to_offer(const char *typed)
{
	FREED char *word = xstrdup(typed);
	const char *said = text_trim(word);
	return said[0] == '\0'   ? REPLY_EMPTY
	       : tr_is_yes(said) ? REPLY_YES
	       : tr_is_no(said)  ? REPLY_NO
				 : REPLY_COMMAND;
}

/* Handles a line that answers the offer, or says that there is none.  Returns
 * false if the line is a command instead. */
static bool
handle_reply_to_offer(struct session *s, const char *typed, int *number)
{
	enum reply reply = classify_reply_to_offer(typed);
	bool offered = prompt.offer.line != NULL;
	bool again = reply == REPLY_EMPTY && prompt.declined && !offered;
	const bool answers = reply == REPLY_YES || reply == REPLY_NO;
	if (prompt.before[0] == '\0' && answers && !offered) {
		session_print_note(
		    s, "nothing has been asked: type a command, or 'help'");
		return true;
	}
	if (prompt.before[0] != '\0' ||
	    !(again || (offered && reply != REPLY_COMMAND)))
		return false;
	prompt.declined = reply == REPLY_NO;
	if (again)
		prompt.stage = -1;
	else if (reply != REPLY_NO)
		run_offered_commands(s, number);
	return true;
}

/* Clears the screen for the word "clear", which shells have, if the terminal
 * can.  Returns true if it did. */
static bool
clear_screen_if_asked(const char *typed)
{
	FREED char *word = xstrdup(typed);
	const char *clear = rl_get_termcap("cl");
	if (clear == NULL || prompt.before[0] != '\0' ||
	    strcmp(text_trim(word), "clear") != 0)
		return false;
	fputs(clear, rl_outstream);
	return true;
}

/* For --safe: takes away the keys of functions that read a settings file, list
 * users or run a shell. */
static void
unbind_unsafe_readline_keys(void)
{
	static const char *const OUT[] = {"re-read-init-file", "tilde-expand",
	    "vi-tilde-expand", "execute-named-command",
	    "edit-and-execute-command", "vi-edit-and-execute-command"};
	const Keymap maps[] = {emacs_standard_keymap, emacs_meta_keymap,
	    emacs_ctlx_keymap, vi_movement_keymap, vi_insertion_keymap};
	for (size_t i = 0; i < ARRAY_LEN(OUT); i++)
		for (size_t m = 0; m < ARRAY_LEN(maps); m++)
			if (rl_named_function(OUT[i]) != NULL)
				rl_unbind_function_in_map(
				    rl_named_function(OUT[i]), maps[m]);
}

static void
set_up_readline(struct session *s)
{
	prompt.session = s;
	prompt.before = xstrdup("");
	prompt.stage = -1;
	rl_readline_name = "tipspeed";
	rl_catch_signals = 0;
	rl_catch_sigwinch = 0;
	/* Otherwise, after a change of size, a pager would be told the old
	 * one. */
	rl_change_environment = 0;
	rl_getc_function = on_readline_getc;
	rl_attempted_completion_function = on_readline_complete;
	rl_completer_word_break_characters = " \t\n;=,";
	rl_completer_quote_characters = "";
	if (s->safe)
		setenv("INPUTRC", "/dev/null", 1);
	history_search_add_to_readline();
	rl_initialize();
	history_search_bind_keys();
	if (s->safe)
		unbind_unsafe_readline_keys();
	/* Text is UTF-8 in every locale, so its bytes are not meta keys. */
	rl_variable_bind("input-meta", "on");
	rl_variable_bind("output-meta", "on");
	rl_variable_bind("convert-meta", "off");
	typed_history_open(!s->safe);
}

void
repl_greet_and_run_init(struct session *s)
{
	fprintf(stderr,
	    tr("tipspeed %s: help lists the commands, tui is full-screen mode, "
	       "quit exits\n"),
	    PACKAGE_VERSION);
	s->hooks.show_manual_page = manpage_show;
	FREED char *path = s->safe ? NULL
				   : xdg_user_file_path("XDG_CONFIG_HOME",
					 ".config", "init.tip");
	if (path != NULL && access(path, F_OK) == 0)
		batch_run_script_file(s, path);
	signals_clear_interrupt();
	/* So that questions about files on the command line are asked. */
	s->hooks.ask = ask_question;
}

/* For readline while an answer is typed, which has no completions. */
static char **
complete_nothing(const char *text, int start, int end)
{
	(void)text, (void)start, (void)end;
	rl_attempted_completion_over = 1;
	return NULL;
}

static char *
prompt_for_typed_answer(const char *text)
{
	rl_attempted_completion_function = complete_nothing;
	char *line = read_prompt_line(text);
	rl_attempted_completion_function = on_readline_complete;
	if (line == NULL || text_is_utf8(line, strlen(line)))
		return line;
	free(line);
	return NULL;
}

static char *
repl_ask_question(struct session *s, const struct user_question *q)
{
	return ask_question_with_reader(s, q, prompt_for_typed_answer);
}

/* Asks for yes or no.  A command typed instead means no, and is run
 * afterwards. */
static bool
repl_confirm(struct session *s, const char *question, bool yes)
{
	(void)s;
	text_print_wrapped(question, 0, question_wrap_width(), stderr);
	char *typed = read_prompt_line(
	    yes ? tr("[Y/n, or a command] ") : tr("[y/N, or a command] "));
	enum reply reply =
	    typed != NULL ? classify_reply_to_offer(typed) : REPLY_NO;
	if (reply == REPLY_COMMAND)
		prompt.command = typed;
	else
		free(typed);
	return reply == REPLY_YES || (yes && reply == REPLY_EMPTY);
}

int
repl_run(struct session *s)
{
	int number = 1;
	set_up_readline(s);
	batch_make_session_interactive(s);
	s->hooks.ask = repl_ask_question;
	s->hooks.confirm = repl_confirm;
	while (!s->quit && !signals_is_end_wanted()) {
		if (prompt.before[0] == '\0')
			offer_next_step(s);
		FREED char *text = prompt_text(s);
		char *typed = read_prompt_line(text);
		s->screen = terminal_get_size_and_colours();
		if (typed != NULL) {
			if (!clear_screen_if_asked(typed) &&
			    !handle_reply_to_offer(s, typed, &number))
				run_entered_lines(s, typed, &number);
			free(typed);
		} else if (signals_get_ending_or_interrupt() == 0) {
			break;
		}
		if (signals_get_ending_or_interrupt() != 0)
			prompt.before[0] = '\0';
		signals_clear_interrupt();
	}
	typed_history_close();
	free(prompt.before);
	return signals_exit_status();
}

int
repl_run_or_note_no_screen(struct session *s)
{
	if (!s->prompt)
		return repl_run(s);
	session_print_note(s,
	    "--linear was given: use the prompt instead of full-screen mode");
	return 0;
}
