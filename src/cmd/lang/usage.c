/* The texts of the command line, and the command table as printed for people.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/usage.h"

#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

const struct usage_option USAGE_OPTIONS[] = {
    {'c', NULL, "CMD", NULL, "run the commands in CMD"},
    {'f', NULL, "FILE", NULL, "run the commands in FILE; - is standard input"},
    {USAGE_FORMAT, "format", "FORM", "table csv json markdown",
	"output format"},
    {USAGE_SEED, "seed", "N", NULL, "seed of calibrations"},
    {USAGE_STORE, "store", "PATH", NULL,
	"store file of remembered calibrations; :memory: writes none"},
    {USAGE_COLOR, "color", "WHEN", "auto always never",
	"colour at the prompt and in plots"},
    {USAGE_LANG, "lang", "LANG", NULL,
	"language of texts for people, such as sv; default: the locale's"},
    {USAGE_SAFE, "safe", NULL, NULL, "commands cannot use files or the shell"},
    {USAGE_LINEAR, "linear", NULL, NULL,
	"for screen readers: the prompt, and plots described in words"},
    {USAGE_RESET_TTY, "reset-tty", NULL, NULL,
	"restore the terminal after a kill -9, and exit"},
    {'h', "help", NULL, NULL, "show this help"},
    {'V', "version", NULL, NULL, "show the version"}, {.code = 0}};

const struct usage_word USAGE_ENVIRONMENT[] = {
    {"TIPSPEED_COLOR", "Colour at the prompt and in plots: auto, always or "
		       "never; --color overrides it."},
    {"NO_COLOR", "If set and not empty, turns colour off unless --color or "
		 "TIPSPEED_COLOR overrides it."},
    {"TERM", "Type of the terminal. With dumb there is no colour and no pager; "
	     "with dumb, linux, vt100 and the like, plots are in ASCII."},
    {"COLORTERM", "If truecolor or 24bit, colour plots have 256 colours, "
		  "whatever TERM is."},
    {"TIPSPEED_PAGER", "Program that shows results longer than the screen; if "
		       "empty, none is used."},
    {"PAGER", "The same, if TIPSPEED_PAGER is not set."},
    {"TIPSPEED_ISA",
	"Best instruction set that calibrations may use, for tests: baseline, "
	"avx2 or avx512. The results are the same."},
    {"OMP_NUM_THREADS",
	"Number of threads, unless 'set threads' states it; default: the "
	"processors that tipspeed may run on. The results are the same."},
    {"SOURCE_DATE_EPOCH",
	"Seconds since 1970: the date to use as today's, so that repeated "
	"output is identical; default: the clock."},
    {"XDG_STATE_HOME",
	"Folder of tipspeed/history, the lines typed at the prompt, and of "
	"unsaved sessions; default .local/state in HOME."},
    {"XDG_CONFIG_HOME", "Folder of tipspeed/init.tip, the commands run before "
			"the first prompt; default .config in HOME."},
    {"XDG_DATA_HOME", "Folder of tipspeed/store.db, the remembered "
		      "calibrations; default .local/share in HOME."},
    {"HOME", "Your home folder."},
    {"TMPDIR", "Folder for the unnamed temporary files in which workbooks are "
	       "put together; default /tmp."},
    {"LC_CTYPE", "Character set, or LC_ALL or LANG if they replace it; text is "
		 "always UTF-8 and numbers always have a decimal point."},
    {"LC_MESSAGES",
	"Language of texts for people, or LC_ALL or LANG if they replace it, "
	"unless --lang is given. Commands, csv and json are in English."},
    {"LANGUAGE", "Languages in order of preference, such as sv:en; not used in "
		 "the locale C."},
    {.name = NULL}};

const struct usage_word USAGE_TRUST[] = {
    {"green", "Nothing in the data contradicts the answer or its band."},
    {"amber", "Use the answer with the reason in mind."},
    {"red", "Do not rely on the answer."}, {.name = NULL}};

const struct usage_word USAGE_STATUS[] = {{"0", "All commands succeeded."},
    {"1", "A check found a fault, or an assertion failed."},
    {"2", "Usage error: the command line or a command cannot be understood, or "
	  "something is missing, such as parameters for a prediction."},
    {"3", "Bad data: a site file, a grading envelope or a table of "
	  "parameters has a fault, or the store is damaged or not one of "
	  "this program's."},
    {"4", "A computation has no result: in a circuit of flow or card, the "
	  "return flow grows without limit."},
    {"5", "System error: a file cannot be read or written, a shell command "
	  "failed, the store is in use by another program, or memory has run "
	  "out."},
    {"129", "Ended by a hang-up, after the best so far was printed."},
    {"130",
	"Interrupted from the keyboard. A calibration stops after the current "
	"generation or step and prints the best found so far. At the prompt, "
	"'continue' continues it. A file that was being read is discarded."},
    {"143", "Ended by kill, after the best so far was printed."},
    {.name = NULL}};

/* Prints a word, and its meaning from column `margin` on; below it, if the word
 * is longer or the screen narrow. */
