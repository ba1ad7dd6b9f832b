/* Edits one line, without a screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/edit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <curses.h>
#include <readline/history.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/run/complete.h"
#include "plot/canvas.h"
#include "tui/keys.h"

#define CONTROL(letter) ((letter)&0x1F)

static void
edit_set_text(struct edit *t, const char *text)
{
	snprintf(t->text, sizeof t->text, "%s", text);
	t->n = t->at = strlen(t->text);
}

/* Replaces the bytes from start to the cursor. */
static void
replace_before_cursor(struct edit *t, size_t start, const char *text, size_t n)
{
	if (t->n - (t->at - start) + n + 1 > sizeof t->text)
		return;
	memmove(t->text + start + n, t->text + t->at, t->n - t->at + 1);
	memcpy(t->text + start, text, n);
	t->n = t->n - (t->at - start) + n;
	t->at = start + n;
}

void
edit_begin(struct edit *t, const char *text)
{
	edit_stop_editing(t);
	t->active = true;
	t->back = 0;
	t->fresh = 0;
	edit_set_text(t, text);
}

void
edit_begin_with_proposal(struct edit *t, const char *text, const char *name)
{
	edit_begin(t, text);
	t->fresh = t->n;
	replace_before_cursor(t, t->n, name, strlen(name));
}

void
edit_stop_editing(struct edit *t)
{
	xfree_and_set(&t->offers, NULL);
	t->active = false;
}

static void
insert_letter_at_cursor(struct edit *t, unsigned code)
{
	char letter[5];
	canvas_encode_code_point(code, letter);
	replace_before_cursor(t, t->at, letter, strlen(letter));
}

/* previous_letter_offset returns the offset of the character before an offset;
 * next_letter_offset that of the one after it. */
static size_t
previous_letter_offset(const struct edit *t, size_t at)
{
	while (at > 0 && (t->text[--at] & 0xC0) == 0x80)
		;
	return at;
}

static size_t
next_letter_offset(const struct edit *t, size_t at)
{
	while (at < t->n && (t->text[++at] & 0xC0) == 0x80)
		;
	return at;
}

static size_t
start_of_word_before(const struct edit *t)
{
	size_t at = t->at;
	while (at > 0 && t->text[at - 1] == ' ')
		at--;
	while (at > 0 && t->text[at - 1] != ' ')
		at--;
	return at;
}

static void
go_back_in_history(struct edit *t, int by)
{
	int back = t->back + by;
	if (back < 0 || back > history_length)
		return;
	t->back = back;
	edit_set_text(
	    t, back == 0
		   ? ""
		   : history_get(history_base + history_length - back)->line);
}

/* Returns the length, in bytes, of what all candidates begin with. */
static size_t
candidates_shared_prefix_bytes(const struct completion *c)
{
	const char *first = c->candidate[0].text;
	size_t n = strlen(first);
	for (size_t i = 1; i < c->n; i++) {
		size_t same =
		    text_shared_prefix_bytes(first, c->candidate[i].text);
		n = same < n ? same : n;
	}
	return n;
}

static void
format_completion_list(struct edit *t, const struct completion *c)
{
	size_t n = 0;
	FILE *out = text_open_memory(&t->offers, &n);
	for (size_t i = 0; i < c->n; i++)
		fprintf(out, "%s%s%s", i > 0 ? "  " : "", c->candidate[i].text,
		    c->candidate[i].append == '=' ? "=" : "");
	fclose(out);
}

static void
complete_word(struct edit *t, const struct session *s)
{
	struct completion *c = find_completions_at_cursor(s, t->text, t->at);
	if (c->n > 0)
		replace_before_cursor(t, c->start, c->candidate[0].text,
		    candidates_shared_prefix_bytes(c));
	if (c->n == 1 && c->candidate[0].append != '\0')
		insert_letter_at_cursor(
		    t, (unsigned char)c->candidate[0].append);
	t->start = c->start;
	if (c->n > 1)
		format_completion_list(t, c);
	completion_free(c);
}

