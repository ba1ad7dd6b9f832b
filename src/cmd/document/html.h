/* Documents as an HTML page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DOCUMENT_HTML_H
#define TIPSPEED_CMD_DOCUMENT_HTML_H

#include "cmd/document/document.h"

/* Returns the page, *n bytes, which the caller frees.  It is a single file of
 * HTML that is also valid XML, with images in SVG; it loads nothing and runs no
 * script.  The same document gives the same bytes. */
char *document_to_html(const struct document *document, size_t *n);

#endif
