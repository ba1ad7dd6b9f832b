/* Histograms of energies in bins of a sixteenth of an octave, and their
 * reduction to twelve impacts of equal energy (D15).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/spectrum.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"

enum { BINS_PER_OCTAVE = 16, FIRST_OCTAVE = -10, SIZES_PER_OCTAVE = 4 };

/* 2^(i/16): the C library's powers differ between machines in the last bit. */
static const double ROOT[BINS_PER_OCTAVE] = {1, 1.0442737824274138,
    1.0905077326652577, 1.1387886347566916, 1.189207115002721,
    1.241857812073484, 1.2968395546510096, 1.3542555469368927,
    1.4142135623730951, 1.4768261459394993, 1.5422108254079407,
    1.6104903319492543, 1.681792830507429, 1.7562521603732995,
    1.8340080864093424, 1.9152065613971474};

static double
log_2(double ratio)
{
	return el_log(ratio) / el_log(2);
}

struct spectrum *
spectrum_new(void)
{
	struct spectrum *s = xcalloc(1, sizeof *s);
	s->speed = NAN;
	return s;
}

void
spectrum_free(struct spectrum *s)
{
	if (s == NULL)
		return;
	for (size_t i = 0; i < s->n; i++)
		free(s->size[i]);
	free(s->size);
	free(s);
}

double
spectrum_bin_edge(size_t bin)
{
	int octave = (int)(bin / BINS_PER_OCTAVE) + FIRST_OCTAVE;
	return ldexp(ROOT[bin % BINS_PER_OCTAVE], octave);
}

static size_t
bin_of_energy(double energy)
{
	size_t low = 0, high = SPECTRUM_BINS;
	while (high - low > 1) {
		size_t middle = (low + high) / 2;
		if (energy >= spectrum_bin_edge(middle))
			low = middle;
		else
			high = middle;
	}
	return low;
}

/* Returns the part of a bin that lies above the cut, in proportion to ln e.
 * The cut must lie within the bin or below it. */
static double
share_of_bin_above_cut(size_t bin, double cut)
{
	if (!(cut > spectrum_bin_edge(bin)))
		return 1;
	double part = log_2(spectrum_bin_edge(bin + 1) / cut) * BINS_PER_OCTAVE;
	return fmax(part, 0);
}

/* Returns 0 if the size is not known. */
static double
round_size_to_quarter_octave(double size)
{
	if (!isnormal(size))
		return 0;
	long steps = lround(SIZES_PER_OCTAVE * log_2(size));
	long octave = (steps >= 0 ? steps : steps - (SIZES_PER_OCTAVE - 1)) /
		      SIZES_PER_OCTAVE;
	long step = steps - octave * SIZES_PER_OCTAVE;
	return ldexp(
	    ROOT[step * BINS_PER_OCTAVE / SIZES_PER_OCTAVE], (int)octave);
}

static struct spectrum_size *
spectrum_find_or_add_size(struct spectrum *s, double size)
{
	double rounded = round_size_to_quarter_octave(size);
	size_t i = 0;
	while (i < s->n && s->size[i]->size > rounded)
		i++;
	if (i < s->n && s->size[i]->size >= rounded)
		return s->size[i];
	s->size = xrealloc(s->size, s->n + 1, sizeof(*s->size));
	memmove(&s->size[i + 1], &s->size[i], (s->n++ - i) * sizeof(*s->size));
	s->size[i] = xcalloc(1, sizeof(**s->size));
	s->size[i]->size = rounded;
	return s->size[i];
}

static void
add_impact_to_bin(struct spectrum_bin *to, double mass, double energy)
{
	to->mass += mass;
	to->energy += energy;
}

void
spectrum_add_impact(
    struct spectrum *s, double size, double mass, double energy, bool first)
{
	struct spectrum_size *of = spectrum_find_or_add_size(s, size);
	size_t bin = bin_of_energy(energy);
	add_impact_to_bin(&of->all[bin], mass, mass * energy);
	if (first)
		add_impact_to_bin(&of->first[bin], mass, mass * energy);
}

void
spectrum_add_first_impact(
    struct spectrum *s, double size, double mass, double energy)
{
	struct spectrum_size *of = spectrum_find_or_add_size(s, size);
	add_impact_to_bin(
	    &of->first[bin_of_energy(energy)], mass, mass * energy);
}

void
spectrum_add_particles(
    struct spectrum *s, double size, double number, double mass)
{
	struct spectrum_size *of = spectrum_find_or_add_size(s, size);
	of->particles += number;
	of->mass += mass;
}

