/* Sites and runs as plain data.  io reads and writes the files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/site.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "core/psd/blend.h"
#include "core/psd/rotor_speed.h"

struct site *
site_new(size_t n_run)
{
	struct site *site = xcalloc(1, sizeof *site);
	for (size_t i = 0; i < SITE_TEXTS; i++)
		site->text[i] = xstrdup("");
	site->remark = xstrdup("");
	site->n_run = n_run;
	site->run = xcalloc(n_run, sizeof *site->run);
	return site;
}

void
site_notes_append(
    struct site_note **list, size_t *n, const char *key, const char *value)
{
	*list = xrealloc(*list, *n + 1, sizeof **list);
	(*list)[(*n)++] = (struct site_note){xstrdup(key), xstrdup(value)};
}

double
site_assumed_top_size(const struct site *site)
{
	double mm, most = 0;
	for (size_t i = 0; i < site->n_note; i++)
		if (strcmp(site->note[i].key, SITE_ASSUMED_TOP) == 0 &&
		    text_parse_number(site->note[i].value, &mm))
			most = fmax(most, mm);
	return most;
}

static void
notes_free(struct site_note *list, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		free(list[i].key);
		free(list[i].value);
	}
	free(list);
}

static struct run
copy_run(const struct run *from)
{
	struct run to = *from;
	to.feed = psd_copy(&from->feed);
	to.product = psd_copy(&from->product);
	if (from->product_sd == NULL)
		return to;
	to.product_sd = xcalloc_doubles(from->product.n);
	memcpy(to.product_sd, from->product_sd,
	    from->product.n * sizeof *to.product_sd);
	return to;
}

struct site *
site_copy(const struct site *from)
{
	struct site *to = site_new(from->n_run);
	for (size_t i = 0; i < SITE_TEXTS; i++)
		xfree_and_set(&to->text[i], xstrdup(from->text[i]));
	to->top_size = from->top_size;
	to->rotor = from->rotor;
	to->run_rotor = from->run_rotor;
	to->individual_feeds = from->individual_feeds;
	to->digest = from->digest;
	to->mean_feed = psd_copy(&from->mean_feed);
	for (size_t r = 0; r < from->n_run; r++)
		to->run[r] = copy_run(&from->run[r]);
	for (size_t i = 0; i < from->n_note; i++)
		site_notes_append(&to->note, &to->n_note, from->note[i].key,
		    from->note[i].value);
	for (size_t i = 0; i < from->n_left_out; i++)
		site_notes_append(&to->left_out, &to->n_left_out,
		    from->left_out[i].key, from->left_out[i].value);
	return to;
}

static void
free_run_members(struct run *run)
{
	psd_free(&run->feed);
	psd_free(&run->product);
	free(run->product_sd);
}

void
site_free(struct site *site)
{
	if (site == NULL)
		return;
	for (size_t r = 0; r < site->n_run; r++)
		free_run_members(&site->run[r]);
	psd_free(&site->mean_feed);
	notes_free(site->note, site->n_note);
	notes_free(site->left_out, site->n_left_out);
	for (size_t i = 0; i < SITE_TEXTS; i++)
		free(site->text[i]);
	free(site->remark);
	free(site->run);
	free(site->shown);
	free(site);
}

static uint64_t
digest_psd(uint64_t h, const struct psd *psd)
{
	uint64_t n = psd->n; /* not size_t, which is shorter on some machines */
	h = text_fnv1a_digest(h, &n, sizeof n);
	h = text_fnv1a_digest(h, psd->size, psd->n * sizeof *psd->size);
	return text_fnv1a_digest(
	    h, psd->passing, psd->n * sizeof *psd->passing);
}

uint64_t
site_digest(const struct site *site)
{
	uint64_t h = TEXT_DIGEST_START;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		h = text_fnv1a_digest(h, &run->speed, sizeof run->speed);
		h = digest_psd(h, &run->feed);
		h = digest_psd(h, &run->product);
		if (run->product_sd != NULL)
			h = text_fnv1a_digest(h, run->product_sd,
			    run->product.n * sizeof *run->product_sd);
	}
	return h;
}

/* Numbers the runs at each speed that several share. */
static void
assign_repeat_numbers(struct site *site)
{
	for (size_t r = 0, nth = 0; r < site->n_run; r++) {
		nth = site_run_repeats_speed(site, r) ? nth + 1 : 1;
		bool more =
		    r + 1 < site->n_run && site_run_repeats_speed(site, r + 1);
		FREED char *which =
		    nth > 1 || more ? xasprintf(" (%zu)", nth) : xstrdup("");
		strncpy(
		    site->run[r].repeat, which, sizeof site->run[r].repeat - 1);
	}
}

