/* Parses XML into events, with expat and limits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_XML_H
#define TIPSPEED_IO_CELLS_XML_H

#include <stddef.h>

#include "base/error.h"
#include "io/cells/archive.h"

/* begin, end: called for an element, with its name without the prefix.  text:
 * called with n bytes of UTF-8, possibly only part of the text between two
 * tags.  Each may be NULL. */
struct xml_events {
	void (*begin)(
	    void *data, const char *name, const char *const *attribute);
	void (*end)(void *data, const char *name);
	void (*text)(void *data, const char *text, size_t n);
};

/* Parses a document of n bytes.  Returns NULL if all went well, or a
 * description of the fault, which the caller frees: the document is not
 * well-formed, nests elements more than 100 deep, has more than 1000 attributes
 * on an element or a namespace of more than 200 bytes, or has a document type,
 * because entities could expand without limit; or
 * error_is_stop_requested(errors) became true. */
char *xml_parse_document(const char *bytes, size_t n,
    const struct xml_events *events, void *data, struct error_list *errors);

/* As xml_parse_document, for a part of an archive; the description of a fault
 * names the part. */
char *xml_parse_archive_part(struct archive *archive, const char *name,
    const struct xml_events *events, void *data, struct error_list *errors);

/* Returns the value of an attribute, or NULL.  name: "r" for one without a
 * namespace, or "office:1.0 value", where "office:1.0" is the end of the
 * namespace. */
const char *xml_attribute_value(const char *const *attribute, const char *name);

/* Returns an attribute as a whole number, or `other` if it is missing or not a
 * whole number.  A number above two million, more rows than any spreadsheet
 * program has, is returned as two million. */
size_t xml_attribute_as_integer(
    const char *const *attribute, const char *name, size_t other);

/* A text built up in pieces; text is NULL before the first piece. */
struct xml_text {
	char *text;
	size_t n, room;
};
void xml_text_add(struct xml_text *to, const char *text, size_t n);

#endif
