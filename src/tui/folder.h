/* Lists of files that a site may be read from, and what each would be taken
 * for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_FOLDER_H
#define TIPSPEED_TUI_FOLDER_H

#include <stdbool.h>
#include <stddef.h>

/* In the order that they are listed in. */
enum folder_kind {
	FOLDER_SHEET,
	FOLDER_SESSION,
	FOLDER_ABOVE,
	FOLDER_BELOW,
	FOLDER_OTHER,
	FOLDER_RESULTS
};

/* about: of a site that comes with the program, "Granite, 11.2 mm, 69 74 79
 * m/s"; of FOLDER_RESULTS "results of predict", of FOLDER_SESSION what it is;
 * else NULL.  made: the command that makes it, where there is no file. */
struct folder_item {
	enum folder_kind kind;
	char *name, *path, *about, *made;
};

/* path: "" is the one that the program runs in.  item [n].  why: it cannot be
 * read, or NULL; more: not all of it are listed. */
struct folder {
	size_t n;
	struct folder_item *item;
	char *path;
	const char *why;
	bool more;
};

/* What of a folder can be opened: sheets, the folder above, folders, other
 * files; hidden ones are left out, and what is neither folder nor file. */
void folder_list(struct folder *folder, const char *path);

/* The sites that come with the program: those of the source tree where it runs
 * in one, else as installed. */
void folder_shipped(struct folder *folder);

/* Leaves only what has the word in its name or in what it is about. */
void folder_narrow(struct folder *folder, const char *word);

/* Leaves folders, and files of that kind. */
void folder_only(struct folder *folder, enum folder_kind kind);

void folder_free(struct folder *folder);

/* "sub/" and ".." from "sub": the folder that an item leads to.  The caller
 * frees. */
char *folder_into(const struct folder *folder, size_t item);

/* The command that opens an item which is no folder; anew: a session takes the
 * place of what there is.  The caller frees. */
char *folder_command(const struct folder_item *item, bool anew);

/* What load would say of a file, in lines, or what it would ask.  The file is
 * not read where that could take long.  The caller frees. */
char *folder_preview(const struct folder_item *item);

#endif
