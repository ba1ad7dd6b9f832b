/* The state of the full screen, in addition to the session.  Pages read it;
 * keys and commands change it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_TUI_STATE_H
#define TIPSPEED_TUI_TUI_STATE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/tr.h"
#include "cmd/ask/goals.h"
#include "cmd/draw/plots.h"
#include "cmd/draw/plots_search.h"
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

/* The numbers of a prediction, for showing differences.  site: the key of its
 * site, or "" for no prediction.  speed: m/s.  size: P20, P50 and P80, mm.
 * passing: at NUMBERS_SIEVE, %; NAN outside the product's sieves. */
enum { NUMBERS_FRACTIONS = 3 };
/* The sieves by which sand is sold, m. */
extern const double NUMBERS_SIEVE[NUMBERS_FRACTIONS];
struct numbers {
	char site[64];
	double speed, size[3], break_mm, passing[NUMBERS_FRACTIONS];
};

/* Text on the whole screen, shown from line `top` and column `left`; text is
 * NULL if none is shown.  line [lines]: its lines, owned.  columns: the width
 * of the widest.  keys: the text is the list of keys that match the word, and
 * the key `at` can be run.  In other text, `at` is the line in which the word
 * was found, or -1. */
struct viewer {
	char *text, **line;
	int top, lines, left, columns;
	int screen;        /* the width that the lines were made for */
	bool keys, report; /* report: the result of a long job */
	int at;
	struct edit word;
};

/* Maximum number of plots in a frame that react to the mouse. */
enum { PLOTS_DRAWN = 4 };

/* Maximum letters in a word to search for, and in a typed speed. */
enum { VIEWER_WORD = 31, SPEED_LETTERS = 12 };

/* A row of page Sites.  entry: the index of its site in the session.  judged:
 * light and verdict are known.  verdict: on the site's own fit, or NULL.  p50:
 * at `speed`, mm.  beyond: that speed is outside the training speeds.  holdout:
 * RMSE at held-out speeds, points, or NAN.  light: how far to trust its
 * parameters, if has_light. */
struct site_row {
	size_t entry;
	const char *verdict;
	double speed, p50, holdout;
	bool beyond, judged, has_light;
	enum light light;
};

/* The sheet on page Data.  sieve [n]: its sieves, m.  column: each is the feed
 * or the product of a run.  digits: the decimals that its cells need.  width:
 * of a column.  looked: doctor has the doubtful cells.  calibrated: they were
 * judged by a calibration, too. */
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
	double misfit; /* of the calibration behind the findings */
	struct outlier_findings doctor;
};

/* The held-out runs of all sites on page Parity, compared site by site.  next:
 * the site to compare next, or n_entry when done; chart: the plot; error: why
 * there is none. */
struct parity {
	size_t next;
	struct trials runs;
	struct chart *chart;
	struct error error;
};

/* Maximum number of columns in a list. */
enum { LIST_COLUMNS = 12 };

/* Text being pasted.  taken: number of characters typed; ended: its first line
 * has ended; left: something was not accepted. */
struct paste {
	bool on, ended, left;
	size_t taken;
};

/* A cell of the screen. */
struct cursor {
	int row, column;
};

struct page_list;
/* Lists of files: all files in the working folder; its sheets, for a feed whose
 * product is to be estimated; saved sessions; or shipped sites. */
enum picker_list { PICK_FILES, PICK_FEEDS, PICK_SESSIONS, PICK_SHIPPED };

/* The row under the cursor in a list, and the first row shown. */
struct list {
	size_t at, top;
};

/* The list of files to open, over the page.  rows: the list as rows; word: a
 * filter for files; preview: the preview of item `previewed`, which is SIZE_MAX
 * if there is none. */
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

struct user_question;
struct envelope_check;
struct tui;

/* How a full screen is shown and gets its keys (callbacks). */
struct tui_callbacks {
	/* Gets the next key for t->question or t->inquiry; returns false if
	 * there is none. */
	bool (*answer)(struct tui *t, int *code, bool *special);
	/* Draws a frame during a step; NULL: nothing is shown. */
	void (*show)(struct tui *t);
	/* leave hands the terminal and signals to another program; come_back
	 * takes them back.  NULL without a terminal. */
	void (*leave)(struct tui *t), (*come_back)(struct tui *t);
	/* True if Esc or ^C was pressed during a step; NULL: never. */
	bool (*stopped)(struct tui *t);
};

/* The user's choices, with nothing computed or owned, so that they can be
 * copied and put back. */
struct ui {
	enum page page;
	double speed; /* m/s; see tui_slider_speed */
	double feed;  /* m/s of the run whose feed is used; 0: the mean */
	struct quantity quantity; /* above the track */
	bool quantity_of_goal;    /* it follows the goal's limit */
	/* What page Predict shows.  runs: the plot of all runs; goal_view: the
	 * goal at full height. */
	bool crosshair, band, runs, goal_view;
	size_t crosshair_sieve; /* a sieve of the prediction */
	int crosshair_passing;  /* %, at which the crosshair reads sizes */
	enum plot_kind picture; /* on page Fit */
	int pace;               /* index of PACES */
	size_t generation;      /* shown, 1..; 0: the latest */
	size_t param_at;        /* chosen on page Fit, 1..; 0: none */
	/* On page Data: the cell under the cursor (row and column `at`), if the
	 * cursor is shown (on), and the first cell shown. */
	struct {
		bool on;
		size_t row, at, top, left;
	} cell;
	/* The cursors of the pages' lists; on page Sites, `at` is an entry of
	 * the session. */
	struct list list[PAGES];
	int sort; /* order of sites: 1 + a column; 0: as loaded */
	bool sort_down;
};

