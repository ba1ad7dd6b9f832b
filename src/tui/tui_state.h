/* What the full screen knows beside the session.  The panes read it; keys and
 * commands change it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_TUI_STATE_H
#define TIPSPEED_TUI_TUI_STATE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/tr.h"
#include "cmd/ask/goals.h"
#include "cmd/draw/plots.h"
#include "cmd/draw/plots_past.h"
#include "cmd/session/session.h"
#include "core/check/outliers.h"
#include "core/psd/quantity.h"
#include "core/check/trust.h"
#include "tui/folder.h"
#include "tui/keys.h"
#include "tui/layout.h"
#include "tui/widgets/slider.h"
#include "tui/hits.h"
#include "tui/widgets/edit.h"

/* The numbers of a prediction, for a difference: P20, P50 and P80 and the break
 * size, mm; passing at 0.063, 2 and 4 mm, %, NAN where these lie off its
 * sieves; feed: m/s of the run that it was sampled in, 0: one for all. */
enum { NUMBERS_FRACTIONS = 3 };
struct numbers {
	char site[64];
	double speed, feed, size[3], break_mm, passing[NUMBERS_FRACTIONS];
};

/* Text on the whole screen: lines from `top` on, of these what is right of the
 * column `left`.  text NULL: none; line [lines]: its lines, owned.  keys: the
 * list of keys, of those that have the word; one of them, `at`, can be run.  Of
 * other text `at` is the line with the word that was found. */
struct viewer {
	char *text, **line;
	int top, lines, left, columns;
	bool keys, report; /* what a long job has ended with */
	int at;
	struct edit word;
};

/* Plots of one frame that can be pointed at. */
enum { PLOTS_DRAWN = 4 };

/* How many letters such a word may have, and a speed. */
enum { VIEWER_WORD = 31, SPEED_LETTERS = 7 };

/* A loaded site, entry of the session, at the slider's speed: P50 in mm,
 * whether that is beyond the speeds trained on; the RMSE at those held out,
 * points; NAN: none; and the light of its parameters, where it is lit, with
 * what a fit of its own is called, or NULL. */
struct site_row {
	size_t entry;
	const char *verdict;
	double p50, holdout;
	bool beyond, lit;
	enum light light;
};

/* The sheet on the Data page: its sieves, m, its columns, a feed or a product
 * of a run each, and the digits that its cells want; what the doctor found,
 * where it has looked. */
struct sheet_column {
	bool feed;
	size_t run;
};
struct sheet {
	const struct site *site; /* NULL: none yet */
	size_t n, n_column;
	double *sieve;
	struct sheet_column *column;
	int digits, width;
	bool looked, calibrated;
	double misfit; /* of the calibration by which it looked */
	struct doctor doctor;
};

/* All sites' held-out runs on the Parity page, compared site by site: `next`
 * is the one to compare, n_entry when all are; the plot, or why there is
 * none. */
struct parity_point {
	size_t entry;
	struct validation v;
};
struct parity {
	size_t next, n;
	struct parity_point *point;
	struct validate_score score[VALIDATE_NULL][PSD_SIZES];
	struct chart *chart;
	struct error error;
};

/* Columns of the Sites page. */
enum { SITE_COLUMNS = 12 };

/* Text being pasted: how many of its characters were typed, whether its first
 * line has ended, and whether something was not taken. */
struct paste {
	bool on, ended, left;
	size_t taken;
};

/* A cell of the screen. */
struct cursor {
	int row, column;
};

struct strip;
struct page_list;
struct page_ops;
/* What is listed: the folder that the program runs in, of that sheets with a
 * feed that a product is estimated of, or saved sessions; or the sites that
 * come with the program. */
enum picker_list { PICK_FILES, PICK_FEEDS, PICK_SESSIONS, PICK_SHIPPED };

/* Files to open one of, over the page.  rows: the list of them; word: that they
 * have; preview: of the item `previewed`, SIZE_MAX: of none. */
struct picker {
	bool on;
	enum picker_list list;
	const struct page_list *rows;
	struct folder folder;
	struct edit word;
	size_t at, top, previewed;
	char *preview;
};

struct inquiry;
struct envelope_check;
struct tui;

