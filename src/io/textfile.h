/* A text file as a string of UTF-8, or what it is instead.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_TEXTFILE_H
#define TIPSPEED_IO_TEXTFILE_H

#include "base/error.h"

/* All of a file of at most 10 MB without its byte order mark; the caller
 * frees.  NULL and one fault when it cannot be read (ERROR_SYSTEM), is larger
 * (seen before it is read), is empty, or holds something other than UTF-8. */
char *textfile_read(const char *path, struct error_list *errors);

#endif
