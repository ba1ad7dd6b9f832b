/* Reads collision energies row by row into a spectrum, finding the columns by
 * their headings.  Writes spectra, which it can read back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/collisions.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/textfile.h"
#include "io/sitefile/units.h"

/* What a column contains. */
enum column {
	COL_RADIUS,
	COL_SIZE,
	COL_MASS,
	COL_VELOCITY,
	COL_SPECIFIC,
	COL_ENERGY,
	COL_WEIGHT,
	COL_LOW,
	COL_HIGH,
	COL_PARTICLES,
	COL_PARTICLES_KG,
	COL_IMPACTS_J,
	COL_FIRST_KG,
	COL_FIRST_J,
	COLUMNS_ALL,
	COL_NONE = COLUMNS_ALL
};

/* Headings of columns, as heading_to_identifier returns them, without a
 * unit. */
static const struct {
	const char *head;
	enum column column;
} HEADS[] = {{"radius", COL_RADIUS}, {"size", COL_SIZE}, {"diameter", COL_SIZE},
    {"particle_size", COL_SIZE}, {"mass", COL_MASS},
    {"particle_mass", COL_MASS}, {"velocity", COL_VELOCITY},
    {"normal_velocity", COL_VELOCITY}, {"impact_velocity", COL_VELOCITY},
    {"relative_velocity_normal", COL_VELOCITY},
    {"normal_relative_velocity", COL_VELOCITY},
    {"specific_energy", COL_SPECIFIC}, {"specific_impact_energy", COL_SPECIFIC},
    {"specific_collision_energy", COL_SPECIFIC}, {"energy", COL_ENERGY},
    {"impact_energy", COL_ENERGY}, {"collision_energy", COL_ENERGY},
    {"dissipated_energy", COL_ENERGY}, {"total_energy_loss", COL_ENERGY},
    {"normal_energy_loss", COL_ENERGY}, {"weight", COL_WEIGHT},
    {"count", COL_WEIGHT}, {"frequency", COL_WEIGHT},
    {"mass_share", COL_WEIGHT}, {"impacts", COL_WEIGHT}, {"low", COL_LOW},
    {"from", COL_LOW}, {"high", COL_HIGH}, {"to", COL_HIGH},
    {"particles", COL_PARTICLES}, {"particles_mass", COL_PARTICLES_KG},
    {"impacts_energy", COL_IMPACTS_J}, {"first", COL_FIRST_KG},
    {"first_energy", COL_FIRST_J}};

/* Units at the end of a heading, the SI unit that each becomes, and the
 * factor. */
static const struct {
	const char *end, *unit;
	double scale;
} UNITS[] = {{"_j_kg", "J/kg", 1}, {"_kj_kg", "J/kg", 1e3},
    {"_kwh_t", "J/kg", 3600}, {"_j_g", "J/kg", 1e3}, {"_m_s", "m/s", 1},
    {"_mm_s", "m/s", 1e-3}, {"_km_h", "m/s", 1 / 3.6}, {"_mm", "m", 1e-3},
    {"_um", "m", 1e-6}, {"_kg", "kg", 1}, {"_g", "kg", 1e-3},
    {"_mg", "kg", 1e-6}, {"_mj", "J", 1e-3}, {"_kj", "J", 1e3}, {"_j", "J", 1},
    {"_m", "m", 1}};

enum { FIELDS_MOST = 64 };

struct reading {
	const char *path;
	const struct collisions_way *way;
	struct error_list *errors;
	struct collisions *to;
	FILE *in;
	char *line;
	size_t length, room;
	int at;                          /* number of the line */
	char separator;                  /* ' ' means any blanks */
	size_t n;                        /* number of columns */
	enum column column[FIELDS_MOST]; /* what each field is */
	double scale[FIELDS_MOST];
	bool has[COLUMNS_ALL + 1];
	/* the numbers of this row, in SI units */
	double value[COLUMNS_ALL + 1];
	/* the number of impacts that the file states */
	uint64_t told;
};

