/* Lists of files to open, with the kind of each.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_FOLDER_H
#define TIPSPEED_TUI_FOLDER_H

#include <stdbool.h>
#include <stddef.h>

#include "core/psd/site.h"

/* Kinds of items, in the order in which they are listed.  FOLDER_SESSION: a
 * script; FOLDER_ABOVE: the parent folder; FOLDER_BELOW: a folder in this one;
 * FOLDER_RESULTS: a file written by tipspeed. */
enum folder_kind {
	FOLDER_SHEET,
	FOLDER_SESSION,
	FOLDER_ABOVE,
	FOLDER_BELOW,
	FOLDER_OTHER,
	FOLDER_RESULTS
};

/* about: for a shipped site, "Granite, 11.2 mm, 69 74 79 m/s"; for
 * FOLDER_RESULTS, "results of predict"; for FOLDER_SESSION, "a saved session";
 * else NULL.  made: the command that makes the item, if it has no file. */
struct folder_item {
	enum folder_kind kind;
	char *name, *path, *about, *made;
};

/* path: "" is the working folder.  why: the reason why it cannot be read, or
 * NULL.  more: it has more items than are listed. */
struct folder {
	size_t n;
	struct folder_item *item;
	char *path;
	const char *why;
	bool more;
};

/* Lists a folder, in the order of enum folder_kind.  Omits hidden items, those
 * with a double quote in their names, and those that are neither folders nor
 * files. */
void folder_list(struct folder *folder, const char *path);

/* Lists the shipped sites: those in the source tree if the program runs in one,
 * otherwise those installed. */
void folder_list_shipped_sites(struct folder *folder);

/* Keeps only the items of these kinds, bits of 1 << kind. */
void folder_filter_by_kind(struct folder *folder, unsigned kinds);

void folder_free(struct folder *folder);

/* Returns the path of the folder to which an item leads: "sub/" or, for the
 * parent of the working folder, "../".  The caller frees it. */
char *folder_path_of_item(const struct folder *folder, size_t item);

/* Returns the command that opens an item other than a folder.  anew: a saved
 * session replaces the current one.  The caller frees it. */
char *folder_command_to_open(const struct folder_item *item, bool anew);

/* Returns a description of a site as it was read, in lines.  The caller frees
 * it. */
char *folder_site_summary_text(const struct site *site);

/* Returns what load would print about a file, in lines, or what it would ask.
 * Does not read a file if that could take long.  The caller frees the text. */
char *folder_item_preview_text(const struct folder_item *item);

#endif
