/* energy: loads, shows, compares and assesses simulated collision energies.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/energies.h"
#include "cmd/session/files.h"
#include "cmd/lang/table.h"
#include "core/model/breakage.h"
#include "core/psd/rotor_speed.h"
#include "io/fs/file.h"
#include "io/sitefile/units.h"

/* A question about collision energies.  cut: J/kg, at the simulated speed;
 * speed: the tip speed asked about, m/s; E: v^2/2 at that speed, J/kg; scale:
 * factor from the simulated energies to that speed; rotor: diameter of the
 * rotor of the site in use, m, or 0.  The simulated rotor is another. */
struct energy_question {
	const struct energies *e;
	const struct spectrum *spectrum;
	double cut, speed, E, scale, rotor;
	const struct entry *entry; /* site whose parameters give k, or NULL */
};

/* Returns k for a size: the number of impacts at v^2/2 that break as much as
 * the simulated ones.  By Eq 3 with the entry's parameters, the threshold is
 * E0_min / x^alpha, J/kg, and the strength f_mat x^alpha; without parameters
 * they are the cut and 0. */
static double
equivalent_impacts_of_size(
    const struct energy_question *q, const struct spectrum_size *of)
{
	double e0 = q->cut * q->scale, f = 0, x = of->size;
	if (!(q->E > 0))
		return NAN;
	if (q->entry != NULL && x > 0) {
		const struct params *p = &q->entry->params;
		double w = pow(x, params_value_by_name(p, "alpha"));
		e0 = params_value_by_name(p, "e0_min") / w;
		f = params_value_by_name(p, "f_mat") * w;
	}
	return spectrum_equivalent_k(q->spectrum, of, q->E, e0, f);
}

static double
energy_share_of_first_impacts(
    const struct energy_question *q, const struct spectrum_size *of)
{
	double all = spectrum_impacts_above_energy(of, q->cut, false).energy;
	if (!q->spectrum->ordered || !(all > 0))
		return NAN;
	return spectrum_impacts_above_energy(of, q->cut, true).energy / all;
}

/* Returns the mean energy of the impacts above the cut, J/kg, at the speed
 * asked about. */
static double
mean_impact_energy(
    const struct energy_question *q, const struct spectrum_size *of, bool first)
{
	struct spectrum_bin above =
	    spectrum_impacts_above_energy(of, q->cut, first);
	return above.mass > 0 ? q->scale * above.energy / above.mass : NAN;
}

static double
share_of_impacts_below_energy_cut(
    const struct energy_question *q, const struct spectrum_size *of)
{
	double all = spectrum_impacts_above_energy(of, 0, false).mass;
	return 1 - spectrum_impacts_above_energy(of, q->cut, false).mass / all;
}

static void
add_energy_row_of_size(struct answer *r, const struct energy_question *q,
    const struct spectrum_size *of, double size)
{
	double mean = mean_impact_energy(q, of, false);
	answer_set_missing_text(r, "all");
	answer_add_cells(r, "%.1f", size);
	answer_set_missing_text(r, "-");
	answer_add_cells(r, "%g %.2f %.2f %.1f %.2f %.1f %.2f",
	    q->spectrum->counted ? of->particles : NAN,
	    spectrum_impacts_per_particle(q->spectrum, of, 0),
	    spectrum_impacts_per_particle(q->spectrum, of, q->cut), mean,
	    mean / q->E, 100 * energy_share_of_first_impacts(q, of),
	    equivalent_impacts_of_size(q, of));
}

static void
add_energy_rows_of_sizes(struct answer *r, const struct energy_question *q,
    const struct spectrum_size *whole)
{
	answer_add_columns(r,
	    "size_mm: size mm, particles, impacts: impacts each, above: above "
	    "the cut, mean_j_kg: mean J/kg, mean_ratio: of v^2/2, "
	    "first_pct: in the first %%, k");
	for (size_t i = 0; i < q->spectrum->n && q->spectrum->n > 1; i++)
		add_energy_row_of_size(r, q, q->spectrum->size[i],
		    units_m_to_mm(q->spectrum->size[i]->size));
	add_energy_row_of_size(r, q, whole, NAN);
}

/* Adds the bins that hold impacts, for programs: the mean energy of each, and
 * its share of the impacts by mass. */
