/* The basis of a site's predictions: its parameters alone, or with draws from
 * the posterior of the calibration that found them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_OUTLOOK_H
#define TIPSPEED_CMD_ASK_OUTLOOK_H

#include "cmd/session/session.h"
#include "core/answer/crusher.h"
#include "core/posterior/ensemble.h"
#include "core/answer/predict.h"
#include "io/formats/answer.h"

/* Returns which runs inform the entry's answers, as set or as the question
 * says. */
enum correction correction_in_use(
    const struct session *s, const struct entry *entry);

/* Returns the posterior, informed by all measured runs or only by the training
 * runs, of the calibration that found the entry's parameters, on this site or
 * another.  The first call draws it, which takes 0.1 s.  NULL if no calibration
 * in this session found them, if it had too few data, or if the user stopped
 * it. */
const struct posterior *posterior_of_calibration(const struct session *s,
    const struct entry *entry, enum correction correction);

/* Draws the posterior of the training runs and returns it without caching it.
 * May be called in several threads at once.  NULL also if answers are the model
 * alone.  Free with posterior_free. */
struct posterior *posterior_new_of_training_runs(
    const struct session *s, const struct entry *entry);

/* Draws a part of the posterior that posterior_for_comparison returns.
 * Returns true if all of it is drawn or there is nothing to draw from. */
bool posterior_sample_a_part(
    const struct session *s, const struct entry *entry);

/* Returns the posterior of the runs set to inform answers, or that of the
 * training runs if answers are the model alone. */
const struct posterior *posterior_for_comparison(
    const struct session *s, const struct entry *entry);

/* Returns the posterior of a calibration, for comparison with cuts that it has
 * not seen: that of posterior_for_comparison or, with training_only,
 * that of the training runs.  NULL if answers lack a band for a reason other
 * than `set correction off`. */
const struct posterior *posterior_for_unseen_cuts(
    const struct session *s, const struct entry *entry, bool training_only);

/* Returns the evidence on the calibration that found the entry's parameters,
 * from the runs that inform the answers, or NULL if no calibration in this
 * session did.  Cached with the calibration. */
const struct evidence *evidence_on_calibration(
    const struct session *s, const struct entry *entry);

/* As evidence_on_calibration, but for a calibrated entry and without draws. */
struct evidence evidence_without_draws(
    const struct session *s, const struct entry *entry);

/* Returns the largest difference, passing 0..1, between the feed of that run
 * and the most similar feed that informs the answers.  Call it only if
 * evidence_on_calibration is not NULL. */
double difference_from_nearest_feed(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the products of the draws for the entry's feed of that run, at
 * predict_table_sizes, or NULL without draws, if answers are the model alone,
 * or for a fit made with other settings.  Cached until another is requested. */
struct ensemble *ensemble_for_answers(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the current settings, with the changes for another machine. */
struct model_settings model_settings_of_answer(
    const struct session *s, const struct entry *entry);

/* Returns the posterior behind the entry's answers with these parameters, or
 * NULL if they are the model alone. */
const struct posterior *posterior_for_answers(const struct session *s,
    const struct entry *entry, const struct params *params);

/* Returns the crusher for the entry's answers, for any feed, with classes
 * between sizes [n].  Free with crusher_free. */
struct crusher *crusher_new_for_answers(const struct session *s,
    const struct entry *entry, const double *size, size_t n);

/* Returns why there is no band, as a sentence.  Do not call it if there is a
 * band. */
const char *band_why_none(const struct session *s, const struct entry *entry);

/* Sets the error that there is no band, and what to do for one.  Returns
 * false. */
bool band_error_none(
    const struct session *s, const struct entry *entry, struct error *error);

/* Returns which runs inform the answer, in words for a heading or a title:
 * "model corrected by all measured runs", "model corrected by the training
 * runs" or "the model alone". */
const char *correction_in_words(
    const struct session *s, const struct entry *entry);

/* Notes what low and high mean, for parameters or a product, and which runs
 * correct a product.  With another site's parameters, they show what that
 * site's data leave open, not how the two sites differ. */
void band_note_meaning(struct answer *r, const struct session *s,
    const struct entry *entry, bool product);

/* Returns the words of correction_in_words to follow a name in a
 * legend: ", all runs"; ", training runs"; ", model" if the model alone was
 * requested; "" if the prediction is the model alone without such a request. */
const char *correction_in_legend(const struct session *s,
    const struct entry *entry, const struct prediction *p);

#endif
