/* Shows manual pages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_MANPAGE_H
#define TIPSPEED_CLI_MANPAGE_H

#include <stdbool.h>

/* Shows a page ("tipspeed-site.5") with man(1): the page in the build tree for
 * a program not yet installed, or else the installed page.  Returns false if
 * there is no man(1) or no such page. */
bool manpage_show(const char *page);

#endif
