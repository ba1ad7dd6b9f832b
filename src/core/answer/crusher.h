/* The transfer matrix of a crusher: what it makes of each size class, at a
 * speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_CRUSHER_H
#define TIPSPEED_CORE_ANSWER_CRUSHER_H

#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"

/* Classes between sizes [n], m, coarsest first: class i lies between sizes i
 * and i + 1, with mass that is uniform in ln d, the last is the pan, which does
 * not break.  A model's product is linear in the feed, so that the products of
 * all feeds follow from those of the classes; what the model leaves out
 * (discrepancy.h) follows from the product that it makes of the whole feed. */
struct crusher;
struct posterior;

/* posterior: NULL for the model alone; else it must outlive the crusher.  The
 * bypass of the settings is left to the circuit. */
struct crusher *crusher_new(const double *size, size_t n,
    const struct params *p, struct model_settings settings,
    const struct posterior *posterior);
void crusher_free(struct crusher *crusher);

/* The feed of the question, with the sieves [n], m, coarsest first, at which a
 * prediction of its product is made: at the sieves that are sizes of the
 * crusher this feed then gives exactly that product, and other feeds are
 * corrected by the same difference, for each t. */
void crusher_match(
    struct crusher *c, const struct psd *feed, const double *sieve, size_t n);

/* The transfer at tip speed v, m/s: one for each draw of the posterior, or a
 * single one of the model alone. */
struct transfer;
struct transfer *crusher_at(struct crusher *crusher, double v);
void transfer_free(struct transfer *t);
size_t transfer_draws(const struct transfer *t);

/* The product of masses in [n] by class, out [n], of one of them: as much comes
 * out as goes in, and nothing coarser.  in and out are not the same; one thread
 * at a time. */
void transfer_product(
    const struct transfer *t, size_t draw, const double *in, double *out);

/* The masses of its classes in a feed, which passes all at its coarsest size,
 * [n] out; they add up to 1.  For draws the feed is smooth between its sieves
 * (D18). */
void crusher_classes(
    const struct crusher *c, const struct psd *feed, double *out);

#endif
