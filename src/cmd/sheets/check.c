/* check: looks for faults in site files, and only reports them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/check.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/sites.h"
#include "cmd/sheets/mend.h"
#include "cmd/lang/table.h"
#include "core/check/trust.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"
#include "io/sitefile/units.h"

/* A product that is coarser than its feed by more than this, passing 0..1, is a
 * fault: sampling error does not explain it. */
static const double COARSER_FAULT = 0.02;

/* Two passings rounded to one decimal, %, can differ by this; the 1e-9 is for
 * binary fractions. */
static const double ROUNDING = 0.001 + 1e-9;

/* How a run's product is coarser than its feed: the number of such sieves, the
 * number of sieves compared, and the largest excess. */
struct coarser {
	size_t sieves, compared;
	double most, at; /* passing, 0..1; m */
	double farthest; /* largest difference of either sign */
};

static struct coarser
find_where_product_is_coarser(const struct run *run)
{
	struct coarser found = {0};
	found.compared = misfit_count_covered_sieves(run);
	for (size_t i = 0; i < found.compared; i++) {
		double x = run->product.size[i];
		double by =
		    psd_passing(&run->feed, x) - run->product.passing[i];
		found.farthest = fmax(found.farthest, fabs(by));
		if (by <= ROUNDING)
			continue;
		found.sieves++;
		if (by > found.most) {
			found.most = by;
			found.at = x;
		}
	}
	return found;
}

void
check_warn_coarser_product(struct session *s, const struct site *site)
{
	bool none_finer = trust_are_products_like_feed(site);
	for (size_t r = 0; r < site->n_run; r++) {
		struct coarser c = find_where_product_is_coarser(&site->run[r]);
		FREED char *rpm =
		    rotor_speed_rpm_text(site->rotor, site->run[r].speed, NAN);
		if (c.most > (none_finer ? COARSER_FAULT : 0))
			session_print_note(s,
			    "  at %g m/s%s%s the product is coarser than the "
			    "feed on %zu of %zu sieves, by up to %.2f points "
			    "at %g mm: run 'check'",
			    site->run[r].speed, site->run[r].repeat, rpm,
			    c.sieves, c.compared, 100 * c.most,
			    units_m_to_mm(c.at));
	}
}

/* Adds a finding: a fault, which makes check fail, or a remark. */
static void __attribute__((format(printf, 5, 6)))
finding(struct answer *r, const struct entry *entry, bool fault,
    const char *where, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *text = xvasprintf(tr(format), ap);
	va_end(ap);
	answer_add_cells(r, "%s %s %s %s", entry->key,
	    fault ? tr("FAULT") : tr("remark"), where, text);
}

/* Returns where a finding is: "69 m/s", "1500 rpm", or "feed" if run is NULL or
 * has no speed. */
static const char *
feed_or_speed_text(
    const struct site *site, const struct run *run, char buf[static 40])
{
	if (run == NULL || !(run->speed > 0))
		return tr("feed");
	FREED char *speed = answers_speed_text(site, run->speed, -1);
	snprintf(buf, 40, "%s%s", speed, run->repeat);
	return buf;
}

static bool
check_product_against_feed(
    struct answer *r, const struct entry *entry, const struct run *run)
{
	struct coarser c = find_where_product_is_coarser(run);
	char buf[40];
	const char *where = feed_or_speed_text(entry->site, run, buf);
	bool fault = c.most > COARSER_FAULT;
	if (c.sieves > 0)
		finding(r, entry, fault, where,
		    fault ? N_("product coarser than feed on %zu of %zu "
			       "sieves, by up to %.2f points at %g mm: "
			       "crushing cannot coarsen: were the samples "
			       "mixed up?")
			  : N_("product coarser than feed on %zu of %zu "
			       "sieves, by up to %.2f points at %g mm: "
			       "crushing cannot coarsen; sampling error may "
			       "explain it"),
		    c.sieves, c.compared, 100 * c.most, units_m_to_mm(c.at));
	if (run->product.n > 0 && c.farthest < SAMPLES_AGREE)
		finding(r, entry, false, where,
		    "product equals feed within %.2f points: nothing "
		    "measurable breaks at this speed; is it the right feed?",
		    100 * c.farthest);
	if (run->product.n > c.compared)
		finding(r, entry, false, where,
		    "the product's sieves of %g mm and finer are not compared: "
		    "the feed was not sieved so fine",
		    units_m_to_mm(run->product.size[c.compared]));
	if (run->product.n == 0)
		finding(r, entry, false, where,
		    "a feed without a product: used for predictions only");
	return !fault;
}

