/* The table is put together as it comes and written once.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/log.h"

#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/files.h"
#include "io/file.h"

struct log {
	char *path, *text;
	size_t n, rows;
	FILE *memory;
};

struct log *
log_new(const char *path)
{
	struct log *log = xcalloc(1, sizeof *log);
	log->path = xstrdup(path);
	log->memory = text_memory(&log->text, &log->n);
	fputs("site,generation,best,median", log->memory);
	for (size_t j = 0; j < BREAKAGES[0]->n; j++)
		fprintf(log->memory, ",%s,%s_p10,%s_p90",
		    BREAKAGES[0]->parameter[j].name,
		    BREAKAGES[0]->parameter[j].name,
		    BREAKAGES[0]->parameter[j].name);
	fputc('\n', log->memory);
	return log;
}

void
log_free(struct log *log)
{
	if (log == NULL)
		return;
	fclose(log->memory);
	free(log->text);
	free(log->path);
	free(log);
}

void
log_add(struct log *log, const char *key, const struct calibration *calibration)
{
	size_t n;
	const struct calibrate_generation *g =
	    calibration_history(calibration, &n);
	for (size_t i = 0; i < n; i++) {
		fprintf(log->memory, "%s,%zu,%.17g,%.17g", key, i + 1,
		    g[i].best, g[i].median);
		for (size_t j = 0; j < BREAKAGES[0]->n; j++)
			fprintf(log->memory, ",%.17g,%.17g,%.17g",
			    g[i].params.at[j], g[i].p10[j], g[i].p90[j]);
		fputc('\n', log->memory);
	}
	log->rows += n;
}

bool
log_save(struct session *s, struct log *log, struct error *error)
{
	fflush(log->memory);
	if (!file_replace(log->path, FILE_SHARED, log->text, log->n, error))
		return false;
	files_wrote(s, log->path);
	session_note(s, "wrote %s: %zu rows", log->path, log->rows);
	return true;
}
