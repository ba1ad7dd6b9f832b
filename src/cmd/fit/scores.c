/* RMSE, bias and R2 of each size over all runs (validate_score), how often each
 * way is the best, and the numbers of runs that parts hand on.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/scores.h"

#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"

const struct scores_way SCORES_WAYS[VALIDATE_WAYS] = {
    [VALIDATE_MODEL] = {"model", N_("model"), N_("the model")},
    [VALIDATE_CORRECTED] = {"corrected", N_("corrected"),
	N_("the corrected answer")},
    [VALIDATE_INTERPOLATION] = {"interpolation", N_("interpolated"),
	N_("interpolation")},
    [VALIDATE_NEAREST] = {"nearest", N_("nearest"),
	N_("the product at the nearest training speed")},
    [VALIDATE_FEED] = {"feed", N_("feed"), N_("the unchanged feed")}};

const char *const SCORES_SIZES[PSD_SIZES] = {"p20", "p50", "p80"};

void
scores_put_null(struct fields *o, const double rmse[static VALIDATE_WAYS])
{
	struct fields *null = fields_object(o, "null");
	for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
		FREED char *key =
		    xasprintf("%s_rmse_pct", SCORES_WAYS[way].key);
		fields_number(null, key, 100 * rmse[way]);
	}
}

void
scores_add(struct scores *scores, const struct scored *item)
{
	scores->item =
	    xrealloc(scores->item, scores->n + 1, sizeof *scores->item);
	struct scored *own = &scores->item[scores->n++];
	*own = *item;
	own->key = xstrdup(item->key);
	own->source = xstrdup(item->source);
}

void
scores_clear(struct scores *scores)
{
	for (size_t i = 0; i < scores->n; i++) {
		free(scores->item[i].key);
		free(scores->item[i].source);
	}
	free(scores->item);
	*scores = (struct scores){0};
}

/* Bias, rms and R2 of a size. */
static void
put_score(struct fields *o, size_t i, struct validate_score score)
{
	fields_put(fields_object(o, SCORES_SIZES[i]),
	    "n %zu bias_pct %g rms_pct %g r2 %g", score.n, 100 * score.bias,
	    100 * score.rms, score.r2);
}

static void
add_scores(struct answer *r, const struct scores *c)
{
	struct fields *o = answer_fields(r), *null = NULL;
	FREED const struct validation **v = xcalloc(c->n + 1, sizeof(*v));
	for (size_t k = 0; k < c->n; k++)
		v[k] = &c->item[k].v;
	answer_columns(r, "size, by: predicted by, n: runs, bias_pct: bias %%, "
			  "rms_pct: rms %%, r2: R2");
	for (size_t i = 0; i < PSD_SIZES; i++)
		for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
			struct validate_score score =
			    validate_score(v, c->n, way, i);
			answer_text(r, "P%.0f", 100 * PSD_PASSING[i]);
			answer_name(
			    r, SCORES_WAYS[way].key, tr(SCORES_WAYS[way].key));
			answer_cells(r, "%g %.2f %.2f %.4f", (double)score.n,
			    100 * score.bias, 100 * score.rms, score.r2);
			if (way == VALIDATE_MODEL)
				put_score(o, i, score);
		}
	struct fields *corrected = fields_object(o, "corrected");
	for (size_t i = 0; i < PSD_SIZES; i++)
		put_score(corrected, i,
		    validate_score(v, c->n, VALIDATE_CORRECTED, i));
	null = fields_object(o, "null");
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS;
	     way++) {
		struct fields *own = fields_object(null, SCORES_WAYS[way].key);
		for (size_t i = 0; i < PSD_SIZES; i++)
			put_score(own, i, validate_score(v, c->n, way, i));
	}
}

/* At how many runs each way is the best. */
static void
add_wins(struct answer *r, const struct scores *c)
{
	size_t wins[VALIDATE_WAYS] = {0};
	struct fields *o = fields_object(answer_fields(r), "wins");
	FREED char *list = xstrdup("");
	for (size_t k = 0; k < c->n; k++)
		wins[validate_winner(c->item[k].v.rmse)]++;
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		fields_number(o, SCORES_WAYS[way].key, (double)wins[way]);
		xlist(&list, ", ", "%s %zu", tr(SCORES_WAYS[way].noun),
		    wins[way]);
	}
	answer_note(
	    r, "best at how many of the %zu runs (RMSE): %s", c->n, list);
}

struct answer *
scores_answer(const struct scores *c)
{
	struct answer *r = answer_new("validate");
	FREED char *about = xstrdup("");
	size_t sites = 0;
	for (size_t k = 0; k < c->n; k++) {
		if (k > 0 && c->item[k].index == c->item[k - 1].index)
			continue;
		sites++;
		if (strstr(about, c->item[k].source) == NULL)
			xlist(&about, "; ", "%s", c->item[k].source);
	}
	answer_title(r,
	    c->each
		? tr_n("sizes at each speed held out in turn, %zu site",
		      "sizes at each speed held out in turn, %zu sites", sites)
		: tr_n("sizes at held-out speeds, %zu site",
		      "sizes at held-out speeds, %zu sites", sites),
	    sites);
	answer_sites(r, "all", about);
	fields_put(answer_fields(r), "sites %zu runs %zu", sites, c->n);
	add_scores(r, c);
	add_wins(r, c);
	if (c->each)
		fields_put(answer_fields(r), "holdout_each %d", true);
	if (c->left_out > 0)
		answer_say(r, ANSWER_REMARK,
		    c->each ? tr_n("%zu loaded site with fewer than three "
				   "speeds: not compared",
				  "%zu loaded sites with fewer than three "
				  "speeds: not compared",
				  c->left_out)
			    : tr_n("%zu loaded site without a calibration or a "
				   "held-out run: not compared",
				  "%zu loaded sites without a calibration or a "
				  "held-out run: not compared",
				  c->left_out),
		    c->left_out);
	return r;
}

/* What a score needs of a run, in one order. */
static void
scores_map_numbers(struct validation *v, double *number[static PART_NUMBERS])
{
	_Static_assert(
	    (int)PART_NUMBERS == PSD_SIZES + VALIDATE_WAYS * (1 + PSD_SIZES),
	    "as many as there are");
	for (size_t i = 0; i < PSD_SIZES; i++)
		*number++ = &v->measured[i];
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		*number++ = &v->rmse[way];
		for (size_t i = 0; i < PSD_SIZES; i++)
			*number++ = &v->size[way][i];
	}
}

void
scores_put(struct fields *o, const struct scores *scores)
{
	struct fields *list = fields_list(o, "rows");
	for (size_t k = 0; k < scores->n; k++) {
		struct validation v = scores->item[k].v;
		double *at[PART_NUMBERS], number[PART_NUMBERS];
		struct fields *row = fields_object(list, NULL);
		scores_map_numbers(&v, at);
		for (size_t i = 0; i < PART_NUMBERS; i++)
			number[i] = *at[i];
		fields_put(row, "site %s source %s", scores->item[k].key,
		    scores->item[k].source);
		fields_numbers(row, "numbers", number, PART_NUMBERS, NULL);
	}
}

void
scores_add_part_site(struct scores *scores, const struct part_site *site)
{
	struct scored item = {.index = site->index,
	    .key = site->text[0],
	    .source = site->text[1]};
	double *at[PART_NUMBERS];
	scores_map_numbers(&item.v, at);
	for (size_t i = 0; i < PART_NUMBERS; i++)
		*at[i] = site->number[i];
	scores_add(scores, &item);
}
