/* What the tests of site files share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_SHEETS_H
#define TIPSPEED_TESTS_SHEETS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sitefile/site_read.h"
#include "io/sitefile/site_write.h"

#define TOP "size_mm,feed,product@69,product@79\n"
#define ROWS "8,100,100,100\n4,60,80,90\n1,10,20,30\n"
#define GOOD                                                                  \
	"# made up for this test\nsite,Tierp\nrock,Granite\n"                 \
	"top_size_mm,11.2\nmachine,Metso Barmac 5100 SE\n"                    \
	"provenance,\"made up, here; seed 9\"\noperator,\"\"\"Åsa\"\"\"\n\n" \
	"size_mm,feed,product@69,sd@69,product@74,product@79.5\n"             \
	"22.4,100,100,0.5,100,\n16,95.5,97.25,0.5,,99\n"                      \
	"11.2,80.123456789012,85,0.25,88,90\n0.063,5,6.1,1,7,8\n"

/* Sheets that all say the same as TOP ROWS. */
static const char *const SAME[] = {
    TOP ROWS,
    "\xEF\xBB\xBF" TOP ROWS,
    "\n# c\n,,,\n" TOP "# \"c\n\n" ROWS ",,,\n",
    "sep=,\n" TOP ROWS,
    "size_mm,feed,product@69,product@79,,\n8,100,100,100,,\n4,60,80,90,\n"
    "1,10,20,30",
    "size_mm,feed,product@69,product@79\r\n8,100,100,100\r\n4,60,80,90\r\n"
    "1,10,20,30\r\n",
    "size_mm,feed,product@69,product@79\r8,100,100,100\r4,60,80,90\r"
    "1,10,20,30\r",
    "size_mm;feed;product@69;product@79\n8,0;100;100;100\n4;60,0;80;90\n"
    "1;10;2,0e1;30\n",
    "note;1,5 a, b\nsize_mm;feed;product@69;product@79\n8.0;100;100;100\n"
    "4;60.0;80;90\n1;10;20;30\n",
    "size_mm\tfeed\tproduct@69\tproduct@79\n8\t100\t100\t100\n"
    "4\t60,0\t80\t90\n1\t10\t20\t30\n",
    "\"Size_MM\" , \"Feed\" ,Product@69 m/s,product @ 79m/s\n" ROWS,
    "size_um,feed,product@79,product@69\n8000,100,100,100\n4e3,60,90,80\n"
    "1000,10,30,20\n",
    "size_\xC2\xB5m,feed,product@79,product@69\n8000,100,100,100\n"
    "4000,60,90,80\n1000,10,30,20\n",
    "size_m,feed,product@69,product@79\n0.008,100,100,100\n0.004,60,80,90\n"
    "0.001,10,20,30\n",
    "size_mm,feed_fraction,product_passing_pct@69,product_fraction@79\n"
    "8,1,100,1\n4,.6,80,.9\n1,.1,20,.3\n",
    "size_mm,feed_retained_g,retained_g@69,product_retained_g@79\n8,0,0,0\n"
    "4,80,1.25,10\n1,100,3.75,60\npan,20,1.25,30\n",
    "size_mm,feed_retained_pct,retained_pct@69,product_retained_pct@79\n"
    "8,0,0,0\n4,40,20,10\n1,50,60,60\n0,10,20,\n",
    "size_mm,feed_cum_retained_pct,cum_retained_pct@69,product@79\n8,0,0,100\n"
    "4,40,20,90\n1,90,80,30\nPan,100,,0\n",
    "Sikt (mm);Ingående;Produkt,69 m/s;Passerande, % vid 79,0 m/s\n"
    "8;100;100;100\n4;60;80;90\n1;10;20;30\n",
    "Maskvidd [mm];Inmatning siktrest (g);69 m/s siktrest g;"
    "Siktrest (g) 79 m/s\n8;0;0;0\n4;80;1,25;10\n1;100;3,75;60\n"
    "Botten;20;1,25;30\n",
    "Kornstorlek \xC2\xB5m;P\xC3\xA5matning siktrest %;Siktrest % 69 m/s;79 "
    "m/s\n"
    "8000;0;0;100\n4000;40;20;90\n1000;50;60;30\n0;10;20;\n",
    "Siktanalys, 3 maj\n;;;\nSikt mm;Feed %;Produkt 69 m/s;Produkt 79 m/s\n"
    "8;100,0 %;100\xC2\xA0%;100%\n4;60,0 %;80;90\n1;10;20 %;30\n;;;\nSumma;170;"
    "200;220\nSignatur;;;\n",
    "Sieve mm;Feed;69 m/s;79 m/s\n#;1;2;3\n8;100;100;100\n4;60;80;90\n"
    "1;10;20;30\n",
    "Prov 17;;;;\nSikt mm;Feed g;69 m/s g;79 m/s g;\n8;0;0;0;\n4;800;"
    "1 250;10 000;\n1;1 000,0;3\xC2\xA0"
    "750;60\xE2\x80\xAF"
    "000,0;\n"
    "Botten;200;1250,0;30000;\nTotalt;2 010;6 250;100 000;\n",
    "\"Sikt mm\",\"Feed\",\"69 m/s\",\"79 m/s\"\n\"8,0\",\"100,0\",100,100\n"
    "\"4\",\"60,0\",\"80,00\",\"90\"\n1,10,20,\"30,0\"\n",
    "Siktanalys, maj\nProv 3, torrt, siktat\nMaskvidd mm;Ing\xC3\xA5"
    "ende material;"
    "Produkt, rotorhastighet 69 m/s;Passerande mängd % 79 "
    "m/s\n8,0;100;100;100\n"
    "4,0;60;80;90\n1,0;10;20;30\n",
    "Siktanalys, maj\nMaskvidd mm\tFeed\t69 m/s\t79 "
    "m/s\n8,0\t100,0\t100,0\t100,0\n"
    "4,0\t60,0\t80,0\t90,0\n1,0\t10,0\t20,0\t30,0\n",
    "Torrt, tv\xC3\xA4ttat\nMaj, prov 3\nRotor, nya spetsar\n"
    "Sikt mm;Feed g;69 m/s g;79 m/s g\n8,0;0 g;0g;0\n4,0;80 g;1,25 g;10\n"
    "1,0;100 g;3,75;60\ntr\xC3\xA5g;20 g;1,25;30\n"
    "Summa;200 g;6,25;100\nDiff %;0,5;;\nKommentar;;;\n",
    "Setaccio mm;Alimentazione;Prodotto 69 m/s;Prodotto 79 m/s\n"
    ";Passante %;Passante %;Passante %\n8;100;100;100\n4;60;80;90\n"
    "1;10;20;30\n",
    "Сито, мм;Питание;Продукт 69 м/с;Продукт 79 м/с\n"
    ";Проход, %;Проход, %;Проход, %\n8;100;100;100\n4;60;80;90\n"
    "1;10;20;30\n",
    "筛孔(mm),给料,产品 69 m/s,产品 79 m/s\n,通过率(%),通过率(%),通过率(%)\n"
    "8,100,100,100\n4,60,80,90\n1,10,20,30\n",
    "Class mm,Feed % retained,69 m/s % retained,79 m/s % retained\n"
    "4-8,40,20,10\n1-4,50,60,60\n<1,10,20,30\n",
    "S1: feed\nS2: VSI product at 69 m/s\nS3: VSI product at 79 m/s\n\n"
    "Sieve mm,S1,S2,S3\n" ROWS,
    "Sieve mm;Prov A;Prov B;Prov C\n8;100;100;100\n4;60;80;90\n"
    "1;10;20;30\n\nProv A;Ing\xC3\xA5"
    "ende\nProv B;Produkt;69 m/s\nProv C;Produkt;79 m/s\n",
    "Sikt mm;Matning;Prov 1;Prov 2\n8;100;100;100\n4;60;80;90\n"
    "1;10;20;30\nPeriferihastighet m/s;;69;79\n",
    "Feed sample,,\nmm,g retained,\n8,0,\n4,40,\n1,50,\nPan,10,\n,,\n"
    "VSI products of May,,\nmm,69 m/s %,79 m/s %\n8,100,100\n4,80,90\n"
    "1,20,30\n",
    "Sieve print 4471\n\nSieve      Feed     Product    Product\n"
    " mm                   69 m/s     79 m/s\n"
    "--------------------------------------\n"
    "  8      100.0       100.0      100.0\n"
    "  4       60          80         90\n"
    "  1       10.0        20.0       30.0\n"
    "--------------------------------------\n",
    "Sieve analysis, 3 May\n\n| Sieve mm | Feed | 69 m/s | 79 m/s |\n"
    "|---:|:---|---|---|\n| 8 | 100 | 100 | 100 |\n| 4 | 60 | 80 | 90 |\n"
    "| 1 | 10 | 20 | 30 |\n",
    "Sieve size mm,feed (g),69 m/s g,Product (g retained) 79 m/s\n8,0,0,0\n"
    "4,80,1.25,10\n1,100,3.75,60\npan,20,1.25,30\n",
};

