/* Site files: what is accepted, what is refused and how that is told, and that
 * a written site reads back to the same bits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "sheets.h"

#include <math.h>

/* One sheet a line: where the first fault is, and parts of text and hint. */
static const struct {
	const char *sheet;
	int line, column;
	const char *text, *hint;
} FAULTS[] = {
    {TOP "8,100,100,100\n4,60,62,90\n1,10,71,30\n", 4, 6,
	"passing rises from 62 to 71 at 1 mm (finer sieve, more passing)",
	"check this row"},
    {TOP "8,100,101,100\n4,60,80,90\n", 2, 7, "0 to 100 %", "check"},
    {TOP "8,100,100,100\n4,-1,80,90\n", 3, 3, "got '-1'", "check"},
    {TOP "8,100,1,100\n4,60,0.8,90\n", 1, 14,
	"what column 3 is, got 'product@69' above 1 0.8",
	"columns=\"1=sieve mm, 2=feed passing_pct, 3=product@69 fraction"},
    {"size_mm,feed,product_fraction@69,product@79\n8,100,1,100\n4,60,80,90\n"
     "1,10,20,30\n",
	3, 6, "fraction", "change the column heading to product@69"},
    {TOP "8,100,100,100\n4,60,80,90\n4,10,20,30\n", 4, 1,
	"duplicate sieve: 4 is already in line 3", "correct"},
    {TOP "8,100,100,100\n1,10,20,30\n4,10,20,30\n", 4, 1,
	"coarsest first, got 4 after 1", "sort"},
    {TOP "8,100,100,100\n-4,60,80,90\n", 3, 1, "positive size", "write pan"},
    {TOP "8,100,100,100\n#3,60,80,90\n", 3, 1, "a sieve of ASTM E11, got '#3'",
	"1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)"},
    {TOP "8,100,100,100\n#5,60,80,90\n4,60,80,90\n", 4, 1,
	"duplicate sieve: 4 is already in line 3", "remove one"},
    {TOP "99999,100,100,100\n4,60,80,90\n", 2, 1, "1e4 mm", "unit"},
    {TOP "22.4,99.5,100,100\n4,60,80,90\n", 2, 6, "22.4 mm, passes 99.5 %",
	"top=31.5"},
    {TOP "90,99.5,100,100\n4,60,80,90\n", 2, 4, "90 mm, passes 99.5 %",
	"top=125"},
    {"size_mm,product@69,product@79\n8,100,100\n4,80,90\n", 1, 1, "feed",
	"add a column feed"},
    {"size_mm,feed,product,product@79\n" ROWS, 1, 14,
	"what column 3 is, and its tip speed",
	"3=product@SPEED passing_pct, 4=product@79"},
    {"size_mm,feed,product@,product@79\n" ROWS, 1, 14, "tip speed", "@"},
    {"size_mm,feed,product@fast,product@79\n" ROWS, 1, 14, "product@fast", "@"},
    {"size_mm,feed,product@-69,product@79\n" ROWS, 1, 14, "what column 3 is",
	"@"},
    {"size_mm,feed,product@74 approx 75,product@79\n" ROWS, 1, 14,
	"what column 3 is", "columns="},
    {"size_mm,feed,product@74 (approx 75),product@79\n" ROWS, 1, 14,
	"what column 3 is", "columns="},
    {"size_mm,feed,product 74 m/s or 75,product@79\n" ROWS, 1, 14,
	"what column 3 is", "columns="},
    {"size_mm,feed,product 74 m/s 75,product@79\n" ROWS, 1, 14,
	"what column 3 is", "columns="},
    {"size_mm,feed,product@401,product@79\n" ROWS, 1, 14, "its tip speed",
	"@SPEED"},
    {"Class,Feed %,69 m/s %,79 m/s %\n<16 mm,0,0,0\n<8 mm,60,30,20\n"
     "<4 mm,25,50,60\n<1 mm,10,15,15\npan,5,5,5\n",
	1, 7, "what column 2 is", "2=feed retained_pct"},
    {"mm,Feed %,66 m/s %,72 m/s %\n" ROWS "Tip speed m/s,,65,71\n", 5, 16,
	"what column 3 is", "3=product@SPEED"},
    {"Tip speed 65 m/s\nTip speed 71 m/s\nmm,Feed,S1,S2\n" ROWS, 3, 9,
	"what column 3 is", "3=product@SPEED"},
    {"Tip speed,65\nTip speed,71\nmm,Feed,S1,S2\n" ROWS, 3, 9,
	"what column 3 is", "3=product@SPEED"},
    {"Max tip speed 85 m/s\nmm,Feed,Product A,Product B\n" ROWS, 2, 9,
	"its tip speed", "3=product@SPEED"},
    {"size_mm,feed,product@79,retained_pct@79\n8,100,100,0\n4,60,80,5\n"
     "1,10,20,95\n",
	3, 9, "the same sample as column 3, got 80 % passing and 95 %",
	"which to read"},
    {"size_mm,feed@69,product@69,feed@79,feed@79,product@79\n"
     "8,100,100,100,100,100\n4,60,80,60,61,90\n",
	1, 36, "one feed@79, got 2", "in the same order"},
    {"size_mm,feed,product@69,product@79,product@79,product@79,sd@79,sd@79\n"
     "8,100,100,100,100,100,1,1\n4,60,80,90,91,92,1,1\n",
	1, 64, "one sd@79 or one for each product, got 2", "in the same order"},
    {"size_mm,feed,product (2),product@79\n" ROWS, 1, 14, "its tip speed",
	"product@SPEED"},
    {"size_mm,feed,siktrest@69,product@79\n" ROWS, 1, 14, "what column 3 is",
	"3=product@69 passing_pct"},
    {"size_mm,feed,product m/s,product@79\n" ROWS, 1, 14, "tip speed",
	"product@SPEED"},
    {"size_mm,feed,Passerande %,product@79\n" ROWS, 1, 14, "what column 3 is",
	"product@SPEED passing_pct"},
    {"size_mm,feed,siktrest g 69 m/s,product@79\n8,100,0,100\n4,60,3,90\n", 1,
	14, "pan", "last row"},
    {"Maskvidd;feed;product@69;product@79\n8;1;1;1\n", 1, 10,
	"what column 2 is", "1=sieve mm, 2=feed fraction"},
    {"size_mm,feed,feed,product@79\n" ROWS, 1, 14, "expected one feed", "keep"},
    {"size_mm,feed,feed@69,product@69,product@79\n8,100,100,100,100\n"
     "4,60,60,80,90\n",
	1, 14, "one kind of feed", "feed@"},
    {"size_mm,feed@69,product@69,product@79\n" ROWS, 1, 28,
	"a feed for product@79", "no speed above"},
    {"size_mm,feed,product@69,product@79,sd@74\n8,100,100,100,1\n"
     "4,50,60,60,1\n",
	1, 36, "a product for sd@74", "remove this one"},

    {TOP "8,100,100,100\n4,60,inf,90\n", 3, 6, "got 'inf'", "digits"},

    {TOP "8,100,100,100\n4,60,80 g,90\n", 3, 6, "got '80 g'", "header"},
    {"size_mm,feed_retained_g,product@69,product@79\n8,0 %,100,100\n"
     "4,60,80,90\npan,40,,\n",
	2, 3, "got '0 %'", "header"},
    {TOP "8,100,100,100\n4,60,wet,90\n", 3, 6, "number, got", "digits"},
    {TOP "8,100,100,100\n5,6,60,80,90\n", 3, 11, "expected 4 cells",
	"decimal commas"},
    {TOP "8,100,100,100\n4,60,\"1,250\",90\n", 3, 6, "0 to 100 %, got '1,250'",
	"check"},
    {TOP "8,100,100,100\n4,60.5,\"80,5\",90\n", 3, 8,
	"a decimal point as in other cells", "one decimal sign"},
    {TOP "8,100,100,100\n05-jun,60,80,90\n", 3, 1, "got '05-jun'",
	"into a date"},
    {"size_mm,feed,varvtal 1180,79 m/s\n" ROWS, 2, 1,
	"rpm without the rotor's diameter", "rotor_mm=DIAMETER"},
    {TOP "8,100,100,100\nsum,60,80,90\n1,10,20,30\n", 3, 1, "got 'sum'",
	"sums"},
    {TOP "8,100,100,100\n4,60,\"1,000.5\",90\n", 3, 6, "'1,000.5'", "check"},
    {TOP "8,100,100,100\n4,60,1 00,90\n", 3, 6, "'1 00'", "thousands"},
    {TOP "8,100,100,100\n4,60,1 000,90\n", 3, 6, "0 to 100 %", "number"},
    {"size_mm;feed;product@69;product@79\n8;100;100;100\n4;60,5;80.5;90\n", 3,
	8, "decimal comma", "one decimal sign"},
    {"size_mm;feed;product@69;product@79\n8;100;100;100\n4;60;8;90;5\n", 3, 11,
	"expected 4 cells", "remove the last cells"},
    {TOP "8,100,100,100\ntotal of it\n4,60,80,90\n1,10,20,30\n", 3, 1,
	"sieve size or pan, got 'total of it'", "sums"},
    {TOP "8,100,100,100\n,60,80,90\n", 3, 1, "got an empty cell", ""},
    {TOP "8,100,100,100\n4,,80,90\n", 1, 9, "2 or more sieves", "fill"},

    {TOP, 1, 1, "a row for each sieve", "add rows"},
    {"site,Tierp\n22.4,100,100\n16,95,97\n", 2, 1,
	"a table of sieves, got '22.4'", "size_mm,feed,product@69,product@79"},
    {"site,Tierp\nsize,feed,product@69\n", 2, 1, "got 'size'",
	"add rows such as"},
    {"# nothing\n", 1, 1, "a table of sieves", "size_mm,"},
    {"site;Tierp\nSil mm;Feed;P1;P2\n22,4;0,5;0,5;0,5\n16;1,5;2,5;2,5\n", 2, 8,
	"what column 2 is", "3=product@SPEED"},
    {"site;Tierp\n22,4;0,5;0,5\n16,5;1,5;2,5\n", 2, 1, "got '22,4'",
	"size_mm;feed"},
    {"size_mm,feed,product 1180 rpm,product@79\n" ROWS, 2, 1, "rpm without",
	"rotor_mm="},
    {"rotor_mm,840\nrotor_mm,900\nsize_mm,feed,product 1180 "
     "rpm,product@79\n" ROWS,
	4, 1, "got 840 mm in line 1 and 900 mm in line 2",
	"rotor_mm=840 or rotor_mm=900"},
    {"VSI with a rotor of 840 mm\nrotor,900\nsize_mm,feed,1180 rpm,79 "
     "m/s\n" ROWS,
	4, 1, "got 840 mm in line 1 and 900 mm in line 2",
	"rotor_mm=840 or rotor_mm=900"},
    {"rotor of 840 mm or rotor of 900 mm\nsize_mm,feed,1180 rpm,79 "
     "m/s\n" ROWS,
	3, 1, "got several in line 1", "rotor_mm=DIAMETER"},
    {"size_mm,feed,product@7.4e1,product@79\n" ROWS, 1, 14, "its tip speed",
	"3=product@SPEED"},
    {"Sieve mm,feed g,69 m/s g,79 m/s g\n16,0,0,0\n8,30,10,5\n4,32,31,25\n"
     "1,28,39,41\n",
	1, 17, "what column 3 is",
	"2=feed retained_g, 3=product@69 retained_g"},
    {"size_mm,feed,1350 rpm (63.6 m/s),1550 rpm (63 m/s)\n" ROWS, 1, 34,
	"63.6 m/s at 1350 rpm and 63 m/s at 1550 rpm", "leave out the rpm"},
    {"Sieve,feed,product@69\n1 1/2,100,100\n3/4 in,60,80\n3/8 in,40,60\n"
     "No. 4,10,20\n",
	2, 1, "sieve size or pan, got '1 1/2'", "write inches"},
    {"Sieve mm,feed g,69 m/s g\n16*,10,5\n8,30,20\n4,40,50\npan,20,25\n", 2, 1,
	"sieve size or pan, got '16*'", "number alone"},
    {"Quarry:,,A,B\n" TOP ROWS, 2, 14, "those of 'A' and 'B'", "3=product@69"},
    {"Crusher :,,1,2\nQuarry,,A,A\n" TOP ROWS, 3, 14, "those of '1' and '2'",
	"3=product@69"},
    {"Kross nr:,,1,2\n" TOP ROWS, 2, 14, "those of '1' and '2'",
	"3=product@69"},
    {"Quarry,,A,B\n\n" TOP ROWS, 1, 11, "end of the line",
	"above the headings"},
    {"Sample,Quarry,mm,passing\nfeed,A,8,100\nfeed,A,4,50\n70 m/s,A,8,100\n"
     "70 m/s,A,4,60\n79 m/s,B,8,100\n79 m/s,B,4,70\n",
	4, 12, "one site and machine, got those of 'A' and 'B'",
	"70 m/s A=@70"},
    {"Sample,Crusher,mm,passing\nfeed,1,8,100\nfeed,1,4,50\n70 m/s,1,8,100\n"
     "70 m/s,1,4,60\n79 m/s,2,8,100\n79 m/s,2,4,70\n",
	4, 12, "those of '1' and '2'", "70 m/s 1=@70"},
    {"Sample,Crusher No.,mm,passing\nfeed,1,8,100\nfeed,1,4,50\n"
     "70 m/s,1,8,100\n70 m/s,1,4,60\n79 m/s,2,8,100\n79 m/s,2,4,70\n",
	4, 12, "those of '1' and '2'", "70 m/s 1=@70"},
    /* The number of a crusher is no speed. */
    {"Sample,Crusher,mm,passing\nfeed,,8,100\nfeed,,4,50\n"
     "product,75,8,100\nproduct,75,4,60\n",
	4, 14, "its tip speed, got 'product", "=@SPEED"},
    {"Sample,Quarry,Crusher,mm,passing\nfeed,A,1,8,100\nfeed,A,1,4,50\n"
     "70 m/s,A,1,8,100\n70 m/s,A,1,4,60\n79 m/s,B,1,8,100\n"
     "79 m/s,B,1,4,70\n",
	4, 14, "those of 'A' and 'B'", "70 m/s A 1=@70"},
    {"size_mm,feed,product@69 (g),product@79\n" ROWS, 1, 14, "product@69 (g)",
	"3=product@69 passing_pct"},
    {"size_mm,fed,product@69,product@79\n" ROWS, 1, 9, "got 'fed'",
	"2=feed passing_pct, 3=product@69"},
    {"size_mm,feed,,product@79\n" ROWS, 2, 7, "what column 3 is",
	"3=product@SPEED passing_pct"},
    {"size_mm,feed,product@69,product@79,sd@69\n8,100,100,100,1\n"
     "4,60,80,90,\n",
	3, 12, "standard deviation, got", "fill"},
    {"size_mm,feed,product@69,product@79,sd@69\n8,100,100,100,0\n"
     "4,60,80,90,1\n",
	2, 15, "above 0", "points"},
    {"size_mm,feed,product@69,product@79,sd@69\n8,100,,100,1\n"
     "4,60,80,90,1\n",
	2, 12, "without a product", "empty"},
    {"size_mm,feed,retained_g@69,product@79\n8,100,0,100\n4,60,-3,90\n"
     "pan,,5,\n",
	3, 6, "0 g or more", "check"},
    {"size_mm,feed,retained_g@69,product@79\n8,100,0,100\n4,60,3,90\n", 1, 14,
	"mass in the pan", "pan"},
    {"size_mm,feed,retained_g@69,product@79\n8,100,0,100\n4,60,0,90\n"
     "pan,,0\n",
	1, 14, "got 0 g", "remove it"},
    {"size_mm,feed,retained_pct@69,product@79\n8,100,0,100\n4,60,30,90\n"
     "pan,,60\n",
	1, 14, "sum to 100, got 90", "check"},
    {"size_mm,feed,retained_pct@69,product@79\n8,100,80,100\n4,60,30,90\n", 1,
	14, "got 110", "check"},
    {TOP "8,100,100,100\n4,60,80,90\npan,0,3,\n", 4, 7, "nothing passing",
	"empty"},
    {TOP "8,100,100,100\npan,,,\n4,60,80,90\n", 4, 1, "got 4 after pan",
	"sort"},
    {"site,A\nsite,B\n" TOP ROWS, 2, 1,
	"duplicate key: site is already in line 1", "remove"},
    {"top_size_mm,big\n" TOP ROWS, 1, 13, "got 'big'", "digits"},
    {"top_size_mm,0\n" TOP ROWS, 1, 13, "positive size", "remove the line"},
    {"top_size_mm,11,2\n" TOP ROWS, 1, 16, "got '2'", "decimal commas"},
    {"rock granite\n" TOP ROWS, 1, 1, "a key and a value", "key,value"},
    {"size_mm,feed_retained_g,retained_g@69,retained_g@79\n8,0,0,0\n"
     "4,80,571.9,10\n1,100,3.75,60\npan,20,1.25,30\nTotal,200,756.9,100\n",
	6, 11, "expected 576.9 g, the sum of column retained_g@69",
	"were digits transposed"},
    {"size_mm,feed_retained_g,retained_g@69,retained_g@79\n8,0,0,0\n"
     "4,80,571.9,10\n1,100,3.75,60\npan,20,1.25,30\nTotal,200,583,100\n",
	6, 11, "576.9 g", "1 % may be lost"},
    {"provenance,\"from Table 3\n" TOP ROWS, 1, 12, "not closed", "close"},
    {"ägare,\"Å\" Öberg\n" TOP ROWS, 1, 11, "after the closing quote", "whole"},
    {"ägare,Å \"Ö\"\n" TOP ROWS, 1, 9, "quote inside", "whole"},
    {"", 1, 1, "empty file", "save it again"},
    {"\xEF\xBB\xBF \r\n", 1, 1, "empty file", "save it again"},
    {"site,Tierp\nrock,Gr\xE5\x81 gnejs\n" TOP ROWS, 2, 9, "Windows-1252",
	"CSV UTF-8"},
    {"site,Tierp\nrock,Gr\xC3\xA5 gnejs, r\xF6" TOP ROWS, 2, 18,
	"a damaged character", "CSV UTF-8"},
    {"site,T\x01\n" TOP ROWS, 1, 7, "a binary file", "CSV UTF-8"},
};

