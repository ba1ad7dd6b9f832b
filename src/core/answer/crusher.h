/* The transfer matrix of a crusher: its product from each size class at a
 * speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_CRUSHER_H
#define TIPSPEED_CORE_ANSWER_CRUSHER_H

#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"

/* Class i lies between sizes i and i + 1 of [n], m, coarsest first, with mass
 * uniform in ln d; the last class is the pan, which does not break.  A model's
 * product is linear in the feed, so the products of the classes determine the
 * product of any feed.  The discrepancy (discrepancy.h) depends on the model's
 * product of the whole feed. */
struct crusher;
struct posterior;

/* posterior: NULL for the model alone; else it must outlive the crusher.  The
 * settings' bypass is ignored, as the circuit handles it. */
struct crusher *crusher_new(const double *size, size_t n,
    const struct params *p, struct model_settings settings,
    const struct posterior *posterior);
void crusher_free(struct crusher *crusher);

/* Sets the feed of the question and the sieves [n], m, coarsest first, at which
 * its product is predicted.  At those sieves that are sizes of the crusher,
 * this feed then gives exactly the predicted product, and other feeds are
 * corrected by the same difference per tonne.  Between these sieves every
 * product is straight in log size (D20), but not coarser than its feed. */
void crusher_set_reference_feed(
    struct crusher *c, const struct psd *feed, const double *sieve, size_t n);

/* Returns the transfer at tip speed v, m/s: a matrix for each draw of the
 * posterior, or a single one for the model alone.  Free with transfer_free. */
struct transfer;
struct transfer *crusher_transfer_at_speed(struct crusher *crusher, double v);
void transfer_free(struct transfer *t);
size_t transfer_count_draws(const struct transfer *t);

/* Computes out [n], the product of the masses in [n] by class, in one draw.
 * Mass is conserved, and no mass moves to a coarser class.  in and out must not
 * overlap.  Not thread-safe. */
void transfer_compute_product(
    const struct transfer *t, size_t draw, const double *in, double *out);

/* Computes the masses of the crusher's classes in a feed, [n] out, with sum 1.
 * All of the feed must pass the coarsest size. */
void crusher_class_masses_of_feed(
    const struct crusher *c, const struct psd *feed, double *out);

#endif
