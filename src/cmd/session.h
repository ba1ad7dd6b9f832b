/* A session: what has been loaded, set and found so far.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_H
#define TIPSPEED_CMD_SESSION_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"
#include "core/calibrate.h"
#include "core/misfit.h"
#include "core/params.h"
#include "core/predict.h"
#include "core/site.h"
#include "core/uncertainty.h"
#include "io/answer.h"
#include "io/store.h"

/* What a calibration left: what it found; its generations, [n], with the bounds
 * it searched in; and its misfit, from which is drawn, when first asked for,
 * what the data leave open.  Shared by the entries, snapshots and origins that
 * hold it. */
struct history {
	size_t holders, n;
	struct fit fit;
	struct calibrate_generation *generation;
	struct bounds bounds;
	struct misfit *misfit;
	struct uncertainty *uncertainty; /* NULL: not drawn yet */
	struct band band;                /* the last one asked for */
	struct band_of {
		const struct site *site;
		struct model_settings settings;
		double speed;
		size_t feed_run;
	} band_of;
};

/* A loaded site with its answers.  key: how it is called here, "gavle/4".
 * train [site->n_run]: runs to train on, or that were trained on. */
struct entry {
	struct site *site;
	char *key;
	bool *train;
	bool has_params, has_fit;
	struct params params;  /* set by hand or found */
	struct origin *origin; /* of them, see origin.h; NULL: there are none */
	struct fit fit;        /* where the parameters were found */
	struct history *history; /* of the last calibration, or NULL */
	char options[400];       /* of the fit, in the words of calibrate */
};

/* A calibration under way.  The driver pumps it: session_step until
 * session_busy is false. */
struct job {
	struct calibration *calibration;
	size_t entry;
	struct turn *turn; /* the command that runs it */
	double started;    /* s, of a clock that only goes forward */
	struct calibrate_options options;
	bool *train;
	bool all;               /* one loaded site after the other */
	bool paused;            /* stopped by ^C; `continue` goes on */
	size_t step;            /* of all sites so far */
	size_t pause_at;        /* step to stop after; 0: none */
	struct answer *summary; /* of all */
	double *run_weight;     /* [n_run] of the site, or NULL */
};

/* The terminal that results go to.  columns: 0 where they go elsewhere;
 * colours: 0 (none), 8, 16 or 256; drawing: it shows more than ASCII. */
struct screen {
	int columns, rows, colours;
	bool drawing;
};

/* What is set, as against loaded: by bounds, seed, timing and the SETTINGS. */
struct choices {
	struct model_settings model;
	struct bounds bounds;
	uint64_t seed;
	unsigned threads;
	enum answer_format format;
	unsigned semicolon; /* 1: in csv, with decimal commas */
	unsigned unpaged;   /* 0: at a prompt, what is taller than the screen is
			       paged */
	bool timing;        /* tell how long each command took */
};

struct canvas;
struct files;
struct journal;
struct keep;
struct origin;
struct screen_request;
struct script;
struct turn;
struct undo;

struct session {
	size_t n_entry, current; /* current is meaningful when n_entry > 0 */
	struct entry *entry;
	struct choices set;
	bool prompt;        /* lines are typed by somebody */
	size_t typed_at;    /* while so many scripts are open */
	enum isa isa;       /* most that calibrations may use */
	bool safe;          /* neither commands nor keys may touch files or
			       the shell */
	bool linear;        /* the screen is heard: words, no pictures */
	FILE *out;          /* results */
	FILE *notes;        /* what is said beside results; NULL: nothing */
	void (*tidy)(void); /* clears progress off the line of a note; NULL:
			       there is none */
	bool (*stop)(void); /* whether the user waits for what takes long to
			       end; NULL: never */
	struct screen screen;
	const char *file; /* results go there; NULL: no file */
	size_t rows;      /* reported since results go where they go */
	size_t n_answer;
	struct answer **answer; /* kept, the newest last: see session_keep */
	struct job job;
	bool (*show_page)(const char *page); /* shows a page of the manual; NULL
						where there is no terminal */
	/* Draws the full screen, see pictures.h; NULL: there is none. */
	struct canvas *(*draw_screen)(
	    struct session *, const struct screen_request *, struct error *);
	/* Is the full screen until it is left; returns an exit status.  NULL:
	 * none is opened. */
	int (*run_screen)(struct session *);
	/* Asks somebody who sits there; NULL: nobody does, nothing is asked. */
	bool (*confirm)(struct session *s, const char *question);
	struct files *files; /* read and written, see files.h; or NULL */
	size_t n_site;
	struct site **site;    /* every site there was; entries borrow them */
	struct choices *first; /* what the command line set; reset goes there */
	struct journal *journal;
	struct keep *keep; /* what is not saved, see keep.h; NULL: no matter */
	struct undo *undo;
	struct script *script; /* scripts being read, innermost first */
	struct turn *turn;     /* commands under way, innermost first */
	struct store *store;   /* ":memory:" until another is put here */
	bool wants_tui; /* the driver opens the full screen, then goes on */
	bool quit;
};

