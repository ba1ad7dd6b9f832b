/* What load asks about a sheet, and what the answers come to.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "cmd/sheets/ask_user.h"
#include "desk.h"
#include "io/sitefile/site_read.h"

/* Who sits there: gives these answers, separated by |, and notes what was
 * asked.  "^" gives up. */
static struct {
	const char *answers;
	char asked[4000];
	size_t n;
} user;

static char *
answer(struct session *s, const struct user_question *q)
{
	(void)s;
	size_t used = strlen(user.asked);
	snprintf(user.asked + used, sizeof user.asked - used, "%s [%s] %s\n",
	    q->text, q->offered, q->wrong);
	user.n++;
	if (user.answers == NULL || user.n > 20)
		return NULL;
	const char *from = user.answers, *end = strchr(from, '|');
	user.answers = end != NULL ? end + 1 : NULL;
	size_t n = end != NULL ? (size_t)(end - from) : strlen(from);
	return n == 1 && from[0] == '^' ? NULL : xstrndup(from, n);
}

static int
open_with_user(void **state)
{
	desk_open(state);
	struct desk *desk = *state;
	desk->session->hooks.ask = answer;
	memset(&user, 0, sizeof user);
	return 0;
}

/* A sheet in the build's folder, which the next one replaces. */
static const char SHEET[] = "test-load.csv";

static int
close_without_sheet(void **state)
{
	unlink(SHEET);
	return desk_close(state);
}

static void
write_sheet(const char *text)
{
	FILE *f = fopen(SHEET, "w");
	assert_non_null(f);
	fputs(text, f);
	assert_int_equal(fclose(f), 0);
}

static bool
load_with(struct desk *desk, const char *sheet, const char *answers)
{
	write_sheet(sheet);
	user.answers = answers;
	user.asked[0] = '\0';
	user.n = 0;
	return desk_say(desk, "load test-load.csv");
}

static void
assert_near(double value, double wanted, double by)
{
	if (!(fabs(value - wanted) <= by))
		fail_msg("expected %.9g, got %.9g", wanted, value);
}

static const struct site *
site_of(struct desk *desk)
{
	return session_current_site_entry(desk->session)->site;
}

static void
assert_speeds(const struct site *site, double slow, double fast)
{
	assert_int_equal(site->n_run, 2);
	assert_near(site->run[0].speed, slow, 1e-9);
	assert_near(site->run[1].speed, fast, 1e-9);
	assert_true(site->run[0].feed.n > 0 && site->run[0].product.n > 0);
}

static const char OPEN[] = "Sieve mm;Feed;Product 1;Product 2\n"
			   "8;100;100;100\n4;40;60;65\n2;20;35;40\n1;5;15;19\n";

static void
speeds_are_asked_column_by_column(void **state)
{
	struct desk *desk = *state;
	assert_true(load_with(desk, OPEN, "69|79"));
	assert_int_equal(user.n, 2);
	assert_non_null(strstr(user.asked, "column 3 'Product 1'"));
	assert_non_null(strstr(user.asked, "column 4 'Product 2'"));
	assert_speeds(site_of(desk), 69, 79);
	assert_near(
	    psd_passing(&site_of(desk)->run[1].product, 4e-3), 0.65, 1e-9);
}

static void
speeds_come_with_units(void **state)
{
	struct desk *desk = *state;
	assert_true(load_with(desk, OPEN, "63,6 m/s|product at 252 km/h"));
	assert_speeds(site_of(desk), 63.6, 70);
}

static void
rpm_lead_to_the_rotor(void **state)
{
	struct desk *desk = *state;
	assert_true(
	    load_with(desk, OPEN, "1350 rpm|1500 rpm|nine hundred|900"));
	assert_non_null(strstr(user.asked, "diameter of the rotor"));
	assert_non_null(strstr(user.asked, "got 'nine hundred'"));
	assert_int_equal(site_of(desk)->n_run, 2);
	assert_near(site_of(desk)->run[0].speed, 63.62, 0.01);
}

static void
words_say_what_a_column_is(void **state)
{
	struct desk *desk = *state;
	/* The first is another feed's product, the second is left out. */
	assert_true(load_with(desk, OPEN, "product@72|-"));
	assert_int_equal(site_of(desk)->n_run, 1);
	assert_near(site_of(desk)->run[0].speed, 72, 1e-9);
	assert_true(load_with(desk,
	    "Sieve mm;Feed;Product 1;Product 2\n8;0;0;0\n4;120;80;70\n"
	    "2;40;50;50\n1;30;40;42\npan;10;30;38\n",
	    "69 g retained|product 79 retained_g"));
	assert_speeds(site_of(desk), 69, 79);
	assert_near(
	    psd_passing(&site_of(desk)->run[0].product, 4e-3), 0.6, 1e-9);
}

