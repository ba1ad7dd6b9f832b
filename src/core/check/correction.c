/* Changes one column or cell of a copy of a site, checks that the result is a
 * valid site, and notes the change in its provenance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/correction.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"

/* Returns the index of the mend's sieve, or n if there is none.  Sizes need to
 * agree only to the digits that site files have. */
static size_t
index_of_mended_sieve(const struct psd *psd, double size)
{
	size_t i = 0;
	while (i < psd->n && fabs(psd->size[i] / size - 1) > 1e-6)
		i++;
	return i;
}

/* ---- Words ---- */

char *
mend_name_of_column(const struct site *site, bool feed, size_t run)
{
	const struct run *r = &site->run[run];
	const char *repeat = r->repeat;
	if (feed && (!site->individual_feeds || !(r->speed > 0)))
		return xstrdup(tr("feed"));
	return xasprintf("%s@%g%s", feed ? tr("feed") : "product", r->speed,
	    repeat + (repeat[0] == ' '));
}

bool
mend_find_column_by_name(
    const struct site *site, const char *name, bool *feed, size_t *run)
{
	for (size_t i = 0; i < 2 * site->n_run; i++) {
		*feed = i % 2 == 0;
		*run = i / 2;
		const struct run *r = &site->run[*run];
		FREED char *own = mend_name_of_column(site, *feed, *run);
		bool same = strcmp(own, name) == 0;
		if (same && (*feed ? site_run_has_feed_sample(site, *run)
				   : r->product.n > 0))
			return true;
	}
	return false;
}

/* Returns a passing in per cent, with as many digits as were typed. */
static char *
passing_percent_text(double passing)
{
	return xasprintf("%.6g", 100 * passing);
}

static char *
cell_mend_description(
    const struct site *site, const struct mend *m, const char *name)
{
	const struct psd *psd = site_feed_or_product(site, m->run, m->feed);
	size_t i = index_of_mended_sieve(psd, m->size);
	FREED char *was =
	    passing_percent_text(i < psd->n ? psd->passing[i] : NAN);
	FREED char *now = passing_percent_text(m->value);
	return xasprintf(tr("%s at %g mm: %s %s%s"), name, 1000 * m->size, was,
	    m->kind == MEND_READ ? tr("read as ") : tr("left out"),
	    m->kind == MEND_READ ? now : "");
}

char *
mend_description(const struct site *site, const struct mend *m)
{
	FREED char *name = mend_name_of_column(site, m->feed, m->run);
	FREED char *with = m->kind == MEND_SWAP_FEED
			       ? mend_name_of_column(site, true, m->run)
			       : mend_name_of_column(site, false, m->other);
	switch (m->kind) {
	case MEND_READ:
	case MEND_OUT:
		return cell_mend_description(site, m, name);
	case MEND_SWAP_FEED:
	case MEND_SWAP_RUNS:
		return xasprintf(tr("%s and %s exchanged"), name, with);
	case MEND_UP:
	case MEND_DOWN:
		return xasprintf(tr("%s moved to the next %s sieve"), name,
		    m->kind == MEND_UP ? tr("coarser") : tr("finer"));
	case MEND_SCALE:
		return xasprintf(
		    tr("sieve sizes of %s times %g"), name, m->value);
	case MEND_DROP:
		break;
	}
	return xasprintf(tr("%s left out"), name);
}

/* ---- Mending ---- */

static void
drop_sieve_of_curve(struct run *run, struct psd *psd, size_t i)
{
	size_t after = psd->n - i - 1;
	memmove(psd->size + i, psd->size + i + 1, after * sizeof *psd->size);
	memmove(psd->passing + i, psd->passing + i + 1,
	    after * sizeof *psd->passing);
	if (psd == &run->product && run->product_sd != NULL)
		memmove(run->product_sd + i, run->product_sd + i + 1,
		    after * sizeof *run->product_sd);
	psd->n--;
}

static void
swap_curves(struct psd *a, struct psd *b)
{
	struct psd was = *a;
	*a = *b;
	*b = was;
}

/* Moves each passing to the next coarser or finer sieve of the site.  If there
 * is no such sieve, the passing is left out. */
static void
shift_column_by_a_sieve(
    const struct site *site, struct run *run, struct psd *psd, bool up)
{
	size_t n;
	FREED double *size = site_all_sieves(site, &n);
	for (size_t i = psd->n; i-- > 0;) {
		size_t k = 0;
		while (k < n && size[k] != psd->size[i])
			k++;
		if (up ? k == 0 : k + 1 >= n)
			drop_sieve_of_curve(run, psd, i);
		else
			psd->size[i] = size[up ? k - 1 : k + 1];
	}
}

