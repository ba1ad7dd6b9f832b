/* Reads a circuit from rows such as "screen,crushed,8,oversize,fine".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/circuit_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "core/psd/rotor_speed.h"
#include "core/psd/site.h"
#include "io/cells/number.h"
#include "io/cells/source.h"
#include "io/sitefile/units.h"

static const char *const WORDS[UNIT_KINDS] = {
    "feed", "crusher", "screen", "split", "stockpile"};

enum { STREAMS = CIRCUIT_UNITS * UNIT_STREAMS * 2 };

/* A file being read.  made, used [STREAMS]: the cells that name a stream as the
 * output and as the input of a unit; text is NULL if there is none.  row
 * [CIRCUIT_UNITS]: the first cell of each unit. */
struct reading_circuit {
	struct sheet *sheet;
	struct circuit *circuit;
	const struct site *site; /* whose rotor rpm are of, or NULL */
	struct cell *made, *used, row[CIRCUIT_UNITS];
};

/* Returns the part of a cell from `from` on, trimmed in place, as a cell of its
 * own. */
static struct cell
rest_of_cell_as_cell(
    const struct reading_circuit *r, struct cell cell, char *from)
{
	while (*from == ' ' || *from == '\t')
		from++;
	cell.column += (int)(from - cell.text);
	return number_reparse_cell_with_text(r->sheet, cell, text_trim(from));
}

static void
add_stream_to_unit(
    struct reading_circuit *r, struct unit *unit, struct cell cell, bool made)
{
	if (cell.text[0] == '\0' || strpbrk(cell.text, "+=") != NULL) {
		sheet_report_expected(r->sheet, cell, "the name of a stream",
		    "name streams as you like, without + and =");
		return;
	}
	size_t i = circuit_find_or_add_stream(r->circuit, cell.text);
	struct cell *first = made ? &r->made[i] : &r->used[i];
	size_t *n = made ? &unit->n_out : &unit->n_in;
	if (first->text != NULL)
		sheet_report_fault(r->sheet, cell,
		    made ? N_("expected one source of '%.40s', got a second "
			      "one\n"
			      "line %d has the first: give one of the two "
			      "another name, and join them where they are "
			      "used: a + b")
			 : N_("expected one use of '%.40s', got a second "
			      "one\nline %d has the first: divide the stream "
			      "with a split line"),
		    cell.text, first->line);
	else if (*n < UNIT_STREAMS) {
		*first = cell;
		(made ? unit->out : unit->in)[(*n)++] = i;
	}
}

/* Adds the input streams that a cell names, "new + back". */
static void
parse_input_streams(
    struct reading_circuit *r, struct unit *unit, struct cell cell)
{
	size_t n = 1;
	for (const char *p = cell.text; *p != '\0'; p++)
		n += *p == '+';
	if (n > UNIT_STREAMS) {
		sheet_report_fault(r->sheet, cell,
		    "expected at most %d streams, got %zu\njoin some of them "
		    "upstream, in a crusher or a split",
		    (int)UNIT_STREAMS, n);
		return;
	}
	for (char *at = cell.text; at != NULL;) {
		char *plus = strchr(at, '+');
		if (plus != NULL)
			*plus = '\0';
		add_stream_to_unit(
		    r, unit, rest_of_cell_as_cell(r, cell, at), false);
		at = plus != NULL ? plus + 1 : NULL;
	}
}

static bool
parse_number_between(struct reading_circuit *r, struct cell cell,
    const char *wanted, double least, double most, double *value)
{
	if (!number_read_cell(r->sheet, cell, wanted, value))
		return false;
	if (number_is_ambiguous(r->sheet, cell) && 1000 * *value <= most)
		return sheet_report_fault(r->sheet, cell,
		    "expected a number that can be read in one way, got %s: a "
		    "decimal sign, or thousands?\nwrite %g or %g",
		    cell.text, *value, 1000 * *value);
	if (*value >= least && *value <= most)
		return true;
	return sheet_report_expected(
	    r->sheet, cell, wanted, "see tipspeed-circuit(5) for units");
}

/* The settings, key=value, that may follow a row, and the kind of unit that
 * each is for.  The number is divided by `scale` (100 for per cent) and stored
 * at `offset`. */
