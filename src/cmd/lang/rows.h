/* Macros for the options in rows of the command table.
 *
 * {NUMBER(tph), "t/h", 1e-3, 1e5, NULL, "", "new feed"} is the option tph=,
 * which a command reads as args->tph.  A row does not compile if that member
 * has another type.  After each macro come the members of struct command_option
 * that it does not set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_ROWS_H
#define TIPSPEED_CMD_LANG_ROWS_H

#include "cmd/lang/command.h"
#include "core/psd/site.h"

/* The list of options in a command's row. */
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

/* After these come unit, least, most, choices, fallback and brief.  NAMED: the
 * option and the member have different names. */
#define NUMBER_NAMED(option, member) ROW(option, member, double, VALUE_NUMBER)
#define NUMBER(member) NUMBER_NAMED(#member, member)
#define NUMBERS(member) ROW(#member, member, struct number_list, VALUE_NUMBERS)
#define WHOLE(member) ROW(#member, member, uint64_t, VALUE_WHOLE)
#define FEED(member) ROW(#member, member, const char *, VALUE_FEED)

/* After these come choices, fallback and brief. */
#define TEXT(member) ROW(#member, member, const char *, VALUE_TEXT), "", 0, 0
#define CHOICE_NAMED(option, member) \
	ROW(option, member, unsigned, VALUE_CHOICE), "", 0, 0
#define CHOICE(member) CHOICE_NAMED(#member, member)

/* After these come fallback and brief.  Help shows the words in this order. */
#define OFF_ON_NAMED(option, member) \
	ROW(option, member, bool, VALUE_CHOICE), "", 0, 0, "off on"
#define OFF_ON(member) OFF_ON_NAMED(#member, member)
#define ON_OFF(member) \
	ROW(#member, member, bool, VALUE_CHOICE), "", 0, 0, "on off"

/* After these comes only brief. */
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
