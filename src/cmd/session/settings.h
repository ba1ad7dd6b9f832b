/* Settings: each has a row in SETTINGS, which describes it and where its value
 * is kept; set, undo, save, reset and help use these rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SETTINGS_H
#define TIPSPEED_CMD_SESSION_SETTINGS_H

#include "cmd/lang/command.h"
#include "core/answer/predict.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* The runs that inform an answer in addition to the parameters (D13): all
 * measured runs, the training runs, or none. */
enum correction { CORRECTION_ALL, CORRECTION_TRAIN, CORRECTION_OFF };

/* The size of a setting's text, and the text that means no value. */
enum { SETTINGS_TEXT = 200 };
#define SETTINGS_NONE "none"

/* Values that are set rather than loaded: by bounds, seed, timing and the
 * SETTINGS. */
struct settings {
	struct model_settings model;
	const char *energy; /* source file of model.impacts, borrowed; NULL: a
single impact */
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
	unsigned unpaged;   /* 0: a prompt shows tall results in a pager */
	bool timing;        /* print how long each command took */
	/* The conditions on the product (goals.h), and the quantity that the
	 * full screen shows above its track.  "": none. */
	char goal[SETTINGS_TEXT], quantity[SETTINGS_TEXT];
	/* Ends of the range of speeds, m/s; 0: as given by
	 * site_default_speed_range. */
	double slider[2];
	char feed[SETTINGS_TEXT]; /* for answers, as in feed=: "mean" or
				  * another */
	unsigned page;            /* open page of the full screen */
};

/* Returns the choices of a new session. */
struct settings settings_default(void);

/* True if the choices are equal, including bounds, seed and timing but not the
 * appearance of the full screen. */
bool settings_are_equal(const struct settings *a, const struct settings *b);

/* Returns the probability of bands, 0..1. */
double settings_band_probability(const struct settings *set);

/* Computes the default range of speeds, m/s, of commands: as set, else from
 * site_default_speed_range.  site may be NULL. */
void settings_default_speed_range(const struct settings *set,
    const struct site *site, double *from, double *to);

/* Stores a value given to `set`. */
void settings_set_value(const struct command_option *row,
    const struct value *value, struct settings *set);

/* Returns the value as typed after `set`.  The caller frees it. */
char *settings_value_text(
    const struct command_option *row, const struct settings *set);

#endif
