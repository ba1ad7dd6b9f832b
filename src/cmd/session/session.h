/* A session: what has been loaded, set and found so far.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SESSION_H
#define TIPSPEED_CMD_SESSION_SESSION_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"
#include "cmd/session/loaded.h"
#include "cmd/session/settings.h"
#include "io/store/store.h"

struct canvas;
struct inquiry;
struct rounds;
struct screen_request;
struct session;

/* Functions of the driver that commands call. */
struct hooks {
	/* Clears progress off the line for a note or an answer; NULL: there is
	 * none. */
	void (*tidy)(void);
	bool (*stop)(void); /* whether a long computation should end, as the
			       user waits; NULL: never */
	/* Called before a computation that takes a moment, with a few words
	 * for the user; NULL if not interactive. */
	void (*begins)(const char *what);
	bool (*show_page)(const char *page); /* shows a page of the manual; NULL
						where there is no terminal */
	/* Draws the full screen, see plot.h; NULL: there is none. */
	struct canvas *(*draw_screen)(
	    struct session *, struct screen_request *, struct error *);
	/* Runs the full screen until the user quits; returns an exit status.
	 * NULL: it is not available. */
	int (*run_screen)(struct session *);
	/* Asks the user yes or no; NULL if not interactive. */
	bool (*confirm)(struct session *s, const char *question);
	/* Asks the user for a line about a sheet.  The caller frees it; NULL
	 * when the user gives up.  NULL if not interactive. */
	char *(*question)(struct session *s, const struct inquiry *inquiry);
};

/* A calibration under way, or several in succession.  The driver calls
 * session_step until session_busy is false. */
struct job {
	const struct rounds *rounds; /* see job.h */
	void *of;                    /* accumulator, owned by the job type */
	void *found;                 /* returned by rounds->follow; owned */
	struct calibration *calibration;
	struct calibration *lowest; /* what a plain search is compared with, or
				     * NULL */
	size_t entry;
	struct invocation *invocation; /* the command that runs it */
	double started;                /* s, of a monotonic clock */
	double stopped;                /* by the same clock, if it is paused */
	struct calibrate_options options;
	bool *train;
	bool fits;          /* each round is its site's own fit */
	bool detail;        /* reports the search, and all of the fit */
	bool watch;         /* its curves are drawn while it goes on */
	bool paused;        /* stopped by ^C; `continue` goes on */
	bool held_back;     /* its site's parameters were better and stayed */
	bool gave;          /* its site `given` when it was last stopped */
	bool taken;         /* its fit is in its site, and draws of it follow */
	bool newest;        /* paused, and undo would begin with it */
	bool apart;         /* rounds can be calibrated side by side */
	size_t step;        /* of all rounds so far */
	size_t pause_at;    /* step to stop after; 0: none */
	double *run_weight; /* [n_run] of the site, or NULL */
	struct params given;
	double before; /* misfit of the site's parameters then, or INFINITY */
};

/* The terminal that results are printed on.  columns: 0 where it is no
 * terminal; colours: 0 (none), 8, 16 or 256; drawing: it shows more than
 * ASCII. */
struct screen {
	int columns, rows, colours;
	bool drawing;
};

struct files;
struct plant_log;
struct spec;
struct energies;
struct pin;
struct standing;
struct blended;
struct journal;
struct keep;
struct script;
struct invocation;
struct undo;

