/* The signals that the program handles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_SIGNALS_H
#define TIPSPEED_CLI_SIGNALS_H

#include <signal.h>
#include <stdbool.h>

/* From now on SIGINT, SIGTERM and SIGHUP are recorded, and SIGUSR1 makes a
 * calibration print a line about its progress. */
void signals_catch(void);

/* signals_block blocks the signals handled at a terminal, so they arrive only
 * where a loop waits; signals_unblock unblocks them. */
void signals_block(void);
void signals_unblock(void);

/* Waits for input.  Returns false on a signal or after that many seconds
 * (INFINITY: never). */
bool signals_wait_for_input(double seconds);

/* As signals_wait_for_input, with the signal mask to use while waiting. */
bool signals_wait_for_input_with_mask(const sigset_t *mask, double seconds);

/* Lets blocked signals arrive now. */
void signals_deliver_blocked(void);

/* Between signals_catch_terminal and signals_uncatch_terminal, ^Z, the return
 * from it and a change of the terminal's size are recorded.
 * signals_take_terminal_events returns those since its last call, as these
 * bits. */
enum { SIGNALS_STOP = 1, SIGNALS_WAKE = 2, SIGNALS_SIZE = 4 };
void signals_catch_terminal(struct sigaction was[static 3]);
void signals_uncatch_terminal(const struct sigaction was[static 3]);
int signals_take_terminal_events(void);

/* If `note`, ^Z is recorded, as by signals_catch_terminal; otherwise it stops
 * the program and its child processes. */
void signals_set_suspend_handler(bool note);

/* Stops the program, as ^Z does by default, and returns when it continues.  The
 * caller restores the terminal. */
void signals_suspend_program(void);

/* Returns the recorded signal, or 0; others take precedence over SIGINT. */
int signals_get_ending_or_interrupt(void);

/* True if the terminal or the system has asked the program to end. */
bool signals_is_end_wanted(void);

/* Clears a SIGINT that has been handled. */
void signals_clear_interrupt(void);

/* Returns the exit status that shells give a program ended by the recorded
 * signal, or 0. */
int signals_exit_status(void);

/* True if SIGUSR1 has arrived since the last call. */
bool signals_usr1_since_last_call(void);

/* For hooks.stop, from any thread: true if a signal has arrived or is blocked
 * or, after signals_set_stop_on_key(true), a key was pressed. */
bool signals_is_stop_wanted(void);
void signals_set_stop_on_key(bool keys);

#endif
