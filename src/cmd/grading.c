/* spec: a predicted product against the limits of a grading.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/grading.h"

#include <math.h>
#include <stdlib.h>

#include "cmd/answers.h"
#include "cmd/files.h"
#include "cmd/table.h"
#include "io/units.h"

bool
grading_open(struct session *s, const char *path, size_t feed,
    struct grading *grading, struct error *error)
{
	const struct entry *entry = session_entry(s);
	const struct psd *from = &entry->site->run[feed].feed;
	struct error_list errors = {0};
	files_reads(s, path);
	struct spec *spec = spec_read(path, &errors);
	*grading = (struct grading){.spec = spec};
	if (spec == NULL)
		return session_tell_faults(s, path, &errors, error);
	while (grading->n < spec->n && psd_covers(from, spec->size[grading->n]))
		grading->n++;
	if (grading->n == 0) {
		spec_free(spec);
		return error_set(error, ERROR_DATA,
		    "%s: none of its sieves is in the range of the feed's "
		    "sieves",
		    path);
	}
	grading->inverse = inverse_new(
	    from, spec->size, grading->n, &entry->params, s->set.model);
	grading->envelope = (struct envelope){spec->least, spec->most};
	return true;
}

void
grading_close(struct grading *grading)
{
	inverse_free(&grading->inverse);
	spec_free(grading->spec);
}

/* Of sieve i, at the speed the inverse was asked for last. */
static const char *
verdict(const struct grading *grading, size_t i)
{
	const double exact = 1e-9;
	if (i >= grading->n)
		return "not known";
	double passing = grading->inverse.product.passing[i];
	if (passing < grading->spec->least[i] - exact)
		return "below";
	return passing > grading->spec->most[i] + exact ? "above" : "ok";
}

void
grading_rows(struct answer *r, struct grading *grading, double v)
{
	const struct spec *spec = grading->spec;
	const struct psd *product = inverse_at(&grading->inverse, v);
	answer_columns(r, "sieve_mm: sieve mm, min_pct: min %%, max_pct: max "
			  "%%, passing_pct: product %%, verdict");
	for (size_t i = 0; i < spec->n; i++)
		answer_cells(r, "%g %g %g %.1f %s", units_mm(spec->size[i]),
		    units_pct(spec->least[i]), units_pct(spec->most[i]),
		    i < grading->n ? units_pct(product->passing[i]) : NAN,
		    verdict(grading, i));
}

void
grading_notes(struct answer *r, const struct grading *grading)
{
	const struct spec *spec = grading->spec;
	if (grading->n < spec->n)
		answer_say(r, ANSWER_REMARK,
		    "not checked: %g mm and below, finer than the feed's "
		    "finest sieve",
		    units_mm(spec->size[grading->n]));
	if (spec->source[0] != '\0')
		answer_say(r, ANSWER_REMARK, "limits: %s", spec->source);
}

void
grading_put(struct answer *r, const struct spec *spec)
{
	fields_put(
	    answer_fields(r), "spec %s source %s", spec->name, spec->source);
	answer_put_columns(r, "sieve_mm min_pct max_pct passing_pct verdict");
}

/* What is wrong, in a line. */
static void
note_verdict(struct answer *r, struct grading *grading, double v)
{
	size_t worst, out = 0;
	double by =
	    inverse_outside(&grading->inverse, &grading->envelope, v, &worst);
	for (size_t i = 0; i < grading->n; i++)
		out += verdict(grading, i)[0] != 'o';
	if (out == 0)
		answer_note(r, "meets the envelope");
	else
		answer_note(r,
		    "outside on %zu of %zu sieves; worst at %g mm: %.1f points "
		    "%s",
		    out, grading->n, units_mm(grading->spec->size[worst]),
		    100 * fabs(by), by > 0 ? "above max" : "below min");
}

bool
cmd_spec(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_entry(s);
	double v = answers_speed(args, entry);
	size_t feed, worst;
	struct grading g;
	if (!answers_ready(s, error) ||
	    !answers_feed(entry->site, args, v, &feed, error) ||
	    !grading_open(s, args->operand[0], feed, &g, error))
		return false;
	bool outside = answers_extrapolates(entry, v);
	bool inside = inverse_outside(&g.inverse, &g.envelope, v, &worst) == 0;
	struct answer *r =
	    answers_new(entry->site, "spec", "%s at %g m/s", g.spec->name, v);
	grading_rows(r, &g, v);
	note_verdict(r, &g, v);
	grading_notes(r, &g);
	answers_note_doubt(s, r, v, feed);
	fields_put(answer_fields(r), "speed %g extrapolated %d inside %d", v,
	    outside, inside);
	grading_put(r, g.spec);
	session_answer(s, r);
	grading_close(&g);
	return true;
}