static void
edit_handle_special_key(struct edit *t, int code)
{
	if (code == KEY_LEFT)
		t->at = previous_letter_offset(t, t->at);
	else if (code == KEY_RIGHT)
		t->at = next_letter_offset(t, t->at);
	else if (code == KEY_HOME)
		t->at = 0;
	else if (code == KEY_END)
		t->at = t->n;
	else if (code == KEY_UP || code == KEY_DOWN)
		go_back_in_history(t, code == KEY_UP ? 1 : -1);
	else if (code == KEY_DC && t->at < t->n)
		t->at = next_letter_offset(t, t->at);
	else if (code != KEY_BACKSPACE)
		return;
	if (code == KEY_DC || code == KEY_BACKSPACE)
		replace_before_cursor(
		    t, previous_letter_offset(t, t->at), "", 0);
}

/* Returns the key that a control key stands for, or 0. */
static int
key_of_control_code(int code)
{
	static const struct {
		int code, key;
	} SHORT[] = {{CONTROL('A'), KEY_HOME}, {CONTROL('E'), KEY_END},
	    {CONTROL('B'), KEY_LEFT}, {CONTROL('F'), KEY_RIGHT},
	    {CONTROL('P'), KEY_UP}, {CONTROL('N'), KEY_DOWN},
	    {CONTROL('D'), KEY_DC}, {CONTROL('H'), KEY_BACKSPACE},
	    {DELETE, KEY_BACKSPACE}};
	for (size_t i = 0; i < ARRAY_LEN(SHORT); i++)
		if (SHORT[i].code == code)
			return SHORT[i].key;
	return 0;
}

const char *
edit_get_nth_offered_completion(const struct edit *t, size_t n, size_t *length)
{
	const char *offer = t->offers;
	while (offer != NULL && n-- > 0) {
		offer = strstr(offer, "  ");
		offer = offer != NULL ? offer + 2 : NULL;
	}
	const char *end = offer != NULL ? strstr(offer, "  ") : NULL;
	*length = end != NULL     ? (size_t)(end - offer)
		  : offer != NULL ? strlen(offer)
				  : 0;
	return offer;
}

size_t
edit_first_unshown_completion(const struct edit *t)
{
	size_t next = t->from + t->shown, length;
	return edit_get_nth_offered_completion(t, next, &length) != NULL ? next
									 : 0;
}

enum edit_result
edit_handle_key(struct edit *t, const struct session *s, int code, bool special)
{
	int key = special ? code : key_of_control_code(code);
	size_t next = edit_first_unshown_completion(t), n = t->n;
	xfree_and_set(&t->offers, NULL);
	if (!special && (code == ESCAPE || code == INTERRUPT))
		return EDIT_GIVEN_UP;
	if (key == KEY_BACKSPACE && t->n == 0)
		return EDIT_GIVEN_UP;
	if (!special && (code == '\n' || code == '\r'))
		return EDIT_DONE;
	if (special || key != 0)
		edit_handle_special_key(t, key);
	else if (code == '\t')
		complete_word(t, s);
	else if (code == CONTROL('U'))
		replace_before_cursor(t, 0, "", 0);
	else if (code == CONTROL('W'))
		replace_before_cursor(t, start_of_word_before(t), "", 0);
	else if (code == CONTROL('K'))
		t->text[t->n = t->at] = '\0';
	else if (code >= ' ') {
		if (t->fresh > 0)
			t->text[t->n = t->at = t->fresh] = '\0';
		insert_letter_at_cursor(t, (unsigned)code);
	}
	t->fresh = 0;
	t->from = code == '\t' && t->n == n ? next : 0;
	return EDIT_ON;
}

void
edit_insert_completion(struct edit *t, size_t n)
{
	size_t length;
	const char *offer = edit_get_nth_offered_completion(t, n, &length);
	if (offer == NULL)
		return;
	bool open = length > 0 &&
		    (offer[length - 1] == '=' || offer[length - 1] == '/');
	replace_before_cursor(t, t->start, offer, length);
	if (!open)
		insert_letter_at_cursor(t, ' ');
	xfree_and_set(&t->offers, NULL);
}

bool
edit_insert_or_erase_letter(struct edit *t, int code, bool special, size_t most)
{
	bool back = code == DELETE || code == '\b';
	if (special || (back ? t->n == 0 : code < ' '))
		return false;
	if (back)
		replace_before_cursor(
		    t, previous_letter_offset(t, t->at), "", 0);
	else if (t->n < most)
		insert_letter_at_cursor(t, (unsigned)code);
	return true;
}
