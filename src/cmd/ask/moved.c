/* The products of one site moved to one feed are kept, as each step of a slider
 * shows them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/moved.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/ask/outlook.h"

/* What it was made for; product [n]: of each run, n 0 where it has none. */
struct moved {
	const struct site *site;
	uint64_t digest;
	const struct posterior *posterior;
	struct params drawn; /* first of its draws, as addresses come again */
	struct params params;
	struct model_settings settings;
	size_t feed, n;
	struct psd *product;
	double most;
};

struct moved *
moved_new(void)
{
	return xcalloc(1, sizeof(struct moved));
}

static void
clear(struct moved *m)
{
	for (size_t r = 0; r < m->n; r++)
		psd_free(&m->product[r]);
	free(m->product);
	*m = (struct moved){0};
}

void
moved_free(struct moved *m)
{
	if (m == NULL)
		return;
	clear(m);
	free(m);
}

/* By what the answers of the two feeds differ at a sieve; 0 where one of them
 * does not tell. */
static double
shift(const struct prediction *to, const struct prediction *own, double x)
{
	double difference =
	    psd_at_sieve(&to->curve, x) - psd_at_sieve(&own->curve, x);
	return isfinite(difference) ? difference : 0;
}

/* Passings stay between 0 and 1, and fall with the size. */
static void
move_run(struct moved *m, const struct session *s, const struct entry *entry,
    size_t run)
{
	const struct run *r = &entry->site->run[run];
	struct psd *product = &m->product[run];
	*product = psd_copy(&r->product);
	if (product->n == 0 || psd_same(&r->feed, site_feed(m->site, m->feed)))
		return;
	struct prediction to =
	    outlook_form(s, entry, &m->params, r->speed, m->feed);
	struct prediction own =
	    outlook_form(s, entry, &m->params, r->speed, run);
	for (size_t i = 0; i < product->n; i++) {
		double more = shift(&to, &own, product->size[i]);
		double most = i > 0 ? product->passing[i - 1] : 1;
		product->passing[i] =
		    fmin(fmax(product->passing[i] + more, 0), most);
		m->most = fmax(m->most, fabs(more));
	}
	prediction_free(&to);
	prediction_free(&own);
}

void
moved_forget(struct moved *m)
{
	clear(m);
}

static const struct moved *
moved_by(const struct session *s, const struct entry *entry,
    const struct params *params, size_t feed_run)
{
	struct moved *m = s->moved;
	const struct site *site = entry->site;
	const struct posterior *posterior = outlook_answering(s, entry, params);
	struct model_settings settings = outlook_settings(s, entry);
	const struct params *drawn =
	    posterior != NULL ? &posterior->draw[0].params : params;
	if (m->site == site && m->digest == site->digest &&
	    m->feed == feed_run && m->posterior == posterior &&
	    memcmp(&m->params, params, sizeof *params) == 0 &&
	    memcmp(&m->drawn, drawn, sizeof *drawn) == 0 &&
	    model_settings_same(&m->settings, &settings))
		return m;
	clear(m);
	*m = (struct moved){.site = site,
	    .digest = site->digest,
	    .posterior = posterior,
	    .drawn = *drawn,
	    .params = *params,
	    .settings = settings,
	    .feed = feed_run,
	    .n = site->n_run,
	    .product = xcalloc(site->n_run, sizeof *m->product)};
	for (size_t r = 0; r < m->n; r++)
		move_run(m, s, entry, r);
	return m;
}

const struct psd *
moved_product(const struct session *s, const struct entry *entry,
    const struct params *params, size_t run, size_t feed_run)
{
	const struct psd *measured = &entry->site->run[run].product;
	if (params == NULL || !entry->site->individual_feeds)
		return measured;
	return &moved_by(s, entry, params, feed_run)->product[run];
}

double
moved_most(const struct session *s, const struct entry *entry,
    const struct params *params, size_t feed_run)
{
	const struct site *site = entry->site;
	if (params == NULL || !site->individual_feeds || site->with[0] != '\0')
		return 0;
	return moved_by(s, entry, params, feed_run)->most;
}
