/* Restores the terminal on every way out of the full screen and the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_RESTORE_H
#define TIPSPEED_CLI_RESTORE_H

/* Records the settings of the terminal, before the screen is opened. */
void restore_keep_settings(void);

/* Prepares the bytes that restore the terminal, from what ncurses knows of it,
 * and from now on writes them when a fault, a failed check or a signal that is
 * not caught ends the program (SEGV, ABRT, QUIT, ..), or memory runs out.
 * SIGTERM, SIGHUP and SIGINT end the program in the usual way. */
void restore_screen(void);

/* As restore_screen, but while readline has the terminal, to restore its
 * present settings.  bytes: also written then. */
void restore_prompt(const char *bytes);

/* The terminal need not be restored any longer: called when the screen has been
 * closed, or the prompt has its line. */
void restore_done(void);

/* Restores a terminal that a killed program left behind; for --reset-tty. */
void restore_reset(void);

#endif
