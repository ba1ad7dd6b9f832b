/* Sheets that cannot be read without a question, or not at all: whoever loads
 * one as something else than the truth has read it wrongly.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "habits.h"

/* As a plain sheet, of which only the trap is odd. */
static void
plain(struct plan *p)
{
	p->shape = SHAPE_WIDE;
	p->apart = p->at_files = p->two_sites = p->paired = p->plain_heads =
	    p->caption = p->feed_only = p->individual = p->size_last =
		p->repeats = p->two_sizes = p->limits = false;
	p->sizes = SIZE_MM;
	p->series = p->feed_series = &SERIES_EN;
	p->speeds = SPEED_MPS;
	p->heads = HEADS_ONE;
	p->quantity = p->feed_quantity = PASS_PCT;
	p->gaps = 0;
	p->loss = p->washed = p->row_numbers = p->lab_column = p->broken_heads =
	    p->gram_signs = false;
	p->plain_speed = true;
}

static void
plain_held(struct plan *p)
{
	plain(p);
	p->quantity = p->feed_quantity = HELD_G;
}

/* Changes the cells of the one file, which is UTF-8 then. */
static void
swap_text(struct plan *p, const char *from, const char *to)
{
	struct made_file *file = &p->file[0];
	char *copy = xstrdup(""), *at = file->bytes, *next;
	while (*from != '\0' && (next = strstr(at, from)) != NULL) {
		xappend(&copy, "%.*s%s", (int)(next - at), at, to);
		at = next + strlen(from);
	}
	xappend(&copy, "%s", at);
	free(file->bytes);
	file->bytes = copy;
	file->n = strlen(copy);
}

static void
make_utf_8(struct plan *p)
{
	p->coding = UTF_8;
	sheet_make(p);
}

/* Another word in place of each speed: what stands before the number of the
 * product, and after it. */
static void
instead_of_speeds(struct plan *p, const char *before, double first, double step,
    const char *after)
{
	make_utf_8(p);
	for (size_t c = 0, n = 0; c < p->n_curve; c++) {
		if (p->curve[c].feed)
			continue;
		char *speed = head_speed(p, &p->curve[c]);
		char *word = xasprintf(
		    "%s%g%s", before, first + step * (double)n++, after);
		swap_text(p, speed, word);
		free(speed);
		free(word);
	}
}

static void
hertz_make(struct plan *p)
{
	instead_of_speeds(p, "", 45, 5, " Hz");
}

static void
power_make(struct plan *p)
{
	instead_of_speeds(p, "", 185, 15, " kW");
}

static void
years_make(struct plan *p)
{
	instead_of_speeds(p, "", 2024, 1, "");
}

static void
fractions_make(struct plan *p)
{
	instead_of_speeds(p, "0/", 4, 4, "");
}

static void
tonnes_make(struct plan *p)
{
	instead_of_speeds(p, "", 80, 20, " t/h");
}

/* 690 m/s, which no rotor does. */
static void
too_fast_make(struct plan *p)
{
	instead_of_speeds(p, "", 690, 50, " m/s");
}

/* Numbers that are no tip speed as they stand: a power, two of them, a part. */
static void
odd_numbers_make(struct plan *p)
{
	static const struct {
		const char *before;
		double first;
		const char *after;
	} ODD[] = {{"@7.4e", 1, ""}, {"@1E+0", 2, ""}, {"@1e", 9, ""},
	    {"@1 0", 70, ""}, {"@", 6, " 9"}, {"@", 69, "..70"},
	    {"@", 74, " or 75"}, {"@.", 69, ""}, {"7.4e", 1, " m/s"},
	    {"", 69, "..70 m/s"}, {"", 74, " or 75 m/s"}, {"", 69, " - 70 m/s"},
	    {"@", 74, " approx 75"}, {"@", 74, " (approx 75)"},
	    {"", 74, " m/s approx 75"}, {"@", 74, " about 75"},
	    {"@", 70, " etwa 72"}, {"", 74, " m/s or 75"}};
	size_t i = p->seed / 7 % ARRAY_LEN(ODD);
	instead_of_speeds(p, ODD[i].before, ODD[i].first, 1, ODD[i].after);
}

