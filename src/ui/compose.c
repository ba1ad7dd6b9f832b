/* From a key and the state to the line it stands for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/compose.h"

#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "io/units.h"

/* The picture of the page, as describe names it. */
static char *
picture_words(const struct tui *t)
{
	const struct prediction *p = &t->shown;
	if (t->page == PAGE_PARITY)
		return xstrdup("parity");
	if (t->page == PAGE_FIT && t->picture != PLOT_PSD)
		return xstrdup(
		    t->picture == PLOT_SPREAD ? "spread" : "convergence");
	char *where = tui_where(t), *words = xasprintf("psd %s", where);
	free(where);
	if (t->page != PAGE_PREDICT)
		return words;
	if (t->pin.site[0] != '\0')
		xappend(
		    &words, " beside=%s other=%.1f", t->pin.site, t->pin.speed);
	if (t->band)
		xappend(&words, " band=on");
	if (t->cross && t->cross_at < p->product.n)
		xappend(&words, " at=%g level=%d",
		    units_mm(p->product.size[t->cross_at]), t->level);
	return words;
}

char *
compose_line(const struct tui *t, const struct key *key)
{
	const struct session *s = t->session;
	const char *hole = strstr(key->command, "%s");
	if (hole == NULL)
		return xstrdup(key->command);
	char *where = key->act == ACT_TELL ? picture_words(t) : tui_where(t);
	char *line;
	const char *with = key->act != ACT_CHOOSE    ? where
			   : t->site_at < s->n_entry ? s->entry[t->site_at].key
						     : "";
	if (key->act == ACT_EXPORT && t->pin.site[0] != '\0')
		line = xasprintf("plot psd %s beside=%s other=%.1f > ", where,
		    t->pin.site, t->pin.speed);
	else
		line = xasprintf("%.*s%s%s", (int)(hole - key->command),
		    key->command, with, hole + 2);
	free(where);
	return line;
}
