/* Holds back the output of a command until it ends, so that a command that
 * fails leaves the file as it was.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/redirect.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/document/html.h"
#include "cmd/document/pdf.h"
#include "cmd/session/journal.h"
#include "config.h"
#include "io/formats/book.h"
#include "io/fs/file.h"
#include "io/formats/answer.h"
#include "plot/picture.h"

enum output_kind {
	OUTPUT_ANSWERS, /* one after the other, in one of ANSWER_FORMATS */
	OUTPUT_BOOK,
	OUTPUT_PICTURE,
	OUTPUT_HTML, /* one document */
	OUTPUT_PDF   /* one document */
};

/* A kind of file that results can go to. */
struct output {
	/* How the file's name ends; NULL: any other name, in the format that is
	 * set. */
	const char *end;
	enum output_kind kind;
	int format; /* of OUTPUT_ANSWERS */
};

static const struct output OUTPUTS[] = {{".csv", OUTPUT_ANSWERS, ANSWER_CSV},
    {".json", OUTPUT_ANSWERS, ANSWER_JSON},
    {".jsonl", OUTPUT_ANSWERS, ANSWER_JSON},
    {".md", OUTPUT_ANSWERS, ANSWER_MARKDOWN}, {".xlsx", OUTPUT_BOOK, 0},
    {".html", OUTPUT_HTML, 0}, {".svg", OUTPUT_PICTURE, 0},
    {".png", OUTPUT_PICTURE, 0}, {".pdf", OUTPUT_PICTURE, 0},
    {".pdf", OUTPUT_PDF, 0}, {NULL, OUTPUT_ANSWERS, -1}};

/* Returns how to write the command's results to the file named in words. */
static const struct output *
find_output_format(const struct command *command, const struct words *words)
{
	bool draws = (command->flags & COMMAND_DRAWS) != 0;
	const struct output *o = OUTPUTS;
	for (; o->end != NULL; o++)
		if (words->to != TO_PIPE &&
		    text_file_ending(words->target, &o->end, 1) == 0 &&
		    (o->kind != OUTPUT_PICTURE || draws))
			break;
	return o;
}

/* Kinds of files that people may want and that are not written, and what is
 * written instead. */
static const struct {
	const char *instead, *ends;
} UNWRITTEN[] = {{".csv", ".tsv"}, {".xlsx", ".ods .xls .xlsb .xlsm"},
    {".html", ".htm .doc .docx .odt"}, {".pdf", ".eps"},
    {".png", ".jpg .jpeg .gif .webp .tif .tiff"}};

/* Returns false with an error for a file of a kind that is not written, with a
 * line that works. */
static bool
check_file_kind_is_written(const struct command *command,
    const struct words *words, struct error *error)
{
	const char *target = words->target, *end = strrchr(target, '.');
	FREED char *folded =
	    text_fold_case_and_accents(end != NULL ? end : target);
	size_t i = 0, which;
	while (i < ARRAY_LEN(UNWRITTEN) &&
	       !text_find_word_in_list(UNWRITTEN[i].ends, folded, &which))
		i++;
	if (end == NULL || i == ARRAY_LEN(UNWRITTEN))
		return true;
	const char *instead = UNWRITTEN[i].instead;
	if (strcmp(instead, ".png") == 0 && !(command->flags & COMMAND_DRAWS))
		instead = ".pdf";
	FREED char *line = xstrdup(command->name);
	for (size_t j = 1; j < words->n; j++)
		journal_append_quoted_word(&line, words->text[j]);
	FREED char *file =
	    xasprintf("%.*s%s", (int)(end - target), target, instead);
	bool more = words->to == TO_APPEND && strcmp(instead, ".csv") == 0;
	xappend(&line, more ? " >>" : " >");
	journal_append_quoted_word(&line, file);
	return error_set(error, ERROR_USAGE,
	    "cannot write %s files, but %s (%s)\nwrite: %s", end, instead,
	    target, line);
}

/* Sets the error for an image from a command that does not draw.  Returns
 * false. */
