/* The truth of a made-up sheet: curves of the model, rounded as a laboratory
 * does.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "habits.h"

static const struct sieve EN[] = {{63, NULL}, {45, NULL}, {31.5, NULL},
    {22.4, NULL}, {16, NULL}, {11.2, NULL}, {8, NULL}, {5.6, NULL}, {4, NULL},
    {2, NULL}, {1, NULL}, {.5, NULL}, {.25, NULL}, {.125, NULL}, {.063, NULL}};
static const struct sieve EN_2[] = {{63, NULL}, {40, NULL}, {31.5, NULL},
    {20, NULL}, {16, NULL}, {14, NULL}, {12.5, NULL}, {10, NULL}, {8, NULL},
    {6.3, NULL}, {4, NULL}, {2, NULL}, {1, NULL}, {.5, NULL}, {.25, NULL},
    {.125, NULL}, {.063, NULL}};
static const struct sieve ISO[] = {{45, NULL}, {31.5, NULL}, {22.4, NULL},
    {16, NULL}, {11.2, NULL}, {8, NULL}, {5.6, NULL}, {4, NULL}, {2.8, NULL},
    {2, NULL}, {1.4, NULL}, {1, NULL}, {.71, NULL}, {.5, NULL}, {.355, NULL},
    {.25, NULL}, {.18, NULL}, {.125, NULL}, {.09, NULL}, {.063, NULL}};
/* Inches begin with a blank. */
static const struct sieve ASTM[] = {{50, " 2"}, {37.5, " 1 1/2"}, {25, " 1"},
    {19, " 3/4"}, {12.5, " 1/2"}, {9.5, " 3/8"}, {6.3, " 1/4"}, {4.75, "4"},
    {2.36, "8"}, {2, "10"}, {1.18, "16"}, {.85, "20"}, {.6, "30"}, {.425, "40"},
    {.3, "50"}, {.15, "100"}, {.106, "140"}, {.075, "200"}};
static const struct sieve BS[] = {{50, NULL}, {37.5, NULL}, {28, NULL},
    {20, NULL}, {14, NULL}, {10, NULL}, {6.3, NULL}, {5, NULL}, {3.35, "5"},
    {2.36, "7"}, {1.7, "10"}, {1.18, "14"}, {.85, "18"}, {.6, "25"}, {.3, "52"},
    {.15, "100"}, {.075, "200"}};
static const struct sieve TYLER[] = {{53, NULL}, {37.5, NULL}, {26.5, NULL},
    {19, NULL}, {13.2, NULL}, {9.5, NULL}, {6.7, "3"}, {4.75, "4"}, {3.35, "6"},
    {2.36, "8"}, {1.7, "10"}, {1.18, "14"}, {.85, "20"}, {.6, "28"},
    {.425, "35"}, {.3, "48"}, {.212, "65"}, {.15, "100"}, {.106, "150"},
    {.075, "200"}};
const struct series SERIES_EN = {"", ARRAY_LEN(EN), EN},
		    SERIES_EN_2 = {"", ARRAY_LEN(EN_2), EN_2},
		    SERIES_ISO = {"", ARRAY_LEN(ISO), ISO},
		    SERIES_ASTM = {"ASTM", ARRAY_LEN(ASTM), ASTM},
		    SERIES_BS = {"BS", ARRAY_LEN(BS), BS},
		    SERIES_TYLER = {"Tyler", ARRAY_LEN(TYLER), TYLER};

static double
rounded(double value, int decimals)
{
	double scale = pow(10, decimals);
	return floor(value * scale + 0.5) / scale + 0.0;
}

/* The sieves of a series that a top size asks for, some of them left out. */
static void
choose_sieves(struct plan *plan, const struct series *series, double top_mm,
    struct curve *curve)
{
	size_t first = series->n - 1, n = 0;
	while (first > 0 && series->sieve[first].mm < 2 * top_mm)
		first--;
	size_t left = series->n - first;
	for (size_t i = first; i < series->n; i++) {
		bool edge = i == first || i + 1 == series->n;
		if (!edge && left > 8 && (left > 15 || chance(plan, 0.2))) {
			left--;
			continue;
		}
		curve->sieve[n] = &series->sieve[i];
		curve->mm[n] = series->sieve[i].mm;
		if (plan->sizes == SIZE_INCHES)
			curve->mm[n] = 25.4 * rounded(curve->mm[n] / 25.4,
						  curve->mm[n] > 2.5 ? 3 : 4);
		n++;
	}
	curve->n = n;
}