void
site_drop_note(struct site *site, size_t i)
{
	free(site->note[i].key);
	free(site->note[i].value);
	size_t after = --site->n_note - i;
	memmove(&site->note[i], &site->note[i + 1], after * sizeof *site->note);
}

void
site_drop_run(struct site *site, size_t r)
{
	free_run_members(&site->run[r]);
	size_t after = --site->n_run - r;
	memmove(&site->run[r], &site->run[r + 1], after * sizeof *site->run);
}

/* Returns a provenance that names both sources in its first clause, which is
 * what people see.  If only the feed's data were made up, the feed comes
 * first. */
static char *
provenance_of_site_and_feed(const struct site *site, const char *of)
{
	const char *own = site->provenance;
	bool worse = site_is_data_made_up(of) && !site_is_data_made_up(own);
	size_t n = strcspn(own, ";"), n_of = strcspn(of, ";");
	FREED char *site_is = xasprintf("%.*s", (int)n, n > 0 ? own : "");
	FREED char *feed_is = xasprintf("%.*s", (int)n_of, of);
	if (n == 0)
		xfree_and_set(&site_is, xstrdup("not stated"));
	if (n_of == 0)
		xfree_and_set(&feed_is, xstrdup("not stated"));
	return worse ? xasprintf("%s (the feed), site: %s%s", feed_is, site_is,
			   own + n)
		     : xasprintf("%s, feed: %s%s", site_is, feed_is, own + n);
}

struct site *
site_copy_with_feed(const struct site *site, const struct psd *feed,
    const char *from, const char *of)
{
	struct site *to = site_copy(site);
	xfree_and_set(&to->provenance, provenance_of_site_and_feed(site, of));
	xfree_and_set(&to->feed_from, xstrdup(from));
	to->run = xrealloc(to->run, to->n_run + 1, sizeof *to->run);
	to->run[to->n_run++] =
	    (struct run){.speed = SITE_OTHER_FEED, .feed = psd_copy(feed)};
	return to;
}

/* Inserts a run after all runs at its speed, or in place of the first of them
 * if that one has only a feed. */
static void
insert_run_by_speed(struct site *site, struct run run, size_t *from)
{
	size_t at = site_run_at_speed(site, run.speed);
	if (at < site->n_run && site->run[at].product.n == 0) {
		free_run_members(&site->run[at]);
		site->run[at] = run;
		return;
	}
	for (at = 0; at < site->n_run && site->run[at].speed <= run.speed;)
		at++;
	site->run = xrealloc(site->run, site->n_run + 1, sizeof *site->run);
	size_t after = site->n_run++ - at;
	memmove(&site->run[at + 1], &site->run[at], after * sizeof *site->run);
	memmove(&from[at + 1], &from[at], after * sizeof *from);
	site->run[at] = run;
	from[at] = SIZE_MAX;
}

/* Gives a cut without a feed the feed of the run that it completes, or the feed
 * for any speed; otherwise marks that it lacks one. */
static void
set_feed_of_cut(struct site *site, struct run *cut)
{
	size_t at = site_run_at_speed(site, cut->speed);
	bool completes = at < site->n_run && site->run[at].product.n == 0;
	if (cut->feed.n > 0) {
		site->individual_feeds =
		    site->individual_feeds ||
		    !psd_is_same(&cut->feed, &site->run[0].feed);
		return;
	}
	psd_free(&cut->feed);
	cut->feed = psd_copy(&site->run[completes ? at : 0].feed);
	cut->lacks_feed = !completes && site->run[0].speed > 0;
}

struct site *
site_copy_with_cuts(
    const struct site *site, const struct site *cuts, size_t *from)
{
	struct site *to = site_copy(site);
	for (size_t r = 0; r < site->n_run; r++)
		from[r] = r;
	for (size_t k = 0; k < cuts->n_run; k++) {
		struct run run = copy_run(&cuts->run[k]);
		set_feed_of_cut(to, &run);
		insert_run_by_speed(to, run, from);
	}
	/* The runs now hold the feed for any speed. */
	if (to->n_run > 1 && !(to->run[0].speed > 0)) {
		site_drop_run(to, 0);
		memmove(from, from + 1, to->n_run * sizeof *from);
	}
	assign_repeat_numbers(to);
	site_update_digest_and_mean_feed(to);
	return to;
}

