/* Converts ranges of cells to and from text, and frees questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_request.h"

#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/sheet.h"

char *
cell_range_text(struct cell_range box)
{
	char left[8], right[8];
	return xasprintf("%s%d:%s%d", text_column_letters(box.left, left),
	    box.top, text_column_letters(box.right, right), box.bottom);
}

bool
cell_range_parse(const char *text, struct cell_range *box)
{
	const char *p = sheet_parse_cell_address(text, &box->left, &box->top);
	if (p == NULL || *p != ':')
		return false;
	p = sheet_parse_cell_address(p + 1, &box->right, &box->bottom);
	return p != NULL && *p == '\0';
}

struct cell_range
cell_range_around_tables(const struct site_ask *ask, size_t from, size_t to)
{
	struct cell_range all = ask->column[from].box;
	for (size_t i = from + 1; i <= to; i++) {
		const struct cell_range *box = &ask->column[i].box;
		all.top = box->top < all.top ? box->top : all.top;
		all.left = box->left < all.left ? box->left : all.left;
		all.bottom =
		    box->bottom > all.bottom ? box->bottom : all.bottom;
		all.right = box->right > all.right ? box->right : all.right;
	}
	return all;
}

void
site_ask_clear(struct site_ask *ask)
{
	for (size_t i = 0; i < ask->n; i++) {
		free(ask->column[i].head);
		free(ask->column[i].values);
		free(ask->column[i].guess);
	}
	free(ask->column);
	free(ask->settle);
	*ask = (struct site_ask){0};
}