static const struct key {
	const char *word, *wanted;
	enum unit_kind kind;
	double least, most, scale;
	size_t offset;
} KEYS[] = {
    {"cascade", N_("a cascade from 0 to 90 %"), UNIT_CRUSHER, 0, 90, 100,
	offsetof(struct unit, cascade)},
    {"speed", N_("a tip speed from 1 to 400 m/s"), UNIT_CRUSHER, 1,
	SITE_FASTEST, 1, offsetof(struct unit, speed)},
    {"sharpness", N_("a sharpness from 0.1 to 100"), UNIT_SCREEN, 0.1, 100, 1,
	offsetof(struct unit, partition.sharpness)},
    {"cut_size", N_("a cut size from 10 to 200 % of the opening"), UNIT_SCREEN,
	10, 200, 100, offsetof(struct unit, partition.cut_size)},
    {"price", N_("a price from -1e6 to 1e6"), UNIT_STOCKPILE, -1e6, 1e6, 1,
	offsetof(struct unit, price)},
};

static const char *const HINTS[UNIT_KINDS] = {
    [UNIT_FEED] = N_("write: feed,STREAM,120"),
    [UNIT_CRUSHER] = N_("write: crusher,FROM + FROM,TO, optionally followed by "
			"cascade=10 or speed=74"),
    [UNIT_SCREEN] = N_("write: screen,FROM,8,OVERSIZE,UNDERSIZE, optionally "
		       "followed by sharpness=6 or cut_size=95"),
    [UNIT_SPLIT] = N_("write: split,FROM,TO=60,TO=40"),
    [UNIT_STOCKPILE] = N_(
	"write: stockpile,FROM + FROM,NAME, optionally followed by price=12")};

/* Reads "1400rpm" as a speed of the site's rotor. */
static void
parse_speed_in_rpm(
    const struct reading_circuit *r, struct cell cell, double *speed)
{
	double rotor = r->site != NULL ? r->site->rotor : 0, rpm;
	FREED char *number =
	    xstrndup(cell.text, strlen(cell.text) - strlen("rpm"));
	if (!(rotor > 0))
		sheet_report_expected(r->sheet, cell,
		    tr("a tip speed from 1 to 400 m/s"),
		    "rpm need the rotor's diameter: a line rotor_mm in the "
		    "site file");
	else if (!text_parse_number(text_trim(number), &rpm) ||
		 rotor_speed_from_rpm(rpm, rotor) < 1 ||
		 rotor_speed_from_rpm(rpm, rotor) > SITE_FASTEST)
		sheet_report_expected(r->sheet, cell,
		    tr("a tip speed from 1 to 400 m/s"),
		    "see tipspeed-circuit(5) for units");
	else
		*speed = site_speed_from_rpm(r->site, rpm, rotor);
}

static void
parse_circuit_unit_key(
    struct reading_circuit *r, struct unit *unit, struct cell cell)
{
	char *sign = strchr(cell.text, '=');
	for (size_t k = 0; sign != NULL && k < ARRAY_LEN(KEYS); k++) {
		const struct key *key = &KEYS[k];
		size_t n = strlen(key->word);
		double value;
		if (key->kind != unit->kind ||
		    !text_is_same_but_case(cell.text, key->word, n) ||
		    cell.text[n + strspn(cell.text + n, " ")] != '=')
			continue;
		struct cell number = rest_of_cell_as_cell(r, cell, sign + 1);
		void *place = (char *)unit + key->offset;
		double *to = place;
		if (to == &unit->speed && text_ends_with(number.text, "rpm")) {
			parse_speed_in_rpm(r, number, to);
			return;
		}
		if (parse_number_between(
			r, number, key->wanted, key->least, key->most, &value))
			*to = value / key->scale;
		return;
	}
	sheet_report_expected(r->sheet, cell,
	    "the end of the line, or a setting", "%s", tr(HINTS[unit->kind]));
}

/* Functions that read a row return the place in it from which settings may
 * follow. */
static size_t
parse_circuit_feed_row(
    struct reading_circuit *r, struct unit *unit, const struct row *row)
{
	struct cell tph = row_cell_at(row, 2);
	double value;
	add_stream_to_unit(r, unit, row_cell_at(row, 1), true);
	if (tph.text[0] != '\0' &&
	    parse_number_between(
		r, tph, tr("a feed above 0, up to 1e5 t/h"), 1e-3, 1e5, &value))
		r->circuit->tph = value;
	return 3;
}

