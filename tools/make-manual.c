/* Run by the build: prints what is made from the tables.
 *   commands, environment, status: parts of tipspeed(1)
 *   models, trust: parts of tipspeed-model(7)
 *   keys: part of tipspeed-tui(1)
 *   bash: completion for bash
 *   texts: the texts to translate
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/lang/command.h"
#include "cmd/lang/usage.h"
#include "core/model/breakage.h"
#include "tui/keys.h"

/* Prints a paragraph: each sentence begins a line, as mdoc requires, lines are
 * short, and no word is taken for a roff request. */
static void
print_mdoc_paragraph(const char *text, FILE *out)
{
	size_t column = 0;
	char *copy = xstrdup(text), *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save)) {
		size_t n = strlen(word);
		if (column > 0 && column + 1 + n > 76) {
			fputc('\n', out);
			column = 0;
		}
		if (column > 0)
			column += (size_t)fprintf(out, " ");
		else if (*word == '.' || *word == '\'')
			fputs("\\&", out);
		for (const char *p = word; *p != '\0'; p++)
			fputs(*p == '\\' ? "\\e" : (char[2]){*p, '\0'}, out);
		column += n;
		if (word[n - 1] == '.') {
			fputc('\n', out);
			column = 0;
		}
	}
	if (column > 0)
		fputc('\n', out);
	free(copy);
}

/* Prints "list the loaded sites" as a sentence. */
static void
print_brief_as_sentence(const struct command *c, FILE *out)
{
	FREED char *line = xasprintf(
	    "%c%s.", toupper((unsigned char)c->brief[0]), c->brief + 1);
	print_mdoc_paragraph(line, out);
}

static void
print_mdoc_option(const struct command_option *o, FILE *out)
{
	FREED char *words = command_option_help_text(o);
	fprintf(out, ".It Cm %s\n", o->name);
	print_mdoc_paragraph(words, out);
}

static void
print_command_options(const struct command *c, FILE *out)
{
	const struct command_option *o = command_own_option_at(c, 0);
	FREED char *shared = command_shared_option_names(c);
	if (shared[0] != '\0') {
		FREED char *line =
		    xasprintf("Also takes %s (see above).", shared);
		print_mdoc_paragraph(line, out);
	}
	if (o == NULL)
		return;
	fputs(".Bl -tag -width 12n -compact\n", out);
	for (size_t i = 0; (o = command_own_option_at(c, i)) != NULL; i++)
		print_mdoc_option(o, out);
	fputs(".El\n", out);
}

static void
print_shared_options(FILE *out)
{
	const struct command_option *o;
	fputs(".Ss Options of many commands\n"
	      ".Bl -tag -width 12n -compact\n",
	    out);
	for (size_t i = 0; (o = command_shared_option_at(i)) != NULL; i++)
		print_mdoc_option(o, out);
	fputs(".El\n", out);
}

static void
print_group_heading(const char *group, FILE *out)
{
	fprintf(out, "%c%s\n", toupper((unsigned char)group[0]), group + 1);
}

/* Prints the groups, each with its commands. */
static void
print_groups_with_commands(FILE *out)
{
	const char *group = "";
	FREED char *names = xstrdup("");
	fputs(".Bl -tag -width calibration -compact\n", out);
	for (const struct command *c = command_next(NULL); c != NULL;) {
		if (strcmp(group, command_group_name(c)) != 0) {
			group = command_group_name(c);
			fputs(".It Sx ", out);
			print_group_heading(group, out);
		}
		xappend_to_list(&names, ", ", "%s", command_shown_name(c));
		c = command_next(c);
		if (c != NULL && strcmp(group, command_group_name(c)) == 0)
			continue;
		print_mdoc_paragraph(names, out);
		names[0] = '\0';
	}
	fputs(".El\n", out);
}

static void
print_commands(FILE *out)
{
	const char *group = "";
	print_groups_with_commands(out);
	print_shared_options(out);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const char *its = command_group_name(c);
		if (strcmp(group, its) != 0) {
			if (group[0] != '\0')
				fputs(".El\n", out);
			fputs(".Ss ", out);
			print_group_heading(its, out);
			fputs(".Bl -tag -width Ds\n", out);
		}
		group = its;
		FREED char *usage = command_usage_text(c);
		/* Quoted, so that mdoc takes no word for a macro. */
		FREED char *quoted = text_add_quotes(usage);
		fprintf(out, ".It %s\n", quoted);
		if (c->alias != NULL)
			fprintf(out, "Also called\n.Cm %s .\n",
			    command_other_name(c));
		print_brief_as_sentence(c, out);
		print_mdoc_paragraph(c->text, out);
		print_mdoc_paragraph(c->more != NULL ? c->more : "", out);
		print_command_options(c, out);
		fputs(".Bd -literal -offset indent\n", out);
		usage_print_example(c, "tipspeed> ", out);
		fputs(".Ed\n", out);
	}
	fputs(".El\n", out);
}

