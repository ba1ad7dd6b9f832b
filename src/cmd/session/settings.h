/* Settings.  A row of SETTINGS describes each and says where its value is kept;
 * set, undo, save, reset and help follow from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SETTINGS_H
#define TIPSPEED_CMD_SESSION_SETTINGS_H

#include "cmd/lang/command.h"
#include "core/answer/predict.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* Which runs inform an answer beside the parameters (D13): every measured one,
 * the training runs only, or none. */
enum correction { CORRECTION_ALL, CORRECTION_TRAIN, CORRECTION_OFF };

/* The size of the text of a setting, and the text that stands for none. */
enum { SETTINGS_TEXT = 200 };
#define SETTINGS_NONE "none"

/* The pages of the full screen, in the order of enum page in tui/acts.h. */
#define SETTINGS_PAGES "predict fit data parity sites"

/* Values that are set rather than loaded: by bounds, seed, timing and the
 * SETTINGS. */
struct choices {
	struct model_settings model;
	const char *energy; /* file that model.impacts are from, borrowed; NULL:
			       a single impact */
	struct bounds bounds;
	uint64_t seed;
	unsigned threads;
	enum correction correction;
	unsigned level;     /* of bands: 0 80 %, 1 90 % */
	double noise;       /* points, of a passing at 50 %; 0: not known */
	unsigned draw_seed; /* of the draws behind answers and bands */
	enum answer_format format;
	unsigned semicolon; /* 1: in csv, with decimal commas */
	unsigned theme;     /* enum theme */
	unsigned unpaged;   /* 0: at a prompt, what is taller than the screen is
			       paged */
	bool timing;        /* print how long each command took */
	/* The conditions on the product, see goals.h; and the quantity that the
	 * full screen shows above its track.  "": none. */
	char goal[SETTINGS_TEXT], quantity[SETTINGS_TEXT];
	/* Ends of the range of speeds, m/s; 0: as given by site_reach. */
	double slider[2];
	char
	    feed[SETTINGS_TEXT]; /* of answers, as in feed=: "mean" or others */
	unsigned page;           /* of the full screen that is open */
};

/* Returns the choices of a new session. */
struct choices settings_default(void);

/* True if the choices are equal, bounds, seed and timing included; the looks of
 * the full screen are not compared. */
bool settings_same(const struct choices *a, const struct choices *b);

/* Returns the probability of bands, 0..1. */
double settings_level(const struct choices *set);

/* Range of speeds, m/s, that commands cover unless told otherwise: as set, else
 * as given by site_reach.  site: or NULL. */
void settings_reach(const struct choices *set, const struct site *site,
    double *from, double *to);

/* Stores a value given to `set`. */
void settings_put(const struct command_option *row, const struct value *value,
    struct choices *set);

/* Returns the value as it would be typed after `set`; the caller frees. */
char *settings_text(
    const struct command_option *row, const struct choices *set);

#endif
