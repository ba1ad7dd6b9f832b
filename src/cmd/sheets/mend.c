/* mend: applies one of the mends that check proposes, or one given in words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/mend.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/sites.h"
#include "cmd/session/invocation.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/table.h"
#include "io/sitefile/units.h"

/* Returns the posterior if the site was calibrated on its present data, or
 * NULL. */
static const struct posterior *
posterior_if_data_unchanged(const struct session *s, const struct entry *entry)
{
	if (origin_fit_behind_params(entry) == NULL ||
	    session_is_calibrating(s) ||
	    entry->origin->history->site != entry->site)
		return NULL;
	return posterior_of_calibration(s, entry, CORRECTION_ALL);
}

bool
mend_can_use_calibration(const struct session *s, const struct entry *entry)
{
	return posterior_if_data_unchanged(s, entry) != NULL;
}

struct outlier_findings
mend_find_faults(const struct session *s, const struct entry *entry)
{
	return outliers_find(entry->site, posterior_if_data_unchanged(s, entry),
	    s->set.noise / 100);
}

/* ---- Reporting ---- */

static const char *const KINDS[] = {[MEND_READ] = "read",
    [MEND_OUT] = "leave out",
    [MEND_SWAP_FEED] = "swap with feed",
    [MEND_UP] = "move up",
    [MEND_DOWN] = "move down",
    [MEND_SWAP_RUNS] = "exchange",
    [MEND_SCALE] = "scale sieves",
    [MEND_DROP] = "drop run"};

char *
mend_to_command_text(const struct site *site, const struct mend *m)
{
	static const char *const DO[] = {[MEND_OUT] = "out",
	    [MEND_SWAP_FEED] = "swap",
	    [MEND_UP] = "up",
	    [MEND_DOWN] = "down",
	    [MEND_DROP] = "drop"};
	FREED char *name = mend_name_of_column(site, m->feed, m->run);
	FREED char *with = mend_name_of_column(site, false, m->other);
	char *call = xasprintf("mend %s", name), number[32];
	if (m->kind == MEND_READ || m->kind == MEND_OUT)
		xappend(&call, " sieve=%s",
		    text_shortest_exact_number(units_m_to_mm(m->size), number));
	if (m->kind == MEND_READ)
		xappend(&call, " value=%s",
		    text_shortest_exact_number(
			units_fraction_to_pct(m->value), number));
	else if (m->kind == MEND_SCALE)
		xappend(&call, " scale=%g", m->value);
	else if (m->kind == MEND_SWAP_RUNS)
		xappend(&call, " with=%s", with);
	else
		xappend(&call, " do=%s", DO[m->kind]);
	return call;
}

/* Returns what the mend would change: "off by 3.10 points now, 0.20 with the
 * mend". */
static char *
mend_effect_text(const struct finding *f)
{
	char *text = xstrdup("");
	if (!isnan(f->off[0]))
		xappend_to_list(&text, "; ",
		    tr("off by %.2f points now, %.2f with the mend"),
		    100 * f->off[0], 100 * f->off[1]);
	if (!isnan(f->rmse[0]) && !isnan(f->rmse[1]))
		xappend_to_list(&text, "; ",
		    tr("RMSE of the fit %.2f points now, %.2f with the mend, "
		       "and less after another calibration"),
		    100 * f->rmse[0], 100 * f->rmse[1]);
	return text;
}

char *
mend_finding_text(const struct site *site, const struct finding *f)
{
	const struct mend *m = &f->mend;
	if (m->kind != MEND_READ && m->kind != MEND_OUT) {
		FREED char *effect = mend_effect_text(f);
		char *words = mend_description(site, m);
		if (effect[0] != '\0')
			xappend_to_list(&words, "; ", "%s", effect);
		return words;
	}
	const char *what = m->feed ? tr("feed") : tr("product");
	const char *ask = m->kind == MEND_READ
			      ? tr("were digits transposed?")
			      : tr("measure it again, or leave it out");
	if (isnan(f->expected))
		return xasprintf(tr("%s passing %g %% at %g mm is off the line "
				    "between its neighbours: %s"),
		    what, units_fraction_to_pct(f->measured),
		    units_m_to_mm(m->size), ask);
	return xasprintf(
	    tr("%s passing %g %% at %g mm, where %.1f (sd %.1f) is expected "
	       "%s: %s"),
	    what, units_fraction_to_pct(f->measured), units_m_to_mm(m->size),
	    100 * f->expected, 100 * f->sd,
	    isnan(f->surprise) ? tr("by its neighbours and the other runs")
			       : tr("by all other passings and the fit"),
	    ask);
}