static void
put_energy_bins(struct answer *r, const struct energy_question *q,
    const struct spectrum_size *whole)
{
	FREED double *e = xcalloc_doubles(SPECTRUM_BINS),
		     *share = xcalloc_doubles(SPECTRUM_BINS);
	double all = spectrum_impacts_above_energy(whole, 0, false).mass;
	size_t n = 0;
	for (size_t b = 0; b < SPECTRUM_BINS; b++) {
		const struct spectrum_bin *bin = &whole->all[b];
		if (!(bin->mass > 0))
			continue;
		e[n] = q->scale * bin->energy / bin->mass;
		share[n++] = bin->mass / all;
	}
	struct fields *f = answer_json_fields(r);
	fields_put_values(f,
	    "name %s speed %g impacts %g rows %llu mass_kg %g "
	    "share_below_pct %g cut_j_kg %g per_particle %g first_pct %g k %g",
	    q->e->name, q->speed,
	    q->e->c.weighted ? NAN : (double)q->e->c.impacts,
	    (unsigned long long)q->e->c.rows,
	    q->spectrum->counted ? whole->mass : NAN,
	    100 * share_of_impacts_below_energy_cut(q, whole),
	    q->scale * q->cut,
	    spectrum_impacts_per_particle(q->spectrum, whole, q->cut),
	    100 * energy_share_of_first_impacts(q, whole),
	    equivalent_impacts_of_size(q, whole));
	struct fields *list = fields_add_object(f, "spectrum");
	fields_put_numbers(list, "j_kg", e, n, NULL);
	fields_put_numbers(list, "mass_share", share, n, NULL);
	answer_add_rows_as_json_objects(r, "sizes");
}

/* Returns how many of the impacts count as independent. */
static double
count_independent_impacts(const struct energies *e)
{
	FREED struct spectrum_size *whole =
	    spectrum_sum_over_sizes(e->c.spectrum);
	double n =
	    e->c.spectrum->counted ? whole->particles : (double)e->c.impacts;
	return fmax(n, 1);
}

/* Notes how much other loaded spectra, scaled by v^2, differ from this one. */
static void
note_difference_of_energy_spectra(
    struct answer *r, const struct session *s, const struct energy_question *q)
{
	for (size_t i = 0; i < s->n_energies; i++) {
		const struct energies *o = s->energies[i];
		const struct spectrum *other = o->c.spectrum;
		if (o == q->e || !(other->speed > 0) || !(q->speed > 0) ||
		    fabs(other->speed - q->spectrum->speed) < 1e-9)
			continue;
		double d = spectrum_ks_distance(q->spectrum, other, q->cut);
		/* The 95 % limit of Kolmogorov and Smirnov.  It counts
		 * particles, because the impacts of one particle depend on each
		 * other. */
		double chance =
		    1.36 * sqrt(1 / count_independent_impacts(q->e) +
				1 / count_independent_impacts(o));
		answer_note(r,
		    d < chance
			? N_("scaled by v^2, %s (%g m/s) and this one (%g m/s) "
			     "differ by at most %.1f %% of the impacts, which "
			     "chance may explain")
			: N_("scaled by v^2, %s (%g m/s) and this one (%g m/s) "
			     "differ by at most %.1f %% of the impacts: more "
			     "than chance explains, so v^2 is not all"),
		    o->name, other->speed, q->spectrum->speed, 100 * d);
	}
}

/* Says whether one impact at v^2/2 is a fair picture.  Three things must hold,
 * each within a quarter: k is about 1, the first impact has most of the energy,
 * and its energy is near v^2/2. */
