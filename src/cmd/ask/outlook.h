/* Where a site's predictions come from: its parameters alone, or also draws
 * from the posterior of the calibration that found them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_OUTLOOK_H
#define TIPSPEED_CMD_ASK_OUTLOOK_H

#include "cmd/session/session.h"
#include "core/answer/crusher.h"
#include "core/posterior/ensemble.h"
#include "core/answer/predict.h"
#include "io/formats/answer.h"

/* Returns which runs correct the model in the entry's answers: as the question
 * says, or else as set. */
enum correction correction_in_use(
    const struct session *s, const struct entry *entry);

/* Returns the posterior of the calibration that found the entry's parameters,
 * on this site or another, given all measured runs or only the training runs.
 * The first call draws it, which takes 0.1 s.  NULL if no calibration in this
 * session found them, if it had too few data, or if the user stopped it or the
 * drawing. */
const struct posterior *posterior_of_calibration(const struct session *s,
    const struct entry *entry, enum correction correction);

/* Draws the posterior given the training runs, and does not cache it.  May run
 * in several threads at once.  NULL as for posterior_of_calibration, and if
 * answers are those of the model alone.  Free with posterior_free. */
struct posterior *posterior_new_of_training_runs(
    const struct session *s, const struct entry *entry);

/* Draws a part of the posterior that posterior_even_if_correction_off returns.
 * Returns true once it is complete, or if there is nothing to draw from. */
bool posterior_sample_a_part(
    const struct session *s, const struct entry *entry);

/* Returns the posterior given the runs that correct the model or, if answers
 * are those of the model alone, given the training runs. */
const struct posterior *posterior_even_if_correction_off(
    const struct session *s, const struct entry *entry);

/* Returns the posterior of a calibration, for comparison with cuts that it did
 * not use: the one given the training runs if training_only is true, otherwise
 * that of posterior_even_if_correction_off.  NULL if answers have no band for a
 * reason other than `set correction off`. */
const struct posterior *posterior_for_unseen_cuts(
    const struct session *s, const struct entry *entry, bool training_only);

/* Returns the evidence about the calibration that found the entry's parameters,
 * from the runs that correct the model; NULL if no calibration in this session
 * found them.  Cached with the calibration. */
const struct evidence *trust_evidence_of_calibration(
    const struct session *s, const struct entry *entry);

/* As trust_evidence_of_calibration, but for an entry that has a fit, and
 * without draws. */
struct evidence trust_evidence_without_posterior(
    const struct session *s, const struct entry *entry);

/* Returns the largest difference, passing 0..1, between the feed of a run and
 * the most similar feed of the runs that correct the model.  Call it only if
 * trust_evidence_of_calibration does not return NULL. */
double difference_from_nearest_feed(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the products of the draws for the feed of a run, at the sizes of
 * predict_list_table_sieves.  NULL without draws, if answers are those of the
 * model alone, or if the fit was made with other settings.  Cached until
 * another is requested. */
struct ensemble *ensemble_for_answers(
    const struct session *s, const struct entry *entry, size_t feed_run);

/* Returns the current settings of the model, with the changes that the question
 * makes to the machine. */
struct model_settings model_settings_with_scenario(
    const struct session *s, const struct entry *entry);

/* Returns the posterior behind the entry's answers with these parameters, or
 * NULL if they are those of the model alone. */
const struct posterior *posterior_if_params_of_entry(const struct session *s,
    const struct entry *entry, const struct params *params);

/* Returns the crusher behind the entry's answers, for any feed, with classes
 * between sizes [n].  Free with crusher_free. */
struct crusher *crusher_new_for_answers(const struct session *s,
    const struct entry *entry, const double *size, size_t n);

/* Returns a sentence that says why there is no band.  Do not call it if there
 * is one. */
const char *band_why_missing(
    const struct session *s, const struct entry *entry);

/* Sets the error that says why there is no band, and what to do to get one.
 * Returns false. */
bool band_set_error_missing(
    const struct session *s, const struct entry *entry, struct error *error);

/* Returns "all", "train" or "off", the correction in use as programs get it. */
const char *correction_name(const struct session *s, const struct entry *entry);

/* Returns which runs correct the model, in words for a heading or a title:
 * "model corrected by all measured runs", "model corrected by the training
 * runs" or "the model alone". */
const char *correction_in_words(
    const struct session *s, const struct entry *entry);

/* Notes which runs correct the model, unless all do. */
void correction_note_unless_all(
    struct answer *r, const struct session *s, const struct entry *entry);

/* Notes what low and high mean for parameters or a product and, for a product,
 * which runs correct the model.  With another site's parameters, the range
 * shows how uncertain they are there, not how the two sites differ. */
void band_note_meaning(struct answer *r, const struct session *s,
    const struct entry *entry, bool product);

/* Returns correction_in_words in short, to follow a name in a legend: ", all
 * runs" or ", training runs"; ", model" if the user asked for the model alone;
 * "" if the prediction is that of the model alone for another reason. */
const char *correction_legend_text(const struct session *s,
    const struct entry *entry, const struct prediction *p);

#endif
