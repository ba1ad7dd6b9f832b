/* Tries to undo the usual mistakes in columns (swapped, shifted, scaled,
 * copied) and in cells (digits, by leave-one-out expectations), and keeps the
 * mends that make a sheet consistent.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/outliers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/check/loo.h"
#include "core/check/trust.h"
#include "core/search/misfit.h"
#include "core/search/polish.h"
#include "core/psd/psd.h"

/* After a calibration, a cell of a product or of a feed is reported if its
 * surprise exceeds these and it is off by WORTH or more.  The limits were found
 * by counting, with bench/doctor. */
static const double SURPRISE_PRODUCT = 4, SURPRISE_FEED = 4.5, WORTH = 0.02;

/* A cell of a feed must also be off its own curve by this many standard
 * deviations, because a wrong model makes the feed seem wrong. */
static const double FEED_OFF = 3;

/* Before a calibration, a cell is reported if its distance from the straight
 * line, in log size, between its neighbours differs by more than this from the
 * mean distance in the other curves at the same three sieves, or from 0 if
 * there are no others.  In 19000 synthetic sites at 50 to 90 m/s, the largest
 * differences were 0.13 in a product (where the break size passes a sieve),
 * 0.03 in a feed, and 0.15 in a curve without others. */
static const double OFF_PRODUCT = 0.14, OFF_FEED = 0.08, OFF_ALONE = 0.2;

/* At most this many cells are reported at a time, because in a bad site file
 * each cell changes the verdict on the others. */
enum { CELLS = 3 };

static struct finding *
add_outlier_finding(struct outlier_findings *d, struct mend mend)
{
	d->finding = xgrow_by_one(d->finding, d->n, sizeof *d->finding);
	struct finding *f = &d->finding[d->n++];
	*f = (struct finding){.mend = mend,
	    .measured = NAN,
	    .expected = NAN,
	    .sd = NAN,
	    .surprise = NAN,
	    .off = {NAN, NAN},
	    .rmse = {NAN, NAN}};
	return f;
}

/* ---- Columns ---- */

static bool
is_product_coarser_than_feed(const struct psd *product, const struct psd *feed)
{
	const double sampling = 0.02, on_the_whole = 0.01;
	struct passing_order o =
	    trust_compare_slow_fast_products(feed, product);
	return o.most > sampling && o.mean > on_the_whole;
}

/* True if no product of the site is coarser than its feed. */
static bool
are_products_finer_than_feeds(const struct site *site)
{
	bool ok = true;
	for (size_t r = 0; r < site->n_run; r++)
		ok = ok && (site->run[r].product.n == 0 ||
			       !is_product_coarser_than_feed(
				   &site->run[r].product, &site->run[r].feed));
	return ok;
}

static void
find_feeds_swapped_with_products(
    struct outlier_findings *d, const struct site *site)
{
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		struct mend m = {.kind = MEND_SWAP_FEED, .run = r};
		if (run->product.n == 0 ||
		    (site->individual_feeds && run->lacks_feed) ||
		    !is_product_coarser_than_feed(&run->product, &run->feed))
			continue;
		struct site *other = site_with_mend(site, &m, NULL);
		if (other != NULL &&
		    (site->individual_feeds ||
			are_products_finer_than_feeds(other))) {
			struct finding *f = add_outlier_finding(d, m);
			const struct run *now = &other->run[r];
			f->off[0] = trust_compare_slow_fast_products(
			    &run->feed, &run->product)
					.mean;
			f->off[1] = fmax(0, trust_compare_slow_fast_products(
						&now->feed, &now->product)
						.mean);
		}
		site_free(other);
	}
}

/* Returns how much coarser the faster product is, on average over the sieves,
 * summed over neighbouring speeds. */
static double
coarsening_with_speed(const struct site *site)
{
	double sum = 0;
	const struct run *slow = NULL;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (run->product.n == 0)
			continue;
		if (slow != NULL && slow->speed < run->speed)
			sum += fmax(0, trust_compare_slow_fast_products(
					   &slow->product, &run->product)
					   .mean);
		slow = run;
	}
	return sum;
}

/* True if the slower product is the finer one on most of the sieves that
 * distinguish the two.  A single wrong cell, however large, does not decide. */
static bool
is_slower_product_finer(const struct psd *slow, const struct psd *fast)
{
	const double apart = 1e-3;
	size_t finer = 0, coarser = 0;
	for (size_t i = 0; i < slow->n; i++) {
		if (!psd_covers_size(fast, slow->size[i]))
			continue;
		double by = slow->passing[i] - psd_passing(fast, slow->size[i]);
		finer += by > apart;
		coarser += by < -apart;
	}
	return finer > coarser;
}

