/* The table of habits, and plans made of them.  To add one: a function that
 * changes the plan, or says that it does not go with those before it, and a
 * row.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "habits.h"

static bool
on(bool *habit)
{
	*habit = true;
	return true;
}

static bool
is_table(const struct plan *p)
{
	return p->shape == SHAPE_WIDE || p->shape == SHAPE_ACROSS ||
	       p->shape == SHAPE_BESIDE || p->shape == SHAPE_BELOW ||
	       p->shape >= SHAPE_EACH_BESIDE;
}

static bool
is_passing(const struct plan *p)
{
	return p->quantity == PASS_PCT && p->feed_quantity == PASS_PCT;
}

static bool
is_held(const struct plan *p)
{
	return p->quantity == HELD_G && p->feed_quantity == HELD_G;
}

/* Language first: words and the decimal sign follow from it. */
static bool
tongue(struct plan *p, size_t i)
{
	if (p->tongue != &TONGUES[0])
		return false;
	p->tongue = &TONGUES[i];
	return true;
}

static bool
swedish(struct plan *p)
{
	return tongue(p, 1);
}

static bool
german(struct plan *p)
{
	return tongue(p, 2);
}

static bool
french(struct plan *p)
{
	return tongue(p, 3);
}

static bool
spanish(struct plan *p)
{
	return tongue(p, 4);
}

static bool
portuguese(struct plan *p)
{
	return tongue(p, 5);
}

static bool
finnish(struct plan *p)
{
	return tongue(p, 6);
}

/* Separators and numbers. */
static bool
semicolons(struct plan *p)
{
	if (p->tongue->comma && chance(p, 0.75))
		p->decimal = ',';
	p->separator = ';';
	return true;
}

static bool
tabs(struct plan *p)
{
	if (p->separator != ',')
		return false;
	if (p->tongue->comma && chance(p, 0.75))
		p->decimal = ',';
	p->separator = '\t';
	return true;
}

static bool
quoted_comma(struct plan *p)
{
	if (p->separator != ',')
		return false;
	p->decimal = ',';
	return true;
}

static bool
thousands(struct plan *p, const char *sign)
{
	bool taken =
	    (sign[0] == p->decimal && sign[1] == '\0') || p->thousands != NULL;
	if (taken || !is_held(p) || p->workbook)
		return false;
	p->thousands = sign;
	return true;
}

static bool
thousands_blank(struct plan *p)
{
	return thousands(p, " ");
}

static bool
thousands_nbsp(struct plan *p)
{
	return thousands(p, "\xC2\xA0");
}

static bool
thousands_narrow(struct plan *p)
{
	return p->coding != CP_1252 && thousands(p, "\xE2\x80\xAF");
}

static bool
thousands_apostrophe(struct plan *p)
{
	return thousands(p, "'");
}

static bool
thousands_quote(struct plan *p)
{
	return thousands(p, "\xE2\x80\x99");
}

static bool
thousands_comma(struct plan *p)
{
	return p->decimal == '.' && thousands(p, ",");
}

static bool
thousands_point(struct plan *p)
{
	return p->decimal == ',' && thousands(p, ".");
}

static bool
percent_signs(struct plan *p)
{
	return p->quantity != HELD_G && p->quantity != SUM_G &&
	       on(&p->percent_signs);
}

static bool
gram_signs(struct plan *p)
{
	return is_held(p) && on(&p->gram_signs);
}

static bool
gaps(struct plan *p, int which)
{
	if (p->gaps != 0 || !is_table(p) || p->paired)
		return false;
	p->gaps = which;
	return true;
}

static bool
empty_cells(struct plan *p)
{
	return gaps(p, 1);
}

static bool
dashes(struct plan *p)
{
	return gaps(p, 2);
}

static bool
not_available(struct plan *p)
{
	return is_passing(p) && gaps(p, 3);
}

static bool
less_than(struct plan *p)
{
	return gaps(p, 4);
}

/* Codings and line ends. */
static bool
coding(struct plan *p, enum coding wanted)
{
	const char *off = getenv("TIPSPEED_TEST_ENCODINGS");
	if (p->coding != UTF_8 || (off != NULL && strcmp(off, "0") == 0))
		return false;
	p->coding = wanted;
	return true;
}