static void
two_feeds_make(struct plan *p)
{
	p->curve[p->n_curve - 1].feed = true;
	p->curve[p->n_curve - 1].speed = 0;
	make_utf_8(p);
}

/* Thousandths of an inch, which nobody says. */
static void
odd_sizes(struct plan *p)
{
	plain(p);
	p->sizes = SIZE_BARE;
	p->series = p->feed_series = &SERIES_ISO;
}

static void
odd_sizes_make(struct plan *p)
{
	double mm[MOST_CURVES][MOST_SIEVES];
	for (size_t c = 0; c < p->n_curve; c++)
		for (size_t i = 0; i < p->curve[c].n; i++) {
			mm[c][i] = p->curve[c].mm[i];
			p->curve[c].mm[i] = round(mm[c][i] / 0.0254);
		}
	make_utf_8(p);
	for (size_t c = 0; c < p->n_curve; c++)
		memcpy(p->curve[c].mm, mm[c], sizeof mm[c]);
}

static void
um_with_comma(struct plan *p)
{
	plain_held(p);
	p->sizes = SIZE_UM;
	p->separator = ';';
	p->decimal = '.';
	p->thousands = ",";
	p->grams_whole = true;
}

static void
ordinals_make(struct plan *p)
{
	p->coding = UTF_8;
	p->speeds = SPEED_BARE;
	for (size_t c = 0, n = 0; c < p->n_curve; c++)
		if (!p->curve[c].feed)
			p->curve[c].as_written = (double)++n;
	sheet_make(p);
}

static void
wrong_quantity_make(struct plan *p)
{
	static const enum written LIES[] = {HELD_PCT, SUM_PCT, HELD_G, SUM_G};
	enum written lie = LIES[pick(p, 4)];
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].quantity = lie;
	p->pan = p->total = false;
	make_utf_8(p);
}

static void
held_as_passing_make(struct plan *p)
{
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].quantity = PASS_PCT;
	p->total = false;
	p->pan = true;
	make_utf_8(p);
}

static void
held_pct_plain(struct plan *p)
{
	plain(p);
	p->quantity = p->feed_quantity = HELD_PCT;
}

static void
sum_pct_plain(struct plan *p)
{
	plain(p);
	p->quantity = p->feed_quantity = SUM_PCT;
}

/* Two or three columns of numbers under nothing. */
static void
no_heads_make(struct plan *p)
{
	struct sheets *grid = xcalloc(1, sizeof *grid);
	for (size_t i = 0; i < p->curve[0].n; i++) {
		grid_put(grid, i, 0, size_cell(p, &p->curve[0], i));
		for (size_t c = 0; c < p->n_curve; c++)
			grid_put(
			    grid, i, c + 1, value_cell(p, &p->curve[c], i));
	}
	p->coding = UTF_8;
	grid_write(p, grid, "sheet.csv");
}

static void
mesh_of_nobody(struct plan *p)
{
	plain(p);
	p->series = p->feed_series = &SERIES_TYLER;
	p->sizes = SIZE_NAMES;
	p->word &= ~1;
}

static void
mesh_of_nobody_make(struct plan *p)
{
	make_utf_8(p);
	swap_text(p, "Tyler ", "");
}

/* May and June, each complete: one sheet, two sieve analyses. */
static void
two_tables_make(struct plan *p)
{
	char *may;
	p->coding = UTF_8;
	sheet_make(p);
	may = xasprintf("Mai%s%s", p->line_end, p->file[0].bytes);
	p->n_file = 0;
	free(p->file[0].bytes);
	p->n_curve = 0;
	plain(p);
	truth_make(p);
	sheet_make(p);
	char *both = xasprintf("%s%s%sJune%s%s", may, p->line_end, p->line_end,
	    p->line_end, p->file[0].bytes);
	free(may);
	free(p->file[0].bytes);
	p->file[0].bytes = both;
	p->file[0].n = strlen(both);
	/* Neither of the two is what the sheet says. */
	p->n_curve = 0;
}

