/* How much one more sample would narrow the band of an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_ADVISE_H
#define TIPSPEED_CORE_ANSWER_ADVISE_H

#include <stddef.h>

/* answer [POSTERIOR_DRAWS], none of them NAN; sample [n * POSTERIOR_DRAWS], row
 * by sieve: the sample that each draw predicts, with its errors
 * (ENSEMBLE_SAMPLE).  Returns the share of the answer's variance, 0..1, that
 * knowing the sample is expected to remove: the R^2 of a regression on the
 * sample's principal components, adjusted for their number, which is chosen to
 * maximise it.  The sample multiplies the width of the band by sqrt(1 -
 * share). */
double advise_variance_share_removed(
    const double *answer, const double *sample, size_t n);

#endif
