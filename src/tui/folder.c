/* Lists folders.  Sheets in them are read by the reader of sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/session.h"
#include "io/cells/archive.h"
#include "io/sitefile/results.h"
#include "io/fs/file.h"
#include "io/fs/shipped.h"
#include "io/sitefile/site_read.h"
#include "io/cells/textfile.h"
#include "io/store/material.h"
#include "io/sitefile/units.h"

/* A longer list is no help, and a folder of a million files takes long. */
enum { MOST_ITEMS = 2000 };

/* A sheet is read for a preview only if that is quick.  Workbooks are larger
 * unpacked. */
enum { MOST_BYTES = 300 * 1000, UNPACKED_TIMES = 10 };

static bool
is_script_name(const char *name)
{
	return text_ends_with(name, ".tip");
}

static int
compare_folder_items(const void *a, const void *b)
{
	const struct folder_item *x = a, *y = b;
	return x->kind != y->kind ? (x->kind > y->kind) - (x->kind < y->kind)
				  : strcmp(x->name, y->name);
}

static void
folder_add_item(struct folder *folder, enum folder_kind kind, const char *name)
{
	folder->item =
	    xrealloc(folder->item, folder->n + 1, sizeof *folder->item);
	folder->item[folder->n++] = (struct folder_item){.kind = kind,
	    .name = xstrdup(name),
	    .path = xasprintf("%s%s", folder->path, name)};
}

/* Adds an entry of a folder, but not one whose name has a quote, which could
 * not be typed.  A pipe is left out, too: reading it would wait. */
static void
add_directory_entry(struct folder *folder, const char *name)
{
	struct stat about;
	if (name[0] == '.' || strchr(name, '"') != NULL)
		return;
	FREED char *path = xasprintf("%s%s", folder->path, name);
	bool known = stat(path, &about) == 0;
	FREED char *command = known && file_has_sheet_ending(name)
				  ? command_that_made_file(path)
				  : NULL;
	if (known && S_ISDIR(about.st_mode)) {
		folder_add_item(folder, FOLDER_BELOW, name);
	} else if (command != NULL) {
		folder_add_item(folder, FOLDER_RESULTS, name);
		folder->item[folder->n - 1].about =
		    xasprintf(tr("results of %s"), command);
	} else if (known && S_ISREG(about.st_mode) && is_script_name(name)) {
		folder_add_item(folder, FOLDER_SESSION, name);
		folder->item[folder->n - 1].about =
		    xstrdup(tr("a saved session"));
	} else if (known && S_ISREG(about.st_mode)) {
		folder_add_item(folder,
		    file_has_sheet_ending(name) ? FOLDER_SHEET : FOLDER_OTHER,
		    name);
	}
}

void
folder_list(struct folder *folder, const char *path)
{
	*folder = (struct folder){.path = xstrdup(path)};
	DIR *dir = opendir(path[0] != '\0' ? path : ".");
	if (dir == NULL)
		folder->why = strerror(errno);
	folder_add_item(folder, FOLDER_ABOVE, "..");
	if (dir == NULL)
		return;
	for (struct dirent *e; !folder->more && (e = readdir(dir)) != NULL;) {
		add_directory_entry(folder, e->d_name);
		folder->more = folder->n >= MOST_ITEMS;
	}
	closedir(dir);
	qsort(folder->item, folder->n, sizeof *folder->item,
	    compare_folder_items);
}

/* Returns "Granite, 11.2 mm, 69 74 79 m/s", or NULL if the file is not a
 * site. */
static char *
site_file_summary(const char *path)
{
	struct error_list errors = {0};
	struct site *site = site_read(path, &errors);
	if (site == NULL)
		return NULL;
	bool in_rpm = answers_is_sheet_in_rpm(site);
	FREED char *speeds =
	    in_rpm ? session_rpm_of_runs_text(site, " ", NULL, false)
		   : session_speeds_of_runs_text(site, " ", NULL, false);
	char *about = xasprintf("%-16s %5.4g mm  %s %s", site->rock,
	    units_m_to_mm(site->top_size), speeds, answers_speed_unit(site));
	site_free(site);
	return about;
}

static void
folder_item_free(struct folder_item *item)
{
	free(item->name);
	free(item->path);
	free(item->about);
	free(item->made);
}