static void
rpm_alone(struct plan *p)
{
	plain(p);
	p->speeds = SPEED_RPM;
}

static void
rpm_alone_make(struct plan *p)
{
	p->header = p->person_row = p->title = p->lab_lines = false;
	p->word |= 1; /* the rotor in one cell, "Rotor diameter (mm): 900" */
	make_utf_8(p);
	char *first =
	    xstrndup(p->file[0].bytes, strcspn(p->file[0].bytes, "\r\n"));
	if (strchr(first, ':') != NULL)
		swap_text(p, first, "");
	free(first);
}

static void
curves_of_others(struct plan *p)
{
	plain(p);
	p->limits = true;
}

static void
curves_of_others_make(struct plan *p)
{
	static const char *const WORDS[][2] = {{"0/8 min", "0/8 max"},
	    {"Fuller", "Target"}, {"Last year", "Design"}, {"A", "B"},
	    {"Mean", "Std dev"}, {"Average", "Goal"}};
	struct tongue mine = *p->tongue;
	const struct tongue *was = p->tongue;
	size_t which = pick(p, ARRAY_LEN(WORDS));
	mine.low = WORDS[which][0];
	mine.high = WORDS[which][1];
	p->tongue = &mine;
	make_utf_8(p);
	p->tongue = was;
}

/* The pan gained a tenth of the sample, the sum did not. */
static void
wrong_pan_make(struct plan *p)
{
	struct curve *c = &p->curve[p->n_curve - 1];
	double sum = 0;
	for (size_t i = 0; i <= c->n; i++)
		sum += c->shown[i];
	char *right = plan_number(p, sum, c->decimals);
	double more = floor(sum / 10);
	c->shown[c->n] += more;
	char *wrong = plan_number(p, sum + more, c->decimals);
	p->total = true;
	make_utf_8(p);
	swap_text(p, wrong, right);
	free(wrong);
	free(right);
}

/* Shares under a head that says per cent, and the other way round. */
static void
shares_as_pct_make(struct plan *p)
{
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].quantity = PASS_PCT;
	make_utf_8(p);
}

static void
shares(struct plan *p)
{
	plain(p);
	p->quantity = p->feed_quantity = PASS_SHARE;
	p->percent_signs = false;
	p->pan = false;
}

static void
pct_as_shares_make(struct plan *p)
{
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].quantity = PASS_SHARE;
	p->pan = false;
	make_utf_8(p);
}

/* 8, 4, 2, 1, 500, 250 under "mm". */
static void
mixed_units_make(struct plan *p)
{
	double mm[MOST_CURVES][MOST_SIEVES];
	for (size_t c = 0; c < p->n_curve; c++)
		for (size_t i = 0; i < p->curve[c].n; i++) {
			mm[c][i] = p->curve[c].mm[i];
			if (mm[c][i] < 1)
				p->curve[c].mm[i] *= 1000;
		}
	make_utf_8(p);
	for (size_t c = 0; c < p->n_curve; c++)
		memcpy(p->curve[c].mm, mm[c], sizeof mm[c]);
}

static void
thousand_times_make(struct plan *p)
{
	double mm[MOST_CURVES][MOST_SIEVES];
	for (size_t c = 0; c < p->n_curve; c++)
		for (size_t i = 0; i < p->curve[c].n; i++) {
			mm[c][i] = p->curve[c].mm[i];
			p->curve[c].mm[i] *= 1000;
		}
	make_utf_8(p);
	for (size_t c = 0; c < p->n_curve; c++)
		memcpy(p->curve[c].mm, mm[c], sizeof mm[c]);
}