static void
each_fault_has_its_place_and_next_step(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(FAULTS); i++) {
		struct error_list errors;
		assert_null(read_string(FAULTS[i].sheet, &errors));
		const struct error *e = &errors.item[0];
		bool good = errors.n >= 1 && e->kind == ERROR_DATA &&
			    e->line == FAULTS[i].line &&
			    e->column == FAULTS[i].column &&
			    strstr(e->text, FAULTS[i].text) != NULL &&
			    strstr(e->hint, FAULTS[i].hint) != NULL;
		if (good && errors.n == 1)
			continue;
		fprintf(stderr, "%s", FAULTS[i].sheet);
		for (size_t k = 0; k < errors.n; k++)
			error_print(&errors.item[k], stderr);
		fail_msg("fault %zu: wanted one at %d:%d with '%s', '%s'", i,
		    FAULTS[i].line, FAULTS[i].column, FAULTS[i].text,
		    FAULTS[i].hint);
	}
}

static void
every_spelling_gives_the_same_site(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(SAME); i++) {
		struct site *site = accept(SAME[i]);
		struct site *plain = accept(SAME[0]);
		if (site->digest != plain->digest)
			fail_msg(
			    "spelling %zu reads otherwise:\n%s", i, SAME[i]);
		assert_string_equal(site->name, "tierp");
		assert_false(site->individual_feeds);
		site_free(site);
		site_free(plain);
	}
}