static void
add_numbered_mend(struct answer *r, struct fields *list,
    const struct entry *entry, const struct finding *f, size_t number)
{
	const struct site *site = entry->site;
	const struct mend *m = &f->mend;
	bool cell = m->kind == MEND_READ || m->kind == MEND_OUT;
	FREED char *words = mend_description(site, m),
		   *effect = mend_effect_text(f);
	FREED char *name = mend_name_of_column(site, m->feed, m->run);
	FREED char *call = mend_to_command_text(site, m);
	answer_note(r,
	    effect[0] != '\0' ? "mend %zu: %s; %s" : "mend %zu: %s%s", number,
	    words, effect);
	struct fields *o = fields_add_object(list, NULL);
	fields_put_values(o, "n %zu kind %s run %s sieve_mm %g from %g to %g",
	    number, KINDS[m->kind], name, cell ? units_m_to_mm(m->size) : NAN,
	    units_fraction_to_pct(f->measured),
	    m->kind == MEND_READ ? units_fraction_to_pct(m->value) : NAN);
	fields_put_values(o, "expected %g sd %g surprise %g",
	    units_fraction_to_pct(f->expected), 100 * f->sd, f->surprise);
	fields_put_values(o, "rmse_pct %g mended_rmse_pct %g words %s call %s",
	    100 * f->rmse[0], 100 * f->rmse[1], words, call);
}

/* Returns a number that identifies this list of mends of this site. */
static double
digest_of_mend_list(const struct entry *entry, const struct outlier_findings *d)
{
	uint64_t h = TEXT_DIGEST_START;
	h = text_fnv1a_digest(
	    h, &entry->site->digest, sizeof entry->site->digest);
	for (size_t i = 0; i < d->n; i++) {
		FREED char *call =
		    mend_to_command_text(entry->site, &d->finding[i].mend);
		h = text_fnv1a_digest(h, call, strlen(call) + 1);
	}
	return (double)(h >> 12);
}

void
mend_add_numbered_list(struct answer *r, const struct entry *entry,
    const struct outlier_findings *d)
{
	struct fields *list = fields_add_list(answer_json_fields(r), "mends");
	for (size_t i = 0; i < d->n; i++)
		add_numbered_mend(r, list, entry, &d->finding[i], i + 1);
	fields_put_values(
	    answer_json_fields(r), ".mark %g", digest_of_mend_list(entry, d));
	if (d->n > 0)
		answer_note(r, "'mend N' makes one of these corrections, once "
			       "the laboratory's sheet confirms it; 'undo' "
			       "reverses it; nothing is changed until then");
}

/* ---- Applying ---- */

static bool
find_mend_by_number(
    struct session *s, const char *word, struct mend *mend, struct error *error)
{
	const struct entry *entry = session_current_site_entry(s);
	double known = session_number_in_last_answer(s, "check mend", "mark");
	struct outlier_findings d = mend_find_faults(s, entry);
	unsigned long n = strtoul(word, NULL, 10);
	bool ok = false;
	if (isnan(known) || known != digest_of_mend_list(entry, &d))
		error_set(error, ERROR_USAGE,
		    isnan(known)
			? N_("no mends were listed yet, so there is no mend "
			     "%s\n"
			     "run 'check' first")
			: N_("mend %s is from an earlier list: the data or the "
			     "fit have changed since\nrun 'check' again"),
		    word);
	else if (d.n == 0)
		error_set(error, ERROR_USAGE,
		    "no mend is proposed for %s\n"
		    "name a column to mend it: 'help mend'",
		    entry->key);
	else if (n < 1 || n > d.n)
		error_set(error, ERROR_USAGE,
		    "expected a mend from 1 to %zu, got %s\n"
		    "run 'mend' to list them",
		    d.n, word);
	else {
		*mend = d.finding[n - 1].mend;
		ok = true;
	}
	outliers_free(&d);
	return ok;
}