static void
feed_and_product_can_be_told(void **state)
{
	struct desk *desk = *state;
	assert_true(load_with(desk,
	    "Sieve mm;Sample A;Sample B\n8;100;100\n4;40;60\n2;20;35\n1;5;15\n",
	    "feed|72"));
	assert_int_equal(site_of(desk)->n_run, 1);
	assert_near(psd_passing(&site_of(desk)->run[0].feed, 4e-3), 0.4, 1e-9);
	assert_near(
	    psd_passing(&site_of(desk)->run[0].product, 4e-3), 0.6, 1e-9);
}

static void
enter_accepts_what_is_offered(void **state)
{
	struct desk *desk = *state;
	const char *sheet = "Sieve,Feed,Product 69 m/s,Product 79 m/s\n"
			    "882,100,100,100\n441,40,60,65\n210,20,35,40\n"
			    "97,5,15,19\n";
	assert_true(load_with(desk, sheet, "furlong|um"));
	assert_non_null(strstr(user.asked, "[sieve um]"));
	assert_non_null(strstr(user.asked, "expected the unit of the sieves"));
	assert_near(
	    psd_passing(&site_of(desk)->run[0].product, 441e-6), 0.6, 1e-9);
	assert_true(load_with(desk, sheet, ""));
	assert_near(
	    psd_passing(&site_of(desk)->run[0].product, 441e-6), 0.6, 1e-9);
	assert_true(load_with(desk, sheet, "mm"));
	assert_near(
	    psd_passing(&site_of(desk)->run[0].product, 0.441), 0.6, 1e-9);
}

static void
what_is_no_answer_is_asked_again(void **state)
{
	struct desk *desk = *state;
	assert_true(load_with(desk, OPEN, "|banana|1350|69|a=b|79"));
	assert_int_equal(user.n, 6);
	assert_non_null(strstr(user.asked, "got nothing"));
	assert_non_null(strstr(user.asked, "got 'banana'"));
	assert_non_null(strstr(user.asked, "for rpm write: 1350 rpm"));
	assert_speeds(site_of(desk), 69, 79);
}

static void
who_gives_up_gets_the_command(void **state)
{
	struct desk *desk = *state;
	assert_false(load_with(desk, OPEN, "69|^"));
	assert_int_equal(desk->session->n_entry, 0);
	assert_int_equal(desk->error.kind, ERROR_DATA);
	assert_non_null(strstr(desk->error.hint, "load test-load.csv "
						 "columns=\"1=sieve mm"));
}

static void
a_decimal_sign_is_asked(void **state)
{
	struct desk *desk = *state;
	const char *sheet = "Sieve mm;Feed retained g;Product 69 m/s retained g"
			    "\n8;0;0\n4;1.500;1.250\n2;1.250;1.500\n"
			    "1;1.125;1.125\npan;1.000;1.125\n";
	assert_true(load_with(desk, sheet, "maybe|point"));
	assert_int_equal(user.n, 2);
	assert_non_null(strstr(user.asked, "got 'maybe'"));
	assert_near(psd_passing(&site_of(desk)->run[0].feed, 4e-3),
	    1 - 1.5 / 4.875, 1e-6);
}

static void
of_two_tables_one_is_asked_for(void **state)
{
	struct desk *desk = *state;
	const char *sheet =
	    "May\nSieve mm;Feed;Product 69 m/s\n8;100;100\n4;40;60\n1;5;15\n"
	    "\nJune\nSieve mm;Feed;Product 79 "
	    "m/s\n8;100;100\n4;42;66\n1;6;18\n";
	assert_true(load_with(desk, sheet, ""));
	assert_near(site_of(desk)->run[0].speed, 69, 1e-9);
	assert_true(load_with(desk, sheet, "A8:C11"));
	assert_near(site_of(desk)->run[0].speed, 79, 1e-9);
}

/* Synthetic masses, of which 96.7 % pass the coarsest sieve. */
static const char SHORT[] =
    "size_mm,feed retained_g,product@69 retained_g,product@79 retained_g\n"
    "16,31.2,5.1,2\n8,300.7,100.5,90\n4,200,250.3,240\n2,150.33,200,210\n"
    "pan,263.9,280,290\n";

