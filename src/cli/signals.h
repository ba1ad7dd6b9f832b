/* The signals that the program answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_SIGNALS_H
#define TIPSPEED_CLI_SIGNALS_H

#include <signal.h>
#include <stdbool.h>

/* From now on SIGINT, SIGTERM and SIGHUP are noted, and SIGUSR1 asks a
 * calibration for a line about itself. */
void signals_catch(void);

/* Blocks the signals that are answered at a terminal: they come in only where a
 * loop waits; and lets all in again. */
void signals_hold(void);
void signals_release(void);

/* Waits until there is something to read; false when a signal came, or after so
 * many seconds (INFINITY: never). */
bool signals_wait(double seconds);

/* The same while other signals are let in. */
bool signals_wait_with(const sigset_t *mask, double seconds);

/* Lets in those that are held. */
void signals_let_in(void);

/* While one has the terminal, ^Z, a continue and another size are noted for
 * signals_news, which returns as these bits what came since it was last
 * asked. */
enum { SIGNALS_STOP = 1, SIGNALS_WAKE = 2, SIGNALS_SIZE = 4 };
void signals_take_terminal(struct sigaction was[static 3]);
void signals_give_terminal(const struct sigaction was[static 3]);
int signals_news(void);

/* Whether ^Z is noted meanwhile, or stops the program with all that it runs. */
void signals_note_stop(bool note);

/* Stops the program as ^Z does where it is not caught, and comes back when it
 * goes on; the terminal is the caller's. */
void signals_suspend(void);

/* The signal noted, or 0.  SIGINT gives way to the others. */
int signals_noted(void);

/* True when the terminal or the system wants the program gone. */
bool signals_ended(void);

/* A SIGINT has been answered. */
void signals_forget_interrupt(void);

/* The exit status of a program that the noted signal ended, as shells count
 * it; 0 without one. */
int signals_status(void);

/* Whether SIGUSR1 came since this was last asked. */
bool signals_asked(void);

/* For session.stop, from any thread: a signal came or is held back; or, while
 * `keys` was the last that signals_watch_keys was told, a key was pressed. */
bool signals_waited_for(void);
void signals_watch_keys(bool keys);

#endif
