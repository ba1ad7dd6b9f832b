/* What the full screen knows beside the session.  The panes read it; keys and
 * commands change it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_TUI_STATE_H
#define TIPSPEED_UI_TUI_STATE_H

#include <stdbool.h>
#include <stdio.h>

#include "cmd/plots.h"
#include "cmd/session.h"
#include "ui/keys.h"
#include "ui/places.h"
#include "ui/slider.h"
#include "ui/typing.h"

/* The numbers of a prediction, for a difference: P20, P50 and P80 and the break
 * size, mm; passing at 0.063, 2 and 4 mm, %, NAN where these lie off its
 * sieves. */
enum { NUMBERS_FRACTIONS = 3 };
struct numbers {
	char site[64];
	double speed, size[3], break_mm, passing[NUMBERS_FRACTIONS];
};

/* Text on the whole screen: lines from `top` on, of these what is right of the
 * column `left`.  text NULL: none.  keys: the list of keys, of those that have
 * the word; one of them, `at`, can be run. */
struct viewer {
	char *text;
	int top, lines, left, columns;
	bool keys;
	int at;
	struct typing word;
};

/* How many letters such a word may have, and a speed. */
enum { VIEWER_WORD = 31, SPEED_LETTERS = 7 };

/* A loaded site at the slider's speed: P50 in mm, whether that is beyond the
 * speeds trained on, and the RMSE at those held out, points; NAN: none. */
struct site_row {
	double p50, holdout;
	bool beyond;
};

/* Text being pasted: how many of its characters were typed, whether its first
 * line has ended, and whether something was not taken. */
struct paste {
	bool on, ended, left;
	size_t taken;
};

/* Where a page's name stands in the header. */
struct tab {
	int column, columns;
};

/* A cell of the screen. */
struct cursor {
	int row, column;
};

struct inquiry;
struct page_ops;
struct tui;

/* How a full screen is shown. */
struct tui_ways {
	/* The next key for t->question or t->inquiry; false: none comes. */
	bool (*answer)(struct tui *t, int *code, bool *special);
	/* Leaves terminal and signals to somebody else, and takes them back;
	 * NULL where it is drawn without a terminal. */
	void (*leave)(void), (*come_back)(void);
	bool (*is_away)(void); /* NULL: never */
};

struct tui {
	struct session *session;
	const struct tui_ways *ways;
	struct places places;
	enum page page;
	/* Of which page the arrows move what it has; NULL: the slider. */
	const struct page_ops *focus;
	struct cursor cursor; /* on the focus */
	bool aside;           /* drawn without a terminal */
	double clock;   /* s; a step with every key where it is drawn aside */
	double started; /* the search or its last part, by that clock */
	double ran;     /* s of its parts before */
	int tenths;     /* of the slider */
	double feed;    /* m/s of the run whose feed is kept; 0: none */
	struct {
		int tenths; /* 0: not yet */
		size_t feed_run;
	} asked;                 /* what was last predicted */
	double moved;            /* when the slider last was */
	struct prediction shown; /* at the slider's speed; product.n 0: none */
	struct numbers now, pause, pin; /* site "": none */
	struct prediction kept;         /* whose numbers are in pin */
	bool cross, band, mouse;
	bool dragging;        /* the focus follows the mouse */
	struct area scrubber; /* of no rows where it is not drawn */
	size_t cross_at;      /* a sieve of the prediction */
	int level;            /* passing that the crosshair reads sizes at, % */
	size_t site_at;       /* of the Sites page */
	size_t data_top;      /* first sieve shown on the Data page */
	struct site_row *row; /* [n_row] of the Sites page, owned */
	size_t n_row;
	int rows_at; /* tenths they are of; 0: of another session */
	enum plot_kind picture;
	bool held;            /* the calibration waits */
	int pace;             /* index of PACES */
	double due;           /* when the next generation is */
	size_t generation;    /* looked at, 1..; 0: the last */
	double holdout;       /* RMSE of the site in use, points, or NAN */
	struct typing typing; /* a command */
	struct typing speed;
	struct paste paste;
	double pasted; /* when its last character came */
	struct viewer viewer;
	struct tab tab[PAGES];
	char *command; /* the last one, for show */
	char message[800];
	bool bad;             /* the message is an error */
	bool told;            /* it is of the command that moved the slider */
	const char *question; /* that waits for an answer, or NULL */
	const struct inquiry *inquiry; /* likewise, for a line */
	struct typing answer;          /* that line */
	int inquiry_up;                /* rows its table is moved up */
	FILE *said;                    /* what commands print */
	char *said_text;
	size_t said_n;
	bool leave;
	/* The session's, which it gets back. */
	struct {
		FILE *out, *notes;
		struct hooks hooks;
		bool prompt;
		size_t typed_at;
		struct screen screen;
	} before;
};

/* Generations a second; the last: as many as can be. */
enum { PACE_COUNT = 7, PACE_FULL = PACE_COUNT - 1 };
extern const double PACES[PACE_COUNT];

/* What is known of the search of the site in use, see plots.h. */
struct plots_past tui_past(const struct tui *t);

/* The generation looked at, 1..n; and to look at it: at the last of a search
 * that runs, those which follow are. */
size_t tui_generation(const struct tui *t);
void tui_look_at(struct tui *t, size_t generation);

/* How long the search under way has run, s: pauses do not count. */
double tui_searched(const struct tui *t);

/* The site in use, or NULL. */
const struct entry *tui_entry(const struct tui *t);

/* The speeds of the slider at that site. */
struct slider_range tui_range(const struct tui *t);

/* The run of that site whose feed the slider predicts with, whatever its speed:
 * what changes while it moves is what the speed does.  It is the one that the
 * last prediction took, or stood nearest when there was none. */
size_t tui_feed(const struct tui *t);
void tui_keep_feed(struct tui *t);

/* Where the slider stands, as options of predict: "speed=77.0 feed=74", the
 * feed where it is not what predict takes by itself.  The caller frees. */
char *tui_where(const struct tui *t);

/* A line for the message row. */
void tui_say(struct tui *t, bool bad, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
