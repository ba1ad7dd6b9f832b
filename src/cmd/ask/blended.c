/* Mixes feeds from sheets and describes them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/blended.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/lang/parse.h"
#include "cmd/sheets/load.h"
#include "core/psd/blend.h"
#include "io/fs/file.h"

bool
blended_add_feed(struct session *s, const char *file, double share,
    struct blended *b, struct error *error)
{
	size_t run;
	struct site *sheet = load_feed(s, file, &run, error);
	if (sheet == NULL)
		return false;
	b->part = xrealloc(b->part, b->n + 1, sizeof *b->part);
	b->part[b->n++] = (struct blend_part){
	    xstrdup(file), sheet, &sheet->run[run].feed, share};
	return true;
}

/* Returns 0 if the data are made up, 1 if the sheet does not say, 2 if they
 * were measured. */
static int
provenance_rank(const struct site *sheet)
{
	const char *kind = site_data_kind(sheet->provenance);
	return site_is_data_made_up(sheet->provenance) ? 0
	       : strcmp(kind, "not stated") == 0       ? 1
						       : 2;
}

/* Returns the first clause of each provenance, each once; "" if no sheet states
 * any.  The least trustworthy comes first, because the first word decides how
 * the blend is classified. */
static char *
join_provenance_clauses(const struct blended *b)
{
	char *list = xstrdup("");
	bool any = false;
	for (int rank = 0; rank <= 2; rank++)
		for (size_t i = 0; i < b->n; i++) {
			const struct site *sheet = b->part[i].sheet;
			FREED char *one =
			    site_provenance_first_clause(sheet, "not stated");
			if (provenance_rank(sheet) == rank &&
			    strstr(list, one) == NULL)
				xappend_to_list(&list, ", ", "%s", one);
			any = any || provenance_rank(sheet) != 1;
		}
	if (!any)
		list[0] = '\0';
	return list;
}

/* Returns "Granite", "Granite and Gneiss", or "" if no sheet states its
 * rock. */
static char *
join_distinct_rocks(const struct blended *b)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < b->n; i++) {
		const char *rock = b->part[i].sheet->rock;
		bool known = rock[0] == '\0';
		for (size_t k = 0; k < i; k++)
			known = known || text_is_same_folded(
					     b->part[k].sheet->rock, rock);
		if (!known)
			xappend_to_list(&list, tr(" and "), "%s", rock);
	}
	return list;
}

void
blended_mix_feeds(struct blended *b)
{
	FREED const struct psd **feed = xcalloc(b->n, sizeof *feed);
	FREED double *share = xcalloc_doubles(b->n);
	b->words = xstrdup("");
	for (size_t i = 0; i < b->n; i++) {
		feed[i] = b->part[i].feed;
		share[i] = b->part[i].share;
		b->sum += share[i];
	}
	for (size_t i = 0; i < b->n; i++)
		xappend_to_list(&b->words, " + ", "%.3g %% %s",
		    100 * share[i] / b->sum,
		    file_name_without_folders(b->part[i].file));
	b->feed = blend_new(feed, share, b->n);
	b->of = join_provenance_clauses(b);
	b->rock = join_distinct_rocks(b);
}

/* Uses the feed of a single sheet as it is. */
static bool
read_feed_of_sheet(
    struct session *s, const char *file, struct blended *b, struct error *error)
{
	if (!blended_add_feed(s, file, 1, b, error))
		return false;
	b->feed = psd_copy(b->part[0].feed);
	b->words = xasprintf(tr("feed %s"), file_name_without_folders(file));
	double top = site_assumed_top_size(b->part[0].sheet);
	if (top > 0)
		xappend(&b->words, tr(", assumed to pass %g mm"), top);
	b->of = xstrdup(b->part[0].sheet->provenance);
	b->rock = xstrdup(b->part[0].sheet->rock);
	return true;
}

static bool
check_share_and_add_feed(struct session *s, const char *at, size_t length,
    double share, struct blended *b, struct error *error)
{
	FREED char *file = xstrndup(at, length);
	bool ok = length > 0 && share > 0 && share <= 1;
	if (!ok)
		error_set(error, ERROR_USAGE,
		    isnan(share)
			? N_("feed: expected FILE*SHARE, got '%s' without a "
			     "share\n"
			     "write: feed=a.csv*0.6+b.csv*0.4")
			: N_("feed: expected a share above 0 and up to 1 (or "
			     "100 %%) of each sheet, got that of '%s'\n"
			     "write: feed=a.csv*0.6+b.csv*0.4"),
		    file);
	return ok && blended_add_feed(s, file, share, b, error);
}

/* Reads a feed from FILE, or a blend whose shares sum to 1, into an empty
 * struct. */
static bool
read_feed_or_blend(
    struct session *s, const char *text, struct blended *b, struct error *error)
{
	double share, sum = 0;
	size_t length;
	value_parse_feed_and_share(text, &length, &share);
	if (isnan(share))
		return read_feed_of_sheet(s, text, b, error);
	for (const char *at = text, *next; at != NULL; at = next) {
		next = value_parse_feed_and_share(at, &length, &share);
		if (!check_share_and_add_feed(s, at, length, share, b, error))
			return false;
		sum += share;
	}
	if (fabs(sum - 1) > 1e-6)
		return error_set(error, ERROR_USAGE,
		    "feed: expected shares that sum to 1 (or 100 %%), got "
		    "%.6g\n"
		    "write: feed=a.csv*0.6+b.csv*0.4; 'blend' takes parts of "
		    "any sum",
		    sum);
	blended_mix_feeds(b);
	return true;
}

struct blended *
blended_read_feeds(struct session *s, const char *text, struct error *error)
{
	struct blended *b = xcalloc(1, sizeof *b);
	b->text = xstrdup(text);
	if (read_feed_or_blend(s, text, b, error))
		return b;
	blended_free(b);
	return NULL;
}

void
blended_free(struct blended *b)
{
	if (b == NULL)
		return;
	for (size_t i = 0; i < b->n; i++) {
		free(b->part[i].file);
		site_free(b->part[i].sheet);
	}
	free(b->part);
	psd_free(&b->feed);
	free(b->text);
	free(b->words);
	free(b->of);
	free(b->rock);
	free(b);
}

const char *
blended_source_text(const struct blended *b)
{
	return b->n == 1 ? b->text : b->words;
}

const struct blended *
blended_read_feed_setting(
    struct session *s, const char *text, struct error *error)
{
	if (s->fed != NULL && strcmp(s->fed->text, text) == 0)
		return s->fed;
	struct blended *b = blended_read_feeds(s, text, error);
	if (b == NULL)
		return NULL;
	blended_free(s->fed);
	return s->fed = b;
}
