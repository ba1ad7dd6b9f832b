/* Sheets as people make them: a known truth, written down with habits crossed
 * at random.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_HABITS_H
#define TIPSPEED_TESTS_HABITS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "made.h"

enum {
	MOST_SIEVES = 20,
	MOST_CURVES = 12,
	MOST_ROWS = 400,
	MOST_CELLS = 60,
	MOST_FILES = 8,
	MOST_HABITS = 128
};

/* What a column of a sieving counts. */
enum written {
	PASS_PCT,
	PASS_SHARE,
	HELD_G,
	HELD_PCT,
	HELD_SHARE,
	SUM_PCT,
	SUM_G,
	SUM_SHARE
};

enum shape {
	SHAPE_WIDE,   /* sieves down, a column a curve */
	SHAPE_ACROSS, /* the same, turned */
	SHAPE_LONG,   /* a row for each number */
	SHAPE_PAIRS,  /* a row for each speed and sieve, feed beside product */
	SHAPE_BESIDE, /* feed and products in tables of their own */
	SHAPE_BELOW,
	SHAPE_FILES, /* a file for each belt cut */
	/* a table for each sample, its name above it */
	SHAPE_EACH_BESIDE,
	SHAPE_EACH_BELOW,
	SHAPE_EACH_SHEET /* of a workbook */
};

enum heads {
	HEADS_ONE,
	HEADS_TWO,       /* role and speed above quantity and unit */
	HEADS_THREE,     /* role, merged; speed; quantity and unit */
	HEADS_SPEED_ROW, /* role and quantity above "tip speed (m/s)" */
	HEADS_UNIT_ROW,  /* units in a row of their own */
	HEADS_ABOVE,     /* role and speed above the sieves of one sample */
	HEADS_APART /* the row of speeds, another line, role and quantity */
};

enum speeds {
	SPEED_MPS,    /* Product 63.6 m/s */
	SPEED_AT,     /* product@63.6 */
	SPEED_BARE,   /* Product 63.6 */
	SPEED_ALONE,  /* 63.6 m/s */
	SPEED_BOTH,   /* 1350 rpm (63.6 m/s) */
	SPEED_SAMPLE, /* Prov 1 63,6 m/s */
	SPEED_RPM,    /* Product 1350 rpm; the rotor's diameter stands above */
	SPEED_FEET,   /* Product 12500 ft/min */
	SPEED_KMH,    /* Product 229 km/h */
	SPEED_BRACKETS, /* Product 1 (63.6 m/s) */
	SPEED_DATED     /* Product 2026-05-03 63.6 m/s */
};

enum sizes {
	SIZE_MM,
	SIZE_UM,
	SIZE_IN_CELL,    /* 4 mm */
	SIZE_UM_BELOW_1, /* 4 mm, 63 µm */
	SIZE_INCHES,
	SIZE_NAMES,   /* No. 4; BS 7 mesh */
	SIZE_NUMBERS, /* 8 below "Tyler mesh" */
	SIZE_BARE,    /* 22.4 below "Sieve" */
	SIZE_RANGES,  /* 16 - 22.4, of what is retained */
	SIZE_BELOW    /* <16, of what passes */
};

enum coding { UTF_8, UTF_8_BOM, CP_1252, UTF_16LE, UTF_16BE };

struct sieve {
	double mm;
	const char *name; /* "4" of No. 4; NULL: none below it has one */
};

struct series {
	const char *name; /* "", ASTM, BS or Tyler */
	size_t n;
	const struct sieve *sieve;
};

/* pct: as it follows from the numbers shown, which are rounded.  slack: points
 * that two right ways of reading them may differ by.  shown [n + 1]: the last
 * is the pan's.  left_out: a cell shown as empty or as a word; maybe: one that
 * may be read as missing as well as a number. */
struct curve {
	bool feed;
	double speed; /* m/s; 0: of all */
	double as_written;
	size_t n;
	const struct sieve *sieve[MOST_SIEVES];
	double mm[MOST_SIEVES];
	double pct[MOST_SIEVES];
	bool left_out[MOST_SIEVES + 1], maybe[MOST_SIEVES];
	double slack, mass, washed, loss;
	enum written quantity;
	double shown[MOST_SIEVES + 1];
	int decimals;
};

/* The words of a language for what stands on a sheet. */
struct tongue {
	const char *name;
	bool comma;
	const char *size[6], *feed[6], *product[6], *passing[4], *held[4],
	    *sum[3], *pan[3], *total[3], *unit[3];
	const char *sample, *speed, *rotor, *title, *site, *rock, *date,
	    *person, *remark, *low, *high, *dry, *after_wash, *loss, *fineness,
	    *lab, *share;
};
extern const struct tongue TONGUES[7];

struct sheets {
	size_t n_row;
	char *cell[MOST_ROWS][MOST_CELLS];
};

