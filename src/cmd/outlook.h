/* What a site is predicted with: its parameters alone, or with what was drawn
 * from the posterior of the calibration that found them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_OUTLOOK_H
#define TIPSPEED_CMD_OUTLOOK_H

#include "cmd/session.h"
#include "core/inverse.h"
#include "core/predict.h"

/* The posterior that all measured runs inform, or the training runs only, of
 * the calibration that found the entry's parameters, on this site or another
 * one; drawn when first asked for, which takes 0.1 s.  NULL where no
 * calibration of this session found them, or one of too few data, or where
 * somebody stopped it. */
const struct posterior *outlook_posterior(const struct session *s,
    const struct entry *entry, enum correction correction);

/* The one that is set; that of the training runs where answers are the model
 * alone. */
const struct posterior *outlook_draws(
    const struct session *s, const struct entry *entry);

/* The products of its draws from the entry's feed of that run, at its sieves
 * and others between (predict_sizes); NULL where there is none, where answers
 * are the model alone, or for a fit made with other settings.  Kept until
 * another is asked for. */
struct ensemble *outlook_ensemble(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* The entry's answers from that feed on sieves [n], to be asked at many speeds;
 * inverse_free. */
struct inverse outlook_inverse(const struct session *s,
    const struct entry *entry, size_t feed_run, const double *sieve, size_t n);

/* The entry's product: the answer, with its band where there is one.
 * outlook_form: with other parameters, as while a calibration runs: the model
 * alone, unless they are the entry's. */
struct prediction outlook_predict(const struct session *s,
    const struct entry *entry, double speed, size_t feed_run);
struct prediction outlook_form(const struct session *s,
    const struct entry *entry, const struct params *params, double speed,
    size_t feed_run);

/* Why there is no band, as a sentence.  Not to be asked where there is one. */
const char *outlook_why_none(
    const struct session *s, const struct entry *entry);

/* Which runs inform the answer, in words for a head or a title: "corrected by
 * all runs", "corrected by the training runs", "model alone". */
const char *outlook_words(const struct session *s, const struct entry *entry);

/* The same behind a name in a legend: ", all runs", ", training runs", or ""
 * where the prediction is the model alone and nothing else was asked for;
 * ", model" where it is what was asked for. */
const char *outlook_short(const struct session *s, const struct prediction *p);

#endif
