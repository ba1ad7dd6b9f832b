/* The table of keys.  From curses it uses only key codes, because the program
 * that prints the manual links neither curses nor the actions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/keys.h"

#include <assert.h>
#include <stdbool.h>
#include <string.h>

#include <curses.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

#define CONTROL(letter) ((letter)&0x1F)

#define PAGE_KEY(NUMBER, name, heading, key)                                   \
	{key, (const char[]){key, '\0'}, ON_ALL, act_open_page, PAGE_##NUMBER, \
	    "page " heading, PAGE_##NUMBER == 0 ? "pages" : NULL, NULL},

const struct key KEYS[] = {
    {KEY_LEFT, "Left, h", ON_ALL | FIRST_ON_PREDICT, act_move_list_or_slider,
	-STEP, "the page's slider left: speed by 0.1 m/s, generation, cell",
	"the slider of the page", "speed"},
    {KEY_RIGHT, "Right, l", ON_ALL | FIRST_ON_PREDICT, act_move_list_or_slider,
	STEP, "the page's slider right", NULL, NULL},
    {KEY_SLEFT, "Shift-Left, H", ON_DATA, act_move_list_or_slider, -FAST,
	"five columns to the left", "by five columns", NULL},
    {KEY_SRIGHT, "Shift-Right, L", ON_DATA, act_move_list_or_slider, FAST,
	"five columns to the right", NULL, NULL},
    {KEY_NPAGE, "PgDn", ON_DATA | ON_PARITY | ON_SITES, act_move_list_or_slider,
	-FAR, "in a list down by as many rows as are shown", "a screen of rows",
	NULL},
    {KEY_PPAGE, "PgUp", ON_DATA | ON_PARITY | ON_SITES, act_move_list_or_slider,
	FAR, "in a list up by as many rows as are shown", NULL, NULL},
    {KEY_SLEFT, "Shift-Left, H", (ON_ALL & ~ON_DATA) | FIRST_ON_PREDICT,
	act_move_list_or_slider, -FAST,
	"speed down by 1 m/s; or ten generations", "by 1 m/s, 10 generations",
	NULL},
    {KEY_SRIGHT, "Shift-Right, L", (ON_ALL & ~ON_DATA) | FIRST_ON_PREDICT,
	act_move_list_or_slider, FAST, "speed up by 1 m/s; or ten generations",
	NULL, NULL},
    {KEY_NPAGE, "PgDn",
	(ON_ALL & ~(ON_DATA | ON_PARITY | ON_SITES)) | FIRST_ON_PREDICT,
	act_move_list_or_slider, -FAR,
	"speed down by 5 m/s; or fifty generations", "by 5 m/s, 50 generations",
	NULL},
    {KEY_PPAGE, "PgUp",
	(ON_ALL & ~(ON_DATA | ON_PARITY | ON_SITES)) | FIRST_ON_PREDICT,
	act_move_list_or_slider, FAR, "speed up by 5 m/s; or fifty generations",
	NULL, NULL},
    {KEY_HOME, "Home, g", ON_ALL | FIRST_ON_PREDICT, act_move_to_end, TO_LEAST,
	"to the slow end of the track; to the first of a list", "to its ends",
	NULL},
    {KEY_END, "End, G", ON_ALL | FIRST_ON_PREDICT, act_move_to_end, TO_MOST,
	"to the fast end of the track; to the last of a list", NULL, NULL},
    {'=', "=", ON_ALL | FIRST_ON_PREDICT, act_type_speed, 0,
	"type a speed: =72.5 Enter", "a speed: =72.5 Enter", NULL},
    {'[', "[", ON_ALL | FIRST_ON_PREDICT | CHANGES,
	act_move_slider_to_run_speed, -1, "to the slowest run",
	"slowest, fastest, middle", NULL},
    {']', "]", ON_ALL | FIRST_ON_PREDICT | CHANGES,
	act_move_slider_to_run_speed, 1, "to the fastest run", NULL, NULL},
    {'m', "m", ON_ALL | FIRST_ON_PREDICT | CHANGES,
	act_move_slider_to_run_speed, 0, "to the middle of the runs", NULL,
	NULL},
    {'t', "t", ON_ALL, act_open_goal_field, 0,
	"set a goal: p80=5.4, passing 2 = 40..50, an envelope; or none", "goal",
	"goal"},
    {'T', "T", ON_PREDICT, act_toggle_goal_view, 0,
	"the goal at full height, with its conditions; again: back",
	"plot of the goal", "plot"},
    {'n', "n", ON_ALL | AT_SPEED | CHANGES, act_move_slider_to_goal_speed, 1,
	"to the next speed at which the goal begins or ends, or the next run",
	"its limits, or runs", "limits"},
    {'p', "p", ON_ALL | AT_SPEED | CHANGES, act_move_slider_to_goal_speed, -1,
	"to the limit or run before", NULL, NULL},
    {'N', "N", ON_ALL | AT_SPEED | CHANGES, act_move_slider_to_goal_speed, 0,
	"to the best speed of the goal", "its best speed", "best"},
    {'y', "y", ON_PREDICT, act_next_quantity, 1,
	"next quantity above the track: P80, P50 ..", "other quantity", NULL},
    {'Y', "Y", ON_PREDICT, act_next_quantity, -1, "the one before", NULL, NULL},
    SCREEN_PAGES(PAGE_KEY)
    /* Lists. */
    {KEY_UP, "Up, k", ON_ALL | FIRST_ON_LISTS, act_move_in_list, -1,
	"up in a list; crosshair to a coarser sieve", "a row, or the sieve",
	"sieve"},
    {KEY_DOWN, "Down, j", ON_ALL | FIRST_ON_LISTS, act_move_in_list, 1,
	"down in a list; crosshair to a finer sieve", NULL, NULL},
    {'\n', "Enter", ON_FIT, act_open_bounds_command, 0,
	"type bounds for the parameter chosen by Up, Down",
	"bounds of the parameter", "bounds"},
    {'.', ".", ON_FIT, act_next_generation, 0,
	"run one search step, then pause; or show the next", "one generation",
	NULL},
    {'\n', "Enter", ON_PREDICT, act_show_numbers_or_calibrate, 0,
	"all numbers, including pinned ones; calibrates first if needed",
	"all numbers", "numbers"},
    {'\n', "Enter", ON_ALL & ~(ON_PREDICT | ON_FIT | ON_DATA), act_open_row, 0,
	"open the chosen row: use a site", "use the site", "use it"},
    {'\n', "Enter", ON_DATA, act_correct_cell, 0,
	"mend the doubtful cell; u undoes it", "mend the cell", "mends"},
    {'!', "!", ON_DATA, act_next_doubtful_cell, 0,
	"to the next doubtful cell of the sheet", "next doubtful cell",
	"next doubtful"},
    {'o', "o", ON_SITES, act_sort_sites, 1,
	"sort by the next column, or click a heading", "sort", NULL},
    {'O', "O", ON_SITES, act_sort_sites, -1, "sort the other way round", NULL,
	NULL},
    {'/', "/", ON_PARITY | ON_SITES, act_open_filter_field, 0,
	"show only the rows that contain a word", "find a word", "filter"},
    {ESCAPE, "Esc", ON_ALL, act_go_back, 0,
	"one step back: from a word, the crosshair, a page; never quits",
	"back", NULL},
    {'o', "o", ON_ALL & ~ON_SITES, act_open_file_picker, 0,
	"open a sheet: a list of files, with a preview of each", "open a sheet",
	NULL},
    {'c', "c", ON_ALL | FIRST_ON_PREDICT, act_toggle_crosshair, 0,
	"crosshair on or off: reads the curves at a sieve", "crosshair", NULL},
    {'<', "<", ON_PREDICT, act_move_crosshair_passing, -5,
	"read crosshair sizes at a passing 5 % lower", "its passing",
	"passing"},
    {'>', ">", ON_PREDICT, act_move_crosshair_passing, 5, "at one 5 % higher",
	NULL, NULL},
    {'b', "b", ON_ALL | FIRST_ON_PREDICT | CHANGES, act_toggle_band, 0,
	"uncertainty band on or off, if there is one", "band", NULL},
    {'a', "a", ON_ALL | FIRST_ON_PREDICT | CHANGES, act_next_correction_setting,
	0, "runs that correct the answer: all, the training runs, none",
	"runs that correct it", NULL},
    {'x', "x", ON_ALL | FIRST_ON_PREDICT | AT_SPEED | CHANGES, act_toggle_pin,
	0, "pin this prediction for comparison; again: unpin", "pin, unpin",
	"pin"},
    {'v', "v", ON_FIT, act_next_plot, 0,
	"the next plot: search, curves, convergence, spread", "next plot",
	"plot"},
    {'r', "r", ON_PREDICT, act_toggle_all_runs_view, 0,
	"all runs, measured and predicted; again: back", "all runs", NULL},
    {'f', "f", ON_ALL | FIRST_ON_FIT | CHANGES, act_calibrate, 0,
	"calibrate, or start again", "calibrate", "fit"},
    {' ', "Space", ON_ALL | FIRST_ON_FIT, act_toggle_calibration_pause, 0,
	"pause or resume the calibration; once stopped: continue",
	"pause, continue", "pause"},
    {'s', "s", ON_ALL | FIRST_ON_FIT | CHANGES, act_stop_fit, 0,
	"stop the calibration and keep the best", "stop, keep the best",
	"stop, keep"},
    {INTERRUPT, "^C", ON_ALL | CHANGES, act_stop_fit, 0,
	"stop the calibration and keep the best", NULL, NULL},
    {'+', "+", ON_ALL | FIRST_ON_FIT, act_change_calibration_pace, 1,
	"more generations a second", "faster, slower display", "pace"},
    {'-', "-", ON_ALL | FIRST_ON_FIT, act_change_calibration_pace, -1,
	"fewer generations a second", NULL, NULL},
    {'d', "d", ON_ALL | AT_SPEED | RUNS_COMMAND, act_describe_plot, 0,
	"describe the plot of the page in words", "plot in words", "describe"},
    {'e', "e", ON_ALL | FIRST_ON_PREDICT | AT_SPEED, act_propose_export, 0,
	"export the prediction, a pinned one too: .xlsx, .csv, .svg", "export",
	NULL},
    {':', ":", ON_ALL | AT_SPEED, act_open_command_line, 0,
	"a command: find, spec, bounds ..; Tab completes, Up repeats",
	"command", NULL},
    {'u', "u", ON_ALL | CHANGES | RUNS_COMMAND, act_run_hint_command, 0,
	"undo the last change", "undo, redo", "undo"},
    {'U', "U", ON_ALL | CHANGES | RUNS_COMMAND, act_run_hint_command, 0,
	"redo it", NULL, "redo"},
    {'w', "w", ON_ALL | AT_SPEED, act_propose_save, 0,
	"save the session as a script, under the proposed name",
	"save the session", NULL},
    {'V', "V", ON_ALL, act_show_last_text, 0,
	"show the last text again: an answer, a report", "last text again",
	NULL},
    {KEY_F(1), "?, F1", ON_ALL, act_list_keys, 0, "this list", "this list",
	"keys"},
    {'M', "M", ON_ALL, act_toggle_mouse, 0,
	"mouse on or off; Shift-drag selects text", "mouse", NULL},
    {CONTROL('L'), "^L", ON_ALL, act_redraw_screen, 0, "redraw", "redraw",
	NULL},
    {SUSPEND, "^Z", ON_ALL, act_suspend_program, 0,
	"to the shell; fg comes back", "to the shell", NULL},
    {'q', "q", ON_ALL, act_leave_screen, 0, "quit full-screen mode", "quit",
	NULL},
    {.code = 0}};