static bool
windows_1252(struct plan *p)
{
	return coding(p, CP_1252);
}

static bool
utf_16le(struct plan *p)
{
	return coding(p, UTF_16LE);
}

static bool
utf_16be(struct plan *p)
{
	return coding(p, UTF_16BE);
}

static bool
byte_mark(struct plan *p)
{
	if (p->coding != UTF_8)
		return false;
	p->coding = UTF_8_BOM;
	return true;
}

static bool
crlf(struct plan *p)
{
	p->line_end = "\r\n";
	return true;
}

static bool
cr(struct plan *p)
{
	if (p->line_end[0] == '\r')
		return false;
	p->line_end = "\r";
	return true;
}

/* What is counted. */
static bool
quantity(struct plan *p, enum written wanted)
{
	if (!is_passing(p))
		return false;
	p->quantity = p->feed_quantity = wanted;
	return true;
}

static bool
passing_share(struct plan *p)
{
	return quantity(p, PASS_SHARE);
}

static bool
held_g(struct plan *p)
{
	return quantity(p, HELD_G);
}

static bool
held_pct(struct plan *p)
{
	return quantity(p, HELD_PCT);
}

static bool
held_share(struct plan *p)
{
	return quantity(p, HELD_SHARE);
}

static bool
sum_pct(struct plan *p)
{
	return quantity(p, SUM_PCT);
}

static bool
sum_g(struct plan *p)
{
	return quantity(p, SUM_G);
}

static bool
sum_share(struct plan *p)
{
	return quantity(p, SUM_SHARE);
}

static bool
feed_counted_otherwise(struct plan *p)
{
	static const enum written OTHERS[] = {PASS_PCT, HELD_PCT, SUM_PCT};
	if (!is_table(p) || p->feed_only)
		return false;
	p->feed_quantity = OTHERS[pick(p, 3)];
	return p->feed_quantity != p->quantity;
}

static bool
whole_percent(struct plan *p)
{
	return is_passing(p) && on(&p->whole_pct);
}

static bool
whole_grams(struct plan *p)
{
	return is_held(p) && on(&p->grams_whole);
}

static bool
losses(struct plan *p)
{
	return is_held(p) && is_table(p) && on(&p->loss);
}

static bool
washed_fines(struct plan *p)
{
	return is_held(p) && is_table(p) && on(&p->washed);
}

static bool
paired(struct plan *p)
{
	if (!is_table(p) || p->plain_heads || p->quantity != p->feed_quantity ||
	    (p->quantity != HELD_G && p->quantity != PASS_PCT &&
		p->quantity != HELD_PCT))
		return false;
	return on(&p->paired);
}

static bool
pan_row(struct plan *p)
{
	return on(&p->pan);
}

static bool
total_row(struct plan *p)
{
	return p->quantity >= HELD_G && p->quantity <= HELD_SHARE &&
	       p->feed_quantity == p->quantity && is_table(p) && on(&p->total);
}

/* Sieves. */
static bool
series(struct plan *p, const struct series *wanted)
{
	if (p->series != &SERIES_EN)
		return false;
	p->series = p->feed_series = wanted;
	return true;
}

static bool
sieves_en_2(struct plan *p)
{
	return series(p, &SERIES_EN_2);
}

static bool
sieves_iso(struct plan *p)
{
	return series(p, &SERIES_ISO);
}

static bool
sieves_astm_mm(struct plan *p)
{
	return series(p, &SERIES_ASTM);
}

static bool
names(struct plan *p, const struct series *wanted)
{
	if (p->sizes != SIZE_MM || !series(p, wanted))
		return false;
	p->sizes = SIZE_NAMES;
	return true;
}

static bool
names_astm(struct plan *p)
{
	return names(p, &SERIES_ASTM);
}

static bool
names_bs(struct plan *p)
{
	return names(p, &SERIES_BS);
}

static bool
names_tyler(struct plan *p)
{
	return names(p, &SERIES_TYLER);
}

static bool
mesh_in_head(struct plan *p)
{
	if (p->sizes != SIZE_NAMES || p->series == &SERIES_ASTM)
		return false;
	p->sizes = SIZE_NUMBERS;
	return true;
}

