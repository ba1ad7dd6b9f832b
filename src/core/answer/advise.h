/* How much one more sample would narrow the band of an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_ADVISE_H
#define TIPSPEED_CORE_ANSWER_ADVISE_H

#include <stddef.h>

/* Returns the share of an answer's variance, 0..1, that knowing a sample is
 * expected to remove: the R^2 of a regression on the sample's principal
 * components, adjusted for their number, which is chosen to maximise it.
 * answer [POSTERIOR_DRAWS]: its value in each draw, not NAN; sample [n *
 * POSTERIOR_DRAWS], a row for each sieve: the sample that each draw predicts,
 * with its errors (ENSEMBLE_SAMPLE).  The sample multiplies the width of the
 * band by sqrt(1 - share). */
double advise_variance_share_removed(
    const double *answer, const double *sample, size_t n);

#endif
