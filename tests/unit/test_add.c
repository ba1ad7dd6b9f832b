/* Belt cuts added to a site, dates, plant logs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "cmd/ask/cut.h"
#include "cmd/ask/forecast.h"
#include "cmd/sheets/ask_user.h"
#include "desk.h"
#include "io/cells/datetime.h"
#include "io/formats/plant_log.h"

static char folder[] = "/tmp/tipspeed-add-XXXXXX";

/* A file in the test's folder; the caller frees its path. */
static char *
file(const char *name, const char *text)
{
	char *path = xasprintf("%s/%s", folder, name);
	FILE *out = fopen(path, "w");
	assert_non_null(out);
	fputs(text, out);
	fclose(out);
	return path;
}

static const char FEED[] = "size_mm,feed,product@72\n16,100,100\n8,60,88\n"
			   "4,30,62\n2,15,33\n1,8,17\n0.5,4,9\n";
static const char CUT[] = "size_mm,passing\n16,100\n8,90\n4,66\n2,36\n1,19\n"
			  "0.5,10\n";

/* "load X" and the like, with the folder before the names. */
static void __attribute__((format(printf, 2, 3)))
say(struct desk *desk, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *line = xvasprintf(format, ap);
	va_end(ap);
	desk_expect(desk, line);
	free(line);
}

static void
assert_near(double is, double wanted, double tolerance)
{
	if (!(fabs(is - wanted) <= tolerance))
		fail_msg("%.12g is not %.12g", is, wanted);
}

static const struct site *
site_of(struct desk *desk)
{
	return session_current_site_entry(desk->session)->site;
}

static void
fresh(struct desk *desk)
{
	desk_expect(desk, "reset");
	say(desk, "load %s/site.csv", folder);
}

static void
assert_noted(const struct desk *desk, const char *part)
{
	char *flat = xstrdup(desk->notes);
	for (char *p = flat; (p = strstr(p, "\n")) != NULL;)
		*p = ' ';
	for (char *p = flat; (p = strstr(p, "  ")) != NULL;)
		memmove(p, p + 1, strlen(p));
	if (strstr(flat, part) == NULL)
		fail_msg("'%s' is not in:\n%s", part, desk->notes);
	free(flat);
}

static void
cuts_stand_in_order_of_speed(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	say(desk, "add %s/cut.csv@79 date=2026-05-03", folder);
	say(desk, "add %s/cut.csv@65", folder);
	say(desk, "add %s/cut.csv@72", folder);
	const struct site *site = site_of(desk);
	const double speed[] = {65, 72, 72, 79};
	assert_int_equal(site->n_run, 4);
	for (size_t r = 0; r < 4; r++) {
		assert_near(site->run[r].speed, speed[r], 1e-9);
		assert_int_equal(site->run[r].feed.n, 6);
		assert_near(site->run[r].feed.passing[1], 0.6, 1e-12);
	}
	assert_string_equal(site->run[0].repeat, "");
	assert_string_equal(site->run[1].repeat, " (1)");
	assert_string_equal(site->run[2].repeat, " (2)");
	assert_near(site->run[1].product.passing[1], 0.88, 1e-12);
	assert_near(site->run[2].product.passing[1], 0.9, 1e-12);
	assert_false(site->individual_feeds);
	assert_int_equal(site->digest, site_digest(site));
	/* The slowest and the fastest are trained on. */
	const bool *train = session_current_site_entry(desk->session)->train;
	assert_true(train[0] && !train[1] && !train[2] && train[3]);
	assert_string_equal(site->note[0].key, "cut");
	assert_string_equal(site->note[0].value, "79 m/s, 2026-05-03, cut.csv");
}

static void
a_feed_alone_becomes_that_of_the_cuts(void **state)
{
	struct desk *desk = *state;
	char *feed = file("feed.csv", "size_mm,feed\n16,100\n8,60\n4,30\n2,15\n"
				      "1,8\n0.5,4\n");
	desk_expect(desk, "reset");
	say(desk, "load %s", feed);
	say(desk, "add %s/cut.csv@70 %s/cut.csv@75", folder, folder);
	const struct site *site = site_of(desk);
	assert_int_equal(site->n_run, 2);
	assert_int_equal(site_count_products(site), 2);
	assert_near(site->run[0].speed, 70, 1e-9);
	assert_int_equal(site->run[0].feed.n, 6);
	free(feed);
}

static void
a_feed_of_its_own_is_kept_and_told(void **state)
{
	struct desk *desk = *state;
	char *own = file("own.csv",
	    "size_mm,feed,product\n16,100,100\n8,50,89\n4,25,60\n2,12,31\n");
	fresh(desk);
	say(desk, "add %s@78", own);
	const struct site *site = site_of(desk);
	assert_true(site->individual_feeds);
	assert_near(site->run[0].feed.passing[1], 0.6, 1e-12);
	assert_near(site->run[1].feed.passing[1], 0.5, 1e-12);
	assert_noted(desk, "up to 10.0 points");
	free(own);
}

