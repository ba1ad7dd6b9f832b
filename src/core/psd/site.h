/* A site: the runs of one quarry's crusher, each with feed and product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SITE_H
#define TIPSPEED_CORE_PSD_SITE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/psd/psd.h"

/* Instead of the speed of a run: its feed comes from another sheet, about which
 * a question is asked.  It is the last run of a copy (site_with_feed). */
#define SITE_OTHER_FEED (-1.0)

/* Instead of the index of a run whose feed is used: the mean of the feeds
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

/* Returns a copy with another feed as its last run, which has no product; from:
 * where the feed comes from; of: the provenance in its sheet.  The digest
 * stays. */
struct site *site_with_feed(const struct site *site, const struct psd *feed,
    const char *from, const char *of);

/* Returns a copy with the products of cuts as further runs, after the site's
 * runs at their speed.  Each run keeps its own feed, if it has one; else it
 * gets the feed of the site's run at the nearest speed.  A run with only a feed
 * is completed.  from [runs of both]: out, for each run of the copy its index
 * in the site, or SIZE_MAX. */
struct site *site_with_cuts(
    const struct site *site, const struct site *cuts, size_t *from);

/* Returns the digest of everything a calibration depends on. */
uint64_t site_digest(const struct site *site);

/* Computes what follows from the runs, digest and mean feed; to be called after
 * runs were made or changed. */
void site_settle(struct site *site);

/* Returns the feed of a run, or for SITE_MEAN_FEED the feed of a question that
 * names none: the mean of the distinct feeds that were sampled (blend_mean), or
 * the feed of another sheet, where the site is a copy with such a feed. */
const struct psd *site_feed(const struct site *site, size_t run);

/* Returns the largest difference in passing, 0..1, between two of the site's
 * feeds; sieve: its sieve, m, out.  0 where there is one feed. */
double site_feeds_differ(const struct site *site, double *sieve);

/* Returns the sieves of all feeds and products, m, coarsest first, each once:
 * [*n]; the caller frees. */
double *site_sieves(const struct site *site, size_t *n);

/* Adds a note at the end of a list of n. */
void site_add_note(
    struct site_note **list, size_t *n, const char *key, const char *value);

/* Returns how many runs have a product. */
size_t site_products(const struct site *site);

/* Returns the index of the run at the given speed (to 0.001 m/s), the first of
 * repeats, or n_run if there is none. */
size_t site_run_at(const struct site *site, double speed);

/* True if the run repeats the speed of the run before it. */
bool site_run_repeats(const struct site *site, size_t run);

/* Returns the run with the nearest speed; the slower of two equally near, the
 * first of repeats. */
size_t site_run_nearest(const struct site *site, double speed);

/* True if the run has a product and its speed is one of the `most` nearest
 * speeds with a product: repeats count as one speed. */
bool site_run_is_near(
    const struct site *site, size_t run, double speed, size_t most);

/* The fastest tip speed allowed, m/s: a rotor reaches half of it, single
 * particles shot at a plate reach it. */
enum { SITE_FASTEST = 400 };

/* Computes the default range of speeds, m/s: 65 to 85, which are usual, widened
 * by whole m/s to cover the runs.  Where all runs are below half or above twice
 * such speeds the machine is another, and the range is that of the runs,
 * widened at both ends by half its length, and by a quarter of the slowest at
 * least.  site: or NULL. */
void site_reach(const struct site *site, double *from, double *to);

/* Returns the middle of the speeds measured, m/s; 74 where there is only a
 * feed. */
double site_middle(const struct site *site);

/* Returns the kind of data with that provenance: "reconstructed", "synthetic",
 * "made up" or "simulated", as it begins; "not stated" where it says that or is
 * empty; any other provenance counts as "measured". */
const char *site_data_kind(const char *provenance);

/* The key of the header line with the size, mm, that all of the feed was
 * assumed to pass, as its coarsest sieve did not show it. */
#define SITE_ASSUMED_TOP "assumed_top_mm"

/* Returns the size of SITE_ASSUMED_TOP, mm; 0: nothing was assumed. */
double site_assumed_top(const struct site *site);

/* True if, by their provenance, the data were never measured at a plant. */
bool site_data_made_up(const char *provenance);

/* Returns the first clause of the provenance, or a copy of `none` where the
 * sheet does not state it; the caller frees. */
char *site_source(const struct site *site, const char *none);

/* Adds the site's first clause to a list "a; b" of several sites' clauses, each
 * once. */
void site_add_source(char **list, const struct site *site);

/* Returns the error in speed of the answer at tip speed v, in multiples of the
 * error of one stated speed: the errors of the runs, as in a straight line
 * through them in v^2, and the error of v itself:
 *   sqrt(1 + 1/n + (v^2 - m)^2 / sum (v_i^2 - m)^2),   m the mean of the v_i^2
 * Infinite where all runs have one speed and v is another. */
double site_speed_error(const struct site *site, double v);

#endif
