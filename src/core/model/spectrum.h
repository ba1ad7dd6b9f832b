/* Collision energies: how often particles are hit, and how hard.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_SPECTRUM_H
#define TIPSPEED_CORE_MODEL_SPECTRUM_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"

/* Bins of energy, sixteen to the octave from 2^-10 J/kg up; energies outside
 * count in the first or last bin. */
enum { SPECTRUM_BINS = 512 };

/* The impacts in a bin: their mass, kg, and their mass times their energy,
 * J. */
struct spectrum_bin {
	double mass, energy;
};

/* The particles of one size, m, rounded to a quarter octave; 0 if the size is
 * not known.  particles, mass: their number and total mass, including particles
 * never hit.  all: all impacts; first: the first impact of each particle. */
struct spectrum_size {
	double size, particles, mass;
	struct spectrum_bin all[SPECTRUM_BINS], first[SPECTRUM_BINS];
};

/* counted: the particles were counted, so the impacts per particle are known.
 * ordered: the first impact of each particle is known. */
struct spectrum {
	double speed; /* rotor tip speed, m/s; NAN if not known */
	bool counted, ordered;
	size_t n;
	struct spectrum_size **size; /* [n], coarsest first */
};

struct spectrum *spectrum_new(void);
void spectrum_free(struct spectrum *s);

/* Adds an impact, energy in J/kg, on a particle of that size (m; 0: not known)
 * and mass (kg, or any weight), and also to the first impacts if `first` is
 * true.  spectrum_add_first_impact adds to the first impacts only.
 * spectrum_add_particles adds `number` particles with a total mass of
 * `mass`. */
void spectrum_add_impact(
    struct spectrum *s, double size, double mass, double energy, bool first);
void spectrum_add_particles(
    struct spectrum *s, double size, double number, double mass);
void spectrum_add_first_impact(
    struct spectrum *s, double size, double mass, double energy);

/* Returns the sum over all sizes, with size 0.  The caller frees it. */
struct spectrum_size *spectrum_sum_over_sizes(const struct spectrum *s);

/* Returns the lower edge of a bin, J/kg, or for SPECTRUM_BINS the upper edge of
 * the last bin. */
double spectrum_bin_edge(size_t bin);

/* Returns the impacts above the energy `cut`, J/kg.  A bin that the cut divides
 * counts in part, in proportion to ln e. */
struct spectrum_bin spectrum_impacts_above_energy(
    const struct spectrum_size *s, double cut, bool first);

/* Returns the impacts per particle of `of` above the cut, averaged by mass, or
 * NAN if particles were not counted. */
double spectrum_impacts_per_particle(
    const struct spectrum *s, const struct spectrum_size *of, double cut);

/* Selection (Eq 3) with a spectrum:
 *   S = 1 - (sum of w_j exp(-f k (x^alpha r_j E - E0_min)))^n
 * for n impacts per particle, drawn from a spectrum in which a share w_j has
 * the energy r_j E, E = v^2/2; the bracket is 0 where negative.  One node with
 * w = r = 1 and n = 1 gives the paper's Eq 3.  The nodes are the impacts above
 * the cut in groups of equal total energy w r, each at its mean energy (D15).
 * n is 1 if particles were not counted.  The speed must be known. */
struct impacts spectrum_group_impacts_by_energy(
    const struct spectrum *s, double cut);

/* Returns the k with which Eq 3, for a single impact at E = v^2/2 (J/kg),
 * breaks as much as the impacts of `of` do.  e0 (J/kg) is the threshold E0_min
 * / x^alpha and f (kg/J) the strength f_mat x^alpha: k = -n ln(sum of w_j
 * exp(-f (r_j E - e0))) / (f (E - e0)) If f is 0, the limit is n sum of w_j
 * (r_j E - e0) / (E - e0).  The sums are over all bins, not over nodes.
 * Returns NAN if E <= e0 or if no impact has an energy above e0. */
double spectrum_equivalent_k(const struct spectrum *s,
    const struct spectrum_size *of, double E, double e0, double f);

/* Returns the factor, the ratio of v^2, that scales the energies to another
 * speed.  The spectrum's speed must be known. */
double spectrum_energy_factor_at_speed(const struct spectrum *s, double speed);

/* Returns the Kolmogorov-Smirnov distance, 0..1, between two spectra with
 * energies divided by v^2/2: the largest difference in the share of impacts
 * above any threshold that is at least `cut` J/kg in both. */
double spectrum_ks_distance(
    const struct spectrum *a, const struct spectrum *b, double cut);

#endif
