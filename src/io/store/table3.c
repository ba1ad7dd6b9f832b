/* data/table3.csv and files like it.  Cells and their places are sheet's.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/table3.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "io/cells/sheet.h"
#include "io/cells/number.h"
#include "io/cells/textfile.h"
#include "io/sitefile/units.h"

/* Made from data/table3.csv at build time: its rows without the remarks. */
extern const char *const TABLE3_TEXT[];

enum { CELLS = 7, MOST_ROWS = 1000 };

/* False where the row shows that the file is of another kind. */
static bool
read_row(struct sheet *sheet, const struct row *row, struct materials *m)
{
	struct material one = {0};
	const struct {
		double *number, most;
	} column[CELLS] = {[2] = {&one.top_size_mm, SIZE_MOST_MM},
	    [3] = {&one.f_mat, F_MAT_MOST},
	    [5] = {&one.e0_min, E0_MIN_MOST},
	    [6] = {&one.alpha, ALPHA_MOST}};
	if (row->n != CELLS)
		return sheet_fault(sheet, row->cell[0],
		    "expected %d cells, got %zu\n"
		    "use the columns of data/table3.csv; read a site file with "
		    "load",
		    (int)CELLS, row->n);
	for (size_t i = 0; i < CELLS; i++) {
		double *number = column[i].number;
		if (number == NULL)
			continue;
		char *wanted = xasprintf(
		    tr("a number above 0, up to %g,"), column[i].most);
		if (number_read(sheet, row->cell[i], wanted, number) &&
		    !(*number > 0 && *number <= column[i].most))
			sheet_wanted(sheet, row->cell[i], wanted, NULL);
		free(wanted);
	}
	one.rock = xstrdup(row->cell[0].text);
	one.site = xstrdup(row->cell[1].text);
	one.feed_source = xstrdup(row->cell[4].text);
	one.individual_feeds = strncmp(one.feed_source, "Default", 7) != 0;
	m->row = xrealloc(m->row, m->n + 1, sizeof *m->row);
	m->row[m->n++] = one;
	return true;
}

/* text is taken apart and freed; NULL after a fault, which is reported. */
static struct materials *
take_text(const char *path, char *text, struct error_list *errors)
{
	if (text == NULL)
		return NULL;
	const struct sheet_limits most = {.rows = MOST_ROWS};
	struct sheet *sheet = sheet_new(path, text, most, errors);
	number_decide(sheet);
	struct materials *m = xcalloc(1, sizeof *m);
	size_t i = 1; /* after the heading */
	while (i < sheet->n_row && read_row(sheet, &sheet->row[i], m))
		i++;
	if (m->n == 0 && sheet->n_fault == 0)
		sheet_fault(
		    sheet, (struct cell){0}, "no rows of materials found");
	if (sheet->n_fault > 0) {
		materials_free(m);
		m = NULL;
	}
	sheet_free(sheet);
	free(text);
	return m;
}

struct materials *
materials_read(const char *path, struct error_list *errors)
{
	return take_text(path, textfile_read(path, errors), errors);
}

struct materials *
materials_table3(void)
{
	struct error_list none = {0};
	struct materials *m =
	    take_text("Table 3", textfile_lines(TABLE3_TEXT), &none);
	/* It is part of the program: the tests read all of it. */
	assert(m != NULL);
	return m;
}

struct params
materials_params(const struct material *row)
{
	struct params p = params_start(0);
	p.f_mat = row->f_mat;
	p.e0_min = row->e0_min;
	p.alpha = row->alpha;
	return p;
}

void
materials_free(struct materials *m)
{
	if (m == NULL)
		return;
	for (size_t i = 0; i < m->n; i++) {
		free(m->row[i].rock);
		free(m->row[i].site);
		free(m->row[i].feed_source);
	}
	free(m->row);
	free(m);
}
