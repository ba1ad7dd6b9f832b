/* The command table: all commands, as data.
 *
 * The parser, usage lines, help, the manual's COMMANDS section and several
 * tests read this table; to add a command, add a row and a function.
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
	VALUE_FILE,    /* path */
	VALUE_FEED,    /* a number, or the path of a sheet with a feed */
	VALUE_SPEC,    /* path of an envelope, or the name of a shipped
			* envelope */
	VALUE_TEXT
};

/* A key=value option of a command, or a setting. */
struct command_option {
	const char *name;
	enum value_kind kind;
	const char *unit;    /* "m/s"; "" if none */
	double least, most;  /* of numbers */
	const char *choices; /* see option_choices */
	/* The default, as typed; "" if there is none or, for a setting, if the
	 * session determines it. */
	const char *fallback;
	const char *brief;
	/* The offset of the member that gets the value, in struct args.  For a
	 * setting, in struct settings: a double for a number, a char array for
	 * a text, else an unsigned or an enum. */
	size_t offset;
	/* The word without which the option has no effect: an operand, or
	 * another option with a value to propose, which words to propose too
	 * may follow; a > among them: a file of results will do.  Or NULL. */
	const char *needs;
	/* A setting about the look of the full screen, which saves it; undo
	 * ignores it. */
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

struct number_list {
	size_t n;
	const double *at;
};

enum { OPTIONS = 28, OPERANDS = 256, EXPECTS = 5, SHARES = 6 };

/* A parsed call.  The members after `value` are the values of all options, by
 * name: the one given, else the fallback, else 0, NULL or false, even if the
 * command has no such option; args_is_given tells whether it was given.  A
 * choice is an index into the option's choices.  See rows.h. */
struct args {
	const struct command *command;
	size_t n_operand;
	const char *operand[OPERANDS];
	/* Where each operand begins in the line. */
	int column[OPERANDS];
	/* What was parsed for each of the command's options. */
	struct value value[OPTIONS];

