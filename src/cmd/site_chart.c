/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/site_chart.h"

#include <stdarg.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/session.h"

struct chart *
site_chart(const struct site *site, struct axis x, struct axis y,
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