static const char VARIED[] = "size_mm,feed@69,product@69,feed@79,product@79\n"
			     "16,100,100,100,100\n8,60,88,50,89\n"
			     "4,30,62,24,61\n2,15,33,12,34\n1,8,17,6,18\n"
			     "0.5,4,9,3,10\n";

/* It is judged by what predict says, which has the mean of the feeds. */
static void
a_cut_without_a_feed_has_the_mean(void **state)
{
	struct desk *desk = *state;
	char *varied = file("varied.csv", VARIED);
	desk_expect(desk, "reset");
	say(desk, "load %s", varied);
	desk_expect(desk, "params set f_mat=0.8 e0_min=18 alpha=0.9");
	say(desk, "add %s/cut.csv@72; add %s/cut.csv@79", folder, folder);
	assert_noted(desk, "feed: mean of those sampled at 69, 79 m/s");
	const struct entry *entry = session_current_site_entry(desk->session);
	const struct site *site = entry->site;
	const struct psd *mean = site_feed_of_run(site, SITE_MEAN_FEED);
	const bool lacks[] = {false, true, false, true};
	assert_near(mean->passing[1], 0.55, 1e-12);
	for (size_t r = 0; r < site->n_run; r++) {
		assert_int_equal(site->run[r].lacks_feed, lacks[r]);
		assert_int_equal(
		    psd_is_same(&site->run[r].feed, mean), lacks[r]);
	}
	struct prediction is =
	    forecast_whole_product(desk->session, entry, 72, SITE_MEAN_FEED);
	struct cut cut = cut_compare_with_prediction(desk->session, entry, 1);
	size_t worst = 0;
	for (size_t i = 0; i < is.product.n; i++)
		if (is.product.size[i] == cut.worst_sieve)
			worst = i;
	assert_near(cut.worst,
	    is.product.passing[worst] -
		psd_passing_at_sieve(&site->run[1].product, cut.worst_sieve),
	    1e-12);
	prediction_free(&is);
	free(varied);
}

/* Also after a feed was mended, and when it is read again. */
static void
the_mean_of_a_cut_follows_the_feeds(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "reset");
	say(desk, "load %s/varied.csv", folder);
	say(desk, "add %s/cut.csv@72; add %s/cut.csv@79", folder, folder);
	assert_false(desk_say(desk, "mend feed@72 sieve=8 value=70"));
	desk_expect(desk, "mend feed@79(1) sieve=8 value=40");
	const struct site *site = site_of(desk);
	assert_near(site->run[1].feed.passing[1], 0.5, 1e-12);
	assert_near(site->run[3].feed.passing[1], 0.5, 1e-12);
	uint64_t digest = site->digest;
	say(desk, "write %s/mean.csv", folder);
	say(desk, "load %s/mean.csv", folder);
	site = site_of(desk);
	assert_int_equal(site->digest, digest);
	assert_true(site->run[1].lacks_feed && site->run[3].lacks_feed);
	assert_false(site->run[0].lacks_feed || site->run[2].lacks_feed);
	assert_int_equal(site->n_note, 2);
}

static void
parameters_and_fit_stay_and_are_compared(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "reset");
	desk_expect(desk, "load data/sites/tierp.csv");
	desk_expect(desk, "calibrate seed=1");
	const struct entry *entry = session_current_site_entry(desk->session);
	struct params before = entry->params;
	assert_int_equal(cut_compare_runs_since_fit(desk->session, entry).n, 0);
	desk_expect(desk, "add data/cuts/tierp-72.csv@72");
	entry = session_current_site_entry(desk->session);
	assert_true(entry->has_fit);
	assert_memory_equal(&before, &entry->params, sizeof before);
	assert_noted(
	    desk, "as expected: 33.0 % passes 2 mm at 72 m/s, predicted 32.8");
	assert_noted(desk, "of 11 sieves are within the range for a belt cut");
	struct cut cut = cut_compare_with_prediction(desk->session, entry, 1);
	assert_int_equal(cut.n, 11);
	assert_true(cut.rms < 0.01 && cut.rms > 0);
	assert_false(cut.missed);
	struct later later = cut_compare_runs_since_fit(desk->session, entry);
	assert_int_equal(later.n, 1);
	assert_near(later.speed, 72, 1e-9);
	assert_false(later.missed);
	assert_noted(desk, "next: 'calibrate' includes it in the answers");
	desk_expect(desk, "add data/cuts/tierp-72.csv@72");
	entry = session_current_site_entry(desk->session);
	assert_true(cut_compare_runs_since_fit(desk->session, entry).twice);
	assert_noted(desk, "next: 'undo', unless two samples");
	desk_expect(desk, "undo");
	entry = session_current_site_entry(desk->session);
	assert_false(cut_compare_runs_since_fit(desk->session, entry).twice);
	desk_expect(desk, "add data/cuts/tierp-72.csv@90");
	assert_noted(desk, "it lies outside the training speeds, 69 to 79");
	desk_expect(desk, "undo");
	entry = session_current_site_entry(desk->session);
	/* New runs are held out until calibrate takes them. */
	assert_true(entry->train[0] && !entry->train[1] && entry->train[3]);
	desk_expect(desk, "calibrate train=all seed=1");
	entry = session_current_site_entry(desk->session);
	assert_true(entry->train[1]);
	assert_int_equal(cut_compare_runs_since_fit(desk->session, entry).n, 0);
}