/* Returns "69, 79 m/s" or "69 (1), 69 (2) m/s".  The caller frees it. */
static char *
two_run_speeds_text(
    const struct site *site, const struct run *a, const struct run *b)
{
	return xasprintf("%g%s, %g%s %s",
	    answers_speed_in_sheet_unit(site, a->speed), a->repeat,
	    answers_speed_in_sheet_unit(site, b->speed), b->repeat,
	    answers_speed_unit(site));
}

/* Reports columns that were entered twice, because no two samples have the same
 * numbers. */
static void
report_columns_entered_twice(struct answer *r, const struct entry *entry)
{
	const struct site *site = entry->site;
	for (size_t i = 1; i < site->n_run; i++)
		for (size_t k = 0; k < i; k++) {
			const struct run *a = &site->run[k], *b = &site->run[i];
			if (!psd_is_same(&a->product, &b->product))
				continue;
			FREED char *where =
			    two_run_speeds_text(entry->site, a, b);
			finding(r, entry, false, where,
			    "the two products have identical numbers: was a "
			    "column copied?");
		}
}

/* Reports repeats that differ by more than two samples from one belt do. */
static void
check_repeated_runs_agree(struct answer *r, const struct entry *entry)
{
	const double far = 0.05;
	const struct site *site = entry->site;
	for (size_t i = 1; i < site->n_run; i++)
		for (size_t k = i; site_run_repeats_speed(site, k); k--) {
			const struct run *a = &site->run[k - 1];
			const struct run *b = &site->run[i];
			struct passing_order fall =
			    trust_compare_slow_fast_products(
				&a->product, &b->product);
			struct passing_order rise =
			    trust_compare_slow_fast_products(
				&b->product, &a->product);
			if (rise.most > fall.most)
				fall = rise;
			if (fall.most <= far)
				continue;
			FREED char *where =
			    two_run_speeds_text(entry->site, a, b);
			finding(r, entry, false, where,
			    "two products at one speed differ by %.2f points "
			    "at %g mm, where repeat samples agree within 1: "
			    "were samples mixed up or digits transposed?",
			    100 * fall.most, units_m_to_mm(fall.at));
		}
}

/* Reports passings that fall from a slower to a faster run by more than
 * sampling explains.  That is a fault, unless each run has its own feed.
 * Returns false for a fault. */
static bool
check_faster_is_finer(struct answer *r, const struct entry *entry,
    const struct run *slow, const struct run *fast)
{
	const struct site *site = entry->site;
	struct passing_order fall =
	    trust_compare_slow_fast_products(&slow->product, &fast->product);
	bool fault =
	    !site->individual_feeds && trust_is_product_order_wrong(&fall);
	if (fall.most <= ORDER_NOTABLE)
		return true;
	FREED char *where = two_run_speeds_text(entry->site, slow, fast);
	const char *why =
	    site->individual_feeds ? tr("its feed may have been coarser")
	    : fault ? tr("were speeds swapped or digits transposed?")
		    : tr("sampling error may explain it, or digits "
			 "were transposed there");
	finding(r, entry, fault, where,
	    "the faster run's product is coarser by %.2f points at %g mm: %s",
	    100 * fall.most, units_m_to_mm(fall.at), why);
	return !fault;
}

/* Compares each run with those at the next lower speed. */
static bool
check_faster_runs_are_finer(struct answer *r, const struct entry *entry)
{
	const struct site *site = entry->site;
	bool ok = true;
	for (size_t i = 0, slow = 0, first = 0; i < site->n_run; i++) {
		if (!site_run_repeats_speed(site, i)) {
			slow = first;
			first = i;
		}
		for (size_t k = slow; k < first; k++)
			ok = check_faster_is_finer(
				 r, entry, &site->run[k], &site->run[i]) &&
			     ok;
	}
	return ok;
}

/* Returns a sieve, m, within the range of curve `at` that this curve lacks and
 * all the others have, or 0. */
static double
find_sieve_curve_lacks(const struct psd *const *curve, size_t n, size_t at)
{
	const struct psd *own = curve[at], *other = curve[(at + 1) % n];
	for (size_t i = 0; i < other->n; i++) {
		double x = other->size[i];
		size_t with = 0;
		for (size_t k = 0; k < n; k++)
			with +=
			    isnan(psd_passing_at_sieve(curve[k], x)) ? 0 : 1;
		if (with == n - 1 && isnan(psd_passing_at_sieve(own, x)) &&
		    x < own->size[0] && psd_covers_size(own, x))
			return x;
	}
	return 0;
}

/* Appends the feeds or the products of a site to the n curves, and the run of
 * each (NULL: of all runs) to run.  Returns the new number of curves. */