struct session *session_new(FILE *out, FILE *notes);
void session_free(struct session *s);

/* The site in use; asserts that there is one. */
struct entry *session_entry(struct session *s);

/* False, with the next step, when no site is loaded; what: who needs it. */
bool session_need_site(
    const struct session *s, const char *what, struct error *error);

/* Where the site's parameters are from, in words: "set by hand". */
const char *session_origin(const struct entry *entry);

/* Forgets the answers kept, because the site or its parameters are others
 * now. */
void session_forget(struct session *s);

/* Adds a site, which the session then owns, and makes it the one in use.  It
 * takes the place of a site that was read from the same file. */
void session_add(struct session *s, struct site *site);

/* Takes a site out of those loaded, and lets go of a calibration of it. */
void session_drop(struct session *s, size_t index);

/* Frees entries [n] with what they own. */
void entries_free(struct entry *entry, size_t n);

/* Another entry of the same site, with copies of what it owns and a share in
 * its history. */
struct entry entry_copy(const struct entry *from);

/* Gives a share in it up; NULL is allowed. */
void history_drop(struct history *history);

/* Finds a loaded site by name without case and accents ("borlange"), by name
 * and top size ("gavle/4") or by key.  Several or none: an error that lists
 * what there is. */
bool session_find(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Reads a site file and adds it.  digest: the one it must have, as hexadecimal
 * digits, or NULL.  Every fault of the file is printed to notes
 * but the last, which is the error. */
bool session_load(struct session *s, const char *path, const char *digest,
    struct error *error);

/* The faults of a file: the last becomes the error, those before it are printed
 * to notes, so that they are shown in order.  Returns false. */
bool session_tell_faults(const struct session *s, const char *path,
    const struct error_list *errors, struct error *error);

/* Gives an answer: prints it in the format that is set, and keeps it.  Returns
 * true, for a command to end with. */
bool session_answer(struct session *s, struct answer *answer);

/* Keeps an answer, which the session then owns, as the newest of its command;
 * one without fields, which nobody could ask for, is not kept. */
void session_keep(struct session *s, struct answer *answer);

/* The number of a field, see answer_number, in the newest answer of one of
 * these commands, with a blank between two, that has it; else NAN. */
double session_known(
    const struct session *s, const char *commands, const char *path);

/* A line beside the results. */
void session_note(const struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Runs the commands of one line.  place names it in errors.  Stops at the first
 * error, and after a command that started a job, opened a script or asks for
 * the full screen: then *next is where to go on (an offset into line) after it,
 * otherwise 0. */
bool session_line(struct session *s, const char *line, size_t from,
    const char *file, int number, size_t *next, struct error *error);

bool session_busy(const struct session *s);

/* One step of the job; prints its result and ends it when it is done. */
void session_step(struct session *s);

/* Lets go of a calibration that was stopped, and says so. */
void session_let_go(struct session *s);

/* Stops the job for the user: the best so far becomes the site's fit, and
 * `continue` goes on from there. */
void session_pause(struct session *s);

/* Ends the job, and keeps nothing of it. */
void session_stop(struct session *s);

/* Ends the commands whose job or script is over, see turn.h; session_line does
 * so before the next command.  A driver that does not go on with the line calls
 * it. ok: they did what they should. */
bool session_settle(struct session *s, bool ok, struct error *error);

/* Seconds of a clock that only goes forward. */
double session_clock(void);

/* The label of a site for people: "Tierp, Granite, 11.2 mm". */
char *session_label(const struct site *site);

#endif