static bool
set_mend_kind_from_options(const struct args *args, struct mend *mend)
{
	static const enum mend_kind DO[] = {
	    MEND_OUT, MEND_SWAP_FEED, MEND_UP, MEND_DOWN, MEND_DROP};
	bool value = args_is_given(args, &args->mend_value);
	mend->size = args->sieve / 1000;
	mend->kind = value                ? MEND_READ
		     : args->scale > 0    ? MEND_SCALE
		     : args->with == NULL ? DO[args->mend_do]
					  : MEND_SWAP_RUNS;
	mend->value = value ? args->mend_value / 100 : args->scale;
	bool cell = mend->kind == MEND_READ || mend->kind == MEND_OUT;
	bool product = mend->kind == MEND_SWAP_FEED ||
		       mend->kind == MEND_SWAP_RUNS || mend->kind == MEND_DROP;
	return cell == (args->sieve > 0) && !(product && mend->feed);
}

static bool
set_unknown_column_error(
    const struct site *site, const char *name, struct error *error)
{
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < 2 * site->n_run; i++) {
		bool feed = i < site->n_run;
		size_t r = i % site->n_run;
		if (feed ? !site_run_has_feed_sample(site, r)
			 : site->run[r].product.n == 0)
			continue;
		FREED char *own = mend_name_of_column(site, feed, r);
		xappend_to_list(&list, ", ", "%s", own);
	}
	return error_set(error, ERROR_USAGE,
	    "the site has no column '%s'\n"
	    "use a number that check gave, or one of: %s",
	    name, list);
}

static bool
parse_mend_options(const struct site *site, const struct args *args,
    struct mend *mend, struct error *error)
{
	const char *name = args->operand[0], *with = args->with;
	bool feed = false;
	if (!mend_find_column_by_name(site, name, &mend->feed, &mend->run))
		return set_unknown_column_error(site, name, error);
	int ways = args_is_given(args, &args->mend_value) +
		   args_is_given(args, &args->mend_do) + (with != NULL) +
		   (args->scale > 0);
	if (ways != 1 || !set_mend_kind_from_options(args, mend))
		return error_set(error, ERROR_USAGE,
		    "expected what to do with %s\n"
		    "use sieve=MM value=PERCENT, sieve=MM do=out, do=up, "
		    "do=down or scale=X; of a product also do=swap, do=drop or "
		    "with=product@SPEED",
		    name);
	if (with == NULL)
		return true;
	if (!mend_find_column_by_name(site, with, &feed, &mend->other) ||
	    feed || mend->other == mend->run)
		return set_unknown_column_error(site, with, error);
	return true;
}

bool
cmd_mend(struct session *s, const struct args *args, struct error *error)
{
	struct mend mend = {.kind = MEND_READ};
	const struct entry *entry = session_current_site_entry(s);
	if (args->n_operand == 0) {
		struct answer *r = answer_new("mend");
		struct outlier_findings d = mend_find_faults(s, entry);
		mend_add_numbered_list(r, entry, &d);
		if (d.n == 0)
			answer_note(
			    r, "no mend is proposed for %s", entry->key);
		outliers_free(&d);
		return session_show_answer(s, r);
	}
	const char *word = args->operand[0];
	bool number = word[strspn(word, "0123456789")] == '\0';
	bool found = number && word[0] != '\0'
			 ? find_mend_by_number(s, word, &mend, error)
			 : parse_mend_options(entry->site, args, &mend, error);
	struct site *site =
	    found ? site_with_mend(entry->site, &mend, error) : NULL;
	if (site == NULL)
		return false;
	FREED char *words = mend_description(entry->site, &mend);
	xfree_and_set(
	    &s->invocation->line, mend_to_command_text(entry->site, &mend));
	bool fitted = session_replace_site_by_mended(s, site);
	session_print_note(s, "mended: %s", words);
	if (fitted)
		session_print_note(s, "  the data have changed since the "
				      "calibration: calibrate again");
	session_print_note(s, "  its file is unchanged: 'write FILE' saves the "
			      "mended sheet, 'undo' reverses the mend");
	return true;
}
