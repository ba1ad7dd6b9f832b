/* Documents as A4 pages in PDF.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DOCUMENT_PDF_H
#define TIPSPEED_CMD_DOCUMENT_PDF_H

#include "cmd/document/document.h"

/* Returns the file, *n bytes, which the caller frees, and the number of its
 * pages.  NULL if this program cannot draw PDF, see picture_can_draw_format.
 * The same document gives the same bytes. */
char *document_to_pdf(
    const struct document *document, size_t *n, size_t *pages);

#endif