static bool
fault(
    struct reading *r, enum error_kind kind, const char *what, const char *hint)
{
	return error_set_at(error_list_add_item(r->errors), kind, r->path,
	    r->at, 0, "%s\n%s", tr(what), tr(hint));
}

/* Reads the next line, without its line end.  Returns false at the end of the
 * file. */
static bool
read_next_line(struct reading *r)
{
	r->length = 0;
	if (text_read_line(&r->line, &r->length, &r->room, r->in) != TEXT_LINE)
		return false;
	r->at++;
	while (r->length > 0 && strchr("\r\n", r->line[r->length - 1]) != NULL)
		r->line[--r->length] = '\0';
	return true;
}

/* Returns the field at *s, which it ends with a NUL, and moves *s past it; NULL
 * after the last. */
static char *
next_field_of_line(const struct reading *r, char **s)
{
	char *begin = *s;
	if (begin == NULL)
		return NULL;
	if (r->separator == ' ') {
		begin += strspn(begin, " \t");
		if (*begin == '\0')
			return NULL;
		/* "velocity (m/s)" is one word. */
		char *end = begin + strcspn(begin, " \t");
		char *unit = end + strspn(end, " \t");
		*s = *unit == '(' || *unit == '[' ? unit + strcspn(unit, " \t")
						  : end;
	} else {
		bool quoted = *begin == '"';
		char *end = quoted ? strchr(begin + 1, '"') : begin;
		*s = strchr(end != NULL ? end : begin, r->separator);
	}
	if (*s != NULL && **s != '\0')
		*(*s)++ = '\0';
	else
		*s = NULL;
	if (begin[0] == '"') {
		begin++;
		begin[strcspn(begin, "\"")] = '\0';
	}
	return begin;
}

/* Returns "Relative Velocity Normal (m/s)" as relative_velocity_normal_m_s. */
static char *
heading_to_identifier(const char *head)
{
	char *plain = text_fold_case_and_accents(head);
	size_t n = 0;
	for (const char *c = plain; *c != '\0'; c++) {
		bool micro = strncmp(c, "\xC2\xB5", 2) == 0 ||
			     strncmp(c, "\xCE\xBC", 2) == 0;
		bool letter = micro || isalnum((unsigned char)*c) != 0;
		if (letter)
			plain[n++] = micro ? 'u' : *c;
		else if (n > 0 && plain[n - 1] != '_')
			plain[n++] = '_';
		c += micro;
	}
	while (n > 0 && plain[n - 1] == '_')
		n--;
	plain[n] = '\0';
	return plain;
}

static enum column
find_column_by_identifier(const char *plain)
{
	for (size_t i = 0; i < ARRAY_LEN(HEADS); i++)
		if (strcmp(plain, HEADS[i].head) == 0)
			return HEADS[i].column;
	return COL_NONE;
}

/* Returns what a column contains according to its heading.  *scale gets the
 * factor to SI units. */
static enum column
collisions_column_of_heading(const char *head, double *scale)
{
	FREED char *plain = heading_to_identifier(head);
	enum column column = find_column_by_identifier(plain);
	const char *unit = "";
	*scale = column == COL_SIZE ? 1e-3 : 1;
	for (size_t i = 0; column == COL_NONE && i < ARRAY_LEN(UNITS); i++) {
		if (!text_ends_with(plain, UNITS[i].end))
			continue;
		plain[strlen(plain) - strlen(UNITS[i].end)] = '\0';
		column = find_column_by_identifier(plain);
		unit = UNITS[i].unit;
		*scale = UNITS[i].scale;
		break;
	}
	if (column == COL_ENERGY && strcmp(unit, "J/kg") == 0)
		column = COL_SPECIFIC;
	if (column == COL_WEIGHT && strcmp(unit, "J") == 0)
		column = COL_IMPACTS_J;
	if (column == COL_FIRST_KG && strcmp(unit, "J") == 0)
		column = COL_FIRST_J;
	if (column == COL_PARTICLES && strcmp(unit, "kg") == 0)
		column = COL_PARTICLES_KG;
	if (strcmp(plain, "energy") == 0 && strcmp(unit, "m/s") == 0)
		column = COL_NONE;
	return column;
}

