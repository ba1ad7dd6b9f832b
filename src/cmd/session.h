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
#include "core/site.h"
#include "io/report.h"
#include "io/store.h"

/* A loaded site with its answers.  key: how it is called here, "gavle/4".
 * train [site->n_run]: runs to train on, or that were trained on. */
struct entry {
	struct site *site;
	char *key;
	bool *train;
	bool has_params, has_fit;
	struct params params; /* set by hand or found */
	struct fit fit;       /* where the parameters were found */
	char options[400];    /* of the fit, in the words of calibrate */
	char recalled[64];    /* material the parameters are of, or "" */
};

/* The newest answers, for assert: sizes in mm, rmse and holdout in points; NAN
 * before there is one. */
enum answer {
	ANSWER_P20,
	ANSWER_P50,
	ANSWER_P80,
	ANSWER_BREAK,
	ANSWER_SPEED,
	ANSWER_MISFIT,
	ANSWER_RMSE,
	ANSWER_HOLDOUT,      /* the largest of validate's */
	ANSWER_POOR,         /* 1: the calibration is poor */
	ANSWER_EXTRAPOLATED, /* 1: predict was outside the trained speeds */
	ANSWERS
};

/* A calibration under way.  The driver pumps it: session_step until
 * session_busy is false. */
struct job {
	struct calibration *calibration;
	size_t entry;
	double started; /* s, of a clock that only goes forward */
	struct calibrate_options options;
	bool *train;
	bool all;               /* one loaded site after the other */
	bool paused;            /* stopped by ^C; `continue` goes on */
	size_t pause_at;        /* generation to stop after; 0: none */
	struct report *summary; /* of all */
	double *run_weight;     /* [n_run] of the site, or NULL */
	char *checkpoint;       /* file to write when stopped, or NULL */
	FILE *log;              /* every generation as CSV, or NULL */
};

struct session {
	size_t n_entry, current; /* current is meaningful when n_entry > 0 */
	struct entry *entry;
	struct model_settings settings;
	struct bounds bounds;
	uint64_t seed;
	unsigned threads;
	enum isa isa;
	enum report_format format;
	FILE *out;   /* results */
	FILE *notes; /* what is said beside results; NULL: nothing */
	double answer[ANSWERS];
	struct job job;
	struct store *store; /* ":memory:" until another is put here */
	bool quit;
};

struct session *session_new(FILE *out, FILE *notes);
void session_free(struct session *s);

/* The site in use; asserts that there is one. */
struct entry *session_entry(struct session *s);

/* Forgets the newest answers, because the site or its parameters are others
 * now. */
void session_forget(struct session *s);

/* Adds a site, which the session then owns, and makes it the one in use. */
void session_add(struct session *s, struct site *site);

/* Finds a loaded site by name without case and accents ("borlange"), by name
 * and top size ("gavle/4") or by key.  Several or none: an error that lists
 * what there is. */
bool session_find(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Reads a site file and adds it.  Every fault of the file is printed to notes
 * but the last, which is the error. */
bool session_load(struct session *s, const char *path, struct error *error);

/* Prints a result and frees it. */
void session_report(struct session *s, struct report *report);

/* A line beside the results. */
void session_note(const struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Runs the commands of one line.  place names it in errors.  Stops at the first
 * error, and after a command that started a job: then *next is where to go on
 * (an offset into line), otherwise 0. */
bool session_line(struct session *s, const char *line, size_t from,
    const char *file, int number, size_t *next, struct error *error);

bool session_busy(const struct session *s);

/* One step of the job; prints its result and ends it when it is done. */
void session_step(struct session *s);

/* Stops the job for the user: the best so far becomes the site's fit, and
 * `continue` goes on from there. */
void session_pause(struct session *s);

/* Ends the job.  keep: the best so far becomes the site's fit. */
void session_stop(struct session *s, bool keep);

/* Seconds of a clock that only goes forward. */
double session_clock(void);

/* The label of a site for people: "Tierp, Granite, 11.2 mm". */
char *session_label(const struct site *site);

#endif
