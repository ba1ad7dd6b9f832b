/* Paths of the user's own files, by the XDG base directories.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_XDG_H
#define TIPSPEED_IO_FS_XDG_H

/* tipspeed/NAME in the folder that the variable names, else in the folder of
 * HOME given; NULL where neither is known.  The caller frees. */
char *home_path(const char *variable, const char *folder, const char *name);

/* Makes the folders of a file, for the user alone.  NULL, or the folder that
 * cannot be made, with errno; the caller frees. */
char *home_make_folders(const char *path);

#endif