/* Returns true if the names of a row, "Left, h", include this one. */
static bool
key_names_include(const char *names, const char *name)
{
	size_t n = strlen(name);
	while (names != NULL) {
		if (strncmp(names, name, n) == 0 &&
		    (names[n] == ',' || names[n] == '\0'))
			return true;
		names = strstr(names, ", ");
		names = names != NULL ? names + 2 : NULL;
	}
	return false;
}

const struct key *
keys_find_by_code(int code, enum page page)
{
	if (code == '\r')
		code = '\n';
	const char letter[2] = {code < 127 ? (char)code : '\0'};
	for (const struct key *k = KEYS; k->code != 0; k++)
		if ((k->where & (1U << page)) &&
		    (k->code == code ||
			(letter[0] > ' ' &&
			    key_names_include(k->name, letter))))
			return k;
	return NULL;
}

static const struct key *
key_that_opens_page(enum page page)
{
	const struct key *k = KEYS;
	while (
	    k->code != 0 && (k->act != act_open_page || k->amount != (int)page))
		k++;
	assert(k->code != 0);
	return k;
}

int
keys_code_of_page(enum page page)
{
	return key_that_opens_page(page)->code;
}

bool
keys_code_of_name(const char *name, int *code)
{
	static const struct {
		const char *name;
		int code;
	} MORE[] = {{"Backspace", KEY_BACKSPACE}, {"Delete", KEY_DC},
	    {"<-", KEY_LEFT}, {"->", KEY_RIGHT}, {"Tab", '\t'},
	    {"Shift-Tab", KEY_BTAB}};
	*code = (unsigned char)name[0];
	if (name[0] != '\0' && name[1] == '\0')
		return *code > ' ' && *code < 127;
	for (const struct key *k = KEYS; k->code != 0; k++)
		if (key_names_include(k->name, name)) {
			*code = k->code;
			return true;
		}
	for (size_t i = 0; i < ARRAY_LEN(MORE); i++)
		if (strcmp(MORE[i].name, name) == 0) {
			*code = MORE[i].code;
			return true;
		}
	return false;
}