static void
add_collision_column(struct reading *r, const char *head)
{
	double scale = 1;
	enum column column = collisions_column_of_heading(head, &scale);
	if (r->n >= FIELDS_MOST)
		return;
	if (column != COL_NONE && r->has[column])
		column = COL_NONE;
	r->column[r->n] = column;
	r->scale[r->n++] = scale;
	r->has[column] = true;
}

static void
set_collision_columns_from_names(
    struct reading *r, const char *heads, char separator)
{
	FREED char *copy = xstrdup(heads);
	char *rest = copy, *head, was = r->separator;
	r->separator = separator;
	r->n = 0;
	memset(r->has, 0, sizeof r->has);
	while ((head = next_field_of_line(r, &rest)) != NULL)
		add_collision_column(r, head);
	r->separator = was;
}

/* True if the columns give energies; otherwise reports what is missing and how
 * to name the columns. */
static bool
check_energy_columns(struct reading *r)
{
	if (r->has[COL_VELOCITY] || r->has[COL_SPECIFIC] ||
	    (r->has[COL_ENERGY] && r->has[COL_MASS]) ||
	    (r->has[COL_LOW] && r->has[COL_HIGH] && r->has[COL_WEIGHT]))
		return true;
	bool joules = r->has[COL_ENERGY] && !r->has[COL_MASS];
	return fault(r, ERROR_DATA,
	    joules
		? N_("expected a column with the mass of the particle beside "
		     "its energy in J, got none")
		: N_("expected a column of specific energy (J/kg) or normal "
		     "velocity (m/s), got none"),
	    N_("name the columns in their order: "
	       "columns=-,velocity_m_s,mass_kg"));
}

/* Reads the numbers of a row.  Returns false with a fault if a field is missing
 * or not a number. */
static bool
parse_numbers_of_row(struct reading *r)
{
	char *rest = r->line;
	for (size_t i = 0; i < r->n; i++) {
		char *field = next_field_of_line(r, &rest), *end = NULL;
		if (field == NULL)
			return fault(r, ERROR_DATA,
			    "expected a number in each column, got fewer",
			    "is the file complete?");
		if (r->column[i] == COL_NONE)
			continue;
		/* strtod reads a decimal point, as the program sets only
		 * LC_CTYPE; see text_parse_number. */
		double v = strtod(field, &end);
		if (end == field || end[strspn(end, " ")] != '\0' ||
		    !isfinite(v))
			return fault(r, ERROR_DATA,
			    "expected a finite number, got other text",
			    "check this row; numbers have a decimal point");
		r->value[r->column[i]] = r->scale[i] * v;
	}
	r->to->rows++;
	return true;
}

static bool
report_rows_read_so_far(struct reading *r)
{
	const uint64_t often = 1 << 17;
	if (r->way->progress == NULL || r->to->rows % often != 0 ||
	    r->way->progress(r->way->data, r->to->rows))
		return true;
	return error_set_at(error_list_add_item(r->errors), ERROR_CHECK,
	    r->path, 0, 0, "stopped after %llu rows: nothing was loaded",
	    (unsigned long long)r->to->rows);
}

/* Returns the energy of a row, J/kg. */
static double
collision_energy_of_row(const struct reading *r)
{
	const double *v = r->value;
	if (r->has[COL_SPECIFIC])
		return v[COL_SPECIFIC];
	if (r->has[COL_VELOCITY])
		return v[COL_VELOCITY] * v[COL_VELOCITY] / 2;
	if (r->has[COL_ENERGY])
		return v[COL_ENERGY] / v[COL_MASS];
	if (r->has[COL_IMPACTS_J])
		return v[COL_WEIGHT] > 0 ? v[COL_IMPACTS_J] / v[COL_WEIGHT] : 0;
	return sqrt(fmax(v[COL_LOW], 0) * v[COL_HIGH]);
}

