/* The keys of the full screen, as data: what is pressed, what it does, and the
 * command it composes.  The ? page and the manual are printed from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYS_H
#define TIPSPEED_TUI_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum page { PAGE_PREDICT, PAGE_FIT, PAGE_DATA, PAGE_PARITY, PAGE_SITES, PAGES };

/* On which pages a key is there: bits of 1 << page. */
enum { ON_ALL = (1 << PAGES) - 1, ON_FIT = 1 << PAGE_FIT };
enum { ON_PREDICT = 1 << PAGE_PREDICT, ON_SITES = 1 << PAGE_SITES };
enum { ON_DATA = 1 << PAGE_DATA };

enum key_act {
	ACT_MOVE,     /* the focus by so many steps */
	ACT_FINE,     /* the slider by so many tenths */
	ACT_TO,       /* the slider to an end, or a run */
	ACT_PAGE,     /* to a page */
	ACT_FOCUS,    /* what the arrows move */
	ACT_LIST,     /* up and down */
	ACT_RUN,      /* the command */
	ACT_CORRECT,  /* the next choice of `set correction` */
	ACT_TELL,     /* describe what the page draws */
	ACT_TYPE,     /* the command into the command line, to be completed */
	ACT_SAVE,     /* the same, with a file name */
	ACT_EXPORT,   /* the same; with one kept beside, both curves */
	ACT_CROSS,    /* crosshair on or off */
	ACT_BAND,     /* uncertainty on or off */
	ACT_PIN,      /* keep this prediction to compare with */
	ACT_QUANTITY, /* the next one above the track */
	ACT_GOAL,     /* a field for what is wanted */
	ACT_LIMIT,    /* the slider to the next limit of that, or run */
	ACT_BEST,     /* the slider to its best speed */
	ACT_PICTURE,  /* the next picture of the page */
	ACT_STEP,     /* one generation */
	ACT_FIT,      /* start, or start again */
	ACT_HOLD,     /* pause and go on */
	ACT_KEEP,     /* stop and keep the best */
	ACT_PACE,     /* slower or faster */
	ACT_CHOOSE,   /* use the site, open what is under the cursor */
	ACT_SORT,     /* by the next column, or the other way round */
	ACT_DOUBT,    /* to the next doubtful cell of a sheet */
	ACT_MEND,     /* mend the cell under the cursor */
	ACT_FILTER,   /* a word that rows must have */
	ACT_BACK,     /* one step back: of a filter, the crosshair, the page */
	ACT_FILES,    /* a list of them, to open one */
	ACT_AGAIN, /* the text that was closed last */
	ACT_HELP,
	ACT_MOUSE,
	ACT_REDRAW,
	ACT_STOP, /* ^C */
	ACT_SUSPEND,
	ACT_LEAVE
};

/* To an end of the slider, or a run: amounts of ACT_TO. */
enum { TO_LEAST, TO_MOST, TO_SLOWEST, TO_FASTEST, TO_MIDDLE };

/* code: as ncurses gives it; name: as shown, "Left, h" where h does the same.
 * command: what it composes, with %s for the
 * slider's speed, or NULL. */
struct key {
	int code;
	const char *name;
	unsigned pages;
	enum key_act act;
	int amount;
	const char *command, *what;
};

/* Ends with a code of 0. */
extern const struct key KEYS[];

/* The row of a key on a page, or NULL. */
const struct key *keys_find(int code, enum page page);

/* The code of a key by its name ("Left", "^L", "Esc") or its character; false
 * where there is none such.  Those above 255 are special keys of ncurses. */
bool keys_code(const char *name, int *code);

/* For the ? page: a line for each key whose line has the word, without regard
 * to case; all for "".  The page's own come first, under a heading.  keys_nth:
 * the key of line n, or NULL; keys_count: how many keys there are. */
void keys_list(enum page page, const char *word, FILE *out);
const struct key *keys_nth(enum page page, const char *word, size_t n);
size_t keys_count(enum page page, const char *word);

/* The same for tipspeed-tui(1), as mdoc. */
void keys_manual(FILE *out);

/* Prints what each key does by a function, for who translates it. */
void keys_texts(void (*print)(const char *text, FILE *out), FILE *out);

#endif