static bool
sizes(struct plan *p, enum sizes wanted)
{
	if (p->sizes != SIZE_MM)
		return false;
	p->sizes = wanted;
	return true;
}

static bool
sizes_um(struct plan *p)
{
	return sizes(p, SIZE_UM);
}

static bool
sizes_in_cells(struct plan *p)
{
	return sizes(p, SIZE_IN_CELL);
}

static bool
sizes_um_below_1(struct plan *p)
{
	return sizes(p, SIZE_UM_BELOW_1);
}

static bool
sizes_inches(struct plan *p)
{
	return sizes(p, SIZE_INCHES);
}

static bool
sizes_bare(struct plan *p)
{
	return sizes(p, SIZE_BARE);
}

static bool
sizes_ranges(struct plan *p)
{
	return is_held(p) && is_table(p) && p->series == &SERIES_EN &&
	       !p->apart && sizes(p, SIZE_RANGES);
}

static bool
sizes_below(struct plan *p)
{
	return is_passing(p) && !p->pan && is_table(p) && sizes(p, SIZE_BELOW);
}

static bool
greek_micro(struct plan *p)
{
	return (p->sizes == SIZE_UM || p->sizes == SIZE_UM_BELOW_1) &&
	       p->coding != CP_1252 && on(&p->micro_greek);
}

static bool
finest_first(struct plan *p)
{
	return p->shape != SHAPE_LONG && p->shape != SHAPE_PAIRS &&
	       on(&p->finest_first);
}

static bool
two_sizes(struct plan *p)
{
	return p->sizes == SIZE_NAMES && is_table(p) && on(&p->two_sizes);
}

/* Shapes. */
static bool
shape(struct plan *p, enum shape wanted)
{
	if (p->shape != SHAPE_WIDE)
		return false;
	p->shape = wanted;
	return true;
}

static bool
across(struct plan *p)
{
	return shape(p, SHAPE_ACROSS);
}

static bool
long_table(struct plan *p)
{
	return shape(p, SHAPE_LONG);
}

static bool
pairs(struct plan *p)
{
	return shape(p, SHAPE_PAIRS);
}

/* The feed on other sieves. */
static bool
apart(struct plan *p, enum shape wanted)
{
	p->apart = p->shape == SHAPE_WIDE;
	return shape(p, wanted);
}

static bool
beside(struct plan *p)
{
	return apart(p, SHAPE_BESIDE);
}

static bool
below(struct plan *p)
{
	return apart(p, SHAPE_BELOW);
}

static bool
cut_files(struct plan *p)
{
	p->at_files = false;
	return apart(p, SHAPE_FILES);
}

static bool
cut_files_at(struct plan *p)
{
	if (!apart(p, SHAPE_FILES))
		return false;
	return on(&p->at_files);
}

static bool
workbook(struct plan *p)
{
	p->decimal = '.';
	p->coding = UTF_8;
	return on(&p->workbook);
}

/* A table for each sample. */
static bool
each(struct plan *p, enum shape wanted)
{
	if (!shape(p, wanted))
		return false;
	p->heads = HEADS_ABOVE;
	return wanted != SHAPE_EACH_SHEET || workbook(p);
}

static bool
each_beside(struct plan *p)
{
	return each(p, SHAPE_EACH_BESIDE);
}

static bool
each_below(struct plan *p)
{
	return each(p, SHAPE_EACH_BELOW);
}

static bool
each_sheet(struct plan *p)
{
	return each(p, SHAPE_EACH_SHEET);
}

static bool
two_sites(struct plan *p)
{
	return p->shape != SHAPE_FILES && on(&p->two_sites);
}

/* Runs. */
static bool
repeats(struct plan *p)
{
	return p->shape != SHAPE_PAIRS && p->shape != SHAPE_EACH_SHEET &&
	       !p->feed_only && on(&p->repeats);
}

static bool
individual_feeds(struct plan *p)
{
	bool fits = (p->shape == SHAPE_WIDE || p->shape == SHAPE_ACROSS) &&
		    !p->repeats && !p->feed_only &&
		    p->quantity == p->feed_quantity &&
		    p->speeds != SPEED_SAMPLE && p->speeds != SPEED_ALONE &&
		    p->speeds < SPEED_BRACKETS;
	return fits && on(&p->individual);
}

