/* Errors: what went wrong, where, and what to do next.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_ERROR_H
#define TIPSPEED_BASE_ERROR_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The kinds are the program's exit codes; see tipspeed(1), EXIT STATUS. */
enum error_kind {
	ERROR_NONE = 0,
	ERROR_CHECK = 1,   /* a check found a fault, or an assertion failed */
	ERROR_USAGE = 2,   /* a command that cannot be understood */
	ERROR_DATA = 3,    /* a file whose contents are wrong */
	ERROR_NUMERIC = 4, /* a computation without a result */
	ERROR_SYSTEM = 5,  /* a file or resource the system refused */
	/* The user interrupted the program.  130 is the status after SIGINT;
	 * after another signal, the driver returns that signal's status. */
	ERROR_STOPPED = 130
};

/* The file name of a line typed at a prompt.  The user can see the line, so its
 * errors are shown without a position. */
#define ERROR_TYPED "typed"

/* A plain value, with nothing to free.  line and column count from 1; 0: not
 * known.  in_grid: the position is a cell of a workbook, shown as B5.  text:
 * what was expected and what was found; hint: the next step, or "". */
struct error {
	enum error_kind kind;
	int line, column;
	bool in_grid;
	char file[240];
	char text[512];
	char hint[512];
};

/* Several faults of one file, in the order found; those after the first 20 are
 * only counted, in `more`.  stop: returns true if reading should end because
 * the user interrupted it; NULL: reading never ends early.  stopped: stop
 * returned true. */
struct error_list {
	size_t n, more;
	bool (*stop)(void);
	bool stopped;
	struct error item[20];
};

/* Sets e, if not NULL.  The first line of the format is the text, the rest is
 * the hint: "no site '%s' is loaded\nload its file".  Always returns false, so
 * that a function can end with return error_set(...). */
bool error_set(struct error *e, enum error_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* As error_set, with a position in a file.  line 0: not known. */
bool error_set_at(struct error *e, enum error_kind kind, const char *file,
    int line, int column, const char *format, ...)
    __attribute__((format(printf, 6, 7)));

bool error_set_formatted(struct error *e, enum error_kind kind,
    const char *file, int line, int column, const char *format, va_list ap)
    __attribute__((format(printf, 6, 0)));

/* Changes the position of an error already set. */
void error_set_place(struct error *e, const char *file, int line, int column);

/* As error_set_place, for an error about a whole file: puts the file's name
 * before the text and sets the position in the script. */
void error_prefix_file_name(
    struct error *e, const char *file, int line, int column);

/* Changes the hint of an error already set.  Returns false. */
bool error_set_hint(struct error *e, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a fault to the list, or counts it if the list is full.  Returns the
 * error to fill in, never NULL. */
struct error *error_list_add_item(struct error_list *list);

/* True if reading should end.  Each loop over the contents of a file calls it
 * now and then.  Once true it stays true, and the list contains a fault of kind
 * ERROR_STOPPED. */
bool error_is_stop_requested(struct error_list *list);

/* Prints "file:line:column: text", or for a workbook "file, B5: text", and the
 * hint, if any, below it.  Always wraps the hint, with a margin; wraps the
 * text, which programs may read, only on a terminal. */
void error_print(const struct error *e, FILE *out);

void error_print_hint(const struct error *e, FILE *out);

#endif
