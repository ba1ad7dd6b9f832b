/* The calibration in progress, for its driver and for other commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_JOB_H
#define TIPSPEED_CMD_FIT_JOB_H

#include "cmd/session/session.h"

/* A task: a site, its training runs, its calibration.  stop: returns true if
 * the task should end because the user is waiting; may be NULL. */
struct job_task {
	size_t entry;
	bool *train;
	struct calibration *calibration;
	bool (*stop)(void);
};

/* What a job does, one task after the other. */
struct job_type {
	/* Prepares the first or the next task: sets job.entry and, if the task
	 * calibrates that site, job.train.  Otherwise `follow` does all the
	 * work.  Returns false if no task is left. */
	bool (*next)(struct session *s);
	/* Computes further results after the task's calibration, a step a call;
	 * returns true when done.  NULL: there are none. */
	bool (*draw)(struct session *s);
	/* Keeps the task's result.  Called when `draw` is done or when the job
	 * is stopped. */
	void (*take)(struct session *s);
	/* Shows the answer.  Called after the last task or after ^C; takes
	 * ownership of `of`. */
	void (*end)(struct session *s, void *of);
	void (*drop)(void *of); /* frees `of`, which may be NULL; shows no
				 * answer */
	bool alone;             /* the job is one calibration, which can be
				 * continued */
	/* Returns the name of the current task, "tierp without 74 m/s", which
	 * the caller frees.  NULL: each task fits its own site and can be
	 * watched. */
	char *(*task_words)(const struct session *s);
	/* What to tell the user if the results of a stopped job are useless;
	 * NULL if they are useful. */
	const char *useless;
	/* Returns further results of a task's finished calibration, or NULL if
	 * stopped.  `take` finds them in job.found, which owns them; `drop`
	 * frees them.  Parallel tasks call this in their threads, so it must
	 * not change the session.  NULL: there are none. */
	void *(*follow)(const struct session *s, const struct job_task *task);
};

/* Returns the options of a plain `calibrate` in this session. */
struct calibrate_options job_options_from_settings(const struct session *s);

/* Starts a job.  type, of, options, pause_at and, for a single task, train and
 * run_weight must be set.  Takes ownership of the members.  Returns false if
 * the job has no task. */
bool job_start(struct session *s, const struct job *job);

/* Marks training runs in train [n_run]: all runs with a product that their feed
 * covers or, unless `all`, only those at the slowest and the fastest speed.
 * Returns their number. */
size_t job_mark_training_runs(const struct site *site, bool all, bool *train);

/* Returns the number of speeds with a product that the feed covers.  Holding
 * out each in turn needs JOB_FOR_EACH, which leaves at least two. */
enum { JOB_FOR_EACH = 3 };
size_t job_count_trainable_speeds(const struct site *site);

/* Advances `speed` to the next usable speed (0: before the first) and marks the
 * runs at all other speeds in train.  Returns false if no speed is left. */
bool job_hold_out_next_speed(
    const struct site *site, double *speed, bool *train);

/* Runs one step of the job.  When the job is done, shows its result and ends
 * it. */
void session_step_job(struct session *s);

/* As session_step_job, but runs several independent tasks to their ends in
 * parallel, for drivers that need not respond meanwhile. */
void session_run_parallel_tasks(struct session *s);

/* Runs the job, if any, until it is over or the user stops it.  For commands
 * that run other commands. */
void session_run_job_to_end(struct session *s);

/* Discards a stopped calibration and says so. */
void session_discard_paused_job(struct session *s);

/* Stops the job at the user's request.  `continue` can resume a single
 * calibration.  The best result so far becomes the site's fit, unless the
 * site's own parameters fit better: then they stay, and `accept` takes the
 * result.  There is no result before the first generation, or if the type has
 * `useless`. */
enum stopped { STOPPED_EMPTY, STOPPED_TAKEN, STOPPED_WORSE };
enum stopped session_stop_job_for_user(struct session *s);

/* Ends the job and discards its results. */
void session_abort_job(struct session *s);

#endif
