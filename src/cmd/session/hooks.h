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
	bool (*stop)(void); /* whether the user waits for what takes long to
			       end; NULL: never */
	/* Something that takes a moment begins: in a few words what; NULL:
	 * nobody looks. */
	void (*begins)(const char *what);
	bool (*show_page)(const char *page); /* shows a page of the manual; NULL
						where there is no terminal */
	/* Draws the full screen, see pictures.h; NULL: there is none. */
	struct canvas *(*draw_screen)(
	    struct session *, struct screen_request *, struct error *);
	/* Is the full screen until it is left; returns an exit status.  NULL:
	 * none is opened. */
	int (*run_screen)(struct session *);
	/* Asks somebody who sits there; NULL: nobody does, nothing is asked. */
	bool (*confirm)(struct session *s, const char *question);
	/* Asks somebody for a line about a sheet, which the caller frees; it
	 * returns NULL when given up.  NULL: nobody is there. */
	char *(*question)(struct session *s, const struct inquiry *inquiry);
};

#endif