static void
print_environment(FILE *out)
{
	const struct usage_word *w = USAGE_ENVIRONMENT;
	for (; w->name != NULL; w++) {
		fprintf(out, ".It Ev %s\n", w->name);
		print_mdoc_paragraph(w->meaning, out);
	}
}

static void
print_mdoc_items(const struct usage_word *word, FILE *out)
{
	for (; word->name != NULL; word++) {
		fprintf(out, ".It %s\n", word->name);
		print_mdoc_paragraph(word->meaning, out);
	}
}

static void
print_exit_status(FILE *out)
{
	print_mdoc_items(USAGE_STATUS, out);
}

static void
print_trust_lights(FILE *out)
{
	print_mdoc_items(USAGE_TRUST, out);
}

static void
print_models(FILE *out)
{
	for (size_t m = 0; m < breakage_count_models(); m++) {
		const struct breakage *of = BREAKAGES[m];
		fprintf(out, ".It Cm %s\n", of->name);
		print_mdoc_paragraph(of->brief, out);
		if (m > 0 && of->bypass)
			continue;
		fputs(".Bl -tag -width q_slope -compact\n", out);
		for (size_t j = 0; j < of->n; j++) {
			const struct param_info *p = &of->parameter[j];
			fprintf(out, ".It Li %s\n%s; ", p->name, p->meaning);
			if (j == of->reference)
				fputs("fixed", out);
			else
				fprintf(out, "%g to %g", p->lower, p->upper);
			fprintf(out, "%s%s\n", p->unit[0] != '-' ? " " : "",
			    p->unit[0] != '-' ? p->unit : "");
		}
		fputs(".El\n", out);
	}
}

static void
print_bash_commands(FILE *out)
{
	fputs("	-c)\n		words='", out);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const char *alias = c->alias != NULL ? c->alias : "";
		fprintf(out, "%s%s%s%.*s",
		    c == command_next(NULL) ? "" : "\n			",
		    c->name, alias[0] != '\0' ? " " : "",
		    (int)strcspn(alias, " "), alias);
	}
	fputs("'\n		;;\n", out);
}

/* Prints the candidates for an option's argument: words, files, or none. */
static void
print_bash_argument(const struct usage_option *o, FILE *out)
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
print_bash_options(FILE *out)
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

static void
print_bash_completion(FILE *out)
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
	print_bash_commands(out);
	for (const struct usage_option *o = USAGE_OPTIONS; o->code != 0; o++)
		if (o->argument != NULL && o->code != 'c')
			print_bash_argument(o, out);
	print_bash_options(out);
	fputs("	esac\n"
	      "	mapfile -t COMPREPLY < \\\n"
	      "		<(compgen -W \"$words\" -- \"$cur\")\n"
	      "	[[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace\n"
	      "} &&\n"
	      "	complete -F _tipspeed tipspeed\n",
	    out);
}

/* Prints a text for xgettext, as one that is not a format even if it has a per
 * cent sign. */
static void
print_text_for_xgettext(const char *text, FILE *out)
{
	if (text == NULL || text[0] == '\0')
		return;
	fputs("/* xgettext:no-c-format */\nN_(\"", out);
	for (const char *p = text; *p != '\0'; p++)
		fprintf(out, strchr("\"\\", *p) != NULL ? "\\%c" : "%c", *p);
	fputs("\");\n", out);
}

static void
print_meanings_for_translators(const struct usage_word *word, FILE *out)
{
	for (; word->name != NULL; word++)
		print_text_for_xgettext(word->meaning, out);
}

static void
print_table_texts_for_xgettext(FILE *out)
{
	const struct command_option *o;
	for (const struct usage_option *u = USAGE_OPTIONS; u->code != 0; u++)
		print_text_for_xgettext(u->brief, out);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		print_text_for_xgettext(c->brief, out);
		print_text_for_xgettext(c->text, out);
		for (size_t i = 0; (o = command_option_at(c, i)) != NULL; i++)
			print_text_for_xgettext(o->brief, out);
	}
	print_meanings_for_translators(USAGE_ENVIRONMENT, out);
	print_meanings_for_translators(USAGE_STATUS, out);
	print_meanings_for_translators(USAGE_TRUST, out);
}

static void
print_texts(FILE *out)
{
	print_table_texts_for_xgettext(out);
	keys_print_for_translators(print_text_for_xgettext, out);
}

static const struct {
	const char *name;
	void (*print)(FILE *out);
} PARTS[] = {{"commands", print_commands}, {"environment", print_environment},
    {"status", print_exit_status}, {"trust", print_trust_lights},
    {"models", print_models}, {"bash", print_bash_completion},
    {"keys", keys_print_manual}, {"texts", print_texts}};

int
main(int argc, char **argv)
{
	for (size_t i = 0; i < sizeof PARTS / sizeof PARTS[0]; i++) {
		if (argc != 2 || strcmp(argv[1], PARTS[i].name) != 0)
			continue;
		PARTS[i].print(stdout);
		return fflush(stdout) != 0 || ferror(stdout);
	}
	fputs("usage: make-manual commands|environment|status|trust|models|"
	      "bash|keys|texts\n",
	    stderr);
	return 2;
}