static void
a_site_is_read_in_si_units(void **state)
{
	(void)state;
	struct site *site = accept(GOOD);
	assert_string_equal(site->name, "Tierp");
	assert_string_equal(site->rock, "Granite");
	assert_string_equal(site->machine, "Metso Barmac 5100 SE");
	assert_string_equal(site->provenance, "made up, here; seed 9");
	assert_string_equal(site->path, "here/tierp.csv");
	assert_int_equal(site->n_note, 1);
	assert_string_equal(site->note[0].key, "operator");
	assert_string_equal(site->note[0].value, "\"Åsa\"");
	assert_true(site->top_size == 11.2 / 1000);
	assert_int_equal(site->n_run, 3);
	assert_true(site->digest == site_digest(site));
	const struct run *run = site->run;
	assert_true(run[0].speed == 69 && run[2].speed == 79.5);
	assert_int_equal(run[0].feed.n, 4);
	assert_true(run[1].feed.passing[2] == 80.123456789012 / 100);
	assert_true(run[1].feed.size[3] == 0.063 / 1000);
	assert_int_equal(run[1].product.n, 3);
	assert_true(run[2].product.size[0] == 16.0 / 1000);
	assert_true(run[0].product_sd[2] == 0.25 / 100);
	assert_null(run[1].product_sd);
	site_free(site);
}

