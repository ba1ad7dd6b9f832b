/* The command table: everything a user can say, as data.
 *
 * The parser, usage lines, help, the manual's COMMANDS section and several
 * tests read this table; to add a command is to add a row and a function.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_COMMAND_H
#define TIPSPEED_CMD_LANG_COMMAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"

struct command;
struct session;

enum value_kind {
	VALUE_NUMBER,  /* decimal point; the option's unit may follow */
	VALUE_WHOLE,   /* 0 to 2^64-1 */
	VALUE_CHOICE,  /* one of the option's choices */
	VALUE_NUMBERS, /* a,b,c or a..b[:step]; n is 0 for a choice */
	VALUE_FILE,    /* path of a file */
	VALUE_FEED,    /* a number, or path of a sheet with a feed */
	VALUE_SPEC,    /* that of an envelope, or the name of a shipped one */
	VALUE_TEXT
};

/* One key=value of a command. */
struct command_option {
	const char *name;
	enum value_kind kind;
	const char *unit;     /* "m/s"; "" where there is none */
	double least, most;   /* of numbers */
	const char *choices;  /* see option_choices */
	const char *fallback; /* default, as typed; "" where there is none */
	const char *brief;
};

/* A setting: what may be said of it, option.fallback being what it is at first,
 * or "" where the session finds that; and where it is kept, a member of struct
 * choices: a double for a number, letters for a text, an unsigned or an enum
 * for the rest.  looks: is of the full screen, which saves it, and is nothing
 * to undo. */
struct setting {
	struct command_option option;
	size_t offset;
	bool looks;
};

struct value {
	bool given;
	double number;
	uint64_t whole;
	size_t choice;    /* index into the choices */
	const char *text; /* as typed */
	size_t n;
	double *list;
};

enum { OPTIONS = 28, OPERANDS = 256, EXPECTS = 5, SHARES = 6 };

/* A parsed call.  value[i] belongs to the command's option i; an option with a
 * fallback that was not given has the fallback's value and given = false. */
struct args {
	const struct command *command;
	size_t n_operand;
	const char *operand[OPERANDS];
	struct value value[OPTIONS];
};

/* What a command does.  False with an error where it cannot. */
typedef bool command_run(struct session *, const struct args *, struct error *);

/* What one does that answers a question (cmd/ask/question.h). */
struct question;
typedef bool command_answer(
    struct session *, const struct args *, struct question *, struct error *);

/* What the session has to know of a command. */
enum command_flag {
	COMMAND_CHANGES = 1,   /* changes the session: can be undone */
	COMMAND_FILES = 2,     /* operands are files: refused by --safe */
	COMMAND_VERBATIM = 4,  /* > and | are words like others */
	COMMAND_UNSAVED = 8,   /* save leaves it out, or it sees to it itself */
	COMMAND_LATEST = 16,   /* of several in a row save keeps the last */
	COMMAND_DRAWS = 32,    /* may write into a picture's file */
	COMMAND_AT_SITE = 64,  /* needs a site to work on */
	COMMAND_LOOKS = 128,   /* what it changes alone is not worth keeping */
	COMMAND_PARAMS = 256,  /* its options are the models' parameters */
	COMMAND_SPEC = 512,    /* operands are as VALUE_SPEC */
	COMMAND_BESIDE = 1024, /* on the screen a search goes on beside it */
	COMMAND_KNOWN = 2048,  /* its answer needs the site's parameters */
	COMMAND_DAILY = 4096,  /* of a day's work: help alone shows it */
	COMMAND_CONDITIONS = 8192 /* one is understood without quotes */
};

/* What a command works on: as shown in usage, or NULL; at least `least` and at
 * most `most` of them.  expect: what completion offers for the first, the
 * second ...; the last one holds for all further ones.  Words between spaces:
 * one in capitals stands for what there is (see KINDS in complete.c), others
 * for themselves. */
struct command_operands {
	const char *usage, *expect[EXPECTS];
	size_t least, most;
};

