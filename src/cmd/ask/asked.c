/* Makes the simplest question about an entry, and keeps what was last asked
 * about.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/asked.h"

struct question
question_of_whole_product(
    const struct session *s, const struct entry *entry, size_t feed)
{
	return (struct question){.entry = entry,
	    .feed = feed,
	    .level = settings_band_probability(&s->set)};
}

void
session_set_last_question(
    struct session *s, double speed, const struct quantity *of)
{
	s->last_asked = (struct last_asked){.speed = speed};
	if (of == NULL || of->kind == QUANTITY_STEP)
		return;
	s->last_asked.named = true;
	s->last_asked.of = *of;
}
