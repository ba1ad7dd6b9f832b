/* The steps, and what each waits for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/tour.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "tui/widgets/file_picker.h"
#include "tui/control.h"
#include "tui/screen.h"

static bool
has_read(const struct tui *t)
{
	return t->cross;
}

/* Not by what loaded the site: the slider then moved, and was predicted at. */
static bool
has_moved(const struct tui *t)
{
	return t->now.site[0] != '\0' && t->tour_tenths != t->tenths;
}

static double
found(const struct tui *t)
{
	return session_known(t->session, "find", "speed");
}

/* Not by what was found or fitted before the step began: the slider had to be
 * moved for that. */
static bool
has_found(const struct tui *t)
{
	bool fits =
	    t->command != NULL && strncmp(t->command, "calibrate", 9) == 0;
	return (fits && !session_busy(t->session)) ||
	       (isfinite(found(t)) && !(found(t) == t->tour_found));
}

static const struct {
	const char *text;
	bool (*done)(const struct tui *t);
} STEPS[] = {
    {N_("The curve is the product predicted at the speed below: how much of it "
	"passes each sieve. Marks are measured runs, the faint line is the "
	"feed. "
	"Press c to read the curves at a sieve."),
	has_read},
    {N_("Move the speed: Tab goes back to it, then Left and Right, or drag "
	"along "
	"the track. Watch the curve, and P80. An x marks speeds beyond the "
	"training speeds."),
	has_moved},
    {N_("Fit and goal: f fits the model to the measured runs; or type :find "
	"p80=5.4 to go to the speed for a P80 of 5.4 mm."),
	has_found}};

void
tour_begin(struct tui *t)
{
	if (tui_entry(t) == NULL) {
		if (!chooser_open_shipped(t, "tierp.csv") ||
		    !control_run(t, "recall table3/tierp"))
			return;
	}
	t->page = PAGE_PREDICT;
	tui_untouch(t);
	t->cross = false;
	t->focus = NULL;
	t->tour = 1;
	t->message[0] = '\0';
}

void
tour_update(struct tui *t)
{
	if (t->tour == 0)
		return;
	if (t->tour > ARRAY_LEN(STEPS) || tui_entry(t) == NULL) {
		t->tour = 0;
		return;
	}
	if (!STEPS[t->tour - 1].done(t))
		return;
	t->tour_tenths = t->tenths;
	t->tour_found = found(t);
	if (t->tour++ == ARRAY_LEN(STEPS)) {
		t->tour = 0;
		tui_say(t, false, "that was the tour: ? lists all keys");
	}
}

static char *
text_of(const struct tui *t)
{
	return xasprintf(tr("%zu of %zu  %s"), t->tour, ARRAY_LEN(STEPS),
	    tr(STEPS[t->tour - 1].text));
}

/* A rule with how to leave it, and the text. */
int
tour_rows(const struct tui *t, int rows, int columns)
{
	enum { MOST_SHARE = 3, LEAST = 9 };
	if (t->tour == 0 || rows < LEAST)
		return 0;
	char *text = text_of(t);
	int n = 1 + text_rows(text, columns);
	free(text);
	return n < rows / MOST_SHARE ? n : rows / MOST_SHARE;
}

void
tour_draw(const struct tui *t, const struct area *area)
{
	struct area rest = *area;
	char *text = text_of(t);
	screen_rule(&(struct area){area->row, area->column, 1, area->columns});
	screen_text(area, 0, 2, LOOK_BOLD, " tour: Esc leaves it ");
	rest.row++;
	rest.rows--;
	screen_words(&rest, 0, LOOK_BOLD, text);
	free(text);
}
