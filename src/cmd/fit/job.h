/* The calibration under way, for its driver and for other commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_JOB_H
#define TIPSPEED_CMD_FIT_JOB_H

#include "cmd/session/session.h"

/* A round: a site, the runs it is trained on, its calibration.  stop: returns
 * true if the user waits, or NULL. */
struct round {
	size_t entry;
	const bool *train;
	struct calibration *calibration;
	bool (*stop)(void);
};

/* What a job calibrates, round by round. */
struct rounds {
	/* Sets up the first round or the next: job.entry, and job.train for
	 * that site.  False where there is none left. */
	bool (*next)(struct session *s);
	/* Called when the round's calibration has ended: computes part of what
	 * follows from it; true when nothing is left to do.  NULL: nothing
	 * follows. */
	bool (*draw)(struct session *s);
	/* Keeps the round's result: called once `draw` is done, or if the job
	 * was stopped. */
	void (*take)(struct session *s);
	/* Called after the last round or ^C: answers, and owns `of`. */
	void (*end)(struct session *s, void *of);
	void (*drop)(void *of); /* without an answer; `of` or NULL */
	bool alone; /* one calibration, to be continued when stopped */
	/* Returns the round under way, which the caller frees: "tierp without
	 * 74 m/s".  NULL: each round is its site's own fit, and can be
	 * watched. */
	char *(*at)(const struct session *s);
	/* What to say of a stopped job whose results are of no use; NULL: they
	 * are of use. */
	const char *useless;
	/* Returns what follows from a round's calibration once it has ended,
	 * for `take` as job.found, which owns it; `drop` frees it.  Rounds run
	 * side by side call it in their threads, so it changes nothing in the
	 * session.  Returns NULL where it was stopped.  A NULL function:
	 * nothing follows. */
	void *(*follow)(const struct session *s, const struct round *round);
};

/* Returns the options of a plain `calibrate` in this session. */
struct calibrate_options job_options(const struct session *s);

/* Starts a job in which rounds, of, options, pause_at and, if there is one
 * round, train and run_weight are set; takes over what it owns.  False if it
 * has no round. */
bool job_start(struct session *s, const struct job *job);

/* Marks in train [n_run] the runs with a product that their feed covers: all,
 * or those at the slowest and the fastest speed.  Returns how many. */
size_t job_mark(const struct site *site, bool all, bool *train);

/* Returns how many speeds have a product that the feed covers.  Holding out
 * each in turn needs JOB_FOR_EACH, so that at least two are left. */
enum { JOB_FOR_EACH = 3 };
size_t job_speeds(const struct site *site);

/* Advances `speed` to the next of these speeds, 0 being before the first, and
 * marks the runs at the others in train.  False if none is left. */
bool job_hold_out(const struct site *site, double *speed, bool *train);

/* Runs one step of the job; prints the result and ends the job when it is
 * done. */
void session_step(struct session *s);

/* As session_step, for drivers that need not respond meanwhile: runs several
 * rounds to their ends, side by side, if they do not depend on each other. */
void session_rounds(struct session *s);

/* Discards a stopped calibration, and says so. */
void session_let_go(struct session *s);

/* Stops the job for the user, so that `continue` can resume it.  The best
 * result so far becomes the site's fit, unless the site's parameters fit
 * better: these stay then, and `accept` takes the stopped ones.  A job without
 * a generation, or of no use when stopped, gives no result. */
enum stopped { STOPPED_EMPTY, STOPPED_TAKEN, STOPPED_WORSE };
enum stopped session_pause(struct session *s);

/* Ends the job, and discards its results. */
void session_stop(struct session *s);

#endif