static bool
set_error_cannot_draw(
    const struct command *command, const char *target, struct error *error)
{
	size_t kind;
	error_set(error, ERROR_USAGE,
	    "%s cannot make an image: %s\nuse predict or plot KIND",
	    command->name, target);
	return text_find_word_in_list(command_find("plot")->operands.expect[0],
		   command->name, &kind) &&
	       error_set_hint(error, "use plot %s > %s", command->name, target);
}

bool
redirect_is_allowed(const struct command *command, const struct words *words,
    struct error *error)
{
	enum picture_form form;
	const char *target = words->target;
	if (words->to == TO_PIPE)
		return true;
	bool image = picture_format_of_file_name(target, &form);
	enum output_kind kind = find_output_format(command, words)->kind;
	if (!check_file_kind_is_written(command, words, error))
		return false;
	if (image && !picture_can_draw_format(form))
		return error_set(error, ERROR_USAGE,
		    "this program draws %s, not %s\n> FILE.%s works",
		    picture_list_formats(), strrchr(target, '.') + 1,
		    kind == OUTPUT_PDF ? tr("html") : "svg");
	if (image && kind == OUTPUT_ANSWERS)
		return set_error_cannot_draw(command, target, error);
	return words->to != TO_APPEND || kind == OUTPUT_ANSWERS ||
	       error_set(error, ERROR_USAGE,
		   "results cannot be appended to this kind of file (%s)\n"
		   "use > with a file for each command, or >> FILE.csv",
		   target);
}

struct redirect {
	enum target to;
	char *target;
	FILE *memory, *out; /* collects results; where they went before */
	char *text;
	size_t n;
	enum answer_format form, before;
	struct screen screen; /* of the session before; likewise rows */
	size_t rows;
	enum output_kind kind;
	struct book *book, *outer_book; /* that collects results; before */
	struct document *document, *outer_document; /* likewise */
	const char *outer_file;
	size_t pages; /* of a document on paper */
	char *line;   /* the command */
};

/* Opens the workbook or document that collects the results, if that is their
 * kind. */
static bool
create_output_book_or_document(
    struct session *s, struct redirect *r, struct error *error)
{
	r->outer_book = s->book;
	r->outer_document = s->document;
	if (r->kind == OUTPUT_BOOK && (r->book = book_new(error)) == NULL)
		return false;
	if (r->kind == OUTPUT_HTML || r->kind == OUTPUT_PDF) {
		FREED char *made_by =
		    xasprintf("tipspeed " PACKAGE_VERSION ": %s", r->line);
		r->document = document_new(made_by);
	}
	s->book = r->book;
	s->document = r->document;
	return true;
}

struct redirect *
redirect_open(struct session *s, const struct command *command,
    const struct words *words, struct error *error)
{
	if (words->to != TO_PIPE &&
	    !files_may_write(s, words->target, words->to == TO_APPEND, error))
		return NULL;
	if (words->to == TO_FILE &&
	    !files_confirm_replace(s, words->target, error))
		return NULL;
	const struct output *output = find_output_format(command, words);
	struct redirect *r = xcalloc(1, sizeof *r);
	r->kind = output->kind;
	r->line = xstrdup(words->typed);
	if (!create_output_book_or_document(s, r, error)) {
		free(r->line);
		free(r);
		return NULL;
	}
	r->memory = text_open_memory(&r->text, &r->n);
	r->to = words->to;
	r->target = xstrdup(words->target);
	r->out = s->out;
	r->before = s->set.format;
	r->form = r->before;
	if (r->kind == OUTPUT_ANSWERS && output->end != NULL)
		r->form = (enum answer_format)output->format;
	/* In CSV format, commands that draw give numbers; in tables, text. */
	if (r->book != NULL)
		r->form = ANSWER_CSV;
	if (r->document != NULL)
		r->form = ANSWER_TABLE;
	r->screen = s->screen;
	r->rows = s->rows;
	s->rows = 0;
	s->screen = (struct screen){0};
	r->outer_file = s->file;
	s->file = r->to == TO_PIPE ? NULL : r->target;
	s->out = r->document != NULL ? r->document->out : r->memory;
	s->set.format = r->form;
	session_set_translation_by_format(s);
	return r;
}

