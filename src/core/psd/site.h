/* A site: the runs of one quarry's crusher, each with feed and product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SITE_H
#define TIPSPEED_CORE_PSD_SITE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/psd/psd.h"

/* The speed of a run that only holds a feed from another sheet: the last run of
 * a copy made by site_copy_with_feed has it. */
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
	bool lacks_feed; /* feed was not sampled: a copy of the mean of the
			  * others' (D19), or of the only one */
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
 * individual_feeds: each run has its own feed sample, except those that lack
 * one; otherwise every run holds a copy of the only feed. */
enum { SITE_TEXTS = 11 };
struct site {
	/* named: sieves given by name, "#4 = 4.75".  read_as: how the columns
	 * were read; assumed: what of this the sheet does not state; both are
	 * "" if the sheet has the headings of tipspeed-site(5).  feed_from and
	 * with describe how a copy made for a question differs from what was
	 * sampled, else they are "": feed_from is the source of its feed; with
	 * has all differences in words, "feed b.csv, cascade 10 %".  path: the
	 * file that was read, or ""; part: the sheet and the range of it that
	 * were chosen, or "" for all. */
	union {
		struct {
			char *name, *rock, *machine, *provenance, *named,
			    *read_as, *assumed, *feed_from, *with, *path, *part;
		};
		char *text[SITE_TEXTS];
	};
	char *remark;    /* on how its file was read, or ""; not copied */
	bool told;       /* the user added what the file may not state; not
		       * copied */
	double top_size; /* m; 0 if not stated */
	double rotor;    /* diameter, m; 0 if not stated */
	bool individual_feeds;
	struct psd mean_feed; /* of individual feeds, else empty */
	size_t n_run;
	struct run *run;
	size_t n_note;
	struct site_note *note;
	/* Parts of the sheet left out: where ("line 9"), what and why. */
	size_t n_left_out;
	struct site_note *left_out;
	/* Set in a copy made for a question.  run_rotor: diameter, m, of the
	 * rotor that made the runs, if the question is about another rotor.
	 * shown: sieves to show, m, coarsest first; if n_shown is 0, the site's
	 * own. */
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
 * from: the source of the feed; of: the provenance that its sheet states.  The
 * digest does not change. */
struct site *site_copy_with_feed(const struct site *site,
    const struct psd *feed, const char *from, const char *of);

/* Returns a copy with the products of cuts added as runs, each after the site's
 * runs at that speed.  An added run keeps its own feed, if it has one;
 * otherwise it lacks one.  If the site has a run with only a feed at that
 * speed, the product completes that run.  Sets from [runs of both] to each
 * run's index in the original site, or SIZE_MAX for an added run. */
struct site *site_copy_with_cuts(
    const struct site *site, const struct site *cuts, size_t *from);

/* Returns the diameter of the rotor that the runs were made with, m; 0 if it is
 * not stated. */
double site_run_rotor_diameter(const struct site *site);

/* Returns the digest of everything a calibration depends on. */
uint64_t site_digest(const struct site *site);

/* Computes the mean feed of the runs, gives it to the runs that lack a feed,
 * and computes the digest.  Call it after making or changing runs. */
void site_update_digest_and_mean_feed(struct site *site);

/* True if the run's feed is a sample of its own; if there is one feed for all
 * runs, it counts as the first run's. */
bool site_run_has_feed_sample(const struct site *site, size_t run);

/* Returns the feed of a run.  For SITE_MEAN_FEED, returns the feed for a
 * question that names none: the feed of another sheet, if the site is a copy
 * with such a feed, or else the mean of the distinct feeds sampled
 * (blend_mean_of_feeds). */
const struct psd *site_feed_of_run(const struct site *site, size_t run);

/* Returns the largest difference in passing, 0..1, between two of the site's
 * feeds, or 0 if there is only one feed.  Sets *sieve to where it occurs, m. */
double site_largest_difference_of_feeds(const struct site *site, double *sieve);

/* Returns the *n sieves of all feeds and products, m, coarsest first, each
 * once.  The caller frees it. */
double *site_all_sieves(const struct site *site, size_t *n);

/* Returns the finest sieve, m, that all feeds and products pass, or INFINITY if
 * there is none.  Coarser sieves show nothing, so means over sieves leave them
 * out. */
double site_finest_sieve_all_pass(const struct site *site);

/* Appends a note to a list of n. */
void site_notes_append(
    struct site_note **list, size_t *n, const char *key, const char *value);

struct psd *site_feed_or_product(
    const struct site *site, size_t run, bool feed);

/* Remove a note or a run. */
void site_drop_note(struct site *site, size_t note);
void site_drop_run(struct site *site, size_t run);

size_t site_count_products(const struct site *site);

/* Returns the index of the run at the given speed (to 0.001 m/s), the first of
 * repeats, or n_run if there is none. */
size_t site_run_at_speed(const struct site *site, double speed);

/* Returns the tip speed, m/s, of a rotor at rpm: that of a run with the same
 * whole number of rpm, as speeds are shown; else as rotor_speed_from_rpm. */
double site_speed_from_rpm(
    const struct site *site, double rpm, double diameter);

/* Returns the number of different speeds of the runs in use [n_run]. */
size_t site_count_speeds(const struct site *site, const bool *use);

/* True if the run repeats the speed of the run before it. */
bool site_run_repeats_speed(const struct site *site, size_t run);

/* True if the run has a product and its speed is one of the `most` nearest
 * speeds with a product: repeats count as one speed. */
bool site_run_is_among_nearest(
    const struct site *site, size_t run, double speed, size_t most);

/* The fastest tip speed allowed, m/s: rotors reach half of this, single
 * particles shot at a plate all of it. */
enum { SITE_FASTEST = 400 };

/* Computes the default range of speeds, m/s: the usual 65 to 85, widened by
 * whole m/s to cover the runs.  If all runs are slower than half of 65 or
 * faster than twice 85 m/s, this is another kind of machine, and the range is
 * that of the runs, widened at both ends by half its length, or at least a
 * quarter of the slowest speed.  site may be NULL. */
void site_default_speed_range(
    const struct site *site, double *from, double *to);

/* Returns the middle of the speeds measured, m/s, or 74 if there is only a
 * feed. */
double site_middle_speed(const struct site *site);

/* Returns the kind of data, from the beginning of the provenance:
 * "reconstructed", "synthetic", "made up" or "simulated" if it begins with
 * these words; "not stated" if it is empty or begins with "not stated" or
 * "sheet of"; else "measured". */
const char *site_data_kind(const char *provenance);

/* The key of the header line for the size, mm, that all of the feed is assumed
 * to pass because some of it stays on the coarsest sieve. */
#define SITE_ASSUMED_TOP "assumed_top_mm"

/* The key of the header line that lists the runs that lack a feed, "72, 74
 * (2)". */
#define SITE_CUTS_WITHOUT_FEED "cuts_without_feed"

/* Returns the size in that line, mm, or 0 if nothing was assumed. */
double site_assumed_top_size(const struct site *site);

/* True if the provenance says that the data were not measured at a plant. */
bool site_is_data_made_up(const char *provenance);

/* Returns a provenance as people are shown it: "sheet of 2026-05-03, cuts to
 * 2026-05-10", which are the program's own words, in the language of texts, any
 * other as it is.  The caller frees it. */
char *site_translate_provenance(const char *provenance);

/* Returns the first clause of the provenance, or a copy of `none` if the sheet
 * does not state it.  The caller frees it. */
char *site_provenance_first_clause(const struct site *site, const char *none);

/* The sources of the data of several sites, each once: [n] clauses, and the
 * names of the sites that have each of them. */
struct sources {
	size_t n;
	char **clause, **names;
};

/* sources_add adds the source of a site; sources_add_site that of its sheet. */
void sources_add(struct sources *sources, const char *name, const char *clause);
void sources_add_site(
    struct sources *sources, const char *name, const struct site *site);

/* Returns the sources, "belt cuts of 3 May (Norrberg), made up (Lane, Hill)";
 * a single one without the names of its sites.  Frees the members.  The caller
 * frees the text. */
char *sources_text_and_clear(struct sources *sources);

#endif