/* The file here/tierp.csv in a folder of the test's own, which goes with it. */
static char sheet_folder[] = "/tmp/tipspeed-sheet-XXXXXX";

static inline void
drop_sheet(void)
{
	char *command = xasprintf("rm -rf '%s'", sheet_folder);
	if (system(command) != 0)
		fprintf(stderr, "%s failed\n", command);
	free(command);
}

static inline const char *
put_sheet(const char *bytes, size_t n)
{
	static const char PATH[] = "here/tierp.csv";
	static bool made;
	if (!made) {
		assert_non_null(mkdtemp(sheet_folder));
		assert_int_equal(atexit(drop_sheet), 0);
		assert_int_equal(chdir(sheet_folder), 0);
		assert_int_equal(mkdir("here", 0700), 0);
		made = true;
	}
	FILE *out = fopen(PATH, "wb");
	assert_non_null(out);
	assert_int_equal(fwrite(bytes, 1, n, out), n);
	assert_int_equal(fclose(out), 0);
	return PATH;
}

static inline struct site *
read_string(const char *text, struct error_list *errors)
{
	*errors = (struct error_list){0};
	return site_read(put_sheet(text, strlen(text)), errors);
}

static inline struct site *
accept(const char *text)
{
	struct error_list errors;
	struct site *site = read_string(text, &errors);
	for (size_t i = 0; i < errors.n; i++)
		error_print(&errors.item[i], stderr);
	assert_non_null(site);
	assert_int_equal(errors.n, 0);
	return site;
}
static inline char *
written(const struct site *site)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	site_write(site, out);
	fclose(out);
	return text;
}

static inline bool
reads_back(const struct site *site)
{
	char *text = written(site);
	struct site *again = accept(text);
	char *twice = written(again);
	bool same =
	    again->digest == site->digest && again->n_note == site->n_note &&
	    again->top_size == site->top_size && strcmp(text, twice) == 0;
	site_free(again);
	free(text);
	free(twice);
	return same;
}

#endif