/* Without a byte order mark, Excel reads the file in the local character set
 * and garbles letters beyond ASCII.  Only the beginning of a file gets one. */
static void
add_byte_order_mark(struct redirect *r)
{
	struct stat about;
	bool there = stat(r->target, &about) == 0;
	if (there && (!S_ISREG(about.st_mode) ||
			 (r->to == TO_APPEND && about.st_size > 0)))
		return;
	char *text = xcalloc(r->n + 4, 1);
	memcpy(text, "\xEF\xBB\xBF", 3);
	memcpy(text + 3, r->text, r->n);
	xfree_and_set(&r->text, text);
	r->n += 3;
}

/* Returns "12 rows" for a table, "24 lines" for other text.  The caller frees
 * it. */
static char *
written_rows_or_lines_text(const struct redirect *r, size_t rows)
{
	if (r->kind == OUTPUT_PICTURE)
		return xstrdup(tr("an image"));
	if (r->document != NULL) {
		char *text = document_parts_summary_text(r->document);
		if (r->pages > 0)
			xappend_to_list(&text, ", ",
			    tr_n("%zu page", "%zu pages", r->pages), r->pages);
		return text;
	}
	bool lines = rows == 0 || r->form == ANSWER_JSON;
	size_t n = lines ? 0 : rows;
	for (size_t i = 0; lines && i < r->n; i++)
		n += r->text[i] == '\n';
	return xasprintf(lines ? tr_n("%zu line", "%zu lines", n)
			       : tr_n("%zu row", "%zu rows", n),
	    n);
}

static bool
write_redirected_output(
    struct session *s, struct redirect *r, struct error *error)
{
	/* The command may have read this file after redirect_open. */
	bool whole = r->to == TO_FILE;
	if (!files_may_write(s, r->target, !whole, error))
		return false;
	bool (*write)(const char *, enum file_rights, const char *, size_t,
	    struct error *) = whole ? file_replace_contents : file_append_bytes;
	if (!write(r->target, FILE_SHARED, r->text, r->n, error))
		return false;
	struct stat about;
	if (stat(r->target, &about) != 0 || !S_ISREG(about.st_mode))
		return true;
	FREED char *what = written_rows_or_lines_text(r, s->rows);
	files_record_written(s, r->target);
	session_print_note(s,
	    whole ? N_("wrote %s: %s") : N_("added to %s: %s"), r->target,
	    what);
	return true;
}

/* Adds a sheet that states the program, command, site and parameters. */
static void
add_workbook_about_sheet(struct session *s, const struct redirect *r)
{
	book_add_about_line(r->book, "program", "tipspeed " PACKAGE_VERSION);
	book_add_about_line(r->book, "command", r->line);
	if (!book_has_site(r->book) || s->n_entry == 0)
		return;
	const struct entry *entry = session_current_site_entry(s);
	const struct site *site = entry->site;
	FREED char *label = session_site_label(site);
	FREED char *speeds =
	    session_speeds_of_runs_text(site, ", ", NULL, true);
	book_add_about_line(r->book, "site", label);
	book_add_about_line(r->book, "file", site->path);
	book_add_about_line(r->book, "provenance", site->provenance);
	book_add_about_line(r->book, "speeds, m/s", speeds);
	book_add_about_line(
	    r->book, "parameters", origin_of_params_text(entry));
	const struct breakage *model = BREAKAGES[entry->params.breakage];
	for (size_t j = 0; entry->has_params && j < model->n; j++) {
		const struct param_info *p = &model->parameter[j];
		char number[32];
		bool bare = strcmp(p->unit, "-") == 0;
		FREED char *name = xasprintf(
		    "%s%s%s", p->name, bare ? "" : ", ", bare ? "" : p->unit);
		book_add_about_line(r->book, name,
		    text_shortest_exact_number(
			params_value_by_name(&entry->params, p->name), number));
	}
}