/* What a prediction depends on besides speed and feed: while it is unchanged,
 * so are the answers.  origin: held until origin_release. */
struct fit_record {
	const struct site *site;
	struct origin *origin;
	struct params params;
	struct settings set;
};

/* Everything that a prediction depends on.  basis: the view's n_basis.  feed:
 * the run whose feed is used.  generation: of a running search, which has its
 * own parameters; else 0.  speed: m/s, or 0 for no prediction. */
struct prediction_key {
	size_t basis, feed, generation;
	double speed;
};

/* The quantity above the track at n speeds, m/s, from the slowest of the slider
 * to the fastest.  value: its value and the ends of its band, in the unit
 * shown; the ends are NAN without a band.  of, basis, feed: what it was
 * computed for. */
enum { STRIP_POINTS = 41 };
struct strip {
	struct quantity of;
	size_t basis, feed, n;
	double speed[STRIP_POINTS], value[STRIP_POINTS][3];
};

/* The content shown, computed from the session and the user's choices, see
 * view.h. */
struct view {
	struct fit_record basis;
	size_t n_basis;
	size_t revision; /* counts possible changes of the session */
	struct prediction_key of;
	double moved;            /* when the slider was last moved */
	struct prediction shown; /* at the slider's speed; product.n 0: none */
	bool from_search;        /* it comes from a running search */
	bool light_known;        /* light is that of `shown` */
	struct trust light;
	struct numbers current, reference, pinned; /* site "": none */
	double holdout;     /* RMSE for the current site, points, or NAN */
	struct strip strip; /* the response strip */
	struct goal goal;   /* from `set goal`, see goals.h */
	struct envelope_check *envelope_check; /* owned, or NULL */
	struct sheet sheet;                    /* for page Data */
	struct parity parity;                  /* for page Parity */
	struct site_row *row; /* [n_row] for page Sites, as sorted, owned */
	size_t n_row;
	int site_width[LIST_COLUMNS]; /* width of each column's texts */
	bool rows_left;               /* some are not computed yet */
};

/* A letter that may begin the name of a command, or a digit that may begin a
 * speed, see word.h.  at: when it was typed, s.  held: its key, if that has not
 * acted yet, or NULL.  was: the user's choices before it. */
struct held_letter {
	char letter;
	double at;
	const struct key *held;
	struct ui was;
};

struct tui {
	struct session *session;
	const struct tui_callbacks *callbacks;
	struct layout layout;
	struct ui ui;
	struct view view;
	struct cursor cursor; /* on the focus */
	bool aside;           /* drawn without a terminal */
	bool away;            /* another program has the terminal */
	double clock;         /* s; if aside, advances with every key */
	double started;       /* when the search began or was last continued */
	double ran;           /* s that it had run before */
	bool goal_field; /* the line typed is a goal; goal_fresh: unedited */
	bool goal_fresh;
	/* A key that waits for the goal's speeds, or NULL, and the slider's
	 * position when it was pressed. */
	const struct key *pending_key;
	double pending_from;
	bool mouse;
	struct hits hits; /* in the frame shown */
	/* plots in it that react to the mouse */
	struct plot_request drawn[PLOTS_DRAWN];
	size_t n_drawn;
	char *running_line;    /* the line being run, or NULL */
	bool of_script;        /* the line is from a script */
	bool stopping;         /* a key is stopping it */
	double ran_from;       /* start of the line or its script, s */
	double drawn_at;       /* when running_line was last drawn */
	const char *computing; /* the long computation in progress, or NULL */
	bool held;             /* the calibration is paused */
	double due;            /* time of the next generation */
	struct edit line;      /* a command, or a goal */
	struct edit speed;
	struct edit filter; /* filter for the rows of a list */
	struct held_letter word;
	struct paste paste;
	double pasted; /* when its last character came */
	struct viewer viewer;
	char *closed; /* the text last closed, or NULL */
	struct picker picker;
	char *command;   /* last command, for display */
	const char *job; /* command that started the job, or NULL */
	bool failed;     /* the last command failed */
	char message[800];
	bool bad; /* the message is an error */
	/* The next prediction keeps the message, which is from the command that
	 * moved the slider. */
	bool keep_message;
	bool reason_shown;    /* the panel shows the light's reason */
	const char *question; /* waiting for yes or no, or NULL */
	const struct user_question *inquiry; /* waiting for a line, or NULL */
	struct edit answer;                  /* the line typed for it */
	int inquiry_up; /* rows by which its table is scrolled up */
	struct {
		bool is, special;
		int code;
	} put_back;     /* key that input_read_next_key returns next */
	FILE *captured; /* output of commands */
	char *captured_text;
	size_t captured_n;
	bool leave;
	/* Members of the session to restore at the end. */
	struct {
		FILE *out, *notes;
		struct hooks hooks;
		bool prompt;
		size_t typed_at;
		struct screen screen;
	} before;
};

