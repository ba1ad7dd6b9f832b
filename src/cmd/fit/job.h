/* The calibration under way, as its driver and other commands see it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_JOB_H
#define TIPSPEED_CMD_FIT_JOB_H

#include "cmd/session/session.h"

/* A round: a site, the runs it is trained on, its calibration; stop: whether
 * somebody waits, or NULL. */
struct round {
	size_t entry;
	const bool *train;
	struct calibration *calibration;
	bool (*stop)(void);
};

/* What a job calibrates, round by round. */
struct rounds {
	/* The first round, or the one after: job.entry, and job.train for that
	 * site.  False where there is none left. */
	bool (*next)(struct session *s);
	/* The round's calibration has ended: works out a part of what follows
	 * from it; true when there is no more.  NULL: nothing does. */
	bool (*draw)(struct session *s);
	/* That is done. */
	void (*take)(struct session *s);
	/* Called after the last round or ^C: answers, and owns `of`. */
	void (*end)(struct session *s, void *of);
	void (*drop)(void *of); /* without an answer; `of` or NULL */
	bool alone; /* one calibration, to be continued when stopped */
	/* What it is at, which the caller frees: "tierp without 74 m/s".  NULL:
	 * each is of its site's own fit, and can be watched. */
	char *(*at)(const struct session *s);
	/* What to say of a stopped one, of which nothing is of use; NULL: what
	 * it has found is. */
	const char *useless;
	/* What follows from a round's calibration once it has ended, for take
	 * as job.found, which owns it; such as drop frees.  Rounds side by side
	 * do it there too, so that it changes nothing of the session.  NULL
	 * where it was stopped.  Itself NULL: nothing follows. */
	void *(*follow)(const struct session *s, const struct round *round);
};

/* The options of a plain `calibrate` in this session. */
struct calibrate_options job_options(const struct session *s);

/* Starts a job, of which rounds, of, options, pause_at and, where there is one
 * round, train and run_weight are given; takes what it owns.  False where it
 * has no round. */
bool job_start(struct session *s, const struct job *job);

/* Marks every run with a product that its feed covers (all), or the slowest and
 * the fastest speed, in train [n_run].  Returns how many. */
size_t job_mark(const struct site *site, bool all, bool *train);

/* How many speeds have a product that the feed covers; to hold out each in turn
 * takes so many, as two at least are to be left. */
enum { JOB_FOR_EACH = 3 };
size_t job_speeds(const struct site *site);

/* Moves on to the next of these speeds, 0 being before the first, and marks the
 * runs at the others in train.  False where there is none left. */
bool job_hold_out(const struct site *site, double *speed, bool *train);

/* One step of the job; prints its result and ends it when it is done. */
void session_step(struct session *s);

/* The same for who need not be live meanwhile: several rounds to their ends,
 * side by side, where they do not wait for each other. */
void session_rounds(struct session *s);

/* Discards a calibration that was stopped, and says so. */
void session_let_go(struct session *s);

/* Stops the job for the user, and `continue` goes on from there.  The best so
 * far becomes the site's fit, unless the parameters that the site has fit
 * better: these stay then, and `accept` takes the stopped ones.  Nothing comes
 * of what had no generation yet, or is of no use when stopped. */
enum stopped { STOPPED_EMPTY, STOPPED_TAKEN, STOPPED_WORSE };
enum stopped session_pause(struct session *s);

/* Ends the job, and keeps nothing of it. */
void session_stop(struct session *s);

#endif
