/* Rows of the Sites page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/rows.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"

/* The P50 at a speed: of the site in use as on its page, of the others on the
 * feed that serves for all speeds. */
static void
row_at(struct site_row *row, const struct tui *t, const struct entry *e)
{
	const struct session *s = t->session;
	double speed = t->tenths / 10.0;
	struct error error = {0};
	*row = (struct site_row){.p50 = NAN, .holdout = row->holdout};
	if (!answers_known(s, e, &error))
		return;
	size_t feed = e == tui_entry(t)
			  ? tui_feed(t)
			  : site_run_nearest(e->site, answers_middle(e->site));
	struct prediction p = answers_predict(s, e, speed, feed);
	row->p50 = 1000 * p.p50;
	row->beyond = answers_extrapolates(e, speed);
	prediction_free(&p);
}

void
rows_update(struct tui *t)
{
	const struct session *s = t->session;
	if (t->page != PAGE_SITES || t->rows_at == t->tenths)
		return;
	if (t->rows_at == 0) {
		free(t->row);
		t->n_row = s->n_entry;
		t->row = xcalloc(t->n_row + 1, sizeof *t->row);
		for (size_t i = 0; i < t->n_row; i++)
			t->row[i].holdout =
			    s->entry[i].has_fit
				? 100 * fit_holdout_rmse(&s->entry[i])
				: NAN;
	}
	for (size_t i = 0; i < t->n_row; i++)
		row_at(&t->row[i], t, &s->entry[i]);
	t->rows_at = t->tenths;
}