static void
individual_feeds_may_lack_a_product(void **state)
{
	(void)state;
	struct site *site =
	    accept("size_mm,feed@79,product@79,feed@74,product@69,feed@69\n"
		   "8,100,100,100,100,100\n4,60,90,61,80,62\n1,10,30,,,12\n");
	assert_true(site->individual_feeds);
	assert_int_equal(site->n_run, 3);
	assert_int_equal(site->run[0].feed.n, 3);
	assert_true(site->run[0].feed.passing[1] == 62.0 / 100);
	assert_int_equal(site->run[1].feed.n, 2);
	assert_int_equal(site->run[1].product.n, 0);
	assert_int_equal(site->run[2].product.n, 3);
	site_free(site);
}

/* Two products and two feeds at 79 m/s, one feed for both at 69 m/s. */
static const char REPEATS[] =
    "size_mm,product@79 (1),feed@69,product@69,feed@79,product 69 m/s "
    "(2),sd@79,Product @ 79 (2),feed@79 (2),product@74,feed@74\n"
    "8,100,100,100,100,100,1,100,100,100,100\n"
    "4,90,60,80,61,81,2,91,62,85,60\n1,30,10,20,11,,3,31,12,25,10\n";

static void
repeats_are_runs_of_their_own(void **state)
{
	(void)state;
	struct site *site = accept(REPEATS);
	static const double speed[] = {69, 69, 74, 79, 79},
			    feed[] = {60, 60, 60, 61, 62},
			    product[] = {80, 81, 85, 90, 91};
	static const char *const repeat[] = {
	    " (1)", " (2)", "", " (1)", " (2)"};
	assert_int_equal(site->n_run, 5);
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		assert_true(run->speed == speed[r]);
		assert_true(run->feed.passing[1] == feed[r] / 100);
		assert_true(run->product.passing[1] == product[r] / 100);
		assert_int_equal(run->product.n, r == 1 ? 2 : 3);
		assert_string_equal(run->repeat, repeat[r]);
		assert_int_equal(run->product_sd != NULL, r > 2);
		assert_int_equal(
		    site_run_repeats_speed(site, r), r == 1 || r == 4);
	}
	assert_int_equal(site_run_at_speed(site, 79), 3);
	site_free(site);
}

