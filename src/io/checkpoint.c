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
#include "io/replace.h"

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

struct text {
	char *bytes;
	size_t n;
};

static void
write_text(const void *data, FILE *out)
{
	const struct text *text = data;
	uint64_t digest = text_digest(TEXT_DIGEST_START, text->bytes, text->n);
	fwrite(text->bytes, 1, text->n, out);
	fprintf(out, "end %016" PRIx64 "\n", digest);
}

bool
checkpoint_save(const char *path, const struct checkpoint_of *of,
    struct calibration *c, struct error *error)
{
	struct text text = {NULL, 0};
	FILE *out = open_memstream(&text.bytes, &text.n);
	if (out == NULL)
		return error_at(error, ERROR_SYSTEM, path, 0, 0,
		    "cannot be saved: %s", strerror(errno));
	fprintf(out, "%s\nsite %016" PRIx64 "\noptions %s\n", TITLE,
	    of->site_digest, of->options);
	struct visit visit = {out, put_reals, put_wholes};
	calibration_visit(c, &visit);
	fclose(out);
	bool ok = replace_file(path, write_text, &text, error);
	free(text.bytes);
	return ok;
}

/* Reading: the place in the text that is next. */
struct cursor {
	char *next;
};

/* Steps over the name and a blank; false where something else stands. */
static bool
take_name(struct cursor *c, const char *name)
{
	size_t n = strlen(name);
	if (strncmp(c->next, name, n) != 0)
		return false;
	c->next += n;
	return true;
}

static bool
take_reals(void *data, const char *name, double *value, size_t n)
{
	struct cursor *c = data;
	bool ok = take_name(c, name);
	for (size_t i = 0; ok && i < n; i++) {
		char *end;
		ok = *c->next == ' ';
		value[i] = ok ? strtod(c->next, &end) : 0;
		c->next = ok ? end : c->next;
	}
	return ok && *c->next++ == '\n';
}

static bool
take_wholes(void *data, const char *name, size_t *value, size_t n)
{
	struct cursor *c = data;
	bool ok = take_name(c, name);
	for (size_t i = 0; ok && i < n; i++) {
		char *end;
		ok = *c->next == ' ';
		value[i] = ok ? (size_t)strtoull(c->next, &end, 10) : 0;
		c->next = ok ? end : c->next;
	}
	return ok && *c->next++ == '\n';
}

/* All of the file with a NUL behind it; NULL with errno. */
static char *
read_all(const char *path, size_t *n)
{
	FILE *in = fopen(path, "r");
	if (in == NULL)
		return NULL;
	size_t room = 1 << 16;
	char *bytes = xcalloc(room + 1, 1);
	*n = 0;
	for (size_t got; (got = fread(bytes + *n, 1, room - *n, in)) > 0;) {
		*n += got;
		if (*n == room)
			bytes = xrealloc(bytes, (room *= 2) + 1, 1);
	}
	bytes[*n] = '\0';
	bool failed = ferror(in) != 0;
	fclose(in);
	if (!failed)
		return bytes;
	free(bytes);
	return NULL;
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
	error_at(error, ERROR_DATA, path, 0, 0, "%s", why);
	return error_hint(error, "%s", hint);
}

/* Checks the heading and restores what follows it. */
static bool
take_text(const char *path, char *bytes, const struct checkpoint_of *of,
    struct calibration *c, struct error *error)
{
	struct cursor cursor = {bytes};
	char *site = xasprintf("site %016" PRIx64 "\n", of->site_digest);
	char *options = xasprintf("options %s\n", of->options);
	struct visit visit = {&cursor, take_reals, take_wholes};
	bool same_site = take_name(&cursor, TITLE) &&
			 take_name(&cursor, "\n") && take_name(&cursor, site);
	bool same_options = same_site && take_name(&cursor, options);
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
	char *bytes = read_all(path, &n);
	if (bytes == NULL)
		return error_at(error, ERROR_SYSTEM, path, 0, 0,
		    "cannot read: %s", strerror(errno));
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