static struct psd
make_feed(struct plan *plan, const struct curve *curve, double top_mm, double n)
{
	struct psd feed = psd_new(curve->n);
	double above = 1;
	for (size_t i = 0; i < curve->n; i++) {
		double d = curve->mm[i] / top_mm;
		double p = d >= 1.99 ? 1
			   : d >= 1  ? 0.9 + 0.1 * log(d) / log(2)
				     : 0.9 * pow(d, n);
		double noise =
		    i > 0 ? 0.006 * draw_between(&plan->draw, -1, 1) : 0;
		p = fmin(above, fmax(0.001, p + noise * sqrt(p * (1 - p))));
		feed.size[i] = curve->mm[i] / 1000;
		feed.passing[i] = above = i == 0 ? 1 : p;
	}
	return feed;
}

static void
make_product_curve(struct plan *plan, const struct psd *feed,
    const struct params *params, struct curve *curve)
{
	struct run run = {
	    .speed = curve->speed, .feed = *feed, .product = psd_new(curve->n)};
	double passing[MOST_SIEVES], above = 100;
	for (size_t i = 0; i < curve->n; i++)
		run.product.size[i] = curve->mm[i] / 1000;
	made_product(&run, params, passing);
	for (size_t i = 0; i < curve->n; i++) {
		double p = passing[i];
		p += 0.008 * draw_between(&plan->draw, -1, 1) *
		     sqrt(fmax(p * (1 - p), 0));
		curve->pct[i] = above = fmin(above, fmax(0.05, 100 * p));
	}
	psd_free(&run.product);
}

/* Masses on the sieves and in the pan; washed fines never reach the pan, and
 * what is lost nothing. */
static void
show_grams(struct curve *curve, int decimals, bool loss, bool washed)
{
	double above = 100, sum = 0;
	for (size_t i = 0; i <= curve->n; i++) {
		double p = i < curve->n ? curve->pct[i] : 0;
		curve->shown[i] =
		    rounded((above - p) / 100 * curve->mass, decimals);
		sum += curve->shown[i];
		above = p;
	}
	curve->mass = sum;
	if (washed) {
		double *pan = &curve->shown[curve->n];
		curve->washed = rounded(0.8 * *pan, decimals);
		*pan = rounded(*pan - curve->washed, decimals);
	}
	double left = sum;
	for (size_t i = 0; i < curve->n; i++) {
		left -= curve->shown[i];
		curve->pct[i] =
		    rounded(fmin(100, 100 * fmax(left, 0) / sum), 9);
	}
	if (loss) {
		curve->loss = rounded(0.005 * sum, decimals);
		curve->mass = rounded(curve->mass + curve->loss, decimals);
		curve->slack += 0.5;
	}
}

static void
show_held(struct curve *curve, int decimals)
{
	double above = 100, sum = 0;
	for (size_t i = 0; i <= curve->n; i++) {
		double p = i < curve->n ? curve->pct[i] : 0;
		curve->shown[i] = rounded(above - p, decimals);
		above = p;
		sum += curve->shown[i];
		if (i < curve->n)
			curve->pct[i] = fmax(100 - sum, 0);
	}
	curve->slack += fabs(100 - sum);
}

void
truth_show(struct curve *curve, enum written quantity, int decimals, bool loss,
    bool washed)
{
	bool share = quantity == PASS_SHARE || quantity == HELD_SHARE ||
		     quantity == SUM_SHARE;
	curve->quantity = quantity;
	curve->decimals = decimals;
	if (quantity == HELD_G || quantity == SUM_G)
		show_grams(curve, decimals, loss, washed);
	else if (quantity == HELD_PCT || quantity == HELD_SHARE)
		show_held(curve, decimals);
	double sum = 0;
	for (size_t i = 0; i <= curve->n; i++) {
		double *v = &curve->shown[i];
		sum += *v;
		if (quantity == SUM_G)
			*v = sum;
		if (quantity >= HELD_G && quantity <= HELD_SHARE)
			continue;
		double p = i < curve->n ? curve->pct[i] : 0;
		if (quantity <= PASS_SHARE)
			*v = p = rounded(p, decimals);
		else if (quantity != SUM_G)
			p = 100 - (*v = rounded(100 - p, decimals));
		if (i < curve->n)
			curve->pct[i] = p;
	}
	for (size_t i = 0; share && i <= curve->n; i++)
		curve->shown[i] /= 100;
	curve->decimals += share ? 2 : 0;
}

/* As it is written, and what follows from that. */
static void
write_speed(const struct plan *plan, struct curve *curve)
{
	double v = curve->speed, round_m = acos(-1) * plan->rotor_mm / 1000;
	curve->as_written = v;
	if (plan->speeds == SPEED_RPM) {
		curve->as_written = round(v * 60 / round_m);
		curve->speed = curve->as_written * round_m / 60;
	} else if (plan->speeds == SPEED_FEET) {
		curve->as_written = round(v / 0.3048 * 60 / 10) * 10;
		curve->speed = curve->as_written * 0.3048 / 60;
	} else if (plan->speeds == SPEED_KMH) {
		curve->as_written = rounded(v * 3.6, 1);
		curve->speed = curve->as_written / 3.6;
	}
}

