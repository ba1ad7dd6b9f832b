/* Rows of options of the command table.
 *
 * {NUMBER(tph), "t/h", 1e-3, 1e5, NULL, "", "new feed"} is the option tph=, of
 * which a command reads args->tph.  A row whose member is of another type does
 * not compile.  After a macro come the members of struct command_option that it
 * leaves open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_ROWS_H
#define TIPSPEED_CMD_LANG_ROWS_H

#include "cmd/lang/command.h"
#include "core/psd/site.h"

/* The options of a command, within its row. */
#define OPTION_LIST(...)                \
	(const struct command_option[]) \
	{                               \
		__VA_ARGS__,            \
		{                       \
			.name = NULL    \
		}                       \
	}

#define ROW(option, member, type, k)                              \
	.name = option,                                           \
	.offset = _Generic(&((struct args *)NULL)->member, type * \
			   : offsetof(struct args, member)),      \
	.kind = k

/* The row's unit, least, most, choices, fallback and brief are to be added.
 * NAMED: the option's name is not the member's. */
#define NUMBER_NAMED(option, member) ROW(option, member, double, VALUE_NUMBER)
#define NUMBER(member) NUMBER_NAMED(#member, member)
#define NUMBERS(member) ROW(#member, member, struct number_list, VALUE_NUMBERS)
#define WHOLE(member) ROW(#member, member, uint64_t, VALUE_WHOLE)
#define FEED(member) ROW(#member, member, const char *, VALUE_FEED)

/* Choices, fallback and brief are to be added. */
#define TEXT(member) ROW(#member, member, const char *, VALUE_TEXT), "", 0, 0
#define CHOICE_NAMED(option, member) \
	ROW(option, member, unsigned, VALUE_CHOICE), "", 0, 0
#define CHOICE(member) CHOICE_NAMED(#member, member)

/* Fallback and brief are to be added.  Help shows the words in this order. */
#define OFF_ON_NAMED(option, member) \
	ROW(option, member, bool, VALUE_CHOICE), "", 0, 0, "off on"
#define OFF_ON(member) OFF_ON_NAMED(#member, member)
#define ON_OFF(member) \
	ROW(#member, member, bool, VALUE_CHOICE), "", 0, 0, "on off"

/* Only brief is to be added. */
#define SPEED(member) NUMBER(member), "m/s", 1, SITE_FASTEST, NULL, ""
/* The speed of a question about one speed, see question_use_last_speed. */
#define LAST_OR_USUAL_SPEED                                            \
	SPEED(speed),                                                  \
	    "rotor tip speed; default: that last asked about, else a " \
	    "held-out speed, else 74"
#define PATH(member) \
	ROW(#member, member, const char *, VALUE_FILE), "", 0, 0, NULL, ""
#define SPEC(member) \
	ROW(#member, member, const char *, VALUE_SPEC), "", 0, 0, NULL, ""

#endif
