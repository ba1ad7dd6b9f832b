/* Plots of a session: what all kinds share, and which function makes each.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/plots.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"

const struct chart_series PLOTS_FEED = {
    .series = SERIES_FEED, .line = CHART_DOTTED, .ascii = '.'};
const struct chart_series PLOTS_CURVE = {
    .series = SERIES_PREDICTED, .line = CHART_SOLID, .ascii = '#'};

struct plot_request
plots_request(enum plot_kind kind)
{
	return (struct plot_request){.kind = kind,
	    .speed = NAN,
	    .other_speed = NAN,
	    .crosshair_mm = NAN,
	    .level = 50,
	    .charset = CHARSET_ASCII,
	    .words = CHART_ALL};
}

static bool
is_running(const struct session *s)
{
	return s->job.calibration != NULL && s->job.entry == s->current;
}

struct plots_past
plots_past(const struct session *s)
{
	struct plots_past past = {0};
	const struct history *h = s->entry[s->current].history;
	if (is_running(s)) {
		past.generation =
		    calibration_history(s->job.calibration, &past.n);
		past.bounds = calibration_bounds(s->job.calibration);
	} else if (h != NULL) {
		past = (struct plots_past){h->n, h->generation, &h->bounds};
	}
	return past;
}

size_t
plots_generation(const struct session *s, const struct plot_request *request,
    const struct plots_past *past, struct error *error)
{
	if (past->n == 0) {
		error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    s->entry[s->current].site->name);
		return past->n;
	}
	if (request->generation <= past->n)
		return request->generation > 0 ? request->generation - 1
					       : past->n - 1;
	error_set(error, ERROR_USAGE, "there is no generation %zu, only %zu",
	    request->generation, past->n);
	return past->n;
}

bool
plots_params(const struct session *s, const struct plot_request *request,
    struct params *params, struct error *error)
{
	const struct entry *entry = &s->entry[s->current];
	struct plots_past past = plots_past(s);
	bool search = request->generation > 0 || is_running(s);
	if (search && past.n > 0) {
		size_t i = plots_generation(s, request, &past, error);
		if (i == past.n)
			return false;
		*params = request->generation > 0
			      ? past.generation[i].params
			      : calibration_status(s->job.calibration).params;
		return true;
	}
	if (!answers_known(s, entry, error))
		return false;
	*params = entry->params;
	return true;
}

struct chart *
plots_site_chart(const struct site *site, struct axis x, struct axis y,
    const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *words = xvasprintf(format, ap), *label = session_label(site);
	va_end(ap);
	char *title = xasprintf("%s: %s", label, words);
	char *about = site_source(site, "provenance not stated");
	struct chart *c = chart_new(title, about, x, y);
	free(about);
	free(words);
	free(title);
	free(label);
	return c;
}

struct chart_series
plots_look(size_t i)
{
	static const char MARKS[] = "v^ox*+@&$%szNHKTUYAEMRW", ASCII[] = "=-~";
	enum { COLOURS = 3 };
	return (struct chart_series){
	    .series = (enum series)(SERIES_MEASURED_1 + i % COLOURS),
	    .line = CHART_SOLID,
	    .ascii = ASCII[i % COLOURS],
	    .mark = MARKS[i % (sizeof MARKS - 1)]};
}

struct chart *
plots_chart(
    struct session *s, const struct plot_request *request, struct error *error)
{
	static const struct {
		plots_maker *make;
		bool any_site;
	} KINDS[] = {[PLOT_PSD] = {plots_psd, false},
	    [PLOT_PARITY] = {plots_parity, false},
	    [PLOT_CONVERGENCE] = {plots_convergence, false},
	    [PLOT_SPREAD] = {plots_spread, false},
	    [PLOT_RESIDUALS] = {plots_residuals, false},
	    [PLOT_SELECTION] = {plots_selection, false},
	    [PLOT_APPEARANCE] = {plots_appearance, false},
	    [PLOT_MAP] = {plots_map, true},
	    [PLOT_SWEEP] = {plots_sweep, false}};
	if (!KINDS[request->kind].any_site &&
	    !session_need_site(s, "this plot", error))
		return NULL;
	return KINDS[request->kind].make(s, request, error);
}

struct canvas *
plots_draw(struct session *s, const struct plot_request *request, int columns,
    int rows, struct error *error)
{
	struct chart *chart = plots_chart(s, request, error);
	if (chart == NULL)
		return NULL;
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, request->charset, request->words);
	chart_free(chart);
	return canvas;
}
