/* A site: the runs of one quarry's crusher, each with feed and product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SITE_H
#define TIPSPEED_CORE_PSD_SITE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/psd/psd.h"

/* The speed of a run that only holds a feed from another sheet: the last run of
 * a copy made by site_copy_with_feed. */
#define SITE_OTHER_FEED (-1.0)

/* As the index of a run, this means the mean of the feeds sampled (D19). */
#define SITE_MEAN_FEED SIZE_MAX

/* One sampling at a rotor tip speed.  product.n is 0 where only the feed was
 * sampled.  product_sd: standard deviation of each product passing, 0..1, or
 * NULL. */
struct run {
	double speed;    /* m/s; 0: a feed for any speed, without product; or
			  * SITE_OTHER_FEED */
	char repeat[16]; /* " (2)" for the second run at a speed; else "" */
	size_t place;    /* position of its product among the columns read */
	bool lacks_feed; /* only its product was sampled: feed is a copy of
			  * the mean of those sampled (D19), or of the one */
	struct psd feed;
	struct psd product;
	double *product_sd;
};

/* A line of the sheet's heading that tipspeed does not use but keeps. */
struct site_note {
	char *key, *value;
};

/* Strings are never NULL; "" means that the sheet does not state it.  run[] is
 * in order of rising speed, repeats at one speed in the order of the sheet.
 * individual_feeds: each run has a feed sample of its own, but for those that
 * lack one; otherwise every run holds a copy of the one feed. */
enum { SITE_TEXTS = 10 };
struct site {
	/* named: sieves given by name, "#4 = 4.75".  read_as: how its columns
	 * were read; assumed: the part of that which the sheet does not state;
	 * both "" if it has the headings of tipspeed-site(5).  In a copy made
	 * for a question, the differences from what was sampled: feed_from, the
	 * source of the feed, and with, all differences in words, "feed b.csv,
	 * cascade 10 %"; else "".  path: of the file it was read from, or "".
	 */
	union {
		struct {
			char *name, *rock, *machine, *provenance, *named,
			    *read_as, *assumed, *feed_from, *with, *path;
		};
		char *text[SITE_TEXTS];
	};
	char *remark; /* on how its file was read, or ""; not copied */
	bool told;    /* by the user, what the file may not state; likewise */
	double top_size; /* m; 0 if not stated */
	double rotor;    /* diameter, m; 0 if not stated */
	bool individual_feeds;
	struct psd
	    mean_feed; /* of several feeds; site_update_digest_and_mean_feed */
	size_t n_run;
	struct run *run;
	size_t n_note;
	struct site_note *note;
	/* Parts of the sheet left out: where ("line 9"), what and why. */
	size_t n_left_out;
	struct site_note *left_out;
	/* In a copy made for a question.  run_rotor: diameter, m, of the rotor
	 * of the runs, if rotor is another that was asked about.  shown: sieves
	 * to show, m, coarsest first; if n_shown is 0, the site's own. */
	double run_rotor;
	size_t n_shown;
	double *shown;
	uint64_t digest; /* of the numbers: sizes, passings, speeds */
};

/* Returns an empty site with n_run runs. */
struct site *site_new(size_t n_run);
void site_free(struct site *site);

/* Returns a deep copy. */
struct site *site_copy(const struct site *site);

/* Returns a copy with another feed as its last run, which has no product.
 * from: the source of the feed; of: the provenance in its sheet.  The digest
 * does not change. */
struct site *site_copy_with_feed(const struct site *site,
    const struct psd *feed, const char *from, const char *of);

/* Returns a copy with the products of cuts added as runs, each after the site's
 * runs at that speed.  An added run keeps its own feed, if it has one;
 * otherwise it lacks one.  A product for a run with only a feed completes that
 * run.  from [runs of both]: out, for each run of the copy its index in the
 * site, or SIZE_MAX. */
struct site *site_copy_with_cuts(
    const struct site *site, const struct site *cuts, size_t *from);

/* Returns the diameter of the rotor that the runs were made with, m; 0 if it is
 * not stated. */
double site_run_rotor_diameter(const struct site *site);

/* Returns the digest of everything a calibration depends on. */
uint64_t site_digest(const struct site *site);

/* Computes the mean feed from the runs, gives it to those that lack a feed, and
 * computes the digest.  Call it after runs were made or changed. */
