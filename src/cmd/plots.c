/* Pictures of a session: curves in ASCII.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/plots.h"

#include <math.h>

static void
draw_psd(struct canvas *c, const struct psd *psd, char mark, enum series series)
{
	for (size_t i = 0; i < psd->n; i++) {
		double at = log(psd->size[i] / 63e-6) / log(22.4 / 0.063);
		int column = (int)lround(at * (c->columns - 1));
		int row = (int)lround((1 - psd->passing[i]) * (c->rows - 1));
		char text[2] = {mark, '\0'};
		canvas_text(c, column, row, text, series, 0);
	}
}

struct canvas *
plots_draw(struct session *s, const struct plot_request *request, int columns,
    int rows, struct error *error)
{
	static const char marks[] = "v^o";
	if (s->n_entry == 0) {
		error_set(error, ERROR_USAGE, "no site is loaded");
		return NULL;
	}
	const struct site *site = session_entry(s)->site;
	struct canvas *c = canvas_new(columns, rows);
	draw_psd(c, &site->run[0].feed, '.', SERIES_FEED);
	for (size_t r = 0; r < site->n_run; r++)
		draw_psd(c, &site->run[r].product, marks[r % 3],
		    (enum series)(SERIES_MEASURED_1 + r % 3));
	if (request->kind == PLOT_PSD)
		draw_psd(c, &s->last.product, '#', SERIES_PREDICTED);
	return c;
}