static bool
add_impact_of_row(struct reading *r)
{
	struct spectrum *s = r->to->spectrum;
	const double *v = r->value;
	double size = r->has[COL_SIZE]     ? v[COL_SIZE]
		      : r->has[COL_RADIUS] ? 2 * v[COL_RADIUS]
					   : 0;
	double mass = r->has[COL_WEIGHT] ? v[COL_WEIGHT]
		      : r->has[COL_MASS] ? v[COL_MASS]
					 : 1;
	double e = collision_energy_of_row(r);
	if (!(e >= 0) || !(mass >= 0))
		return fault(r, ERROR_DATA,
		    "expected an energy and a weight of at least 0, got less",
		    "check this row");
	if (r->has[COL_PARTICLES] && v[COL_PARTICLES] > 0) {
		s->counted = true;
		spectrum_add_particles(
		    s, size, v[COL_PARTICLES], v[COL_PARTICLES_KG]);
	}
	if (mass > 0)
		spectrum_add_impact(s, size, mass, e, false);
	r->to->impacts += mass > 0;
	if (r->has[COL_FIRST_KG] && r->has[COL_FIRST_J] && v[COL_FIRST_KG] > 0)
		spectrum_add_first_impact(
		    s, size, v[COL_FIRST_KG], v[COL_FIRST_J] / v[COL_FIRST_KG]);
	return true;
}

/* Reads a line such as "speed_m_s,69" or "provenance,.." above the headings.
 * Returns false if it is not such a line. */
static bool
parse_line_above_headings(struct reading *r)
{
	FREED char *copy = xstrdup(r->line);
	char *rest = copy;
	const char *key = next_field_of_line(r, &rest),
		   *value = next_field_of_line(r, &rest);
	double v;
	if (key == NULL || value == NULL)
		return key != NULL && strcmp(key, "spectrum") == 0;
	if (strcmp(key, "speed_m_s") == 0 && text_parse_number(value, &v) &&
	    v > 0) {
		r->to->spectrum->speed = v;
		return true;
	}
	if (strcmp(key, "provenance") == 0) {
		xfree_and_set(&r->to->about, xstrdup(value));
		return true;
	}
	return strcmp(key, "spectrum") == 0 ||
	       (strcmp(key, "impacts") == 0 &&
		   text_parse_whole_number(value, &r->told));
}

/* Reads the headings of a table; for a list without headings, takes its columns
 * from the options.  *is_row: the line has numbers, not headings. */
static bool
read_table_headings(struct reading *r, bool *is_row)
{
	FREED char *copy = xstrdup(r->line);
	char *rest = copy;
	double v;
	const char *first = next_field_of_line(r, &rest);
	*is_row = first != NULL && text_parse_number(first, &v);
	bool two = next_field_of_line(r, &rest) != NULL;
	if (r->way->columns != NULL)
		set_collision_columns_from_names(r, r->way->columns, ',');
	else if (!*is_row)
		set_collision_columns_from_names(r, r->line, r->separator);
	else if (r->way->unit == NULL)
		return fault(r, ERROR_USAGE,
		    "expected headings above the numbers, got none",
		    "say what they are: unit=j_kg or unit=m_s, or columns=");
	else
		set_collision_columns_from_names(r,
		    strcmp(r->way->unit, "m/s") == 0
			? two ? "velocity,weight" : "velocity"
		    : two ? "specific_energy,weight"
			  : "specific_energy",
		    ',');
	return check_energy_columns(r);
}

static bool
collisions_read_table(struct reading *r)
{
	bool ok = true, is_row = false;
	r->separator = strchr(r->line, '\t')  ? '\t'
		       : strchr(r->line, ';') ? ';'
		       : strchr(r->line, ',') ? ','
					      : ' ';
	while (parse_line_above_headings(r))
		if (!read_next_line(r))
			return fault(r, ERROR_DATA, "expected rows, got none",
			    "is the file complete?");
	ok = read_table_headings(r, &is_row);
	if (ok && is_row)
		ok = parse_numbers_of_row(r) && add_impact_of_row(r);
	while (ok && read_next_line(r))
		ok = r->length == 0 ||
		     (parse_numbers_of_row(r) && add_impact_of_row(r) &&
			 report_rows_read_so_far(r));
	if (r->told > 0)
		r->to->impacts = r->told;
	else
		r->to->weighted =
		    r->has[COL_WEIGHT] && !r->to->spectrum->counted;
	r->to->spectrum->ordered = r->has[COL_FIRST_KG];
	r->to->form =
	    r->has[COL_LOW] ? tr("binned spectrum") : tr("list of impacts");
	return ok;
}