static bool
one_product(struct plan *p)
{
	return on(&p->one_product);
}

static bool
feed_only(struct plan *p)
{
	return is_table(p) && !p->two_sites && on(&p->feed_only);
}

static bool
fast_first(struct plan *p)
{
	return is_table(p) && !p->individual && on(&p->fast_first);
}

static bool
products_first(struct plan *p)
{
	return is_table(p) && !p->individual && on(&p->products_first);
}

/* Heads. */
static bool
speeds(struct plan *p, enum speeds wanted)
{
	if (p->speeds != SPEED_MPS || p->shape == SHAPE_LONG ||
	    p->shape == SHAPE_PAIRS || p->shape == SHAPE_FILES)
		return false;
	p->speeds = wanted;
	return true;
}

static bool
speed_at(struct plan *p)
{
	return speeds(p, SPEED_AT);
}

static bool
speed_bare(struct plan *p)
{
	return speeds(p, SPEED_BARE);
}

static bool
speed_alone(struct plan *p)
{
	return speeds(p, SPEED_ALONE);
}

static bool
speed_and_turns(struct plan *p)
{
	return speeds(p, SPEED_BOTH);
}

static bool
speed_of_sample(struct plan *p)
{
	return speeds(p, SPEED_SAMPLE);
}

static bool
speed_in_brackets(struct plan *p)
{
	return speeds(p, SPEED_BRACKETS);
}

static bool
speed_and_date(struct plan *p)
{
	return speeds(p, SPEED_DATED);
}

static bool
speed_turns(struct plan *p)
{
	bool can = p->speeds == SPEED_MPS && !p->at_files;
	p->rotor_in_m = can && chance(p, 0.3);
	if (can)
		p->speeds = SPEED_RPM;
	return can;
}

static bool
speed_feet(struct plan *p)
{
	if (p->speeds != SPEED_MPS || p->at_files)
		return false;
	p->speeds = SPEED_FEET;
	return true;
}

static bool
speed_kmh(struct plan *p)
{
	if (p->speeds != SPEED_MPS || p->at_files)
		return false;
	p->speeds = SPEED_KMH;
	return true;
}

static bool
heads(struct plan *p, enum heads wanted)
{
	if (p->heads != HEADS_ONE || !is_table(p))
		return false;
	p->heads = wanted;
	return true;
}

static bool
heads_two(struct plan *p)
{
	return heads(p, HEADS_TWO);
}

static bool
heads_three(struct plan *p)
{
	return heads(p, HEADS_THREE);
}

static bool
heads_speed_row(struct plan *p)
{
	bool fits = p->speeds == SPEED_MPS || p->speeds >= SPEED_RPM;
	return fits && p->speeds != SPEED_BRACKETS && heads(p, HEADS_SPEED_ROW);
}

static bool
heads_apart(struct plan *p)
{
	bool fits = p->shape == SHAPE_WIDE && !p->plain_heads &&
		    (p->speeds == SPEED_MPS || p->speeds >= SPEED_RPM);
	return fits && p->speeds != SPEED_BRACKETS && heads(p, HEADS_APART);
}

static bool
heads_unit_row(struct plan *p)
{
	return heads(p, HEADS_UNIT_ROW);
}

static bool
plain_heads(struct plan *p)
{
	return is_passing(p) && is_table(p) && !p->paired &&
	       on(&p->plain_heads);
}

static bool
caption(struct plan *p)
{
	if (!is_table(p) || p->heads == HEADS_ABOVE || p->paired ||
	    p->quantity != p->feed_quantity)
		return false;
	p->plain_heads = true;
	return on(&p->caption);
}

static bool
plain_held(struct plan *p)
{
	if (!is_table(p) || p->paired || p->caption ||
	    p->quantity != p->feed_quantity ||
	    (p->quantity != HELD_G && p->quantity != HELD_PCT))
		return false;
	return on(&p->plain_heads);
}