static size_t
parse_circuit_crusher_row(
    struct reading_circuit *r, struct unit *unit, const struct row *row)
{
	parse_input_streams(r, unit, row_cell_at(row, 1));
	add_stream_to_unit(r, unit, row_cell_at(row, 2), true);
	return 3;
}

static size_t
parse_circuit_screen_row(
    struct reading_circuit *r, struct unit *unit, const struct row *row)
{
	double mm = 1;
	parse_input_streams(r, unit, row_cell_at(row, 1));
	parse_number_between(r, row_cell_at(row, 2), tr("an opening in mm"),
	    SIZE_LEAST_MM, SIZE_MOST_MM, &mm);
	unit->opening = mm / 1000;
	add_stream_to_unit(r, unit, row_cell_at(row, 3), true);
	add_stream_to_unit(r, unit, row_cell_at(row, 4), true);
	return 5;
}

/* Reads an output of a split, "a=60", or "a", which takes the rest.  Returns
 * its share, 0..1, or NAN for the rest. */
static double
parse_split_output(
    struct reading_circuit *r, struct unit *unit, struct cell cell)
{
	char *sign = strchr(cell.text, '=');
	double share = NAN;
	if (sign != NULL) {
		*sign = '\0';
		struct cell number = rest_of_cell_as_cell(r, cell, sign + 1);
		if (parse_number_between(r, number,
			tr("a share from 0 to 100 %"), 0, 100, &share))
			share /= 100;
		else
			share = 0;
	}
	add_stream_to_unit(
	    r, unit, rest_of_cell_as_cell(r, cell, cell.text), true);
	return share;
}

static size_t
parse_circuit_split_row(
    struct reading_circuit *r, struct unit *unit, const struct row *row)
{
	const double exact = 1e-6;
	double sum = 0;
	size_t open = 0, n = row->n > 2 ? row->n - 2 : 0;
	parse_input_streams(r, unit, row_cell_at(row, 1));
	if (n < 2 || n > UNIT_STREAMS) {
		sheet_report_fault(r->sheet, row->cell[0],
		    "expected a split into 2 to %d streams, got %zu\n%s",
		    (int)UNIT_STREAMS, n, tr(HINTS[UNIT_SPLIT]));
		return row->n;
	}
	for (size_t i = 0; i < n; i++) {
		double share = parse_split_output(r, unit, row->cell[i + 2]);
		unit->share[i] = share;
		open += isnan(share) ? 1 : 0;
		sum += isnan(share) ? 0 : share;
	}
	if (open > 1 || sum > 1 + exact || (open == 0 && sum < 1 - exact))
		sheet_report_fault(r->sheet, row->cell[2],
		    open > 1 ? N_("expected shares that sum to 100 %%, got %g "
				  "%% and the rest twice\nonly one stream may "
				  "be without a share: it takes the rest")
			     : N_("expected shares that sum to 100 %%, got %g "
				  "%%\nonly one stream may be without a share: "
				  "it takes the rest"),
		    round(sum * 1e8) / 1e6);
	for (size_t i = 0; i < n; i++)
		unit->share[i] = isnan(unit->share[i]) ? fmax(1 - sum, 0)
				 : open == 0           ? unit->share[i] / sum
						       : unit->share[i];
	return row->n;
}

static size_t
parse_circuit_stockpile_row(
    struct reading_circuit *r, struct unit *unit, const struct row *row)
{
	struct cell from = row_cell_at(row, 1), name = row_cell_at(row, 2);
	bool key = strchr(name.text, '=') != NULL;
	xfree_and_set(&unit->name,
	    xstrdup(name.text[0] != '\0' && !key ? name.text : from.text));
	parse_input_streams(r, unit, from);
	return key ? 2 : 3;
}