static void
broken_formula_make(struct plan *p)
{
	static const char *const FAULTS[] = {
	    "#DIV/0!", "#REF!", "####", "Err:502"};
	struct curve *c = &p->curve[p->n_curve - 1];
	size_t i = 2 + pick(p, c->n - 4);
	c->shown[i] = 77777.5;
	p->coding = UTF_8;
	p->total = false;
	p->thousands = NULL;
	sheet_make(p);
	char *number = plan_number(p, c->shown[i], c->decimals);
	swap_text(p, number, FAULTS[pick(p, ARRAY_LEN(FAULTS))]);
	free(number);
}

static void
rising_passing_make(struct plan *p)
{
	struct curve *c = &p->curve[p->n_curve - 1];
	size_t i = 3;
	c->shown[i] = fmin(100, c->shown[i - 1] + 12);
	if (c->shown[i] <= c->shown[i - 1])
		c->shown[i - 1] -= 20;
	make_utf_8(p);
}

static void
no_pan_make(struct plan *p)
{
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].quantity = HELD_PCT;
	p->pan = p->total = false;
	p->coding = UTF_8;
	sheet_make(p);
	swap_text(p, quantity_unit(p, HELD_PCT), "g");
}

static void
same_sieve_twice_make(struct plan *p)
{
	double was = p->curve[0].mm[4];
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].mm[4] = p->curve[c].mm[3];
	make_utf_8(p);
	for (size_t c = 0; c < p->n_curve; c++)
		p->curve[c].mm[4] = was;
}

static void
product_alone_make(struct plan *p)
{
	struct sheets *grid = xcalloc(1, sizeof *grid);
	const struct curve *c = &p->curve[1];
	char *speed = head_speed(p, c);
	grid_put(grid, 0, 0, head_size(p));
	grid_put(grid, 0, 1,
	    xasprintf("%s %s", plan_word(p, p->tongue->product, 6), speed));
	for (size_t i = 0; i < c->n; i++) {
		grid_put(grid, i + 1, 0, size_cell(p, c, i));
		grid_put(grid, i + 1, 1, value_cell(p, c, i));
	}
	free(speed);
	p->coding = UTF_8;
	grid_write(p, grid, "sheet.csv");
	/* A cut without a feed: the curve may be loaded, nothing else. */
	p->curve[0] = p->curve[1];
	p->n_curve = 1;
}

static void
other_thing(struct plan *p, const char *text)
{
	p->coding = UTF_8;
	p->n_curve = 0;
	plan_text(p, "sheet.csv", text);
}

static void
timesheet_make(struct plan *p)
{
	other_thing(p, "Tidrapport vecka 18;;;;;\nNamn;Mån;Tis;Ons;Tor;Fre\n"
		       "Åsa;8,0;8,0;7,5;8,0;6,0\nBengt;8;8;8;8;8\n"
		       "Cecilia;0;4;8;8;8\nSumma;16;20;23,5;24;22\n");
}

static void
prices_make(struct plan *p)
{
	other_thing(p,
	    "Product,Size (mm),Price EUR/t,Stock t\n0/2,2,14.50,1200\n"
	    "2/5,5,12.00,800\n5/8,8,11.50,650\n8/11,11.2,11.00,2100\n"
	    "11/16,16,10.50,1800\n");
}

static void
plant_log_make(struct plan *p)
{
	other_thing(p, "Time;rpm;kW;t/h\n2026-05-03 10:00;1350;182,5;120\n"
		       "2026-05-03 10:01;1352;183,1;121\n"
		       "2026-05-03 10:02;1348;181,9;119\n"
		       "2026-05-03 10:03;1351;182,2;120\n");
}