	/* Of questions. */
	double speed, rpm, rotor_mm, cascade, k, sharpness, cut_size, from, to;
	struct number_list speeds, sieves;
	const char *feed, *cut, *of, *spec;
	unsigned correction;
	bool detail, replace, band;
	/* Of answers. */
	double p20, p50, p80, passing, at, noise, speed_sd, h;
	bool curve, interpolated;
	unsigned probability;
	uint64_t n, nearest;
	/* Of flow. */
	double tph, kwh;
	const char *fractions, *recycle, *circuit, *power, *prices;
	bool best;
	/* Of calibrations. */
	uint64_t seed, population, generations, stall, threads, pause, every;
	double tolerance;
	struct number_list train, run_weights;
	bool polish, watch, by_sieve;
	unsigned weights, preset, holdout;
	const char *part;
	/* Of pictures. */
	double other, other_feed, level, width, height;
	const char *beside, *site, *limits, *param, *keys;
	uint64_t generation;
	unsigned charset, colours, page;
	/* Of sheets. */
	const char *columns, *samples, *sheet, *range, *digest, *out;
	unsigned as, decimal, dates, unit;
	double top, window, exponent, energy_cut;
	bool skip;
	/* Of mend. */
	double sieve, scale, mend_value;
	const char *with;
	unsigned mend_do;
	/* Of the store, and of the session. */
	const char *rock, *date, *note;
	unsigned origin;
	uint64_t most;
	bool state;
};

/* Runs a command.  On failure, returns false with an error. */
typedef bool command_run(struct session *, const struct args *, struct error *);

/* Runs a command that answers a question (cmd/ask/question.h). */
struct question;
typedef bool command_answer(
    struct session *, const struct args *, struct question *, struct error *);

/* Properties of a command. */
enum command_flag {
	COMMAND_CHANGES = 1,      /* changes the session: can be undone */
	COMMAND_FILES = 2,        /* operands are files: refused by --safe */
	COMMAND_VERBATIM = 4,     /* > and | are ordinary words */
	COMMAND_UNSAVED = 8,      /* save omits it, or it adds its own line */
	COMMAND_KEEPS_LAST = 16,  /* save keeps only the last of a series */
	COMMAND_DRAWS = 32,       /* may write to an image file */
	COMMAND_NEEDS_SITE = 64,  /* needs a site to work on */
	COMMAND_APPEARANCE = 128, /* its changes alone need no saving */
	COMMAND_PARAMS = 256,     /* its options are the models' parameters */
	COMMAND_SPEC = 512,       /* operands are like VALUE_SPEC */
	COMMAND_DURING_SEARCH =
	    1024, /* full screen: a search goes on meanwhile */
	COMMAND_NEEDS_PARAMS =
	    2048,                   /* its answer needs the site's parameters */
	COMMAND_DAILY = 4096,       /* in daily use: shown by plain `help` */
	COMMAND_CONDITIONS = 8192,  /* conditions need no quotes */
	COMMAND_QUANTITIES = 16384, /* words that name quantities become of= */
	COMMAND_SETTINGS = 32768 /* settings, which may be typed as two words */
};

struct command_operands {
	/* usage: as help shows it, or NULL.  expect: what completion offers for
	 * the first, the second and further operands; the last entry applies to
	 * all that follow.  Of the words in it, separated by spaces, those in
	 * capitals stand for what exists (see KINDS in complete.c), others for
	 * themselves. */
	const char *usage, *expect[EXPECTS];
	size_t least, most;
};

/* A command: a row of the table. */
struct command {
	/* name: one word, under which answers are kept.  alias: a second name,
	 * or NULL; if it has two words ("store list"), people are shown this
	 * one. */
	const char *name, *alias, *brief;
	/* Commands that are meant instead if the line has an option that only
	 * they have, or a range of speeds ("predict 65..85"); see
	 * command_find_by_options. */
	const char *others[3];
	struct command_operands operands;
	unsigned flags; /* command_flag */
	/* The option that a word without = sets ("predict 74"), or NULL. */
	const char *bare;
	/* NULL, or ends with a NULL name. */
	const struct command_option *option;
	/* Options shared with other commands, from SHARED_..; ends with
	 * NULL. */
	const struct command_option *shared[SHARES + 1];
	/* text: sentences for help and manual.  more: further ones for the
	 * manual, or NULL.  example: lines of a script that runs in a folder
	 * with the project's data/. */
	const char *text, *more, *example;
	/* Exactly one of these. */
	command_run *run;
	command_answer *answer;
};

/* The parts of the table, one for each group of commands; each ends with a NULL
 * name. */
extern const struct command TABLE_DATA[], TABLE_MODEL[], TABLE_FIT[],
    TABLE_ANSWERS[], TABLE_STORE[], TABLE_PICTURES[], TABLE_SESSION[];

/* Options that several commands share; each list ends with a NULL name. */
extern const struct command_option SHARED_RPM[], SHARED_FEED[],
    SHARED_MACHINE[], SHARED_SIEVES[], SHARED_CUT[], SHARED_SCREENS[];

/* The settings, ending with a NULL name. */
extern const struct command_option SETTINGS[];

/* Goes through the table by group: returns the command after this one, the
 * first if `after` is NULL, and NULL after the last. */
const struct command *command_next(const struct command *after);

/* Returns the group of a command, such as "answers". */
const char *command_group_name(const struct command *command);

/* Return the name shown to people, and the other name, or NULL. */
const char *command_shown_name(const struct command *command);
const char *command_other_name(const struct command *command);

/* Returns the command that the words after its name call for: one of its
 * `others`, or the command itself. */
const struct command *command_find_by_options(
    const struct command *command, char *const *word, size_t n);

/* Returns the command with exactly this name or alias, or NULL. */
const struct command *command_find(const char *name);

/* As command_find; at a prompt it also ignores case, and accepts a unique
 * beginning of at least two letters, and q for quit. */
const struct command *command_find_abbreviated(const char *name, bool prompt);

/* Returns the names of the commands that begin with `name`, ignoring case:
 * "calibrate, check".  The caller frees it. */
char *command_names_beginning_with(const char *name);

/* Returns the name of the command that a mistyped name or one from another
 * program may mean, or NULL. */
const char *command_nearest_name(const char *name);

/* Return option i, from 0, or NULL after the last.  command_option_at counts
 * the command's own options, then those that it shares with others;
 * command_own_option_at only its own; command_shared_option_at those that any
 * commands share. */
const struct command_option *command_option_at(
    const struct command *command, size_t i);
const struct command_option *command_own_option_at(
    const struct command *command, size_t i);
const struct command_option *command_shared_option_at(size_t i);

/* Returns the names of the options that the command shares with others, "feed,
 * cascade", or "".  The caller frees it. */
char *command_shared_option_names(const struct command *command);

/* Returns the index of the option with that name, or OPTIONS. */
size_t command_option_index(const struct command *command, const char *name);

/* True if the operands of the command are speeds. */
bool command_takes_speeds(const struct command *command);

/* Returns the call with the command's own options as help shows it: "predict
 * [speed=V]".  The caller frees it. */
char *command_usage_text(const struct command *command);

/* Returns the help about an option: "brief (limits), default D".  The caller
 * frees it. */
char *command_option_help_text(const struct command_option *option);

/* Returns the words of a choice, "on off", which are the breakage models if it
 * has none; for a text, what completion offers, as `expect` of operands; for
 * numbers, words allowed instead; or NULL. */
const char *option_choices(const struct command_option *option);

/* Returns the values that an option may have: "1 to 200 m/s" or "on, off".  The
 * caller frees it. */
char *command_option_valid_values_text(const struct command_option *option);

/* True if the value names a file. */
bool value_is_file(
    const struct command_option *option, const struct value *value);

/* About the option whose value is this member of args: args_is_given is true if
 * it was given, args_value_text returns its value as typed, args_option_name
 * its name.  For the latter two, the command must have the option. */
bool args_is_given(const struct args *args, const void *member);
const char *args_value_text(const struct args *args, const void *member);
const char *args_option_name(const struct args *args, const void *member);

#endif
