/* tipspeed: reads the command line and hands over to a driver.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <getopt.h>
#include <gsl/gsl_errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/data.h"
#include "cmd/info.h"
#include "cmd/session.h"
#include "config.h"
#include "ui/batch.h"

/* One -c or -f, in the order given. */
struct action {
	char kind;
	const char *value;
};

struct invocation {
	size_t n_action;
	struct action *action;
	enum report_format format;
	uint64_t seed;
	const char *store; /* NULL: the default place */
	bool help, version;
	int first_file;
};

enum { OPTION_FORMAT = 256, OPTION_SEED, OPTION_STORE };

static const struct option LONG_OPTIONS[] = {
    {"format", required_argument, NULL, OPTION_FORMAT},
    {"seed", required_argument, NULL, OPTION_SEED},
    {"store", required_argument, NULL, OPTION_STORE},
    {"help", no_argument, NULL, 'h'}, {"version", no_argument, NULL, 'V'},
    {NULL, 0, NULL, 0}};

static void
print_help(void)
{
	fputs(
	    "usage: tipspeed [-c CMD]... [-f FILE]... [--format=FORMAT] "
	    "[--seed=N]\n"
	    "                [--store=PATH] [FILE...]\n\n"
	    "Loads the site FILEs (a FILE.tip is a script and is run), then "
	    "runs the commands\nof -c and -f in order. Without -c and -f, "
	    "commands come from standard input.\n"
	    "\n  -c CMD           run the commands in CMD\n"
	    "  -f FILE          run the commands in FILE; - is standard input\n"
	    "  --format=FORMAT  table, csv, json or markdown\n"
	    "  --seed=N         seed of calibrations\n"
	    "  --store=PATH     file of calibrations, or :memory: to leave no "
	    "trace\n"
	    "  --help           this text\n"
	    "  --version        the version\n\ncommands\n",
	    stdout);
	info_list(stdout);
}

static bool
take_format(const char *word, enum report_format *format)
{
	for (size_t i = 0; i < ARRAY_LEN(REPORT_FORMATS); i++) {
		if (strcmp(word, REPORT_FORMATS[i]) != 0)
			continue;
		*format = (enum report_format)i;
		return true;
	}
	fprintf(stderr,
	    "tipspeed: --format wants table, csv, json or markdown, not '%s'\n",
	    word);
	return false;
}

static bool
take_option(struct invocation *in, int option, const char *value)
{
	switch (option) {
	case 'c':
	case 'f':
		in->action[in->n_action++] =
		    (struct action){(char)option, value};
		return true;
	case OPTION_FORMAT:
		return take_format(value, &in->format);
	case OPTION_SEED:
		if (text_whole(value, &in->seed) && in->seed <= INT64_MAX)
			return true;
		fprintf(stderr,
		    "tipspeed: --seed wants a whole number below 2^63, not "
		    "'%s'\n",
		    value);
		return false;
	case OPTION_STORE:
		in->store = value;
		if (value[0] != '\0')
			return true;
		fputs("tipspeed: --store wants a file or :memory:\n", stderr);
		return false;
	case 'h':
		in->help = true;
		return true;
	case 'V':
		in->version = true;
		return true;
	default:
		fputs("  hint: tipspeed --help lists the options\n", stderr);
		return false;
	}
}

static bool
read_command_line(struct invocation *in, int argc, char **argv)
{
	int option;
	while ((option = getopt_long(
		    argc, argv, "c:f:hV", LONG_OPTIONS, NULL)) != -1)
		if (!take_option(in, option, optarg))
			return false;
	in->first_file = optind;
	return true;
}

/* A FILE is a site file, or a script when its name ends in .tip. */
static int
open_file(struct session *s, const char *path)
{
	size_t n = strlen(path);
	if (n > 4 && strcmp(path + n - 4, ".tip") == 0)
		return batch_file(s, path);
	struct error error = {0};
	if (data_load(s, path, &error))
		return 0;
	if (error.kind == ERROR_SYSTEM && command_find(path) != NULL)
		error_hint(&error, "commands go behind -c: -c '%s'", path);
	error_print(&error, stderr);
	return (int)error.kind;
}

static int
run_actions(struct session *s, const struct invocation *in)
{
	int status = 0, commands = 0;
	for (size_t i = 0; status == 0 && i < in->n_action && !s->quit; i++) {
		const struct action *a = &in->action[i];
		if (a->kind == 'f')
			status = strcmp(a->value, "-") == 0
				     ? batch_stream(s, stdin, "stdin")
				     : batch_file(s, a->value);
		else
			status = batch_text(s, a->value, "-c", ++commands);
	}
	return status;
}

static int
run(struct session *s, const struct invocation *in, int argc, char **argv)
{
	int status = 0;
	for (int i = in->first_file; status == 0 && i < argc; i++)
		status = open_file(s, argv[i]);
	if (status != 0)
		return status;
	if (in->n_action > 0)
		return run_actions(s, in);
	if (isatty(STDIN_FILENO))
		return batch_typed(s);
	return batch_stream(s, stdin, "stdin");
}

/* A full disk or a closed pipe must not look like success. */
static int
close_output(int status)
{
	if (fflush(stdout) == 0 && !ferror(stdout))
		return status;
	fputs("tipspeed: not all results could be written: is the disk full?\n",
	    stderr);
	return ERROR_SYSTEM;
}

int
main(int argc, char **argv)
{
	/* LC_CTYPE only: under sv_SE, LC_NUMERIC would read 11.2 as 11. */
	setlocale(LC_CTYPE, "");
	gsl_set_error_handler_off();
	struct invocation in = {.seed = 1};
	in.action = xcalloc((size_t)argc, sizeof *in.action);
	int status = ERROR_USAGE;
	if (read_command_line(&in, argc, argv)) {
		struct session *s = session_new(stdout, stderr);
		s->format = in.format;
		s->seed = in.seed;
		store_free(s->store);
		s->store = store_new(in.store);
		batch_catch_interrupt();
		if (in.help)
			print_help();
		if (in.version)
			printf("tipspeed %s\n", PACKAGE_VERSION);
		status = in.help || in.version ? 0 : run(s, &in, argc, argv);
		session_free(s);
	}
	free(in.action);
	return close_output(status);
}