static void
a_coarser_sieve_is_assumed(void **state)
{
	struct desk *desk = *state;
	static const char *const YES[] = {"", "y", "perhaps|Yes"};
	for (size_t i = 0; i < ARRAY_LEN(YES); i++) {
		assert_true(load_with(desk, SHORT, YES[i]));
		assert_non_null(strstr(user.asked, "take 22.4 mm, the next "
						   "sieve up [Y/n]"));
		const struct psd *feed = &site_of(desk)->run[0].feed;
		assert_near(feed->size[0], 22.4e-3, 1e-12);
		assert_near(feed->passing[0], 1, 0);
		assert_near(feed->size[1], 16e-3, 1e-12);
		assert_near(site_assumed_top_size(site_of(desk)), 22.4, 0);
	}
	assert_non_null(strstr(user.asked, "got 'perhaps'"));
	assert_true(load_with(desk, SHORT, "31.5"));
	assert_near(site_assumed_top_size(site_of(desk)), 31.5, 0);
	assert_false(load_with(desk, SHORT, "n"));
	assert_non_null(
	    strstr(desk->error.text, "16 mm, passes 96.7 % of the"));
	assert_non_null(
	    strstr(desk->error.hint, "load test-load.csv top=22.4"));
	/* How coarse it is where much is coarser nobody knows. */
	static const char COARSE[] = "size_mm,feed,product@69\n16,60,80\n"
				     "8,30,50\n4,12,25\n";
	assert_true(load_with(desk, COARSE, ""));
	assert_non_null(strstr(user.asked,
	    "take 22.4 mm, the next sieve up (or type 31.5 or more, since "
	    "much is coarser) [Y/n]"));
	assert_near(site_assumed_top_size(site_of(desk)), 22.4, 0);
	assert_true(load_with(desk, COARSE, "45"));
	assert_near(site_assumed_top_size(site_of(desk)), 45, 0);
	assert_false(load_with(desk, COARSE, "n"));
	assert_non_null(
	    strstr(desk->error.hint, "(or 31.5 mm or more, since much is "
				     "coarser): load test-load.csv top=22.4"));
	assert_false(load_with(desk, SHORT, "n"));
	assert_false(desk_say(desk, "load test-load.csv top=16"));
	assert_non_null(strstr(desk->error.hint, "top=22.4"));
}

/* Synthetic: a long table, whose samples have no columns. */
static void
samples_are_asked_by_name(void **state)
{
	struct desk *desk = *state;
	static const char LONG[] =
	    "Cut,Size mm,passing\nK-1,8,100\nK-1,4,50\nK-1,2,20\nK-1,1,8\n"
	    "K-2,8,100\nK-2,4,65\nK-2,2,35\nK-2,1,15\nK-3,8,100\n"
	    "K-3,4,70\nK-3,2,40\nK-3,1,19\nK-4,8,100\nK-4,4,71\nK-4,2,41\n"
	    "K-4,1,20\n";
	assert_true(load_with(desk, LONG, "feed|69|-|79"));
	assert_non_null(strstr(user.asked, "'K-1'"));
	assert_speeds(site_of(desk), 69, 79);
	assert_near(psd_passing(&site_of(desk)->run[0].feed, 4e-3), 0.5, 1e-9);
	assert_near(
	    psd_passing(&site_of(desk)->run[1].product, 4e-3), 0.71, 1e-9);
	/* A point leaves out what follows. */
	assert_true(load_with(desk, LONG, "feed|69|79|."));
	assert_near(
	    psd_passing(&site_of(desk)->run[1].product, 4e-3), 0.7, 1e-9);
	assert_true(load_with(desk, LONG, "|69|."));
	assert_int_equal(site_of(desk)->n_run, 1);
}

/* Synthetic: blocks of two machines below each other. */
static void
tables_are_asked_by_number(void **state)
{
	struct desk *desk = *state;
	static const char TWO[] =
	    "Feed;\nSize mm;Passing %\n16;100\n8;60\n4;30\n2;10\n\n"
	    "VSI 1, 60 m/s;\nSize mm;Passing %\n16;100\n8;80\n4;50\n2;20\n\n"
	    "VSI 1, 70 m/s;\nSize mm;Passing %\n16;100\n8;85\n4;55\n2;25\n\n"
	    "VSI 2, 80 m/s;\nSize mm;Passing %\n16;100\n8;90\n4;60\n2;30\n";
	assert_true(load_with(desk, TWO, ""));
	assert_non_null(
	    strstr(user.asked, "which tables are to be read [1-3]"));
	assert_speeds(site_of(desk), 60, 70);
	assert_true(load_with(desk, TWO, "5|2-1|x|A1|1-2"));
	assert_int_equal(user.n, 5);
	assert_int_equal(site_of(desk)->n_run, 1);
	assert_true(load_with(desk, TWO, "A2:B20"));
	assert_speeds(site_of(desk), 60, 70);
	assert_false(load_with(desk, TWO, "^"));
	assert_non_null(strstr(desk->error.hint, "range=A2:B20"));
}

static void
scripts_are_not_asked(void **state)
{
	struct desk *desk = *state;
	desk->session->scripts = 1;
	assert_false(load_with(desk, OPEN, "69|79"));
	desk->session->scripts = 0;
	assert_int_equal(user.n, 0);
	desk->session->hooks.ask = NULL;
	assert_false(load_with(desk, OPEN, "69|79"));
	assert_non_null(strstr(desk->error.hint, "columns="));
}