static void
sieve_stock_make(struct plan *p)
{
	other_thing(p,
	    "Sieve (mm),Serial,Bought,Frame mm,Checked %\n"
	    "16,A1,2019,200,100\n8,A2,2019,200,99.5\n4,A3,2020,200,99\n"
	    "2,A4,2020,200,98.5\n1,A5,2021,200,98\n0.5,A6,2021,200,97\n"
	    "0.25,A7,2022,200,96.5\n0.063,A8,2022,200,95\n");
}

static void
envelope_make(struct plan *p)
{
	other_thing(p,
	    "Sieve size (mm);Min passing (%);Max passing (%)\n8;100;100\n"
	    "4;95;100\n2;70;95\n1;45;70\n0,5;28;50\n0,25;15;30\n"
	    "0,125;6;16\n0,063;3;10\n");
}

static void
numbers_make(struct plan *p)
{
	other_thing(p, "1,2,3\n4,5,6\n7,8,9\n10,11,12\n");
}

static void
prose_make(struct plan *p)
{
	other_thing(p,
	    "The sieve analysis of May went well; the feed was 0/22.\n"
	    "Product at 69 m/s passed 98.5 % at 11.2 mm, 80 % at 5.6 mm.\n");
}

const struct trap TRAPS[] = {
    {"sizes of no unit, odd", odd_sizes, NULL, odd_sizes_make, false},
    {"um with thousands by comma", um_with_comma, NULL, make_utf_8, false},
    {"ordinals for speeds", plain, NULL, ordinals_make, false},
    {"passing headed as retained", plain, NULL, wrong_quantity_make, false},
    {"retained headed as passing", held_pct_plain, NULL, held_as_passing_make,
	false},
    {"cumulative retained headed as passing", sum_pct_plain, NULL,
	held_as_passing_make, false},
    {"grams headed as passing", plain_held, NULL, held_as_passing_make, false},
    {"no heads", plain, NULL, no_heads_make, false},
    {"mesh of no series", mesh_of_nobody, NULL, mesh_of_nobody_make, true},
    {"two tables", plain, NULL, two_tables_make, true},
    {"rpm without a rotor", rpm_alone, NULL, rpm_alone_make, true},
    {"curves of others", curves_of_others, NULL, curves_of_others_make, false},
    {"wrong pan", plain_held, NULL, wrong_pan_make, true},
    {"fractions headed %", shares, NULL, shares_as_pct_make, false},
    {"per cent headed fraction", plain, NULL, pct_as_shares_make, false},
    {"mm and um under mm", plain, NULL, mixed_units_make, false},
    {"um under mm", plain, NULL, thousand_times_make, false},
    {"broken formula", plain_held, NULL, broken_formula_make, true},
    {"passing rises", plain, NULL, rising_passing_make, true},
    {"grams without a pan", held_pct_plain, NULL, no_pan_make, true},
    {"one sieve twice", plain, NULL, same_sieve_twice_make, true},
    {"a product alone", plain, NULL, product_alone_make, false},
    {"Hz for speeds", plain, NULL, hertz_make, true},
    {"kW for speeds", plain, NULL, power_make, true},
    {"years for speeds", plain, NULL, years_make, true},
    {"fractions for speeds", plain, NULL, fractions_make, true},
    {"t/h for speeds", plain, NULL, tonnes_make, true},
    {"speeds of no rotor", plain, NULL, too_fast_make, true},
    {"two feeds", plain, NULL, two_feeds_make, true},
    {"timesheet", plain, NULL, timesheet_make, true},
    {"price list", plain, NULL, prices_make, true},
    {"plant log", plain, NULL, plant_log_make, true},
    {"stock of sieves", plain, NULL, sieve_stock_make, true},
    {"envelope", plain, NULL, envelope_make, true},
    {"numbers only", plain, NULL, numbers_make, true},
    {"prose", plain, NULL, prose_make, true},
    {"odd numbers for speeds", plain, NULL, odd_numbers_make, true},
};

size_t
traps_count(void)
{
	return ARRAY_LEN(TRAPS);
}