static void
find_exchanged_products(struct outlier_findings *d, const struct site *site)
{
	/* Above this, check reports a fault. */
	const double much = 0.003, share = 0.2;
	double before = coarsening_with_speed(site), least = share * before;
	struct mend best = {.kind = MEND_READ};
	for (size_t i = 0; i < site->n_run && before > much; i++)
		for (size_t k = i + 1; k < site->n_run; k++) {
			struct mend m = {
			    .kind = MEND_SWAP_RUNS, .run = i, .other = k};
			if (site->individual_feeds ||
			    site->run[i].product.n == 0 ||
			    site->run[k].product.n == 0 ||
			    !is_slower_product_finer(
				&site->run[i].product, &site->run[k].product))
				continue;
			struct site *other = site_with_mend(site, &m, NULL);
			double after =
			    other != NULL ? coarsening_with_speed(other) : 1;
			site_free(other);
			if (after < least) {
				least = after;
				best = m;
			}
		}
	if (best.kind != MEND_SWAP_RUNS)
		return;
	struct finding *f = add_outlier_finding(d, best);
	f->off[0] = before;
	f->off[1] = least;
}

/* Sums for a straight line in energy through the passings of other runs. */
struct line_sums {
	double n, e, ee, p, ep;
};

static double
regression_value_at_energy(const struct line_sums *l, double e)
{
	double mean = l->e / l->n, about = l->ee / l->n - mean * mean;
	double slope = about > 1e-9 * mean * mean
			   ? (l->ep / l->n - mean * l->p / l->n) / about
			   : 0;
	return l->p / l->n + slope * (e - mean);
}

/* Returns the RMS distance of a run's product from the line through the other
 * products, or NAN if there are fewer than two others, because either of two
 * curves may be the wrong one. */
static double
distance_from_other_products(const struct site *site, size_t at)
{
	const struct run *run = &site->run[at];
	double squares = 0, n = 0;
	for (size_t i = 0; i < run->product.n; i++) {
		struct line_sums l = {.n = 0};
		double x = run->product.size[i];
		for (size_t r = 0; r < site->n_run; r++) {
			const struct psd *p = &site->run[r].product;
			if (r == at || p->n == 0 || !psd_covers_size(p, x))
				continue;
			double v = site->run[r].speed, P = psd_passing(p, x);
			l.n++;
			l.e += v * v;
			l.ee += v * v * v * v;
			l.p += P;
			l.ep += v * v * P;
		}
		if (l.n < 2)
			continue;
		double by =
		    run->product.passing[i] -
		    regression_value_at_energy(&l, run->speed * run->speed);
		squares += by * by;
		n++;
	}
	return n > 2 ? sqrt(squares / n) : NAN;
}

/* Finds a column that is far from the others, but close to them when moved by
 * one sieve. */
static void
find_column_moved_by_a_sieve(
    struct outlier_findings *d, const struct site *site)
{
	const double far = 0.05, share = 0.35;
	double best = 1;
	struct mend mend = {.kind = MEND_READ};
	double off[2] = {0, 0};
	for (size_t i = 0; i < 2 * site->n_run; i++) {
		struct mend m = {.run = i / 2};
		double before = distance_from_other_products(site, m.run);
		m.kind = i % 2 == 0 ? MEND_UP : MEND_DOWN;
		if (!(before > far))
			continue;
		struct site *other = site_with_mend(site, &m, NULL);
		double after = other != NULL
				   ? distance_from_other_products(other, m.run)
				   : NAN;
		site_free(other);
		if (!(after < share * before) || after / before >= best)
			continue;
		best = after / before;
		mend = m;
		off[0] = before;
		off[1] = after;
	}
	if (mend.kind != MEND_READ)
		memcpy(add_outlier_finding(d, mend)->off, off, sizeof off);
}

/* Returns the distance, after a mend, of the run that fits the others worst. */
static double
worst_run_distance_after_mend(const struct site *site, const struct mend *m)
{
	struct site *other = site_with_mend(site, m, NULL);
	double most = 0;
	for (size_t r = 0; other != NULL && r < other->n_run; r++)
		if (other->run[r].product.n > 0)
			most =
			    fmax(most, distance_from_other_products(other, r));
	site_free(other);
	return most;
}

