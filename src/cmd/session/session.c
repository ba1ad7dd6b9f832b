/* What all commands need of the session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/session.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/document/document.h"
#include "core/psd/rotor_speed.h"
#include "io/formats/book.h"
#include "io/sitefile/units.h"

struct entry *
session_current_site_entry(struct session *s)
{
	assert(s->current < s->n_entry);
	return &s->entry[s->current];
}

bool
session_report_file_faults(const struct session *s, const char *path,
    const struct error_list *errors, struct error *error)
{
	if (errors->stopped) /* what was found on the way is not all */
		return error_set(error, ERROR_STOPPED, "interrupted");
	for (size_t i = 0; i + 1 < errors->n; i++)
		error_print(&errors->item[i], s->notes);
	*error = errors->item[errors->n - 1];
	if (errors->more > 0)
		session_print_note(
		    s, "%s: %zu more faults are not shown", path, errors->more);
	return false;
}

/* Results for programs are written unchanged to files and pipes, but escaped on
 * a terminal. */
static size_t
print_answer_for_programs(struct session *s, const struct answer_form *form,
    const struct answer *answer)
{
	char *text = NULL, *save = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&text, &n);
	size_t rows = form->print(answer, s->set.semicolon, memory);
	fclose(memory);
	for (char *line = strtok_r(text, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save)) {
		text_print_escaped(line, s->out);
		fputc('\n', s->out);
	}
	free(text);
	return rows;
}

static void
remove_answer_at(struct session *s, size_t i)
{
	answer_free(s->answer[i]);
	memmove(&s->answer[i], &s->answer[i + 1],
	    (--s->n_answer - i) * sizeof *s->answer);
}

void
session_remove_answers(struct session *s)
{
	while (s->n_answer > 0)
		remove_answer_at(s, s->n_answer - 1);
}

void
session_store_newest_answer(struct session *s, struct answer *answer)
{
	const char *command = answer_command_name(answer);
	if (!answer_has_json_fields(answer)) {
		answer_free(answer);
		return;
	}
	for (size_t i = s->n_answer; i-- > 0;)
		if (strcmp(answer_command_name(s->answer[i]), command) == 0)
			remove_answer_at(s, i);
	s->answer = xrealloc(s->answer, s->n_answer + 1, sizeof *s->answer);
	s->answer[s->n_answer++] = answer;
}

double
session_number_in_last_answer(
    const struct session *s, const char *commands, const char *path)
{
	size_t which;
	double value = NAN;
	for (size_t i = s->n_answer; i-- > 0 && isnan(value);)
		if (text_find_word_in_list(
			commands, answer_command_name(s->answer[i]), &which))
			value = answer_find_json_number(s->answer[i], path);
	return value;
}

const char *
session_text_in_last_answer(
    const struct session *s, const char *command, const char *path)
{
	const char *text = NULL;
	for (size_t i = s->n_answer; i-- > 0 && text == NULL;)
		if (strcmp(answer_command_name(s->answer[i]), command) == 0)
			text = answer_find_json_text(s->answer[i], path);
	return text;
}

bool
session_is_interrupted(const struct session *s)
{
	bool stop = s->hooks.stop != NULL && s->hooks.stop();
	if (stop && s->cut_short != NULL)
		*s->cut_short = true;
	return stop;
}

bool
session_show_answer(struct session *s, struct answer *answer)
{
	const struct answer_form *form = &ANSWER_FORMATS[s->set.format];
	if (s->cut_short != NULL && *s->cut_short) {
		answer_free(answer);
		return true;
	}
	if (session_text_width(s) < SESSION_TEXT_WIDTH)
		answer_set_width(answer, s->screen.columns);
	if (s->hooks.clear_progress != NULL)
		s->hooks.clear_progress();
	if (s->book != NULL)
		s->rows += book_add_answer_worksheet(s->book, answer);
	else if (s->document != NULL)
		s->rows += document_add_answer(s->document, answer);
	else
		s->rows += form->exact && s->screen.columns > 0
			       ? print_answer_for_programs(s, form, answer)
			       : form->print(answer, s->set.semicolon, s->out);
	fflush(s->out);
	session_store_newest_answer(s, answer);
	return true;
}