static void
retained_counts_the_coarsest_sieve_and_the_pan(void **state)
{
	(void)state;
	struct site *site =
	    accept("size_mm,feed,retained_g@69,retained_pct@79\n"
		   "8,100,100,10\n4,60,200,20\n1,10,600,60\npan,0,100,\n");
	const double passing[] = {0.9, 0.7, 0.1};
	for (size_t i = 0; i < 3; i++)
		for (size_t r = 0; r < 2; r++) {
			double p = site->run[r].product.passing[i];
			assert_true(fabs(p - passing[i]) < 1e-14);
		}
	site_free(site);
}

/* Up to 1 % of a sample is lost between the sieves. */
static void
a_total_may_be_a_little_more_than_its_sum(void **state)
{
	(void)state;
	struct site *site = accept(
	    "size_mm,feed_retained_g,retained_g@69,retained_g@79\n8,0,0,0\n"
	    "4,80,571.9,10\n1,100,3.75,60\npan,20,1.25,30\n"
	    "Total,202,582,100\n");
	assert_true(fabs(site->run[0].feed.passing[1] - 0.6) < 1e-12);
	site_free(site);
}

static void
all_faults_are_told_in_file_order(void **state)
{
	(void)state;
	struct error_list errors;
	assert_null(read_string(
	    "site,A\nrock,\"open\ntop_size_mm,-1\nsite,B\n" TOP
	    "8,100,100,100,7\n4,60,110,x\ntotal of it\n1,70,20,30\n",
	    &errors));
	static const int place[][2] = {
	    {2, 6}, {3, 13}, {4, 1}, {6, 15}, {7, 6}, {7, 10}, {8, 1}, {9, 3}};
	for (size_t i = 0; i < errors.n && i < ARRAY_LEN(place); i++) {
		assert_int_equal(errors.item[i].line, place[i][0]);
		assert_int_equal(errors.item[i].column, place[i][1]);
		assert_string_equal(errors.item[i].file, "here/tierp.csv");
	}
	assert_int_equal(errors.n, ARRAY_LEN(place));
	assert_int_equal(errors.more, 0);
}

