/* Times the commands that use the store, with many materials in it.  Prints a
 * row for each command; bench/README.md has results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/run/complete.h"
#include "cmd/run/line.h"
#include "cmd/session/session.h"
#include "core/numeric/rng.h"
#include "measure.h"

static const char BY_HAND[] = "params set beta1=0.2 beta2=0 beta3=0.1 beta4=0 "
			      "f_mat=0.001 e0_min=3 alpha=0.9";

enum { AT_ONCE = 10000, TIMES = 5 };

static const char *const ROCKS[] = {"Granite", "Gneiss", "Diabase", "Basalt",
    "Porphyry", "Limestone", "Quartzite", "Gabbro", "Amphibolite", "Rhyolite"};

static void
set(char **text, char *value)
{
	free(*text);
	*text = value;
}

/* Returns a material of Table 3 with other values, which depend on its number
 * alone. */
static struct material
made_up(const struct material_list *paper, size_t number)
{
	const struct material *of = &paper->item[number % paper->n];
	struct rng_key key = rng_make_key(1, number, 90);
	struct material m = material_make_empty();
	for (size_t f = 0; f < FIELD_COUNT; f++)
		if (FIELDS[f].kind == FIELD_TEXT)
			material_set_field(&m, &FIELDS[f],
			    *material_text_field_pointer(of, &FIELDS[f]));
		else if (FIELDS[f].kind == FIELD_NUMBER)
			*material_number_field_pointer(&m, &FIELDS[f]) =
			    *material_number_field_pointer(of, &FIELDS[f]);
	m.params = of->params;
	for (size_t j = 4; j < 7; j++)
		m.params.at[j] *= 0.9 + 0.2 * rng_uniform(key, (uint32_t)j);
	m.top_size_mm = 8 + floor(24 * rng_uniform(key, 20));
	set(&m.name, xasprintf("quarry %zu", number));
	set(&m.site, xasprintf("Quarry %zu", number / 4));
	set(&m.rock, xstrdup(ROCKS[number % ARRAY_LEN(ROCKS)]));
	set(&m.provenance, xstrdup("made up"));
	set(&m.origin, xstrdup("hand"));
	return m;
}

static void
fill(struct store *store, size_t n)
{
	struct error error = {0};
	struct material_list paper = {0};
	material_add_table3_to_list(&paper);
	for (size_t from = 0; from < n; from += AT_ONCE) {
		struct material_list list = {0};
		for (size_t i = from; i < n && i < from + AT_ONCE; i++)
			material_list_add(&list, made_up(&paper, i));
		if (!store_save_materials(
			store, list.item, list.n, true, &error)) {
			error_print(&error, stderr);
			exit(1);
		}
		material_list_free(&list);
	}
	material_list_free(&paper);
}

static void
run(struct session *s, const char *line)
{
	struct error error = {0};
	size_t next = 0;
	if (!session_run_line(s, line, 0, "bench", 1, &next, &error)) {
		error_print(&error, stderr);
		exit(1);
	}
}

/* Returns the processor time of this process, which other programs do not
 * lengthen. */
static double
processor_ms(clock_t since)
{
	return 1000.0 * (double)(clock() - since) / CLOCKS_PER_SEC;
}

/* Times Tab after "recall quarry". */
static void
print_completion(const struct session *s)
{
	static const char LINE[] = "recall quarry";
	double ms[TIMES];
	clock_t before = clock();
	for (int k = 0; k < TIMES; k++) {
		double from = session_clock_seconds();
		completion_free(
		    find_completions_at_cursor(s, LINE, strlen(LINE)));
		ms[k] = 1000 * (session_clock_seconds() - from);
	}
	double middle = measure_median(ms, TIMES);
	printf("%-44s %8.1f %8.1f %9.1f\n", "Tab after recall quarry", middle,
	    ms[TIMES - 1], processor_ms(before) / TIMES);
}

int
main(int argc, char **argv)
{
	static const char *const LINES[] = {"remember a replace=on", "recall a",
	    "recall \"quarry 77777\"", "materials \"quarry 5\"",
	    "materials rock=gneiss top=11 origin=own", "materials rock=gabbro",
	    "materials rock=marble", "guess rock=granite top=11.2",
	    "guess nearest=5", "plot map", "show store", "forget a"};
	if (argc != 4) {
		fprintf(stderr, "expected STORE.db N SITE.csv\n");
		return 2;
	}
	struct session *s =
	    session_new(fopen("/dev/null", "w"), fopen("/dev/null", "w"));
	store_free(s->store);
	s->store = store_new(argv[1]);
	if (access(argv[1], F_OK) != 0)
		fill(s->store, (size_t)strtoul(argv[2], NULL, 10));
	char *load = xasprintf("load %s", argv[3]);
	run(s, load);
	free(load);
	run(s, BY_HAND);
	printf("%-44s %8s %8s %9s\n", "ms", "median", "most", "processor");
	for (size_t i = 0; i < ARRAY_LEN(LINES); i++) {
		double ms[TIMES];
		int times = strncmp(LINES[i], "forget", 6) == 0 ? 1 : TIMES;
		double used = 0;
		for (int k = 0; k < times; k++) {
			double from = session_clock_seconds();
			clock_t before = clock();
			run(s, LINES[i]);
			used += processor_ms(before) / times;
			ms[k] = 1000 * (session_clock_seconds() - from);
			if (strncmp(LINES[i], "recall", 6) == 0)
				run(s, BY_HAND);
		}
		double middle = measure_median(ms, (size_t)times);
		printf("%-44s %8.1f %8.1f %9.1f\n", LINES[i], middle,
		    ms[times - 1], used);
	}
	print_completion(s);
	session_free(s);
	return 0;
}