static void
a_cut_that_is_missed_turns_the_light(void **state)
{
	struct desk *desk = *state;
	char *off = file("off.csv", "size_mm,passing\n16,98\n11.2,94\n8,85\n"
				    "5.6,68\n4,50\n2,25\n1,13\n0.5,6\n");
	desk_expect(desk, "reset");
	desk_expect(desk, "load data/sites/tierp.csv");
	desk_expect(desk, "calibrate seed=1");
	say(desk, "add %s@74.5", off);
	assert_noted(desk, "warning: not as expected: 25.0 % passes 2 mm");
	assert_noted(desk, "if they are right, 'calibrate train=all'");
	fflush(desk->out_file);
	size_t n = desk->n_out;
	desk_expect(desk, "predict 74");
	assert_non_null(strstr(desk->out + n, "trust: red: the cut at 74.5"));
	desk_expect(desk, "undo");
	n = desk->n_out;
	desk_expect(desk, "predict 74");
	assert_non_null(strstr(desk->out + n, "trust: green"));
	free(off);
}

static void
undo_takes_a_cut_back(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	const struct site *before = site_of(desk);
	say(desk, "add %s/cut.csv@79", folder);
	assert_int_equal(site_of(desk)->n_run, 2);
	desk_expect(desk, "undo");
	assert_ptr_equal(site_of(desk), before);
	desk_expect(desk, "redo");
	assert_int_equal(site_of(desk)->n_run, 2);
}

static void
a_written_site_is_the_same(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	say(desk, "add %s/cut.csv@79 date=2026-05-03", folder);
	say(desk, "add %s/cut.csv@79", folder);
	assert_noted(desk, "was the cut added before?");
	uint64_t digest = site_of(desk)->digest;
	say(desk, "write %s/copy.csv", folder);
	say(desk, "load %s/copy.csv", folder);
	const struct site *site = site_of(desk);
	assert_int_equal(site->digest, digest);
	assert_int_equal(site->n_note, 2);
	assert_string_equal(site->note[0].value, "79 m/s, 2026-05-03, cut.csv");
}

/* Runs the saved session in an empty one. */
static void
replay(struct desk *desk)
{
	char *saved = xasprintf("%s/saved/s.tip", folder), line[500];
	FILE *in = fopen(saved, "r");
	assert_non_null(in);
	desk_expect(desk, "reset");
	while (fgets(line, sizeof line, in) != NULL) {
		line[strcspn(line, "\n")] = '\0';
		desk_expect(desk, line);
	}
	fclose(in);
	free(saved);
}

static void
a_saved_session_adds_again_and_notices_changes(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	say(desk, "add %s/cut.csv@79 date=2026-05-03", folder);
	uint64_t digest = site_of(desk)->digest;
	say(desk, "save %s/saved/s.tip replace=on", folder);
	replay(desk);
	assert_int_equal(site_of(desk)->digest, digest);
	fresh(desk);
	char *wrong = xasprintf("add %s/cut.csv@78 digest=%016llx", folder,
	    (unsigned long long)digest);
	assert_false(desk_say(desk, wrong));
	assert_non_null(strstr(desk->error.text, "digest"));
	assert_int_equal(site_of(desk)->n_run, 1);
	free(wrong);
}