/* name: one word, by which answers are known.  alias: a second name, or NULL;
 * one of two words ("store list") is the first for people.  others: names of
 * commands that are meant instead where a line has an option that only these
 * have, or a range of speeds ("predict 65..85"), which command_meant sees.
 * bare: option that a bare word stands for ("predict 74"), or NULL.
 * setting: options that may be written as two words ("set method classes").
 * text: sentences for help and manual.  more: further ones for the manual, or
 * NULL.  example: lines of a script that runs in
 * a folder with the project's data/. */
struct command {
	const char *name, *alias, *brief;
	const char *others[2];
	struct command_operands operands;
	unsigned flags; /* command_flag */
	const char *bare;
	/* One of the two or none; ends with a name of NULL. */
	const struct command_option *option;
	const struct setting *setting;
	/* Those it takes as others do, of SHARED_...; NULL after the last. */
	const struct command_option *shared[SHARES + 1];
	const char *text, *more, *example;
	/* One of the two. */
	command_run *run;
	command_answer *answer;
};

/* The table's parts, a file for each group; each ends with a name of NULL. */
extern const struct command TABLE_DATA[], TABLE_MODEL[], TABLE_FIT[],
    TABLE_ANSWERS[], TABLE_STORE[], TABLE_PICTURES[], TABLE_SESSION[];

/* Options that several commands take and that are told once; each ends with a
 * name of NULL. */
extern const struct command_option SHARED_TURNS[], SHARED_FEED[],
    SHARED_MACHINE[], SHARED_SIEVES[], SHARED_CUT[], SHARED_SCREENS[];

/* What `set` sets; ends with a name of NULL. */
extern const struct setting SETTINGS[];

/* The table, by group: the first command for NULL, then the one after. NULL
 * at the end. */
const struct command *command_next(const struct command *after);

/* The group it stands in: "answers". */
const char *command_group(const struct command *command);

/* The name that people are told, and the other one or NULL. */
const char *command_title(const struct command *command);
const char *command_other_name(const struct command *command);

/* The command or, of its others, that which its words are for. */
const struct command *command_meant(
    const struct command *command, char *const *word, size_t n);

/* By full name or alias; NULL if there is none. */
const struct command *command_find(const char *name);

/* The same; at a prompt also without case and by a prefix of two letters or
 * more that only one command has. */
const struct command *command_called(const char *name, bool prompt);

/* "calibrate, check": names that begin so, without case.  The caller frees. */
char *command_candidates(const char *name);

/* The name nearest to a mistyped one, or NULL when none is near. */
const char *command_nearest(const char *name);

/* Option i of those it has, counted from 0, its own and then the shared ones;
 * NULL for the first beyond.  The same of its own alone, and of all that are
 * shared. */
const struct command_option *command_option_at(
    const struct command *command, size_t i);
const struct command_option *command_own_option(
    const struct command *command, size_t i);
const struct command_option *command_shared_option(size_t i);

/* "feed, cascade": those it shares with others, "" where there are none.  The
 * caller frees. */
char *command_shared(const struct command *command);

/* Index of an option, or OPTIONS if the command has none of that name. */
size_t command_option_index(const struct command *command, const char *name);

/* "predict [speed=V]": the call as shown in help, with its own options.  The
 * caller frees. */
char *command_usage(const struct command *command);

/* "brief (limits), default D": an option in words.  The caller frees. */
char *command_option_words(const struct command_option *option);

/* The words of an option: "on off"; of one of text as `expect` of operands; of
 * numbers, what may stand instead; or NULL.  A choice without any is one of the
 * breakage models. */
const char *option_choices(const struct command_option *option);

/* What an option may be: "1 to 200 m/s", "on, off".  The caller frees. */
char *command_limits(const struct command_option *option);

/* Whether the value given names a file. */
bool value_is_file(
    const struct command_option *option, const struct value *value);

/* Value of an option of the call; asserts that the command has it. */
const struct value *args_value(const struct args *args, const char *name);

/* Its number where it was given, else `otherwise`. */
double args_number(const struct args *args, const char *name, double otherwise);

#endif
