/* Converts requests and ranges of cells to text, and frees questions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_request.h"

#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/sheet.h"

char *
site_request_file_text(const struct site_request *q, size_t i)
{
	double given = q->speed != NULL ? q->speed[i] : 0;
	char number[32];
	if (given == 0)
		return xstrdup(q->path[i]);
	return xasprintf("%s@%s%s", q->path[i],
	    text_shortest_exact_number(fabs(given), number),
	    given < 0 ? "rpm" : "");
}

char *
site_request_options_text(const struct site_request *q)
{
	char *text = xstrdup(""), number[32];
	if (q->columns != NULL)
		xappend(&text, " columns=\"%s\"", q->columns);
	if (q->samples != NULL)
		xappend(&text, " samples=\"%s\"", q->samples);
	if (q->sheet != NULL)
		xappend(&text, " sheet=\"%s\"", q->sheet);
	if (q->range != NULL)
		xappend(&text, " range=%s", q->range);
	if (q->decimal != '\0')
		xappend(&text, " decimal=%s",
		    q->decimal == ',' ? "comma" : "point");
	if (q->rotor > 0)
		xappend(&text, " rotor_mm=%.15g", 1000 * q->rotor);
	if (q->top > 0)
		xappend(&text, " top=%s",
		    text_shortest_exact_number(q->top, number));
	return text;
}

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
