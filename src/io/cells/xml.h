/* XML as events, by expat, with limits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_XML_H
#define TIPSPEED_IO_CELLS_XML_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* begin, end: of an element, by its name without a prefix.  text: n bytes of
 * UTF-8, perhaps a part of what stands between two tags; NULL: not asked. */
struct xml_events {
	void (*begin)(
	    void *data, const char *name, const char *const *attribute);
	void (*end)(void *data, const char *name);
	void (*text)(void *data, const char *text, size_t n);
};

/* Goes through a document of n bytes.  Returns NULL, or what is wrong with it,
 * which the caller frees: it is not well-formed, has elements within each other
 * more than 100 deep, with more than 1000 attributes or in a namespace of more
 * than 200 letters, or a document type, whose entities could stand for more
 * than there is; or errors say that it is to stop. */
char *xml_read(const char *bytes, size_t n, const struct xml_events *events,
    void *data, struct error_list *errors);

/* An attribute's value, or NULL.  name: "r" without a namespace; "office:1.0
 * value" by how the namespace ends. */
const char *xml_attribute(const char *const *attribute, const char *name);

/* The same as a whole number up to two million, which is more than the rows of
 * any program; or `other` where it is absent or none. */
size_t xml_whole(const char *const *attribute, const char *name, size_t other);

/* Text put together piece by piece; NULL before the first. */
struct xml_text {
	char *text;
	size_t n, room;
};
void xml_text_add(struct xml_text *to, const char *text, size_t n);

#endif
