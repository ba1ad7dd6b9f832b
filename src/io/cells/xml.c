/* Parses XML into events with expat, within limits.  expat returns names as
 * "namespace name".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/xml.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <expat.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

/* OFTEN: the number of events between two checks for an interrupt. */
enum {
	MOST_DEPTH = 100,
	MOST_ATTRIBUTES = 1000,
	MOST_NAME = 200,
	OFTEN = 1024
};

struct reading {
	XML_Parser parser;
	const struct xml_events *events;
	void *data;
	struct error_list *errors;
	int depth;
	size_t n; /* events so far */
	const char *wrong;
};

static void
xml_stop_with_fault(struct reading *r, const char *wrong)
{
	r->wrong = wrong;
	XML_StopParser(r->parser, XML_FALSE);
}

static void
stop_parsing_if_interrupted(struct reading *r)
{
	if (r->wrong == NULL && ++r->n % OFTEN == 0 &&
	    error_is_stop_requested(r->errors))
		xml_stop_with_fault(r, tr("interrupted"));
}

/* Refuses elements with many attributes or a long namespace.  expat copies the
 * namespace into each name within it, which would take too long for a million
 * names.  Called by a first parser that does not expand names, so attributes
 * are as written. */
static void XMLCALL
refuse_long_namespaces(
    void *data, const XML_Char *name, const XML_Char **attribute)
{
	static const char NAMESPACE[] = "xmlns";
	struct reading *r = data;
	size_t n = 0;
	bool many = false;
	(void)name;
	for (; attribute[0] != NULL && !many; attribute += 2)
		many =
		    ++n > MOST_ATTRIBUTES ||
		    (strncmp(attribute[0], NAMESPACE, strlen(NAMESPACE)) == 0 &&
			strlen(attribute[1]) > MOST_NAME);
	if (many && r->wrong == NULL)
		xml_stop_with_fault(
		    r, tr("an element has more names than a spreadsheet "
			  "program writes"));
	stop_parsing_if_interrupted(r);
}

static const char *
xml_local_name(const char *name)
{
	const char *blank = strrchr(name, ' ');
	return blank != NULL ? blank + 1 : name;
}

static void XMLCALL
xml_on_element_begin(
    void *data, const XML_Char *name, const XML_Char **attribute)
{
	struct reading *r = data;
	if (r->wrong == NULL && ++r->depth > MOST_DEPTH)
		xml_stop_with_fault(
		    r, tr("its elements are nested too deeply"));
	stop_parsing_if_interrupted(r);
	if (r->wrong == NULL && r->events->begin != NULL)
		r->events->begin(r->data, xml_local_name(name),
		    (const char *const *)attribute);
}

static void XMLCALL
xml_on_element_end(void *data, const XML_Char *name)
{
	struct reading *r = data;
	r->depth--;
	if (r->wrong == NULL && r->events->end != NULL)
		r->events->end(r->data, xml_local_name(name));
}

static void XMLCALL
xml_on_text(void *data, const XML_Char *text, int n)
{
	struct reading *r = data;
	if (r->wrong == NULL)
		r->events->text(r->data, text, (size_t)n);
}

static void XMLCALL
refuse_doctype(void *data, const XML_Char *name, const XML_Char *system,
    const XML_Char *public, int internal)
{
	(void)name;
	(void)system;
	(void)public;
	(void)internal;
	xml_stop_with_fault(data, tr("it has a document type"));
}

/* Runs the parser and frees it.  Returns a description of the fault, or
 * NULL. */
static char *
run_xml_parser(struct reading *r, XML_Parser parser,
    XML_StartElementHandler begin, const char *bytes, size_t n)
{
	r->parser = parser;
	XML_SetUserData(parser, r);
	XML_SetStartElementHandler(parser, begin);
	XML_SetStartDoctypeDeclHandler(parser, refuse_doctype);
	char *wrong = NULL;
	/* The whole document at once: in pieces, expat would scan a long name
	 * from its start again for each piece. */
	if (XML_Parse(parser, bytes, (int)n, 1) != XML_STATUS_OK)
		wrong = xasprintf(tr("%s in line %lu"),
		    r->wrong != NULL
			? r->wrong
			: XML_ErrorString(XML_GetErrorCode(parser)),
		    (unsigned long)XML_GetCurrentLineNumber(parser));
	XML_ParserFree(parser);
	return wrong;
}

char *
xml_parse_document(const char *bytes, size_t n, const struct xml_events *events,
    void *data, struct error_list *errors)
{
	struct reading r = {.events = events, .data = data, .errors = errors};
	char *wrong = run_xml_parser(
	    &r, XML_ParserCreate(NULL), refuse_long_namespaces, bytes, n);
	if (r.wrong != NULL)
		return wrong;
	free(wrong); /* the second parser reports it again */
	XML_Parser parser = XML_ParserCreateNS(NULL, ' ');
	XML_SetEndElementHandler(parser, xml_on_element_end);
	if (events->text != NULL)
		XML_SetCharacterDataHandler(parser, xml_on_text);
	return run_xml_parser(&r, parser, xml_on_element_begin, bytes, n);
}

char *
xml_parse_archive_part(struct archive *archive, const char *name,
    const struct xml_events *events, void *data, struct error_list *errors)
{
	size_t n;
	char *wrong = NULL;
	FREED char *bytes = archive_unpack_entry(archive, name, &n, &wrong);
	if (bytes == NULL)
		return wrong;
	FREED char *fault = xml_parse_document(bytes, n, events, data, errors);
	return fault != NULL ? xasprintf("%s: %s", name, fault) : NULL;
}

const char *
xml_attribute_value(const char *const *attribute, const char *name)
{
	bool spaced = strchr(name, ' ') != NULL;
	for (; attribute[0] != NULL; attribute += 2) {
		const char *found = attribute[0];
		if (strcmp(found, name) == 0 ||
		    (spaced && text_ends_with(found, name) &&
			(name[0] == ' ' ||
			    found[strlen(found) - strlen(name) - 1] == ':')))
			return attribute[1];
	}
	return NULL;
}

size_t
xml_attribute_as_integer(
    const char *const *attribute, const char *name, size_t other)
{
	enum { MOST = 2000000 };
	uint64_t whole;
	const char *text = xml_attribute_value(attribute, name);
	if (text == NULL || !text_parse_whole_number(text, &whole))
		return other;
	return whole < MOST ? (size_t)whole : MOST;
}

void
xml_text_add(struct xml_text *p, const char *text, size_t n)
{
	if (p->n + n + 1 > p->room) {
		p->room = 2 * (p->n + n) + 64;
		p->text = xrealloc(p->text, p->room, 1);
	}
	memcpy(p->text + p->n, text, n);
	p->n += n;
	p->text[p->n] = '\0';
}
