/* XML as events, by expat, with limits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_XML_H
#define TIPSPEED_IO_CELLS_XML_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* begin, end: called for an element, with its name without a prefix.  text:
 * called with n bytes of UTF-8, perhaps a part of the text between two tags;
 * NULL: not called. */
struct xml_events {
	void (*begin)(
	    void *data, const char *name, const char *const *attribute);
	void (*end)(void *data, const char *name);
	void (*text)(void *data, const char *text, size_t n);
};

/* Parses a document of n bytes.  Returns NULL, or what is wrong with it, as a
 * text that the caller frees: it is not well-formed, nests elements more than
 * 100 deep, has more than 1000 attributes on an element or a namespace of more
 * than 200 letters, or has a document type, whose entities could expand to more
 * than the document; or error_stopped(errors) is true. */
char *xml_read(const char *bytes, size_t n, const struct xml_events *events,
    void *data, struct error_list *errors);

/* Returns an attribute's value, or NULL.  name: "r" without a namespace;
 * "office:1.0 value" with the end of the namespace. */
const char *xml_attribute(const char *const *attribute, const char *name);

/* As xml_attribute, but as a whole number up to two million, which is more than
 * the rows of any spreadsheet program; returns `other` if the attribute is
 * absent or no such number. */
size_t xml_whole(const char *const *attribute, const char *name, size_t other);

/* A text built piece by piece; text is NULL before the first piece. */
struct xml_text {
	char *text;
	size_t n, room;
};
void xml_text_add(struct xml_text *to, const char *text, size_t n);

#endif