/* A line a sample: the corner names the samples, nothing the sieves. */
static bool
sample_corner(struct plan *p)
{
	bool heads = p->heads == HEADS_ONE || p->heads == HEADS_SPEED_ROW;
	bool fits = p->sizes == SIZE_MM || p->sizes == SIZE_BARE ||
		    p->sizes == SIZE_IN_CELL || p->sizes == SIZE_BELOW;
	if (p->shape != SHAPE_ACROSS || !heads || !fits)
		return false;
	p->sizes = p->sizes == SIZE_MM ? SIZE_BARE : p->sizes;
	return on(&p->sample_corner);
}

static bool
upper(struct plan *p)
{
	return on(&p->upper);
}

static bool
no_accents(struct plan *p)
{
	return on(&p->no_accents);
}

static bool
quotes(struct plan *p)
{
	return on(&p->quotes);
}

static bool
loose(struct plan *p)
{
	return on(&p->loose);
}

static bool
broken_heads(struct plan *p)
{
	return p->shape == SHAPE_WIDE && p->heads == HEADS_ONE &&
	       p->line_end[0] != '\r' && on(&p->broken_heads);
}

static bool
padded(struct plan *p)
{
	return on(&p->padded);
}

static bool
sep_line(struct plan *p)
{
	return p->separator != '\t' && on(&p->sep_line);
}

/* Lines around the table, columns and rows that are no data. */
static bool
title(struct plan *p)
{
	return on(&p->title);
}

static bool
blank_lines(struct plan *p)
{
	return on(&p->blanks);
}

static bool
header(struct plan *p)
{
	return on(&p->header);
}

static bool
remarks(struct plan *p)
{
	return on(&p->remarks);
}

static bool
person_row(struct plan *p)
{
	return on(&p->person_row);
}

static bool
date_row(struct plan *p)
{
	return (p->shape == SHAPE_WIDE || p->shape == SHAPE_ACROSS) &&
	       on(&p->date_row);
}

static bool
count_row(struct plan *p)
{
	return p->shape == SHAPE_ACROSS && on(&p->count_row);
}

static bool
remark_row(struct plan *p)
{
	return p->shape == SHAPE_ACROSS && on(&p->remark_row);
}

static bool
other_rows(struct plan *p)
{
	return is_table(p) && on(&p->other_rows);
}

static bool
lab_lines(struct plan *p)
{
	return on(&p->lab_lines);
}

static bool
fineness_row(struct plan *p)
{
	return is_table(p) && on(&p->fineness);
}

static bool
row_numbers(struct plan *p)
{
	return p->shape == SHAPE_WIDE && on(&p->row_numbers);
}

static bool
remark_column(struct plan *p)
{
	return is_table(p) && on(&p->remark_column);
}

static bool
date_column(struct plan *p)
{
	return p->shape == SHAPE_WIDE && on(&p->date_column);
}

static bool
lab_column(struct plan *p)
{
	return p->shape == SHAPE_WIDE && !p->row_numbers && on(&p->lab_column);
}

static bool
blank_column(struct plan *p)
{
	return p->shape == SHAPE_WIDE && on(&p->blank_column);
}

static bool
limits(struct plan *p)
{
	return is_table(p) && is_passing(p) && on(&p->limits);
}

static bool
size_last(struct plan *p)
{
	return p->shape == SHAPE_WIDE && on(&p->size_last);
}

