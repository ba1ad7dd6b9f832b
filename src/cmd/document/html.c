/* Writes a document as HTML that any browser can show and print.  What a colour
 * means is also said in words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/document/html.h"

#include <stdlib.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "config.h"
#include "plot/picture.h"

/* Contains no characters that are special in XML.  The colours of the lights
 * can be told apart by people with red-green blindness. */
static const char STYLE[] =
    "body{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;"
    "font-size:15px;line-height:1.4;color:#000;background:#fff;"
    "max-width:60rem;margin:1.5rem auto;padding:0 1rem}\n"
    "h1{font-size:1.5em;line-height:1.2;margin:.5em 0}\n"
    "h2{font-size:1.2em;margin:1.8em 0 .5em;padding-top:.4em;"
    "border-top:1px solid #999}\n"
    "h3{font-size:1em;margin:1.2em 0 .2em}\n"
    "p{margin:.3em 0;max-width:46rem}\n"
    ".about{color:#555}\n"
    ".warning{font-weight:bold;border-left:.3em solid #000;"
    "padding-left:.5em}\n"
    ".light{font-size:1.1em;border:2px solid #000;border-left-width:1em;"
    "padding:.4em .7em;margin:.8em 0}\n"
    ".green{border-color:#00af00}\n"
    ".amber{border-color:#d78700}\n"
    ".red{border-color:#d70000}\n"
    ".wide{overflow-x:auto;margin:.5em 0 .8em}\n"
    "table{border-collapse:collapse;font-size:.9em;"
    "font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.15em .7em .15em 0;text-align:left;vertical-align:top}\n"
    "th{border-bottom:1px solid #000;vertical-align:bottom}\n"
    "td{border-bottom:1px solid #ddd}\n"
    "td:first-child:not(:only-child){white-space:pre}\n"
    "th.n,td.n{text-align:right;padding:.15em 0 .15em .7em}\n"
    "th.n+th:not(.n),td.n+td:not(.n){padding-left:1em}\n"
    "figure{margin:.8em 0}\n"
    "svg{max-width:100%;height:auto}\n"
    "pre{font-size:.8em;line-height:1.25;overflow-x:auto;"
    "background:#f5f5f5;padding:.6em}\n"
    "footer{color:#555;font-size:.85em;margin-top:2em;"
    "border-top:1px solid #999;padding-top:.4em}\n"
    "@page{size:A4;margin:16mm 15mm}\n"
    "@media print{\n"
    "body{font-size:9.5pt;max-width:none;margin:0;padding:0}\n"
    "h1,h2,h3,.about{break-after:avoid}\n"
    "thead{display:table-header-group}\n"
    "tr,figure,.light,.warning{break-inside:avoid}\n"
    ".wide{overflow:visible}\n"
    "pre{white-space:pre-wrap;overflow-wrap:anywhere;overflow:visible}\n"
    "}\n";

static void
html_put_escaped(
    const char *before, const char *text, const char *after, FILE *out)
{
	fputs(before, out);
	text_print_xml(text, out);
	fputs(after, out);
}

static void
html_put_paragraph(const char *text, bool warning, FILE *out)
{
	html_put_escaped(
	    warning ? "<p class=\"warning\">" : "<p>", text, "</p>\n", out);
}

static void
html_put_cell(const struct answer_view *v, size_t row, size_t column, FILE *out)
{
	bool head = row == 0;
	const char *text = head
			       ? v->head[column]
			       : v->cell[(row - 1) * v->n_column + column].text;
	fprintf(out, "<%s%s%s>", head ? "th" : "td",
	    head ? " scope=\"col\"" : "",
	    document_is_number_column(v, column) ? " class=\"n\"" : "");
	text_print_xml(text, out);
	fputs(head ? "</th>" : "</td>", out);
}

