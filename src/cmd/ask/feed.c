/* The names of feeds; question.c chooses the feed (D19).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/feed.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

size_t
feed_sampled_at(const struct site *site, double speed)
{
	size_t run = speed > 0 ? site_run_at(site, speed) : site->n_run;
	return run < site->n_run ? run : SITE_MEAN_FEED;
}

bool
feed_find_sampled(
    const struct site *site, double speed, size_t *feed, struct error *error)
{
	*feed = feed_sampled_at(site, speed);
	return *feed != SITE_MEAN_FEED ||
	       error_set(error, ERROR_USAGE,
		   "%s has no feed sampled at %g m/s\n"
		   "run 'show feed' for its feeds",
		   site->name, speed);
}

double
feed_speed(const struct site *site, size_t run)
{
	return run < site->n_run && site->run[run].speed >= 0
		   ? site->run[run].speed
		   : NAN;
}

/* "69, 74, 79": each speed once, in rpm of a rotor unless its diameter is 0. */
static char *
sampled_speeds(const struct site *site, double diameter)
{
	char *speeds = xstrdup("");
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed > 0 && !site_run_repeats(site, r) &&
		    !(site->run[r].feed_speed > 0))
			xlist(&speeds, ", ", diameter > 0 ? "%.0f" : "%g",
			    diameter > 0
				? rotor_speed_rpm(site->run[r].speed, diameter)
				: site->run[r].speed);
	return speeds;
}

static char *
sampled_words(const struct site *site, double speed, const char *repeat)
{
	FREED char *rpm = rotor_speed_words(site_run_rotor(site), speed, NAN);
	return xasprintf(tr("sampled at %g m/s%s%s"), speed, repeat, rpm);
}

char *
feed_words(const struct site *site, size_t run)
{
	double sieve, most;
	bool other = site_run_at(site, SITE_OTHER_FEED) < site->n_run;
	if (!site->individual_feeds || other)
		return NULL;
	if (run < site->n_run && site->run[run].feed_speed > 0)
		return sampled_words(site, site->run[run].feed_speed, "");
	if (run < site->n_run)
		return sampled_words(
		    site, site->run[run].speed, site->run[run].repeat);
	most = site_feeds_differ(site, &sieve);
	if (!(most > 0))
		return NULL;
	FREED char *speeds = sampled_speeds(site, 0);
	double rotor = site_run_rotor(site);
	FREED char *list = sampled_speeds(site, rotor);
	FREED char *rpm =
	    rotor > 0 ? xasprintf(tr(" (%s rpm)"), list) : xstrdup("");
	return xasprintf(tr("mean of those sampled at %s m/s%s, which "
			    "differ by up to %.1f points at %g mm"),
	    speeds, rpm, 100 * most, units_mm(sieve));
}

void
feed_note(struct answer *r, const struct site *site, size_t run,
    const char *whose, double moved)
{
	FREED char *words = feed_words(site, run);
	if (words != NULL && whose != NULL) {
		answer_say(r, ANSWER_REMARK, "feed of %s: %s", whose, words);
	} else if (words != NULL && moved > 0) {
		answer_say(r, ANSWER_REMARK,
		    "feed: %s; measured products moved to it, by up to %.1f "
		    "points",
		    words, 100 * moved);
	} else if (words != NULL) {
		answer_say(r, ANSWER_REMARK, "feed: %s", words);
	}
	if (words != NULL && whose == NULL)
		fields_put(answer_fields(r), "feed %s", words);
}

void
feed_note_assumed(struct answer *r, const struct site *site, const char *whose)
{
	double top = site_assumed_top(site);
	if (!(top > 0))
		return;
	answer_say(r, ANSWER_REMARK,
	    "assumed%s%s: all of the feed passes %g mm",
	    whose != NULL ? tr(" of ") : "", whose != NULL ? whose : "", top);
	if (whose == NULL)
		fields_put(answer_fields(r), SITE_ASSUMED_TOP " %g", top);
}
