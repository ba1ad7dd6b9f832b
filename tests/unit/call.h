/* Parsing a line of text into a call.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_CALL_H
#define TIPSPEED_TESTS_CALL_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "cmd/ask/condition_words.h"
#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"

static const struct place CALL_PLACE = {.file = "script.tip", .line = 3};

/* A parsed line; command is NULL where it was refused. */
struct call {
	struct words words;
	struct args args;
	struct error error;
	const struct command *command;
};

static inline struct call *
call_parse(const char *line)
{
	struct call *call = xcalloc(1, sizeof *call);
	bool split =
	    words_split_line(line, 0, CALL_PLACE, &call->words, &call->error);
	if (split)
		conditions_join_words(&call->words);
	if (split)
		call->command = parse_command_words(
		    &call->words, CALL_PLACE, &call->args, &call->error);
	return call;
}

static inline struct call *
call_accept(const char *line)
{
	struct call *call = call_parse(line);
	if (call->command == NULL)
		fail_msg("%s: %s", line, call->error.text);
	return call;
}

static inline void
call_free(struct call *call)
{
	args_free(&call->args);
	words_free(&call->words);
	free(call);
}

/* As many words as the command wants at least. */
static inline const char *
call_operands(const struct command *command)
{
	static const char *const words[] = {"", "x", "x x", "x x x"};
	return words[command->operands.least];
}

static inline const struct value *
call_value(const struct call *call, const char *name)
{
	size_t i = command_option_index(call->command, name);
	assert_true(i < OPTIONS);
	return &call->args.value[i];
}

#endif