void
session_set_translation_by_format(const struct session *s)
{
	tr_set_enabled(!ANSWER_FORMATS[s->set.format].exact);
}

int
session_text_width(const struct session *s)
{
	int columns = s->screen.columns - 1;
	return columns > 0 && columns < SESSION_TEXT_WIDTH ? columns
							   : SESSION_TEXT_WIDTH;
}

void
session_print_note(const struct session *s, const char *format, ...)
{
	char text[1024];
	va_list ap;
	va_start(ap, format);
	vsnprintf(text, sizeof text, tr(format), ap);
	va_end(ap);
	if (s->hooks.clear_progress != NULL)
		s->hooks.clear_progress();
	text_print_wrapped(text, 0, session_text_width(s), s->notes);
}

bool
session_require_site(
    const struct session *s, const char *what, struct error *error)
{
	size_t own = 0;
	if (s->n_entry > 0)
		return true;
	bool remembered =
	    store_count_materials(s->store, &own, NULL) && own > 0;
	return error_set(error, ERROR_USAGE,
	    remembered ? N_("%s needs a site, and none is loaded\n"
			    "load its site file: load FILE; or bring back what "
			    "was remembered: recall NAME")
		       : N_("%s needs a site, and none is loaded\n"
			    "load its site file first: load FILE"),
	    what);
}

double
session_clock_seconds(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

char *
session_site_label(const struct site *site)
{
	FREED char *size =
	    site->top_size > 0
		? xasprintf(tr(", %g mm"), units_m_to_mm(site->top_size))
		: xstrdup("");
	bool rock = site->rock[0] != '\0', with = site->with[0] != '\0';
	FREED char *label = xasprintf(
	    "%s%s%s%s", site->name, rock ? ", " : "", site->rock, size);
	return with ? xasprintf(tr("%s, with %s"), label, site->with)
		    : xstrdup(label);
}

bool
session_is_calibrating(const struct session *s)
{
	return s->job.type != NULL && !s->job.paused;
}

const struct entry *
session_entry_being_fitted(const struct session *s)
{
	return session_is_calibrating(s) && s->job.fits
		   ? &s->entry[s->job.entry]
		   : NULL;
}

char *
session_speeds_of_runs_text(
    const struct site *site, const char *between, const bool *mark, bool marked)
{
	char *list = xstrdup("");
	for (size_t r = 0, n = 0; r < site->n_run; r++) {
		if (site->run[r].product.n == 0 ||
		    (mark != NULL && mark[r] != marked))
			continue;
		n = n > 0 && site_run_repeats_speed(site, r) ? n + 1 : 1;
		if (n == 1)
			xappend_to_list(
			    &list, between, "%g", site->run[r].speed);
		if (n > 1 && (r + 1 == site->n_run ||
				 !site_run_repeats_speed(site, r + 1)))
			xappend(&list, tr(" (%zu runs)"), n);
	}
	return list;
}

char *
session_rpm_of_runs_text(
    const struct site *site, const char *between, const bool *mark, bool marked)
{
	char *rpm = xstrdup("");
	double rotor = site_run_rotor_diameter(site);
	for (size_t r = 0; r < site->n_run && rotor > 0; r++)
		if (site->run[r].product.n > 0 &&
		    !site_run_repeats_speed(site, r) &&
		    (mark == NULL || mark[r] == marked))
			xappend_to_list(&rpm, between, "%.0f",
			    rotor_speed_to_rpm(site->run[r].speed, rotor));
	return rpm;
}

char *
session_rpm_of_runs_in_brackets(
    const struct site *site, const bool *mark, bool marked)
{
	FREED char *rpm = session_rpm_of_runs_text(site, ", ", mark, marked);
	return rpm[0] != '\0' ? xasprintf(tr(" (%s rpm)"), rpm) : xstrdup("");
}