/* Paces of the search: indices of PACES, which has generations per second; the
 * last is full speed. */
enum {
	PACE_AUTO, /* slow while the best improves fast */
	PACE_USUAL = 5,
	PACE_FULL = 7,
	PACE_COUNT
};
extern const double PACES[PACE_COUNT];

/* Returns the search for the current site's parameters, see plots_search.h. */
struct search_shown tui_calibration_history(const struct tui *t);

/* Steps of the search: its generations, and one for the polish if that found a
 * better candidate.  tui_count_generations returns their number;
 * tui_shown_generation_number the one shown, 1..; tui_show_generation shows
 * one, or follows a running search if given its last. */
size_t tui_count_generations(const struct tui *t);
size_t tui_shown_generation_number(const struct tui *t);
void tui_show_generation(struct tui *t, size_t step);

/* Returns the generation shown, 1..n; during the polish, the last. */
size_t tui_shown_unpolished_generation(const struct tui *t);

/* Returns how long the current search has run, s, without pauses. */
double tui_calibration_seconds(const struct tui *t);

/* Returns the entry of the current site, or NULL. */
const struct entry *tui_current_site_entry(const struct tui *t);

/* tui_current_site returns the current site, or NULL; tui_rotor_diameter
 * returns the diameter of its rotor, m, or 0 if it is not known. */
const struct site *tui_current_site(const struct tui *t);
double tui_rotor_diameter(const struct tui *t);

/* Returns the entry that the slider's predictions use, or NULL: the current
 * site or, if `set feed` is a sheet and no run's feed is used, a copy of it
 * with that feed. */
const struct entry *tui_site_entry_for_prediction(const struct tui *t);

/* TUI_NO_SITE says what to do if no site is loaded; tui_why_no_prediction
 * returns why there is no prediction. */
#define TUI_NO_SITE N_("no site is loaded: o opens a sheet")
const char *tui_why_no_prediction(const struct tui *t);

/* Returns the range of the slider for the site. */
struct slider_range tui_slider_range(const struct tui *t);

/* tui_set_slider_speed moves the slider to a speed, m/s.
 * tui_set_slider_position moves it to a position or, if the rotor is known, to
 * the exact speed of a run at that position.  tui_slider_speed returns its
 * speed, m/s: that of its position or, if the rotor is known, the one it was
 * moved to. */
void tui_set_slider_speed(struct tui *t, double speed);
void tui_set_slider_position(struct tui *t, int position);
double tui_slider_speed(const struct tui *t);
int tui_slider_position(const struct tui *t);

/* Returns the site of the pinned prediction, or NULL if it is not loaded. */
const struct site *tui_pinned_site(const struct tui *t);

/* The feed for the slider's predictions is the same at all speeds, so that only
 * the speed changes them.  tui_run_index_of_feed returns the run that it is
 * from: that of the last prediction if it used a run's feed, or else that of
 * `set feed`; for a sheet, see tui_site_entry_for_prediction.  tui_feed_curve
 * returns its curve. The others set it by the last prediction, or by `set
 * feed`. */
size_t tui_run_index_of_feed(const struct tui *t);
const struct psd *tui_feed_curve(const struct tui *t);
void tui_set_feed_from_answer(struct tui *t);
void tui_set_feed_from_setting(struct tui *t);

/* Returns what the slider's predictions have instead of the runs' feed, "feed
 * b.csv", or "".  Measured products are then not compared with them. */
const char *tui_other_feed(const struct tui *t);

/* Returns the measured product of a run as shown with the prediction, see
 * measured_product_moved_to_feed. */
const struct psd *tui_product_adjusted_to_feed(const struct tui *t, size_t run);

/* True if the product was moved far enough that the page must say so. */
bool tui_is_product_moved_to_feed(const struct tui *t, size_t run);

/* Returns the slider's speed as options of predict, "speed=77.0 feed=74" or
 * "speed=1650rpm", with the feed if predict would otherwise use another.  The
 * caller frees it. */
char *tui_speed_and_feed_options(const struct tui *t);

/* Returns the command for everything shown at the slider's speed: predict, or
 * compare with the pinned prediction.  The caller frees it. */
char *tui_command_at_slider(const struct tui *t);

/* Ignores clicks until the next frame, because the frame shown is out of
 * date. */
void tui_clear_click_areas(struct tui *t);
/* Discard computed results, but not the cursor's position. */
void tui_free_sheet(struct sheet *sheet);
void tui_free_parity(struct parity *parity);

/* Sets the message.  bad: it is an error. */
void tui_set_message(struct tui *t, bool bad, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds to the message of a line, unless `more` is "".  If the line opened a
 * text, only an empty message is added to; it is read after the text is
 * closed. */
void tui_append_to_message(struct tui *t, const char *more);

#endif