/* In order: those below see what those above have changed. */
const struct habit HABITS[] = {
    {"Swedish", 0.2, swedish},
    {"German", 0.12, german},
    {"French", 0.1, french},
    {"Spanish", 0.1, spanish},
    {"Portuguese", 0.1, portuguese},
    {"Finnish", 0.1, finnish},
    {"semicolons", 0.4, semicolons},
    {"tabs", 0.12, tabs},
    {"decimal comma in quotes", 0.06, quoted_comma},
    {"Windows-1252", 0.06, windows_1252},
    {"UTF-16LE", 0.03, utf_16le},
    {"UTF-16BE", 0.02, utf_16be},
    {"byte order mark", 0.1, byte_mark},
    {"CRLF", 0.3, crlf},
    {"CR", 0.03, cr},
    {"workbook", 0.1, workbook},
    {"sieves across", 0.15, across},
    {"long table", 0.06, long_table},
    {"long table, feed beside product", 0.04, pairs},
    {"tables beside each other", 0.05, beside},
    {"tables below each other", 0.05, below},
    {"a table for each sample, beside", 0.03, each_beside},
    {"a table for each sample, below", 0.03, each_below},
    {"a sheet for each sample", 0.03, each_sheet},
    {"a file for each cut", 0.03, cut_files},
    {"a file for each cut, @speed", 0.03, cut_files_at},
    {"two sites", 0.03, two_sites},
    {"retained g", 0.25, held_g},
    {"retained %", 0.1, held_pct},
    {"cumulative retained %", 0.08, sum_pct},
    {"cumulative retained g", 0.04, sum_g},
    {"passing fraction", 0.05, passing_share},
    {"retained fraction", 0.03, held_share},
    {"cumulative retained fraction", 0.02, sum_share},
    {"feed only", 0.04, feed_only},
    {"one product", 0.1, one_product},
    {"feed counted otherwise", 0.05, feed_counted_otherwise},
    {"two quantities side by side", 0.07, paired},
    {"losses", 0.15, losses},
    {"washed fines", 0.1, washed_fines},
    {"whole per cent", 0.06, whole_percent},
    {"whole grams", 0.4, whole_grams},
    {"pan row", 0.2, pan_row},
    {"row of sums", 0.4, total_row},
    {"sieves of ASTM by name", 0.06, names_astm},
    {"sieves of BS by name", 0.03, names_bs},
    {"sieves of Tyler by name", 0.03, names_tyler},
    {"series of mesh in the head", 0.4, mesh_in_head},
    {"sieves of ASTM in mm", 0.06, sieves_astm_mm},
    {"sieves of EN 933, set 2", 0.1, sieves_en_2},
    {"sieves of ISO 565", 0.1, sieves_iso},
    {"um", 0.07, sizes_um},
    {"mm in the cells", 0.06, sizes_in_cells},
    {"mm and um in the cells", 0.04, sizes_um_below_1},
    {"inches", 0.02, sizes_inches},
    {"sizes without a unit", 0.05, sizes_bare},
    {"classes of size", 0.04, sizes_ranges},
    {"classes of what passes", 0.06, sizes_below},
    {"Greek micro", 0.4, greek_micro},
    {"names and mm of sieves", 0.25, two_sizes},
    {"finest first", 0.1, finest_first},
    {"speed behind @", 0.1, speed_at},
    {"speed without a unit", 0.08, speed_bare},
    {"speed alone", 0.1, speed_alone},
    {"rpm and m/s", 0.06, speed_and_turns},
    {"sample and speed", 0.08, speed_of_sample},
    {"number and speed", 0.06, speed_in_brackets},
    {"date and speed", 0.03, speed_and_date},
    {"rpm and rotor", 0.08, speed_turns},
    {"ft/min", 0.03, speed_feet},
    {"km/h", 0.02, speed_kmh},
    {"repeats", 0.1, repeats},
    {"feeds of their own", 0.08, individual_feeds},
    {"fastest first", 0.06, fast_first},
    {"products first", 0.06, products_first},
    {"heads in two rows", 0.1, heads_two},
    {"heads in three rows", 0.07, heads_three},
    {"speeds in a row", 0.08, heads_speed_row},
    {"speeds above another line", 0.05, heads_apart},
    {"units in a row", 0.07, heads_unit_row},
    {"plain heads", 0.4, plain_heads},
    {"caption", 0.05, caption},
    {"plain heads above retained", 0.08, plain_held},
    {"samples in the corner", 0.6, sample_corner},
    {"capitals", 0.08, upper},
    {"no accents", 0.1, no_accents},
    {"thousands by blank", 0.2, thousands_blank},
    {"thousands by nbsp", 0.15, thousands_nbsp},
    {"thousands by narrow nbsp", 0.1, thousands_narrow},
    {"thousands by apostrophe", 0.06, thousands_apostrophe},
    {"thousands by right quote", 0.06, thousands_quote},
    {"thousands by comma", 0.2, thousands_comma},
    {"thousands by point", 0.2, thousands_point},
    {"percent signs", 0.06, percent_signs},
    {"g in the cells", 0.05, gram_signs},
    {"empty cells", 0.06, empty_cells},
    {"dashes", 0.06, dashes},
    {"n/a", 0.04, not_available},
    {"<0.1", 0.04, less_than},
    {"quotes", 0.1, quotes},
    {"blanks around cells", 0.05, loose},
    {"line breaks in heads", 0.05, broken_heads},
    {"padded rows", 0.25, padded},
    {"sep=", 0.03, sep_line},
    {"title", 0.25, title},
    {"blank lines", 0.3, blank_lines},
    {"key-value lines", 0.2, header},
    {"remarks", 0.12, remarks},
    {"operator", 0.08, person_row},
    {"row of dates", 0.06, date_row},
    {"row of counts", 0.3, count_row},
    {"row of remarks", 0.15, remark_row},
    {"moisture, P80 and the like", 0.08, other_rows},
    {"lines of a laboratory", 0.08, lab_lines},
    {"fineness modulus", 0.05, fineness_row},
    {"row numbers", 0.04, row_numbers},
    {"column of remarks", 0.05, remark_column},
    {"column of dates", 0.02, date_column},
    {"laboratory numbers", 0.02, lab_column},
    {"blank column", 0.03, blank_column},
    {"limits", 0.04, limits},
    {"sizes last", 0.02, size_last},
};