static void
what_is_missing_is_asked_for(void **state)
{
	static const struct {
		const char *call, *error, *hint;
	} CASE[] = {{"", "its tip speed", "@SPEED"},
	    {"@fast", "expected a tip speed or a time", "@72"},
	    {"@10:15", "expected a day", "date="},
	    {"@2026-05-03T10:15", "expected a log", "as=log"},
	    {"@5/3/2026T10:15", "read in one way", "@2026"},
	    {"@79 date=5/3/2026", "read in one way", "date=2026"},
	    {"@79 date=2026-02-29", "expected a date", "date=2026"}};
	struct desk *desk = *state;
	char *feed = file("feedonly.csv", "size_mm,feed\n16,100\n8,60\n4,30\n");
	desk_expect(desk, "reset");
	assert_false(desk_say(desk, "add cut.csv@72"));
	fresh(desk);
	for (size_t i = 0; i < ARRAY_LEN(CASE); i++) {
		char *line =
		    xasprintf("add %s/cut.csv%s", folder, CASE[i].call);
		if (desk_say(desk, line) ||
		    strstr(desk->error.text, CASE[i].error) == NULL ||
		    strstr(desk->error.hint, CASE[i].hint) == NULL)
			fail_msg("%s: %s (%s)", line, desk->error.text,
			    desk->error.hint);
		assert_int_equal(site_of(desk)->n_run, 1);
		free(line);
	}
	char *line = xasprintf("add %s@79", feed);
	assert_false(desk_say(desk, line));
	assert_non_null(strstr(desk->error.text, "expected a product"));
	free(line);
	free(feed);
}

static void
one_product_checks_recalled_parameters(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	desk_expect(desk, "recall table3/tierp");
	fflush(desk->out_file);
	size_t n = desk->n_out;
	desk_expect(desk, "predict 78");
	assert_non_null(strstr(desk->out + n, "the cut at 72 m/s"));
	assert_non_null(strstr(desk->out + n, "points (5 sieves)"));
	say(desk, "add %s/cut.csv@79", folder);
	n = desk->n_out;
	desk_expect(desk, "predict 78");
	assert_null(strstr(desk->out + n, "(5 sieves)"));
}

/* Dates, and how they are read in either order. */
static const struct {
	const char *text, *day_first, *month_first;
} DATES[] = {{"2026-05-03T10:15", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"2026-05-03 10:15:30", "2026-05-03 10:15:30", "2026-05-03 10:15:30"},
    {"2026-05-03T10:15:00.000Z", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"2026-05-03T10:15+02:00", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"2026/05/03 0:05", "2026-05-03 00:05", "2026-05-03 00:05"},
    {"03.05.2026 10:15:00", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"3.5.2026 10.15", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"5/3/2026 10:15 AM", "2026-03-05 10:15", "2026-05-03 10:15"},
    {"5/3/2026 12:15 am", "2026-03-05 00:15", "2026-05-03 00:15"},
    {"5/3/2026 1:15:10 p.m.", "2026-03-05 13:15:10", "2026-05-03 13:15:10"},
    {"25/3/2026 10:15", "2026-03-25 10:15", "2026-03-25 10:15"},
    {"3/25/2026 10:15", "2026-03-25 10:15", "2026-03-25 10:15"},
    {"5/5/2026 10:15", "2026-05-05 10:15", "2026-05-05 10:15"},
    {"03-05-2026 10:15", "2026-05-03 10:15", "2026-03-05 10:15"},
    {"3 May 2026 10:15", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"May 3, 2026 10:15 AM", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"Maj 3 2026 10:15", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"3/5-2026 10:15", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"3/5 2026", "2026-05-03 00:00", "2026-05-03 00:00"},
    {"03-maj-26 10:15:00", "2026-05-03 10:15", "2026-05-03 10:15"},
    {"2024-02-29", "2024-02-29 00:00", "2024-02-29 00:00"},
    {"2000-12-31 23:59", "2000-12-31 23:59", "2000-12-31 23:59"}};

static void
dates_are_read_in_one_way_or_not_at_all(void **state)
{
	static const char *const NONE[] = {"", "72", "72.5", "2026-02-29",
	    "31.4.2026", "5/3/26", "03.05.26 10:15", "2026-13-01",
	    "2026-05-03 25:00", "2026-05-03 10:61", "10:15 x", "hello", "1.5.2",
	    "2026-05-03 10:15 and so on", "13/13/2026", "1,250", "12-2026",
	    "May 2026", "May 3, 26", "5/13-2026", "3-5/2026", "3.5 2026"};
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(DATES); i++) {
		struct datetime m;
		if (!datetime_parse(DATES[i].text, &m))
			fail_msg("%s is not read", DATES[i].text);
		FREED char *a = datetime_to_text(
		    datetime_seconds_since_1970(&m, DATETIME_DAY_FIRST));
		FREED char *b = datetime_to_text(
		    datetime_seconds_since_1970(&m, DATETIME_MONTH_FIRST));
		assert_string_equal(a, DATES[i].day_first);
		assert_string_equal(b, DATES[i].month_first);
		bool open = strcmp(a, b) != 0;
		assert_true(open == isnan(datetime_seconds_since_1970(
					&m, DATETIME_OPEN)));
	}
	for (size_t i = 0; i < ARRAY_LEN(NONE); i++) {
		struct datetime m;
		if (datetime_parse(NONE[i], &m))
			fail_msg("%s is read", NONE[i]);
	}
}

