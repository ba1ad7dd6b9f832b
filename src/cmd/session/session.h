/* A session: all that was loaded, set and found so far.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SESSION_H
#define TIPSPEED_CMD_SESSION_SESSION_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"
#include "cmd/session/loaded.h"
#include "cmd/session/settings.h"
#include "core/psd/quantity.h"
#include "io/store/store.h"

struct canvas;
struct user_question;
struct job_type;
struct screen_request;
struct session;

/* Functions of the driver that commands call. */
struct hooks {
	/* Clears the progress display before a note or an answer; or NULL. */
	void (*clear_progress)(void);
	/* True if a long computation should end because the user is waiting;
	 * NULL: never. */
	bool (*stop)(void);
	/* Says in a few words that a computation will take a while; NULL if not
	 * interactive. */
	void (*announce)(const char *what);
	/* Shows a page of the manual; NULL without a terminal. */
	bool (*show_manual_page)(const char *page);
	/* Draws the full screen, see plot.h. */
	struct canvas *(*draw_screen)(
	    struct session *, struct screen_request *, struct error *);
	/* Runs the full screen until the user quits, and returns an exit
	 * status; NULL if not available. */
	int (*run_screen)(struct session *);
	/* Asks the user yes or no.  yes: at the prompt, Return alone means yes;
	 * the full screen waits for y.  NULL if not interactive. */
	bool (*confirm)(struct session *s, const char *question, bool yes);
	/* Asks the user for a line about a sheet, which the caller frees, and
	 * returns NULL if the user gives up.  NULL if not interactive. */
	char *(*ask)(struct session *s, const struct user_question *inquiry);
};

/* Work in progress: a calibration, or several tasks in turn.  The driver calls
 * session_step_job until session_is_calibrating is false. */
struct job {
	const struct job_type *type; /* see job.h */
	void *of;                    /* accumulator, owned by the job type */
	void *found;                 /* what type->follow returned; owned */
	struct calibration *calibration; /* NULL: another kind of task */
	struct calibration *lowest; /* reference for a plain search, or NULL */
	size_t entry;
	struct invocation *invocation; /* the command that runs it */
	double started;                /* s, on a monotonic clock */
	double stopped;                /* on the same clock, if paused */
	struct calibrate_options options;
	bool *train;
	bool fits;          /* each task fits its own site */
	bool detail;        /* reports the search and the whole fit */
	bool watch;         /* its curves are drawn while it runs */
	bool paused;        /* stopped by ^C; `continue` resumes it */
	bool held_back;     /* the site's parameters were better and were
			     * kept */
	size_t undo_steps;  /* that could be undone when it was paused */
	bool gave;          /* the site got `given` at the last stop */
	bool taken;         /* its fit is in the site; draws follow */
	bool newest;        /* paused, and next to be undone */
	bool apart;         /* tasks can be calibrated in parallel */
	size_t step;        /* counted over all tasks */
	size_t pause_at;    /* step to stop after; 0: none */
	double *run_weight; /* [n_run] of the site, or NULL */
	struct params given;
	double before; /* misfit of the site's former parameters, or INFINITY */
	/* The answer of the former calibration: the value of a quantity at a
	 * speed, m/s; 0 if there was none. */
	struct former {
		double speed, value;
		struct quantity of;
	} former;
};

struct last_asked {
	/* In m/s; 0 before the first question. */
	double speed;
	/* The command that found the speed; NULL if the user named it. */
	const char *found_by;
	/* The quantity, if one was named. */
	bool named;
	struct quantity of;
};

/* The terminal on which results are printed. */
struct screen {
	/* columns: 0 if not a terminal.  colours: 0 (none), 8, 16 or 256. */
	int columns, rows, colours;
	/* It can show more than ASCII. */
	bool drawing;
};

struct files;
struct plant_log;
struct spec;
struct energies;
struct pin;
struct site_with_feed;
struct blended;
struct journal;
struct autosave;
struct script;
struct invocation;
struct undo;