/* Returns what the keys of a hint do, in the words of the first key that has
 * any.  Returns "" if the hint already has words after its keys: "1-5
 * pages". */
static const char *
description_of_keys_in_hint_line(const char *hint, enum page page)
{
	const char *words = "";
	for (size_t n; *hint != '\0'; hint += n + (hint[n] != '\0')) {
		int code;
		n = keys_first_name_length(hint);
		FREED char *name = xstrndup(hint, n);
		if (!keys_code_of_name(name, &code))
			return "";
		const struct key *k = keys_find_by_code(code, page);
		if (words[0] == '\0' && k != NULL && (k->hint || k->brief))
			words = tr(k->hint != NULL ? k->hint : k->brief);
	}
	return words;
}

size_t
keys_first_name_length(const char *names)
{
	/* "/" is a key, too. */
	return names[0] == '\0' ? 0 : 1 + strcspn(names + 1, "/ ");
}

char *
keys_next_hint(const char **hints)
{
	const char *from = *hints, *end = strstr(from, "  ");
	size_t n = end != NULL ? (size_t)(end - from) : strlen(from);
	*hints += n + (end != NULL ? 2 : 0);
	return xstrndup(from, n);
}

char *
keys_hint_row_text(const char *hints, enum page page)
{
	char *bar = xstrdup("");
	while (*hints != '\0') {
		FREED char *hint = keys_next_hint(&hints);
		const char *words =
		    description_of_keys_in_hint_line(hint, page);
		xappend_to_list(
		    &bar, "  ", "%s%s%s", hint, words[0] ? " " : "", words);
	}
	return bar;
}