void site_update_digest_and_mean_feed(struct site *site);

/* True if the run's feed is one of those sampled: of one feed for all runs, if
 * it is the first run. */
bool site_run_has_feed_sample(const struct site *site, size_t run);

/* Returns the feed of a run.  For SITE_MEAN_FEED, returns the feed for a
 * question that names none: the feed of another sheet, if the site is a copy
 * with such a feed, or else the mean of the distinct feeds sampled
 * (blend_mean_of_feeds). */
const struct psd *site_feed_of_run(const struct site *site, size_t run);

/* Returns the largest difference in passing, 0..1, between two of the site's
 * feeds, or 0 if there is only one feed.  sieve: where it occurs, m, out. */
double site_largest_feed_difference(const struct site *site, double *sieve);

/* Returns the sieves of all feeds and products, m, coarsest first, each once:
 * [*n].  The caller frees it. */
double *site_all_sieves(const struct site *site, size_t *n);

/* Returns the finest sieve, m, that all feeds and products pass, or INFINITY if
 * there is none.  Coarser sieves show nothing, so means over sieves leave them
 * out. */
double site_finest_sieve_all_pass(const struct site *site);

/* Appends a note to a list of n. */
void site_add_note(
    struct site_note **list, size_t *n, const char *key, const char *value);

/* Returns the feed or the product of a run. */
struct psd *site_feed_or_product(
    const struct site *site, size_t run, bool feed);

/* Takes a note, or a run, out. */
void site_drop_note(struct site *site, size_t note);
void site_drop_run(struct site *site, size_t run);

/* Returns the number of runs with a product. */
size_t site_count_products(const struct site *site);

/* Returns the index of the run at the given speed (to 0.001 m/s), the first of
 * repeats, or n_run if there is none. */
size_t site_run_at_speed(const struct site *site, double speed);

/* Returns the number of different speeds of the runs in use [n_run]. */
size_t site_count_speeds(const struct site *site, const bool *use);

/* True if the run repeats the speed of the run before it. */
bool site_run_repeats_speed(const struct site *site, size_t run);

/* Returns the run with the nearest speed: the slower of two equally near, the
 * first of repeats. */
size_t site_run_nearest_speed(const struct site *site, double speed);

/* True if the run has a product and its speed is one of the `most` nearest
 * speeds with a product: repeats count as one speed. */
bool site_run_is_near_speed(
    const struct site *site, size_t run, double speed, size_t most);

/* The fastest tip speed allowed, m/s: rotors reach half of it, single particles
 * shot at a plate all of it. */
enum { SITE_FASTEST = 400 };

/* Computes the default range of speeds, m/s: the usual 65 to 85, widened by
 * whole m/s to cover the runs.  If all runs are slower than half or faster than
 * twice such speeds, it is another kind of machine, and the range is that of
 * the runs, widened at both ends by half its length, or at least a quarter of
 * the slowest speed.  site may be NULL. */
void site_default_speed_range(
    const struct site *site, double *from, double *to);

/* Returns the middle of the speeds measured, m/s, or 74 if there is only a
 * feed. */
double site_middle_speed(const struct site *site);

/* Returns the kind of data with that provenance: "reconstructed", "synthetic",
 * "made up" or "simulated" if it begins with that; "not stated" if it is that
 * or empty; "measured" for any other. */
const char *site_data_kind(const char *provenance);

/* The key of the header line for the size, mm, that all of the feed is assumed
 * to pass, because not all passes its coarsest sieve. */
#define SITE_ASSUMED_TOP "assumed_top_mm"

/* The key of the header line that lists the runs that lack a feed, "72, 74
 * (2)". */
#define SITE_CUTS_WITHOUT_FEED "cuts_without_feed"

/* Returns the size in that line, mm, or 0 if nothing was assumed. */
double site_assumed_top_size(const struct site *site);

/* True if the provenance says that the data were not measured at a plant. */
bool site_is_data_made_up(const char *provenance);

/* Returns the first clause of the provenance, or a copy of `none` if the sheet
 * does not state it.  The caller frees it. */
char *site_source_clause(const struct site *site, const char *none);

/* Adds the first clause of the site's provenance to a list "a; b", unless it is
 * there already. */
void sources_add_site(char **list, const struct site *site);

#endif
