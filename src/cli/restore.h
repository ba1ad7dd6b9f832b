/* Restores the terminal however the full screen or the prompt ends.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_RESTORE_H
#define TIPSPEED_CLI_RESTORE_H

/* Records the terminal's settings before the screen is opened. */
void terminal_record_settings(void);

/* Prepares the bytes that restore the terminal, from what ncurses knows about
 * it.  From now on, these are written if a fault, a failed assertion, an
 * uncaught signal (SEGV, ABRT, QUIT, ..) or lack of memory ends the program.
 * SIGTERM, SIGHUP and SIGINT end it in the usual way. */
void restore_arm_tty_for_screen(void);

/* As restore_arm_tty_for_screen, but for the time in which readline controls
 * the terminal: restores the settings that the terminal has now, and writes
 * `bytes`. */
void restore_arm_tty_for_prompt(const char *bytes);

/* Called when the terminal need not be restored any more, because the screen
 * has been closed or the prompt has its line. */
void restore_disarm_tty(void);

/* Restores a terminal after a program was killed; for --reset-tty. */
void restore_reset_terminal(void);

#endif
