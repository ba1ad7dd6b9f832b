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
	struct question asked; /* entry NULL: the site as loaded; speed, for
				* psd and selection, NAN: the middle of the
				* site's; at: for sweep, none:
				* answers_list_few_round_speeds; for runs,
				* besides the measured ones */
	const struct entry *second; /* the site `beside` as in the question;
				     * NULL: as loaded */
	double other_speed;         /* of a second prediction, or NAN */
	double other_feed;  /* psd: speed at which the feed of the second was
			    * sampled; 0: the feed of the first or, at
			    * another site, that nearest to its speed */
	int strip;          /* psd: rows of a strip of differences, 0: none */
	const char *beside; /* psd: loaded site of the second; NULL: the same
			      * site */
	const struct prediction *kept; /* psd: the second, if already made, for
					* the site `beside`; or NULL */
	const struct prediction *made; /* psd: the first, if already made; or
					* NULL */
	double crosshair_mm; /* psd: a vertical line with values; NAN: none */
	double level;        /* psd: passing, %, whose sizes are reported with
			      * the line */
	bool band;           /* psd: shade the band of the prediction, if any */
	size_t generation;   /* psd, search, convergence, spread: state at this
			    * generation of the history (1..n); 0: the end */
	enum charset charset;
	unsigned words; /* bits of CHART_ALL: texts around the chart.  Without
			 * CHART_NOTES, the names in psd contain no numbers that
			 * change with the speed */
	const char *param;       /* profile: the parameter; NULL: e0_min */
	const char *of, *limits; /* response: quantities and conditions in
				  * words, separated by commas; NULL: the usual;
				  * none */
};

/* Makes a chart, which the caller frees with chart_free.  Returns NULL with an
 * error that says what is missing. */
typedef struct chart *plot_make(
    struct session *, const struct plot_request *, struct error *);

#endif