void
folder_filter_by_kind(struct folder *folder, unsigned kinds)
{
	size_t n = 0;
	for (size_t i = 0; i < folder->n; i++) {
		struct folder_item *item = &folder->item[i];
		if (kinds & 1U << item->kind)
			folder->item[n++] = *item;
		else
			folder_item_free(item);
	}
	folder->n = n;
}

/* Adds the shipped sites as made from the paper's Table 3, because without an
 * installation there are no files of them. */
static void
add_synthetic_sites(struct folder *folder)
{
	struct material_list paper = {0};
	material_add_table3_to_list(&paper);
	for (size_t i = 0; i < paper.n; i++) {
		const struct material *row = &paper.item[i];
		FREED char *slug = text_slug(row->site);
		FREED char *name = xasprintf("%s.csv", slug);
		bool again = false;
		for (size_t k = 0; k < folder->n && !again; k++)
			again = strcmp(folder->item[k].name, name) == 0;
		if (!again) {
			folder_add_item(folder, FOLDER_SHEET, name);
			struct folder_item *item = &folder->item[folder->n - 1];
			item->about = xasprintf(
			    "%-16s %5.4g mm", row->rock, row->top_size_mm);
			item->made = xasprintf(
			    "synth table3 \"site=%s\" seed=9", row->site);
		}
	}
	material_list_free(&paper);
	xfree_and_set(&folder->path, xstrdup(tr("from Table 3")));
	folder->why = NULL;
}

void
folder_list_shipped_sites(struct folder *folder)
{
	FREED char *path = shipped_sites_folder();
	folder_list(folder, path);
	for (size_t i = 0; i < folder->n; i++) {
		struct folder_item *item = &folder->item[i];
		if (item->kind == FOLDER_SHEET)
			item->about = site_file_summary(item->path);
		if (item->about == NULL)
			item->kind = FOLDER_OTHER;
	}
	folder_filter_by_kind(folder, 1U << FOLDER_SHEET);
	if (folder->n == 0)
		add_synthetic_sites(folder);
}

void
folder_free(struct folder *folder)
{
	for (size_t i = 0; i < folder->n; i++)
		folder_item_free(&folder->item[i]);
	free(folder->item);
	free(folder->path);
	*folder = (struct folder){0};
}

char *
folder_path_of_item(const struct folder *folder, size_t item)
{
	const char *path = folder->path;
	size_t n = strlen(path);
	if (folder->item[item].kind == FOLDER_BELOW)
		return xasprintf("%s%s/", path, folder->item[item].name);
	if (strcmp(path, "/") == 0)
		return xstrdup("/");
	if (n == 0 || strcmp(path, "../") == 0 || text_ends_with(path, "/../"))
		return xasprintf("%s../", path);
	for (n--; n > 0 && path[n - 1] != '/';)
		n--;
	return xstrndup(path, n);
}

/* Adds "./" to a name that would otherwise be taken for an option (=) or a
 * speed (@). */
char *
folder_command_to_open(const struct folder_item *item, bool anew)
{
	if (item->made != NULL)
		return xstrdup(item->made);
	bool plain = strchr(item->path, '/') != NULL ||
		     strpbrk(item->path, "=@-") == NULL;
	return xasprintf("%s \"%s%s\"",
	    !is_script_name(item->name) ? "load"
	    : anew                      ? "restore"
					: "source",
	    plain ? "" : "./", item->path);
}

static void
print_unless_empty(FILE *out, const char *what, const char *text)
{
	if (text[0] != '\0')
		fprintf(out, "%s%s\n", what, text);
}

