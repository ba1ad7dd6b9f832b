/* tipspeed: reads the command line and runs a driver.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <assert.h>
#include <fcntl.h>
#include <getopt.h>
#include <gsl/gsl_errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/sheets/load.h"
#include "cmd/run/line.h"
#include "cmd/session/session.h"
#include "cmd/lang/usage.h"
#include "config.h"
#include "cli/batch.h"
#include "cli/signals.h"
#include "cli/repl.h"
#include "cli/restore.h"
#include "tui/script_terminal.h"
#include "cli/terminal.h"
#include "tui/tui.h"

/* One -c or -f, in the order given. */
struct action {
	char kind;
	const char *value;
};

struct command_line {
	size_t n_action;
	struct action *action;
	enum answer_format format;
	uint64_t seed;
	const char *store; /* NULL: the default place */
	enum colour color;
	bool help, version, safe, linear, reset_tty;
	int first_file;
};

static bool
parse_format_name(
    const char *word, enum answer_format *format, struct error *error)
{
	for (size_t i = 0; i < ARRAY_LEN(ANSWER_FORMATS); i++) {
		if (strcmp(word, ANSWER_FORMATS[i].name) != 0)
			continue;
		*format = (enum answer_format)i;
		return true;
	}
	return error_set(error, ERROR_USAGE,
	    "expected --format table, csv, json or markdown, got '%s'", word);
}

static bool
set_language_by_code(const char *word, struct error *error)
{
	return tr_set_language(word) ||
	       error_set(error, ERROR_USAGE,
		   "expected --lang with a language that tipspeed has, got "
		   "'%s'",
		   word);
}

static bool
main_parse_option(
    struct command_line *in, int option, const char *value, struct error *error)
{
	switch (option) {
	case 'c':
	case 'f':
		in->action[in->n_action++] =
		    (struct action){(char)option, value};
		return true;
	case USAGE_FORMAT:
		return parse_format_name(value, &in->format, error);
	case USAGE_SEED:
		return (text_parse_whole_number(value, &in->seed) &&
			   in->seed <= INT64_MAX) ||
		       error_set(error, ERROR_USAGE,
			   "expected --seed with a whole number below 2^63, "
			   "got '%s'",
			   value);
	case USAGE_STORE:
		in->store = value;
		return value[0] != '\0' ||
		       error_set(error, ERROR_USAGE,
			   "expected --store with a file or :memory:");
	case USAGE_LANG:
		return set_language_by_code(value, error);
	case USAGE_SAFE:
		in->safe = true;
		return true;
	case USAGE_COLOR:
		return terminal_parse_colour_mode(value, &in->color) ||
		       error_set(error, ERROR_USAGE,
			   "expected --color auto, always or never, got '%s'",
			   value);
	case USAGE_LINEAR:
		in->linear = true;
		return true;
	case USAGE_RESET_TTY:
		in->reset_tty = true;
		return true;
	case 'h':
		in->help = true;
		return true;
	default:
		assert(option == 'V');
		in->version = true;
		return true;
	}
}

/* Returns the long options that may be meant by "--NAME" or "--NAME=VALUE":
 * those that begin with NAME, are spelled like it or have a choice of this
 * name.  The caller frees it. */
static char *
list_options_like(const char *word)
{
	char *list = xstrdup("");
	FREED char *name = xstrndup(word + 2, strcspn(word + 2, "="));
	size_t i;
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++) {
		if (o->name == NULL || name[0] == '\0')
			continue;
		if (strncmp(o->name, name, strlen(name)) == 0 ||
		    text_edit_distance(o->name, name) <= 2)
			xappend_to_list(&list, ", ", "--%s", o->name);
		else if (o->choices != NULL &&
			 text_find_word_in_list(o->choices, name, &i))
			xappend_to_list(&list, ", ", "--%s=%s", o->name, name);
	}
	return list;
}

/* Sets the error here because getopt would print the word as it is, unescaped.
 * word: the argument read last.  If a letter inside it is unknown, only that
 * letter is named. */
static bool
set_program_option_error(
    int option, const char *letters, const char *word, struct error *error)
{
	char letter[3] = {'-', (char)optopt, '\0'};
	bool alone = optopt > 0 && optopt < 256 && option == '?' &&
		     strchr(letters, optopt) == NULL;
	FREED char *like = list_options_like(
	    option == '?' && strncmp(word, "--", 2) == 0 ? word : "--");
	error_set(error, ERROR_USAGE,
	    option == ':' ? N_("expected a value after '%s', got none\n%s")
			  : N_("unrecognized option '%s'\n%s"),
	    alone ? letter : word, tr("run tipspeed --help for the options"));
	return like[0] != '\0' &&
	       error_set_hint(error,
		   strchr(like, ',') != NULL ? N_("did you mean one of %s?")
					     : N_("did you mean '%s'?"),
		   like);
}

static bool
parse_command_line(
    struct command_line *in, int argc, char **argv, struct error *error)
{
	enum { MOST = 32 };
	struct option options[MOST] = {{0}};
	char letters[2 * MOST] = ":";
	size_t n = 0, m = 1;
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++) {
		bool takes = o->argument != NULL;
		if (o->name != NULL)
			options[n++] = (struct option){o->name,
			    takes ? required_argument : no_argument, NULL,
			    o->code};
		assert(n < MOST);
		if (o->code < 256)
			letters[m++] = (char)o->code;
		if (o->code < 256 && takes)
			letters[m++] = ':';
	}
	int option;
	opterr = 0;
	while ((option = getopt_long(argc, argv, letters, options, NULL)) != -1)
		if (option == '?' || option == ':'
			? !set_program_option_error(
			      option, letters, argv[optind - 1], error)
			: !main_parse_option(in, option, optarg, error))
			return false;
	in->first_file = optind;
	return true;
}

