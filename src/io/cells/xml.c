/* Names come from expat as "namespace name".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/xml.h"

#include <stdint.h>
#include <string.h>

#include <expat.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

enum { MOST_DEPTH = 100 };

struct reading {
	XML_Parser parser;
	const struct xml_events *events;
	void *data;
	int depth;
	const char *wrong;
};

static void
give_up(struct reading *r, const char *wrong)
{
	r->wrong = wrong;
	XML_StopParser(r->parser, XML_FALSE);
}

static const char *
local(const char *name)
{
	const char *blank = strrchr(name, ' ');
	return blank != NULL ? blank + 1 : name;
}

static void XMLCALL
on_begin(void *data, const XML_Char *name, const XML_Char **attribute)
{
	struct reading *r = data;
	if (r->wrong == NULL && ++r->depth > MOST_DEPTH)
		give_up(r, tr("its elements are too deep within each other"));
	if (r->wrong == NULL)
		r->events->begin(
		    r->data, local(name), (const char *const *)attribute);
}

static void XMLCALL
on_end(void *data, const XML_Char *name)
{
	struct reading *r = data;
	r->depth--;
	if (r->wrong == NULL)
		r->events->end(r->data, local(name));
}

static void XMLCALL
on_text(void *data, const XML_Char *text, int n)
{
	struct reading *r = data;
	if (r->wrong == NULL)
		r->events->text(r->data, text, (size_t)n);
}

static void XMLCALL
on_doctype(void *data, const XML_Char *name, const XML_Char *system,
    const XML_Char *public, int internal)
{
	(void)name;
	(void)system;
	(void)public;
	(void)internal;
	give_up(data, tr("it has a document type"));
}

char *
xml_read(
    const char *bytes, size_t n, const struct xml_events *events, void *data)
{
	struct reading r = {.parser = XML_ParserCreateNS(NULL, ' '),
	    .events = events,
	    .data = data};
	XML_SetUserData(r.parser, &r);
	XML_SetElementHandler(r.parser, on_begin, on_end);
	if (events->text != NULL)
		XML_SetCharacterDataHandler(r.parser, on_text);
	XML_SetStartDoctypeDeclHandler(r.parser, on_doctype);
	char *wrong = NULL;
	/* At once: a long name in pieces is looked at from its start for each
	 * of them. */
	if (XML_Parse(r.parser, bytes, (int)n, 1) != XML_STATUS_OK)
		wrong = xasprintf(tr("%s in line %lu"),
		    r.wrong != NULL
			? r.wrong
			: XML_ErrorString(XML_GetErrorCode(r.parser)),
		    (unsigned long)XML_GetCurrentLineNumber(r.parser));
	XML_ParserFree(r.parser);
	return wrong;
}

const char *
xml_attribute(const char *const *attribute, const char *name)
{
	bool spaced = strchr(name, ' ') != NULL;
	for (; attribute[0] != NULL; attribute += 2) {
		const char *found = attribute[0];
		if (strcmp(found, name) == 0 ||
		    (spaced && text_ends(found, name) &&
			(name[0] == ' ' ||
			    found[strlen(found) - strlen(name) - 1] == ':')))
			return attribute[1];
	}
	return NULL;
}

size_t
xml_whole(const char *const *attribute, const char *name, size_t other)
{
	enum { MOST = 2000000 };
	uint64_t whole;
	const char *text = xml_attribute(attribute, name);
	if (text == NULL || !text_whole(text, &whole))
		return other;
	return whole < MOST ? (size_t)whole : MOST;
}
