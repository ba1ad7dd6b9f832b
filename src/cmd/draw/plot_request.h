/* What to plot: the kinds, and what may be asked of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOT_REQUEST_H
#define TIPSPEED_CMD_DRAW_PLOT_REQUEST_H

#include "cmd/session/session.h"
#include "core/psd/screening.h"
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

/* In the order of the enum, a space between two. */
#define PLOT_KINDS                                                           \
	"psd runs parity convergence spread residuals selection appearance " \
	"map sweep response profile correlation drift search energy"

struct plot_request {
	enum plot_kind kind;
	const char *site; /* of this loaded site; NULL: of the one in use */
	const struct entry *entry, /* it, as it is asked about, see question.h;
				    * NULL: as it is loaded */
	    *second;               /* the same of `beside` */
	double speed;              /* of psd, selection; NAN: the middle of the
			      * site's speeds */
	double other_speed; /* a second prediction beside the first, or NAN */
	double other_feed;  /* psd: the run whose feed it takes, as feed_speed;
			     * 0: that of the first, of another site the one
			     * nearest to its speed */
	int strip;          /* psd: rows of a strip of differences, 0: none */
	const char *beside; /* psd: the second is of this loaded site; NULL:
			      * of the same */
	const struct prediction *kept; /* psd: the second, made before, of the
					* site `beside`; NULL: it is made now */
	const struct prediction *made; /* psd: the first, made before; NULL: it
					* is made now */
	double crosshair_mm; /* psd: a vertical line with values; NAN: none */
	double level;        /* psd: passing whose sizes are reported with the
			      * line, % */
	bool band; /* psd: shade the uncertainty of the prediction, if there is
		    * one */
	size_t generation; /* psd, search, convergence, spread: as of this
			    * generation of the history (1..n); 0: the end */
	enum charset charset;
	unsigned words; /* of CHART_ALL: what to write around it.  Without
			 * CHART_NOTES the names of psd have no numbers that
			 * change with the speed */
	size_t n_speed; /* sweep: speeds [n_speed]; 0: answers_speeds.
			 * runs: those beside the measured ones */
	const double *speeds;
	const char *param;        /* profile: of this parameter; NULL: e0_min */
	const char *of, *limits;  /* response: quantities and conditions in
				  * words, with commas between; NULL: as
				  * usual, none */
	struct fraction fraction; /* psd, sweep, response: of the product; zeros
				   * of the whole */
	double feed_speed; /* psd, sweep: take the feed sampled at this speed;
			    * 0: the mean, or that of another sheet which
			    * entry has */
};

/* What draws a kind: the chart, which the caller frees with chart_free, or NULL
 * with an error that says what is missing. */
typedef struct chart *plot_make(
    struct session *, const struct plot_request *, struct error *);

#endif