/* Puts a table of the first column and columns `from` to `to` - 1. */
static void
html_put_table(const struct answer_view *v, size_t from, size_t to, FILE *out)
{
	fputs("<div class=\"wide\"><table>\n<thead>", out);
	for (size_t row = 0; row <= v->n_row; row++) {
		fputs("<tr>", out);
		for (size_t c = 0; c < to; c = c == 0 ? from : c + 1)
			html_put_cell(v, row, c, out);
		fputs(row == 0 ? "</tr></thead>\n<tbody>\n" : "</tr>\n", out);
	}
	fputs("</tbody></table></div>\n", out);
}

static void
html_put_sentences(const struct answer_view *v, bool warnings, FILE *out)
{
	for (size_t i = 0; i < v->n_sentence; i++) {
		const struct answer_sentence *said = &v->sentence[i];
		if ((said->grade == ANSWER_WARNING) == warnings)
			html_put_paragraph(said->text, warnings, out);
	}
}

/* Leaves out the answer's title if the document has it. */
static void
html_put_answer(const struct document *d, size_t i, FILE *out)
{
	struct answer_view v = answer_view(d->part[i].answer);
	bool top = i == d->titled_by;
	if (v.title != NULL && !top)
		html_put_escaped("<h3>", v.title, "</h3>\n", out);
	if (v.provenance != NULL) {
		FREED char *text = xasprintf(tr("Data: %s"), v.provenance);
		html_put_escaped("<p class=\"about\">", text, "</p>\n", out);
	}
	html_put_sentences(&v, true, out);
	for (size_t from, to = 0;
	     document_find_columns_that_fit(&v, d->one_page, &from, &to);)
		html_put_table(&v, from, to, out);
	html_put_sentences(&v, false, out);
}

static void
html_put_text_lines(const char *text, FILE *out)
{
	char *line;
	fputs("<pre>", out);
	while ((line = document_copy_next_text_line(&text)) != NULL) {
		html_put_escaped("", line, "\n", out);
		free(line);
	}
	fputs("</pre>\n", out);
}

static void
html_put_document_part(const struct document *d, size_t i, FILE *out)
{
	const struct document_part *p = &d->part[i];
	switch (p->kind) {
	case DOCUMENT_HEADING:
		html_put_escaped("<h2>", p->text, "</h2>\n", out);
		break;
	case DOCUMENT_WORDS:
	case DOCUMENT_WARNING:
		html_put_paragraph(p->text, p->kind == DOCUMENT_WARNING, out);
		break;
	case DOCUMENT_LIGHT:
		fprintf(out, "<p class=\"light %s\">", LIGHT_NAME[p->light]);
		html_put_escaped("", p->text, "</p>\n", out);
		break;
	case DOCUMENT_TEXT:
		html_put_text_lines(p->text, out);
		break;
	case DOCUMENT_ANSWER:
		html_put_answer(d, i, out);
		break;
	case DOCUMENT_PICTURE:
		fputs("<figure>\n", out);
		picture_write_chart(p->chart, PICTURE_INLINE, PICTURE_WIDTH,
		    "tipspeed " PACKAGE_VERSION, out);
		fputs("</figure>\n", out);
		break;
	}
}

char *
document_to_html(const struct document *d, size_t *n)
{
	char *text = NULL;
	FILE *out = text_open_memory(&text, n);
	fprintf(out,
	    "<!DOCTYPE html>\n"
	    "<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"%s\">\n"
	    "<head>\n<meta charset=\"utf-8\"/>\n"
	    "<meta http-equiv=\"Content-Security-Policy\" "
	    "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
	    "<meta name=\"viewport\" content=\"width=device-width\"/>\n",
	    tr("en")); /* the code of the language */
	html_put_escaped("<title>", d->title, "</title>\n", out);
	fprintf(out, "<style>\n%s</style>\n</head>\n<body>\n", STYLE);
	html_put_escaped("<h1>", d->title, "</h1>\n", out);
	for (size_t i = 0; i < d->n; i++)
		html_put_document_part(d, i, out);
	html_put_escaped(
	    "<footer>", d->made_by, "</footer>\n</body>\n</html>\n", out);
	fclose(out);
	return text;
}
