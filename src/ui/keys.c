/* The table of keys.  Only the names of keys are taken from curses here: who
 * prints the manual does not link it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/keys.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <curses.h>

#include "base/text.h"
#include "base/xalloc.h"

#define CONTROL(letter) ((letter)&0x1F)

#define PREDICT "predict %s"

const struct key KEYS[] = {
    {KEY_LEFT, "Left, h", ON_ALL, ACT_MOVE, -1, PREDICT,
	"speed down by 0.1 m/s; or move what Tab chose to the left"},
    {KEY_RIGHT, "Right, l", ON_ALL, ACT_MOVE, 1, PREDICT,
	"speed up by 0.1 m/s; or move what Tab chose to the right"},
    {KEY_SLEFT, "Shift-Left, H", ON_ALL, ACT_FINE, -10, PREDICT,
	"speed down by 1 m/s; or ten generations"},
    {KEY_SRIGHT, "Shift-Right, L", ON_ALL, ACT_FINE, 10, PREDICT,
	"speed up by 1 m/s; or ten generations"},
    {KEY_NPAGE, "PgDn", ON_ALL, ACT_FINE, -50, PREDICT,
	"speed down by 5 m/s; or fifty generations"},
    {KEY_PPAGE, "PgUp", ON_ALL, ACT_FINE, 50, PREDICT,
	"speed up by 5 m/s; or fifty generations"},
    {KEY_HOME, "Home", ON_ALL, ACT_TO, TO_LEAST, PREDICT,
	"to the slow end of the track; or to the first generation"},
    {KEY_END, "End", ON_ALL, ACT_TO, TO_MOST, PREDICT,
	"to the fast end of the track; or to the last generation"},
    {'[', "[", ON_ALL, ACT_TO, TO_SLOWEST, PREDICT,
	"to the slowest run, and its feed"},
    {']', "]", ON_ALL, ACT_TO, TO_FASTEST, PREDICT,
	"to the fastest run, and its feed"},
    {'m', "m", ON_ALL, ACT_TO, TO_MIDDLE, PREDICT,
	"to the middle, and the feed nearest to it"},
    {'\t', "Tab", ON_ALL, ACT_FOCUS, 1, NULL,
	"choose what arrows move: speed, crosshair, generation, site"},
    {KEY_BTAB, "Shift-Tab", ON_ALL, ACT_FOCUS, -1, NULL,
	"choose the previous one"},
    {'1', "1", ON_ALL, ACT_PAGE, PAGE_PREDICT, NULL, "page Predict"},
    {'2', "2", ON_ALL, ACT_PAGE, PAGE_FIT, NULL, "page Fit"},
    {'3', "3", ON_ALL, ACT_PAGE, PAGE_DATA, NULL, "page Data"},
    {'4', "4", ON_ALL, ACT_PAGE, PAGE_PARITY, NULL, "page Parity"},
    {'5', "5", ON_ALL, ACT_PAGE, PAGE_SITES, NULL, "page Sites"},
    {KEY_UP, "Up, k", ON_ALL, ACT_LIST, -1, NULL,
	"up in a list; to a higher passing for the crosshair's sizes"},
    {KEY_DOWN, "Down, j", ON_ALL, ACT_LIST, 1, NULL,
	"down in a list; to a lower passing"},
    {'\n', "Enter", ON_SITES, ACT_CHOOSE, 0, NULL, "use this site"},
    {'c', "c", ON_ALL, ACT_CROSS, 0, NULL,
	"crosshair on or off: reads the curves at a sieve"},
    {'b', "b", ON_ALL, ACT_BAND, 0, NULL,
	"uncertainty band on or off, if known"},
    {'a', "a", ON_ALL, ACT_CORRECT, 0, "set correction",
	"runs that correct the answer: all, the training runs, none"},
    {'x', "x", ON_ALL, ACT_PIN, 0, NULL,
	"pin this prediction for comparison; again: unpin"},
    {'v', "v", ON_FIT, ACT_PICTURE, 1, NULL,
	"the next plot: curves, convergence, spread"},
    {'f', "f", ON_ALL, ACT_FIT, 0, "calibrate", "calibrate, or start again"},
    {' ', "Space", ON_ALL, ACT_HOLD, 0, "continue",
	"pause or resume the calibration; once stopped: continue"},
    {'s', "s", ON_ALL, ACT_KEEP, 0, NULL,
	"stop the calibration and keep the best"},
    {'+', "+, =", ON_ALL, ACT_PACE, 1, NULL, "more generations a second"},
    {'-', "-", ON_ALL, ACT_PACE, -1, NULL, "fewer generations a second"},
    {'d', "d", ON_ALL, ACT_TELL, 0, "describe %s",
	"describe the plot of the page in words"},
    {'e', "e", ON_ALL, ACT_EXPORT, 0, "predict %s > ",
	"export the prediction, pinned one too: .csv table, .svg plot"},
    {':', ":", ON_ALL, ACT_TYPE, 0, "",
	"a command: find, spec, bounds ..; Tab completes, Up repeats"},
    {'u', "u", ON_ALL, ACT_RUN, 0, "undo", "undo the last change"},
    {'U', "U", ON_ALL, ACT_RUN, 0, "redo", "redo it"},
    {'w', "w", ON_ALL, ACT_TYPE, 0, "save ",
	"save the session as a script: give a file name"},
    {KEY_F(1), "?, F1", ON_ALL, ACT_HELP, 0, NULL, "this list"},
    {'M', "M", ON_ALL, ACT_MOUSE, 0, NULL,
	"mouse on or off; Shift and drag selects text"},
    {CONTROL('L'), "^L", ON_ALL, ACT_REDRAW, 0, NULL, "redraw"},
    {CONTROL('C'), "^C", ON_ALL, ACT_STOP, 0, NULL,
	"stop the calibration and keep the best"},
    {CONTROL('Z'), "^Z", ON_ALL, ACT_SUSPEND, 0, NULL,
	"to the shell; fg comes back"},
    {'q', "q", ON_ALL, ACT_LEAVE, 0, NULL, "quit full-screen mode"},
    {.code = 0}};

/* Whether one of the names of a row, "Left, h", is this. */
static bool
has_name(const char *names, const char *name)
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
keys_find(int code, enum page page)
{
	if (code == '\r')
		code = '\n';
	const char letter[2] = {code < 127 ? (char)code : '\0'};
	for (const struct key *k = KEYS; k->code != 0; k++)
		if ((k->pages & (1U << page)) &&
		    (k->code == code ||
			(letter[0] > ' ' && has_name(k->name, letter))))
			return k;
	return NULL;
}