static void
print_word_with_meaning(
    const char *word, const char *meaning, int margin, int width, FILE *out)
{
	enum { NARROW = 50, BELOW = 6 };
	int pad = width < NARROW ? 0 : margin - 2 - text_width_in_columns(word);
	int column = pad > 0 ? margin : BELOW;
	fprintf(out, "  %s%s%*s", word, pad > 0 ? "" : "\n",
	    pad > 0 ? pad : BELOW, "");
	text_print_hanging(meaning, column, column, width, out);
}

void
usage_print_command_brief(const struct command *c, int width, FILE *out)
{
	const char *title = command_shown_name(c),
		   *other = command_other_name(c);
	FREED char *name = other != NULL && title == c->name
			       ? xasprintf("%s, %s", title, other)
			       : xstrdup(title);
	print_word_with_meaning(name, tr(c->brief), 22, width, out);
}

void
usage_print_command_list(const char *group, int width, FILE *out)
{
	const char *last = "";
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const char *its = command_group_name(c);
		if (group != NULL && strcmp(group, its) != 0)
			continue;
		/* Shown beside the translation, because only the English name
		 * can be typed: help store. */
		if (strcmp(last, its) != 0)
			fprintf(out,
			    strcmp(tr(its), its) != 0 ? "%s (%s)\n" : "%s\n",
			    tr(its), its);
		last = its;
		usage_print_command_brief(c, width, out);
	}
	fputc('\n', out);
	text_print_wrapped(
	    tr("help COMMAND explains one, apropos WORD searches"), 0, width,
	    out);
}

static void
print_option_help(const struct command_option *o, int width, FILE *out)
{
	FREED char *words = command_option_help_text(o);
	print_word_with_meaning(o->name, words, 15, width, out);
}

void
usage_print_example(const struct command *c, const char *margin, FILE *out)
{
	for (const char *line = c->example; *line != '\0';) {
		int n = (int)strcspn(line, "\n");
		fprintf(out, "%s%.*s\n", margin, n, line);
		line += n + (line[n] == '\n');
	}
}

/* Prints the names of the command's shared options, which `help options`
 * explains. */
static void
print_shared_option_names(const struct command *c, int width, FILE *out)
{
	FREED char *names = command_shared_option_names(c);
	FREED char *line = xasprintf(tr("also takes %s: help options"), names);
	if (names[0] != '\0')
		text_print_wrapped(line, 2, width, out);
}

void
usage_print_shared_options(int width, FILE *out)
{
	const struct command_option *o;
	text_print_wrapped(
	    tr("Options of many commands; help COMMAND names those it takes."),
	    0, width, out);
	fputc('\n', out);
	for (size_t i = 0; (o = command_shared_option_at(i)) != NULL; i++)
		print_option_help(o, width, out);
}

