/* Reads the lines right above each table: which sample it has, how fast.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_title.h"

#include <stdlib.h>

#include "io/sitefile/column_header.h"
#include "io/sitefile/lexicon.h"
#include "io/sitefile/site_heading.h"

static bool
has_speed(const struct head *head)
{
	return head->speed > 0 || head->rpm > 0;
}

/* Whether cell c of a line may head a table: within three lines above it, and
 * no key with its value. */
static bool
is_above(const struct table *t, const struct row *row, size_t c)
{
	int top = t->n_head > 0 ? t->head[0].line : t->row[0].line;
	return row->line < top && row->line >= top - 3 &&
	       vocabulary_key(row->cell[0].text) == N_KEY &&
	       (row->n == 1 || row->cell[c].column >= t->row[0].cell[0].column);
}

/* Whether words say which sample a table has. */
static bool
is_title(const struct head *head)
{
	return (head->means & (WORD_FEED | WORD_PRODUCT)) != 0 ||
	       has_speed(head);
}

bool
title_heads_any(const struct layout *layout, const struct row *row)
{
	for (size_t b = 0; b < layout->n; b++)
		for (size_t c = 0; c < row->n; c++) {
			struct head title = head_read(row->cell[c].text);
			if (is_above(&layout->table[b], row, c) &&
			    is_title(&title))
				return true;
		}
	return false;
}

/* One cell with something in it: a title. */
static bool
is_alone(const struct row *row)
{
	size_t filled = 0;
	for (size_t i = 0; i < row->n; i++)
		filled += (size_t)(row->cell[i].text[0] != '\0');
	return filled == 1;
}

uint64_t
title_context(const struct layout *layout, const struct table *t,
    const char *path, struct surroundings *near)
{
	uint64_t means = vocabulary_text(t->sheet->name, NULL);
	struct head name = head_read(t->sheet->name);
	near->speed = near->speed > 0 ? near->speed : name.speed;
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		for (size_t c = 0; c < row->n; c++) {
			if (!is_above(t, row, c))
				continue;
			struct head title = head_read(row->cell[c].text);
			near->strange =
			    near->strange ||
			    (is_alone(row) &&
				(title.unknown > 0 ||
				    (title.means & (WORD_LIMIT | WORD_MEAN |
						       WORD_MACHINE)) != 0));
			if (!is_title(&title))
				continue;
			uint64_t role =
			    title.means & (WORD_FEED | WORD_PRODUCT);
			means = role != 0 ? role : means;
			if (!title.several && has_speed(&title)) {
				near->speed = title.speed;
				near->rpm = title.rpm;
			}
			break;
		}
	}
	if ((means & (WORD_FEED | WORD_PRODUCT)) == 0) {
		char *stem = site_heading_name(path);
		means |= vocabulary_text(stem, NULL);
		free(stem);
	}
	return means;
}