static void
a_full_list_keeps_the_first_faults(void **state)
{
	(void)state;
	char text[4000] = TOP "9,100,100,100\n";
	for (int i = 0; i < 30; i++) {
		size_t n = strlen(text);
		snprintf(text + n, sizeof text - n, "%g,x,y,1\n", 8 - i / 10.0);
	}
	struct error_list errors;
	assert_null(read_string(text, &errors));
	assert_int_equal(errors.n, ARRAY_LEN(errors.item));
	assert_int_equal(errors.more, 60 - errors.n);
	for (size_t i = 0; i < errors.n; i++) {
		assert_int_equal(errors.item[i].line, 3 + i / 2);
		assert_true(i % 2 == 0 || errors.item[i].column ==
					      errors.item[i - 1].column + 2);
	}
}

static void
a_written_site_reads_back_to_the_same_bits(void **state)
{
	(void)state;
	static const char *const sheet[] = {GOOD,
	    ("size_um,feed@69,retained_g@69,feed_fraction@79.25,"
	     "product_fraction@79.25,feed@80\n"
	     "31000.123,100,0,1,1,100\n7.1,33.333333333333336,7.7,"
	     "0.981379781,,7\n3.3,1,0.1,0.7,0.123456789,1\npan,,3.3\n"),
	    ("size_mm,feed,cum_retained_pct@69,fraction@79\n8,100,99.01,.01\n"
	     "4,60,99.123456789,0\n"),
	    REPEATS,
	    ("size_mm,feed,product@69,fraction@79,fraction@79\n"
	     "8,100,50,.01,.02\n4,60,5,0,0.015\n")};
	for (size_t i = 0; i < ARRAY_LEN(sheet); i++) {
		struct site *site = accept(sheet[i]);
		assert_true(reads_back(site));
		site_free(site);
	}
}

