/* Computes a fraction of a measured product by the partition curve
 * (core/psd/screening.h), and its share of the product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/screened.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/quantity_words.h"
#include "io/sitefile/units.h"

/* Returns false with an error if all of the feed passes the finer of two ideal
 * screens: crushing makes nothing coarser, so the fraction is empty. */
static bool
check_feed_coarse_enough_for_fraction(const struct fraction *fraction,
    const struct psd *feed, struct error *error)
{
	double edge = fraction->fine * fraction->partition.cut_size;
	if (fraction->fine <= 0 || fraction->partition.sharpness > 0 ||
	    psd_passing(feed, edge) < 1)
		return true;
	return error_set(error, ERROR_USAGE,
	    "no product in %g/%g: all of the feed passes %g mm\n"
	    "use a fraction whose finer screen is below that",
	    units_m_to_mm(fraction->fine), units_m_to_mm(fraction->coarse),
	    units_m_to_mm(edge));
}

bool
screened_check_feed_covers(const struct question *q, struct error *error)
{
	const struct psd *feed = site_feed_of_run(q->entry->site, q->feed);
	struct quantity share = {
	    .kind = QUANTITY_SHARE, .fraction = q->fraction};
	return quantities_check_feed_covers(&share, feed, error) &&
	       check_feed_coarse_enough_for_fraction(&q->fraction, feed, error);
}

/* Returns the fraction, and its share of the product in *share. */
static struct psd
fraction_and_share_of_product(
    const struct psd *product, const struct fraction *fraction, double *share)
{
	*share = 1;
	if (!fraction_is_screened(fraction))
		return psd_copy(product);
	struct psd whole = psd_new(product->n + 2);
	memcpy(whole.size, product->size, product->n * sizeof *product->size);
	whole.size[product->n] = fraction->coarse;
	whole.size[product->n + 1] =
	    fraction->fine > 0 ? fraction->fine : fraction->coarse;
	whole.n = psd_sort_distinct_sizes(whole.size, whole.n, 1e-12);
	for (size_t i = 0; i < whole.n; i++)
		whole.passing[i] = psd_passing(product, whole.size[i]);
	struct psd part = psd_copy(&whole);
	FREED double *kept = xcalloc_doubles(whole.n);
	fraction_share_of_each_class(fraction, whole.size, whole.n, kept);
	*share = screening_compute_kept_part(&whole, kept, &part);
	psd_free(&whole);
	return part;
}

struct psd
screened_fraction_of_product(
    const struct psd *product, const struct fraction *fraction)
{
	double share;
	return fraction_and_share_of_product(product, fraction, &share);
}

double *
screened_feed_passings(const struct prediction *p)
{
	struct psd feed = screened_fraction_of_product(&p->feed, &p->fraction);
	double *passing = xcalloc_doubles(p->product.n);
	for (size_t i = 0; i < p->product.n; i++)
		passing[i] = psd_passing(&feed, p->product.size[i]);
	psd_free(&feed);
	return passing;
}

double
screened_quantity_of_product(
    const struct psd *product, const struct quantity *q)
{
	double point[QUANTITY_POINTS], share;
	size_t n = quantity_sizes_needed(q, point);
	for (size_t i = 0; i < n; i++)
		if (!psd_covers_size(product, point[i]))
			return NAN;
	struct psd part =
	    fraction_and_share_of_product(product, &q->fraction, &share);
	double value = quantity_read_off_curve(q, &part, share);
	psd_free(&part);
	return value;
}

char *
screened_fraction_title_suffix(const struct fraction *fraction)
{
	if (!fraction_is_screened(fraction))
		return xstrdup("");
	FREED char *words = quantities_fraction_text(fraction);
	return xasprintf(tr(", fraction %s"), words);
}

void
screened_note_share(struct answer *r, const struct prediction *p)
{
	const struct partition *screen = &p->fraction.partition;
	if (!fraction_is_screened(&p->fraction))
		return;
	FREED char *words = quantities_fraction_text(&p->fraction);
	FREED char *range =
	    quantities_band_text(units_fraction_to_pct(p->share_range[0]),
		units_fraction_to_pct(p->share_range[1]), 1);
	FREED char *how =
	    screen->sharpness > 0
		? xasprintf(tr("screens of sharpness %g, cut size %g %% "
			       "of the opening"),
		      screen->sharpness, 100 * screen->cut_size)
	    : screen->cut_size != 1
		? xasprintf(tr("ideal screens, cut size %g %% of the opening"),
		      100 * screen->cut_size)
		: xstrdup(tr("ideal screens"));
	answer_note(r, "%s is %.1f %%%s of the product; %s", words,
	    units_fraction_to_pct(p->share), range, how);
}

void
screened_put_fraction_fields(struct fields *o, const struct prediction *p)
{
	if (!fraction_is_screened(&p->fraction))
		return;
	FREED char *words = quantities_fraction_text(&p->fraction);
	fields_put_values(o,
	    "fraction %s share_pct %g share_low_pct %g share_high_pct %g "
	    "sharpness %g cut_size_pct %g",
	    words, units_fraction_to_pct(p->share),
	    units_fraction_to_pct(p->share_range[0]),
	    units_fraction_to_pct(p->share_range[1]),
	    p->fraction.partition.sharpness > 0
		? p->fraction.partition.sharpness
		: NAN,
	    100 * p->fraction.partition.cut_size);
}