static void
note_whether_one_impact_is_fair(struct answer *r,
    const struct energy_question *q, const struct spectrum_size *whole)
{
	const double within = 0.8;
	double k = equivalent_impacts_of_size(q, whole), ratio;
	double first = energy_share_of_first_impacts(q, whole);
	ratio = mean_impact_energy(q, whole, q->spectrum->ordered) / q->E;
	if (!isfinite(k)) {
		answer_add_sentence(r, ANSWER_REMARK,
		    "without a tip speed v^2/2 is unknown: load the energies "
		    "with speed=");
		return;
	}
	bool once = k >= within && k <= 1 / within, hard = ratio >= within;
	bool single = !(first < within);
	answer_note(r,
	    once && hard && single
		? N_("one impact at v^2/2 is a fair picture here: k is near 1 "
		     "and the first impact has most of the energy")
	    : once
		? N_("one impact at v^2/2 gives the right total here, but no "
		     "more: k is near 1, yet the energy is spread over impacts "
		     "that are weaker than v^2/2")
		: N_("one impact at v^2/2 is a poor approximation here: the "
		     "impacts break as much as k impacts at v^2/2 would, and k "
		     "is not near 1; a calibrated f_mat makes up for it"));
	if (!q->spectrum->counted)
		answer_add_sentence(r, ANSWER_REMARK,
		    "particles were not counted: k is that of one impact from "
		    "this spectrum");
}

/* Notes the range of k over the sizes, by Eq 3 with the site's parameters. */
static void
note_range_of_k_over_sizes(struct answer *r, const struct energy_question *q)
{
	double low = INFINITY, high = -INFINITY;
	for (size_t i = 0; q->entry != NULL && i < q->spectrum->n; i++) {
		const struct spectrum_size *of = q->spectrum->size[i];
		double k =
		    of->size > 0 ? equivalent_impacts_of_size(q, of) : NAN;
		low = fmin(low, isfinite(k) ? k : INFINITY);
		high = fmax(high, isfinite(k) ? k : -INFINITY);
	}
	if (low > high)
		return;
	answer_note(r,
	    high < 0.1
		? N_("with the parameters of %s k is from %.2f to %.2f, for "
		     "sizes that one impact at v^2/2 can break: hardly any of "
		     "these impacts passes the threshold")
		: N_("with the parameters of %s k is from %.2f to %.2f, for "
		     "sizes that one impact at v^2/2 can break"),
	    q->entry->site->name, low, high);
}

static void
note_basis_of_impact_count(struct answer *r, const struct energy_question *q)
{
	if (q->entry != NULL)
		answer_add_sentence(r, ANSWER_REMARK,
		    "k of one size: by Eq 3 with the parameters of %s; k of "
		    "all sizes, or without parameters: for weak rock with a "
		    "threshold at the cut",
		    q->entry->site->name);
	else
		answer_add_sentence(r, ANSWER_REMARK,
		    "k: for weak rock with a threshold at the cut; with the "
		    "parameters of a site it is that of Eq 3");
	if (q->scale < 1 || q->scale > 1) {
		FREED char *rpm = rotor_speed_rpm_text(q->rotor, q->speed, NAN);
		answer_add_sentence(r, ANSWER_REMARK,
		    "energies and the cut scaled by v^2 from %g to %g m/s%s",
		    q->spectrum->speed, q->speed, rpm);
	}
	answer_add_sentence(r, ANSWER_REMARK,
	    "energies of a simulation hold for its own geometry, rock and "
	    "contact model: see tipspeed-model(7)");
}

static bool
has_f_mat(const struct entry *entry)
{
	return entry->has_params &&
	       isfinite(params_value_by_name(&entry->params, "f_mat"));
}