void
usage_print_command_help(const struct command *c, int width, FILE *out)
{
	const char *operands = c->operands.usage;
	const struct command_option *o = command_option_at(c, 0);
	FREED char *title =
	    xasprintf("%s - %s", command_shown_name(c), tr(c->brief));
	text_print_wrapped(title, 0, width, out);
	fputc('\n', out);
	FREED char *usage = xstrdup(command_shown_name(c));
	if (operands != NULL)
		xappend(&usage, " %s", operands);
	if (c->bare != NULL)
		xappend(&usage, " [%s]", c->bare);
	if (o != NULL)
		xappend(&usage, " %s", tr("[OPTION=VALUE...]"));
	fputs("  ", out);
	text_print_hanging(usage, 2, 6, width, out);
	if (c->alias != NULL)
		fprintf(out, tr("  also called %s\n"), command_other_name(c));
	print_shared_option_names(c, width, out);
	fputc('\n', out);
	text_print_wrapped(tr(c->text), 2, width, out);
	if (c->more != NULL)
		fputs(tr("  tipspeed(1) says more.\n"), out);
	for (size_t i = 0; (o = command_own_option_at(c, i)) != NULL; i++) {
		if (i == 0)
			fputs(tr("\noptions\n"), out);
		print_option_help(o, width, out);
	}
	fputs(tr("\nexample\n"), out);
	usage_print_example(c, "  ", out);
}

static void
print_program_options(FILE *out)
{
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++) {
		char letter[3] = {o->code < 256 ? '-' : '\0',
		    o->code < 256 ? (char)o->code : '\0', '\0'};
		FREED char *option = xasprintf("%s%s%s%s%s%s", letter,
		    letter[0] != '\0' && o->name != NULL ? ", " : "",
		    o->name != NULL ? "--" : "", o->name != NULL ? o->name : "",
		    o->argument == NULL ? ""
		    : o->name != NULL   ? "="
					: " ",
		    o->argument != NULL ? o->argument : "");
		fprintf(out, "  %-16s %s%s%s\n", option, tr(o->brief),
		    o->choices != NULL ? ": " : "",
		    o->choices != NULL ? o->choices : "");
	}
}

static void
print_words_with_meanings(
    const char *title, const struct usage_word *word, int width, FILE *out)
{
	fprintf(out, "\n%s\n", tr(title));
	for (; word->name != NULL; word++)
		print_word_with_meaning(
		    tr(word->name), tr(word->meaning), 0, width, out);
}

void
usage_print_trust_lights(int width, FILE *out)
{
	text_print_wrapped(
	    tr("Every answer ends in a light, which says whether it can "
	       "be trusted, and the worst reason. 'why' lists all "
	       "reasons, and what to do about each."),
	    0, width, out);
	print_words_with_meanings(N_("trust"), USAGE_TRUST, width, out);
	fputs("\n", out);
	text_print_wrapped(
	    tr("Between three or more measured speeds the measurements correct "
	       "the model, and the light is green unless they contradict each "
	       "other or are too few. Beyond them it is amber, and far beyond "
	       "red: no measurement shows what the machine does there. 'man "
	       "model' has the rules, and how often each light was right."),
	    0, width, out);
}

void
usage_print_program_help(FILE *out)
{
	enum { WIDTH = 78 };
	fputs(
	    tr("usage: tipspeed [-c CMD]... [-f FILE]... [OPTION]... "
	       "[FILE...]\n"
	       "\nLoads the site FILEs (a FILE.tip is a script and is run), "
	       "then runs the commands\nof -c and -f in order. Without -c and "
	       "-f, commands come from standard input.\n\n"),
	    out);
	print_program_options(out);
	fputs(tr("\ncommands\n"), out);
	usage_print_command_list(NULL, WIDTH, out);
	print_words_with_meanings(
	    N_("environment"), USAGE_ENVIRONMENT, WIDTH, out);
	print_words_with_meanings(N_("exit status"), USAGE_STATUS, WIDTH, out);
}