/* Texts about speeds in m/s, and those that replace them for a sheet in rpm. */
static const char *const IN_RPM[][2] = {
    {"the page's slider left: speed by 0.1 m/s, generation, cell",
	N_("the page's slider left: speed by 1 rpm, generation, cell")},
    {"speed down by 1 m/s; or ten generations",
	N_("speed down by 10 rpm; or ten generations")},
    {"speed up by 1 m/s; or ten generations",
	N_("speed up by 10 rpm; or ten generations")},
    {"by 1 m/s, 10 generations", N_("10 rpm, 10 generations")},
    {"speed down by 5 m/s; or fifty generations",
	N_("speed down by 50 rpm; or fifty generations")},
    {"speed up by 5 m/s; or fifty generations",
	N_("speed up by 50 rpm; or fifty generations")},
    {"by 5 m/s, 50 generations", N_("50 rpm, 50 generations")},
    {"type a speed: =72.5 Enter", N_("type a speed: =1450 Enter")},
    {"a speed: =72.5 Enter", N_("a speed: =1450 Enter")}};

const char *
keys_text_for_speed_unit(const char *words, bool in_rpm)
{
	for (size_t i = 0; in_rpm && i < ARRAY_LEN(IN_RPM); i++)
		if (strcmp(words, IN_RPM[i][0]) == 0)
			words = IN_RPM[i][1];
	return tr(words);
}

/* Returns what the key does, followed by " (page Fit)" if it acts only on that
 * page.  The caller frees it. */
static char *
key_description(const struct key *k, bool in_rpm)
{
	unsigned pages = k->where & ON_ALL;
	char *words = xstrdup(keys_text_for_speed_unit(k->what, in_rpm));
	for (enum page page = 0; page < PAGES; page++)
		if (pages == 1U << page)
			xappend(&words, " (%s)",
			    tr(key_that_opens_page(page)->what));
	return words;
}

/* Returns true if a key belongs to a page: it acts there but not on all pages,
 * or it acts on all but is listed first there. */
