/* Keeps what a command prints until it is done, then hands it over: so a
 * command that fails leaves a file as it was.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/redirect.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/script.h"
#include "io/replace.h"

struct redirect {
	enum target to;
	char *target;
	FILE *memory, *out; /* what is kept; where results went before */
	char *text;
	size_t n;
	enum report_format form, before;
	bool mark;            /* begins with a byte order mark */
	struct screen screen; /* before, too */
};

/* The form that the end of a file's name asks for. */
static enum report_format
form_of(const char *path, enum report_format other)
{
	static const struct {
		const char *end;
		enum report_format form;
	} ENDS[] = {{".csv", REPORT_CSV}, {".json", REPORT_JSON},
	    {".md", REPORT_MARKDOWN}};
	for (size_t i = 0; i < ARRAY_LEN(ENDS); i++)
		if (text_ends(path, ENDS[i].end))
			return ENDS[i].form;
	return other;
}

static bool
cannot_write(const char *path, int reason, struct error *error)
{
	return error_set(error, ERROR_SYSTEM,
	    "cannot write %s: %s\n"
	    "check the folder, its rights and the room on the disk",
	    path, strerror(reason));
}

/* Better told before an hour's calibration than after it. */
static bool
may_write(const char *path, struct error *error)
{
	struct stat about;
	if (stat(path, &about) == 0) {
		if (S_ISDIR(about.st_mode))
			return cannot_write(path, EISDIR, error);
		return access(path, W_OK) == 0 ||
		       cannot_write(path, errno, error);
	}
	const char *slash = strrchr(path, '/');
	char *folder = slash == NULL
			   ? xstrdup(".")
			   : xstrndup(path, (size_t)(slash - path) + 1);
	bool ok = access(folder, W_OK | X_OK) == 0;
	int reason = errno;
	free(folder);
	return ok || cannot_write(path, reason, error);
}

/* Scripts are not asked for. */
static bool
may_replace(struct session *s, const char *path, struct error *error)
{
	struct stat file;
	if (s->confirm == NULL || script_depth(s) > s->typed_at ||
	    stat(path, &file) != 0 || !S_ISREG(file.st_mode) ||
	    file.st_size == 0)
		return true;
	char *question = xasprintf("%s exists: replace it?", path);
	bool yes = s->confirm(s, question);
	free(question);
	return yes || error_set(error, ERROR_USAGE,
			  "%s was kept as it was\nname another file", path);
}

struct redirect *
redirect_open(struct session *s, const struct words *words, struct error *error)
{
	if (words->to != TO_PIPE && !may_write(words->target, error))
		return NULL;
	if (words->to == TO_FILE && !may_replace(s, words->target, error))
		return NULL;
	struct redirect *r = xcalloc(1, sizeof *r);
	r->memory = text_memory(&r->text, &r->n);
	r->to = words->to;
	r->target = xstrdup(words->target);
	r->out = s->out;
	r->before = s->set.format;
	r->form = r->to == TO_PIPE ? s->set.format
				   : form_of(r->target, s->set.format);
	r->screen = s->screen;
	s->screen = (struct screen){0};
	s->file = r->to == TO_PIPE ? NULL : r->target;
	s->out = r->memory;
	s->set.format = r->form;
	return r;
}

/* Excel takes a file without the mark for one in the letters of its country,
 * and shows the O of Ossjo as two. */
static void
put_text(const void *data, FILE *out)
{
	const struct redirect *r = data;
	if (r->mark)
		fputs("\xEF\xBB\xBF", out);
	fwrite(r->text, 1, r->n, out);
}

/* At the end of a file, or into a device.  What a full disk took of it is cut
 * off again. */
static bool
write_end(struct redirect *r, struct error *error)
{
	struct stat about;
	FILE *out = fopen(r->target, "a");
	if (out == NULL)
		return cannot_write(r->target, errno, error);
	bool file = fstat(fileno(out), &about) == 0 && S_ISREG(about.st_mode);
	r->mark = r->mark && file && about.st_size == 0;
	put_text(r, out);
	bool good = fflush(out) == 0 && !ferror(out);
	int reason = errno;
	if (!good && file && ftruncate(fileno(out), about.st_size) != 0)
		reason = errno;
	good = fclose(out) == 0 && good;
	return good || cannot_write(r->target, reason, error);
}

static bool
write_file(struct redirect *r, struct error *error)
{
	struct stat about;
	bool whole = r->to == TO_FILE &&
		     (stat(r->target, &about) != 0 || S_ISREG(about.st_mode));
	return whole ? replace_file(r->target, put_text, r, error)
		     : write_end(r, error);
}

/* How the shell command ended.  One that ^C ended passes it on. */
static bool
judge_shell(const struct redirect *r, int status, struct error *error)
{
	if (status == 0)
		return true;
	if (status != -1 && WIFEXITED(status))
		return error_set(error, ERROR_SYSTEM,
		    "the shell command '%s' ended with status %d\n"
		    "all of the line behind | is the shell's",
		    r->target, WEXITSTATUS(status));
	error_set(error, ERROR_SYSTEM, "'%s' did not end by itself", r->target);
	if (status != -1 && WTERMSIG(status) == SIGINT)
		raise(SIGINT);
	return false;
}

/* A reader that has seen enough ends the writing, not the program; ^C is for
 * the shell command, as in a shell. */
static bool
write_pipe(struct redirect *r, struct error *error)
{
	struct sigaction ignore = {.sa_handler = SIG_IGN}, pipe, interrupt;
	sigemptyset(&ignore.sa_mask);
	fflush(r->out);
	FILE *out = popen(r->target, "w");
	if (out == NULL)
		return cannot_write(r->target, errno, error);
	/* Nothing may be left to write when it is closed: that would hide how
	 * the command ended. */
	setvbuf(out, NULL, _IONBF, 0);
	sigaction(SIGPIPE, &ignore, &pipe);
	sigaction(SIGINT, &ignore, &interrupt);
	put_text(r, out);
	int status = pclose(out);
	sigaction(SIGPIPE, &pipe, NULL);
	sigaction(SIGINT, &interrupt, NULL);
	return judge_shell(r, status, error);
}

bool
redirect_close(
    struct session *s, struct redirect *r, bool keep, struct error *error)
{
	s->out = r->out;
	s->screen = r->screen;
	s->file = NULL;
	/* Unless the command itself was to set it. */
	if (s->set.format == r->form)
		s->set.format = r->before;
	bool whole = fclose(r->memory) == 0;
	r->mark = r->to != TO_PIPE && r->form == REPORT_CSV &&
		  s->set.semicolon && r->n > 0;
	bool ok = true;
	if (keep && !whole)
		ok = cannot_write(r->target, ENOMEM, error);
	else if (keep)
		ok = (r->to == TO_PIPE ? write_pipe : write_file)(r, error);
	free(r->text);
	free(r->target);
	free(r);
	return ok;
}
