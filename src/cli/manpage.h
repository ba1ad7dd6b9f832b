/* Shows pages of the manual.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_MANPAGE_H
#define TIPSPEED_CLI_MANPAGE_H

#include <stdbool.h>

/* Shows a page ("tipspeed-site.5") with man(1): the one beside the program
 * where it has not been installed, else the installed one.  False where there
 * is no man(1) or no such page. */
bool manpage_show(const char *page);

#endif