static bool
show_impact_energies(
    struct session *s, const struct args *args, struct error *error)
{
	if (energies_last_read(s, error) == NULL)
		return false;
	const struct spectrum *spectrum = s->energy->c.spectrum;
	struct energy_question q = {.e = s->energy,
	    .spectrum = spectrum,
	    .cut = args_is_given(args, &args->energy_cut) ? args->energy_cut
							  : s->energy->cut,
	    .speed = spectrum->speed,
	    .scale = 1};
	if (args->speed > 0 && !(spectrum->speed > 0))
		return error_set(error, ERROR_USAGE,
		    "expected energies of a known tip speed to scale, got "
		    "none\nload them with it: energy load FILE speed=V");
	if (args->speed > 0) {
		q.speed = args->speed;
		q.scale = spectrum_energy_factor_at_speed(spectrum, q.speed);
		q.cut /= q.scale;
	}
	q.E = q.speed > 0 ? specific_energy_at_speed(q.speed) : NAN;
	if (s->n_entry > 0) {
		const struct entry *entry = session_current_site_entry(s);
		q.entry = has_f_mat(entry) ? entry : NULL;
		q.rotor = entry->site->rotor;
	}
	FREED struct spectrum_size *whole = spectrum_sum_over_sizes(spectrum);
	struct answer *r = answer_new("energy");
	answer_set_title(r,
	    q.speed > 0 ? N_("%s: collision energies above %g J/kg")
			: N_("%s: collision energies above %g J/kg, tip speed "
			     "not known"),
	    s->energy->name, q.scale * q.cut);
	answer_set_site_names(r, "", s->energy->c.about);
	add_energy_rows_of_sizes(r, &q, whole);
	answer_note(r,
	    s->energy->c.weighted
		? N_("%llu weighted rows, %.1f %% of the weight below %g J/kg")
		: N_("%llu impacts, %.1f %% below %g J/kg (by mass of the "
		     "particles)"),
	    (unsigned long long)s->energy->c.impacts,
	    100 * share_of_impacts_below_energy_cut(&q, whole),
	    q.scale * q.cut);
	note_difference_of_energy_spectra(r, s, &q);
	note_whether_one_impact_is_fair(r, &q, whole);
	note_range_of_k_over_sizes(r, &q);
	note_basis_of_impact_count(r, &q);
	put_energy_bins(r, &q, whole);
	return session_show_answer(s, r);
}

static bool
load_energy_file(
    struct session *s, const struct args *args, struct error *error)
{
	struct collisions_way way = {.columns = args->columns,
	    .speed = args->speed > 0 ? args->speed : NAN};
	if (args_is_given(args, &args->unit))
		way.unit = args->unit == 0 ? "J/kg" : "m/s";
	double cut = args_is_given(args, &args->energy_cut) ? args->energy_cut
							    : ENERGIES_CUT;
	if (energies_load_file(s, args->operand[1], &way, cut, error) == NULL)
		return false;
	struct energies *e = s->energies[s->n_energies - 1];
	if (args->note != NULL)
		xfree_and_set(&e->c.about, xstrdup(args->note));
	s->energy = e;
	session_print_note(s,
	    e->c.weighted && e->c.spectrum->speed > 0
		? N_("loaded %s: %s, %llu weighted rows")
	    : e->c.weighted
		? N_("loaded %s: %s, %llu weighted rows; tip speed not known")
	    : e->c.spectrum->speed > 0
		? N_("loaded %s: %s, %llu rows, %llu impacts")
		: N_("loaded %s: %s, %llu rows, %llu impacts; tip speed not "
		     "known"),
	    e->name, e->c.form, (unsigned long long)e->c.rows,
	    (unsigned long long)e->c.impacts);
	return true;
}

static void
print_energy_file(const void *data, FILE *out)
{
	const struct energies *e = data;
	collisions_write(&e->c, e->name, out);
}

static bool
write_energy_file(
    struct session *s, const struct args *args, struct error *error)
{
	const char *path = args->operand[1];
	if (energies_last_read(s, error) == NULL ||
	    !file_check_csv_name(path, error) ||
	    !files_may_write(s, path, false, error) ||
	    !files_confirm_replace(s, path, error) ||
	    !file_replace_using_writer(
		path, FILE_SHARED, print_energy_file, s->energy, error))
		return false;
	files_record_written(s, path);
	session_print_note(s, "wrote %s", path);
	return true;
}

bool
cmd_energy(struct session *s, const struct args *args, struct error *error)
{
	static const struct {
		const char *verb;
		command_run *run;
	} VERBS[] = {{"load", load_energy_file}, {"write", write_energy_file}};
	if (args->n_operand == 0)
		return show_impact_energies(s, args, error);
	for (size_t i = 0; i < ARRAY_LEN(VERBS); i++)
		if (strcmp(args->operand[0], VERBS[i].verb) == 0)
			return args->n_operand == 2
				   ? VERBS[i].run(s, args, error)
				   : error_set(error, ERROR_USAGE,
					 "energy %s: expected a file\n"
					 "write energy load FILE, or energy "
					 "write FILE",
					 VERBS[i].verb);
	return error_set(error, ERROR_USAGE,
	    "expected load or write, got '%s'\n"
	    "write energy load FILE, or energy alone to show them",
	    args->operand[0]);
}
