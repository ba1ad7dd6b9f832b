/* Plots of a session: which curves each kind has.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLOTS_H
#define TIPSPEED_CMD_PLOTS_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session.h"
#include "plot/draw.h"

enum plot_kind {
	PLOT_PSD,
	PLOT_PARITY,
	PLOT_CONVERGENCE,
	PLOT_SPREAD,
	PLOT_RESIDUALS,
	PLOT_SELECTION,
	PLOT_APPEARANCE,
	PLOT_MAP,
	PLOT_SWEEP,
	PLOT_PROFILE,
	PLOT_CORRELATION
};

/* In the order of the enum, a space between two. */
#define PLOT_KINDS                                                      \
	"psd parity convergence spread residuals selection appearance " \
	"map sweep profile correlation"

struct plot_request {
	enum plot_kind kind;
	double speed;       /* of psd, selection; NAN: the middle of the
			      * site's speeds */
	double other_speed; /* a second prediction beside the first, or NAN */
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
	size_t generation; /* psd, convergence, spread: as of this generation of
			    * the history (1..n); 0: the last */
	enum charset charset;
	unsigned words; /* of CHART_ALL: what to write around it.  Without
			 * CHART_NOTES the names of psd have no numbers that
			 * change with the speed */
	size_t n_speed; /* sweep: speeds [n_speed]; 0: answers_speeds */
	const double *speeds;
	const char *param; /* profile: of this parameter; NULL: e0_min */
	double feed_speed; /* psd, sweep: take the feed sampled at this speed;
			    * 0: the nearest one, of sweep to the middle */
};

/* Of that kind with nothing else asked for: NANs, ASCII, with a legend. */
struct plot_request plots_request(enum plot_kind kind);

/* The chart, or NULL with an error that says what is missing (no site, no
 * parameters, no history).  The caller frees with chart_free. */
struct chart *plots_chart(
    struct session *s, const struct plot_request *request, struct error *error);

/* The same drawn in exactly columns x rows.  The caller frees with
 * canvas_free. */
struct canvas *plots_draw(struct session *s, const struct plot_request *request,
    int columns, int rows, struct error *error);

/* What is known of the search: of the calibration under way, else of the site's
 * last one.  n is 0 where there is none.  Borrowed. */
struct plots_past {
	size_t n;
	const struct calibrate_generation *generation;
	const struct bounds *bounds;
};
struct plots_past plots_past(const struct session *s);

/* The parameters to draw with: of the generation asked for, the best so far of
 * a calibration under way, or the site's. */
bool plots_params(const struct session *s, const struct plot_request *request,
    struct params *params, struct error *error);

/* Measured products of so many speeds, those nearest to its own, has psd;
 * repeats look alike. */
enum { PLOTS_MEASURED = 3 };

/* The looks that several series of a chart take in turn; the first 23
 * differ without colour. */
struct chart_series plots_look(size_t i);

#endif