/* How a full screen is shown. */
struct tui_ways {
	/* The next key for t->question or t->inquiry; false: none comes. */
	bool (*answer)(struct tui *t, int *code, bool *special);
	/* Draws a frame in the midst of a step; NULL: nobody sees it. */
	void (*show)(struct tui *t);
	/* Leaves terminal and signals to somebody else, and takes them back;
	 * NULL where it is drawn without a terminal. */
	void (*leave)(void), (*come_back)(void);
	bool (*is_away)(void); /* NULL: never */
	/* Amid a step, whether Esc or ^C was pressed; NULL: never. */
	bool (*stopped)(struct tui *t);
};

/* What the user has chosen, and nothing that follows from it, nor anything
 * owned: a frame beside the open screen begins with a copy. */
struct ui {
	enum page page;
	int tenths;  /* of the slider */
	double feed; /* m/s of the run whose feed is taken; 0: the mean */
	struct quantity quantity; /* above the track */
	bool cross, band, runs;   /* runs: page Predict has plot runs */
	size_t cross_at;          /* a sieve of the prediction */
	int level;    /* passing that the crosshair reads sizes at, % */
	int start_at; /* of what can be done without a site */
	enum plot_kind picture; /* of the page Fit */
	int pace;               /* index of PACES */
	size_t generation;      /* looked at, 1..; 0: the end so far */
	size_t param_at;        /* chosen on the page Fit, 1..; 0: none */
	/* The cell of the cursor on the page Data, whether it is shown, and the
	 * first cell that is. */
	struct {
		bool on;
		size_t row, at, top, left;
	} cell;
	size_t top[PAGES]; /* the first row shown of a page's list */
	size_t point_at;   /* of the Parity page */
	size_t site_at;    /* of the Sites page */
	int sort;          /* it, by 1 + a column; 0: as they were loaded */
	bool sort_down;
};

/* All that a prediction follows from beside speed and feed: while it is the
 * same, so are answers.  origin: a share in it. */
struct basis {
	const struct site *site;
	struct origin *origin;
	struct params params;
	struct choices set;
};

/* What a prediction is of.  basis: counts those there were; generation: of a
 * search under way, which has parameters of its own; tenths 0: of nothing. */
struct view_key {
	size_t basis, feed, generation;
	int tenths;
};

/* What is shown and follows from the session and what is chosen, see view.h. */
struct view {
	struct basis basis;
	size_t n_basis;
	size_t revision; /* counts what may have changed the session */
	struct view_key of;
	double moved;            /* when the slider last was */
	struct prediction shown; /* at the slider's speed; product.n 0: none */
	bool formed;             /* it is of a search that was under way */
	struct numbers current, reference, pinned; /* site "": none */
	struct prediction
	    pinned_whole;    /* whose numbers are in pinned, borrowed */
	double holdout;      /* RMSE of the site in use, points, or NAN */
	struct strip *strip; /* what is drawn there */
	struct goal goal;    /* the one that is set, see goals.h */
	struct envelope_check *envelope_check; /* owned, or NULL */
	struct sheet sheet;                    /* of the Data page */
	struct parity parity;                  /* of the Parity page */
	struct site_row *row; /* [n_row] of the Sites page as sorted, owned */
	size_t n_row;
	int site_width[SITE_COLUMNS]; /* what the texts of each want */
	int rows_at; /* tenths they are of; 0: of another session */
};

/* A letter that may begin a word, see word.h.  held: what it does as a key, and
 * has not done yet; was: what was chosen before it. */
struct word {
	char letter;
	double at;
	const struct key *held;
	struct ui was;
};