bool
keys_code(const char *name, int *code)
{
	static const struct {
		const char *name;
		int code;
	} MORE[] = {
	    {"Esc", 27}, {"Backspace", KEY_BACKSPACE}, {"Delete", KEY_DC}};
	*code = (unsigned char)name[0];
	if (name[0] != '\0' && name[1] == '\0')
		return *code > ' ' && *code < 127;
	for (const struct key *k = KEYS; k->code != 0; k++)
		if (has_name(k->name, name)) {
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

/* The only page a key is there on, in words; "" where it is on all. */
static const char *
only_on(const struct key *k)
{
	return k->pages == ON_FIT     ? " (page Fit)"
	       : k->pages == ON_SITES ? " (page Sites)"
				      : "";
}

static char *
line_of(const struct key *k)
{
	return xasprintf("  %-15s %s%s", k->name, k->what, only_on(k));
}

static bool
has_word(const struct key *k, const char *word)
{
	char *line = line_of(k), *folded = text_fold(line);
	char *wanted = text_fold(word);
	bool has = strstr(folded, wanted) != NULL;
	free(line);
	free(folded);
	free(wanted);
	return has;
}

void
keys_list(const char *word, FILE *out)
{
	for (const struct key *k = KEYS; k->code != 0; k++) {
		if (!has_word(k, word))
			continue;
		char *line = line_of(k);
		fprintf(out, "%s\n", line);
		free(line);
	}
	if (keys_nth(word, 0) == NULL)
		fprintf(out,
		    "  no key for '%s'; search the commands: Esc, Esc, then\n"
		    "  :apropos %s\n",
		    word, word);
	if (word[0] == '\0')
		fprintf(out,
		    "  digits, Enter   type a speed: 74, 9.1, 012.5 (1 to %d "
		    "are pages)\n"
		    "  mouse           click and drag set the speed, the wheel "
		    "moves it by 0.1 m/s\n",
		    PAGES);
}

const struct key *
keys_nth(const char *word, size_t n)
{
	for (const struct key *k = KEYS; k->code != 0; k++)
		if (has_word(k, word) && n-- == 0)
			return k;
	return NULL;
}

void
keys_manual(FILE *out)
{
	fputs(".Bl -tag -width Shift-Right\n", out);
	for (const struct key *k = KEYS; k->code != 0; k++) {
		/* The control characters of mdoc would be taken as such. */
		fprintf(out, ".It %s%s\n%s%s.\n",
		    k->name[1] == '\0' ? "\\&" : "", k->name, k->what,
		    only_on(k));
		if (k->command != NULL && k->command[0] != '\0' &&
		    (k->act == ACT_RUN || k->act == ACT_TELL))
			fprintf(out, "Runs\n.Ic %.*s .\n",
			    (int)strcspn(k->command, " "), k->command);
	}
	fprintf(out,
	    ".It digits, Enter\nType a speed; 1 to %d are pages, so that one "
	    "which begins with them\nis typed with a 0 before it: 012.5.\n"
	    ".It mouse\nClick on the track or drag along it to set the "
	    "speed;\nthe wheel moves it by 0.1 m/s.\nA click on the name of a "
	    "page opens it.\n.El\n",
	    PAGES);
}
