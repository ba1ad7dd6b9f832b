/* Makes the simplest question about an entry.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/asked.h"

struct question
question_of_whole_product(
    const struct session *s, const struct entry *entry, size_t feed)
{
	return (struct question){
	    .entry = entry, .feed = feed, .level = settings_level(&s->set)};
}
