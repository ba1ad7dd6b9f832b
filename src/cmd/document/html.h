/* Documents as a page of HTML.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DOCUMENT_HTML_H
#define TIPSPEED_CMD_DOCUMENT_HTML_H

#include "cmd/document/document.h"

/* Returns the page, *n bytes, which the caller frees: HTML that is XML too, in
 * one file, with images as SVG; it fetches nothing and runs no script.  The
 * same document gives the same bytes. */
char *document_html(const struct document *document, size_t *n);

#endif
