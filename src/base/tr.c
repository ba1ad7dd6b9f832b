/* Translation with gettext.  Catalogues are in locale/ beside a program that is
 * not installed, otherwise among the system's.  libc keeps the state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "config.h"

#if HAVE_LIBINTL

#include <libintl.h>
#include <limits.h>
#include <unistd.h>

/* Domains of gettext; OFF has no catalogue. */
static const char ON[] = PACKAGE, OFF[] = PACKAGE "-c";

static void
bind_message_catalogues(void)
{
	static const char BESIDE[] = "/locale";
	char path[PATH_MAX];
	ssize_t n = readlink("/proc/self/exe", path, sizeof path);
	bool fits = n > 0 && (size_t)n < sizeof path - sizeof BESIDE;
	path[fits ? n : 0] = '\0';
	char *slash = strrchr(path, '/');
	if (slash != NULL)
		memcpy(slash, BESIDE, sizeof BESIDE);
	bool beside = slash != NULL && access(path, R_OK) == 0;
	bindtextdomain(ON, beside ? path : LOCALEDIR);
	bind_textdomain_codeset(ON, "UTF-8");
	textdomain(ON);
}

/* True if a path is given instead of a language.  It would name a catalogue
 * from elsewhere, whose texts are unchecked formats. */
static bool
is_path_not_language(const char *language)
{
	return strchr(language, '/') != NULL;
}

/* glibc uses LANGUAGE in any locale that exists, except C; musl accepts any
 * locale, and ignores LANGUAGE. */
static void
set_message_language(const char *language)
{
	setenv("LANGUAGE", language, 1);
	if (setlocale(LC_MESSAGES, language) == NULL &&
	    setlocale(LC_MESSAGES, "C.UTF-8") == NULL)
		setlocale(LC_MESSAGES, "en_US.UTF-8");
}

bool
tr_set_language(const char *language)
{
	const char *wanted = getenv("LANGUAGE");
	if (language != NULL && is_path_not_language(language))
		return false;
	if (wanted != NULL && is_path_not_language(wanted))
		unsetenv("LANGUAGE");
	if (language != NULL)
		set_message_language(language);
	else
		setlocale(LC_MESSAGES, "");
	bind_message_catalogues();
	/* The header of a catalogue is the translation of the empty text. */
	return language == NULL || strcmp(language, "en") == 0 ||
	       strcmp(language, "C") == 0 || gettext("")[0] != '\0';
}

const char *
tr(const char *text)
{
	return text[0] != '\0' ? gettext(text) : text;
}

const char *
tr_n(const char *one, const char *several, unsigned long n)
{
	return ngettext(one, several, n);
}

void
tr_set_enabled(bool on)
{
	textdomain(on ? ON : OFF);
}

#else

bool
tr_set_language(const char *language)
{
	return language == NULL || strcmp(language, "en") == 0 ||
	       strcmp(language, "C") == 0;
}

const char *
tr(const char *text)
{
	return text;
}

const char *
tr_n(const char *one, const char *several, unsigned long n)
{
	return n == 1 ? one : several;
}

void
tr_set_enabled(bool on)
{
	(void)on;
}

#endif

static bool
is_word_or_its_first_letter(const char *said, const char *word)
{
	bool letter = said[0] != '\0' && said[1] == '\0';
	return text_is_same_but_case(said, word, letter ? 1 : SIZE_MAX);
}

bool
tr_is_yes(const char *said)
{
	return is_word_or_its_first_letter(said, "yes") ||
	       is_word_or_its_first_letter(said, tr("yes"));
}

bool
tr_is_no(const char *said)
{
	return is_word_or_its_first_letter(said, "no") ||
	       is_word_or_its_first_letter(said, tr("no"));
}

/* Other scripts than Latin keep the English letter. */
char
tr_yes_letter(void)
{
	char first = tr("yes")[0];
	return first >= 'a' && first <= 'z' ? first : 'y';
}

char
tr_letter_for_no(void)
{
	char first = tr("no")[0];
	return first >= 'a' && first <= 'z' ? first : 'n';
}
