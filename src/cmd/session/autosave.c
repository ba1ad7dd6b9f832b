/* Writes the file after each command: when the program ends, crashes or runs
 * out of memory, it would be too late.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/autosave.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/journal.h"
#include "config.h"
#include "io/fs/autosave_file.h"

struct autosave {
	struct autosave_file *kept;
	size_t saved;        /* state of the journal that counts as saved */
	struct mark written; /* what is in the file */
	/* The file that is being restored, and one that was; or NULL. */
	char *restoring, *restored;
	struct error error; /* why the session could not be kept, if so */
};

static bool
has_unsaved_changes(const struct session *s)
{
	struct mark now = journal_current_place(s);
	return now.state != s->autosave->saved && now.n > now.start;
}

static void
write_session_script(const void *data, FILE *out)
{
	const struct session *s = data;
	struct mark now = journal_current_place(s);
	size_t n = now.n - now.start;
	FREED char *name =
	    s->n_entry > 0 ? xasprintf(", %s", s->entry[s->current].site->name)
			   : xstrdup("");
	for (char *p = name; *p != '\0'; p++)
		*p = (unsigned char)*p < ' ' || *p == '\\' ? ' ' : *p;
	fprintf(out,
	    "# %zu command%s%s\n# A session of tipspeed %s that was not "
	    "saved.\n",
	    n, n == 1 ? "" : "s", name, PACKAGE_VERSION);
	journal_write_script(s, NULL, out);
}

/* Returns "4 commands, tierp" as the file has it, in the language of texts. */
static char *
leftover_autosave_text(const struct autosave_left *file)
{
	char *end;
	unsigned long n = strtoul(file->about, &end, 10);
	if (strncmp(end, " command", strlen(" command")) != 0)
		return xstrdup(file->about);
	const char *name = strchr(end, ',');
	FREED char *count =
	    xasprintf(tr_n("%lu command", "%lu commands", n), n);
	return xasprintf("%s%s", count, name != NULL ? name : "");
}

char *
autosave_begin(struct session *s)
{
	if (s->autosave != NULL || s->safe ||
	    strcmp(store_path(s->store), ":memory:") == 0)
		return NULL;
	s->autosave = xcalloc(1, sizeof *s->autosave);
	s->autosave->kept = autosave_file_new();
	s->autosave->written = journal_current_place(s);
	s->autosave->saved = s->autosave->written.state;
	size_t n;
	static const char *const MONTHS[] = {N_("January"), N_("February"),
	    N_("March"), N_("April"), N_("May"), N_("June"), N_("July"),
	    N_("August"), N_("September"), N_("October"), N_("November"),
	    N_("December")};
	char *offer = NULL, day[8];
	struct autosave_left *file = autosave_list_left_files(&n);
	if (n > 0) {
		const struct tm *tm = localtime(&file[0].when.tv_sec);
		strftime(day, sizeof day, " %H:%M", tm);
		FREED char *about = leftover_autosave_text(&file[0]);
		offer = xasprintf(
		    n > 1 ? tr("'restore last' brings back your last session, "
			       "of %d %s%s (%s); 'restore' lists earlier ones")
			  : tr("'restore last' brings back your last session, "
			       "of %d %s%s (%s)"),
		    tm->tm_mday, tr(MONTHS[tm->tm_mon]), day, about);
	}
	autosave_left_free(file, n);
	return offer;
}

static void
write_autosave(struct session *s)
{
	struct autosave *k = s->autosave;
	struct mark now = journal_current_place(s);
	/* What reset or restore discards remains in a file of its own. */
	if (now.start != k->written.start)
		autosave_file_close(k->kept);
	if (now.state == k->saved)
		autosave_file_remove(k->kept);
	else if (has_unsaved_changes(s)) {
		k->error = (struct error){0};
		if (!journal_can_be_saved(s, &k->error) ||
		    !autosave_file_write(
			k->kept, write_session_script, s, &k->error))
			return;
	}
	k->written = now;
}

/* Removes the file that was restored, once its session is kept elsewhere: in
 * this session's file, or in one of the user's. */
static void
remove_restored_autosave(struct autosave *k)
{
	if (k->restored != NULL)
		remove(k->restored);
	xfree_and_set(&k->restored, NULL);
}

/* Called after a command.  whole: if it restored a session, all of it ran. */
static void
finish_restoring_autosave(struct autosave *k, bool whole)
{
	if (k->restoring == NULL)
		return;
	free(whole ? k->restored : k->restoring);
	k->restored = whole ? k->restoring : k->restored;
	k->restoring = NULL;
}