/* A sheet on its way: what its habits chose, the truth, the files. */
struct plan {
	uint64_t seed;
	struct draw draw;
	bool used[MOST_HABITS];
	const char *trap; /* NULL: none */
	/* what the habits choose */
	const struct tongue *tongue;
	enum shape shape;
	enum heads heads;
	enum speeds speeds;
	enum sizes sizes;
	enum coding coding;
	enum written quantity, feed_quantity;
	const struct series *series, *feed_series;
	char separator, decimal;
	const char *thousands, *line_end;
	bool upper, no_accents, quotes, padded, sep_line, caption, plain_heads,
	    title, blanks, header, remarks, finest_first, pan, total, loss,
	    washed, paired, percent_signs, fineness, row_numbers, two_sizes,
	    products_first, fast_first, size_last, limits, remark_column,
	    date_column, lab_column, person_row, date_row, repeats, individual,
	    feed_only, one_product, at_files, micro_greek, two_sites, whole_pct,
	    grams_whole, blank_column, apart, gram_signs, loose, broken_heads,
	    plain_speed, workbook, sample_corner, count_row, other_rows,
	    remark_row, lab_lines;
	int gaps; /* 0 none, 1 empty, 2 "-", 3 "n/a", 4 "<0.1" */
	int word; /* which of several words; they stay the same on a sheet */
	double rotor_mm;
	bool rotor_in_m;
	/* the truth */
	size_t n_curve;
	struct curve curve[MOST_CURVES];
	/* what was made of it */
	size_t n_file;
	struct made_file {
		char name[40];
		char *bytes; /* of a workbook: its cells, to be shown */
		size_t n;
		double at;      /* speed given on the command line; 0: none */
		size_t n_sheet; /* of a workbook; 0: a text */
		struct sheets *sheet[MOST_CURVES];
		char *title[MOST_CURVES];
	} file[MOST_FILES];
	size_t size_column; /* of the first table, from 1; 0: not known */
	size_t curve_column[MOST_CURVES];
	struct plan *other; /* the second of two sites */
};

/* A habit: how often, and what it changes; false where it does not go with
 * those before it. */
struct habit {
	const char *name;
	double often;
	bool (*take)(struct plan *plan);
};
extern const struct habit HABITS[];
size_t habits_count(void);

/* habits.c: a plan from a seed, with its files; trap: an index, or -1. */
struct plan *plan_new(uint64_t seed, int trap);
void plan_free(struct plan *plan);
char *plan_habits(const struct plan *plan);

/* habits_words.c */
const char *plan_word(
    const struct plan *plan, const char *const *words, size_t most);
char *plan_quantity(const struct plan *plan, enum written quantity);
const char *quantity_word(const struct plan *plan, enum written quantity);
const char *quantity_unit(const struct plan *plan, enum written quantity);
char *plan_upper(const struct plan *plan, const char *text);
char *plan_role(const struct plan *plan, bool feed);
char *plan_number(const struct plan *plan, double value, int decimals);
char *plan_short(const struct plan *plan, double value, int most);

/* habits_truth.c */
extern const struct series SERIES_EN, SERIES_EN_2, SERIES_ISO, SERIES_ASTM,
    SERIES_BS, SERIES_TYLER;
void truth_make(struct plan *plan);
void truth_show(struct curve *curve, enum written quantity, int decimals,
    bool loss, bool washed);

/* habits_grid.c */
void grid_put(struct sheets *grid, size_t row, size_t column, char *text);
struct sheets *grid_turned(const struct sheets *grid);
size_t grid_columns(const struct sheets *grid);
void grid_free(struct sheets *grid);
void grid_write(struct plan *plan, struct sheets *grid, const char *name);
void file_clear(struct made_file *file);

/* habits_book.c: adds a sheet to a workbook of the plan, and takes both; writes
 * a workbook. */
void sheets_add(struct plan *plan, struct sheets *grid, char *title, bool more);
void sheets_save(const struct made_file *file, const char *path);
void plan_text(struct plan *plan, const char *name, const char *text);

/* habits_head.c: the heads of a table's columns. */
enum column_kind {
	COLUMN_NUMBER,
	COLUMN_SIZE,
	COLUMN_SIZE_MM,
	COLUMN_CURVE,
	COLUMN_OTHER, /* the same curve in the other quantity */
	COLUMN_LOW,
	COLUMN_HIGH,
	COLUMN_REMARK,
	COLUMN_DATE,
	COLUMN_LAB,
	COLUMN_BLANK
};
struct column_plan {
	enum column_kind kind;
	size_t curve;
	struct curve other;
};
char *head_size(const struct plan *plan);
char *head_speed(const struct plan *plan, const struct curve *curve);
char *head_sample(const struct plan *plan, const struct curve *curve);
size_t head_rows(const struct plan *plan);
void head_put(const struct plan *plan, const struct column_plan *column,
    const struct column_plan *before, struct sheets *grid, size_t row,
    size_t at);

/* habits_sheet.c */
void sheet_make(struct plan *plan);
char *size_cell(const struct plan *plan, const struct curve *curve, size_t i);
char *value_cell(const struct plan *plan, const struct curve *curve, size_t i);

/* habits_traps.c */
struct trap {
	const char *name;
	void (*before)(struct plan *plan); /* after the habits */
	void (*truth)(struct plan *plan);  /* after the truth */
	void (*make)(struct plan *plan);   /* instead of sheet_make */
	bool nothing; /* no sieving: whatever is loaded is wrong */
};
extern const struct trap TRAPS[];
size_t traps_count(void);

static inline bool
chance(struct plan *plan, double p)
{
	return draw_between(&plan->draw, 0, 1) < p;
}

static inline size_t
pick(struct plan *plan, size_t n)
{
	return (size_t)draw_between(&plan->draw, 0, (double)n);
}

#endif