static void
apply_mend_to_column(
    const struct site *from, struct run *run, const struct mend *m)
{
	struct psd *psd = m->feed ? &run->feed : &run->product;
	size_t i = index_of_mended_sieve(psd, m->size);
	switch (m->kind) {
	case MEND_READ:
		psd->passing[i] = m->value;
		break;
	case MEND_OUT:
		drop_sieve_of_curve(run, psd, i);
		break;
	case MEND_UP:
	case MEND_DOWN:
		shift_column_by_a_sieve(from, run, psd, m->kind == MEND_UP);
		break;
	case MEND_SCALE:
		for (i = 0; i < psd->n; i++)
			psd->size[i] *= m->value;
		break;
	default:
		break;
	}
}

static void
remove_product_sd_of_run(struct run *run)
{
	free(run->product_sd);
	run->product_sd = NULL;
}

/* If all runs share the feed, all of them get the new one. */
static void
swap_feed_with_product(struct site *site, size_t at)
{
	struct run *run = &site->run[at];
	swap_curves(&run->feed, &run->product);
	run->lacks_feed = false;
	remove_product_sd_of_run(run);
	for (size_t r = 0; r < site->n_run && !site->individual_feeds; r++) {
		if (r == at)
			continue;
		psd_free(&site->run[r].feed);
		site->run[r].feed = psd_copy(&run->feed);
	}
}

/* True if sizes fall, passings do not rise, and all of a feed passes its
 * coarsest sieve. */
static bool
is_valid_curve(const struct psd *psd, bool feed)
{
	bool ok = psd->n >= 2 && (!feed || psd->passing[0] == 1);
	for (size_t i = 0; i < psd->n; i++)
		ok = ok && psd->passing[i] >= 0 && psd->passing[i] <= 1 &&
		     (i == 0 || (psd->size[i] < psd->size[i - 1] &&
				    psd->passing[i] <= psd->passing[i - 1]));
	return ok;
}

static bool
are_site_curves_valid(const struct site *site)
{
	bool ok = site->n_run > 0;
	for (size_t r = 0; r < site->n_run; r++)
		ok = ok && is_valid_curve(&site->run[r].feed, true) &&
		     (site->run[r].product.n == 0 ||
			 is_valid_curve(&site->run[r].product, false));
	return ok;
}

/* Adds to the first clause, which results show, that there are mends, and
 * appends this mend at the end. */
static void
add_mend_to_provenance(
    struct site *site, const struct site *from, const struct mend *mend)
{
	static const char mark[] = ", mended";
	const char *was =
	    from->provenance[0] != '\0' ? from->provenance : "not stated";
	size_t n = strcspn(was, ";"), m = strlen(mark);
	bool marked = n >= m && strncmp(was + n - m, mark, m) == 0;
	FREED char *words = mend_description(from, mend);
	FREED char *first = xstrndup(was, n);
	free(site->provenance);
	site->provenance = xasprintf(
	    "%s%s%s; mended: %s", first, marked ? "" : mark, was + n, words);
}

static void
apply_mend(struct site *site, const struct site *from, const struct mend *m)
{
	bool all = m->feed && !site->individual_feeds;
	if (m->kind == MEND_SWAP_FEED) {
		swap_feed_with_product(site, m->run);
	} else if (m->kind == MEND_SWAP_RUNS) {
		swap_curves(
		    &site->run[m->run].product, &site->run[m->other].product);
		remove_product_sd_of_run(&site->run[m->run]);
		remove_product_sd_of_run(&site->run[m->other]);
	} else if (m->kind == MEND_DROP) {
		site_drop_run(site, m->run);
	} else {
		for (size_t r = 0; r < site->n_run; r++)
			if (all || r == m->run)
				apply_mend_to_column(from, &site->run[r], m);
	}
}

struct site *
site_with_mend(
    const struct site *from, const struct mend *mend, struct error *error)
{
	const struct psd *psd =
	    site_feed_or_product(from, mend->run, mend->feed);
	bool cell = mend->kind == MEND_READ || mend->kind == MEND_OUT;
	if (cell && index_of_mended_sieve(psd, mend->size) == psd->n) {
		error_set(error, ERROR_USAGE,
		    "the column has no sieve of %g mm\nuse one of its sieves: "
		    "see 'show product', 'show feed'",
		    1000 * mend->size);
		return NULL;
	}
	struct site *site = site_copy(from);
	apply_mend(site, from, mend);
	if (are_site_curves_valid(site)) {
		add_mend_to_provenance(site, from, mend);
		site_update_digest_and_mean_feed(site);
		return site;
	}
	site_free(site);
	error_set(error, ERROR_USAGE,
	    "the mend would make a curve invalid\npassing must not rise on a "
	    "finer sieve, all of a feed must pass its coarsest sieve, and two "
	    "sieves must be left");
	return NULL;
}