static size_t
append_feed_or_product_curves(const struct site *site, bool feed,
    const struct psd **curve, const struct run **run, size_t n)
{
	for (size_t i = 0; i < site->n_run; i++) {
		const struct run *its = &site->run[i];
		const struct psd *psd = feed ? &its->feed : &its->product;
		bool shared = feed && !site->individual_feeds;
		if (psd->n == 0 || (feed && !site_run_has_feed_sample(site, i)))
			continue;
		run[n] = shared ? NULL : its;
		curve[n++] = psd;
	}
	return n;
}

/* Reports two sieves of the feed so far apart that much of the curve between
 * them is only assumed. */
static void
report_wide_gap_in_feed(struct answer *r, const struct entry *entry)
{
	const struct psd *feed = &entry->site->run[0].feed;
	size_t i = psd_sieve_above_widest_gap(feed);
	if (i < feed->n)
		finding(r, entry, false, tr("feed"),
		    "no sieve between %g and %g mm, where %.0f points of it "
		    "lie: add one, because its curve is assumed to be straight "
		    "there",
		    units_m_to_mm(feed->size[i]),
		    units_m_to_mm(feed->size[i + 1]),
		    100 * (feed->passing[i] - feed->passing[i + 1]));
}

/* Reports a cell that is the only empty one in its row: a mass that was
 * forgotten there is missing from the total. */
static void
report_lone_empty_cells(struct answer *r, const struct entry *entry)
{
	const struct site *site = entry->site;
	char buf[40];
	FREED const struct psd **curve =
	    xcalloc(2 * site->n_run, sizeof(*curve));
	FREED const struct run **run = xcalloc(2 * site->n_run, sizeof(*run));
	size_t feeds = append_feed_or_product_curves(site, true, curve, run, 0);
	size_t n =
	    append_feed_or_product_curves(site, false, curve, run, feeds);
	for (size_t i = 0; i < n && n > 2; i++) {
		double x = find_sieve_curve_lacks(curve, n, i);
		if (x > 0)
			finding(r, entry, false,
			    feed_or_speed_text(site, run[i], buf),
			    i < feeds
				? N_("the feed's cell at %g mm is empty, and "
				     "no other in its row: if it was weighed "
				     "in grams and forgotten, the whole curve "
				     "is wrong")
				: N_("the product's cell at %g mm is empty, "
				     "and no other in its row: if it was "
				     "weighed in grams and forgotten, the "
				     "whole curve is wrong"),
			    units_m_to_mm(x));
	}
}

/* Reports single cells that look wrong.  Faults of whole columns have findings
 * of their own. */
static void
report_suspect_cells(struct answer *r, const struct entry *entry,
    const struct outlier_findings *d)
{
	char buf[40];
	for (size_t i = 0; i < d->n; i++) {
		const struct finding *f = &d->finding[i];
		const struct mend *m = &f->mend;
		bool shared = m->feed && !entry->site->individual_feeds;
		if (m->kind != MEND_READ && m->kind != MEND_OUT)
			continue;
		FREED char *words = mend_finding_text(entry->site, f);
		finding(r, entry, false,
		    feed_or_speed_text(entry->site,
			shared ? NULL : &entry->site->run[m->run], buf),
		    "%s", words);
	}
}

/* Reports the passing farthest from the calibrated product, which may reveal a
 * wrong cell that its neighbours and the other runs do not. */
static void
report_worst_cell_of_fit(struct answer *r, const struct entry *entry)
{
	if (!entry->has_fit)
		return;
	struct validation v =
	    trust_find_outlier_cell(entry->site, entry->train, &entry->fit);
	if (v.worst_difference == 0)
		return;
	const struct run *run = &entry->site->run[v.run];
	char buf[40];
	finding(r, entry, false, feed_or_speed_text(entry->site, run, buf),
	    "product passing %g %% at %g mm is %.1f points %s the calibrated "
	    "product: were digits transposed, here or in a neighbouring cell?",
	    units_fraction_to_pct(psd_passing(&run->product, v.worst_sieve)),
	    units_m_to_mm(v.worst_sieve), 100 * fabs(v.worst_difference),
	    v.worst_difference < 0 ? tr("above") : tr("below"));
}

static void
report_sites_with_same_data(struct session *s, struct answer *r, size_t index)
{
	const struct entry *entry = &s->entry[index];
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *other = &s->entry[i];
		if (i == index || other->site->digest != entry->site->digest)
			continue;
		finding(r, entry, false, tr("all runs"),
		    "identical data: %s and %s have the same numbers",
		    entry->site->name, other->site->name);
	}
}

