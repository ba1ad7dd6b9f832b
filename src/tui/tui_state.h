/* The state of the full screen, beside the session.  Pages read it; keys and
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
#include "cmd/fit/trials.h"
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

/* Text on the whole screen: lines from `top` on, from column `left` on.  text
 * NULL: none; line [lines]: its lines, owned.  keys: it is the list of keys,
 * those with the word; the key `at` can be run.  In other text `at` is the line
 * where the word was found. */
struct viewer {
	char *text, **line;
	int top, lines, left, columns;
	bool keys, report; /* what a long job has ended with */
	int at;
	struct edit word;
};

/* Plots of one frame that can be pointed at. */
enum { PLOTS_DRAWN = 4 };

/* Letters of such a word, and of a typed speed. */
enum { VIEWER_WORD = 31, SPEED_LETTERS = 12 };

/* A loaded site, entry of the session, at the slider's speed: P50 in mm, and
 * whether the speed is beyond those trained on; the RMSE at the speeds held
 * out, points; NAN: none; the light of its parameters, where it is lit; and the
 * verdict on a fit of its own, or NULL. */
struct site_row {
	size_t entry;
	const char *verdict;
	double p50, holdout;
	bool beyond, lit;
	enum light light;
};

/* The sheet on the Data page: its sieves, m; its columns, each a feed or a
 * product of a run; the digits that its cells need; and the doctor's findings,
 * once it has looked. */
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
struct parity {
	size_t next;
	struct trials runs;
	struct validate_score score[VALIDATE_NULL][PSD_SIZES];
	struct chart *chart;
	struct error error;
};

/* Most columns of a list. */
enum { LIST_COLUMNS = 12 };

/* Text being pasted: how many of its characters were typed, whether its first
 * line has ended, and whether something was not accepted. */
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
/* Lists of files: all files of the folder that the program runs in; its sheets,
 * for a feed whose product is estimated; the saved sessions; or the sites that
 * come with the program. */
enum picker_list { PICK_FILES, PICK_FEEDS, PICK_SESSIONS, PICK_SHIPPED };

/* Of a list the row under the cursor and the first one shown. */
struct list {
	size_t at, top;
};

/* The list of files to open, over the page.  rows: the list as rows; word: only
 * files with this word are shown; preview: of the item `previewed`, SIZE_MAX:
 * of none. */
struct picker {
	bool on;
	enum picker_list what;
	const struct page_list *rows;
	struct folder folder;
	struct edit word;
	struct list list;
	size_t previewed;
	char *preview;
};

struct inquiry;
struct envelope_check;
struct tui;

/* How a full screen is shown and gets its keys. */
struct tui_ways {
	/* The next key for t->question or t->inquiry; false: none comes. */
	bool (*answer)(struct tui *t, int *code, bool *special);
	/* Draws a frame amid a step; NULL: nothing is shown. */
	void (*show)(struct tui *t);
	/* leave leaves terminal and signals to another program, come_back takes
	 * them back; NULL where the screen is drawn without a terminal. */
	void (*leave)(void), (*come_back)(void);
	bool (*is_away)(void); /* NULL: never */
	/* True if Esc or ^C was pressed amid a step; NULL: never. */
	bool (*stopped)(struct tui *t);
};

/* The user's choices, without anything that follows from them or is owned: a
 * frame drawn beside the open screen begins with a copy. */
struct ui {
	enum page page;
	int tenths;  /* of the slider */
	double feed; /* m/s of the run whose feed is taken; 0: the mean */
	struct quantity quantity; /* above the track */
	bool cross, band, runs;   /* runs: page Predict has plot runs */
	size_t cross_at;          /* a sieve of the prediction */
	int level; /* passing that the crosshair reads sizes at, % */
	enum plot_kind picture; /* of the page Fit */
	int pace;               /* index of PACES */
	size_t generation;      /* looked at, 1..; 0: the end so far */
	size_t param_at;        /* chosen on the page Fit, 1..; 0: none */
	/* The cell of the cursor on the page Data, whether the cursor is shown,
	 * and the first cell shown. */
	struct {
		bool on;
		size_t row, at, top, left;
	} cell;
	/* Of the pages' lists; on the page Sites `at` is a site. */
	struct list list[PAGES];
	int sort; /* of sites, by 1 + a column; 0: as loaded */
	bool sort_down;
};

/* All that a prediction depends on besides speed and feed: while it is the
 * same, so are the answers.  origin: a share in it. */
struct basis {
	const struct site *site;
	struct origin *origin;
	struct params params;
	struct choices set;
};

/* What a prediction depends on.  basis: number of its basis; generation: of a
 * search under way, which has its own parameters; tenths 0: no prediction. */
struct view_key {
	size_t basis, feed, generation;
	int tenths;
};

/* What is shown, as it follows from the session and the user's choices, see
 * view.h. */