static void
columns_are_those_of_the_table(void **state)
{
	struct desk *desk = *state;
	static const char *const WHAT[] = {"5=product@79", "3=product@79"};
	write_sheet(OPEN);
	for (size_t i = 0; i < ARRAY_LEN(WHAT); i++) {
		FREED char *line =
		    xasprintf("load test-load.csv columns=\"1=sieve, 2=feed, "
			      "3=product@69, %s\"",
			WHAT[i]);
		assert_false(desk_say(desk, line));
		assert_non_null(
		    strstr(desk->error.text, "columns with numbers"));
	}
}

static void
answers_are_saved_with_the_session(void **state)
{
	struct desk *desk = *state;
	assert_true(load_with(desk, OPEN, "69|79"));
	unlink("test-load.tip");
	desk_expect(desk, "save test-load.tip");
	FILE *f = fopen("test-load.tip", "r");
	assert_non_null(f);
	char text[2000];
	size_t n = fread(text, 1, sizeof text - 1, f);
	fclose(f);
	unlink("test-load.tip");
	text[n] = '\0';
	assert_non_null(strstr(text, "3=product@69 passing_pct"));
}

/* Rows of the table fit whatever width there is. */
static void
rows_fit(void **state)
{
	(void)state;
	struct site_ask_column column[] = {
	    {1, "Sikt (mm)", "11,2 8 5,6 4", "sieve mm", false, {0}},
	    {12, "Förkrossad produkt, prov nummer ett", "100 75,0 55,25 42,125",
		"product@SPEED retained_cum_pct", true, {0}}};
	struct site_ask ask = {.n = 2, .column = column};
	struct user_question q = {.ask = &ask};
	for (int columns = 38; columns <= 110; columns++) {
		size_t at = 0;
		for (size_t row = 0; row <= ask.n; row++) {
			char *line = user_question_row_text(&q, row, columns);
			assert_true(text_width_in_columns(line) <= columns);
			if (row == 2)
				at = strncmp(line, "? ", 2) == 0 ? 1 : 0;
			free(line);
		}
		assert_int_equal(at, 1);
	}
	char *line = user_question_row_text(&q, 2, 110);
	assert_non_null(strstr(line, "prov nummer ett  100 75,0 55,25 42,125  "
				     "product@SPEED retained_cum_pct"));
	free(line);
}

/* Asked whether to stop, says so the calls_left-th time and after it. */
static size_t calls_left;

static bool
stop_when_counted_down(void)
{
	calls_left -= calls_left > 0;
	return calls_left == 0;
}

/* Wherever it is, until the file is read before the user interrupts. */
static void
reading_can_be_interrupted_anywhere(void **state)
{
	static const char *const FILES[] = {"data/sites/tierp.csv",
	    "tests/sheets/office-lab-de_DE.ods",
	    "tests/sheets/openpyxl-tidy.xlsx"};
	const char *srcdir = getenv("srcdir");
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(FILES); i++) {
		FREED char *path =
		    xasprintf("%s/%s", srcdir != NULL ? srcdir : ".", FILES[i]);
		struct site *site = NULL;
		for (size_t n = 1; site == NULL; n++) {
			struct error_list errors = {
			    .stop = stop_when_counted_down};
			calls_left = n;
			site = site_read(path, &errors);
			assert_true((site == NULL) == errors.stopped);
		}
		site_free(site);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
#define WITH_USER(test)                  \
	cmocka_unit_test_setup_teardown( \
	    test, open_with_user, close_without_sheet)
	    WITH_USER(speeds_are_asked_column_by_column),
	    WITH_USER(speeds_come_with_units),
	    WITH_USER(rpm_lead_to_the_rotor),
	    WITH_USER(words_say_what_a_column_is),
	    WITH_USER(feed_and_product_can_be_told),
	    WITH_USER(enter_accepts_what_is_offered),
	    WITH_USER(what_is_no_answer_is_asked_again),
	    WITH_USER(who_gives_up_gets_the_command),
	    WITH_USER(a_decimal_sign_is_asked),
	    WITH_USER(of_two_tables_one_is_asked_for),
	    WITH_USER(a_coarser_sieve_is_assumed),
	    WITH_USER(samples_are_asked_by_name),
	    WITH_USER(tables_are_asked_by_number),
	    WITH_USER(scripts_are_not_asked),
	    WITH_USER(columns_are_those_of_the_table),
	    WITH_USER(answers_are_saved_with_the_session),
	    cmocka_unit_test(rows_fit),
	    cmocka_unit_test(reading_can_be_interrupted_anywhere),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