size_t
habits_count(void)
{
	return ARRAY_LEN(HABITS);
}

static struct plan *
plan_start(uint64_t seed)
{
	static const double ROTORS[] = {690, 760, 840, 900, 990};
	struct plan *p = xcalloc(1, sizeof *p);
	p->seed = seed;
	p->draw = draw_start(seed);
	p->tongue = &TONGUES[0];
	p->series = p->feed_series = &SERIES_EN;
	p->separator = ',';
	p->decimal = '.';
	p->line_end = "\n";
	p->word = (int)pick(p, 27720);
	p->rotor_mm = ROTORS[pick(p, ARRAY_LEN(ROTORS))];
	return p;
}

struct plan *
plan_new(uint64_t seed, int trap)
{
	struct plan *p = plan_start(seed);
	assert_true(ARRAY_LEN(HABITS) <= MOST_HABITS);
	for (size_t i = 0; i < ARRAY_LEN(HABITS); i++)
		if (chance(p, HABITS[i].often * (trap < 0 ? 1 : 0.3)))
			p->used[i] = HABITS[i].take(p);
	/* Traps change texts. */
	p->workbook = p->workbook && trap < 0;
	if (trap >= 0 && p->shape == SHAPE_EACH_SHEET)
		p->shape = SHAPE_EACH_BELOW;
	const struct trap *t = trap < 0 ? NULL : &TRAPS[trap];
	p->trap = t != NULL ? t->name : NULL;
	if (t != NULL && t->before != NULL)
		t->before(p);
	truth_make(p);
	if (t != NULL && t->truth != NULL)
		t->truth(p);
	if (t != NULL && t->make != NULL)
		t->make(p);
	else
		sheet_make(p);
	/* The other site is a sheet of its own, without a third. */
	if (!p->two_sites || t != NULL)
		return p;
	for (uint64_t next = seed + 1000000; p->other == NULL; next++) {
		p->other = plan_new(next, -1);
		bool fits = p->other->n_file == 1 && p->other->other == NULL &&
			    !p->other->feed_only;
		if (!fits) {
			plan_free(p->other);
			p->other = NULL;
		}
	}
	return p;
}

void
plan_free(struct plan *plan)
{
	if (plan == NULL)
		return;
	plan_free(plan->other);
	for (size_t i = 0; i < plan->n_file; i++)
		file_clear(&plan->file[i]);
	free(plan);
}

char *
plan_habits(const struct plan *plan)
{
	char *list = xstrdup("");
	if (plan->trap != NULL)
		xappend_to_list(&list, ", ", "TRAP %s", plan->trap);
	for (size_t i = 0; i < ARRAY_LEN(HABITS); i++)
		if (plan->used[i])
			xappend_to_list(&list, ", ", "%s", HABITS[i].name);
	return list;
}