static bool
replace_printed_text_by_workbook(
    struct session *s, struct redirect *r, struct error *error)
{
	if (book_count_sheets(r->book) == 0)
		return error_set(error, ERROR_USAGE,
		    "no table for a workbook (%s)\n"
		    "write > FILE.txt instead",
		    r->target);
	add_workbook_about_sheet(s, r);
	xfree_and_set(&r->text, book_finish_to_bytes(r->book, &r->n, error));
	r->book = NULL;
	return r->text != NULL;
}

static bool
replace_text_by_document(struct redirect *r, struct error *error)
{
	if (!document_finish(r->document))
		return error_set(error, ERROR_USAGE,
		    "no results for a document (%s)\n"
		    "use it with a command that answers: predict > %s",
		    r->target, r->target);
	xfree_and_set(
	    &r->text, r->kind == OUTPUT_PDF
			  ? document_to_pdf(r->document, &r->n, &r->pages)
			  : document_to_html(r->document, &r->n));
	return r->text != NULL || error_set(error, ERROR_SYSTEM,
				      "cannot draw the document %s\n"
				      "try > FILE.html",
				      r->target);
}

/* Returns false with an error if the shell command failed.  If an interrupt
 * ended it, passes that on. */
static bool
check_shell_status(const struct redirect *r, int status, struct error *error)
{
	if (status == 0)
		return true;
	if (status != -1 && WIFEXITED(status))
		return error_set(error, ERROR_SYSTEM,
		    "the shell command '%s' ended with status %d\n"
		    "check the text after |: all of it goes to the shell",
		    r->target, WEXITSTATUS(status));
	error_set(
	    error, ERROR_SYSTEM, "'%s' was terminated by a signal", r->target);
	if (status != -1 && WTERMSIG(status) == SIGINT)
		raise(SIGINT);
	return false;
}

/* If the shell command stops reading early, only the writing ends.  ^C goes to
 * it, as in a shell. */
static bool
write_to_shell_command(const struct redirect *r, struct error *error)
{
	struct sigaction ignore = {.sa_handler = SIG_IGN}, pipe, interrupt;
	sigemptyset(&ignore.sa_mask);
	fflush(r->out);
	FILE *out = popen(r->target, "w");
	if (out == NULL)
		return error_set(error, ERROR_SYSTEM, "cannot run '%s': %s",
		    r->target, strerror(errno));
	/* Nothing must be left in a buffer for pclose, because a failed write
	 * would hide the exit status of the command. */
	setvbuf(out, NULL, _IONBF, 0);
	sigaction(SIGPIPE, &ignore, &pipe);
	sigaction(SIGINT, &ignore, &interrupt);
	fwrite(r->text, 1, r->n, out);
	int status = pclose(out);
	sigaction(SIGPIPE, &pipe, NULL);
	sigaction(SIGINT, &interrupt, NULL);
	return check_shell_status(r, status, error);
}

bool
redirect_close(
    struct session *s, struct redirect *r, bool keep, struct error *error)
{
	s->out = r->out;
	s->book = r->outer_book;
	s->document = r->outer_document;
	s->screen = r->screen;
	s->file = r->outer_file;
	/* Unless the command itself has set the format. */
	if (s->set.format == r->form)
		s->set.format = r->before;
	session_set_translation_by_format(s);
	bool whole = fclose(r->memory) == 0, ok = true;
	if (keep && r->book != NULL)
		keep = ok = replace_printed_text_by_workbook(s, r, error);
	else if (keep && r->document != NULL)
		keep = ok = replace_text_by_document(r, error);
	else if (r->to != TO_PIPE && r->form == ANSWER_CSV &&
		 s->set.semicolon && r->n > 0)
		add_byte_order_mark(r);
	if (keep && !whole)
		ok = error_set(error, ERROR_SYSTEM,
		    "the results for %s do not fit into memory", r->target);
	else if (keep)
		ok = r->to == TO_PIPE ? write_to_shell_command(r, error)
				      : write_redirected_output(s, r, error);
	s->rows = r->rows;
	free(r->text);
	book_free(r->book);
	document_free(r->document);
	free(r->line);
	free(r->target);
	free(r);
	return ok;
}
