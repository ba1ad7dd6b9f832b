/* Puts the terminal right on every way out of the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_RESCUE_H
#define TIPSPEED_UI_RESCUE_H

/* Notes how the terminal is set, before the screen is opened. */
void rescue_note(void);

/* Writes down what puts the terminal right, from what ncurses knows of it, and
 * from now on does so when a fault or a failed check ends the program (SEGV,
 * BUS, FPE, ILL, ABRT), or memory runs out.  SIGTERM, SIGHUP and SIGINT leave
 * by the usual way. */
void rescue_prepare(void);

/* The screen has been closed. */
void rescue_done(void);

/* Mends a terminal that a killed program left behind; for --reset-tty. */
void rescue_reset(void);

#endif