/* Predictions in a row, as from the slider, are one line of the journal and
 * change nothing, so they are not written. */
void
autosave_after_command(struct session *s, bool ok, bool saved)
{
	struct autosave *k = s->autosave;
	struct mark now = journal_current_place(s);
	if (k == NULL)
		return;
	if (ok && saved) {
		k->saved = now.state;
		if (now.start == k->written.start)
			remove_restored_autosave(k);
	}
	/* The commands of a script are saved together, as they are undone. */
	if (s->scripts > s->typed_depth)
		return;
	/* A session of which only a part was restored does not become the
	 * newest. */
	bool in_part = k->restoring != NULL && !ok;
	finish_restoring_autosave(k, ok);
	if (in_part)
		return;
	if (saved || now.n != k->written.n || now.start != k->written.start ||
	    now.state != k->written.state)
		write_autosave(s);
}

/* Says how to keep calibrations that are in no file and not in the store. */
static void
print_fits_not_remembered(struct session *s)
{
	const char *key = NULL;
	size_t n = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		if (entry->has_fit && entry->remembered == NULL &&
		    !origin_is_from_store(entry->origin)) {
			key = entry->key;
			n++;
		}
	}
	if (n == 1)
		session_print_note(s,
		    "the calibration of %s was not remembered; next time, "
		    "'restore last' brings it back and 'remember %s' keeps it",
		    key, key);
	else if (n > 1)
		session_print_note(s,
		    "%zu calibrations were not remembered; next time, 'restore "
		    "last' brings them back and 'remember all' keeps them",
		    n);
}

/* Says how to keep cuts that were added to sites of the store. */
static void
print_cuts_not_remembered(struct session *s)
{
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		const char *name = entry->remembered;
		if (name == NULL && origin_is_from_store(entry->origin))
			name = entry->origin->material;
		if (entry->new_cuts > 0 && name != NULL)
			session_print_note(s,
			    entry->new_cuts > 1
				? N_("%zu new cuts of %s were not remembered; "
				     "next time, 'restore last' brings them "
				     "back and 'remember %s' keeps them")
				: N_("%zu new cut of %s was not remembered; "
				     "next time, 'restore last' brings it "
				     "back and 'remember %s' keeps it"),
			    entry->new_cuts, entry->key, name);
	}
}

void
autosave_end(struct session *s)
{
	struct autosave *k = s->autosave;
	if (k == NULL)
		return;
	if (has_unsaved_changes(s)) {
		write_autosave(s);
		if (k->error.kind == ERROR_NONE) {
			remove_restored_autosave(k);
			print_fits_not_remembered(s);
			print_cuts_not_remembered(s);
		} else
			session_print_note(s,
			    "could not keep this session: %s%s%s",
			    k->error.file, k->error.file[0] != '\0' ? ": " : "",
			    k->error.text);
	}
	autosave_file_free(k->kept);
	free(k->restored);
	free(k->restoring);
	s->autosave = NULL;
	free(k);
}

char *
autosave_newest_path(struct session *s, struct error *error)
{
	size_t n;
	struct autosave_left *file = autosave_list_left_files(&n);
	char *path = n > 0 ? xstrdup(file[0].path) : NULL;
	autosave_left_free(file, n);
	if (path == NULL)
		error_set(error, ERROR_USAGE,
		    "there is no unsaved session\n"
		    "write ./last for a file of that name");
	else if (s->autosave != NULL)
		s->autosave->restoring = xstrdup(path);
	return path;
}

bool
autosave_show_sessions(struct session *s)
{
	size_t n;
	struct autosave_left *file = autosave_list_left_files(&n);
	struct answer *r = answer_new("restore");
	answer_set_title(r, "unsaved sessions");
	answer_add_columns(r, "time, what, file");
	for (size_t i = 0; i < n; i++) {
		char when[32];
		strftime(when, sizeof when, "%Y-%m-%d %H:%M",
		    localtime(&file[i].when.tv_sec));
		FREED char *about = leftover_autosave_text(&file[i]);
		answer_add_cells(r, "%s %s %s", when, about, file[i].path);
	}
	answer_note(r, n > 0 ? N_("run 'restore last' for the first, 'restore "
				  "FILE' for any of them")
			     : N_("there is none"));
	autosave_left_free(file, n);
	return session_show_answer(s, r);
}
