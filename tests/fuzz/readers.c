/* Every reader as a function of the bytes of one file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../unit/books.h"
#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/sites.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/session/script.h"
#include "cmd/session/invocation.h"
#include "io/formats/circuit_file.h"
#include "io/formats/collisions.h"
#include "io/formats/plant_log.h"
#include "io/sitefile/site_read.h"
#include "io/sitefile/site_write.h"
#include "io/formats/spec.h"
#include "io/store/store_csv.h"

/* Steps of calibrations that a script is given. */
enum { STEPS = 10 };

static char folder[256];
static FILE *nowhere;

/* A file in the folder; the caller frees. */
static char *
path_of(const char *name)
{
	return xasprintf("%s/%s", folder, name);
}

static void
put(const char *path, const void *bytes, size_t n)
{
	FILE *out = fopen(path, "wb");
	if (out == NULL || fwrite(bytes, 1, n, out) != n || fclose(out) != 0) {
		perror(path);
		exit(99);
	}
}

static void
leave(void)
{
	static const char *const NAMES[] = {
	    "input", "input-wal", "input-shm", "input-journal"};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		char *path = path_of(NAMES[i]);
		unlink(path);
		free(path);
	}
	rmdir(folder);
}

static void
begin(void)
{
	const char *where = getenv("TMPDIR");
	snprintf(folder, sizeof folder, "%s/tipspeed-fuzz-XXXXXX",
	    where != NULL ? where : "/tmp");
	nowhere = fopen("/dev/null", "w");
	if (mkdtemp(folder) == NULL || nowhere == NULL || atexit(leave) != 0) {
		perror(folder);
		exit(99);
	}
}

/* A small site that is always good. */
static struct site *
small_site(void)
{
	const char *srcdir = getenv("srcdir");
	char *path = xasprintf("%s/tests/fuzz/corpus/sheet/good-small.csv",
	    srcdir != NULL ? srcdir : ".");
	struct error_list errors = {0};
	struct site *site = site_read(path, &errors);
	if (site == NULL) {
		perror(path);
		exit(99);
	}
	free(path);
	return site;
}

static bool
read_sheet(const char *path)
{
	struct error_list errors = {0};
	struct site *site = site_read(path, &errors);
	if (site != NULL)
		site_write(site, nowhere);
	site_free(site);
	return site != NULL;
}

/* A part of a workbook: a fuzzer hardly ever makes an archive. */
static bool
read_part(const char *path, const char *name)
{
	enum { ROOM = 1000000 };
	char *bytes = xcalloc(ROOM, 1);
	FILE *in = fopen(path, "rb");
	size_t n = in != NULL ? fread(bytes, 1, ROOM, in) : 0;
	if (in != NULL)
		fclose(in);
	const struct part none = {NULL, NULL, 0};
	struct part ods[] = {{name, bytes, n}, none};
	struct part xlsx[] = {XLSX_WORKBOOK(""), XLSX_RELATIONS(""),
	    XLSX_SHEET("<row s='1'><c t='s'><v>0</v></c><c><v>1</v></c></row>"),
	    {name, bytes, n}, none};
	bool good =
	    n > 0 && put_book(path, strchr(name, '/') != NULL ? xlsx : ods);
	free(bytes);
	return good && read_sheet(path);
}

static bool
read_xlsx_sheet(const char *path)
{
	return read_part(path, "xl/worksheets/sheet1.xml");
}

static bool
read_xlsx_styles(const char *path)
{
	return read_part(path, "xl/styles.xml");
}

static bool
read_xlsx_strings(const char *path)
{
	return read_part(path, "xl/sharedStrings.xml");
}

static bool
read_ods(const char *path)
{
	return read_part(path, "content.xml");
}

static bool
read_table3(const char *path)
{
	struct error_list errors = {0};
	struct material_list list = {0};
	bool ok = material_read_table3_file(path, &list, &errors);
	material_list_free(&list);
	return ok;
}

static bool
read_spec(const char *path)
{
	struct error_list errors = {0};
	struct spec *spec = spec_read_file(path, &errors);
	spec_free(spec);
	return spec != NULL;
}

