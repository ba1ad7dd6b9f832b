/* Collision energies: how often particles are hit, and how hard.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_SPECTRUM_H
#define TIPSPEED_CORE_MODEL_SPECTRUM_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"

/* Bins of energy, sixteen to an octave from 2^-10 J/kg up; energies outside
 * count in the first or the last. */
enum { SPECTRUM_BINS = 512 };

/* Impacts of a bin: their mass, kg, and their mass times their energy, J. */
struct spectrum_bin {
	double mass, energy;
};

/* Particles of one size: m, rounded to a quarter octave; 0 where no size is
 * known.  particles, mass: their number and total mass, including particles
 * that were never hit.  all: their impacts; first: of these the first impact of
 * each particle. */
struct spectrum_size {
	double size, particles, mass;
	struct spectrum_bin all[SPECTRUM_BINS], first[SPECTRUM_BINS];
};

/* counted: the particles were counted, so that the impacts per particle are
 * known.  ordered: the first impact of each particle is known. */
struct spectrum {
	double speed; /* rotor tip speed, m/s; NAN where it is not known */
	bool counted, ordered;
	size_t n;
	struct spectrum_size **size; /* [n], coarsest first */
};

struct spectrum *spectrum_new(void);
void spectrum_free(struct spectrum *s);

/* Adds an impact of a particle of that size (m, 0: not known) and mass (kg, or
 * any weight), of energy J/kg.  spectrum_add_particles: adds `number` particles
 * with the total mass `mass`.  spectrum_add_first: adds to the first impacts
 * alone. */
void spectrum_add_impact(
    struct spectrum *s, double size, double mass, double energy, bool first);
void spectrum_add_particles(
    struct spectrum *s, double size, double number, double mass);
void spectrum_add_first(
    struct spectrum *s, double size, double mass, double energy);

/* Returns all sizes as one, with size 0. */
struct spectrum_size *spectrum_whole(const struct spectrum *s);

/* Returns the lower edge of a bin, J/kg; for SPECTRUM_BINS the upper edge of
 * the last bin. */
double spectrum_edge(size_t bin);

/* Impacts above an energy, J/kg: times the particles' mass, and the share of
 * them in all.  Of a bin that the cut divides, the part above it in ln e. */
struct spectrum_bin spectrum_above(
    const struct spectrum_size *s, double cut, bool first);

/* Returns the impacts per particle above the cut, averaged by mass; NAN where
 * particles were not counted. */
double spectrum_per_particle(
    const struct spectrum *s, const struct spectrum_size *of, double cut);

/* Selection (Eq 3) with a spectrum:
 *   S = 1 - (sum of w_j exp(-f k (x^alpha r_j E - E0_min)))^n
 * for n impacts per particle, each drawn from the spectrum, of which a share
 * w_j has the energy r_j E, E = v^2/2; the bracket is 0 where negative.  One
 * node with w = r = 1 and n = 1 is the paper's.  The nodes: the impacts above
 * the cut, in groups of equal energy w r, each at its mean.  D15.
 * n is 1 where particles were not counted.  The speed must be known. */
struct impacts spectrum_impacts(const struct spectrum *s, double cut);

/* The k with which Eq 3, of a single impact at E = v^2/2, breaks as much as the
 * impacts do, for a threshold E0_min / x^alpha of e0 (J/kg) and a strength f
 * x^alpha of f (kg/J):
 *   k = -n ln(sum of w_j exp(-f (r_j E - e0))) / (f (E - e0))
 * f 0: its limit, n sum of w_j (r_j E - e0) / (E - e0).  E J/kg.  of: all bins
 * are taken, not nodes.  NAN where E <= e0 or nothing is above e0. */
double spectrum_k(const struct spectrum *s, const struct spectrum_size *of,
    double E, double e0, double f);

/* Returns the factor that scales the energies to another speed, by v^2; the
 * spectrum's speed must be known. */
double spectrum_scale(const struct spectrum *s, double speed);

/* Distance of two spectra whose energies are taken over v^2/2: the largest
 * difference of the shares of impacts above any cut that is at least cut J/kg
 * at both (Kolmogorov-Smirnov), 0..1. */
double spectrum_distance(
    const struct spectrum *a, const struct spectrum *b, double cut);

#endif
