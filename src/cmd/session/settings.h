/* Settings: what is said of each and where it is kept is a row of SETTINGS;
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

/* The longest text of one, and that for none. */
enum { SETTINGS_TEXT = 200 };
#define SETTINGS_NONE "none"

/* The pages of the full screen, as enum page of tui/keys.h has them. */
#define SETTINGS_PAGES "predict fit data parity sites"

/* What is set, as against loaded: by bounds, seed, timing and the SETTINGS. */
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
	/* What is wanted of the product, see goals.h; and the quantity that the
	 * full screen has above its track.  "": none. */
	char goal[SETTINGS_TEXT], quantity[SETTINGS_TEXT];
	/* m/s, the ends of what is looked at; 0: as site_reach has it. */
	double slider[2];
	char
	    feed[SETTINGS_TEXT]; /* of answers, as of feed=: "mean" or others */
	unsigned page;           /* of the full screen that is open */
};

/* What is set in a session that has just begun. */
struct choices settings_default(void);

/* Bounds, seed and timing are compared too, but not how the full screen
 * looks. */
bool settings_same(const struct choices *a, const struct choices *b);

/* The probability of bands, 0..1. */
double settings_level(const struct choices *set);

/* The speeds, m/s, that are looked at unless told otherwise: as set, else those
 * of site_reach.  site: or NULL. */
void settings_reach(const struct choices *set, const struct site *site,
    double *from, double *to);

/* Keeps a value that `set` was given. */
void settings_put(
    const struct setting *row, const struct value *value, struct choices *set);

/* The value as `set` would be given it; the caller frees. */
char *settings_text(const struct setting *row, const struct choices *set);

#endif
