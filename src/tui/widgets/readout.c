/* Reads the passing of each curve at the crosshair, and the size at the
 * crosshair's passing from the finer curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/readout.h"

#include <math.h>
#include <stdio.h>

#include "base/tr.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/pin.h"
#include "io/sitefile/units.h"
#include "tui/pane.h"
#include "tui/screen.h"

const char *
readout_size_or_reason_text(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, tr("off sieves"));
	else if (isinf(mm))
		snprintf(text, 24, tr("none"));
	else if (mm < 1000 * ANSWERS_NO_SIZE)
		snprintf(text, 24, tr("all"));
	else
		snprintf(text, 24, "%.2f mm", mm);
	return text;
}

/* Draws a row: the passing of a curve at the crosshair's sieve, and its size at
 * the crosshair's passing, read off `finer`. */
static void
draw_curve_at_crosshair(const struct tui *t, const struct area *area, int row,
    unsigned look, const char *name, const struct psd *psd,
    const struct psd *finer)
{
	double x = t->view.shown.product.size[t->ui.crosshair_sieve];
	char size[24] = "-";
	double mm =
	    1000 * psd_size_at_passing(finer, t->ui.crosshair_passing / 100.0);
	if (isfinite(mm))
		readout_size_or_reason_text(mm, size);
	struct area left = area_of_columns_in_row(area, row, 0, 8);
	screen_draw_clipped_text(&left, 0, 0, SERIES_TEXT, look, name);
	if (psd_covers_size(psd, x))
		screen_draw_text(
		    area, row, 8, look, "%5.1f %%", 100 * psd_passing(psd, x));
	screen_draw_text(area, row, 15, look, "%9s", size);
}

/* Draws the band of the passing and, if there is a row for it, that of the
 * size. */
static void
readout_draw_band(const struct tui *t, const struct area *area, int row)
{
	const struct prediction *p = &t->view.shown;
	if (!t->ui.band || p->low == NULL)
		return;
	screen_draw_text(area, row++, 0, 0, "band %5.1f .. %.1f %%",
	    100 * p->low[t->ui.crosshair_sieve],
	    100 * p->high[t->ui.crosshair_sieve]);
	const struct quantity size = {
	    .kind = QUANTITY_SIZE, .x = t->ui.crosshair_passing / 100.0};
	const struct question q = question_of_whole_product(
	    t->session, tui_site_entry_for_prediction(t), p->feed_run);
	struct forecast *f = forecast_open(t->session, &q, &size, 1);
	forecast_set_speed(f, p->speed);
	struct figure at = forecast_value_with_band(f, 0);
	if (row < area->rows && isfinite(at.low) && isfinite(at.high))
		screen_draw_text(area, row, 0, 0, "     %5.2f .. %.2f mm",
		    1000 * at.low, 1000 * at.high);
	forecast_close(f);
}

int
readout_count_rows(const struct tui *t)
{
	enum { OTHERS = 3, BAND = 2 };
	if (!t->ui.crosshair ||
	    t->ui.crosshair_sieve >= t->view.shown.product.n)
		return 0;
	const struct site *site = tui_current_site_entry(t)->site;
	return OTHERS +
	       (tui_other_feed(t)[0] == '\0' ? (int)site_count_products(site)
					     : 0) +
	       (t->ui.band && t->view.shown.low != NULL ? BAND : 0) +
	       (t->view.pinned.site[0] != '\0');
}

void
readout_draw_at_crosshair(struct tui *t, const struct area *area)
{
	const struct prediction *p = &t->view.shown;
	const struct site *site = tui_current_site_entry(t)->site;
	bool pin = t->view.pinned.site[0] != '\0';
	char name[40];
	int row = 0, others = 1 + (t->ui.band && p->low != NULL) + pin;
	enum { ABOVE = 2 };
	int room = area->rows - ABOVE - others;
	snprintf(name, sizeof name, tr("crosshair %g mm"),
	    units_m_to_mm(p->product.size[t->ui.crosshair_sieve]));
	screen_draw_text(area, row++, 0, LOOK_BOLD, "%-18s%4d %%", name,
	    t->ui.crosshair_passing);
	draw_curve_at_crosshair(
	    t, area, row++, 0, tr("feed"), &p->feed, &p->feed);
	for (size_t r = 0; r < site->n_run && tui_other_feed(t)[0] == '\0';
	     r++) {
		const struct run *run = &site->run[r];
		if (row + others >= area->rows ||
		    !site_run_is_among_nearest(site, r, p->speed, (size_t)room))
			continue;
		snprintf(name, sizeof name, tr("meas %g%s"), run->speed,
		    run->repeat);
		draw_curve_at_crosshair(t, area, row++, 0, name,
		    tui_product_adjusted_to_feed(t, r),
		    tui_product_adjusted_to_feed(t, r));
	}
	draw_curve_at_crosshair(
	    t, area, row++, LOOK_BOLD, tr("PRED"), &p->product, &p->curve);
	if (pin)
		draw_curve_at_crosshair(t, area, row++, 0, tr("pinned"),
		    &t->session->pin->p.product, &t->session->pin->p.curve);
	readout_draw_band(t, area, row);
}