struct tui {
	struct session *session;
	const struct tui_ways *ways;
	struct layout layout;
	struct ui ui;
	struct view view;
	struct cursor cursor; /* on the focus */
	bool aside;           /* drawn without a terminal */
	double clock;    /* s; a step with every key where it is drawn aside */
	double started;  /* the search or its last part, by that clock */
	double ran;      /* s of its parts before */
	bool goal_field; /* the line typed is that; fresh: as it was offered */
	bool goal_fresh;
	const struct key *wish; /* of its speeds, pressed before they are */
	int wish_from;          /* known, and where the slider then stood */
	bool mouse;
	struct hits hits; /* of the frame shown */
	struct {
		struct plot_request request;
		struct area area;
	} drawn[PLOTS_DRAWN]; /* its plots */
	size_t n_drawn;
	const struct page_ops *shows; /* whose these are */
	char *under_way;              /* line that is run, or NULL */
	bool of_script;               /* it is one of a script */
	bool stopping;                /* a key stops it */
	double ran_from;              /* when it or its script began, s */
	double drawn_at;              /* when that was last drawn */
	const char *begun; /* what takes a moment just now, or NULL */
	bool held;         /* the calibration waits */
	double due;        /* when the next generation is */
	struct edit line;  /* a command, or a goal */
	struct edit speed;
	struct edit filter; /* a word that rows of a list must have */
	struct word word;
	struct paste paste;
	double pasted; /* when its last character came */
	struct viewer viewer;
	char *closed; /* the text that was closed last, or NULL */
	struct picker picker;
	char *command;   /* the last one, for show */
	const char *job; /* name of that which began the job, or NULL */
	bool failed;     /* it did */
	char message[800];
	bool bad;             /* the message is an error */
	bool told;            /* it is of the command that moved the slider */
	bool left_out;        /* the panel has more than it shows */
	const char *question; /* that waits for an answer, or NULL */
	const struct inquiry *inquiry; /* likewise, for a line */
	struct edit answer;            /* that line */
	int inquiry_up;                /* rows its table is moved up */
	struct {
		bool is, special;
		int code;
	} pointed,  /* the key that the mouse pressed for an answer */
	    again;  /* the key that is to be read next */
	FILE *said; /* what commands print */
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
enum {
	PACE_AUTO, /* slow while the best gains much */
	PACE_USUAL = 5,
	PACE_FULL = 7,
	PACE_COUNT
};
extern const double PACES[PACE_COUNT];

/* What is known of the search of the site in use, see plots.h. */
struct plots_past tui_past(const struct tui *t);

/* The steps of the search: its generations, and one for the polish where that
 * found better.  The one looked at, 1..; and to look at it: at the last of a
 * search that runs, those which follow are. */
size_t tui_steps(const struct tui *t);
size_t tui_step(const struct tui *t);
void tui_look_at(struct tui *t, size_t step);

/* The generation looked at, 1..n, at the polish the last. */
size_t tui_generation(const struct tui *t);

/* How long the search under way has run, s: pauses do not count. */
double tui_searched(const struct tui *t);

/* The site in use, or NULL. */
const struct entry *tui_entry(const struct tui *t);

/* What to do first where there is none, and where nothing is predicted. */
#define TUI_NO_SITE N_("no site is loaded: o opens a sheet")
const char *tui_why_none(const struct tui *t);

/* The speeds of the slider at that site. */
struct slider_range tui_range(const struct tui *t);
struct slider_range tui_range_of(
    const struct session *s, const struct entry *entry);

/* The run of that site whose feed the slider predicts with, whatever its speed:
 * what changes while it moves is what the speed does.  It is the one that the
 * last prediction took where that was a run's, else the one that is set, of
 * which a sheet counts as the mean. */
size_t tui_feed(const struct tui *t);
void tui_keep_feed(struct tui *t);
void tui_take_feed(struct tui *t); /* the one that is set */

/* The measured product of a run as it stands beside the prediction, see
 * moved_product. */
const struct psd *tui_measured(const struct tui *t, size_t run);

/* Whether it was moved by so much that it has to be told. */
bool tui_moved(const struct tui *t, size_t run);

/* Where the slider stands, as options of predict: "speed=77.0 feed=74", the
 * feed where it is not what predict takes by itself.  The caller frees. */
char *tui_where(const struct tui *t);

/* The command whose answer has all that is shown there: predict, or compare
 * with what is pinned.  The caller frees. */
char *tui_asks(const struct tui *t);

/* The frame shown is no longer what there is: until the next nothing of it is
 * touched, as one event may come before that. */
void tui_untouch(struct tui *t);
/* Forgets what was worked out, but not where the cursor is. */
void tui_forget_sheet(struct sheet *sheet);
void tui_forget_parity(struct parity *parity);

/* A line for the message row. */
void tui_say(struct tui *t, bool bad, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