static bool
read_circuit(const char *path)
{
	struct error_list errors = {0};
	struct circuit *circuit = circuit_file_read(path, NULL, &errors);
	circuit_free(circuit);
	return circuit != NULL;
}

static bool
read_energy(const char *path)
{
	struct error_list errors = {0};
	struct collisions c;
	const struct collisions_way way = {.speed = NAN, .unit = "J/kg"};
	bool taken = collisions_read(path, &way, &c, &errors);
	collisions_clear(&c);
	return taken;
}

static bool
read_log(const char *path)
{
	struct error_list errors = {0};
	struct log_request q = {.n = 1, .path = &path};
	bool open;
	struct plant_log *log = plant_log_read(&q, &errors, &open);
	if (log != NULL)
		plant_log_summarise_window(
		    log, log->time[0], log->time[log->n - 1]);
	bool good = log != NULL;
	plant_log_free(log);
	return good;
}

static bool
read_materials(const char *path)
{
	struct error_list errors = {0};
	struct material_list list = {0};
	bool ok = store_csv_read_file(path, NULL, &list, &errors);
	material_list_free(&list);
	return ok;
}

/* The commands of a line, whose calibrations together get so many steps. */
static bool
run_line(struct session *s, const char *line, struct place place, int *steps)
{
	struct error error = {0};
	size_t at = 0;
	bool ok;
	do {
		ok = session_run_line(
		    s, line, at, place.file, place.line, &at, &error);
		while (session_is_calibrating(s) && (*steps)-- > 0)
			session_step_job(s);
		session_stop_job_for_user(s);
		s->wants_tui = false;
	} while (ok && at > 0 && !s->quit);
	return session_end_finished_commands(s, ok, &error);
}

/* With --safe, and after an error the next line. */
static bool
run_script(const char *path, bool prompt)
{
	struct session *s = session_new(nowhere, nowhere);
	struct error error = {0};
	struct place place;
	char *line;
	int steps = STEPS;
	bool ok = script_open(s, path, &error);
	s->safe = true;
	s->prompt = prompt;
	s->set.threads = 1;
	session_add_site(s, small_site());
	while (!s->quit && s->script != NULL &&
	       (line = script_read_line(s, &place, &error)) != NULL) {
		ok = run_line(s, line, place, &steps) && ok;
		free(line);
	}
	session_free(s);
	return ok && error.kind == ERROR_NONE;
}

static bool
read_script(const char *path)
{
	return run_script(path, false);
}

static bool
read_init(const char *path)
{
	return run_script(path, true);
}

/* Reads, and writes what was read. */
static bool
read_store(const char *path)
{
	struct store *store = store_new(path);
	struct material_list list = {0};
	struct error error = {0};
	bool ok = store_list_materials(store, &list, &error);
	if (ok && list.n > 0)
		ok = store_save_materials(store, list.item, 1, true, &error) &&
		     store_remove_material(store, list.item[0].name, &error);
	material_list_free(&list);
	store_free(store);
	return ok;
}

static const struct reader READERS[] = {{"sheet", read_sheet},
    {"workbook", read_sheet}, {"xlsx-sheet", read_xlsx_sheet},
    {"xlsx-styles", read_xlsx_styles}, {"xlsx-strings", read_xlsx_strings},
    {"ods", read_ods}, {"table3", read_table3}, {"spec", read_spec},
    {"circuit", read_circuit}, {"materials", read_materials},
    {"script", read_script}, {"init", read_init}, {"store", read_store},
    {"log", read_log}, {"energy", read_energy}};

const struct reader *
reader_find(const char *name)
{
	for (size_t i = 0; i < ARRAY_LEN(READERS); i++)
		if (strcmp(READERS[i].name, name) == 0)
			return &READERS[i];
	return NULL;
}

bool
reader_feed(const struct reader *reader, const uint8_t *bytes, size_t n)
{
	if (nowhere == NULL)
		begin();
	char *path = path_of("input");
	put(path, bytes, n);
	bool good = reader->read(path);
	free(path);
	return good;
}
