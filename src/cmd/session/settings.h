/* The settings.  Each has a row in SETTINGS, which describes it and says in
 * which member its value is kept; set, undo, save, reset and help use these
 * rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SETTINGS_H
#define TIPSPEED_CMD_SESSION_SETTINGS_H

#include "cmd/lang/command.h"
#include "core/answer/predict.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* Which runs correct the model in an answer (D13): all measured runs, the
 * training runs, or none. */
enum correction { CORRECTION_ALL, CORRECTION_TRAIN, CORRECTION_OFF };

/* The size of a text setting, and the text that stands for no value. */
enum { SETTINGS_TEXT = 4096 };
#define SETTINGS_NONE "none"

/* What is set rather than loaded: the settings, bounds, seed and timing. */
struct settings {
	struct model_settings model;
	/* The file that model.impacts are from, borrowed; NULL: a single
	 * impact. */
	const char *energy;
	struct bounds bounds;
	uint64_t seed;
	unsigned threads;
	enum correction correction;
	unsigned level;     /* of bands: 0: 80 %, 1: 90 % */
	double noise;       /* points, for a passing of 50 %; 0: not known */
	double speed_sd;    /* of stated tip speeds, %; 0: exact */
	unsigned draw_seed; /* of the draws behind answers and bands (D24) */
	enum answer_format format;
	unsigned semicolon; /* 1: in csv, with decimal commas */
	unsigned theme;     /* enum theme */
	double figure_mm;   /* width of plots in image files */
	unsigned unpaged;   /* 0: a prompt shows tall results in a pager */
	bool timing;        /* print how long each command took */
	/* The conditions on the product (goals.h), and the quantity that the
	 * full screen shows above its track.  "": none. */
	char goal[SETTINGS_TEXT], quantity[SETTINGS_TEXT];
	/* Ends of the range of speeds, m/s; 0: as given by
	 * site_default_speed_range. */
	double slider[2];
	char feed[SETTINGS_TEXT]; /* as in feed=: "mean" or another */
	unsigned page;            /* open page of the full screen */
};

/* Returns the settings of a new session. */
struct settings settings_default(void);

/* True if the settings, bounds, seed and timing are equal; ignores the look of
 * the full screen. */
bool settings_are_equal_but_for_looks(
    const struct settings *a, const struct settings *b);

/* Returns the probability of bands, 0..1. */
double settings_band_probability(const struct settings *set);

/* Computes the range of speeds, m/s, that commands use by default: as set, or
 * else that of site_default_speed_range.  site may be NULL. */
void settings_default_speed_range(const struct settings *set,
    const struct site *site, double *from, double *to);

/* Stores the value that `set` was given for a row. */
void settings_set_value(const struct command_option *row,
    const struct value *value, struct settings *set);

/* Returns the value of a row as one would type it after `set`.  The caller
 * frees it. */
char *settings_value_text(
    const struct command_option *row, const struct settings *set);

#endif