static bool
read_collisions_stream(struct reading *r)
{
	if (!read_next_line(r))
		return fault(r, ERROR_DATA, "expected collisions, got nothing",
		    "is it the right file?");
	if (strncmp(r->line, "ITEM:", 5) == 0)
		return fault(r, ERROR_DATA,
		    "expected impacts, got a LIGGGHTS dump of contacts",
		    "merge its contacts into impacts: dem/merge CONTACTS "
		    "PARTICLES > impacts.csv");
	return collisions_read_table(r);
}

bool
collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors)
{
	const char *why;
	struct reading r = {
	    .path = path, .way = way, .errors = errors, .to = c};
	*c = (struct collisions){
	    .spectrum = spectrum_new(), .about = xstrdup(""), .form = ""};
	r.in = textfile_open(path, &why);
	bool ok = r.in != NULL;
	FREED char *hint = textfile_hint_after_failed_open(path);
	if (!ok)
		error_set_at(error_list_add_item(errors), ERROR_SYSTEM, path, 0,
		    0, "cannot read: %s\n%s", why, hint);
	ok = ok && read_collisions_stream(&r);
	if (ok && !feof(r.in)) /* or a line is too long */
		ok = fault(&r, ERROR_SYSTEM, "cannot be read to its end",
		    ferror(r.in) ? N_("check the disk")
				 : N_("is it the right file?"));
	if (ok && c->impacts == 0)
		ok = fault(&r, ERROR_DATA, "expected impacts, got none",
		    "is it the right file?");
	if (ok && isfinite(way->speed))
		c->spectrum->speed = way->speed;
	if (r.in != NULL)
		fclose(r.in);
	free(r.line);
	if (!ok)
		collisions_clear(c);
	return ok;
}

void
collisions_clear(struct collisions *c)
{
	spectrum_free(c->spectrum);
	free(c->about);
	*c = (struct collisions){.spectrum = NULL};
}

static void
write_spectrum_rows(const struct spectrum_size *of, FILE *out)
{
	bool begun = false;
	for (size_t b = 0; b < SPECTRUM_BINS; b++) {
		const double row[] = {units_m_to_mm(of->size),
		    begun ? 0 : of->particles, begun ? 0 : of->mass,
		    spectrum_bin_edge(b), spectrum_bin_edge(b + 1),
		    of->all[b].mass, of->all[b].energy, of->first[b].mass,
		    of->first[b].energy};
		if (!(of->all[b].mass > 0) && (begun || !(of->mass > 0)))
			continue;
		for (size_t i = 0; i < ARRAY_LEN(row); i++)
			fprintf(out, "%s%.9g", i > 0 ? "," : "", row[i]);
		fputc('\n', out);
		begun = true;
	}
}

void
collisions_write(const struct collisions *c, const char *name, FILE *out)
{
	char text[32];
	const struct spectrum *s = c->spectrum;
	fprintf(out, "spectrum,\"%s\"\n", name);
	if (!c->weighted)
		fprintf(out, "impacts,%llu\n", (unsigned long long)c->impacts);
	if (isfinite(s->speed))
		fprintf(out, "speed_m_s,%s\n",
		    text_shortest_exact_number(s->speed, text));
	fprintf(out, "provenance,\"%s\"\n", c->about);
	fputs("size_mm,particles,particles_kg,low_j_kg,high_j_kg,impacts_kg,"
	      "impacts_j,first_kg,first_j\n",
	    out);
	for (size_t i = 0; i < s->n; i++)
		write_spectrum_rows(s->size[i], out);
}
