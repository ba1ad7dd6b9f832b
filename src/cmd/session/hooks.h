/* What commands ask of the driver.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_HOOKS_H
#define TIPSPEED_CMD_SESSION_HOOKS_H

#include <stdbool.h>

struct canvas;
struct error;
struct inquiry;
struct screen_request;
struct session;

struct hooks {
	/* Clears progress off the line for a note or an answer; NULL: there is
	 * none. */
	void (*tidy)(void);
	bool (*stop)(void); /* whether a long computation should end, as the
			       user waits; NULL: never */
	/* Called before a computation that takes a moment, with a few words
	 * for the user; NULL if not interactive. */
	void (*begins)(const char *what);
	bool (*show_page)(const char *page); /* shows a page of the manual; NULL
						where there is no terminal */
	/* Draws the full screen, see plot.h; NULL: there is none. */
	struct canvas *(*draw_screen)(
	    struct session *, struct screen_request *, struct error *);
	/* Runs the full screen until the user quits; returns an exit status.
	 * NULL: it is not available. */
	int (*run_screen)(struct session *);
	/* Asks the user yes or no; NULL if not interactive. */
	bool (*confirm)(struct session *s, const char *question);
	/* Asks the user for a line about a sheet.  The caller frees it; NULL
	 * when the user gives up.  NULL if not interactive. */
	char *(*question)(struct session *s, const struct inquiry *inquiry);
};

#endif