static void
report_what_was_read(
    struct answer *r, struct fields *read, const struct entry *entry)
{
	const struct site *site = entry->site;
	size_t n, columns = 0;
	free(site_all_sieves(site, &n));
	for (size_t i = 0; i < site->n_run; i++)
		columns += (size_t)site_run_has_feed_sample(site, i) +
			   (size_t)(site->run[i].product.n > 0) +
			   (size_t)(site->run[i].product_sd != NULL);
	for (size_t i = 0; i < site->n_left_out; i++)
		finding(r, entry, false, site->left_out[i].key, "not read: %s",
		    site->left_out[i].value);
	FREED char *in =
	    xasprintf(tr_n("%zu column", "%zu columns", columns), columns);
	FREED char *runs =
	    xasprintf(tr_n("%zu run", "%zu runs", site->n_run), site->n_run);
	answer_note(r,
	    tr_n("%s: read %zu sieve in %s, %s",
		"%s: read %zu sieves in %s, %s", n),
	    entry->key, n, in, runs);
	if (site->named[0] != '\0')
		answer_note(r, "  by ASTM E11, mm: %s", site->named);
	fields_put_values(fields_add_object(read, NULL),
	    "site %s runs %zu sieves %zu columns %zu left_out %zu", entry->key,
	    site->n_run, n, columns, site->n_left_out);
}

static bool
check_site(
    struct session *s, struct answer *r, struct fields *read, size_t index)
{
	const struct entry *entry = &s->entry[index];
	bool ok = true;
	report_what_was_read(r, read, entry);
	for (size_t i = 0; i < entry->site->n_run; i++)
		ok = check_product_against_feed(
			 r, entry, &entry->site->run[i]) &&
		     ok;
	ok = check_faster_runs_are_finer(r, entry) && ok;
	check_repeated_runs_agree(r, entry);
	report_columns_entered_twice(r, entry);
	report_lone_empty_cells(r, entry);
	report_wide_gap_in_feed(r, entry);
	struct outlier_findings d = mend_find_faults(s, entry);
	report_suspect_cells(r, entry, &d);
	if (d.unseen > 0)
		finding(r, entry, false, tr("all runs"),
		    "%zu passings are too many to compare each with every "
		    "other (check does so for up to %d), so single wrong "
		    "values are not looked for; check fewer runs at a time",
		    d.unseen, OUTLIERS_CELLS_MOST);
	if (!mend_can_use_calibration(s, entry))
		report_worst_cell_of_fit(r, entry);
	report_sites_with_same_data(s, r, index);
	if (index == s->current)
		mend_add_numbered_list(r, entry, &d);
	outliers_free(&d);
	if (strcmp(site_data_kind(entry->site->provenance), "not stated") == 0)
		finding(r, entry, false, tr("site file"),
		    "provenance is not stated: above the table, write "
		    "provenance in a cell, and in the next where the data "
		    "are from");
	if (site_assumed_top_size(entry->site) > 0)
		finding(r, entry, false, tr("feed"),
		    "all of it is assumed to pass %g mm: a coarser sieve would "
		    "show it",
		    site_assumed_top_size(entry->site));
	return ok;
}

bool
cmd_check(struct session *s, const struct args *args, struct error *error)
{
	size_t first = s->current, last = s->current;
	if (args->n_operand > 0 && strcmp(args->operand[0], "all") == 0) {
		first = 0;
		last = s->n_entry - 1;
	} else if (args->n_operand > 0) {
		if (!session_find_site(s, args->operand[0], &first, error))
			return false;
		last = first;
	}
	struct answer *r = answer_new("check");
	answer_add_columns(r, "site, kind, where, finding");
	struct fields *read = fields_add_list(answer_json_fields(r), "read");
	bool ok = true;
	for (size_t i = first; i <= last; i++)
		ok = check_site(s, r, read, i) && ok;
	answer_add_rows_as_json_objects(r, "rows");
	fields_put_values(answer_json_fields(r), "ok %d", ok);
	answer_note(r, "%s",
	    !ok ? tr("there are faults")
	    : answer_count_rows(r) == 0
		? tr("no faults found")
		: tr("no faults found; judge the remarks yourself"));
	bool mends = answer_find_json_number(r, "mends.n") > 0;
	session_show_answer(s, r);
	if (ok)
		return true;
	error_set(error, ERROR_CHECK,
	    "check found faults in the site file\n"
	    "correct the spreadsheet, save it and load it again");
	if (mends)
		error_set_hint(error,
		    "correct the spreadsheet, save it and load "
		    "it again; or mend it here: mend 1");
	return false;
}
