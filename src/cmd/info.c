/* Help is the table, printed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/info.h"

#include <gsl/gsl_version.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "config.h"
#include "core/isa.h"

void
info_list(FILE *out)
{
	const char *group = "";
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		if (strcmp(group, c->group) != 0)
			fprintf(out, "%s\n", c->group);
		group = c->group;
		char *name = c->alias != NULL
				 ? xasprintf("%s, %s", c->name, c->alias)
				 : xstrdup(c->name);
		fprintf(out, "  %-16s %s\n", name, c->brief);
		free(name);
	}
	fputs("help COMMAND tells more; the manual is tipspeed(1)\n", out);
}

static void
print_option(const struct command_option *o, FILE *out)
{
	char *limits = command_limits(o);
	char *text = xasprintf("%s (%s)%s%s", o->brief, limits,
	    o->fallback[0] != '\0' ? ", default " : "", o->fallback);
	fprintf(out, "  %s\n", o->name);
	text_wrap(text, 6, 78, out);
	free(text);
	free(limits);
}

void
info_command(const struct command *c, FILE *out)
{
	char *usage = command_usage(c);
	fprintf(out, "%s - %s\n\n  %s\n", c->name, c->brief, usage);
	free(usage);
	if (c->alias != NULL)
		fprintf(out, "  also called %s\n", c->alias);
	fputc('\n', out);
	text_wrap(c->text, 2, 78, out);
	if (c->option != NULL)
		fputs("\noptions\n", out);
	for (const struct command_option *o = c->option;
	     o != NULL && o->name != NULL; o++)
		print_option(o, out);
	fputs("\nexample\n", out);
	char *copy = xstrdup(c->example), *save = NULL;
	for (char *line = strtok_r(copy, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save))
		fprintf(out, "  %s\n", line);
	free(copy);
}

/* Help is words for people: among JSON or CSV it goes beside the results. */
static FILE *
help_stream(const struct session *s)
{
	bool words = s->format == REPORT_TABLE || s->format == REPORT_MARKDOWN;
	return words || s->notes == NULL ? s->out : s->notes;
}

bool
cmd_help(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0) {
		info_list(help_stream(s));
		return true;
	}
	const char *name = args->operand[0];
	const struct command *command = command_find(name);
	if (command != NULL) {
		info_command(command, help_stream(s));
		return true;
	}
	const char *near = command_nearest(name);
	error_set(error, ERROR_USAGE, "there is no command '%s'", name);
	if (near != NULL)
		error_hint(error, "did you mean '%s'?", near);
	return false;
}

bool
cmd_version(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct report *r = report_new("version");
	const char *rows[][2] = {{"tipspeed", PACKAGE_VERSION},
	    {"gsl", GSL_VERSION}, {"jansson", JANSSON_VERSION},
	    {"instructions", isa_name(isa_usable(ISA_BEST))}};
	report_column(r, "part", "part");
	report_column(r, "version", "version");
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		report_text(r, rows[i][0]);
		report_text(r, rows[i][1]);
	}
	json_t *o = json_object();
	json_object_set_new(o, "command", json_string("version"));
	json_object_set_new(o, "version", json_string(PACKAGE_VERSION));
	report_json(r, o);
	session_report(s, r);
	return true;
}

bool
cmd_quit(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	s->quit = true;
	return true;
}
