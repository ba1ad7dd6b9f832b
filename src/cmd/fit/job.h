/* The calibration in progress, for its driver and for other commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_JOB_H
#define TIPSPEED_CMD_FIT_JOB_H

#include "cmd/session/session.h"

/* A task: a site, its training runs, its calibration.  stop: returns true if
 * the user is waiting; may be NULL. */
struct job_task {
	size_t entry;
	bool *train;
	struct calibration *calibration;
	bool (*stop)(void);
};

/* What a job does, task by task. */
struct job_type {
	/* Prepares the first or the next task: job.entry, and job.train for
	 * that site; without it, nothing is calibrated, and `follow` is all of
	 * the task.  Returns false if none is left. */
	bool (*next)(struct session *s);
	/* Called after the task's calibration, to compute further results in
	 * steps; returns true when done.  NULL: there are none. */
	bool (*draw)(struct session *s);
	/* Keeps the task's result: called when `draw` is done or the job was
	 * stopped. */
	void (*take)(struct session *s);
	/* Called after the last task or ^C: answers, and takes ownership of
	 * `of`. */
	void (*end)(struct session *s, void *of);
	void (*drop)(void *of); /* frees `of`, or NULL, without an answer */
	bool alone;             /* a single calibration, which can be resumed */
	/* Returns the name of the current task, "tierp without 74 m/s", which
	 * the caller frees.  NULL: each task fits its own site and can be
	 * watched. */
	char *(*task_words)(const struct session *s);
	/* The message if a stopped job's results are useless; NULL: they are
	 * useful. */
	const char *useless;
	/* Returns further results of a task's finished calibration, or NULL if
	 * stopped.  `take` finds them in job.found, which owns them; `drop`
	 * frees them.  Parallel tasks call this in their threads, so it must
	 * not change the session.  NULL: there are none. */
	void *(*follow)(const struct session *s, const struct job_task *task);
};

/* Returns the options of a plain `calibrate` in this session. */
struct calibrate_options job_default_options(const struct session *s);

/* Starts a job in which type, of, options, pause_at and, for a single task,
 * train and run_weight are set.  Takes ownership of the members.  Returns false
 * if there is no task. */
bool job_start(struct session *s, const struct job *job);

/* Marks in train [n_run] the runs with a product that their feed covers: all,
 * or those at the slowest and fastest speeds.  Returns their number. */
size_t job_mark_training_runs(const struct site *site, bool all, bool *train);

/* Returns the number of speeds with a product that the feed covers.  Holding
 * out each in turn needs JOB_FOR_EACH, which leaves at least two. */
enum { JOB_FOR_EACH = 3 };
size_t job_count_usable_speeds(const struct site *site);

/* Advances `speed` to the next of these speeds (0: before the first) and marks
 * the runs at all others in train.  Returns false if none is left. */
bool job_hold_out_next_speed(
    const struct site *site, double *speed, bool *train);

/* Runs one step of the job; prints the result and ends the job when it is
 * done. */
void session_step_job(struct session *s);

/* As session_step_job, for drivers that need not respond meanwhile: runs
 * several independent tasks to their ends in parallel. */
void session_run_parallel_tasks(struct session *s);

/* For a command that runs others: runs the job, if any, until it is over or
 * the user stops it. */
void session_run_job_to_end(struct session *s);

/* Discards a stopped calibration and says so. */
void session_discard_paused_job(struct session *s);

/* Stops the job for the user; `continue` can resume it.  The best result so far
 * becomes the site's fit, unless the site's parameters fit better: these are
 * then kept, and `accept` takes the result.  A job without a generation, or
 * useless when stopped, gives no result. */
enum stopped { STOPPED_EMPTY, STOPPED_TAKEN, STOPPED_WORSE };
enum stopped session_stop_job_for_user(struct session *s);

/* Ends the job and discards its results. */
void session_abort_job(struct session *s);

#endif
