/* Computes and draws the slider, without a terminal or a session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/slider.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/tr.h"
#include "core/model/breakage.h"
#include "core/psd/rotor_speed.h"

struct slider_range
slider_range(double from, double to, double rotor)
{
	if (!(rotor > 0))
		return (struct slider_range){10 * (int)from, 10 * (int)to, 0};
	return (struct slider_range){
	    (int)lround(rotor_speed_to_rpm(from, rotor)),
	    (int)lround(rotor_speed_to_rpm(to, rotor)), rotor};
}

int
slider_clamped_position(struct slider_range range, int position)
{
	return position < range.least  ? range.least
	       : position > range.most ? range.most
				       : position;
}

int
slider_position_of_speed(struct slider_range range, double speed)
{
	return slider_clamped_position(range,
	    (int)lround(range.rotor > 0 ? rotor_speed_to_rpm(speed, range.rotor)
					: 10 * speed));
}

double
slider_speed_of_position(struct slider_range range, double position)
{
	return range.rotor > 0 ? rotor_speed_from_rpm(position, range.rotor)
			       : position / 10;
}

bool
slider_has_speed(struct slider_range range, double speed)
{
	return speed >= slider_speed_of_position(range, range.least) &&
	       speed <= slider_speed_of_position(range, range.most);
}

int
slider_column_of_position(struct slider_range range, int position, int width)
{
	double share =
	    (double)(slider_clamped_position(range, position) - range.least) /
	    (range.most - range.least);
	return width > 1 ? (int)lround(share * (width - 1)) : 0;
}

int
slider_position_at_column(struct slider_range range, int column, int width)
{
	if (width < 2)
		return range.least;
	double share = (double)column / (width - 1);
	return slider_clamped_position(range,
	    range.least + (int)lround(share * (range.most - range.least)));
}

static bool
is_beyond_trained_speeds(int position, const struct slider_mark *mark, size_t n)
{
	bool below = false, above = false;
	for (size_t i = 0; i < n; i++) {
		below =
		    below || (mark[i].trained && mark[i].position <= position);
		above =
		    above || (mark[i].trained && mark[i].position >= position);
	}
	return !below || !above;
}

static bool
are_slider_cells_free(
    const struct slider_cell *cell, int width, int from, int wanted)
{
	for (int c = from; c < from + wanted; c++)
		if (c < 0 || c >= width || cell[c].taken)
			return false;
	return true;
}

static void
write_text_in_slider_cells(struct slider_cell *cell, const char *text)
{
	for (; *text != '\0'; text++)
		*cell++ = (struct slider_cell){*text, true, true};
}

/* Writes the label of a mark, "69" or, with words, "69 m/s 2381 J/kg".  Returns
 * its length. */
static int
slider_mark_label_text(struct slider_range range,
    const struct slider_mark *mark, bool words, char label[static 32])
{
	double v = slider_speed_of_position(range, mark->position);
	if (range.rotor > 0)
		return words ? snprintf(label, 32, tr("%d rpm %.0f J/kg"),
				   mark->position, specific_energy_at_speed(v))
			     : snprintf(label, 32, "%d", mark->position);
	return words ? snprintf(label, 32, "%g m/s %.0f J/kg", v,
			   specific_energy_at_speed(v))
		     : snprintf(label, 32, "%g", v);
}

/* Returns true if the track has room for labels with units and for some track
 * between them. */
static bool
has_room_for_long_labels(const struct slider_cell *cell, int width,
    struct slider_range range, const struct slider_mark *mark, size_t n)
{
	enum { BETWEEN = 5 };
	char label[32];
	for (size_t i = 0; i < n; i++) {
		int from =
		    slider_column_of_position(range, mark[i].position, width) +
		    1;
		int length =
		    slider_mark_label_text(range, &mark[i], true, label);
		if (!are_slider_cells_free(cell, width, from, length + BETWEEN))
			return false;
	}
	return true;
}

/* Writes the speed after a mark, if there is room.  handle: the cell after the
 * handle of the slider. */
static void
write_slider_mark_label(struct slider_cell *cell, int width,
    struct slider_range range, const struct slider_mark *mark, bool words,
    int handle)
{
	char label[32];
	int from = slider_column_of_position(range, mark->position, width) + 1;
	int wanted = slider_mark_label_text(range, mark, words, label);
	if (words && !are_slider_cells_free(cell, width, from, wanted + 1))
		wanted = slider_mark_label_text(range, mark, false, label);
	if (from == handle ||
	    !are_slider_cells_free(cell, width, from, wanted + 1))
		return;
	write_text_in_slider_cells(cell + from, label);
	/* A space, because dashes right after a label would be hard to read. */
	if (cell[from + wanted].sign == 'x')
		write_text_in_slider_cells(cell + from + wanted, " ");
}

/* Writes a word in the middle of each part beyond the training speeds. */
static void
write_word_beyond_training(
    struct slider_cell *cell, int width, const char *word)
{
	int n = (int)strlen(word);
	for (int from = 0, to; from < width; from = to + 1) {
		for (to = from; to < width && cell[to].sign == 'x'; to++)
			;
		int at = from + (to - from - n) / 2;
		if (n == 0 || to - from < n + 4 ||
		    !are_slider_cells_free(cell, width, at - 1, n + 2))
			continue;
		write_text_in_slider_cells(cell + at - 1, " ");
		write_text_in_slider_cells(cell + at, word);
		write_text_in_slider_cells(cell + at + n, " ");
	}
}

int
slider_fill_cells(struct slider_cell *cell, int width,
    struct slider_range range, int position, const struct slider_mark *mark,
    size_t n, const bool *kept, const char *beyond)
{
	char label[16];
	bool any = false;
	for (int c = 0; c < width; c++) {
		bool outside = is_beyond_trained_speeds(
		    slider_position_at_column(range, c, width), mark, n);
		cell[c] = (struct slider_cell){
		    outside ? 'x' : '-', kept != NULL && kept[c], false};
		any = any || cell[c].taken;
	}
	if (width < 1)
		return 0;
	for (size_t i = 0; i < n; i++)
		cell[slider_column_of_position(
		    range, mark[i].position, width)] = (struct slider_cell){
		    mark[i].trained ? '|' : 'o', true, false};
	int length = range.rotor > 0
			 ? snprintf(label, sizeof label, "[%d]", position)
			 : snprintf(label, sizeof label, "[%.1f]",
			       slider_speed_of_position(range, position));
	if (length > width)
		length = snprintf(label, sizeof label, "#");
	int at = slider_column_of_position(range, position, width) - length / 2;
	at = at < 0 ? 0 : at > width - length ? width - length : at;
	bool words =
	    !any && has_room_for_long_labels(cell, width, range, mark, n);
	for (int c = at; c < at + length; c++)
		cell[c].taken = true;
	for (size_t i = 0; i < n; i++)
		write_slider_mark_label(
		    cell, width, range, &mark[i], words, at + length);
	write_word_beyond_training(cell, width, beyond);
	write_text_in_slider_cells(cell + at, label);
	return at;
}
