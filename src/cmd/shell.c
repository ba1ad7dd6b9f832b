/* The tables as a script for bash.  Run at build time by tools/make-manual.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cmd/command.h"
#include "cmd/manual.h"
#include "cmd/usage.h"

static void
print_commands(FILE *out)
{
	fputs("	-c)\n		words='", out);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		fprintf(out, "%s%s%s%s",
		    c == command_next(NULL) ? "" : "\n			",
		    c->name, c->alias != NULL ? " " : "",
		    c->alias != NULL ? c->alias : "");
	fputs("'\n		;;\n", out);
}

/* What may stand behind an option that takes something: words, files, or what
 * only the user knows. */
static void
print_argument(const struct usage_option *o, FILE *out)
{
	bool file = strcmp(o->argument, "FILE") == 0 ||
		    strcmp(o->argument, "PATH") == 0;
	if (o->name != NULL)
		fprintf(out, "	--%s)\n", o->name);
	else
		fprintf(out, "	-%c)\n", o->code);
	if (o->choices != NULL)
		fprintf(out, "		words='%s'\n", o->choices);
	if (file)
		fputs("		compopt -o default\n", out);
	fputs("		;;\n", out);
}

static void
print_options(FILE *out)
{
	fputs("	*)\n		case $cur in\n		-*)\n"
	      "			words='",
	    out);
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++) {
		if (o->code < 256)
			fprintf(out, "-%c ", o->code);
		if (o->name != NULL)
			fprintf(out, "--%s%s ", o->name,
			    o->argument != NULL ? "=" : "");
	}
	fputs("'\n			;;\n"
	      "		*) compopt -o default ;;\n"
	      "		esac\n		;;\n",
	    out);
}

void
manual_bash(FILE *out)
{
	fputs("# Completion of tipspeed(1) for bash, made from its tables.\n"
	      "_tipspeed() {\n"
	      "	local cur=${COMP_WORDS[COMP_CWORD]} words=\n"
	      "	local prev=${COMP_WORDS[COMP_CWORD - 1]}\n"
	      "	# bash takes the = of --format=csv for a word.\n"
	      "	if [[ $cur == = ]]; then\n"
	      "		cur=\n"
	      "	elif [[ $prev == = ]]; then\n"
	      "		prev=${COMP_WORDS[COMP_CWORD - 2]}\n"
	      "	fi\n"
	      "	cur=${cur#[\\'\\\"]}\n"
	      "	case $prev in\n",
	    out);
	print_commands(out);
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++)
		if (o->argument != NULL && o->code != 'c')
			print_argument(o, out);
	print_options(out);
	fputs("	esac\n"
	      "	mapfile -t COMPREPLY < \\\n"
	      "		<(compgen -W \"$words\" -- \"$cur\")\n"
	      "	[[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace\n"
	      "} &&\n"
	      "	complete -F _tipspeed tipspeed\n",
	    out);
}
