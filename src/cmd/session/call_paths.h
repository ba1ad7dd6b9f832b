/* The paths in the words of a call.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_CALL_PATHS_H
#define TIPSPEED_CMD_SESSION_CALL_PATHS_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Returns the path in a word of the call, which is the word itself or the value
 * of an option, or NULL if it has none.  A goal, a blend of feeds and a feed
 * with its speed count as paths.  *option: the option, or NULL. */
const char *call_path_in_word(const struct args *args, const char *word,
    const struct command_option **option);

/* Returns the @ of a file with a speed or a time, "cut.csv@70"; NULL if there
 * is none, or if it is part of the file's name. */
const char *call_path_at_sign(const char *word);

/* Returns the length of the path, or of what is before an @ or = in it, if that
 * is a file or folder, else 0. */
size_t call_path_length_of_file(const char *path);

/* Returns what call_path_in_word returned with each path in it as map returns
 * it.  The caller frees it. */
char *call_paths_map(const struct command_option *option, const char *paths,
    char *(*map)(const char *path, const void *of), const void *of);

/* In a line of a script in `folder`, replaces the relative names of files that
 * the command reads, and that are in this folder, by their paths, but not that
 * of a file that the session wrote.  Returns true if it replaced any; then the
 * words have to be parsed again. */
bool call_paths_find_in_folder(const struct session *s, const struct args *args,
    struct words *words, const char *folder);

#endif