/* Reads a text as a log; NULL with the first fault in *error. */
static struct plant_log *
read_log(const char *text, const char *columns, char decimal,
    enum datetime_order order, struct error *error)
{
	char *path = file("log.csv", text);
	const char *const paths[] = {path};
	struct log_request q = {1, paths, columns, NULL, decimal, order};
	struct error_list errors = {0};
	bool open;
	struct plant_log *log = plant_log_read(&q, &errors, &open);
	*error = errors.item[0];
	assert_true((log == NULL) == (errors.n > 0));
	free(path);
	return log;
}

/* A log with three rows, at 10:00, 10:01 and 10:02. */
static const struct {
	const char *text, *columns;
	char decimal;
	enum datetime_order order;
} LOGS[] = {{"time,rpm,kW,t/h\n2026-05-03T10:00,1350,180,120\n"
	     "2026-05-03T10:01,1360,187.5,121\n"
	     "2026-05-03T10:02,1370,190,122\n",
		NULL, 0, DATETIME_OPEN},
    {"Zeit;Drehzahl;Leistung [kW];Durchsatz t/h\n"
     "03.05.2026 10:00:00;1.350;180,0;120\n"
     "03.05.2026 10:01:00;1.360;187,5;121\n"
     "03.05.2026 10:02:00;1.370;190,0;122\n",
	NULL, 0, DATETIME_OPEN},
    {"Datum;Tid;Effekt kW;Varvtal;Kapacitet\n"
     "2026-05-03;10:02;190;1370;122\n2026-05-03;10:01;187,5;1360;121\n"
     "2026-05-03;10:00;180;1350;120\n",
	NULL, 0, DATETIME_OPEN},
    {"Exported 2026-05-04 08:00\nDate\tRotor speed\tMotor power\t"
     "Feed rate\tFeeder speed\n\trpm\tkW\tt/h\t%\n"
     "5/3/2026 10:00 AM\t1350\t180\t120\t40\n"
     "5/3/2026 10:01 AM\t1360\t187.5\t121\t41\n"
     "No Data\tBad\tBad\tBad\tBad\n"
     "5/3/2026 10:02 AM\t1370\t190\t122\t42\n",
	NULL, 0, DATETIME_MONTH_FIRST},
    {"Timestamp,A,B,C\n03-May-26 10:00:00,1350,180,120\n"
     "03-May-26 10:01:00,1360,187.5,121\n"
     "03-May-26 10:02:00,1370,190,122\n",
	"1=time, 2=rpm, 3=kW, 4=t/h", 0, DATETIME_OPEN},
    {"Time,Rotor rpm,Apparent power kVA,Power factor,Motor power MW,"
     "Feed rate %,Feed rate setpoint t/h,Feed rate t/d\n"
     "2026-05-03 10:00,1350,211,0.85,0.18,48,150,2880\n"
     "2026-05-03 10:01,1360,220,0.85,0.1875,48,150,2904\n"
     "2026-05-03 10:02,1370,223,0.85,0.19,49,150,2928\n",
	NULL, 0, DATETIME_OPEN},
    {"Time,Rotor rpm,Motor power,Feed kg/h,Specific power kWh/t\n,,W,,\n"
     "2026-05-03 10:00,1350,180000,120000,1.5\n"
     "2026-05-03 10:01,1360,187500,121000,1.55\n"
     "2026-05-03 10:02,1370,190000,122000,1.56\n",
	NULL, 0, DATETIME_OPEN},
    {"Time,Rotor rpm,Power A/B,Throughput tonnes/hr,Water kg/h\n"
     "2026-05-03 10:00,1350,180,120,900\n"
     "2026-05-03 10:01,1360,187.5,121,900\n"
     "2026-05-03 10:02,1370,190,122,900\n",
	NULL, 0, DATETIME_OPEN},
    {"Time,Rotor rpm,Motor 1/2 effekt,Throughput t/h (short head)\n"
     "2026-05-03 10:00,1350,180,120\n"
     "2026-05-03 10:01,1360,187.5,121\n"
     "2026-05-03 10:02,1370,190,122\n",
	NULL, 0, DATETIME_OPEN}};