static size_t
choose_speeds(struct plan *plan, double *speed)
{
	static const double STEPS[] = {2.5, 4, 5, 7.1, 10};
	static const double FIRST[] = {55, 60, 63.6, 64, 65, 66.7, 69, 70};
	size_t n = plan->feed_only ? 0 : plan->one_product ? 1 : 2;
	n += n == 2 ? pick(plan, 3) : 0;
	double first = FIRST[pick(plan, ARRAY_LEN(FIRST))];
	double step = STEPS[pick(plan, ARRAY_LEN(STEPS))];
	for (size_t i = 0; i < n; i++)
		speed[i] = rounded(first + step * (double)i, 1);
	if (plan->repeats && n > 0) {
		size_t twin = pick(plan, n);
		memmove(
		    &speed[twin + 1], &speed[twin], (n - twin) * sizeof *speed);
		n++;
	}
	return n;
}

/* The last product on the coarsest sieve passes all; leave_gaps sees that what
 * is left can be read. */
static void
leave_gaps(struct plan *plan)
{
	for (size_t c = 0; plan->gaps > 0 && c < plan->n_curve; c++) {
		struct curve *k = &plan->curve[c];
		bool held = k->quantity >= HELD_G && k->quantity <= HELD_SHARE;
		for (size_t i = 0; i < k->n; i++) {
			if (held && k->shown[i] == 0 && plan->gaps != 4)
				k->left_out[i] = k->maybe[i] = true;
			if (plan->gaps == 4 && k->shown[i] < 0.1 && held &&
			    k->quantity == HELD_PCT)
				k->left_out[i] = k->maybe[i] = true;
		}
		bool passing = k->quantity == PASS_PCT && plan->gaps < 4;
		if (passing && !k->feed && k->n > 5 && chance(plan, 0.5)) {
			size_t gap = 1 + pick(plan, k->n - 2);
			k->left_out[gap] = true;
			k->pct[gap] = NAN;
		}
		if (k->quantity == PASS_PCT && plan->gaps == 4 &&
		    k->shown[k->n - 1] < 0.1)
			k->left_out[k->n - 1] = k->maybe[k->n - 1] = true;
	}
}

static int
choose_decimals(const struct plan *plan, enum written quantity)
{
	if (quantity == HELD_G || quantity == SUM_G)
		return plan->grams_whole ? 0 : 1;
	if (quantity == PASS_SHARE || quantity == HELD_SHARE ||
	    quantity == SUM_SHARE)
		return plan->word % 3 == 0 ? 2 : 1;
	return plan->whole_pct ? 0 : plan->word % 3 == 0 ? 2 : 1;
}

static void
add_curve(struct plan *plan, const struct curve *like, double speed, bool feed)
{
	struct curve *c = &plan->curve[plan->n_curve++];
	*c = *like;
	c->speed = speed;
	c->feed = feed;
	c->slack = 0.15;
	c->mass = draw_log(&plan->draw, 800, 9000);
}

void
truth_make(struct plan *plan)
{
	const struct table_row *row = &TABLE_3[pick(plan, 19)];
	struct params params = made_params(row);
	double speed[6], n = draw_between(&plan->draw, 0.6, 1.4);
	size_t n_speed = choose_speeds(plan, speed);
	struct curve of_feed = {0}, of_product = {0};
	choose_sieves(plan, plan->feed_series, row->top_mm, &of_feed);
	of_product = of_feed;
	if (plan->apart)
		choose_sieves(plan, plan->series, row->top_mm, &of_product);
	struct psd feed = {0};
	for (size_t i = 0; i < (n_speed > 0 ? n_speed : 1); i++) {
		if (i == 0 || plan->individual) {
			add_curve(plan, &of_feed,
			    plan->individual ? speed[i] : 0, true);
			psd_free(&feed);
			feed = make_feed(plan, &of_feed, row->top_mm,
			    n * (1 + 0.04 * (double)i));
			for (size_t k = 0; k < feed.n; k++)
				plan->curve[plan->n_curve - 1].pct[k] =
				    100 * feed.passing[k];
		}
		if (n_speed == 0)
			break;
		add_curve(plan, &of_product, speed[i], false);
		make_product_curve(
		    plan, &feed, &params, &plan->curve[plan->n_curve - 1]);
	}
	psd_free(&feed);
	for (size_t i = 0; i < plan->n_curve; i++) {
		struct curve *c = &plan->curve[i];
		/* Clay, without which washing would take nothing that shows. */
		for (size_t k = 0; plan->washed && k < c->n; k++)
			c->pct[k] = 3 + 0.97 * c->pct[k];
		enum written q = c->feed ? plan->feed_quantity : plan->quantity;
		truth_show(
		    c, q, choose_decimals(plan, q), plan->loss, plan->washed);
		write_speed(plan, c);
	}
	leave_gaps(plan);
}
