/* Scrolling and choosing; the pane draws it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/pane.h"

/* Counts the lines, and the columns of the widest. */
static void
measure(struct viewer *v)
{
	for (const char *p = v->text; *p != '\0'; v->lines++) {
		size_t n = strcspn(p, "\n");
		char *line = xstrndup(p, n);
		int width = text_width(line);
		v->columns = width > v->columns ? width : v->columns;
		p += n + (p[n] == '\n');
		free(line);
	}
}

void
view_close(struct tui *t)
{
	free(t->viewer.text);
	t->viewer = (struct viewer){0};
}

void
view_text(struct tui *t, char *text)
{
	view_close(t);
	t->viewer = (struct viewer){.text = text};
	measure(&t->viewer);
}

void
view_keys(struct tui *t, const char *word)
{
	char kept[sizeof t->viewer.word], *text = NULL;
	size_t n = 0;
	bool filtering = t->viewer.filtering;
	snprintf(kept, sizeof kept, "%s", word);
	FILE *out = text_memory(&text, &n);
	keys_list(kept, out);
	fclose(out);
	view_text(t, text);
	t->viewer.keys = true;
	t->viewer.filtering = filtering;
	memcpy(t->viewer.word, kept, sizeof kept);
}

/* A character of the word behind '/'; false where it is none. */
static bool
filter(struct tui *t, int code, bool special)
{
	struct viewer *v = &t->viewer;
	char word[sizeof v->word] = {0}; /* ends wherever it is cut */
	bool back = !special && (code == 127 || code == '\b');
	if (!v->keys || (!v->filtering && code != '/'))
		return false;
	if (!v->filtering) {
		v->filtering = true;
		return true;
	}
	snprintf(word, sizeof word, "%s", v->word);
	size_t n = strlen(word);
	if (back && n > 0)
		word[n - 1] = '\0';
	else if (back || special || code < ' ' || code >= 127)
		return false;
	else if (n + 1 < sizeof word)
		word[n] = (char)code;
	view_keys(t, word);
	return true;
}

static void
scroll_by(struct tui *t, int by)
{
	struct viewer *v = &t->viewer;
	int rows = t->places.body.rows > 1 ? t->places.body.rows : 1;
	int last = v->lines - 1;
	if (v->keys) {
		v->at += by;
		v->at = v->at > last ? last : v->at;
		v->at = v->at < 0 ? 0 : v->at;
		if (v->at >= v->top + rows)
			v->top = v->at - rows + 1;
		if (v->at < v->top)
			v->top = v->at;
		return;
	}
	v->top += by;
	v->top = v->top > v->lines - rows ? v->lines - rows : v->top;
	v->top = v->top < 0 ? 0 : v->top;
}

/* Where lines are wider than the screen; the list of keys shows the rest of the
 * one that is chosen. */
static bool
shift_by(struct tui *t, int by)
{
	struct viewer *v = &t->viewer;
	int last = v->columns - t->places.body.columns;
	if (v->keys || last <= 0)
		return false;
	v->left += by;
	v->left = v->left > last ? last : v->left;
	v->left = v->left < 0 ? 0 : v->left;
	return true;
}

const struct key *
view_key(struct tui *t, int code, bool special)
{
	struct viewer *v = &t->viewer;
	const struct key *key = keys_find(code, t->page), *chosen = NULL;
	int page = t->places.body.rows > 2 ? t->places.body.rows - 1 : 1;
	if (filter(t, code, special))
		return NULL;
	if (key != NULL && key->act == ACT_LIST) {
		scroll_by(t, key->amount);
		return NULL;
	}
	int aside = key != NULL && key->act == ACT_MOVE ? key->amount : 0;
	if (aside != 0 && shift_by(t, aside * t->places.body.columns / 2))
		return NULL;
	if (special && (code == PANE_PAGE_DOWN || code == PANE_PAGE_UP)) {
		scroll_by(t, code == PANE_PAGE_DOWN ? page : -page);
		return NULL;
	}
	if (code == ' ') {
		scroll_by(t, page);
		return NULL;
	}
	if (v->keys && (code == '\n' || code == '\r'))
		chosen = keys_nth(v->word, (size_t)v->at);
	view_close(t);
	return chosen;
}