struct session {
	size_t n_entry, current; /* current is meaningful when n_entry > 0 */
	struct entry *entry;
	struct settings set;
	bool prompt;        /* a user types the lines */
	size_t typed_depth; /* open scripts while the user types */
	enum isa isa;       /* best that calibrations may use */
	bool safe;          /* no command or key may use files or the shell */
	bool linear;        /* for a screen reader: words, no pictures */
	FILE *out;          /* results */
	FILE *notes;        /* messages besides results */
	struct screen screen;
	const char *file;          /* target of the results; NULL: no file */
	struct book *book;         /* workbook that collects results, or NULL */
	struct document *document; /* document that collects results, or NULL */
	size_t rows;               /* rows written to the current target */
	size_t n_answer;
	struct answer *
	    *answer; /* newest last, see session_store_newest_answer */
	struct job job;
	struct hooks hooks; /* functions of the driver */
	/* Becomes true if the user interrupts what the answer of the running
	 * command rests on; NULL: none runs, or it changes the session. */
	bool *cut_short;
	struct files *files; /* those read and written, see files.h */
	size_t n_site;
	struct site **site;    /* all sites so far; entries borrow them */
	struct plant_log *log; /* in use, or NULL */
	size_t n_log;
	struct plant_log **logs; /* all so far */
	const struct spec *spec; /* chosen envelope, or NULL */
	size_t n_spec;
	struct spec **specs;          /* all so far */
	struct last_asked last_asked; /* see session_set_last_question */
	struct moved *moved;          /* see moved.h */
	/* The feed from the sheets in `set feed`, or NULL. */
	struct blended *fed;
	/* See question_site_with_feed_setting; or NULL. */
	struct site_with_feed *site_with_feed;
	const struct pin *pin; /* see pin.h, or NULL */
	size_t n_pin;
	struct pin **pins;             /* all so far */
	const struct energies *energy; /* for commands, or NULL */
	size_t n_energies;
	struct energies **energies; /* all so far */
	struct settings *initial;   /* what the command line set, for reset */
	struct journal *journal;
	struct autosave *autosave; /* see autosave.h; NULL: off */
	struct undo *undo;
	struct script *script;         /* being read, innermost first */
	size_t scripts;                /* number of scripts */
	struct invocation *invocation; /* commands in progress, innermost
					* first */
	struct store *store;           /* ":memory:" until replaced */
	bool wants_tui; /* the driver opens the full screen, then continues */
	bool quit;
};

/* Returns the current site; there must be one. */
struct entry *session_current_site_entry(struct session *s);

/* Returns false if no site is loaded; the error says what to do next.  what:
 * the command that needs one. */
bool session_require_site(
    const struct session *s, const char *what, struct error *error);

/* Discards the answers that were kept, because the site or its parameters have
 * changed. */
void session_remove_answers(struct session *s);

/* Prints the faults of a file to notes, in order, except for the last, which
 * becomes the error.  If reading was interrupted, says only that.  Returns
 * false. */
bool session_report_file_faults(const struct session *s, const char *path,
    const struct error_list *errors, struct error *error);

/* Returns true if the user wants the running command to stop.  What asks this
 * and then gives up leaves an answer that is not shown. */
bool session_is_interrupted(const struct session *s);

/* Prints an answer in the format that is set, and keeps it, unless it was cut
 * short.  Returns true, so that a command can end with this. */
bool session_show_answer(struct session *s, struct answer *answer);

/* Takes ownership of an answer and keeps it as the newest of its command.  One
 * without fields is freed, because nothing could be read from it. */
void session_store_newest_answer(struct session *s, struct answer *answer);

/* Returns the number in a field (see answer_find_json_number) of the newest
 * answer that has this field and is from one of the commands, which are
 * separated by spaces; NAN if there is none. */
double session_number_in_last_answer(
    const struct session *s, const char *commands, const char *path);

/* Returns the text in a field of the newest answer of a command that has it,
 * borrowed, or NULL. */
const char *session_text_in_last_answer(
    const struct session *s, const char *command, const char *path);

/* Switches translation on, or off if results are for programs.  Call it after
 * each change of the results' format. */
void session_set_translation_by_format(const struct session *s);

/* Returns the width that text for people is wrapped to: the usual one, or that
 * of a narrower screen. */
enum { SESSION_TEXT_WIDTH = 78 };
int session_text_width(const struct session *s);

/* Prints a line to notes. */
void session_print_note(const struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* True if a job is in progress and not paused. */
bool session_is_calibrating(const struct session *s);

/* Returns the site that will get the fit of the calibration in progress, or
 * NULL. */
const struct entry *session_entry_being_fitted(const struct session *s);

/* Returns the time of a monotonic clock, s. */
double session_clock_seconds(void);

/* Returns the label of a site for people: "Tierp, Granite, 11.2 mm".  The
 * caller frees it. */
char *session_site_label(const struct site *site);

/* Returns "69, 79 (2 runs)": the speeds of the runs that have a product and
 * whose mark [n_run] equals `marked`; of all that have one if mark is NULL.
 * between: the separator.  The caller frees it. */
char *session_speeds_of_runs_text(const struct site *site, const char *between,
    const bool *mark, bool marked);

/* Return these speeds in rpm: "1569, 1796" or, to follow m/s in a sentence, "
 * (1569, 1796 rpm)"; "" unless the site states its rotor.  The caller frees
 * them. */
char *session_rpm_of_runs_text(const struct site *site, const char *between,
    const bool *mark, bool marked);
char *session_rpm_of_runs_in_brackets(
    const struct site *site, const bool *mark, bool marked);

#endif
