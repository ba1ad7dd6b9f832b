/* A site: the runs of one quarry's crusher, each with feed and product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SITE_H
#define TIPSPEED_CORE_PSD_SITE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/psd/psd.h"

/* Instead of the speed of a run: its feed is that of another sheet, about which
 * a question is asked.  It is the last run of a copy (site_with_feed). */
#define SITE_OTHER_FEED (-1.0)

/* Instead of the index of the run whose feed is taken: the mean of those
 * sampled (D19). */
#define SITE_MEAN_FEED SIZE_MAX

/* One sampling at a rotor tip speed.  product.n is 0 where only the feed was
 * sampled.  product_sd: standard deviation of each product passing, 0..1, or
 * NULL. */
struct run {
	double speed;    /* m/s; 0 of a feed for any speed, without product;
			  * SITE_OTHER_FEED */
	char repeat[16]; /* " (2)": which of several at this speed; else "" */
	size_t place;    /* of its product among the columns that were read */
	struct psd feed;
	struct psd product;
	double *product_sd;
};

/* A line of the sheet's heading that tipspeed does not use but keeps. */
struct site_note {
	char *key, *value;
};

/* Strings are never NULL; "" where the sheet does not state it.  run[] is in
 * order of rising speed, repeats at one speed in the order of the sheet.
 * individual_feeds: each run has a feed sample of its own; otherwise every run
 * holds a copy of the one feed. */
struct site {
	char *name, *rock, *machine, *provenance;
	double top_size; /* m; 0 when not stated */
	double rotor;    /* diameter, m; 0 when not stated */
	bool individual_feeds;
	struct psd mean_feed; /* of several feeds; site_settle */
	size_t n_run;
	struct run *run;
	size_t n_note;
	struct site_note *note;
	/* What the reader left out: where ("line 9"), and what and why.  named:
	 * sieves that had names, "#4 = 4.75". */
	size_t n_left_out;
	struct site_note *left_out;
	char *named;
	/* read_as: what its columns were read as; assumed: what of that the
	 * sheet does not state; "" where it has the headings of
	 * tipspeed-site(5).  remark: on how its file was read, or "". */
	char *read_as, *assumed, *remark;
	/* In a copy for a question, what differs from what was sampled.
	 * feed_from: where the feed is from; with: all of it in words, "feed
	 * b.csv, cascade 10 %"; else "". */
	char *feed_from, *with;
	/* In such a copy: sieves to show, m, coarsest first; n_shown 0: the
	 * site's own. */
	size_t n_shown;
	double *shown;
	char *path;      /* file it was read from, or "" */
	uint64_t digest; /* of the numbers: sizes, passings, speeds */
};

/* An empty site with n_run runs. */
struct site *site_new(size_t n_run);
void site_free(struct site *site);

/* A deep copy. */
struct site *site_copy(const struct site *site);

/* A copy with another feed as its last run, which has no product; from: where
 * the feed is from, of: the provenance in its sheet.  The digest stays. */
struct site *site_with_feed(const struct site *site, const struct psd *feed,
    const char *from, const char *of);

/* A copy with the products of cuts as further runs, behind those at their
 * speed.  Each has its own feed, where it has one, else that of the site's run
 * at the nearest speed; a run that had a feed only is completed.
 * from [runs of both]: out, for each run of the copy its place in the site, or
 * SIZE_MAX. */
struct site *site_with_cuts(
    const struct site *site, const struct site *cuts, size_t *from);

/* Digest of everything a calibration depends on. */
uint64_t site_digest(const struct site *site);

/* Computes what follows from the runs, digest and mean feed; to be called after
 * runs were made or changed. */
void site_settle(struct site *site);

/* The feed of a run, or for SITE_MEAN_FEED the one that a question has where it
 * names none: the mean of the distinct feeds that were sampled (blend_mean),
 * or that of another sheet, where the site is a copy with one. */
const struct psd *site_feed(const struct site *site, size_t run);

/* The largest difference in passing, 0..1, between two of its feeds, and the
 * sieve, m; 0 where there is one feed. */
double site_feeds_differ(const struct site *site, double *sieve);

/* The sieves of all feeds and products, m, coarsest first, each once: [*n],
 * which the caller frees. */
double *site_sieves(const struct site *site, size_t *n);

/* One more note at the end of a list of n. */
void site_add_note(
    struct site_note **list, size_t *n, const char *key, const char *value);

/* How many runs have a product. */
size_t site_products(const struct site *site);

/* Index of the run at the given speed (to 0.001 m/s), the first of repeats, or
 * n_run if none. */
size_t site_run_at(const struct site *site, double speed);

/* Whether the run repeats the speed of the one before it. */
bool site_run_repeats(const struct site *site, size_t run);

/* The run whose speed is nearest; the slower of two equally near, the first of
 * repeats. */
size_t site_run_nearest(const struct site *site, double speed);

/* Whether the run has a product and its speed is one of the `most` nearest that
 * have one: repeats stand together. */
bool site_run_is_near(
    const struct site *site, size_t run, double speed, size_t most);

/* The fastest tip speed allowed, m/s: a rotor reaches half of it, single
 * particles shot at a plate reach it. */
enum { SITE_FASTEST = 400 };

/* The default range of speeds, m/s: 65 to 85, which are usual, widened by whole
 * m/s to cover the runs.  Where all runs are below half or above twice such
 * speeds the machine is another, and the range is that of the runs, widened at
 * both ends by half its length, and by a quarter of the slowest at least.
 * site: or NULL. */
void site_reach(const struct site *site, double *from, double *to);

/* The middle of the speeds measured, m/s; 74 where there is a feed only. */
double site_middle(const struct site *site);

/* What data of that provenance are: "reconstructed", "synthetic", "made up" or
 * "simulated", as it begins; "not stated" where it says that or is empty;
 * anything else counts as "measured". */
const char *site_data_kind(const char *provenance);

/* The key of the header line with the size, mm, that all of the feed was
 * assumed to pass, as its coarsest sieve did not show it. */
#define SITE_ASSUMED_TOP "assumed_top_mm"

/* That size, mm; 0: nothing was assumed. */
double site_assumed_top(const struct site *site);

/* Whether the data were never measured at a plant, by their provenance. */
bool site_data_made_up(const char *provenance);

/* The first clause of the provenance, which the caller frees; or a copy of
 * `none` where the sheet does not state it. */
char *site_source(const struct site *site, const char *none);

/* Adds that clause to a list "a; b" of several sites', each once. */
void site_add_source(char **list, const struct site *site);

#endif