/* Returns the *n feeds that were sampled.  The caller frees the array. */
static const struct psd **
list_sampled_feeds(const struct site *site, size_t *n)
{
	const struct psd **feed = xcalloc(site->n_run, sizeof *feed);
	*n = 0;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed >= 0 && site->run[r].feed.n > 0 &&
		    !site->run[r].lacks_feed)
			feed[(*n)++] = &site->run[r].feed;
	return feed;
}

void
site_update_digest_and_mean_feed(struct site *site)
{
	size_t n;
	FREED const struct psd **feed = list_sampled_feeds(site, &n);
	psd_free(&site->mean_feed);
	/* If the last feed sample was removed, the copies that the cuts hold
	 * become the site's feeds. */
	for (size_t r = 0; r < site->n_run && n == 0; r++)
		site->run[r].lacks_feed = false;
	if (site->individual_feeds && n > 0)
		site->mean_feed = blend_mean_of_feeds(feed, n);
	for (size_t r = 0; r < site->n_run && site->mean_feed.n > 0; r++) {
		if (!site->run[r].lacks_feed)
			continue;
		psd_free(&site->run[r].feed);
		site->run[r].feed = psd_copy(&site->mean_feed);
	}
	site->digest = site_digest(site);
}

bool
site_run_has_feed_sample(const struct site *site, size_t run)
{
	return site->individual_feeds ? !site->run[run].lacks_feed : run == 0;
}

const struct psd *
site_feed_of_run(const struct site *site, size_t run)
{
	size_t other = site_run_at_speed(site, SITE_OTHER_FEED);
	if (run < site->n_run)
		return &site->run[run].feed;
	if (other < site->n_run)
		return &site->run[other].feed;
	return site->mean_feed.n > 0 ? &site->mean_feed : &site->run[0].feed;
}

double
site_largest_difference_of_feeds(const struct site *site, double *sieve)
{
	size_t n;
	FREED const struct psd **feed = list_sampled_feeds(site, &n);
	return blend_largest_feed_difference(feed, n, sieve);
}

double *
site_all_sieves(const struct site *site, size_t *n)
{
	FREED const struct psd **curve =
	    xcalloc(2 * site->n_run, sizeof *curve);
	for (size_t i = 0; i < 2 * site->n_run; i++)
		curve[i] = site_feed_or_product(
		    site, i % site->n_run, i < site->n_run);
	struct psd all = blend_list_sieves(curve, 2 * site->n_run);
	free(all.passing);
	*n = all.n;
	return all.size;
}

double
site_finest_sieve_all_pass(const struct site *site)
{
	double top = 0;
	for (size_t i = 0; i < 2 * site->n_run; i++) {
		const struct psd *p =
		    site_feed_or_product(site, i / 2, i % 2 == 0);
		for (size_t k = p->n; k-- > 0;)
			if (p->passing[k] >= 1) {
				top = fmax(top, p->size[k]);
				break;
			}
	}
	return top > 0 ? top : INFINITY;
}

struct psd *
site_feed_or_product(const struct site *site, size_t run, bool feed)
{
	return feed ? &site->run[run].feed : &site->run[run].product;
}

size_t
site_count_products(const struct site *site)
{
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++)
		n += site->run[r].product.n > 0;
	return n;
}

size_t
site_run_at_speed(const struct site *site, double speed)
{
	size_t r = 0;
	while (r < site->n_run && fabs(site->run[r].speed - speed) > 1e-3)
		r++;
	return r;
}

double
site_speed_from_rpm(const struct site *site, double rpm, double diameter)
{
	for (size_t r = 0; r < site->n_run; r++) {
		double v = site->run[r].speed;
		if (v > 0 && round(rotor_speed_to_rpm(v, diameter)) == rpm)
			return v;
	}
	return rotor_speed_from_rpm(rpm, diameter);
}

size_t
site_count_speeds(const struct site *site, const bool *use)
{
	size_t n = 0;
	double last = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (!use[r])
			continue;
		n += site->run[r].speed != last;
		last = site->run[r].speed;
	}
	return n;
}

bool
site_run_repeats_speed(const struct site *site, size_t run)
{
	return run > 0 && site->run[run].speed == site->run[run - 1].speed;
}

bool
site_run_is_among_nearest(
    const struct site *site, size_t run, double speed, size_t most)
{
	size_t nearer = 0;
	double far = fabs(site->run[run].speed - speed);
	for (size_t i = 0; i < site->n_run; i++) {
		double v = site->run[i].speed, d = fabs(v - speed);
		nearer += site->run[i].product.n > 0 &&
			  !site_run_repeats_speed(site, i) &&
			  (d < far || (d == far && v < site->run[run].speed));
	}
	return site->run[run].product.n > 0 && nearer < most;
}

