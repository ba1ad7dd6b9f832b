/* Writes a site as a sheet, and the sheet safely to disk.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_write.h"

#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/source.h"
#include "io/fs/file.h"
#include "io/sitefile/units.h"

/* The most lines above the sizes, without the notes. */
enum { LINES_ABOVE = 8 };

/* A curve to write, and the first of its sieves that is not yet written. */
struct curve {
	const char *role;
	double speed; /* m/s; 0: none in the heading */
	bool small;   /* written in fractions */
	const struct psd *psd;
	const double *value; /* [psd->n] fractions; NULL: an empty column */
	size_t next;
};

/* True if the products at a speed must be written as fractions: the reader
 * takes percentages that never exceed 1 for fractions.  Repeats at the speed
 * share the unit. */
static bool
must_write_as_fractions(const struct site *site, double speed)
{
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed == speed && site->run[r].product.n > 0 &&
		    site->run[r].product.passing[0] <= 0.01)
			return true;
	return false;
}

/* True if a product at a speed has standard deviations.  Its repeats then get a
 * column too, empty if they have none: a single column serves all of them. */
static bool
has_deviations_at_speed(const struct site *site, double speed)
{
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed == speed &&
		    site->run[r].product_sd != NULL)
			return true;
	return false;
}

static void
write_key_and_value(const char *key, const char *value, FILE *out)
{
	text_write_csv_cell(key, ',', out);
	fputc(',', out);
	text_write_csv_cell(value, ',', out);
	fputc('\n', out);
}

static void
write_site_keys_above_table(const struct site *site, FILE *out)
{
	char top[32] = "", rotor[32] = "", speed[32];
	if (site->top_size > 0)
		text_shortest_exact_number(units_m_to_mm(site->top_size), top);
	if (site->rotor > 0)
		text_shortest_exact_number(units_m_to_mm(site->rotor), rotor);
	FREED char *lacking = xstrdup("");
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].lacks_feed)
			xappend_to_list(&lacking, ", ", "%s%s",
			    text_shortest_exact_number(
				site->run[r].speed, speed),
			    site->run[r].repeat);
	const char *const line[][2] = {{"site", site->name},
	    {"rock", site->rock}, {"top_size_mm", top},
	    {"machine", site->machine}, {"rotor_mm", rotor},
	    {"provenance", site->provenance},
	    {SITE_CUTS_WITHOUT_FEED, lacking}};
	for (size_t i = 0; i < ARRAY_LEN(line); i++)
		if (line[i][1][0] != '\0')
			write_key_and_value(line[i][0], line[i][1], out);
	for (size_t i = 0; i < site->n_note; i++)
		write_key_and_value(
		    site->note[i].key, site->note[i].value, out);
}

/* Lists the columns after that of the sizes in order, and their number.  The
 * caller frees the list. */
static struct curve *
list_curves_to_write(const struct site *site, size_t *columns)
{
	/* A run may have only a feed, whose speed no other column states. */
	bool own = site->individual_feeds;
	for (size_t r = 0; r < site->n_run; r++)
		own = own || site->run[r].product.n == 0;
	struct curve *curve = xcalloc(3 * site->n_run + 1, sizeof *curve);
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		const struct psd *feed = &run->feed;
		const struct psd *product = &run->product;
		if (own || r == 0)
			curve[n++] =
			    (struct curve){"feed", own ? run->speed : 0, false,
				feed, feed->passing, 0};
		if (product->n > 0)
			curve[n++] = (struct curve){"product", run->speed,
			    must_write_as_fractions(site, run->speed), product,
			    product->passing, 0};
		if (product->n > 0 && has_deviations_at_speed(site, run->speed))
			curve[n++] = (struct curve){"sd", run->speed, false,
			    product, run->product_sd, 0};
	}
	*columns = n;
	return curve;
}

static void
write_sieve_row(struct curve *curve, size_t n, double mm, FILE *out)
{
	char number[32];
	fputs(text_shortest_exact_number(mm, number), out);
	for (size_t i = 0; i < n; i++) {
		struct curve *c = &curve[i];
		fputc(',', out);
		bool used = false;
		for (; c->next < c->psd->n; c->next++) {
			if (units_m_to_mm(c->psd->size[c->next]) < mm)
				break;
			if (!used && c->value != NULL)
				fputs(text_shortest_exact_number(
					  round(c->value[c->next] * 1e14) /
					      (c->small ? 1e14 : 1e12),
					  number),
				    out);
			used = true;
		}
	}
	fputc('\n', out);
}

size_t
site_write(const struct site *site, FILE *out)
{
	char number[32];
	size_t n;
	FREED struct curve *curve = list_curves_to_write(site, &n);
	write_site_keys_above_table(site, out);
	fputs("size_mm", out);
	for (size_t i = 0; i < n; i++) {
		const struct curve *c = &curve[i];
		fprintf(out, ",%s%s%s%s", c->role, c->small ? "_fraction" : "",
		    c->speed > 0 ? "@" : "",
		    c->speed > 0 ? text_shortest_exact_number(c->speed, number)
				 : "");
	}
	fputc('\n', out);
	for (size_t rows = 0;; rows++) {
		double mm = 0; /* the coarsest sieve that is not yet written */
		for (size_t i = 0; i < n; i++)
			if (curve[i].next < curve[i].psd->n)
				mm = fmax(
				    mm, units_m_to_mm(
					    curve[i].psd->size[curve[i].next]));
		if (!(mm > 0))
			return rows;
		write_sieve_row(curve, n, mm, out);
	}
}

bool
site_save(const struct site *site, const char *path, size_t *rows,
    struct error *error)
{
	FREED char *text = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&text, &n);
	*rows = site_write(site, memory);
	fclose(memory);
	size_t columns, cells;
	free(list_curves_to_write(site, &columns));
	cells = ++columns * (*rows + LINES_ABOVE + site->n_note);
	if (columns > SOURCE_MOST_COLUMNS || cells > SOURCE_MOST_CELLS)
		return error_set(error, ERROR_USAGE,
		    "cannot write %zu columns and %zu rows: a site file has at "
		    "most %d columns and %d cells\n"
		    "load a part of the samples, and write that: load FILE "
		    "range=A1:F500",
		    columns, *rows, SOURCE_MOST_COLUMNS, SOURCE_MOST_CELLS);
	return file_replace_contents(path, FILE_SHARED, text, n, error);
}