/* A moved column makes speeds seem exchanged, and vice versa.  If both mends
 * were found, keeps the one that leaves the products more alike. */
static void
choose_mend_with_smoother_products(
    struct outlier_findings *d, const struct site *site)
{
	if (d->n < 2)
		return;
	const struct finding *f = d->finding;
	if (worst_run_distance_after_mend(site, &f[1].mend) <
	    worst_run_distance_after_mend(site, &f[0].mend))
		d->finding[0] = f[1];
	d->n = 1;
}

/* Finds a column in micrometres that was read as millimetres, or vice versa. */
static void
find_column_in_wrong_unit(struct outlier_findings *d, const struct site *site)
{
	const double apart = 100, factor = 1000, largest = 1;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (run->product.n == 0)
			continue;
		double ratio = run->product.size[0] / run->feed.size[0];
		struct mend m = {.kind = MEND_SCALE, .run = r};
		if (ratio > apart)
			m.value = 1 / factor;
		else if (ratio * apart < 1) {
			m.feed = run->feed.size[0] > largest;
			m.value = m.feed ? 1 / factor : factor;
		} else
			continue;
		if (!m.feed || site_run_has_feed_sample(site, r))
			add_outlier_finding(d, m);
	}
}

static void
find_copied_products(struct outlier_findings *d, const struct site *site)
{
	for (size_t i = 1; i < site->n_run; i++)
		for (size_t k = 0; k < i; k++)
			if (psd_is_same(
				&site->run[k].product, &site->run[i].product)) {
				add_outlier_finding(d,
				    (struct mend){.kind = MEND_DROP, .run = i});
				break;
			}
}

/* ---- Cells ---- */

static double
distance_from_expected(const struct finding *f, double passing)
{
	return fabs(passing - f->expected);
}

/* Makes a reading the cell's mend if it is within three standard deviations of
 * the expected passing and nearer to it than any earlier reading. */
static void
try_passing_as_cell_mend(struct finding *f, double passing)
{
	double least = 0.001, near = 3 * f->sd + least;
	bool taken = f->mend.kind == MEND_READ;
	double so_far = taken ? distance_from_expected(f, f->mend.value) : near;
	if (distance_from_expected(f, passing) >= so_far || passing < 0 ||
	    passing > 1)
		return;
	f->mend.kind = MEND_READ;
	f->mend.value = passing;
}

/* Finds the digits of a passing in per cent, "691", and the number of them
 * before the point.  Returns the number of digits, or 0 if the passing seems
 * calculated, not typed. */
static size_t
split_passing_into_digits(double passing, char digits[static 16], size_t *point)
{
	double hundredths = passing * 1e4;
	size_t n = 0;
	if (fabs(hundredths - round(hundredths)) > 1e-6)
		return 0;
	FREED char *text = xasprintf("%.2f", round(hundredths) / 100);
	for (const char *c = text; *c != '\0' && n < 15; c++)
		if (*c != '.')
			digits[n++] = *c;
	digits[n] = '\0';
	if (n < 3)
		return 0;
	*point = n - 2;
	if (n > 1 && digits[n - 1] == '0')
		digits[--n] = '\0';
	return n;
}

static double
passing_of_percent_digits(const char *digits, size_t point)
{
	double value = 0, place = 1;
	for (size_t i = 0; digits[i] != '\0'; i++) {
		value = value * 10 + (digits[i] - '0');
		place *= i >= point ? 10 : 1;
	}
	return round(value / place * 1e10) / 1e12;
}

/* Considers two transposed digits, a digit typed twice, and a shifted point. */
static void
try_digit_errors_as_mends(struct finding *f)
{
	char digits[16], other[16];
	size_t point,
	    n = split_passing_into_digits(f->measured, digits, &point);
	for (size_t i = 0; i + 1 < n; i++) {
		memcpy(other, digits, sizeof other);
		other[i] = digits[i + 1];
		other[i + 1] = digits[i];
		if (digits[i] != digits[i + 1])
			try_passing_as_cell_mend(
			    f, passing_of_percent_digits(other, point));
		memmove(other + i, digits + i + 1, n - i);
		memcpy(other, digits, i);
		if (digits[i] == digits[i + 1])
			try_passing_as_cell_mend(
			    f, passing_of_percent_digits(
				   other, point - (i < point)));
	}
	if (n > 0) {
		try_passing_as_cell_mend(f, round(f->measured * 1e13) / 1e12);
		try_passing_as_cell_mend(f, round(f->measured * 1e11) / 1e12);
	}
}