static void
print_site_summary(const struct site *site, FILE *out)
{
	size_t n, products = site_count_products(site);
	FREED char *label = session_site_label(site);
	FREED char *speeds =
	    session_speeds_of_runs_text(site, ", ", NULL, false);
	FREED char *rpm = session_rpm_of_runs_in_brackets(site, NULL, false);
	FREED double *sieve = site_all_sieves(site, &n);
	fprintf(out, "%s\n", label);
	if (products > 0)
		fprintf(out,
		    tr_n("%zu run: %s m/s%s\n", "%zu runs: %s m/s%s\n",
			site->n_run),
		    site->n_run, speeds, rpm);
	else
		fprintf(out, tr("a feed, no product\n"));
	if (n > 0)
		fprintf(out, tr("%zu sieves, %g to %g mm\n"), n,
		    units_m_to_mm(sieve[n - 1]), units_m_to_mm(sieve[0]));
	print_unless_empty(out, tr("read: "), site->read_as);
	print_unless_empty(out, tr("likely, not stated: "), site->assumed);
	print_unless_empty(out, "", site->remark);
	for (size_t i = 0; i < site->n_left_out; i++)
		fprintf(out, tr("not read: %s, %s\n"), site->left_out[i].key,
		    site->left_out[i].value);
	FREED char *data = site_translate_provenance(site->provenance);
	print_unless_empty(out, tr("data: "), data);
}

char *
folder_site_summary_text(const struct site *site)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	print_site_summary(site, out);
	fclose(out);
	return text;
}

static void
print_faults_of_sheet(
    const struct error_list *errors, const struct site_ask *ask, FILE *out)
{
	enum { MOST = 3 };
	if (ask->settle != NULL)
		fputs(tr("load asks about it:\n"), out);
	for (size_t i = 0; i < errors->n && i < MOST; i++) {
		const struct error *e = &errors->item[i];
		if (e->line > 0)
			fprintf(out, tr("line %zu: "), (size_t)e->line);
		fprintf(out, "%s\n", e->text);
		print_unless_empty(out, "", e->hint);
	}
	if (errors->n > MOST)
		fprintf(out, tr("and %zu more\n"), errors->n - MOST);
	for (size_t i = 0; i < ask->n; i++)
		fprintf(out, "  %zu %s: %s%s\n", ask->column[i].number,
		    ask->column[i].head, ask->column[i].guess,
		    ask->column[i].open ? "?" : "");
}

static void
print_sheet_preview(const char *path, FILE *out)
{
	const double any = 0;
	const struct site_request request = {
	    .n = 1, .path = &path, .speed = &any};
	struct error_list errors = {0};
	struct site_ask ask = {0};
	struct site *site = site_read_with_options(&request, &errors, &ask);
	if (site != NULL)
		print_site_summary(site, out);
	else
		print_faults_of_sheet(&errors, &ask, out);
	site_ask_clear(&ask);
	site_free(site);
}

/* Returns the size of a file or, of an archive, that of its content divided by
 * UNPACKED_TIMES. */
static double
unpacked_size_of_file(const char *path, double bytes)
{
	size_t n = 0;
	char *wrong = NULL;
	struct error_list errors = {0};
	if (bytes > MOST_BYTES)
		return bytes;
	FREED char *content =
	    textfile_read_bytes(path, TEXTFILE_SHEET, &n, &errors);
	struct archive *archive =
	    content != NULL
		? archive_open(content, n, ARCHIVE_MOST_BYTES, &wrong)
		: NULL;
	if (archive != NULL)
		bytes = archive_unpacked_size(archive) / UNPACKED_TIMES;
	archive_close(archive);
	free(wrong);
	return bytes;
}

char *
folder_item_preview_text(const struct folder_item *item)
{
	char *text = NULL;
	size_t n = 0;
	struct stat about;
	if (item->kind == FOLDER_BELOW)
		return xstrdup(tr("a folder\n"));
	if (item->kind == FOLDER_ABOVE)
		return xstrdup(tr("the folder above\n"));
	if (item->made != NULL)
		return xstrdup(tr("made from the parameters of Table 3, not "
				  "measured\n"));
	if (is_script_name(item->name))
		return xstrdup(tr("a script of commands, which Enter runs\n"));
	if (stat(item->path, &about) != 0)
		return xasprintf("%s\n", strerror(errno));
	if (about.st_size == 0)
		return xstrdup(tr("an empty file\n"));
	if (about.st_size > TEXTFILE_SHEET)
		return xasprintf(tr("larger than the %d MB that a site file "
				    "may have\n"),
		    TEXTFILE_SHEET / 1000000);
	if (unpacked_size_of_file(item->path, (double)about.st_size) >
	    MOST_BYTES)
		return xstrdup(tr("large: not read for a preview; Enter loads "
				  "it\n"));
	FILE *out = text_open_memory(&text, &n);
	print_sheet_preview(item->path, out);
	fclose(out);
	return text;
}
