/* The command table as mdoc.  Run at build time by tools/make-manual.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/manual.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/command.h"

/* Text of a paragraph: a new sentence on a new line, as mdoc wants it, and
 * nothing that roff would take for a request. */
static void
print_text(const char *text, FILE *out)
{
	bool start = true;
	for (const char *p = text; *p != '\0'; p++) {
		if (start && (*p == '.' || *p == '\''))
			fputs("\\&", out);
		start = false;
		if (*p == '\\')
			fputs("\\e", out);
		else if (p > text && p[0] == ' ' && p[-1] == '.') {
			fputc('\n', out);
			start = true;
		} else {
			fputc(*p, out);
		}
	}
	fputc('\n', out);
}

/* A word as an argument of a macro: quoted, so that no letter acts. */
static void
print_quoted(const char *text, FILE *out)
{
	fputc('"', out);
	for (const char *p = text; *p != '\0'; p++)
		fputs(*p == '"' ? "\"\"" : (char[2]){*p, '\0'}, out);
	fputc('"', out);
}

static void
print_options(const struct command *c, FILE *out)
{
	if (c->option == NULL)
		return;
	fputs(".Bl -tag -width 12n -compact\n", out);
	for (const struct command_option *o = c->option; o->name != NULL; o++) {
		fprintf(out, ".It Cm %s\n", o->name);
		char *limits =
		    o->kind == VALUE_CHOICE ? xstrdup(o->choices)
		    : o->kind == VALUE_TEXT
			? xstrdup("text")
			: xasprintf("%g to %g%s%s", o->least, o->most,
			      o->unit[0] != '\0' ? " " : "", o->unit);
		char *line = xasprintf("%s (%s)%s%s", o->brief, limits,
		    o->fallback[0] != '\0' ? ", default " : "", o->fallback);
		print_text(line, out);
		free(limits);
		free(line);
	}
	fputs(".El\n", out);
}

static void
print_example(const struct command *c, FILE *out)
{
	fputs(".Bd -literal -offset indent\n", out);
	char *copy = xstrdup(c->example), *save = NULL;
	for (char *line = strtok_r(copy, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save))
		fprintf(out, "tipspeed> %s\n", line);
	free(copy);
	fputs(".Ed\n", out);
}

void
manual_commands(FILE *out)
{
	const char *group = "";
	for (const struct command *c = COMMANDS; c->name != NULL; c++) {
		if (strcmp(group, c->group) != 0) {
			if (group[0] != '\0')
				fputs(".El\n", out);
			fprintf(out, ".Ss %c%s\n.Bl -tag -width Ds\n",
			    toupper((unsigned char)c->group[0]), c->group + 1);
		}
		group = c->group;
		char *usage = command_usage(c);
		fputs(".It ", out);
		print_quoted(usage, out);
		fputc('\n', out);
		free(usage);
		if (c->alias != NULL)
			fprintf(out, "Also called\n.Cm %s .\n", c->alias);
		print_text(c->text, out);
		print_options(c, out);
		print_example(c, out);
	}
	fputs(".El\n", out);
}
