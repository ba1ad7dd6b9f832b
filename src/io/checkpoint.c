/* The text of a checkpoint: three heading lines, a line for each name with its
 * values, and the digest of all before it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/checkpoint.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/file.h"
#include "io/textfile.h"

static const char TITLE[] = "tipspeed checkpoint 3";

static bool
put_reals(void *data, const char *name, double *value, size_t n)
{
	FILE *out = data;
	fprintf(out, "%s", name);
	for (size_t i = 0; i < n; i++)
		fprintf(out, " %a", value[i]);
	fputc('\n', out);
	return true;
}

static bool
put_wholes(void *data, const char *name, size_t *value, size_t n)
{
	FILE *out = data;
	fprintf(out, "%s", name);
	for (size_t i = 0; i < n; i++)
		fprintf(out, " %zu", value[i]);
	fputc('\n', out);
	return true;
}

bool
checkpoint_save(const char *path, const struct checkpoint_of *of,
    struct calibration *c, struct error *error)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_memory(&text, &n);
	fprintf(out, "%s\nsite %016" PRIx64 "\noptions %s\n", TITLE,
	    of->site_digest, of->options);
	struct visit visit = {out, put_reals, put_wholes};
	calibration_visit(c, &visit);
	fflush(out);
	fprintf(out, "end %016" PRIx64 "\n",
	    text_digest(TEXT_DIGEST_START, text, n));
	fclose(out);
	bool ok = file_replace(path, FILE_SHARED, text, n, error);
	free(text);
	return ok;
}

/* Steps over a word; false where something else stands. */
static bool
take(char **next, const char *word)
{
	size_t n = strlen(word);
	bool here = strncmp(*next, word, n) == 0;
	*next += here ? n : 0;
	return here;
}

static bool
take_reals(void *data, const char *name, double *value, size_t n)
{
	char **next = data;
	bool ok = take(next, name);
	for (size_t i = 0; i < n && (ok = ok && **next == ' '); i++)
		value[i] = strtod(*next, next);
	return ok && take(next, "\n");
}

static bool
take_wholes(void *data, const char *name, size_t *value, size_t n)
{
	char **next = data;
	bool ok = take(next, name);
	for (size_t i = 0; i < n && (ok = ok && **next == ' '); i++)
		value[i] = (size_t)strtoull(*next, next, 10);
	return ok && take(next, "\n");
}

/* All of the file with a NUL behind it; NULL and why. */
static char *
read_all(const char *path, size_t *n, const char **why)
{
	FILE *in = textfile_open(path, why);
	if (in == NULL)
		return NULL;
	char *bytes = NULL;
	size_t room = 0;
	/* A checkpoint has no NUL of its own; one that has is damaged. */
	ssize_t got = getdelim(&bytes, &room, '\0', in);
	bool failed = ferror(in) != 0;
	*why = strerror(errno);
	fclose(in);
	*n = got > 0 ? (size_t)got : 0;
	if (got > 0)
		return bytes;
	free(bytes);
	return failed ? NULL : xstrdup("");
}

/* True when the last line holds the digest of what stands before it. */
static bool
is_whole(const char *bytes, size_t n)
{
	enum { LAST = sizeof "end 0123456789abcdef\n" - 1 };
	char want[LAST + 1];
	if (n < LAST)
		return false;
	uint64_t digest = text_digest(TEXT_DIGEST_START, bytes, n - LAST);
	snprintf(want, sizeof want, "end %016" PRIx64 "\n", digest);
	return memcmp(bytes + n - LAST, want, LAST) == 0;
}

static bool
refuse(const char *path, const char *why, const char *hint, struct error *error)
{
	return error_at(error, ERROR_DATA, path, 0, 0, "%s\n%s", why, hint);
}

/* Checks the heading and restores what follows it. */
static bool
take_text(const char *path, char *bytes, const struct checkpoint_of *of,
    struct calibration *c, struct error *error)
{
	char *next = bytes;
	char *site = xasprintf("site %016" PRIx64 "\n", of->site_digest);
	char *options = xasprintf("options %s\n", of->options);
	struct visit visit = {&next, take_reals, take_wholes};
	bool same_site =
	    take(&next, TITLE) && take(&next, "\n") && take(&next, site);
	bool same_options = same_site && take(&next, options);
	free(site);
	free(options);
	if (!same_site)
		return refuse(path,
		    "this checkpoint is of another site, or of "
		    "other numbers of this one",
		    "load the sheet it was made from", error);
	if (!same_options)
		return refuse(path,
		    "this checkpoint was made with other "
		    "options, bounds or settings",
		    "give calibrate the same ones; the file's third line has "
		    "them",
		    error);
	return calibration_visit(c, &visit) ||
	       refuse(path, "this checkpoint is of another version of tipspeed",
		   "calibrate again", error);
}

bool
checkpoint_load(const char *path, const struct checkpoint_of *of,
    struct calibration *c, struct error *error)
{
	size_t n = 0;
	const char *why;
	char *bytes = read_all(path, &n, &why);
	if (bytes == NULL)
		return error_at(
		    error, ERROR_SYSTEM, path, 0, 0, "cannot read: %s", why);
	bool ok;
	if (strncmp(bytes, TITLE, sizeof TITLE - 1) != 0)
		ok = refuse(path, "this is no checkpoint of tipspeed",
		    "calibrate checkpoint=FILE writes one when it is stopped",
		    error);
	else if (!is_whole(bytes, n))
		ok = refuse(path, "this checkpoint is damaged or cut off",
		    "take another copy, or calibrate again", error);
	else
		ok = take_text(path, bytes, of, c, error);
	free(bytes);
	return ok;
}
