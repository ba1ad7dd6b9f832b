/* Paths of the user's files, following the XDG Base Directory Specification.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_XDG_H
#define TIPSPEED_IO_FS_XDG_H

/* Returns the path tipspeed/NAME in the folder that the environment variable
 * names or, if it is not set, in the given folder of HOME; NULL if neither is
 * known.  The caller frees it. */
char *xdg_user_file_path(
    const char *variable, const char *folder, const char *name);

/* Makes the folders above a file, accessible only to the user.  Returns NULL on
 * success, or the folder that cannot be made, with errno set; the caller frees
 * it. */
char *xdg_make_parent_folders(const char *path);

#endif
