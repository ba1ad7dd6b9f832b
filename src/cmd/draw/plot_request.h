/* What to plot: the kinds of plots, and their options.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOT_REQUEST_H
#define TIPSPEED_CMD_DRAW_PLOT_REQUEST_H

#include "cmd/ask/asked.h"
#include "cmd/session/session.h"
#include "plot/draw.h"

enum plot_kind {
	PLOT_PSD,
	PLOT_RUNS,
	PLOT_PARITY,
	PLOT_CONVERGENCE,
	PLOT_SPREAD,
	PLOT_RESIDUALS,
	PLOT_SELECTION,
	PLOT_APPEARANCE,
	PLOT_MAP,
	PLOT_SWEEP,
	PLOT_RESPONSE,
	PLOT_PROFILE,
	PLOT_CORRELATION,
	PLOT_DRIFT,
	PLOT_SEARCH,
	PLOT_ENERGY
};

/* In the order of the enum, separated by spaces. */
#define PLOT_KINDS                                                           \
	"psd runs parity convergence spread residuals selection appearance " \
	"map sweep response profile correlation drift search energy"

struct plot_request {
	enum plot_kind kind;
	const char *site;      /* the loaded site; NULL: the current one */
	struct question asked; /* the question.  entry NULL: the site as loaded;
				* speed NAN: for psd and selection the middle
				* speed of the site; at: for sweep the speeds,
				* or if none answers_list_few_round_speeds; for
				* runs the speeds besides the measured ones */
	const struct entry *second; /* the site `beside` with the feed and
				     * machine of the question; NULL: as
				     * loaded */
	double other_speed;         /* speed of a second prediction, or NAN */
	double other_feed;  /* psd: speed at which the feed of the second was
			     * sampled; 0: the feed of the first or, at another
			     * site, the mean */
	int strip;          /* psd: rows of the strip of differences; 0: no
			     * strip */
	const char *beside; /* psd: site of the second; NULL: the same site */
	const struct prediction *kept; /* psd: the second, if already made, for
					* the site `beside`; or NULL */
	const struct prediction *made; /* psd: the first, if already made; or
					* NULL */
	double crosshair_mm; /* psd: size of a vertical line with values, or
			      * NAN */
	double level;        /* psd: passing, %, for which the line's note gives
			      * the size of each curve */
	bool band;           /* psd: shade the band of the prediction */
	size_t generation;   /* show the search as of this generation (1..n); 0:
			      * its end */
	enum charset charset;
	unsigned words; /* bits of CHART_ALL: texts around the chart.  Without
			 * CHART_NOTES, the names of curves in psd contain no
			 * numbers that change with the speed */
	const char *param;       /* profile: the parameter; NULL: e0_min */
	const char *of, *limits; /* response: quantities and conditions in
				  * words, separated by commas; NULL: the usual
				  * quantities; no conditions */
};

/* Makes a chart, which the caller frees with chart_free, or returns NULL with
 * an error that says what is missing. */
typedef struct chart *plot_make(
    struct session *, const struct plot_request *, struct error *);

#endif
