/* Ranges of cells as text, and freeing of questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_request.h"

#include <ctype.h>
#include <stdlib.h>

#include "base/xalloc.h"

/* "AB12" */
static char *
cell_name(int column, int line)
{
	char letters[8] = "", *first = letters + sizeof letters - 1;
	for (int c = column; c > 0 && first > letters; c = (c - 1) / 26)
		*--first = (char)('A' + (c - 1) % 26);
	return xasprintf("%s%d", first, line);
}

char *
site_box_text(struct site_box box)
{
	FREED char *from = cell_name(box.left, box.top);
	FREED char *to = cell_name(box.right, box.bottom);
	return xasprintf("%s:%s", from, to);
}

/* "A3" as column 1 and line 3. */
static const char *
read_corner(const char *p, int *column, int *line)
{
	*column = *line = 0;
	for (; isalpha((unsigned char)*p) && *column < 1000; p++)
		*column = 26 * *column + (toupper((unsigned char)*p) - 'A') + 1;
	for (; isdigit((unsigned char)*p) && *line < 1000000; p++)
		*line = 10 * *line + (*p - '0');
	return *column > 0 && *line > 0 ? p : NULL;
}

bool
site_box_read(const char *text, struct site_box *box)
{
	const char *p = read_corner(text, &box->left, &box->top);
	if (p == NULL || *p != ':')
		return false;
	p = read_corner(p + 1, &box->right, &box->bottom);
	return p != NULL && *p == '\0';
}

struct site_box
site_ask_box(const struct site_ask *ask, size_t from, size_t to)
{
	struct site_box all = ask->column[from].box;
	for (size_t i = from + 1; i <= to; i++) {
		const struct site_box *box = &ask->column[i].box;
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