/* Adds a hint if one of the FILEs that cannot be read is a command. */
static void
hint_command_among_files(char *const *path, size_t n, struct error *error)
{
	size_t i = 0;
	while (i < n && command_find(path[i]) == NULL)
		i++;
	FREED char *line = xstrdup("");
	for (size_t j = i; j < n; j++)
		xappend_to_list(&line, " ", "%s", path[j]);
	if (i < n && error->kind == ERROR_SYSTEM)
		error_set_hint(error, "put commands after -c: -c '%s'", line);
}

/* Opens the FILEs: site files, or scripts if their names end in .tip.  Site
 * files that follow each other are loaded together, because they may be of one
 * site.  stays: somebody sits at a prompt, and can load a refused sheet anew,
 * as its hint says. */
static int
load_or_run_files(struct session *s, char *const *path, size_t n, bool stays)
{
	for (size_t i = 0, k; i < n; i = k) {
		int status = 0;
		struct error error = {0};
		for (k = i; k < n && !text_ends_with(path[k], ".tip"); k++)
			;
		if (k == i) {
			status = batch_run_script_file(s, path[k++]);
		} else if (!load_files(s, k - i, (const char *const *)path + i,
			       NULL, &error)) {
			hint_command_among_files(path + i, n - i, &error);
			error_print(&error, stderr);
			status = stays ? 0 : (int)error.kind;
		}
		if (status != 0 || s->quit)
			return status;
	}
	return 0;
}

static int
run_scripts_and_commands(struct session *s, const struct command_line *in)
{
	int status = 0, commands = 0;
	for (size_t i = 0; status == 0 && i < in->n_action && !s->quit; i++) {
		const struct action *a = &in->action[i];
		if (a->kind == 'f')
			status = strcmp(a->value, "-") == 0
				     ? batch_run_script_stream(s)
				     : batch_run_script_file(s, a->value);
		else
			status = batch_run_script_text(s, a->value, ++commands);
	}
	return status;
}

static int
main_run(
    struct session *s, const struct command_line *in, int argc, char **argv)
{
	int status = 0;
	bool prompt = in->n_action == 0 && terminal_is_interactive();
	if (prompt)
		repl_greet_and_run_init(s);
	if (in->first_file < argc)
		status = load_or_run_files(s, argv + in->first_file,
		    (size_t)(argc - in->first_file), prompt);
	if (status != 0)
		return status;
	if (prompt)
		signals_clear_interrupt(); /* from a question about a FILE */
	if (in->n_action > 0)
		return run_scripts_and_commands(s, in);
	if (prompt)
		return repl_run(s);
	if (isatty(STDIN_FILENO))
		return batch_run_typed_lines(s);
	return batch_run_script_stream(s);
}

/* Returns the exit status after flushing standard output: a full disk or a
 * closed pipe must not look like success. */
static int
flush_stdout(int status)
{
	bool good = !ferror(stdout);
	if (fclose(stdout) == 0 && good)
		return status;
	fputs(tr("tipspeed: not all results could be written: is the disk "
		 "full?\n"),
	    stderr);
	return ERROR_SYSTEM;
}

/* Opens those of the three standard streams that are missing.  Otherwise a file
 * of the user's, or of a shell command, which inherits the streams, could get
 * the number of one of them, and everything printed there.  They are opened
 * read-only, so that printing to them still fails. */
static void
open_missing_fds(void)
{
	int fd;
	do
		fd = open("/dev/null", O_RDONLY);
	while (fd >= 0 && fd <= STDERR_FILENO);
	if (fd >= 0)
		close(fd);
}

int
main(int argc, char **argv)
{
	open_missing_fds();
	/* Not LC_NUMERIC: under sv_SE 11.2 would be read as 11. */
	setlocale(LC_CTYPE, "");
	tr_set_language(NULL);
	gsl_set_error_handler_off();
	struct command_line in = {.seed = 1};
	in.action = xcalloc((size_t)argc, sizeof *in.action);
	int status = ERROR_USAGE;
	struct error error = {0};
	bool understood = parse_command_line(&in, argc, argv, &error);
	if (!understood)
		error_print(&error, stderr);
	if (understood && in.reset_tty) {
		restore_reset_terminal();
		status = 0;
	} else if (understood) {
		struct session *s = session_new(stdout, stderr);
		s->set.format = in.format;
		session_set_translation_by_format(s);
		s->set.seed = in.seed;
		s->isa = isa_from_name(getenv("TIPSPEED_ISA"));
		s->safe = in.safe;
		store_free(s->store);
		/* With --safe, a script must not touch the user's materials
		 * either. */
		bool none = in.safe && in.store == NULL;
		s->store = store_new(none ? ":memory:" : in.store);
		terminal_set_colour_mode(in.color);
		s->screen = terminal_get_size_and_colours();
		s->hooks.draw_screen = script_draw_screen;
		s->hooks.run_screen =
		    in.linear ? repl_run_or_note_no_screen : tui_run;
		signals_catch();
		s->hooks.stop = signals_is_stop_wanted;
		s->linear = in.linear;
		if (in.help)
			usage_print_program_help(stdout);
		if (in.version)
			printf("tipspeed %s\n", PACKAGE_VERSION);
		status =
		    in.help || in.version ? 0 : main_run(s, &in, argc, argv);
		session_free(s);
	}
	free(in.action);
	/* What failed because of a signal was ended by it. */
	if (status != 0 && signals_get_ending_or_interrupt() != 0)
		status = signals_exit_status();
	return flush_stdout(status);
}
