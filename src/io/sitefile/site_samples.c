/* Gives columns the roles that samples= states by name.  Samples have the names
 * in their headings, or in the rows of a long table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_samples.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sitefile/lexicon.h"

char *
samples_next_item(char **rest)
{
	char *part = *rest, *comma = part != NULL ? strchr(part, ',') : NULL;
	while (comma != NULL && comma > part &&
	       isdigit((unsigned char)comma[-1]) &&
	       isdigit((unsigned char)comma[1]) &&
	       comma[1 + strcspn(comma + 1, "=,")] != '=')
		comma = strchr(comma + 1, ',');
	*rest = comma != NULL ? comma + 1 : NULL;
	if (comma != NULL)
		*comma = '\0';
	return part;
}

static bool
add_sample(struct samples *s, char *part, struct error *error)
{
	char *text = text_trim(part), *cut = strrchr(text, '=');
	bool good = cut != NULL && cut > text && cut[1] != '\0';
	if (!good)
		return error_set(error, ERROR_USAGE,
		    "expected NAME=WHAT in samples, got '%s'\n"
		    "for instance: samples=\"A1=feed, A2=@70\"",
		    text);
	*cut = '\0';
	s->name = xrealloc(s->name, s->n + 1, sizeof(*s->name));
	s->text = xrealloc(s->text, s->n + 1, sizeof(*s->text));
	s->found = xrealloc(s->found, s->n + 1, sizeof *s->found);
	s->name[s->n] = xstrdup(text_trim(text));
	s->text[s->n] = xstrdup(text_trim(cut + 1));
	s->found[s->n++] = false;
	return true;
}

bool
samples_parse(struct samples *s, const char *text, struct error *error)
{
	if (text == NULL)
		return true;
	FREED char *copy = xstrdup(text);
	char *rest = copy;
	for (char *part; (part = samples_next_item(&rest)) != NULL;)
		if (!add_sample(s, part, error))
			return false;
	return true;
}

void
samples_clear(struct samples *s)
{
	for (size_t i = 0; i < s->n; i++) {
		free(s->name[i]);
		free(s->text[i]);
	}
	free(s->name);
	free(s->text);
	free(s->found);
}

/* True if the cells of a row of headings are all different. */
static bool
has_distinct_cells(const struct table *t, size_t r)
{
	const struct cell *cell = t->head[r].cell;
	for (size_t c = 1; c < t->n_col; c++) {
		if (cell[c].text[0] == '\0')
			return false;
		for (size_t k = 1; k < c; k++)
			if (strcasecmp(cell[c].text, cell[k].text) == 0)
				return false;
	}
	return true;
}

bool
samples_have_distinct_names(const struct table *t)
{
	size_t r = 0;
	while (r < t->n_head && t->name == NULL && !has_distinct_cells(t, r))
		r++;
	return t->name != NULL || r < t->n_head;
}

char *
samples_label_of_column(const struct table *t, size_t c)
{
	if (t->name != NULL)
		return xstrdup(t->name[c]);
	for (size_t r = 0; r < t->n_head; r++)
		if (has_distinct_cells(t, r))
			return xstrdup(t->head[r].cell[c].text);
	return layout_heading_text(t, c);
}

/* True if a name is that of a column: its label, or a cell of its headings. */
static bool
is_name_of_column(
    const struct table *t, size_t c, const char *label, const char *name)
{
	bool same = text_same_folded(label, name);
	for (size_t r = 0; r < t->n_head && !same && t->name == NULL; r++)
		same = text_same_folded(t->head[r].cell[c].text, name);
	return same;
}

static void
refuse_contradiction(const struct column *c, const char *text)
{
	sheet_fault(c->table->sheet, c->head,
	    "expected what this heading states, got '%s' in samples=\nleave "
	    "out what contradicts it, or correct the sheet",
	    text);
}

/* Adds the stated meanings of a group; a contradiction is a fault. */
static void
merge_meanings(struct column *c, const char *text, uint64_t group, uint64_t own)
{
	uint64_t stated = c->said.means & group;
	if (stated != 0 && (own & group & ~stated) != 0)
		refuse_contradiction(c, text);
	c->said.means |= own & group;
}

static void
apply_sample_text(struct column *c, const char *text)
{
	static const uint64_t GROUPS[] = {WORD_FEED | WORD_PRODUCT | WORD_SD,
	    WORD_PASSES | WORD_STAYS, WORD_SUMS,
	    WORD_PERCENT | WORD_GRAMS | WORD_SHARE};
	struct head own = head_parse(text), *said = &c->said;
	bool speed = head_has_speed(&own);
	if ((own.means & GROUPS[0]) == 0 && speed)
		own.means |= WORD_PRODUCT;
	for (size_t i = 0; i < ARRAY_LEN(GROUPS); i++)
		merge_meanings(c, text, GROUPS[i], own.means);
	if (own.speed > 0 && said->speed > 0 &&
	    fabs(own.speed - said->speed) > 1e-3)
		refuse_contradiction(c, text);
	if (speed) {
		said->speed = own.speed;
		said->rpm = own.rpm;
		said->unit = own.unit;
	}
	/* The rest of its heads is its name. */
	said->unknown = said->n_number = 0;
	said->several = own.several;
	said->means &= ~(uint64_t)(WORD_SAMPLE | WORD_NUMBER | WORD_OTHER);
}

bool
samples_apply_to_column(struct samples *s, struct column *c)
{
	FREED char *label = samples_label_of_column(c->table, c->at);
	size_t i = 0;
	while (
	    i < s->n && !is_name_of_column(c->table, c->at, label, s->name[i]))
		i++;
	if (i == s->n)
		return false;
	s->found[i] = true;
	apply_sample_text(c, s->text[i]);
	return true;
}

void
samples_report_missing(const struct samples *s, const struct table *t)
{
	enum { SHOWN = 5 };
	size_t i = 0;
	while (i < s->n && s->found[i])
		i++;
	if (i == s->n)
		return;
	FREED char *list = xstrdup("");
	for (size_t c = 1; c < t->n_col && c <= SHOWN; c++) {
		FREED char *label = samples_label_of_column(t, c);
		xappend_to_list(&list, ", ", "%s", label);
	}
	sheet_fault(t->sheet, t->row[0].cell[0],
	    "expected a sample called %s, got none\n"
	    "its samples: %s%s",
	    s->name[i], list, t->n_col > SHOWN + 1 ? ", .." : "");
}
