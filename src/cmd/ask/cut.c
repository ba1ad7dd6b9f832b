/* Compares a cut with the band of one more sample at its speed: the sieves
 * inside it, the RMSE, and the sieve with the largest difference.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/cut.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/asked.h"
#include "core/search/misfit.h"
#include "io/sitefile/lexicon.h"
#include "io/sitefile/units.h"

/* Careful samples agree to within this, as a passing. */
static const double CAREFUL = 0.01;

/* Returns the passings of a run's product at the sieves that crushing can
 * change, [*n].  The caller frees them. */
static struct quantity *
sieves_that_crushing_changes(const struct run *r, size_t *n)
{
	size_t covered = misfit_count_covered_sieves(r);
	struct quantity *q = xcalloc(covered, sizeof *q);
	*n = 0;
	for (size_t i = 0; i < covered; i++)
		if (psd_passing(&r->feed, r->product.size[i]) < 1)
			q[(*n)++] = (struct quantity){
			    .kind = QUANTITY_PASSING, .x = r->product.size[i]};
	return q;
}

struct cut
cut_compare_with_prediction(
    const struct session *s, const struct entry *entry, size_t run)
{
	/* Half a tenth of a point: sheets are rounded to a tenth. */
	const double rounding = 5e-4;
	const struct run *r = &entry->site->run[run];
	const struct question q = question_of_whole_product(s, entry, run);
	struct cut c = {.no_band = true};
	FREED struct quantity *asked = sieves_that_crushing_changes(r, &c.n);
	struct forecast *f = forecast_open(s, &q, asked, c.n);
	double sum = 0;
	forecast_set_speed_and_ensemble(f, r->speed, ENSEMBLE_SAMPLE);
	for (size_t i = 0; i < c.n; i++) {
		struct figure at = forecast_value_with_band(f, i);
		double passing = psd_passing_at_sieve(&r->product, asked[i].x);
		double off = at.value - passing;
		sum += off * off;
		if (fabs(off) > fabs(c.worst)) {
			c.worst = off;
			c.worst_sieve = asked[i].x;
		}
		c.no_band = forecast_draws_of_quantity(f, i) == NULL;
		c.inside += passing >= at.low - rounding &&
			    passing <= at.high + rounding;
	}
	c.rms = c.n > 0 ? sqrt(sum / (double)c.n) : NAN;
	/* Errors at neighbouring sieves are alike, so half of the sieves may be
	 * outside by chance alone. */
	bool half = 2 * c.inside < c.n, some = 4 * c.inside < 3 * c.n;
	bool apart = c.rms > CAREFUL;
	c.missed = c.n > 0 && (c.no_band ? c.rms > FIT_POOR : half && apart);
	c.off = !c.missed && !c.no_band && (half || (some && apart));
	forecast_close(f);
	return c;
}

char *
cut_comparison_text(const struct cut *c)
{
	const double off = 100 * c->rms, worst = 100 * fabs(c->worst),
		     mm = units_m_to_mm(c->worst_sieve);
	if (c->no_band)
		return xasprintf(c->worst > 0
				     ? tr("RMSE %.1f points (%zu sieves), "
					  "largest error at %g mm, where the "
					  "model alone is %.1f above the cut")
				     : tr("RMSE %.1f points (%zu sieves), "
					  "largest error at %g mm, where the "
					  "model alone is %.1f below the cut"),
		    off, c->n, mm, worst);
	return xasprintf(
	    c->worst > 0 ? tr("%zu of %zu sieves are within the range for a "
			      "belt cut; RMSE %.1f points, largest error at %g "
			      "mm, where the answer is %.1f above the cut")
			 : tr("%zu of %zu sieves are within the range for a "
			      "belt cut; RMSE %.1f points, largest error at %g "
			      "mm, where the answer is %.1f below the cut"),
	    c->inside, c->n, off, mm, worst);
}

bool
cut_is_duplicate(const struct run *one, const struct run *two)
{
	const struct psd *a = &one->product, *b = &two->product;
	return one->speed == two->speed && a->n == b->n &&
	       memcmp(a->passing, b->passing, a->n * sizeof *a->passing) == 0;
}

static bool
is_note_of_cut(const struct site_note *note, double speed)
{
	double said;
	FREED char *number =
	    xstrndup(note->value, strspn(note->value, "0123456789."));
	return strcmp(note->key, "cut") == 0 &&
	       text_parse_number(number, &said) && fabs(said - speed) < 1e-3;
}

const struct site_note *
cut_find_note(const struct site *site, size_t run)
{
	double speed = site->run[run].speed;
	size_t after = 0;
	for (size_t r = run + 1; r < site->n_run; r++)
		after += fabs(site->run[r].speed - speed) < 1e-3 &&
			 site->run[r].product.n > 0;
	for (size_t i = site->n_note; i-- > 0;)
		if (is_note_of_cut(&site->note[i], speed) && after-- == 0)
			return &site->note[i];
	return NULL;
}

bool
cut_parse_date(const struct site_note *note, struct datetime *m)
{
	bool cut = strcmp(note->key, "cut") == 0;
	const char *at = cut ? strstr(note->value, ", ") : note->value;
	if (at == NULL || (!cut && !lexicon_is_date_label(note->key)))
		return false;
	at += cut ? strlen(", ") : 0;
	FREED char *text = xstrndup(at, cut ? strcspn(at, ",") : strlen(at));
	return datetime_parse(text, m) && m->has_date;
}

enum datetime_order
cut_day_month_order(const struct site *site)
{
	enum datetime_order order = DATETIME_OPEN;
	struct datetime m;
	for (size_t i = 0; i < site->n_note; i++) {
		if (!cut_parse_date(&site->note[i], &m) || m.plain ||
		    m.order == DATETIME_OPEN)
			continue;
		if (order != DATETIME_OPEN && order != m.order)
			return DATETIME_OPEN;
		order = m.order;
	}
	return order;
}

/* Returns how many runs of a site have the product and speed of this run. */
static size_t
count_runs_with_same_product(const struct site *site, const struct run *run)
{
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++)
		n += cut_is_duplicate(&site->run[r], run);
	return n;
}

struct later
cut_compare_runs_since_fit(const struct session *s, const struct entry *entry)
{
	const struct site *site = entry->site;
	struct history *h = entry->history;
	struct later later = {.site = site};
	if (!entry->has_fit || h == NULL || h->site->digest == site->digest)
		return later;
	if (h->later.site == site)
		return h->later;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (misfit_count_covered_sieves(run) == 0)
			continue;
		size_t known = count_runs_with_same_product(h->site, run);
		later.twice = later.twice || count_runs_with_same_product(site,
						 run) > (known > 0 ? known : 1);
		if (known > 0)
			continue;
		struct cut c = cut_compare_with_prediction(s, entry, r);
		bool worse =
		    c.missed == later.missed ? c.rms > later.rms : c.missed;
		if (later.n++ > 0 && !worse)
			continue;
		later.rms = c.rms;
		later.missed = c.missed;
		later.off = c.off;
		later.speed = run->speed;
	}
	h->later = later;
	return later;
}

bool
cut_is_only_product(const struct entry *entry, size_t *run)
{
	const struct site *site = entry->site;
	if (!entry->has_params || !origin_is_other_site(entry) ||
	    site_count_products(site) != 1)
		return false;
	for (*run = 0; site->run[*run].product.n == 0;)
		++*run;
	return misfit_count_covered_sieves(&site->run[*run]) > 0;
}