static bool
is_key_listed_first_on_page(const struct key *k, enum page page)
{
	unsigned pages = k->where & ON_ALL;
	if (pages == ON_ALL)
		pages = k->where >> PAGES;
	return pages & (1U << page);
}

/* Returns a line of the brief list, "  Up Down       a row": a key, with those
 * listed with it as far as there is room. */
static char *
brief_key_help_line(const struct key *k, bool in_rpm)
{
	enum { ROOM = 13 };
	FREED char *names = xstrndup(k->name, strcspn(k->name, ","));
	for (const struct key *next = k + 1;
	     next->code != 0 && next->brief == NULL; next++) {
		size_t n = strcspn(next->name, ",");
		if (strlen(names) + 1 + n <= ROOM)
			xappend(&names, " %.*s", (int)n, next->name);
	}
	return xasprintf("  %-*s %s", ROOM, names,
	    keys_text_for_speed_unit(k->brief, in_rpm));
}

static char *
full_key_help_line(const struct key *k, bool in_rpm)
{
	FREED char *words = key_description(k, in_rpm);
	return xasprintf("  %-15s %s", k->name, words);
}

static bool
has_word_in_help_line(const struct key *k, const char *word)
{
	FREED char *line = full_key_help_line(k, false);
	return text_contains_folded(line, word);
}

/* Lists keys, those of the page first: all keys of the page or, if there is a
 * word, those whose line contains it.  Returns their number. */
static size_t
list_keys_of_page_or_word(enum page page, const char *word,
    const struct key *line[static ARRAY_LEN(KEYS)])
{
	size_t n = 0;
	for (int own = 1; own >= 0; own--)
		for (const struct key *k = KEYS; k->code != 0; k++)
			if (is_key_listed_first_on_page(k, page) == own &&
			    (word[0] != '\0'
				    ? has_word_in_help_line(k, word)
				    : k->brief && k->where & (1U << page)))
				line[n++] = k;
	return n;
}

void
keys_print_list(enum page page, const char *word, bool in_rpm, FILE *out)
{
	const struct key *line[ARRAY_LEN(KEYS)];
	size_t n = list_keys_of_page_or_word(page, word, line);
	for (size_t i = 0; i < n; i++) {
		FREED char *text = word[0] == '\0'
				       ? brief_key_help_line(line[i], in_rpm)
				       : full_key_help_line(line[i], in_rpm);
		fprintf(out, "%s\n", text);
	}
	if (n == 0)
		fprintf(out,
		    tr("  no key for '%s'; search the commands: Esc, Esc, "
		       "then\n"
		       "  :apropos %s\n"),
		    word, word);
	if (word[0] == '\0')
		fputs(tr("  mouse         click, wheel, drag\n"), out);
}

const struct key *
keys_nth_listed(enum page page, const char *word, size_t n)
{
	const struct key *line[ARRAY_LEN(KEYS)];
	return n < list_keys_of_page_or_word(page, word, line) ? line[n] : NULL;
}

size_t
keys_count_listed(enum page page, const char *word)
{
	const struct key *line[ARRAY_LEN(KEYS)];
	return list_keys_of_page_or_word(page, word, line);
}

void
keys_print_manual(FILE *out)
{
	fputs(".Bl -tag -width Shift-Right\n", out);
	for (const struct key *k = KEYS; k->code != 0; k++) {
		/* A single character might be one that mdoc interprets. */
		FREED char *words = key_description(k, false);
		fprintf(out, ".It %s%s\n%s.\n", k->name[1] == '\0' ? "\\&" : "",
		    k->name, words);
		if (k->where & RUNS_COMMAND)
			fprintf(out, "Runs\n.Ic %s .\n", k->hint);
	}
	fprintf(out,
	    ".It mouse\nClick on the track or drag along it to set the "
	    "speed;\nthe wheel over it or the plot moves it by 0.1 m/s.\n"
	    "A click on the plot puts the crosshair on the nearest sieve and "
	    "says what\nis drawn there, one on a row chooses it, a second one "
	    "opens it.\nThe name of a page opens it; a hint in the last row is "
	    "its key, and the row\nof the command begins one.\nOver a list or "
	    "a text the wheel goes through it.\n.El\n");
}

void
keys_print_for_translators(
    void (*print)(const char *text, FILE *out), FILE *out)
{
	for (const struct key *k = KEYS; k->code != 0; k++) {
		print(k->what, out);
		if (k->brief != NULL)
			print(k->brief, out);
		if (k->hint != NULL)
			print(k->hint, out);
	}
}