struct session {
	size_t n_entry, current; /* current is meaningful when n_entry > 0 */
	struct entry *entry;
	struct choices set;
	bool prompt;     /* lines are typed by a user */
	size_t typed_at; /* number of open scripts at which lines are typed */
	enum isa isa;    /* most that calibrations may use */
	bool safe;       /* neither commands nor keys may touch files or
			       the shell */
	bool linear;     /* the screen is heard: words, no pictures */
	FILE *out;       /* results */
	FILE *notes;     /* lines beside results; NULL: none */
	struct screen screen;
	const char *file;          /* target of the results; NULL: no file */
	struct book *book;         /* workbook that collects them, or NULL */
	struct document *document; /* document that collects them, or NULL */
	size_t rows;               /* reported to the present target */
	size_t n_answer;
	struct answer *
	    *answer; /* kept, the newest last: see session_keep_answer */
	struct job job;
	struct hooks hooks;  /* functions of the driver */
	struct files *files; /* read and written, see files.h; or NULL */
	size_t n_site;
	struct site **site;    /* every site there was; entries borrow them */
	struct plant_log *log; /* in use, or NULL */
	size_t n_log;
	struct plant_log **logs; /* every one there was */
	const struct spec *spec; /* envelope chosen, or NULL */
	size_t n_spec;
	struct spec **specs; /* every one there was */
	double asked;        /* speed that was last asked about, or 0 */
	struct moved *moved; /* see moved.h */
	struct blended *fed; /* sheets of 'set feed', see blended.h, or NULL */
	struct standing *standing; /* see question_standing; NULL: none made */
	const struct pin *pin;     /* see pin.h, or NULL */
	size_t n_pin;
	struct pin **pins;             /* every one there was */
	const struct energies *energy; /* shown, or NULL */
	size_t n_energies;
	struct energies **energies; /* every one there was */
	struct choices *first;      /* as set by the command line, for reset */
	struct journal *journal;
	struct keep *keep; /* autosave, see autosave.h; NULL: off */
	struct undo *undo;
	struct script *script;         /* scripts being read, innermost first */
	size_t scripts;                /* how many */
	struct invocation *invocation; /* commands under way, innermost first */
	struct store *store; /* ":memory:" until another is put here */
	bool wants_tui; /* the driver opens the full screen, then goes on */
	bool quit;
};

/* Returns the site in use; asserts that there is one. */
struct entry *session_entry(struct session *s);

/* False, with an error that says what to do next, when no site is loaded; what:
 * the command that needs one. */
bool session_need_site(
    const struct session *s, const char *what, struct error *error);

/* Discards the answers kept, because the site or its parameters changed. */
void session_forget(struct session *s);

/* Reports the faults of a file: the last becomes the error, those before it are
 * printed to notes, so that they appear in order; if reading was interrupted,
 * only that is reported.  Returns false. */
bool session_tell_faults(const struct session *s, const char *path,
    const struct error_list *errors, struct error *error);

/* Prints an answer in the format that is set, and keeps it.  Returns true, for
 * a command to end with. */
bool session_show_answer(struct session *s, struct answer *answer);

/* Keeps an answer, which the session then owns, as the newest of its command.
 * An answer without fields is freed instead, as nothing could be read from
 * it. */
void session_keep_answer(struct session *s, struct answer *answer);

/* Returns the number of a field, see answer_number, from the newest answer that
 * has it, of the commands listed, with a space between two; else NAN. */
double session_answer_number(
    const struct session *s, const char *commands, const char *path);

/* Sets whether texts are translated: they are unless the results are for
 * programs.  Called after each change of the results' format. */
void session_language(const struct session *s);

/* Prints a line beside the results. */
void session_note(const struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* True if a calibration is under way and not stopped. */
bool session_busy(const struct session *s);

/* Returns the site that receives the fit of the calibration under way, or
 * NULL. */
const struct entry *session_fitting(const struct session *s);

/* Returns seconds of a monotonic clock. */
double session_clock(void);

/* Returns the label of a site for people: "Tierp, Granite, 11.2 mm". */
char *session_site_label(const struct site *site);

/* Returns "69, 79 (2 runs)": speeds of the runs with a product that have mark
 * [n_run] equal to `marked`; mark NULL: of all.  between: put between two
 * speeds.  The caller frees. */
char *session_speeds(const struct site *site, const char *between,
    const bool *mark, bool marked);

#endif