struct view {
	struct basis basis;
	size_t n_basis;
	size_t revision; /* counts what may have changed the session */
	struct view_key of;
	double moved;            /* when the slider last was */
	struct prediction shown; /* at the slider's speed; product.n 0: none */
	bool formed;             /* it is of a search that was under way */
	bool lit;                /* light is of it, see panel.c */
	struct trust light;
	struct numbers current, reference, pinned; /* site "": none */
	struct prediction
	    pinned_whole;    /* whose numbers are in pinned, borrowed */
	double holdout;      /* RMSE of the site in use, points, or NAN */
	struct strip *strip; /* the response strip */
	struct goal goal;    /* the one that is set, see goals.h */
	struct envelope_check *envelope_check; /* owned, or NULL */
	struct sheet sheet;                    /* of the Data page */
	struct parity parity;                  /* of the Parity page */
	struct site_row *row; /* [n_row] of the Sites page as sorted, owned */
	size_t n_row;
	int site_width[LIST_COLUMNS]; /* width of each one's texts */
	int rows_at; /* slider of these rows, tenths; 0: out of date */
};

/* A letter that may begin a word, see word.h.  held: its key, which has not
 * acted yet; was: the choices before it. */
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
	bool goal_field; /* the typed line is a goal; fresh: still as offered */
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
	const struct page_ops *shows; /* their page */
	char *under_way;              /* line that is run, or NULL */
	bool of_script;               /* it is one of a script */
	bool stopping;                /* a key stops it */
	double ran_from;              /* when it or its script began, s */
	double drawn_at;              /* when under_way was last drawn */
	const char *begun; /* what is being done that takes a moment, or NULL */
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
	const char *job; /* command that began the job, or NULL */
	bool failed;     /* that command did */
	char message[800];
	bool bad;             /* the message is an error */
	bool told;            /* it is from the command that moved the slider */
	bool reason_shown;    /* the panel shows the reason of the light */
	const char *question; /* waiting for an answer, or NULL */
	const struct inquiry *inquiry; /* waiting for a line, or NULL */
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
	/* Members of the session, restored at the end. */
	struct {
		FILE *out, *notes;
		struct hooks hooks;
		bool prompt;
		size_t typed_at;
		struct screen screen;
	} before;
};

/* Paces of the search, generations a second; the last: as many as possible. */
enum {
	PACE_AUTO, /* slow while the best gains much */
	PACE_USUAL = 5,
	PACE_FULL = 7,
	PACE_COUNT
};
extern const double PACES[PACE_COUNT];

/* Returns what is known of the search of the site in use, see plots_past.h. */
struct plots_past tui_past(const struct tui *t);

/* Steps of the search: its generations, and one for the polish if that found a
 * better candidate.  tui_count_generations returns how many;
 * tui_generation_shown the one shown, 1..; tui_show_generation shows one: at
 * the last of a running search, the later ones are followed. */
size_t tui_count_generations(const struct tui *t);
size_t tui_generation_shown(const struct tui *t);
void tui_show_generation(struct tui *t, size_t step);

/* Returns the generation shown, 1..n; at the polish, the last. */
size_t tui_generation(const struct tui *t);

/* Returns how long the search under way has run, s, without pauses. */
double tui_searched(const struct tui *t);

/* Returns the site in use, or NULL. */
const struct entry *tui_current_entry(const struct tui *t);

/* Returns the site in use as the slider's predictions have it: with the feed of
 * the sheet that is set, unless a run's feed is taken; or NULL. */
const struct entry *tui_asked(const struct tui *t);

/* What to do first if no site is loaded; tui_why_none returns why nothing is
 * predicted. */
#define TUI_NO_SITE N_("no site is loaded: o opens a sheet")
const char *tui_why_none(const struct tui *t);

/* Return the speeds of the slider at the site. */
struct slider_range tui_range(const struct tui *t);
struct slider_range tui_range_of(
    const struct session *s, const struct entry *entry);

/* The feed of the slider's predictions, the same at all speeds, so that only
 * the speed changes them.  tui_feed returns its run: the one of the last
 * prediction if that took a run's feed, else the one that is set; of a sheet
 * see tui_asked. */
size_t tui_feed(const struct tui *t);
void tui_keep_feed(struct tui *t);
void tui_take_feed(struct tui *t); /* the one that is set */

/* Returns the measured product of a run as shown beside the prediction, see
 * moved_product. */
const struct psd *tui_measured(const struct tui *t, size_t run);

/* True if the product was moved so far that the page must say so. */
bool tui_moved(const struct tui *t, size_t run);

/* Returns the slider's place as options of predict: "speed=77.0 feed=74", with
 * the feed if predict would take another by itself.  The caller frees. */
char *tui_options_at_slider(const struct tui *t);

/* Returns the command that answers all that is shown at the slider: predict, or
 * compare with what is pinned.  The caller frees. */
char *tui_command_of_page(const struct tui *t);

/* Ignores clicks until the next frame: the frame shown is out of date, and a
 * mouse event may come before the next. */
void tui_clear_hits(struct tui *t);
/* Discard what was computed, but not where the cursor is. */
void tui_forget_sheet(struct sheet *sheet);
void tui_forget_parity(struct parity *parity);

/* Sets the message row; bad: it is an error. */
void tui_say(struct tui *t, bool bad, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