static void
logs_of_several_programs_say_the_same(void **state)
{
	(void)state;
	struct datetime m;
	assert_true(datetime_parse("2026-05-03 10:01", &m));
	double at = datetime_seconds_since_1970(&m, DATETIME_OPEN);
	for (size_t i = 0; i < ARRAY_LEN(LOGS); i++) {
		struct error e;
		struct plant_log *log = read_log(LOGS[i].text, LOGS[i].columns,
		    LOGS[i].decimal, LOGS[i].order, &e);
		if (log == NULL)
			fail_msg("%s: %s", LOGS[i].text, e.text);
		assert_int_equal(log->n, 3);
		assert_near(log->time[1], at, 1e-6);
		assert_near(log->apart, 60, 1e-6);
		struct log_window w =
		    plant_log_summarise_window(log, at - 30, at + 30);
		assert_int_equal(w.n, 1);
		assert_near(w.median[LOG_RPM], 1360, 1e-9);
		assert_near(w.median[LOG_POWER], 187.5, 1e-9);
		assert_near(w.median[LOG_RATE], 121, 1e-9);
		w = plant_log_summarise_window(log, at - 60, at + 60);
		assert_int_equal(w.n, 3);
		assert_near(w.least[LOG_RPM], 1350, 1e-9);
		assert_near(w.most[LOG_RPM], 1370, 1e-9);
		plant_log_free(log);
	}
}

static void
a_log_tells_what_is_converted_or_left_out(void **state)
{
	(void)state;
	struct error e;
	struct plant_log *log = read_log(
	    "Time,rpm,MW power,Feed rate m3/h,Throughput short tons/h\n"
	    "2026-05-03 10:00,1350,0.18,80,120\n",
	    NULL, 0, DATETIME_OPEN, &e);
	assert_non_null(log);
	assert_string_equal(log->read_as,
	    "time in column 1, rpm in 2, kW in 3 (* 1000), t/h in 5 (* "
	    "0.9072), not column 4");
	plant_log_free(log);
}

static void
logs_that_are_open_are_refused(void **state)
{
	static const struct {
		const char *text, *error, *hint;
	} CASE[] = {{"time,rpm\n5/3/2026 10:00,1350\n5/3/2026 10:01,1350\n",
			"day or month first", "dates=day-first"},
	    {"time,rpm\n25/3/2026 10:00,1350\n3/26/2026 10:01,1350\n",
		"expected dates with the day first", ""},
	    {"time,rpm\n2026-05-03,1350\n2026-05-04,1350\n",
		"expected times of day", ""},
	    {"n,rpm\n1,1350\n2,1350\n", "a column of dates and times", ""},
	    {"time,a\n2026-05-03 10:00,1350\n", "headings that name",
		"columns="},
	    {"time,speed\n2026-05-03 10:00,65\n", "rpm or m/s", "columns="},
	    {"time,motor 1 kW,motor 2 kW\n2026-05-03 10:00,65,66\n",
		"expected one column of kW", "columns="},
	    {"time;rpm\n2026-05-03 10:00;1,350\n", "read in one way",
		"decimal="}};
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(CASE); i++) {
		struct error e;
		struct plant_log *log =
		    read_log(CASE[i].text, NULL, 0, DATETIME_OPEN, &e);
		if (log != NULL || strstr(e.text, CASE[i].error) == NULL ||
		    strstr(e.hint, CASE[i].hint) == NULL)
			fail_msg("%s: %s (%s)", CASE[i].text, e.text, e.hint);
	}
}

static void
dates_of_one_order_settle_the_others(void **state)
{
	(void)state;
	struct error e;
	struct datetime m;
	struct plant_log *log = read_log(
	    "time,kW 1,kW 2\n12/3/2026 23:59,90,95\n13/3/2026 0:00,91,96\n",
	    "1=time,2=kW,3=kW", 0, DATETIME_OPEN, &e);
	assert_non_null(log);
	assert_true(datetime_parse("2026-03-12 23:59", &m));
	assert_near(
	    log->time[0], datetime_seconds_since_1970(&m, DATETIME_OPEN), 1e-6);
	/* Two motors of one rotor add up. */
	assert_near(log->value[LOG_POWER][0], 185, 1e-9);
	plant_log_free(log);
}

static void
a_log_gives_the_speed_of_a_cut(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	desk_expect(desk, "load data/cuts/log.csv as=log");
	assert_noted(desk, "log: 121 rows from 2026-05-03 09:30 to 11:30");
	say(desk, "add %s/cut.csv@2026-05-03T10:15 rotor_mm=900", folder);
	const struct site *site = site_of(desk);
	/* pi 0.9 m 1528 / 60 s, to a tenth. */
	assert_near(site->run[1].speed, 72.0, 1e-9);
	assert_near(site->rotor, 0.9, 1e-12);
	assert_string_equal(site->note[0].value,
	    "72 m/s, 2026-05-03 10:15, 188 kW, 119 t/h, cut.csv");
	say(desk, "add %s/cut.csv@10:45 date=2026-05-03", folder);
	assert_noted(desk, "warning: rpm changed from");
	char *late = xasprintf("add %s/cut.csv@2026-05-03T15:00", folder);
	assert_false(desk_say(desk, late));
	assert_non_null(strstr(desk->error.text, "no row within"));
	free(late);
	desk_expect(desk, "show log");
	desk_expect(desk, "undo");
	desk_expect(desk, "undo");
	desk_expect(desk, "undo");
	assert_false(desk_say(desk, "show log"));
}