static void
the_sheet_is_written_like_this(void **state)
{
	(void)state;
	struct site *site = accept(GOOD);
	char *text = written(site);
	assert_string_equal(text,
	    "site,Tierp\nrock,Granite\ntop_size_mm,11.2\n"
	    "machine,Metso Barmac 5100 SE\n"
	    "provenance,\"made up, here; seed 9\"\n"
	    "operator,\"\"\"Åsa\"\"\"\n"
	    "size_mm,feed,product@69,sd@69,product@74,product@79.5\n"
	    "22.4,100,100,0.5,100,\n16,95.5,97.25,0.5,,99\n"
	    "11.2,80.123456789012,85,0.25,88,90\n0.063,5,6.1,1,7,8\n");
	free(text);
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_fault_has_its_place_and_next_step),
	    cmocka_unit_test(every_spelling_gives_the_same_site),
	    cmocka_unit_test(a_site_is_read_in_si_units),
	    cmocka_unit_test(individual_feeds_may_lack_a_product),
	    cmocka_unit_test(repeats_are_runs_of_their_own),
	    cmocka_unit_test(retained_counts_the_coarsest_sieve_and_the_pan),
	    cmocka_unit_test(a_total_may_be_a_little_more_than_its_sum),
	    cmocka_unit_test(all_faults_are_told_in_file_order),
	    cmocka_unit_test(a_full_list_keeps_the_first_faults),
	    cmocka_unit_test(a_written_site_reads_back_to_the_same_bits),
	    cmocka_unit_test(the_sheet_is_written_like_this),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