struct spectrum_size *
spectrum_sum_over_sizes(const struct spectrum *s)
{
	struct spectrum_size *whole = xcalloc(1, sizeof *whole);
	for (size_t i = 0; i < s->n; i++) {
		const struct spectrum_size *of = s->size[i];
		whole->particles += of->particles;
		whole->mass += of->mass;
		for (size_t b = 0; b < SPECTRUM_BINS; b++) {
			add_impact_to_bin(
			    &whole->all[b], of->all[b].mass, of->all[b].energy);
			add_impact_to_bin(&whole->first[b], of->first[b].mass,
			    of->first[b].energy);
		}
	}
	return whole;
}

struct spectrum_bin
spectrum_impacts_above_energy(
    const struct spectrum_size *s, double cut, bool first)
{
	const struct spectrum_bin *bin = first ? s->first : s->all;
	struct spectrum_bin sum = {0, 0};
	for (size_t b = SPECTRUM_BINS, at = bin_of_energy(cut); b-- > at;) {
		double part = share_of_bin_above_cut(b, cut);
		add_impact_to_bin(
		    &sum, part * bin[b].mass, part * bin[b].energy);
	}
	return sum;
}

double
spectrum_impacts_per_particle(
    const struct spectrum *s, const struct spectrum_size *of, double cut)
{
	if (!s->counted || !(of->mass > 0))
		return NAN;
	return spectrum_impacts_above_energy(of, cut, false).mass / of->mass;
}

double
spectrum_energy_factor_at_speed(const struct spectrum *s, double speed)
{
	double ratio = speed / s->speed;
	return ratio * ratio;
}

struct impacts
spectrum_group_impacts_by_energy(const struct spectrum *s, double cut)
{
	FREED struct spectrum_size *whole = spectrum_sum_over_sizes(s);
	struct spectrum_bin above =
	    spectrum_impacts_above_energy(whole, cut, false);
	struct spectrum_bin node = {0, 0};
	struct impacts to = {.n = 0};
	double E = s->speed * s->speed / 2, done = 0;
	double number = spectrum_impacts_per_particle(s, whole, cut);
	to.number = isfinite(number) ? number : 1;
	for (size_t b = bin_of_energy(cut); b < SPECTRUM_BINS && above.mass > 0;
	     b++) {
		const struct spectrum_bin *bin = &whole->all[b];
		double part = share_of_bin_above_cut(b, cut);
		add_impact_to_bin(&node, part * bin->mass, part * bin->energy);
		done += part * bin->energy;
		double due = above.energy * (double)(to.n + 1) / IMPACTS_MOST;
		bool last = b + 1 == SPECTRUM_BINS;
		if (!(node.mass > 0) || (done < due * (1 - 1e-9) && !last))
			continue;
		to.share[to.n] = node.mass / above.mass;
		to.ratio[to.n++] = node.energy / node.mass / E;
		node = (struct spectrum_bin){0, 0};
		if (to.n == IMPACTS_MOST)
			break;
	}
	return to;
}

double
spectrum_equivalent_k(const struct spectrum *s, const struct spectrum_size *of,
    double E, double e0, double f)
{
	double scale = E / (s->speed * s->speed / 2), kept = 0, over = 0;
	double mass = 0;
	for (size_t b = 0; b < SPECTRUM_BINS; b++) {
		const struct spectrum_bin *bin = &of->all[b];
		if (!(bin->mass > 0))
			continue;
		double e = scale * bin->energy / bin->mass - e0;
		mass += bin->mass;
		over += bin->mass * fmax(e, 0);
		kept += bin->mass * el_exp(-f * fmax(e, 0));
	}
	if (!(E > e0) || !(over > 0))
		return NAN;
	double n = s->counted && of->mass > 0 ? mass / of->mass : 1;
	double exponent = f > 0 ? -el_log(kept / mass) / f : over / mass;
	return n * exponent / (E - e0);
}

/* Returns the share of the impacts above cut that are above r v^2/2. */
static double
share_of_impacts_above_energy(
    const struct spectrum_size *of, double v, double cut, double r)
{
	double from = fmax(cut, r * v * v / 2);
	return spectrum_impacts_above_energy(of, from, false).mass /
	       spectrum_impacts_above_energy(of, cut, false).mass;
}

double
spectrum_ks_distance(
    const struct spectrum *a, const struct spectrum *b, double cut)
{
	double largest = 0, slower = fmin(a->speed, b->speed);
	double least = cut / (slower * slower / 2);
	FREED struct spectrum_size *of_a = spectrum_sum_over_sizes(a);
	FREED struct spectrum_size *of_b = spectrum_sum_over_sizes(b);
	for (size_t i = 0; i < 200; i++) {
		double r = least * el_pow(2 / least, (double)i / 199);
		double d = share_of_impacts_above_energy(of_a, a->speed,
			       least * a->speed * a->speed / 2, r) -
			   share_of_impacts_above_energy(of_b, b->speed,
			       least * b->speed * b->speed / 2, r);
		largest = fmax(largest, fabs(d));
	}
	return largest;
}
