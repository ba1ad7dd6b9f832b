/* Where data and parameters are from, wherever they go.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "desk.h"

/* Whether the newest results have the text, and the former ones forgotten. */
static bool
says(struct desk *desk, const char *line, const char *text)
{
	fflush(desk->out_file);
	size_t before = desk->n_out;
	desk_expect(desk, line);
	return strstr(desk->out + before, text) != NULL;
}

static void
data_are_what_the_sheet_says(void **state)
{
	(void)state;
	static const char *const KINDS[][2] = {{"", "not stated"},
	    {" ", "not stated"}, {"belt cuts of 3 May", "measured"},
	    {"measured", "measured"}, {"not made up at all", "measured"},
	    {"reconstructed from Table 3", "reconstructed"},
	    {"Made up, by hand", "made up"}, {"SIMULATED", "simulated"},
	    {"synthetic; seed 9", "synthetic"}};
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++)
		assert_string_equal(site_data_kind(KINDS[i][0]), KINDS[i][1]);
}

/* README's own sheet was told that it is not from a plant's sieves. */
static void
why_takes_the_sheet_at_its_word(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/tierp.csv; "
			  "params set f_mat=2 e0_min=16 alpha=1");
	assert_true(says(desk, "why", "not from a plant's sieves: recon"));
	char *own = session_entry(s)->site->provenance;
	session_entry(s)->site->provenance = xstrdup("belt cuts of 3 May; wet");
	assert_true(says(desk, "why",
	    "The data are measured, says the sheet: belt cuts of 3 May."));
	assert_true(says(desk, "sites", "measured"));
	session_entry(s)->site->provenance[0] = '\0';
	assert_true(says(desk, "why", "does not say where its data are from"));
	free(session_entry(s)->site->provenance);
	session_entry(s)->site->provenance = own;
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, desk_open, desk_close)
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(data_are_what_the_sheet_says),
	    at_desk(why_takes_the_sheet_at_its_word),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
