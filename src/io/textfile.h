/* A text file as a string of UTF-8, or what it is instead.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_TEXTFILE_H
#define TIPSPEED_IO_TEXTFILE_H

#include <stdio.h>

#include "base/error.h"

/* Opens a file to read; also a pipe, once somebody writes to it: that is waited
 * for a minute at most, and not after a signal.  NULL and why, for people,
 * where it cannot be, and for devices other than /dev/null: these may have no
 * end. */
FILE *textfile_open(const char *path, const char **why);

/* All of a file of at most 10 MB without its byte order mark; the caller
 * frees.  NULL and one fault when it cannot be read (ERROR_SYSTEM), is larger
 * (seen before it is read), is empty, or holds something other than UTF-8. */
char *textfile_read(const char *path, struct error_list *errors);

#endif
