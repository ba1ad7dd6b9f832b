/* What predicts a site: its parameters alone, or with draws from the posterior
 * of the calibration that found them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_OUTLOOK_H
#define TIPSPEED_CMD_ASK_OUTLOOK_H

#include "cmd/session/session.h"
#include "core/answer/crusher.h"
#include "core/posterior/ensemble.h"
#include "core/answer/predict.h"
#include "io/formats/answer.h"

/* Returns the runs that inform the entry's answers: as set, or as asked for. */
enum correction outlook_correction(
    const struct session *s, const struct entry *entry);

/* Returns the posterior, informed by all measured runs or by the training runs
 * only, of the calibration that found the entry's parameters, on this site or
 * another one; drawn when first asked for, which takes 0.1 s.  NULL where no
 * calibration of this session found them, or one of too few data, or where the
 * user stopped it. */
const struct posterior *outlook_posterior(const struct session *s,
    const struct entry *entry, enum correction correction);

/* Draws the posterior of the training runs in one thread, which may be one of
 * several, and keeps it nowhere: free with posterior_free.  NULL also where
 * answers are the model alone. */
struct posterior *outlook_begin_draws(
    const struct session *s, const struct entry *entry);

/* Draws a part of the posterior that outlook_draws returns; true when all of it
 * is drawn, or there is nothing to draw from. */
bool outlook_draw(const struct session *s, const struct entry *entry);

/* Returns the posterior of the runs that are set to inform answers; that of the
 * training runs where answers are the model alone. */
const struct posterior *outlook_draws(
    const struct session *s, const struct entry *entry);

/* Returns the posterior of a calibration whose answers have a band: from the
 * runs that are set to inform answers, even if these are the model alone, or
 * with training_only from the training runs, to compare with cuts that it has
 * not seen.  NULL where there is no band for a reason other than the
 * settings. */
const struct posterior *outlook_posterior_of_unseen(
    const struct session *s, const struct entry *entry, bool training_only);

/* Returns the evidence of the calibration that found the entry's parameters, by
 * the runs that inform the answers; NULL where no calibration of this session
 * did.  Kept with the calibration. */
const struct evidence *outlook_evidence(
    const struct session *s, const struct entry *entry);

/* As outlook_evidence, for an entry that was calibrated, but without draws. */
struct evidence outlook_evidence_without_draws(
    const struct session *s, const struct entry *entry);

/* Returns how far the feed of that run differs from the most similar of those
 * that inform the answers: the largest difference, passing 0..1.  Call it only
 * where outlook_evidence is not NULL. */
double outlook_feed_difference(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the products of the draws from the entry's feed of that run, at its
 * sieves and others between (predict_sizes); NULL without draws, where answers
 * are the model alone, or for a fit made with other settings.  Kept until
 * another is asked for. */
struct ensemble *outlook_ensemble(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the settings that are set, with the changes of another machine. */
struct model_settings outlook_settings(
    const struct session *s, const struct entry *entry);

/* Returns the posterior that the entry's answers with these parameters are
 * drawn from; NULL: they are the model alone. */
const struct posterior *outlook_posterior_for_answers(const struct session *s,
    const struct entry *entry, const struct params *params);

/* Returns the crusher of the entry's answers, for any feed, with classes
 * between sizes [n]; free with crusher_free. */
struct crusher *outlook_crusher(const struct session *s,
    const struct entry *entry, const double *size, size_t n);

/* Returns why there is no band, as a sentence.  Not to be called where there is
 * one. */
const char *outlook_why_none(
    const struct session *s, const struct entry *entry);

/* Returns which runs inform the answer, in words for a head or a title: "model
 * corrected by all measured runs", "model corrected by the training runs", "the
 * model alone". */
const char *outlook_words(const struct session *s, const struct entry *entry);

/* Notes what low and high mean, for parameters or for a product, and for a
 * product which runs correct it.  With another site's parameters they show what
 * its data leave open, not how the two sites differ. */
void outlook_note_low_high(struct answer *r, const struct session *s,
    const struct entry *entry, bool product);

/* Returns the words of outlook_words to follow a name in a legend: ", all
 * runs", ", training runs"; "" where the prediction is the model alone though
 * something else was asked for; ", model" where the model alone was asked
 * for. */
const char *outlook_short_words(const struct session *s,
    const struct entry *entry, const struct prediction *p);

#endif
