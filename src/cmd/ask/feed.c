/* Names feeds; question.c chooses them (D19).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/feed.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/journal.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

size_t
feed_run_at_speed_or_mean(const struct site *site, double speed)
{
	size_t run = speed > 0 ? site_run_at_speed(site, speed) : site->n_run;
	for (; run < site->n_run && fabs(site->run[run].speed - speed) <= 1e-3;
	     run++)
		if (!site->individual_feeds || !site->run[run].lacks_feed)
			return run;
	return SITE_MEAN_FEED;
}

bool
feed_find_run_sampled_at_speed(
    const struct site *site, double speed, size_t *feed, struct error *error)
{
	FREED char *rpm =
	    rotor_speed_rpm_text(site_run_rotor_diameter(site), speed, NAN);
	*feed = feed_run_at_speed_or_mean(site, speed);
	return *feed != SITE_MEAN_FEED ||
	       error_set(error, ERROR_USAGE,
		   "%s has no feed sampled at %g m/s%s\n"
		   "'show feed' shows them, 'set feed mean' takes their mean",
		   site->name, speed, rpm);
}

double
feed_sampling_speed(const struct site *site, size_t run)
{
	return run < site->n_run && site->run[run].speed >= 0
		   ? site->run[run].speed
		   : NAN;
}

/* Returns "69, 74, 79", each speed once at which a feed was sampled; in rpm if
 * the diameter of the rotor is not 0.  The caller frees it. */
static char *
feed_sampling_speeds_text(const struct site *site, double diameter)
{
	char *speeds = xstrdup("");
	double before = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (!(site->run[r].speed > before) || site->run[r].lacks_feed)
			continue;
		before = site->run[r].speed;
		xappend_to_list(&speeds, ", ", diameter > 0 ? "%.0f" : "%g",
		    diameter > 0 ? rotor_speed_to_rpm(before, diameter)
				 : before);
	}
	return speeds;
}

char *
feed_sampling_text(const struct site *site, size_t run)
{
	double sieve, most;
	bool other = site_run_at_speed(site, SITE_OTHER_FEED) < site->n_run;
	if (!site->individual_feeds || other)
		return NULL;
	double rotor = site_run_rotor_diameter(site);
	if (run < site->n_run && !site->run[run].lacks_feed) {
		const struct run *of = &site->run[run];
		FREED char *in = rotor_speed_rpm_text(rotor, of->speed, NAN);
		return xasprintf(
		    tr("sampled at %g m/s%s%s"), of->speed, of->repeat, in);
	}
	most = site_largest_difference_of_feeds(site, &sieve);
	if (!(most > 0))
		return NULL;
	FREED char *speeds = feed_sampling_speeds_text(site, 0);
	FREED char *list = feed_sampling_speeds_text(site, rotor);
	FREED char *rpm =
	    rotor > 0 ? xasprintf(tr(" (%s rpm)"), list) : xstrdup("");
	return xasprintf(tr("mean of those sampled at %s m/s%s, which "
			    "differ by up to %.1f points at %g mm"),
	    speeds, rpm, 100 * most, units_m_to_mm(sieve));
}

void
feed_add_note_to_answer(struct answer *r, const struct site *site, size_t run,
    const char *whose, double moved)
{
	FREED char *words = feed_sampling_text(site, run);
	if (words != NULL && whose != NULL) {
		answer_add_sentence(
		    r, ANSWER_REMARK, "feed of %s: %s", whose, words);
	} else if (words != NULL && moved > 0) {
		answer_add_sentence(r, ANSWER_REMARK,
		    "feed: %s; measured products moved to it, by up to %.1f "
		    "points",
		    words, 100 * moved);
	} else if (words != NULL) {
		answer_add_sentence(r, ANSWER_REMARK, "feed: %s", words);
	}
	if (words != NULL && whose == NULL)
		fields_put_values(answer_json_fields(r), "feed %s", words);
	if (words != NULL && whose == NULL && run < site->n_run)
		answer_repeat_fields_in_rows(r, "feed");
}

void
feed_note_assumed_top_size(
    struct answer *r, const struct site *site, const char *whose)
{
	double top = site_assumed_top_size(site);
	if (!(top > 0))
		return;
	answer_add_sentence(r, ANSWER_REMARK,
	    "assumed%s%s: all of the feed passes %g mm",
	    whose != NULL ? tr(" of ") : "", whose != NULL ? whose : "", top);
	if (whose == NULL)
		fields_put_values(
		    answer_json_fields(r), SITE_ASSUMED_TOP " %g", top);
}

void
feed_note_how_to_set_top_size(struct answer *r, const struct site *site)
{
	double top = site_assumed_top_size(site);
	if (!(top > 0) || site->path[0] == '\0')
		return;
	FREED char *line = xstrdup("load");
	journal_append_quoted_word(&line, site->path);
	answer_note(r,
	    "All of the feed is assumed to pass %g mm, which its sheet does "
	    "not state; to assume another size, in mm: %s top=SIZE",
	    top, line);
}
