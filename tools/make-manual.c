/* Build-time only: prints what is made from the tables.
 *   commands, environment, status: parts of tipspeed(1)
 *   models: of tipspeed-model(7)
 *   keys: those of tipspeed-tui(1)
 *   bash: completion for the shell
 *   texts: what of them is translated
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "cmd/lang/manual.h"
#include "tui/keys.h"

static void
print_texts(FILE *out)
{
	manual_print_texts_for_xgettext(out);
	keys_print_texts(manual_print_text_for_xgettext, out);
}

static const struct {
	const char *name;
	void (*print)(FILE *out);
} PARTS[] = {{"commands", manual_print_commands},
    {"environment", manual_print_environment},
    {"status", manual_print_exit_status}, {"trust", manual_print_trust_lights},
    {"models", manual_print_models}, {"bash", manual_print_bash_completion},
    {"keys", keys_print_manual}, {"texts", print_texts}};

int
main(int argc, char **argv)
{
	for (size_t i = 0; i < sizeof PARTS / sizeof PARTS[0]; i++) {
		if (argc != 2 || strcmp(argv[1], PARTS[i].name) != 0)
			continue;
		PARTS[i].print(stdout);
		return fflush(stdout) != 0 || ferror(stdout);
	}
	fputs("usage: make-manual commands|environment|status|models|bash|keys|"
	      "texts\n",
	    stderr);
	return 2;
}