/* Adds a cell with its mend: a reading if there is one and the site is valid
 * with it, otherwise leaving the cell out. */
static void
add_outlier_finding_of_cell(struct outlier_findings *d, const struct site *site,
    const struct leave_out_cell *cell, const struct leave_out_shift *s)
{
	struct mend m = {
	    .kind = MEND_OUT, .feed = cell->feed, .run = cell->run};
	const struct psd *psd = site_feed_or_product(site, m.run, m.feed);
	m.size = psd->size[cell->sieve];
	struct finding *f = add_outlier_finding(d, m);
	f->measured = psd->passing[cell->sieve];
	f->expected = s->expected;
	f->sd = s->sd;
	try_digit_errors_as_mends(f);
	struct site *other = site_with_mend(site, &f->mend, NULL);
	if (other == NULL)
		f->mend = m;
	site_free(other);
}

/* Refits the site without a cell, because a fit moves towards a cell that is
 * off. */
static void
refit_without_cell(struct posterior *p, const struct site *site, struct mend m)
{
	enum { MOST = 100 };
	m.kind = MEND_OUT;
	struct site *less = site_with_mend(site, &m, NULL);
	if (less == NULL)
		return;
	struct misfit *misfit =
	    misfit_new(less, NULL, NULL, false, p->settings);
	struct polish *polish = polish_new(misfit);
	polish_minimise_misfit(polish, &p->bounds, MOST, NULL, &p->fit);
	params_scale_largest_beta_to_1(&p->fit);
	polish_free(polish);
	misfit_free(misfit);
	site_free(less);
}

static double
measured_passing_of_cell(
    const struct site *site, const struct leave_out_cell *c)
{
	return site_feed_or_product(site, c->run, c->feed)->passing[c->sieve];
}

/* Returns how far a cell is off its curve, without using a model. */
static struct leave_out_shift
compare_cell_with_its_curve(
    const struct site *site, double noise, const struct leave_out_cell *cell)
{
	struct leave_out *l = leave_out_new(site, NULL, noise);
	struct leave_out_shift s = {.z = NAN, .expected = NAN, .sd = NAN};
	for (size_t i = 0; i < leave_out_count_cells(l); i++) {
		struct leave_out_cell c = leave_out_get_cell(l, i);
		if (c.feed == cell->feed && c.run == cell->run &&
		    c.sieve == cell->sieve)
			s = leave_out_shift_of_cell(l, i);
	}
	leave_out_free(l);
	return s;
}

static struct leave_out *
leave_out_new_without_cells(const struct site *site, const struct posterior *p,
    double noise, const size_t *cell, size_t n)
{
	struct leave_out *l = leave_out_new(site, p, noise);
	for (size_t i = 0; i < n; i++)
		leave_out_remove_cell(l, cell[i]);
	return l;
}

/* Finds the next cell to report.  p: the caller's own copy,
 * whose fit is replaced.  found [n]:
 * the cells found before.  Returns false if no other cell is worth
 * reporting. */
static bool
find_next_surprising_cell(struct outlier_findings *d, const struct site *site,
    struct posterior *p, double noise, size_t *found, size_t n)
{
	struct leave_out *l =
	    leave_out_new_without_cells(site, p, noise, found, n);
	struct leave_out_shift s = {.gain = 0};
	if (leave_out_count_cells(l) > n)
		s = leave_out_find_worst_cell(l);
	struct leave_out_cell c = {.feed = false};
	bool tell = s.gain > fmin(SURPRISE_PRODUCT, SURPRISE_FEED);
	if (tell)
		c = leave_out_get_cell(l, s.cell);
	leave_out_free(l);
	tell = tell && s.gain > (c.feed ? SURPRISE_FEED : SURPRISE_PRODUCT) &&
	       fabs(s.expected - measured_passing_of_cell(site, &c)) > WORTH;
	if (!tell)
		return false;
	found[n] = s.cell;
	if (c.feed && !(compare_cell_with_its_curve(site, noise, &c).z *
			      copysign(1, s.z) >
			  FEED_OFF))
		return true;
	struct mend m = {.feed = c.feed, .run = c.run};
	m.size = site_feed_or_product(site, m.run, m.feed)->size[c.sieve];
	refit_without_cell(p, site, m);
	l = leave_out_new_without_cells(site, p, noise, found, n);
	double gain = s.gain;
	s = leave_out_shift_of_cell(l, s.cell);
	leave_out_free(l);
	if (!(fabs(s.expected - measured_passing_of_cell(site, &c)) > WORTH))
		return false;
	add_outlier_finding_of_cell(d, site, &c, &s);
	d->finding[d->n - 1].surprise = gain;
	return true;
}

