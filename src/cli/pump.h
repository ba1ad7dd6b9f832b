/* Runs the session's job and shows how it goes; what signals ask for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_PUMP_H
#define TIPSPEED_CLI_PUMP_H

#include <signal.h>

#include "cmd/sheets/ask_user.h"

/* From now on SIGINT, SIGTERM and SIGHUP are noted, and SIGUSR1 asks a
 * calibration for a line about itself. */
void pump_catch_signals(void);

/* Blocks the signals that are answered at a terminal: they come in only where a
 * loop waits; and lets all in again. */
void pump_hold_signals(void);
void pump_free_signals(void);

/* Waits until there is something to read; false when a signal came, or after so
 * many seconds (INFINITY: never). */
bool pump_wait(double seconds);

/* Lets in those that are held. */
void pump_let_in(void);

/* While one has the terminal, ^Z, a continue and another size are noted for
 * pump_news, which returns as these bits what came since it was last asked. */
enum { PUMP_STOP = 1, PUMP_WAKE = 2, PUMP_SIZE = 4 };
void pump_take_terminal(struct sigaction was[static 3]);
void pump_give_terminal(const struct sigaction was[static 3]);
int pump_news(void);

/* Whether ^Z is noted meanwhile, or stops the program with all that it runs. */
void pump_note_stop(bool note);

/* Stops the program as ^Z does where it is not caught, and comes back when it
 * goes on; the terminal is the caller's. */
void pump_suspend(void);

/* The signal noted, or 0.  SIGINT gives way to the others. */
int pump_signal(void);

/* True when the terminal or the system wants the program gone. */
bool pump_ended(void);

/* A SIGINT has been answered. */
void pump_forget_interrupt(void);

/* Waits for a line that is typed at the terminal.  A stop, or another size of
 * the terminal, is none.  Returns its first character, or EOF at the end of
 * input or a signal; adds all of it, without its end, to *line (NULL: not
 * wanted). */
int pump_answer(char **line);

/* Asks at the prompt, for session->hooks.confirm and .question; read: asks for
 * a line after such a text, and returns it without its end, which the caller
 * frees, or NULL at the end of input or a signal. */
bool pump_confirm(struct session *s, const char *question);
char *pump_question(struct session *s, const struct inquiry *inquiry);
char *pump_ask(struct session *s, const struct inquiry *inquiry,
    char *(*read)(const char *text));

/* The exit status of a program that the noted signal ended, as shells count
 * it; 0 without one. */
int pump_status(void);

/* For session.stop, from any thread: a signal came or is held back; or, while
 * `keys` was the last that pump_watch was told, a key was pressed. */
bool pump_waited_for(void);
void pump_watch(bool keys);

/* Runs the job to its end.  False when a signal came: then the job is as it
 * was, for session_pause. */
bool pump_run(struct session *s);

#endif