static size_t asked;

/* A first answer that is none is asked again. */
static char *
answer(struct session *s, const struct user_question *q)
{
	(void)s;
	asked++;
	if (strstr(q->text, "tip speed") != NULL)
		return xstrdup("79");
	assert_string_equal(q->text, "is it day or month first");
	return xstrdup(q->wrong[0] == '\0' ? "5" : " month");
}

static void
somebody_is_asked_once(void **state)
{
	struct desk *desk = *state;
	char *log = file("log.csv", "time,m/s\n5/3/2026 10:00,70\n"
				    "5/3/2026 10:01,71\n5/3/2026 10:02,70.5\n");
	fresh(desk);
	desk->session->hooks.ask = answer;
	asked = 0;
	say(desk, "add %s/cut.csv", folder);
	assert_int_equal(asked, 1);
	assert_near(site_of(desk)->run[1].speed, 79, 1e-9);
	say(desk, "load %s as=log", log);
	assert_int_equal(asked, 3);
	say(desk, "add %s/cut.csv@2026-05-03T10:01", folder);
	assert_near(site_of(desk)->run[0].speed, 70.5, 1e-9);
	uint64_t digest = site_of(desk)->digest;
	say(desk, "save %s/saved/s.tip replace=on", folder);
	desk->session->hooks.ask = NULL;
	replay(desk);
	assert_int_equal(site_of(desk)->digest, digest);
	free(log);
}

static int
make_files(void **state)
{
	(void)state;
	assert_non_null(mkdtemp(folder));
	/* A script in a folder of its own has whole paths. */
	FREED char *saved = xasprintf("%s/saved", folder);
	assert_int_equal(mkdir(saved, 0700), 0);
	free(file("site.csv", FEED));
	free(file("cut.csv", CUT));
	return 0;
}

static int
remove_files(void **state)
{
	(void)state;
	static const char *const NAMES[] = {"site.csv", "cut.csv", "feed.csv",
	    "own.csv", "off.csv", "copy.csv", "saved/s.tip", "feedonly.csv",
	    "log.csv", "varied.csv", "mean.csv"};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		char *path = xasprintf("%s/%s", folder, NAMES[i]);
		unlink(path);
		free(path);
	}
	FREED char *saved = xasprintf("%s/saved", folder);
	rmdir(saved);
	rmdir(folder);
	return 0;
}

/* Adds a cut at a speed from a sheet that states a date above its table. */
static void
add_dated(struct desk *desk, const char *date, double speed)
{
	char *text = xasprintf("Date,%s\n%s", date, CUT);
	char *path = file("dated.csv", text);
	say(desk, "add %s@%g", path, speed);
	free(text);
	free(path);
}

static void
the_date_of_a_sheet_is_taken(void **state)
{
	struct desk *desk = *state;
	fresh(desk);
	add_dated(desk, "2026-05-04", 70);
	assert_noted(desk, "added a cut: 70 m/s, 2026-05-04, dated.csv");
	add_dated(desk, "14 May 2026", 71);
	assert_noted(desk, "added a cut: 71 m/s, 2026-05-14, dated.csv");
	char *path =
	    file("note.csv", "provenance,lab\ncut,\"74 m/s, 2026-05-09\"\n"
			     "size_mm,product@74\n16,100\n8,90\n4,66\n");
	say(desk, "add %s", path);
	assert_noted(desk, "added a cut: 74 m/s, 2026-05-09, note.csv");
	free(path);
}

/* A sheet that is known by its day alone also has the cuts of later days. */
static void
the_days_of_cuts_are_in_the_provenance(void **state)
{
	struct desk *desk = *state;
	char *text = xasprintf("Date,2026-05-02\n%s", FEED);
	char *path = file("sheet.csv", text);
	desk_expect(desk, "reset");
	say(desk, "load %s", path);
	assert_string_equal(site_of(desk)->provenance, "sheet of 2026-05-02");
	add_dated(desk, "14 May 2026", 70);
	add_dated(desk, "2026-05-04", 71);
	assert_string_equal(site_of(desk)->provenance,
	    "sheet of 2026-05-02, cuts to 2026-05-14");
	add_dated(desk, "2026-05-21", 73);
	assert_string_equal(site_of(desk)->provenance,
	    "sheet of 2026-05-02, cuts to 2026-05-21");
	assert_string_equal(
	    site_data_kind(site_of(desk)->provenance), "not stated");
	unlink(path);
	free(path);
	free(text);
}

