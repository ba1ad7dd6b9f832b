/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/screened.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "io/sitefile/units.h"

/* Crushing makes nothing coarser: where all of the feed passes the finer of
 * ideal screens, so does the product. */
static bool
check_any(const struct fraction *fraction, const struct psd *feed,
    struct error *error)
{
	double edge = fraction->fine * fraction->partition.cut_size;
	if (fraction->fine <= 0 || fraction->partition.sharpness > 0 ||
	    psd_passing(feed, edge) < 1)
		return true;
	return error_set(error, ERROR_USAGE,
	    "no product in %g/%g: all of the feed passes %g mm\n"
	    "use a fraction whose finer screen is below that",
	    units_mm(fraction->fine), units_mm(fraction->coarse),
	    units_mm(edge));
}

/* What is read off: the share, the passing of each sieve, then the sizes. */
static struct quantity *
asked_of(const struct fraction *fraction, const struct psd *sieves)
{
	struct quantity *asked =
			    xcalloc(sieves->n + 1 + PSD_SIZES, sizeof *asked),
			*q = asked;
	*q++ = (struct quantity){.kind = QUANTITY_SHARE};
	for (size_t i = 0; i < sieves->n; i++)
		*q++ = (struct quantity){
		    .kind = QUANTITY_PASSING, .x = sieves->size[i]};
	for (size_t i = 0; i < PSD_SIZES; i++)
		*q++ = (struct quantity){
		    .kind = QUANTITY_SIZE, .x = PSD_PASSING[i]};
	while (q-- > asked)
		q->fraction = *fraction;
	return asked;
}

static void
read_response(struct prediction *p, struct response *r, double level)
{
	size_t n = p->product.n;
	p->share = response_value(r, 0);
	response_band(r, 0, level, p->share_range);
	for (size_t i = 0; i < n; i++) {
		double range[2];
		p->product.passing[i] = response_value(r, i + 1);
		p->model[i] = response_model(r, i + 1);
		response_band(r, i + 1, level, range);
		if (p->low == NULL)
			continue;
		p->low[i] = range[0];
		p->high[i] = range[1];
	}
	for (size_t i = 0; i < PSD_SIZES; i++) {
		p->size[i] = response_value(r, n + 1 + i);
		response_band(r, n + 1 + i, level, p->range[i]);
	}
	psd_free(&p->curve);
	p->curve = response_part(r, 0);
}

bool
screened_predict(const struct session *s, const struct entry *entry,
    const struct params *params, const struct fraction *fraction, double speed,
    size_t feed_run, struct prediction *p, struct error *error)
{
	const struct psd *feed = site_feed(entry->site, feed_run);
	struct quantity share = {.kind = QUANTITY_SHARE, .fraction = *fraction};
	if (!quantities_covered(&share, feed, error) ||
	    !check_any(fraction, feed, error))
		return false;
	*p = outlook_form(s, entry, params, speed, feed_run);
	if (!fraction_screens(fraction))
		return true;
	struct quantity *asked = asked_of(fraction, &p->product);
	struct response *r = outlook_reader(
	    s, entry, params, feed_run, asked, p->product.n + 1 + PSD_SIZES);
	outlook_read_at(s, entry, params, feed_run, r, speed);
	read_response(p, r, settings_level(&s->set));
	p->fraction = *fraction;
	response_free(r);
	free(asked);
	return true;
}

/* share: of the product that the part is. */
static struct psd
measured_part(
    const struct psd *product, const struct fraction *fraction, double *share)
{
	*share = 1;
	if (!fraction_screens(fraction))
		return psd_copy(product);
	struct psd whole = psd_new(product->n + 2);
	memcpy(whole.size, product->size, product->n * sizeof *product->size);
	whole.size[product->n] = fraction->coarse;
	whole.size[product->n + 1] =
	    fraction->fine > 0 ? fraction->fine : fraction->coarse;
	whole.n = psd_sort(whole.size, whole.n, 1e-12);
	for (size_t i = 0; i < whole.n; i++)
		whole.passing[i] = psd_passing(product, whole.size[i]);
	struct psd part = psd_copy(&whole);
	double *kept = xdoubles(whole.n);
	fraction_classes(fraction, whole.size, whole.n, kept);
	*share = screening_part(&whole, kept, &part);
	free(kept);
	psd_free(&whole);
	return part;
}

struct psd
screened_measured(const struct psd *product, const struct fraction *fraction)
{
	double share;
	return measured_part(product, fraction, &share);
}

double
screened_value(const struct psd *product, const struct quantity *q)
{
	double point[QUANTITY_POINTS], share;
	size_t n = quantity_points(q, point);
	for (size_t i = 0; i < n; i++)
		if (!psd_covers(product, point[i]))
			return NAN;
	struct psd part = measured_part(product, &q->fraction, &share);
	double value = quantity_read(q, &part, share);
	psd_free(&part);
	return value;
}

char *
screened_title(const struct prediction *p)
{
	if (!fraction_screens(&p->fraction))
		return xstrdup("");
	char *words = quantities_fraction_words(&p->fraction);
	char *title = xasprintf(tr(", fraction %s"), words);
	free(words);
	return title;
}

void
screened_note(struct answer *r, const struct prediction *p)
{
	const struct partition *screen = &p->fraction.partition;
	if (!fraction_screens(&p->fraction))
		return;
	char *words = quantities_fraction_words(&p->fraction);
	char *range = quantities_band(
	    units_pct(p->share_range[0]), units_pct(p->share_range[1]), 1);
	char *how =
	    screen->sharpness > 0
		? xasprintf(tr("screens of sharpness %g, cut size %g %% "
			       "of the opening"),
		      screen->sharpness, 100 * screen->cut_size)
	    : screen->cut_size != 1
		? xasprintf(tr("ideal screens, cut size %g %% of the "
			       "opening"),
		      100 * screen->cut_size)
		: xstrdup(tr("ideal screens"));
	answer_note(r, "%s is %.1f %%%s of the product; %s", words,
	    units_pct(p->share), range, how);
	free(how);
	free(range);
	free(words);
}

void
screened_put(struct fields *o, const struct prediction *p)
{
	if (!fraction_screens(&p->fraction))
		return;
	char *words = quantities_fraction_words(&p->fraction);
	fields_put(o,
	    "fraction %s share_pct %g share_low_pct %g share_high_pct %g "
	    "sharpness %g cut_size_pct %g",
	    words, units_pct(p->share), units_pct(p->share_range[0]),
	    units_pct(p->share_range[1]),
	    p->fraction.partition.sharpness > 0
		? p->fraction.partition.sharpness
		: NAN,
	    100 * p->fraction.partition.cut_size);
	free(words);
}