static void
parse_circuit_unit_row(struct reading_circuit *r, const struct row *row)
{
	static size_t (*const READ[UNIT_KINDS])(struct reading_circuit *,
	    struct unit *, const struct row *) = {parse_circuit_feed_row,
	    parse_circuit_crusher_row, parse_circuit_screen_row,
	    parse_circuit_split_row, parse_circuit_stockpile_row};
	struct cell word = row->cell[0];
	if (text_is_same_folded(word.text, "circuit")) {
		xfree_and_set(
		    &r->circuit->name, xstrdup(row_cell_at(row, 1).text));
		return;
	}
	for (size_t k = 0; k < UNIT_KINDS; k++) {
		if (!text_is_same_folded(word.text, WORDS[k]))
			continue;
		struct unit *unit =
		    circuit_add_unit(r->circuit, (enum unit_kind)k, "");
		if (unit == NULL) {
			sheet_report_fault(r->sheet, word,
			    "expected at most %d units, got more\n"
			    "tipspeed is for small circuits",
			    (int)CIRCUIT_UNITS);
			return;
		}
		r->row[r->circuit->n_unit - 1] = word;
		for (size_t i = READ[k](r, unit, row); i < row->n; i++)
			if (row->cell[i].text[0] != '\0')
				parse_circuit_unit_key(r, unit, row->cell[i]);
		return;
	}
	sheet_report_expected(r->sheet, word,
	    "circuit, feed, crusher, screen, split or stockpile",
	    "begin each line with one of these; see tipspeed-circuit(5)");
}

static void
check_streams_connected(struct reading_circuit *r)
{
	for (size_t i = 0; i < r->circuit->n_stream; i++) {
		if (r->made[i].text == NULL)
			sheet_report_expected(r->sheet, r->used[i],
			    "a stream that a unit makes",
			    "no feed, crusher, screen or split of the file "
			    "makes this stream: is it spelled the same way "
			    "there?");
		else if (r->used[i].text == NULL)
			sheet_report_expected(r->sheet, r->made[i],
			    "a stream that a unit takes",
			    "nothing takes it: send it to a unit or add a "
			    "line: stockpile,%.40s",
			    r->made[i].text);
	}
}

static void
check_exactly_one_feed(struct reading_circuit *r)
{
	size_t feeds = 0;
	struct cell start = {.line = 1, .column = 1}, second = start;
	for (size_t u = 0; u < r->circuit->n_unit; u++)
		if (r->circuit->unit[u].kind == UNIT_FEED && feeds++ == 1)
			second = r->row[u];
	if (feeds == 0 && !r->sheet->lost)
		sheet_report_fault(r->sheet, start,
		    "expected a line that begins with feed, got none\n%s",
		    tr(HINTS[UNIT_FEED]));
	if (feeds > 1)
		sheet_report_fault(r->sheet, second,
		    "expected one feed, got a second one\n"
		    "there is one feed, that of the site; a split shares it "
		    "out");
}

/* Checks that all units are fed and no stream is trapped in a loop.  All
 * streams must have a source and a destination. */
static void
check_paths_through_circuit(struct reading_circuit *r)
{
	const struct circuit *c = r->circuit;
	size_t unfed = circuit_find_unfed_unit(c),
	       trapped = circuit_find_trapped_stream(c);
	if (unfed < c->n_unit)
		sheet_report_fault(r->sheet, r->row[unfed],
		    "expected a path from the feed to this %s, got none\nits "
		    "input comes only from itself: see the lines of its "
		    "streams",
		    WORDS[c->unit[unfed].kind]);
	else if (trapped < c->n_stream)
		sheet_report_fault(r->sheet, r->made[trapped],
		    "expected a path from '%.40s' to a stockpile, got a loop "
		    "that never empties\nsend part of it, or of what it "
		    "becomes, to a stockpile",
		    c->stream[trapped]);
}

struct circuit *
circuit_file_read(
    const char *path, const struct site *site, struct error_list *errors)
{
	struct source source;
	struct circuit *circuit = NULL;
	if (source_read_sheets(path, errors, &source)) {
		struct reading_circuit r = {.sheet = source.sheet[0],
		    .circuit = circuit_new(),
		    .site = site,
		    .made = xcalloc(STREAMS, sizeof *r.made),
		    .used = xcalloc(STREAMS, sizeof *r.used)};
		for (size_t i = 0; i < r.sheet->n_row; i++)
			parse_circuit_unit_row(&r, &r.sheet->row[i]);
		check_exactly_one_feed(&r);
		if (r.sheet->n_fault == 0)
			check_streams_connected(&r);
		if (r.sheet->n_fault == 0)
			check_paths_through_circuit(&r);
		free(r.made);
		free(r.used);
		circuit = r.circuit;
		if (r.sheet->n_fault > 0 || errors->stopped) {
			circuit_free(circuit);
			circuit = NULL;
		}
	}
	source_free(&source);
	return circuit;
}
