/* The speeds at which a product is as it is wanted.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_WINDOW_H
#define TIPSPEED_CORE_ANSWER_WINDOW_H

#include <stdbool.h>

#include "core/answer/response.h"

/* Limits of a quantity, in its own unit; NAN where there is none. */
struct condition {
	struct quantity quantity;
	double least, most;
};

/* Condition i of a list is on quantity i of a response, which may have more
 * quantities behind those.  All functions move it to other speeds. */
struct wanted {
	struct response *response;
	size_t n;
	const struct condition *at;
	double from, to; /* speeds looked at, m/s */
	bool coarse;     /* the best speed to a step only, 0.1 m/s */
};

/* One of the two limits of condition i; i SIZE_MAX: none. */
struct window_limit {
	size_t i;
	bool most;
};

/* Speeds at which all conditions hold, and the limit that binds below and
 * above them: none where they end with the speeds looked at. */
struct window_range {
	double from, to;
	struct window_limit low, high;
};

/* best: the speed with the largest margin, which is that of the limit with the
 * least, as a passing 0..1 (quantity_over); where no speed is inside that
 * misses least, by -margin, and low and high are what it misses just below and
 * just above; alike: every speed misses by as much.
 * A limit that leaves no room, at least 100 % or at most 0 %, has
 * to hold but has no margin: INFINITY where there are no others.
 * speed, certain [n]: steps over the speeds, and the share of the draws in
 * which all conditions hold there; alone [..]: for each condition the speeds
 * about the best one, or nearest to it, at which it alone holds; NAN: up to the
 * end of those looked at; best_certain: at the best speed; NAN of a model
 * alone. */
struct window_found {
	size_t n_inside;
	struct window_range *inside;
	double best, margin, best_certain;
	struct window_limit low, high;
	bool alike;
	size_t n;
	double *speed, *certain;
	double (*alone)[2];
};

/* window_free. */
struct window_found window_find(const struct wanted *c);
void window_free(struct window_found *w);

/* The one inside range that has the best speed; NULL where there is none. */
const struct window_range *window_around(const struct window_found *w);

/* The speeds around the most certain one where all conditions hold with the
 * probability `level`; [2] out, NAN where there are none. */
void window_certain(
    const struct window_found *w, double level, double range[static 2]);

/* At the speed the response is at: the least margin, and whose it is; the
 * margin of one condition, and its nearer limit; and the share of draws in
 * which all hold. */
double window_margin(const struct wanted *c, struct window_limit *limit);
double window_margin_of(
    const struct wanted *c, size_t i, struct window_limit *limit);
double window_certainty(const struct wanted *c);

/* Whether all of them, or one, hold there. */
bool window_holds(const struct wanted *c);
bool window_holds_of(const struct wanted *c, size_t i);

/* The speeds at which quantity i of the response is `value`, slowest first, to
 * 1e-9 m/s; `from` too where it is that there.  root: the caller frees. */
size_t window_roots(
    const struct wanted *c, size_t i, double value, double **root);

/* The middle `level` of the speeds at which the draws give that value of
 * quantity i as the answer does at speed v, those nearest to it: 0 and INFINITY
 * where they do so below and above the speeds looked at.  NAN of a model
 * alone. */
void window_spread(const struct wanted *c, size_t i, double value, double v,
    double level, double range[static 2]);

/* The speed inside the window at which quantity i is largest, or least; NAN
 * where no speed is inside. */
double window_extreme(
    const struct wanted *c, const struct window_found *w, size_t i, bool most);

#endif