static void
find_surprising_cells(struct outlier_findings *d, const struct site *site,
    const struct posterior *posterior, double noise)
{
	struct posterior *p = xcalloc(1, sizeof *p); /* borrows the arrays of
						      * posterior */
	size_t found[CELLS], n = 0;
	*p = *posterior;
	while (
	    n < CELLS && find_next_surprising_cell(d, site, p, noise, found, n))
		n++;
	free(p);
}

/* Lists the curves of the feeds or of the products, and their runs.  Returns
 * their number. */
static size_t
collect_feed_or_product_curves(
    const struct site *site, bool feed, const struct psd **curve, size_t *run)
{
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct psd *psd = site_feed_or_product(site, r, feed);
		if (psd->n == 0 || (feed && !site_run_has_feed_sample(site, r)))
			continue;
		run[n] = r;
		curve[n++] = psd;
	}
	return n;
}

static void
find_cell_off_smooth_curve(struct outlier_findings *d, const struct site *site,
    bool feed, double noise)
{
	FREED const struct psd **curve = xcalloc(site->n_run, sizeof *curve);
	FREED size_t *run = xcalloc(site->n_run, sizeof *run);
	size_t n = collect_feed_or_product_curves(site, feed, curve, run);
	struct psd_outlier o = psd_find_outlier(curve, n);
	double most = o.others == 0 ? OFF_ALONE : feed ? OFF_FEED : OFF_PRODUCT;
	struct leave_out_cell cell = {feed, run[o.curve], o.sieve};
	if (!(fabs(o.off) > most))
		return;
	struct leave_out_shift s =
	    compare_cell_with_its_curve(site, noise, &cell);
	/* A curve with few sieves may bend where the others show why. */
	if (fabs(s.expected - measured_passing_of_cell(site, &cell)) < s.sd)
		return;
	add_outlier_finding_of_cell(d, site, &cell, &s);
}

/* ---- All ---- */

static double
rmse_of_fit(const struct site *site, const struct posterior *p)
{
	struct misfit *m = misfit_new(site, NULL, NULL, false, p->settings);
	double rmse = m->n_residual > 0 ? misfit_rmse(m, &p->fit) : NAN;
	misfit_free(m);
	return rmse;
}

static size_t
count_cells_of_site(const struct site *site)
{
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		n += site->run[r].product.n;
		n +=
		    site_run_has_feed_sample(site, r) ? site->run[r].feed.n : 0;
	}
	return n;
}

/* Keeps the mends that are possible (dropping the only run is not), and
 * computes the errors of the fit before and after each. */
static void
remove_impossible_mends(struct outlier_findings *d, const struct site *site,
    const struct posterior *p)
{
	size_t n = 0;
	for (size_t i = 0; i < d->n; i++) {
		struct finding f = d->finding[i];
		struct site *other = site_with_mend(site, &f.mend, NULL);
		if (other == NULL)
			continue;
		if (p != NULL) {
			f.rmse[0] = rmse_of_fit(site, p);
			f.rmse[1] = rmse_of_fit(other, p);
		}
		d->finding[n++] = f;
		site_free(other);
	}
	d->n = n;
}

struct outlier_findings
outliers_find(
    const struct site *site, const struct posterior *posterior, double noise)
{
	struct outlier_findings d = {0};
	find_column_in_wrong_unit(&d, site);
	if (d.n == 0)
		find_feeds_swapped_with_products(&d, site);
	if (d.n == 0) {
		find_exchanged_products(&d, site);
		find_column_moved_by_a_sieve(&d, site);
		choose_mend_with_smoother_products(&d, site);
	}
	bool columns = d.n > 0;
	find_copied_products(&d, site);
	size_t cells = count_cells_of_site(site);
	if (cells > OUTLIERS_CELLS_MOST)
		d.unseen = cells;
	bool look = !columns && d.unseen == 0;
	if (look && posterior != NULL)
		find_surprising_cells(&d, site, posterior, noise);
	if (look && posterior == NULL) {
		find_cell_off_smooth_curve(&d, site, true, noise);
		find_cell_off_smooth_curve(&d, site, false, noise);
	}
	remove_impossible_mends(&d, site, posterior);
	return d;
}

void
outliers_free(struct outlier_findings *found)
{
	free(found->finding);
	*found = (struct outlier_findings){0};
}