void
site_default_speed_range(const struct site *site, double *from, double *to)
{
	const double usual_from = 65, usual_to = 85;
	double slowest = INFINITY, fastest = 0;
	for (size_t r = 0; site != NULL && r < site->n_run; r++) {
		double v = site->run[r].speed;
		slowest = v > 0 ? fmin(slowest, v) : slowest;
		fastest = fmax(fastest, v);
	}
	bool apart =
	    fastest > 0 && (2 * fastest < usual_from || slowest > 2 * usual_to);
	double more = fmax((fastest - slowest) / 2, slowest / 4);
	*from =
	    fmax(1, floor(apart ? slowest - more : fmin(slowest, usual_from)));
	*to = ceil(apart ? fmin(fastest + more, SITE_FASTEST)
			 : fmax(fastest, usual_to));
}

char *
site_translate_provenance(const char *provenance)
{
	static const char SHEET[] = "sheet of ", CUTS[] = ", cuts to ";
	const char *day = provenance + strlen(SHEET);
	if (strcmp(provenance, "provenance not stated") == 0)
		return xstrdup(tr("provenance not stated"));
	if (strncmp(provenance, SHEET, strlen(SHEET)) != 0)
		return xstrdup(provenance);
	const char *cuts = strstr(day, CUTS);
	return cuts == NULL ? xasprintf(tr("sheet of %s"), day)
			    : xasprintf(tr("sheet of %.*s, cuts to %s"),
				  (int)(cuts - day), day, cuts + strlen(CUTS));
}

char *
site_provenance_first_clause(const struct site *site, const char *none)
{
	size_t n = strcspn(site->provenance, ";");
	return n > 0 ? xstrndup(site->provenance, n) : xstrdup(none);
}

void
sources_add(struct sources *all, const char *name, const char *clause)
{
	size_t i = 0;
	while (i < all->n && strcmp(all->clause[i], clause) != 0)
		i++;
	if (i == all->n) {
		all->n++;
		all->clause = xrealloc(all->clause, i + 1, sizeof(char *));
		all->names = xrealloc(all->names, i + 1, sizeof(char *));
		all->clause[i] = xstrdup(clause);
		all->names[i] = xstrdup("");
	}
	xappend_to_list(&all->names[i], ", ", "%s", name);
}

void
sources_add_site(struct sources *all, const char *name, const struct site *site)
{
	FREED char *clause =
	    site_provenance_first_clause(site, "provenance not stated");
	sources_add(all, name, clause);
}

char *
sources_text_and_clear(struct sources *all)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < all->n; i++) {
		if (all->n == 1)
			xappend(&list, "%s", all->clause[i]);
		else
			xappend_to_list(&list, ", ", "%s (%s)", all->clause[i],
			    all->names[i]);
		free(all->clause[i]);
		free(all->names[i]);
	}
	free(all->clause);
	free(all->names);
	*all = (struct sources){0};
	return list;
}

static const char *const MADE_UP[] = {
    N_("reconstructed"), N_("synthetic"), N_("made up"), N_("simulated")};

double
site_middle_speed(const struct site *site)
{
	const double usual = 74;
	size_t other = site_run_at_speed(site, SITE_OTHER_FEED);
	size_t last = other > 0 ? other - 1 : 0;
	double middle = (site->run[0].speed + site->run[last].speed) / 2;
	return middle > 0 ? middle : usual;
}

const char *
site_data_kind(const char *provenance)
{
	FREED char *folded = text_fold_case_and_accents(provenance);
	const char *text = text_trim(folded), *kind = N_("measured");
	const char none[] = "not stated", day[] = "sheet of ";
	/* The date of a sheet does not mean that its numbers were measured. */
	if (text[0] == '\0' || strncmp(text, none, strlen(none)) == 0 ||
	    strncmp(text, day, strlen(day)) == 0)
		kind = "not stated";
	for (size_t i = 0; i < ARRAY_LEN(MADE_UP); i++)
		if (strncmp(text, MADE_UP[i], strlen(MADE_UP[i])) == 0)
			kind = MADE_UP[i];
	return kind;
}

bool
site_is_data_made_up(const char *provenance)
{
	const char *kind = site_data_kind(provenance);
	return strcmp(kind, "measured") != 0 && strcmp(kind, "not stated") != 0;
}

double
site_run_rotor_diameter(const struct site *site)
{
	return site->run_rotor > 0 ? site->run_rotor : site->rotor;
}
