/* What a site is predicted with: its parameters alone, or with what was drawn
 * from the posterior of the calibration that found them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_OUTLOOK_H
#define TIPSPEED_CMD_ASK_OUTLOOK_H

#include "cmd/session/session.h"
#include "core/answer/crusher.h"
#include "core/posterior/ensemble.h"
#include "core/answer/predict.h"
#include "io/formats/answer.h"

/* The runs that inform the entry's answers: as set, or as it is asked. */
enum correction outlook_correction(
    const struct session *s, const struct entry *entry);

/* The posterior that all measured runs inform, or the training runs only, of
 * the calibration that found the entry's parameters, on this site or another
 * one; drawn when first asked for, which takes 0.1 s.  NULL where no
 * calibration of this session found them, or one of too few data, or where
 * somebody stopped it. */
const struct posterior *outlook_posterior(const struct session *s,
    const struct entry *entry, enum correction correction);

/* That of the training runs, drawn by one thread, which may be one of several,
 * and kept nowhere: posterior_free.  NULL too where answers are the model
 * alone. */
struct posterior *outlook_beside(
    const struct session *s, const struct entry *entry);

/* Draws a part of what outlook_draws gives; true when that is all there, or
 * there is nothing to draw from. */
bool outlook_draw(const struct session *s, const struct entry *entry);

/* The one that is set; that of the training runs where answers are the model
 * alone. */
const struct posterior *outlook_draws(
    const struct session *s, const struct entry *entry);

/* That of a calibration whose answers have a band, of the runs that are set to
 * inform them, though these be the model alone, or of its training runs only:
 * what cuts are compared with that it has not seen.  NULL where there is no
 * band but for what is set. */
const struct posterior *outlook_unseen(
    const struct session *s, const struct entry *entry, bool training_only);

/* What the calibration that found the entry's parameters shows of itself, by
 * the runs that inform the answers; NULL where none of this session did.  Kept
 * with it. */
const struct evidence *outlook_evidence(
    const struct session *s, const struct entry *entry);

/* The same of an entry that was calibrated, without draws. */
struct evidence outlook_undrawn(
    const struct session *s, const struct entry *entry);

/* How far the feed of that run differs from the most similar of those that
 * inform the answers: the largest difference, passing 0..1.  Only with such
 * evidence. */
double outlook_feed_difference(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* The products of its draws from the entry's feed of that run, at its sieves
 * and others between (predict_sizes); NULL where there is none, where answers
 * are the model alone, or for a fit made with other settings.  Kept until
 * another is asked for. */
struct ensemble *outlook_ensemble(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* The settings that are set, with what another machine does otherwise. */
struct model_settings outlook_settings(
    const struct session *s, const struct entry *entry);

/* What the entry's answers are drawn from, formed with these parameters; NULL:
 * they are the model alone. */
const struct posterior *outlook_answering(const struct session *s,
    const struct entry *entry, const struct params *params);

/* The crusher of the entry's answers, for any feed, with classes between sizes
 * [n]; crusher_free. */
struct crusher *outlook_crusher(const struct session *s,
    const struct entry *entry, const double *size, size_t n);

/* Why there is no band, as a sentence.  Not to be asked where there is one. */
const char *outlook_why_none(
    const struct session *s, const struct entry *entry);

/* Which runs inform the answer, in words for a head or a title: "corrected by
 * all runs", "corrected by the training runs", "model alone". */
const char *outlook_words(const struct session *s, const struct entry *entry);

/* Says what low and high are, of parameters or of a product, and of this which
 * runs correct it; of another site's parameters they are what its data leave
 * open, and know nothing of the difference between the two. */
void outlook_note(struct answer *r, const struct session *s,
    const struct entry *entry, bool product);

/* What outlook_words has, behind a name in a legend: ", all runs", ", training
 * runs", or "" where the prediction is the model alone and nothing else was
 * asked for; ", model" where it is what was asked for. */
const char *outlook_short(const struct session *s, const struct entry *entry,
    const struct prediction *p);

#endif