/* Judged at the sieve that predict names, although the cut has others. */
static void
a_cut_is_judged_at_the_sieve_of_predict(void **state)
{
	struct desk *desk = *state;
	char *path = file("astm.csv", "size_mm,passing\n16,100\n8,90\n"
				      "4.75,71\n2.36,41\n1.18,22\n0.6,12\n");
	fresh(desk);
	desk_expect(desk, "params set f_mat=0.8 e0_min=18 alpha=0.9");
	say(desk, "add %s@72", path);
	assert_noted(desk, "% passes 2 mm at 72 m/s (2), predicted");
	unlink(path);
	free(path);
}

/* Never in silence, and never by chance. */
static void
a_date_of_two_readings_is_settled_or_said(void **state)
{
	struct desk *desk = *state;
	setenv("SOURCE_DATE_EPOCH", "1795737600", 1); /* 2026-11-27 */
	fresh(desk);
	add_dated(desk, "05/11/2026", 70);
	assert_noted(desk, "added a cut: 70 m/s, dated.csv");
	assert_noted(
	    desk, "can be 2026-11-05 or 2026-05-11, so the cut has none");
	add_dated(desk, "12/11/2026", 71);
	assert_noted(desk, "added a cut: 71 m/s, 2026-11-12, dated.csv");
	assert_noted(desk, "as the other reading is in the future");
	assert_false(desk_say(desk, "add cut.csv@72 date=05/11/2026"));
	assert_non_null(
	    strstr(desk->error.hint, "date=2026-11-05 or date=2026-05-11"));
	char *two =
	    file("two.csv", "provenance,lab\ncut,\"72 m/s, 10/4/2026\"\n"
			    "cut,\"73 m/s, 10/25/2026\"\n"
			    "size_mm,product@72,product@73\n"
			    "16,100,100\n8,90,91\n4,66,67\n");
	say(desk, "add %s", two);
	assert_noted(desk, "added a cut: 72 m/s, 2026-10-04, two.csv");
	assert_noted(desk, "read as 2026-10-04, as its other dates show");
	add_dated(desk, "05/11/2026", 75);
	assert_noted(desk, "added a cut: 75 m/s, 2026-05-11, dated.csv");
	assert_noted(desk, "as the dates of earlier cuts show");
	say(desk, "add %s/cut.csv@76 date=05/11/2026", folder);
	assert_noted(desk, "added a cut: 76 m/s, 2026-05-11, cut.csv");
	unsetenv("SOURCE_DATE_EPOCH");
	free(two);
}

#define AT_DESK(f) cmocka_unit_test_setup_teardown(f, desk_open, desk_close)

int
main(void)
{
	chdir_to_source();
	const struct CMUnitTest tests[] = {
	    AT_DESK(cuts_stand_in_order_of_speed),
	    AT_DESK(a_feed_alone_becomes_that_of_the_cuts),
	    AT_DESK(a_feed_of_its_own_is_kept_and_told),
	    AT_DESK(a_cut_without_a_feed_has_the_mean),
	    AT_DESK(the_mean_of_a_cut_follows_the_feeds),
	    AT_DESK(parameters_and_fit_stay_and_are_compared),
	    AT_DESK(a_cut_that_is_missed_turns_the_light),
	    AT_DESK(undo_takes_a_cut_back),
	    AT_DESK(a_written_site_is_the_same),
	    AT_DESK(a_saved_session_adds_again_and_notices_changes),
	    AT_DESK(what_is_missing_is_asked_for),
	    AT_DESK(one_product_checks_recalled_parameters),
	    cmocka_unit_test(dates_are_read_in_one_way_or_not_at_all),
	    cmocka_unit_test(logs_of_several_programs_say_the_same),
	    cmocka_unit_test(a_log_tells_what_is_converted_or_left_out),
	    cmocka_unit_test(logs_that_are_open_are_refused),
	    cmocka_unit_test(dates_of_one_order_settle_the_others),
	    AT_DESK(a_log_gives_the_speed_of_a_cut),
	    AT_DESK(somebody_is_asked_once),
	    AT_DESK(the_date_of_a_sheet_is_taken),
	    AT_DESK(the_days_of_cuts_are_in_the_provenance),
	    AT_DESK(a_cut_is_judged_at_the_sieve_of_predict),
	    AT_DESK(a_date_of_two_readings_is_settled_or_said),
	};
	return cmocka_run_group_tests(tests, make_files, remove_files);
}
